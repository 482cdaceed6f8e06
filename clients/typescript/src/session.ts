/* A session of a worker: from attach to its end.
 *
 * A lost answer is harmless: the request is repeated unchanged, with its attach_key or seq, and
 * the server repeats the answer without executing the request again. A session that ends in the
 * middle of an episode costs an attempt once an action was executed; so an interrupted
 * evaluation leaves such a session to its lease.
 */

import type { Action, AttachWorker, DataApi, Observe, Run, Turn } from "../../../generated_clients/typescript/src";
import { ProctorError } from "./errors";
import { milliseconds, type RetryPolicy } from "./retry_policy";
import type { Server } from "./server";
import { SilenceMeter, type LostSession } from "./silence";

const SESSION_END_CODES = new Set(["session_ended", "session_superseded"]);
const REASON_S = 1; // to say why an episode is left
const MARGIN_S = 3; // added to the lease when waiting for a busy worker

/** A live session; `turn` is its latest turn. */
export class Session {
  private ended = false;
  private unanswered = false; // a predict was sent and its answer has not come
  private readonly meter = new SilenceMeter();

  private constructor(
    private readonly data: DataApi,
    private readonly retryPolicy: RetryPolicy,
    private readonly address: { runId: string; workerId: string },
    public turn: Turn,
  ) {}

  /** Waits while the run is at its worker limit, or an earlier session of the worker lives. */
  static async attach(
    server: Server, run: Run, workerId: string, more: Omit<AttachWorker, "attach_key"> = {},
  ): Promise<Session> {
    const data = server.data(run);
    const address = { runId: run.run_id, workerId };
    const attachWorker = { ...more, attach_key: crypto.randomUUID() };
    const limitsS = { worker_busy: run.idle_timeout_s + MARGIN_S };
    const retryPolicy = server.retryPolicy.atEndpoint(run.endpoint);
    const turn = await retryPolicy.call((init) => data.attachWorker({ ...address, attachWorker }, init), limitsS);
    return new Session(data, retryPolicy, address, turn);
  }

  /** Execute a chunk exactly once; returns the turn. observe: `all` observations, or the `last`. */
  async predict(actions: Action[], observe?: Observe): Promise<Turn> {
    const predict = { session_id: this.turn.session_id, seq: this.turn.seq + 1, actions, observe };
    this.unanswered = true;
    this.meter.sent();
    try {
      this.turn = await this.retryPolicy.call((init) => this.data.predict({ ...this.address, predict }, init));
    } catch (error) {
      if (!(error instanceof ProctorError)) throw error;
      this.ended = SESSION_END_CODES.has(error.code);
      this.unanswered = error.sideEffects !== "none";
      throw error;
    }
    this.unanswered = false;
    this.meter.answered();
    return this.turn;
  }

  /** How this worker has lost the session by its silence; null if it has not.
   *
   * error: the refusal `session_ended`. A server that no longer knows the reason is believed to have
   * ended the lease if that has passed.
   */
  lost(error: unknown): LostSession | null {
    const { episode, lease: { idle_timeout_s: leaseS } } = this.turn;
    if (!(error instanceof ProctorError) || error.code !== "session_ended" || !episode) return null;
    const silence = this.meter.silence(leaseS);
    const { ended_by: endedBy = "unknown" } = error.problem ?? {};
    if (endedBy !== "lease_ended" && (endedBy !== "unknown" || silence.silentS <= leaseS)) return null;
    const { episode_id: episodeId, step, attempt } = episode;
    return { workerId: this.address.workerId, episodeId, step, attempt, leaseS, ...silence };
  }

  /** The result of `think`; until it comes, heartbeats extend the lease.
   *
   * A function that keeps the thread busy for longer than the lease stops them: compute in a
   * worker thread, or submit the run with a longer `idleTimeoutS`.
   */
  async whileAlive<T>(think: () => T | Promise<T>): Promise<T> {
    const failures: unknown[] = [];
    const beat = () => void this.heartbeat().catch((error) => failures.push(error));
    const timer = setInterval(beat, milliseconds(this.turn.lease.idle_timeout_s / 3));
    try {
      const result = await think();
      if (failures.length) throw failures[0];
      return result;
    } finally {
      clearInterval(timer);
    }
  }

  /** End the session; never throws. Repeated until answered or for 3 s, for it frees a simulator. */
  async detach(): Promise<void> {
    if (this.ended) return;
    this.ended = true;
    const signal = AbortSignal.timeout(milliseconds(MARGIN_S)); // also when the evaluation was interrupted
    const request = { ...this.address, sessionId: this.turn.session_id };
    const retryPolicy = this.retryPolicy.with({ totalS: MARGIN_S, signal, onWaiting: () => {} });
    await retryPolicy.call((init) => this.data.detachWorker(request, init)).catch(() => {});
  }

  /** Give the session up without the loss of an attempt; never throws.
   *
   * Detaches where that costs nothing: it is done, or no action was executed in the attempt. Else
   * the session is left to its lease; within it, `takeover` continues the episode at its step.
   * reason: why, for those who look at the run; only for a server with the profile `reasons`.
   */
  async leave(reason?: string): Promise<void> {
    const { done, episode } = this.turn;
    if (reason && episode && !this.ended) {
      const signal = AbortSignal.timeout(milliseconds(REASON_S)); // also when the evaluation was interrupted
      await this.send(REASON_S, this.retryPolicy.with({ signal }), reason).catch(() => {});
    }
    if (done || !episode || (episode.step === 0 && !this.unanswered)) await this.detach();
    this.ended = true;
  }

  /** Extend the lease. Not repeated: if it is lost, the next one is early enough. */
  private async heartbeat(): Promise<void> {
    if (this.ended) return;
    const timeoutS = Math.max(1, this.turn.lease.idle_timeout_s / 3);
    const { answered, failed } = this.meter.heartbeat(timeoutS);
    try {
      await this.send(timeoutS, this.retryPolicy);
      answered();
    } catch (error) {
      if (!(error instanceof ProctorError && SESSION_END_CODES.has(error.code))) failed();
      // Of a server or a connection, the next predict says what is wrong.
      if (!(error instanceof ProctorError) && !this.retryPolicy.signal.aborted) throw error;
    }
  }

  private async send(timeoutS: number, retryPolicy: RetryPolicy, reason?: string): Promise<void> {
    const heartbeat = { session_id: this.turn.session_id, reason };
    await retryPolicy.once((init) => this.data.heartbeat({ ...this.address, heartbeat }, init), timeoutS);
  }
}
