// The benchmark `calibration` of spec/calibration.md, with the tasks of Core.
import { createHash } from 'node:crypto';
import { setTimeout as sleep } from 'node:timers/promises';
import { canonical } from './json.js';
import { invalid } from './problems.js';
import { LIMITS, below } from './shapes.js';

const fill = (size, value) => (value === undefined ? undefined : Array(size).fill(value));
const NONE = { frame: 'none', rotation: 'none', relative_to: 'none' };
const space = (size, out_of_range, low, high, [quantity, unit] = ['number', '1']) => ({
  size, parts: { all: { start: 0, size, quantity, unit, ...NONE } }, out_of_range,
  minimum: fill(size, low), maximum: fill(size, high),
});
const ACTIONS = {
  score: space(1, 'refuse', 0, 1), success: space(1, 'refuse', 0, 1), end: space(1, 'refuse', 0, 1),
  delay_s: space(1, 'refuse', 0, 5, ['time', 's']), fault: space(1, 'refuse', 0, 2),
  vector: space(8, 'unbounded'), clipped: space(2, 'clip', -1, 1),
};
const STATE = { count: space(1, 'unbounded'), vector: space(8, 'unbounded'), clipped: space(2, 'unbounded') };
// The digest covers what can change a score, and no texts and limits (BEN-006).
const HASHED = {
  benchmark_id: 'calibration', version: '1', tasks: ['score', 'count', 'delay'], splits: ['even', 'odd'],
  control_rate_hz: 10, max_attempts: 3, max_faults: 3, simulator: { name: 'calibration', version: '1' },
  action_space: ACTIONS, observation_space: { state: STATE, images: {}, tensors: {} },
};
const NOT_HASHED = {
  title: 'Calibration', description: 'No physics: a server is checked with it from outside.',
  max_chunk: LIMITS.max_chunk, image_sizes: [{ width: 16, height: 12 }, { width: 64, height: 48 }],
  image_codecs: ['raw'], unavailable_reason: null,
};

/** The manifest of a run with these options, and its digest. */
export function plan({ tasks = ['score'], max_steps = 10, success_rule = 'any_step' } = {}) {
  const episodes = tasks.map((task, i) => ({ task, split: HASHED.splits[i % 2], seed: i + 1000 }));
  const manifest = { ...HASHED, max_steps, success_rule, episodes };
  const manifest_sha256 = createHash('sha256').update(canonical(manifest)).digest('hex');
  return { ...manifest, manifest_sha256 };
}

/** The benchmark as `get_benchmark` shows it. */
export function describe() {
  const { episodes, ...manifest } = plan();
  return { ...manifest, ...NOT_HASHED, episodes_total: episodes.length };
}

/** Refuse a chunk that breaks the action space, as a whole. */
export function checkActions(actions) {
  if (actions.length > LIMITS.max_chunk) throw invalid('/actions', `at most ${LIMITS.max_chunk} actions`);
  actions.forEach(({ values }, index) => {
    const pointer = `/actions/${index}/values`;
    for (const name of Object.keys(values)) {
      if (!Object.hasOwn(ACTIONS, name)) throw invalid(below(pointer, name), 'is not in the action space');
    }
    for (const [name, { size, out_of_range, minimum, maximum }] of Object.entries(ACTIONS)) {
      if (values[name]?.length !== size) throw invalid(below(pointer, name), `must hold ${size} numbers`);
      if (out_of_range !== 'refuse') continue;
      const outside = values[name].findIndex((value, i) => value < minimum[i] || value > maximum[i]);
      if (outside >= 0) throw invalid(below(below(pointer, name), outside), 'is out of range');
    }
  });
}

/** One attempt at one episode. */
export class Simulator {
  constructor(task, { max_steps, success_rule }) {
    Object.assign(this, { task, max_steps, success_rule, steps: 0, score: 0, goal: false });
    Object.assign(this, { terminated: false, vector: fill(8, 0), clipped: fill(2, 0) });
  }

  get truncated() { return !this.terminated && this.steps >= this.max_steps; }

  get isOver() { return this.terminated || this.truncated; }

  /** Execute one checked action; returns its reward. */
  async step({ score: [score], success: [success], end: [end], delay_s: [delay_s], vector, clipped }) {
    if (this.task === 'delay') {
      // Timers may fire a millisecond early; the step must not end early (CAL-004).
      const until = performance.now() + delay_s * 1000;
      while (performance.now() < until) await sleep(Math.ceil(until - performance.now()));
    }
    this.steps += 1;
    this.score = score;
    this.goal = success === 1 || (this.goal && this.success_rule === 'any_step');
    this.terminated = end === 1;
    this.vector = vector;
    this.clipped = clipped.map((value) => Math.min(1, Math.max(-1, value)));
    return score;
  }

  result() {
    const outcome = this.goal ? 'success' : 'failure';
    return { outcome, score: this.task === 'score' ? this.score : Number(this.goal) };
  }

  observe() {
    const { vector, clipped } = this;
    return { state: { count: [this.steps], vector, clipped }, images: {}, tensors: {} };
  }
}
