// One run: its state by the table, its episodes, and which sessions live. Knows no HTTP.
import { plan } from './calibration.js';
import { Problem } from './problems.js';
import { score } from './scoring.js';

// x-lifecycle of spec/openapi.yaml; a missing cell is a refusal.
const TRANSITIONS = {
  queued: { stop_abort: 'stopped', stop_drain: 'stopped', resume_run: 'queued', capacity: 'ready' },
  ready: { attach_worker: 'running', stop_abort: 'stopped', stop_drain: 'stopped', resume_run: 'ready' },
  running: {
    attach_worker: 'running', stop_abort: 'stopped', stop_drain: 'stopping', resume_run: 'running',
    last_lease_ends: 'ready', all_scored: 'completed', fault: 'failed',
  },
  stopping: {
    stop_abort: 'stopped', stop_drain: 'stopping', last_lease_ends: 'stopped', all_scored: 'completed', fault: 'failed',
  },
  stopped: { stop_abort: 'stopped', stop_drain: 'stopped', resume_run: 'queued' },
  failed: { resume_run: 'queued' },
  completed: {},
};
// A run has no workers after a crash; its episodes start again from their beginning.
const AFTER_CRASH = { running: 'ready', stopping: 'stopped' };

export class Run {
  /** `record` is what the journal keeps of the submit; `keep` writes to the journal, `changed` wakes long-polls. */
  constructor(record, keep, changed) {
    Object.assign(this, { record, keep, changed });
    this.rules = plan(record.submit.options);
    this.episodes = this.rules.episodes.map((episode) => ({
      ...episode, episode_id: `episode-${episode.index}`, status: 'pending', attempt: 1, faults: 0, recentFaults: 0,
    }));
    Object.assign(this, { state: 'queued', reason: null, retryable: null, updated_at: record.created_at });
    this.sessions = new Map(); // session id → session, for as long as the process lives
    this.workers = new Map(); // worker id → its latest session
  }

  /** Applies one line of the journal. */
  restore({ state, reason, retryable, episode, at }) {
    if (state) Object.assign(this, { state: AFTER_CRASH[state] ?? state, reason, retryable });
    if (state === 'queued') this.forgiveFaults();
    if (episode) Object.assign(this.episodes[episode.index], episode, { status: episode.result ? 'scored' : 'pending' });
    this.updated_at = at;
  }

  permit(event) {
    const refused = !TRANSITIONS[this.state][event] || (this.state === 'failed' && !this.retryable);
    if (refused) throw new Problem('illegal_transition', { detail: `The run is ${this.state}`, state: this.state });
  }

  move(event, reason = null, retryable = null) {
    this.permit(event);
    const to = TRANSITIONS[this.state][event];
    if (to === this.state) return;
    Object.assign(this, { state: to, reason, retryable });
    this.write({ state: to, reason, retryable });
    if (to === 'queued') {
      this.forgiveFaults();
      this.queue();
    }
  }

  write(facts) {
    const now = new Date().toISOString();
    if (now > this.updated_at) this.updated_at = now; // RUN-021: a clock may be set back
    this.keep({ run_id: this.record.run_id, at: this.updated_at, ...facts });
    this.changed();
  }

  /** FAULT-010: only faults since the run was last queued count. */
  forgiveFaults() { for (const episode of this.episodes) episode.recentFaults = 0; }

  /** There is always capacity here; `queue_s` pretends otherwise (LIFE-810). */
  queue() {
    const seconds = this.record.submit.options?.queue_s ?? 0;
    clearTimeout(this.queueing);
    const leave = () => this.state === 'queued' && this.move('capacity');
    if (seconds === 0) leave();
    else this.queueing = setTimeout(leave, seconds * 1000);
  }

  stop(mode) {
    this.permit(`stop_${mode}`);
    // A run that has stopped before is not changed: a session that is done may still repeat its last turn.
    if (mode === 'abort' && this.state !== 'stopped') this.endAll('run_stopped');
    // EPI-009: what an abort has closed may be the last attempt of the last episode.
    if (this.allScored()) this.settle();
    else this.move(`stop_${mode}`, `stopped by a request with mode ${mode}`);
  }

