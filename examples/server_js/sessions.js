// What a worker does: attach, predict, heartbeat, detach. One turn of a session is in execution at a time.
import { randomBytes } from 'node:crypto';
import { Simulator, checkActions, checkAssumptions } from './calibration.js';
import { fingerprint } from './json.js';
import { Problem } from './problems.js';

function renew(run, session) {
  const idle = run.record.idle_timeout_s;
  session.lease = { expires_at: new Date(Date.now() + idle * 1000).toISOString(), idle_timeout_s: idle };
  clearTimeout(session.timer);
  // LEASE-005: a turn in execution renews the lease itself when it is through.
  session.timer = setTimeout(() => session.inflight || run.end(session, 'lease_ended'), idle * 1000 + 1);
}

/** The session, if this worker may still use it. */
function live(run, worker, id) {
  const session = run.sessions.get(id);
  if (!session || session.worker !== worker) throw new Problem('session_ended', { ended_by: 'unknown' });
  if (session.takenOver) {
    // The successor may have had successors of its own; the worker's latest session speaks for them.
    if (!run.workers.get(worker).ended) throw new Problem('session_superseded');
    // The list of endings has no word for a session that was taken over by one that has ended since.
    throw new Problem('session_ended', { ended_by: 'unknown' });
  }
  if (session.ended) throw new Problem('session_ended', { ended_by: session.ended });
  return session;
}

/** Puts a session before its next episode, or marks it as done. */
function proceed(run, session) {
  session.episode = run.handOut();
  session.done = session.episode === null;
  if (session.episode) session.simulator = new Simulator(session.episode.task, run.rules, run.record.images);
}

function turn(session, began, played = {}) {
  const { episode, simulator, done } = session;
  const shown = done ? {} : {
    episode: {
      episode_id: episode.episode_id, index: episode.index, task: episode.task, attempt: episode.attempt,
      instruction: `Calibration task ${episode.task}.`, step: simulator.steps, max_steps: simulator.rules.max_steps,
    },
    observation: simulator.observe(),
  };
  const { simulated = 0, ...facts } = played;
  const simulate_s = simulated / 1000;
  const total_s = Math.max((performance.now() - began) / 1000, simulate_s);
  return {
    session_id: session.id, seq: session.seq, executed_steps: 0, stopped_early: false, rewards: [],
    terminated: false, truncated: false, ...facts, ...shown, done, lease: session.lease,
    timing: { total_s, queue_s: 0, simulate_s, render_s: 0, encode_s: 0 },
  };
}

/** Keeps the turn for a repeat; from here on the policy thinks (EPI-011). */
function answer(session, began, played) {
  session.turn = turn(session, began, played);
  session.answered = performance.now();
}

export async function attach(run, worker, body) {
  const began = performance.now();
  let current;
  for (;;) {
    current = run.workers.get(worker);
    if (current?.ended) current = undefined;
    // A lost answer is repeated in every state of the run; anything else is a new attachment.
    if (current?.key !== body.attach_key) {
      run.permit('attach_worker');
      checkAssumptions(body.assumes);
      if (current && !current.done && !body.takeover) throw new Problem('worker_busy');
    }
    if (!current?.inflight) break;
    await current.inflight; // what is executing ends where the successor begins
  }
  if (current?.key === body.attach_key) {
    renew(run, current);
    return current.turn;
  }
  if ((!current || current.done) && run.holders() >= run.record.max_workers) throw new Problem('worker_limit');
  return open(run, worker, body, current, began);
}

function open(run, worker, body, current, began) {
  const id = randomBytes(16).toString('base64url');
  const session = { id, worker, key: body.attach_key, seq: 0, done: false, ended: null };
  run.sessions.set(id, session);
  run.workers.set(worker, session);
  run.move('attach_worker');
  if (current && body.takeover) {
    current.takenOver = true;
    clearTimeout(current.timer);
    session.episode = current.episode;
    session.simulator = current.simulator;
    current.episode = null;
  }
  if (!session.episode) proceed(run, session);
  renew(run, session);
  answer(session, began);
  run.changed();
  run.settle();
  return session.turn;
}

export async function predict(run, worker, body) {
  const began = performance.now();
  // PRED-005: a request that arrives while a turn executes waits, and is then decided on the state after the turn.
  for (let s = run.sessions.get(body.session_id); s?.inflight;) await s.inflight;
  const session = live(run, worker, body.session_id);
  const print = fingerprint(body);
  if (body.seq === session.seq) {
    if (print !== session.print) throw new Problem('seq_conflict');
    renew(run, session);
    return session.turn;
  }
  if (body.seq !== session.seq + 1) throw new Problem('seq_out_of_order', { expected_seq: session.seq + 1 });
  if (session.done) throw new Problem('no_episode');
  checkActions(body.actions);
  let release;
  session.inflight = new Promise((resolve) => { release = resolve; });
  try {
    session.episode.thought += began - session.answered;
    const played = await play(run, session, body);
    Object.assign(session, { seq: body.seq, print });
    renew(run, session);
    answer(session, began, played);
    return session.turn;
  } finally {
    session.inflight = null;
    release();
  }
}

/** Executes a chunk; whatever ends the session meanwhile has closed the attempt already. */
async function play(run, session, { actions, observe }) {
  const started = performance.now();
  const { episode, simulator } = session;
  const rewards = [];
  const observations = [];
  let fault;
  for (const { values } of actions) {
    try {
      rewards.push(await simulator.step(values));
    } catch (kind) {
      if (typeof kind !== 'string') throw kind;
      fault = kind;
      break;
    }
    if (session.ended) break;
    if (observe === 'all') observations.push(simulator.observe());
    if (simulator.over) break;
  }
  if (!session.ended && fault) return { ...breakDown(run, session, fault), observations: observe === 'all' ? [] : undefined };
  if (session.ended) throw new Problem('session_ended', { ended_by: session.ended });
  const played = {
    executed_steps: rewards.length, stopped_early: rewards.length < actions.length, rewards,
    observations: observe === 'all' ? observations : undefined, simulated: performance.now() - started,
  };
  if (!simulator.over) return played;
  run.scored(episode, simulator, simulator.result());
  proceed(run, session);
  run.settle();
  const { terminated, truncated } = simulator;
  return { ...played, terminated, truncated, episode_result: episode.result };
}

/** FAULT-001: the same attempt begins again with a new simulator, until the run fails. */
function breakDown(run, session, kind) {
  const { episode } = session;
  episode.faults += 1;
  episode.recentFaults += 1;
  session.simulator = new Simulator(episode.task, run.rules, run.record.images);
  run.writeEpisode(episode);
  if (kind === 'unplayable') run.fail(`the task ${episode.task} cannot be played`, false);
  else if (episode.recentFaults >= run.rules.max_faults) run.fail(`episode ${episode.index} broke its simulator too often`, true);
  if (session.ended) throw new Problem('session_ended', { ended_by: session.ended });
  return { fault: { episode_id: episode.episode_id, faults: episode.faults, detail: 'The simulator was killed by the action.' } };
}

export function heartbeat(run, worker, { session_id }) {
  const session = live(run, worker, session_id);
  renew(run, session);
  return session.lease;
}

export function detach(run, worker, id) {
  try {
    run.end(live(run, worker, id), 'detached');
  } catch (problem) {
    if (problem.body?.code !== 'session_ended') throw problem; // DET-002: it has ended, as was asked
  }
}
