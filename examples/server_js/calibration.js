// The benchmark `calibration` of spec/calibration.md: its description, its actions, its simulator.
import { createHash } from 'node:crypto';
import { setTimeout as sleep } from 'node:timers/promises';
import { Problem, invalid } from './problems.js';
import { LIMITS } from './shapes.js';

const fill = (size, value) => (value === undefined ? undefined : Array(size).fill(value));
const NONE = { frame: 'none', rotation: 'none', relative_to: 'none' };
const space = (size, out_of_range, low, high, [quantity, unit] = ['number', '1']) => ({
  size, parts: { all: { start: 0, size, quantity, unit, ...NONE } }, out_of_range, minimum: fill(size, low), maximum: fill(size, high),
});
const ACTIONS = {
  score: space(1, 'refuse', 0, 1),
  success: space(1, 'refuse', 0, 1),
  end: space(1, 'refuse', 0, 1),
  delay_s: space(1, 'refuse', 0, 5, ['time', 's']),
  fault: space(1, 'refuse', 0, 2),
  vector: space(8, 'unbounded'),
  clipped: space(2, 'clip', -1, 1),
};
const STATE = { count: space(1, 'unbounded'), vector: space(8, 'unbounded'), clipped: space(2, 'unbounded') };

// dtype: its six elements as little-endian bytes; float16 by its bits, since Node 20 has no such array.
const bytes = (array) => Buffer.from(array.buffer).toString('base64');
const floats = (normal, largest) => [-2, -0.5, 0, 0.5, normal, largest];
const TENSORS = {
  bool: bytes(Uint8Array.of(0, 1, 0, 1, 0, 1)),
  int8: bytes(Int8Array.of(-2, -1, 0, 1, -128, 127)),
  int16: bytes(Int16Array.of(-2, -1, 0, 1, -32768, 32767)),
  int32: bytes(Int32Array.of(-2, -1, 0, 1, -(2 ** 31), 2 ** 31 - 1)),
  int64: bytes(BigInt64Array.of(-2n, -1n, 0n, 1n, -(2n ** 63n), 2n ** 63n - 1n)),
  uint8: bytes(Uint8Array.of(0, 1, 2, 3, 4, 255)),
  uint16: bytes(Uint16Array.of(0, 1, 2, 3, 4, 65535)),
  uint32: bytes(Uint32Array.of(0, 1, 2, 3, 4, 2 ** 32 - 1)),
  uint64: bytes(BigUint64Array.of(0n, 1n, 2n, 3n, 4n, 2n ** 64n - 1n)),
  float16: bytes(Uint16Array.of(0xc000, 0xb800, 0, 0x3800, 0x0400, 0x7bff)),
  float32: bytes(Float32Array.from(floats(2 ** -126, (2 - 2 ** -23) * 2 ** 127))),
  float64: bytes(Float64Array.from(floats(2 ** -1022, Number.MAX_VALUE))),
  empty: '',
};
const tensor = (name) => (name === 'empty' ? { dtype: 'float64', shape: [0, 3] } : { dtype: name, shape: [2, 3] });

const described = Object.keys(TENSORS).map((name) => [name, { ...tensor(name), description: 'Known elements.', tasks: ['echo'] }]);
const ABOUT = {
  benchmark_id: 'calibration',
  version: '1',
  title: 'Calibration',
  description: 'No physics: a server is checked with it from outside.',
  tasks: ['score', 'count', 'echo', 'delay', 'fault'],
  splits: ['even', 'odd'],
  control_rate_hz: 10,
  max_chunk: LIMITS.max_chunk,
  action_space: ACTIONS,
  observation_space: {
    state: STATE,
    images: { pattern: { channels: 3, description: 'A pattern that moves with `count`.', tasks: ['echo'] } },
    tensors: Object.fromEntries(described),
  },
  image_sizes: [{ width: 16, height: 12 }, { width: 64, height: 48 }],
  image_codecs: ['raw'],
  simulator: { name: 'calibration', version: '1' },
};