  resume() { this.move('resume_run'); }

  fail(reason, retryable) {
    this.move('fault', reason, retryable);
    this.endAll('run_failed');
  }

  /** Ends all sessions; the state is the caller's to move. */
  endAll(why) { for (const session of this.sessions.values()) this.endSession(session, why); }

  end(session, why) {
    this.endSession(session, why);
    this.settle();
  }

  /** Ends a session, closing its attempt unscored; a fault that fails the run costs no attempt (FAULT-007). */
  endSession(session, why) {
    if (session.ended) return;
    session.ended = why;
    clearTimeout(session.timer);
    if (session.episode && why === 'run_failed') session.episode.status = 'pending';
    else if (session.episode) this.close(session.episode, session.simulator);
    session.episode = null;
    this.changed();
  }

  /** EPI-002 to EPI-004: what an attempt that is closed unscored costs. */
  close(episode, simulator) {
    episode.status = 'pending';
    if (simulator.steps === 0) return;
    if (episode.attempt < this.rules.max_attempts) {
      episode.attempt += 1;
      this.writeEpisode(episode);
    } else this.scored(episode, simulator, { outcome: 'abandoned', score: 0 });
  }

  /** What a restart needs of an episode without a result (CRASH-005). */
  writeEpisode({ index, attempt, faults, recentFaults }) {
    this.write({ episode: { index, attempt, faults, recentFaults } });
  }

  /** Gives the episode its result; it is in the journal before it is sent. */
  scored(episode, simulator, { outcome, score: points }) {
    const { index, attempt, faults, task, split, seed, episode_id } = episode;
    const finished = outcome !== 'abandoned';
    episode.status = 'scored';
    episode.result = {
      episode_id, index, task, split, seed, attempt, faults, outcome, score: points, steps: simulator.steps,
      terminated: finished && simulator.terminated, truncated: finished && simulator.truncated,
      think_s: (episode.thought ?? 0) / 1000, finished_at: new Date().toISOString(),
    };
    this.write({ episode: { index, attempt, faults, result: episode.result } });
  }

  /** The next episode in manifest order; a run that drains hands out none. */
  handOut() {
    const episode = this.state === 'running' && this.episodes.find(({ status }) => status === 'pending');
    if (!episode) return null;
    Object.assign(episode, { status: 'in_progress', thought: 0 });
    this.changed();
    return episode;
  }

  holders() {
    const all = [...this.workers.values()];
    return all.filter(({ ended, done }) => !ended && !done).length;
  }

  allScored() { return this.episodes.every(({ status }) => status === 'scored'); }

  /** The events that no command causes. A session that is done holds nothing and keeps nothing going. */
  settle() {
    if (this.state !== 'running' && this.state !== 'stopping') return;
    if (this.allScored()) this.move('all_scored');
    else if (this.holders() === 0) this.move('last_lease_ends', this.state === 'stopping' ? 'drained' : null);
  }

  /** Without `endpoint` and `queue_position`, which are not the run's own knowledge. */
  view() {
    const { run_id, submit, max_workers, idle_timeout_s, images, created_at } = this.record;
    const having = (wanted) => this.episodes.filter(({ status }) => status === wanted).length;
    const { state, reason, retryable, updated_at } = this;
    return {
      run_id, state, reason, retryable, created_at, updated_at, policy: submit.policy, max_workers, idle_timeout_s, images,
      benchmark_id: 'calibration', benchmark_version: '1', manifest_sha256: this.rules.manifest_sha256,
      live_workers: this.holders(),
      progress: {
        episodes_total: this.episodes.length, episodes_scored: having('scored'),
        episodes_in_progress: having('in_progress'), episodes_pending: having('pending'),
      },
    };
  }

  score() {
    const { run_id, benchmark_id, manifest_sha256, state } = this.view();
    return { run_id, benchmark_id, manifest_sha256, state, ...score(this.episodes) };
  }
}
