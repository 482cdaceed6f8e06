/* An evaluation from submission to score: what most users call.
 *
 * A round ends when no worker finds an episode to play. Then either the run is completed, or
 * episodes have been requeued by a session that ended, and another round begins.
 */

import type {
  Assumptions, CalibrationOptions, EpisodeResult, EpisodeSelection, ImageChoice, Run, Score,
} from "../../../generated_clients/typescript/src";
import { ActionLayout, chunkOf, type Actions } from "./actions";
import { ProctorError, RunFailed, RunStopped, howToResume } from "./errors";
import { observationOf, type Observation } from "./observation";
import { Server } from "./server";
import { Session } from "./session";
import { describe, summary, type LostSession } from "./silence";

/** Plays episodes one after another; every worker has its own. */
export interface Policy {
  /** Called when an episode begins or restarts: discard all earlier state. */
  reset?(instruction: string): void | Promise<void>;
  /** The next actions: one, or a chunk of up to the benchmark's `max_chunk`. */
  act(observation: Observation): Actions | Promise<Actions>;
}

export interface EvaluateOptions {
  url: string;
  token: string;
  /** Id of the benchmark, for a new run. */
  benchmark?: string;
  /** Continue this run instead; it is resumed if it is stopped or failed. */
  runId?: string;
  /** Makes a policy; called once per worker. */
  policy: () => Policy | Promise<Policy>;
  /** Of the policy, as the score shows it. */
  name?: string;
  version?: string;
  /** Episodes played at a time; 1 by default. */
  workers?: number;
  /** Of the worker ids; must differ between programs that share a run. */
  workerPrefix?: string;
  /** Take over the sessions of a crashed program's workers, and do not wait. */
  takeover?: boolean;
  /** Conventions that the policy assumes. */
  assumes?: Assumptions;
  /** Tasks and splits that are played; all by default. */
  select?: EpisodeSelection;
  images?: ImageChoice;
  /** The lease of a session, seconds. */
  idleTimeoutS?: number;
  /** Of the benchmark `calibration`. */
  calibration?: CalibrationOptions;
  /** How long an unreachable server is retried, seconds; 300 by default. */
  retryTimeoutS?: number;
  /** Ends the evaluation; the run remains, and `runId` continues it. */
  signal?: AbortSignal;
  /** Called as soon as the run exists. */
  onRun?: (run: Run) => void;
  /** Called with each result that a worker of this program has played. */
  onResult?: (result: EpisodeResult, workerId: string) => void;
  /** Called with the reason of a wait, and with null when it is over; by default stderr has it after 2 s. */
  onWaiting?: (why: string | null) => void;
}

/** Sessions in a row that end before their first turn: attaching again does not help then. */
const EMPTY_SESSIONS_MAX = 8;
/** Ends one worker while the others continue. */
const WORKER_ENDING_CODE = "session_superseded";

/** Evaluate a policy on a benchmark; returns its score.
 *
 * Throws ProctorError (RunFailed and RunStopped when the run ends without a score), TypeError for
 * wrong options, the reason of `signal`, and whatever the policy throws. The run remains;
 * `runId` continues it, and `takeover` the episodes in play, at their step.
 */
export async function evaluate(options: EvaluateOptions): Promise<Score> {
  const stop = new AbortController();
  const { url, token, retryTimeoutS, onWaiting, workers = 1, workerPrefix = "worker" } = options;
  if (!Number.isInteger(workers) || workers < 1) throw new TypeError(`workers is ${workers}; it is a whole number of at least 1`);
  requireFunction(options.policy);
  const signal = options.signal ? AbortSignal.any([options.signal, stop.signal]) : stop.signal;
  const server = new Server(url, token, { retryTimeoutS, onWaiting, signal });
  const { limits, profiles } = await server.service();
  if (workers > limits.max_workers) {
    const detail = `${workers} workers requested; ${url} allows ${limits.max_workers} per run.`;
    throw new ProctorError("invalid_request", detail);
  }
  const ids = Array.from({ length: workers }, (_, i) => `${workerPrefix}-${i}`);
  const { run, layout, policies } = await open(server, options, ids);
  options.onRun?.(run);
  const lost: LostSession[] = [];
  let abandoned = 0;
  let team = ids.map((id, i) => new WorkerLoop(server, run, id, policies[i], layout, options, profiles.includes("reasons"), lost));
  try {
    for (let held = options.takeover ?? false; await server.waitForWork(run.run_id, held); held = false) {
      team = await playRound(team, stop);
    }
    const score = await server.score(run.run_id);
    abandoned = score.counts.abandoned;
    return score;
  } catch (error) {
    const isSaid = error instanceof RunFailed || error instanceof RunStopped;
    if (!isSaid) console.error(`Run ${run.run_id} remains on the server; ${howToResume(run.run_id)}.`);
    throw error;
  } finally {
    if (lost.length) console.error(summary(lost, abandoned));
  }
}

const POLICY_HINT = "`policy` is a function that makes a policy, which is an object with `act`: `policy: () => new MyPolicy()`";

/** Refuses a policy, or its class, in the place of the function that makes one. */
function requireFunction(given: unknown): void {
  if (typeof given !== "function") throw new TypeError(`options.policy is no function. ${POLICY_HINT}`);
  if (/^class\b/.test(Function.prototype.toString.call(given))) throw new TypeError(`options.policy is the class ${given.name}. ${POLICY_HINT}`);
}