// RFC 8785: JSON.stringify writes texts and numbers in its form, and sort has its order of names.
function canonical(value) {
  if (Array.isArray(value)) return `[${value.map(canonical)}]`;
  if (value === null || typeof value !== 'object') return JSON.stringify(value);
  const names = Object.keys(value).filter((name) => value[name] !== undefined).sort();
  return `{${names.map((name) => `${JSON.stringify(name)}:${canonical(value[name])}`)}}`;
}

const unexplained = (named) =>
  Object.fromEntries(Object.entries(named).map(([name, { description, ...entry }]) => [name, entry]));

/** The manifest of spec/benchmarks.md: what can change a score, without texts and choices of the server (BEN-006). */
function manifest(rules, episodes) {
  const { title, description, max_chunk, image_sizes, image_codecs, observation_space, ...kept } = ABOUT;
  const { state, images, tensors } = observation_space;
  const observed = { state, images: unexplained(images), tensors: unexplained(tensors) };
  return { ...kept, ...rules, observation_space: observed, episodes: episodes.map(({ index, ...episode }) => episode) };
}

/** What is played under these options, with the digest of its manifest. */
export function plan(options = {}) {
  const { tasks = ['score'], max_steps = 10, max_attempts = 3, max_faults = 3, success_rule = 'any_step' } = options;
  const rules = { max_steps, max_attempts, max_faults, success_rule };
  const episodes = tasks.map((task, index) => ({ index, task, split: ABOUT.splits[index % 2], seed: index + 1000 }));
  const manifest_sha256 = createHash('sha256').update(canonical(manifest(rules, episodes))).digest('hex');
  return { ...rules, episodes, manifest_sha256 };
}

export function describe() {
  const { episodes, ...rules } = plan();
  return { ...ABOUT, ...rules, episodes_total: episodes.length, unavailable_reason: null };
}

/** The image choice of a run: the default, or one that is offered. */
export function chooseImages(wanted) {
  const [codec, size] = [ABOUT.image_codecs[0], ABOUT.image_sizes[0]];
  if (!wanted) return { codec, ...size };
  if (wanted.codec !== codec) throw invalid(['/images/codec', `only ${codec} is offered`]);
  const offered = ABOUT.image_sizes.some(({ width, height }) => width === wanted.width && height === wanted.height);
  if (!offered) throw invalid(['/images/width', 'this size is not offered']);
  return wanted;
}

/** Refuse a policy that takes other conventions for granted, part by part. */
export function checkAssumptions({ control_rate_hz, action = {}, state = {} } = {}) {
  const errors = [];
  const compare = (pointer, assumed, fact, where = '') => {
    if (assumed !== fact) errors.push({ pointer, detail: `assumed ${assumed}, is ${fact ?? 'absent'}${where}` });
  };
  const step = (name) => `/${name.replaceAll('~', '~0').replaceAll('/', '~1')}`;
  /** What holds a name, or an error that nothing does. */
  const find = (named, name, pointer) => {
    if (Object.hasOwn(named, name)) return named[name];
    errors.push({ pointer, detail: `there is only ${Object.keys(named)}` });
    return undefined;
  };
  if (control_rate_hz !== undefined) compare('/assumes/control_rate_hz', control_rate_hz, ABOUT.control_rate_hz);
  for (const [kind, vectors, spaces] of [['action', action, ACTIONS], ['state', state, STATE]]) {
    for (const [name, { size, parts = {}, ...ofAll }] of Object.entries(vectors)) {
      const at = `/assumes/${kind}${step(name)}`;
      const fact = find(spaces, name, at);
      if (!fact) continue;
      if (size !== undefined) compare(`${at}/size`, size, fact.size);
      // CONV-004: what stands beside `parts` is about each part; here there is one.
      for (const [member, value] of Object.entries(ofAll)) compare(`${at}/${member}`, value, { scale: 1, ...fact.parts.all }[member], ' in all');
      for (const [part, members] of Object.entries(parts)) {
        const declared = find(fact.parts, part, `${at}/parts${step(part)}`);
        if (!declared) continue;
        for (const [member, value] of Object.entries(members)) {
          compare(`${at}/parts${step(part)}/${member}`, value, { scale: 1, ...declared }[member], ` in ${part}`);
        }
      }
    }
  }
  if (errors.length) throw new Problem('convention_mismatch', { errors });
}

