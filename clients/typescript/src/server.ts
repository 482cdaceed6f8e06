/* The control plane of a server: benchmarks, submission, state, stop, resume, score of runs.
 *
 * Every method repeats its request until it is answered. An operation that is not here is
 * `server.call((init) => server.control.someOperation({ … }, init))`.
 */

import {
  BadSetting, Configuration, ControlApi, DataApi, ResponseError,
  type Benchmark, type Episode, type Run, type Score, type Service, type StopMode, type SubmitRun,
} from "../../../generated_clients/typescript/src";
import { ProctorError, RunFailed, RunStopped } from "./errors";
import { RetryPolicy, milliseconds } from "./retry_policy";

const REASON_MAX = 500;
const LONG_POLL_S = 10;
const UNCHANGED_S = 0.2; // between polls, for servers without long polling
const FIRST_CONTACT_S = 3; // short for a mistyped URL, long enough for a starting server
const SHORTEST_SILENCE_S = 10;
const BUSY_S = 60;
const FIRST_ANSWER_S = 15; // where something accepts connections and is silent: a server can be busy

export interface ServerOptions {
  /** How long an unreachable server is retried, seconds; 300 by default. */
  retryTimeoutS?: number;
  /** Ends every wait and request of this server, but for the detach of a session. */
  signal?: AbortSignal;
  /** Called with the reason of a wait, and with null when it is over; by default stderr has it after 2 s. */
  onWaiting?: (why: string | null) => void;
}

export class Server {
  readonly control: ControlApi;
  readonly retryPolicy: RetryPolicy;

  constructor(url: string, private readonly token: string, options: ServerOptions = {}) {
    const { retryTimeoutS = 300, signal = new AbortController().signal, onWaiting } = options;
    const configuration = this.at(url);
    this.retryPolicy = new RetryPolicy(configuration.basePath, retryTimeoutS, signal, onWaiting);
    this.control = new ControlApi(configuration);
  }

  /** The data plane that a run names. A request without an answer on a dead connection is repeated in time for the lease. */
  data(run: Run): DataApi {
    // Where requests are repeated for less than a minute, a busy server has that in all.
    const silenceS = Math.max(SHORTEST_SILENCE_S, run.idle_timeout_s / 2, BUSY_S - this.retryPolicy.totalS);
    return new DataApi(this.at(run.endpoint, "bad_answer", `${this.retryPolicy.url} named a wrong endpoint of the run: `, fetchWithin(silenceS)));
  }