async function makePolicy(options: EvaluateOptions): Promise<Policy> {
  const policy: Partial<Policy> | undefined | null = await options.policy();
  if (typeof policy?.act === "function") return policy as Policy;
  throw new TypeError(`options.policy() returned an object without a function \`act\`. ${POLICY_HINT}`);
}

/** Submit or resume the run. Policies load first, so that one that fails leaves no run behind. */
async function open(server: Server, options: EvaluateOptions, ids: string[]) {
  const makePolicies = () => Promise.all(ids.map(() => makePolicy(options)));
  const { runId, benchmark: benchmarkId } = options;
  if (runId !== undefined) {
    const known = await server.run(runId);
    const layout = new ActionLayout(await server.benchmark(known.benchmark_id));
    const policies = await makePolicies();
    return { run: await server.resumeIfNeeded(runId), layout, policies };
  }
  if (benchmarkId === undefined) throw new TypeError("evaluate needs `benchmark`, or `runId` of a run to continue");
  const benchmark = await server.benchmark(benchmarkId);
  if (benchmark.unavailable_reason !== null) throw new ProctorError("benchmark_unavailable", benchmark.unavailable_reason);
  const policies = await makePolicies();
  const run = await server.submit({
    benchmark_id: benchmarkId, policy: { name: options.name ?? "policy", version: options.version },
    images: options.images, idle_timeout_s: options.idleTimeoutS, options: options.calibration, select: options.select,
  });
  return { run, layout: new ActionLayout(benchmark), policies };
}

/** Every worker plays until no episode is left; returns those that may play on. */
async function playRound(team: WorkerLoop[], stop: AbortController): Promise<WorkerLoop[]> {
  const failures: unknown[] = [];
  const ended: unknown[] = [];
  const left: WorkerLoop[] = [];
  await Promise.all(team.map(async (worker) => {
    try {
      await worker.play();
      left.push(worker);
    } catch (error) {
      if (error instanceof ProctorError && error.code === WORKER_ENDING_CODE) ended.push(error);
      else failures.push(error);
      if (failures.length) stop.abort(failures[0]);
    }
  }));
  if (failures.length) throw failures[0];
  if (!left.length) throw ended[0];
  return left;
}

/** Plays episodes of a run with its own policy. */
class WorkerLoop {
  private takeover: boolean;

  constructor(
    private readonly server: Server,
    private readonly run: Run,
    private readonly workerId: string,
    private readonly policy: Policy,
    private readonly layout: ActionLayout,
    private readonly options: EvaluateOptions,
    private readonly saysReasons: boolean,
    private readonly losses: LostSession[],
  ) {
    this.takeover = options.takeover ?? false;
  }

  /** Returns when no episode is left, or the state of the run forbids attaching.
   *
   * A session that ends early (its lease ran out, the server restarted) is replaced by another.
   */
  async play(): Promise<void> {
    for (let empty = 0; ; await this.server.retryPolicy.pause(0.05 * (2 ** empty - 1))) {
      let session: Session;
      let reason: string | undefined;
      try {
        session = await this.attach();
      } catch (error) {
        if (error instanceof ProctorError && error.code === "illegal_transition") return;
        throw error;
      }
      try {
        return await this.playSession(session);
      } catch (error) {
        if (this.saysReasons) reason = this.server.withoutSecrets(this.whyLeft(error));
        this.report(session.lost(error));
        empty = session.turn.seq > 0 ? 0 : empty + 1;
        const replace = error instanceof ProctorError && error.code === "session_ended";
        if (!replace || empty === EMPTY_SESSIONS_MAX) throw error;
      } finally {
        await session.leave(reason);
      }
    }
  }

  private report(lost: LostSession | null): void {
    if (lost === null) return;
    this.losses.push(lost);
    console.error(`warning: ${describe(lost)}.`);
  }

  /** Why this worker leaves its episode, as those who look at the run read it. */
  private whyLeft(error: unknown): string {
    if (this.options.signal?.aborted) return "Its evaluation was interrupted by its program.";
    if (this.server.retryPolicy.signal.aborted) return "Its evaluation ended by a failure of another worker.";
    return error instanceof ProctorError ? error.message : `The policy threw ${error}`;
  }

  private async attach(): Promise<Session> {
    const takeover = this.takeover || undefined; // unknown to a server without `sessions`
    // Once only: two programs that both take over would supersede each other forever.
    this.takeover = false;
    return Session.attach(this.server, this.run, this.workerId, { takeover, assumes: this.options.assumes });
  }

  private async playSession(session: Session): Promise<void> {
    let isNew = true; // after a takeover the episode goes on with a new policy
    while (!session.turn.done) {
      const actions = await session.whileAlive(async () => {
        const observation = observationOf(session.turn);
        if (isNew || observation.step === 0) await this.policy.reset?.(observation.instruction);
        return chunkOf(await this.policy.act(observation), this.layout);
      });
      this.server.retryPolicy.signal.throwIfAborted();
      isNew = false;
      const { episode_result: result } = await session.predict(actions);
      if (result) this.options.onResult?.(result, this.workerId);
    }
  }
}