/** Refuse a chunk that breaks the action space, as a whole. */
export function checkActions(actions) {
  if (actions.length > LIMITS.max_chunk) throw invalid(['/actions', `at most ${LIMITS.max_chunk} actions`]);
  for (const [index, { values }] of actions.entries()) {
    const at = (name) => `/actions/${index}/values/${name.replaceAll('~', '~0').replaceAll('/', '~1')}`;
    for (const name of Object.keys(values)) {
      if (!Object.hasOwn(ACTIONS, name)) throw invalid([at(name), 'is not in the action space']);
    }
    for (const [name, { size, out_of_range, minimum, maximum }] of Object.entries(ACTIONS)) {
      const vector = values[name];
      if (vector?.length !== size) throw invalid([at(name), `must hold ${size} numbers`]);
      const outside = vector.findIndex((value, i) => value < minimum?.[i] || value > maximum?.[i]);
      if (out_of_range === 'refuse' && outside >= 0) throw invalid([`${at(name)}/${outside}`, 'is out of range']);
    }
  }
}

/** One attempt at one episode. A fault is thrown as the string `broken` or `unplayable`. */
export class Simulator {
  constructor(task, rules, images) {
    Object.assign(this, { task, rules, images });
    Object.assign(this, { steps: 0, vector: fill(8, 0), clipped: fill(2, 0), score: 0, goal: false, everGoal: false });
    this.terminated = false;
  }

  // Reported as the step limit only when the task did not end by itself at that step.
  get truncated() { return !this.terminated && this.steps >= this.rules.max_steps; }
  get over() { return this.terminated || this.truncated; }

  /** Executes one checked action and returns its reward. */
  async step({ score: [score], success: [success], end: [end], delay_s: [delay], fault: [fault], vector, clipped }) {
    if (this.task === 'fault' && fault === 2) throw 'unplayable';
    if (this.task === 'fault' && fault >= 1) throw 'broken'; // CAL-009: between whole numbers nothing is rounded
    if (this.task === 'delay') {
      // Timers may fire a millisecond early; the step must not.
      const until = performance.now() + delay * 1000;
      while (performance.now() < until) await sleep(Math.ceil(until - performance.now()));
    }
    this.steps += 1;
    this.vector = vector;
    this.clipped = clipped.map((value) => Math.min(1, Math.max(-1, value)));
    this.score = score;
    this.goal = success === 1;
    this.everGoal ||= this.goal;
    this.terminated = end === 1;
    return score;
  }

  result() {
    const success = this.rules.success_rule === 'any_step' ? this.everGoal : this.goal;
    const score = this.task === 'score' ? this.score : Number(success);
    return { outcome: success ? 'success' : 'failure', score };
  }

  observe() {
    const state = { count: [this.steps], vector: this.vector, clipped: this.clipped };
    if (this.task !== 'echo') return { state, images: {}, tensors: {} };
    const tensors = Object.entries(TENSORS).map(([name, data]) => [name, { ...tensor(name), data }]);
    return { state, images: { pattern: this.picture() }, tensors: Object.fromEntries(tensors) };
  }

  picture() {
    const { codec, width, height } = this.images;
    const data = Buffer.alloc(width * height * 3);
    for (let i = 0; i < data.length; i += 1) {
      const pixel = Math.floor(i / 3);
      data[i] = (7 * (pixel % width) + 13 * Math.floor(pixel / width) + 29 * (i % 3) + this.steps) % 256;
    }
    return { codec, width, height, channels: 3, data: data.toString('base64') };
  }
}
