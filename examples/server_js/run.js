// One run: its state, its episodes, its sessions. Nothing here knows HTTP.
import { randomBytes } from 'node:crypto';
import { Simulator, checkActions } from './calibration.js';
import { canonical } from './json.js';
import { Problem } from './problems.js';
import { score } from './scoring.js';
import { LIMITS } from './shapes.js';

// The part of `x-lifecycle` that Core has; a missing command is refused.
const TRANSITIONS = {
  ready: { attach: 'running', stop: 'stopped' },
  running: { attach: 'running', stop: 'stopped', complete: 'completed' },
  stopped: { stop: 'stopped' },
  completed: {},
};
const newId = () => randomBytes(16).toString('hex');
const now = () => new Date().toISOString();

export class Run {
  constructor(account, policy, max_workers, manifest) {
    Object.assign(this, { run_id: newId(), account, policy, max_workers, manifest, state: 'ready', reason: null });
    this.created_at = this.updated_at = now();
    this.sessions = new Map(); // session id → session
    this.workers = new Map(); // worker id → its latest session
    this.episodes = manifest.episodes.map((episode, index) => (
      { ...episode, index, episode_id: newId(), status: 'pending' }));
  }

  permit(command) {
    if (TRANSITIONS[this.state][command]) return;
    throw new Problem('illegal_transition', { detail: `The run is ${this.state}`, state: this.state });
  }

  move(command, reason = null) {
    this.permit(command);
    Object.assign(this, { state: TRANSITIONS[this.state][command], reason, updated_at: now() });
  }

  stop() {
    this.move('stop', 'stopped by a request');
    for (const { episode } of this.liveSessions()) episode.status = 'pending';
    for (const session of this.sessions.values()) session.ended = true; // also one that is done
    return this;
  }

  async attach(worker, { attach_key }) {
    // A turn that is executed ends before anything is decided.
    while (this.workers.get(worker)?.executing) await this.workers.get(worker).executing;
    const current = this.workers.get(worker);
    const isLive = current && !current.ended;
    if (isLive && current.attach_key === attach_key) return current.turn; // ATT-002
    this.permit('attach');
    if (isLive && !current.done) throw new Problem('worker_busy');
    if (this.liveSessions().length >= this.max_workers) throw new Problem('worker_limit');
    this.move('attach');
    const session = { id: newId(), worker, attach_key, seq: 0 };
    this.sessions.set(session.id, session);
    this.workers.set(worker, session);
    this.beginEpisode(session);
    return this.keepTurn(session, performance.now());
  }

  async predict(worker, body) {
    const beganAt = performance.now();
    const session = this.sessions.get(body.session_id);
    while (session?.executing) await session.executing; // PRED-005: a repeat waits for its turn
    if (session?.worker !== worker) throw new Problem('session_ended', { ended_by: 'unknown' });
    if (session.ended) throw new Problem('session_ended', { ended_by: 'run_stopped' });
    const sent = canonical(body);
    const expected_seq = session.seq + 1;
    if (body.seq === session.seq && sent !== session.sent) throw new Problem('seq_conflict');
    if (body.seq === session.seq) return session.turn;
    if (body.seq !== expected_seq) throw new Problem('seq_out_of_order', { expected_seq });
    if (session.done) throw new Problem('no_episode');
    checkActions(body.actions);
    const turn = this.execute(session, body, sent, beganAt);
    const forget = () => { session.executing = null; };
    session.executing = turn.then(forget, forget);
    return turn;
  }

  async execute(session, { seq, actions }, sent, beganAt) {
    const { simulator, episode } = session;
    session.think_ms += Math.max(0, beganAt - session.answeredAt); // 0 if it came before the answer
    const rewards = [];
    for (const { values } of actions) {
      rewards.push(await simulator.step(values));
      if (session.ended) throw new Problem('session_ended', { ended_by: 'run_stopped' });
      if (simulator.isOver) break;
    }
    const played = { executed_steps: rewards.length, stopped_early: rewards.length < actions.length, rewards };
    Object.assign(session, { seq, sent });
    if (simulator.isOver) {
      this.giveResult(episode, simulator, session.think_ms / 1000);
      const { terminated, truncated } = simulator;
      Object.assign(played, { terminated, truncated, episode_result: episode.result });
      this.beginEpisode(session);
    }
    return this.keepTurn(session, beganAt, played);
  }

  giveResult(episode, simulator, think_s) {
    const { index, episode_id, task, split, seed } = episode;
    const { steps, terminated, truncated } = simulator;
    const played = { attempt: 1, faults: 0, ...simulator.result(), steps, terminated, truncated, think_s };
    episode.result = { episode_id, index, task, split, seed, ...played, finished_at: now() };
    Object.assign(episode, { status: 'scored' });
    if (this.count('scored') === this.episodes.length) this.move('complete');
  }

  /** Give the session the next episode of the manifest, or mark it as done. */
  beginEpisode(session) {
    const episode = this.episodes.find(({ status }) => status === 'pending');
    Object.assign(session, { episode, done: !episode, think_ms: 0 });
    if (!episode) return;
    episode.status = 'in_progress';
    session.simulator = new Simulator(episode.task, this.manifest);
  }

  /** Build the session's turn, and keep it for a repeat (PRED-002). */
  keepTurn(session, beganAt, played) {
    const { simulator, done } = session;
    const idle_timeout_s = LIMITS.idle_timeout_s_max;
    session.answeredAt = performance.now();
    session.turn = {
      session_id: session.id, seq: session.seq, executed_steps: 0, stopped_early: false, rewards: [],
      terminated: false, truncated: false, ...played, done,
      lease: { expires_at: new Date(Date.now() + idle_timeout_s * 1000).toISOString(), idle_timeout_s },
      timing: { total_s: (session.answeredAt - beganAt) / 1000, queue_s: 0, simulate_s: 0, render_s: 0, encode_s: 0 },
    };
    if (done) return session.turn;
    const { episode_id, index, task } = session.episode;
    const { max_steps } = this.manifest;
    const instruction = `Calibration task ${task}.`;
    session.turn.episode = { episode_id, index, task, attempt: 1, instruction, step: simulator.steps, max_steps };
    session.turn.observation = simulator.observe();
    return session.turn;
  }

  liveSessions() { return [...this.sessions.values()].filter(({ done, ended }) => !done && !ended); }

  count(status) { return this.episodes.filter((episode) => episode.status === status).length; }

  view() {
    const { run_id, state, reason, policy, max_workers, created_at, updated_at } = this;
    return {
      run_id, state, reason, retryable: null, created_at, updated_at, policy, max_workers,
      benchmark_id: 'calibration', benchmark_version: '1', manifest_sha256: this.manifest.manifest_sha256,
      idle_timeout_s: LIMITS.idle_timeout_s_max, images: { codec: 'raw', width: 16, height: 12 },
      queue_position: null, live_workers: this.liveSessions().length,
      progress: {
        episodes_total: this.episodes.length, episodes_scored: this.count('scored'),
        episodes_in_progress: this.count('in_progress'), episodes_pending: this.count('pending'),
      },
    };
  }

  score() {
    const { run_id, benchmark_id, manifest_sha256, state } = this.view();
    return { run_id, benchmark_id, manifest_sha256, state, ...score(this.episodes) };
  }
}