  /** A text of an error in one line, as others may read it: without the token, users and passwords of URLs. */
  withoutSecrets(text: string): string {
    const shown = (this.token ? text.replaceAll(this.token, "(token)") : text)
      .replace(/(?<=:\/\/)[^/?#\s]*@/g, "")
      .replace(/(:\/\/[^\s?#]*)[?#][^\s'"<>]*/g, "$1?…");
    const characters = [...shown.replace(/[\p{C}\s]+/gu, " ")];
    return characters.length <= REASON_MAX ? characters.join("") : `${characters.slice(0, REASON_MAX - 1).join("")}…`;
  }

  /** Send a request of the generated client until it is answered; throws ProctorError. */
  call<T>(send: (init: RequestInit) => Promise<T>): Promise<T> {
    return this.retryPolicy.call(send);
  }

  /** What the server says of itself; a mistyped URL is an error after seconds. */
  service(): Promise<Service> {
    const first = this.retryPolicy.with({
      totalS: Math.min(FIRST_CONTACT_S, this.retryPolicy.totalS), requestS: FIRST_ANSWER_S,
    });
    return first.call((init) => this.control.describeService({}, init));
  }

  /** Throws `not_found` with the names that the server has. */
  async benchmark(benchmarkId: string): Promise<Benchmark> {
    try {
      return await this.call((init) => this.control.getBenchmark({ benchmarkId }, init));
    } catch (error) {
      if (!(error instanceof ProctorError) || error.code !== "not_found") throw error;
      const { benchmarks } = await this.call((init) => this.control.listBenchmarks({}, init));
      const names = benchmarks.map((one) => one.benchmark_id).join(", ");
      const detail = `${this.retryPolicy.url} has no benchmark ${benchmarkId}; it has ${names}`;
      throw new ProctorError("not_found", detail, { status: 404, problem: error.problem, cause: error });
    }
  }

  /** Submit exactly one run: the repeats of the request carry the same Idempotency-Key. */
  submit(submitRun: SubmitRun, idempotencyKey: string = crypto.randomUUID()): Promise<Run> {
    return this.call((init) => this.control.submitRun({ submitRun, idempotencyKey }, init));
  }

  run(runId: string): Promise<Run> {
    return this.call((init) => this.control.getRun({ runId }, init));
  }

  stop(runId: string, mode: StopMode): Promise<Run> {
    return this.call((init) => this.control.stopRun({ runId, stopRun: { mode } }, init));
  }

  resume(runId: string): Promise<Run> {
    return this.call((init) => this.control.resumeRun({ runId }, init));
  }

  score(runId: string): Promise<Score> {
    return this.call((init) => this.control.getScore({ runId }, init));
  }

  /** All episodes of a run, from the pages of the list; `limit` is of a page. */
  async *episodes(runId: string, limit?: number): AsyncGenerator<Episode> {
    for (let cursor: string | undefined; ; ) {
      const page = await this.call((init) => this.control.listEpisodes({ runId, cursor, limit }, init));
      yield* page.episodes;
      cursor = page.next_cursor ?? undefined;
      if (cursor === undefined) return;
    }
  }

  /** The run now, and again after every change; endless. */
  async *changes(runId: string): AsyncGenerator<Run> {
    for (let etag: string | undefined; ; ) {
      const answer = await this.call((init) => this.poll(runId, etag, init));
      if (answer !== null) {
        etag = answer.etag;
        yield answer.run;
      }
      if (answer === null || etag === undefined) await this.retryPolicy.pause(UNCHANGED_S);
    }
  }

  /** Resume the run if it is stopped or failed; waits while it is stopping. */
  async resumeIfNeeded(runId: string): Promise<Run> {
    for await (const run of this.changes(runId)) {
      if (run.state === "stopping") continue;
      if (run.state === "failed" && !run.retryable) throw new RunFailed(run);
      return run.state === "stopped" || run.state === "failed" ? this.resume(runId) : run;
    }
    throw new Error("changes never end");
  }

  /** Wait until episodes can be played (true) or the run is completed (false).
   *
   * held: episodes held by a session count, because it will be taken over. Throws RunFailed and
   * RunStopped.
   */
  async waitForWork(runId: string, held = false): Promise<boolean> {
    for await (const run of this.changes(runId)) {
      if (run.state === "completed") return false;
      if (run.state === "failed") throw new RunFailed(run);
      if (run.state === "stopped") throw new RunStopped(run);
      if (run.state === "queued" || run.state === "stopping") continue;
      // If a session of others ends early, its episode is played here.
      if (held || run.progress.episodes_pending > 0) return true;
    }
    throw new Error("changes never end");
  }

  private at(basePath: string, code = "invalid_request", prefix = "", fetchApi = fetch): Configuration {
    try {
      return new Configuration({ basePath, accessToken: this.token, fetchApi });
    } catch (error) {
      throw error instanceof BadSetting ? new ProctorError(code, `${prefix}${error.message}.`, { cause: error }) : error;
    }
  }

  /** The run with its ETag, or null if it has not changed since `etag`. */
  private async poll(runId: string, etag: string | undefined, init: RequestInit) {
    const prefer = etag === undefined ? undefined : `wait=${LONG_POLL_S}`;
    try {
      const answer = await this.control.getRun({ runId, ifNoneMatch: etag, prefer }, init).withResponse();
      return { run: answer.message, etag: answer.response.headers.get("ETag") ?? undefined };
    } catch (error) {
      if (error instanceof ResponseError && error.response.status === 304) return null;
      throw error;
    }
  }
}

/** A `fetch` that gives a request up whose answer does not begin in time: its connection may be dead without a sign of it. */
function fetchWithin(silenceS: number): typeof fetch {
  return async (target, init) => {
    const silence = new AbortController();
    const late = () => silence.abort(new DOMException(`no answer began in ${silenceS} s`, "TimeoutError"));
    const timer = setTimeout(late, milliseconds(silenceS));
    const signals = [silence.signal, init?.signal ?? []].flat();
    try {
      return await fetch(target, { ...init, signal: AbortSignal.any(signals) });
    } finally {
      clearTimeout(timer);
    }
  };
}
