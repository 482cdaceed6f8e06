/* A worker loop on the generated client: the least that a policy needs to be evaluated.
 *
 *     npm ci && npm run build && PROCTOR_TOKEN=… node dist/example/worker.js URL [RUN_ID]
 *
 * It plays the benchmark `calibration` with a scripted policy, or goes on with a run. The
 * same loop stands in every language of generated_clients/; see docs/implement/clients.md.
 */

import { randomUUID } from "node:crypto";
import {
  Configuration, ControlApi, DataApi, FetchError, InvalidAnswer, ResponseError, mayPass,
  type Action, type EpisodeResult, type Problem, type Run, type Turn,
} from "../src";
import { act } from "./calibration";

const RETRY_TIMEOUT_MS = 60_000;

export const sleep = (ms: number) => new Promise((done) => setTimeout(done, ms));

/** The server said no: `problem` says why and what to do. */
export class Refused extends Error {
  constructor(readonly status: number, readonly problem: Problem, readonly retryAfterS: number | null, hint = "") {
    super(`${problem.detail} ${hint && `${hint} `}[${problem.code}]`);
  }
}

/** No answer, or one of a gateway or a network that may soon be gone. */
export class Lost extends Error {}

/** The control plane of one server, and the data planes that its runs name. */
export class Server {
  readonly control: ControlApi;
  private hasAnswered = false;

  constructor(private readonly url: string, private readonly token: string) {
    this.control = new ControlApi(this.at(url));
  }

  data(run: Run): DataApi {
    return new DataApi(this.at(run.endpoint));
  }

  private at(basePath: string): Configuration {
    return new Configuration({ basePath, accessToken: this.token });
  }

  /** Send a request; a refusal becomes Refused. */
  async once<T>(request: () => Promise<T>): Promise<T> {
    try {
      const message = await request();
      this.hasAnswered = true;
      return message;
    } catch (error) {
      if (error instanceof FetchError) throw new Lost(error.message);
      if (!(error instanceof ResponseError || error instanceof InvalidAnswer)) throw error;
      const { response } = error;
      const problem = error instanceof ResponseError ? await error.response.json().catch(() => null) : null;
      if (error instanceof ResponseError && typeof problem?.retryable === "boolean") {
        const wait = error.response.headers.get("Retry-After");
        throw new Refused(error.response.status, problem, wait ? Number(wait) : null, error.hint);
      }
      const why = error instanceof ResponseError ? error.message : `${this.url} sent no message of Proctor: ${error.message}`;
      throw response && mayPass(response, this.hasAnswered) ? new Lost(why) : new Error(why);
    }
  }

  /** Send a request until it is answered: a repeat executes nothing twice. */
  async ask<T>(request: () => Promise<T>): Promise<T> {
    const deadline = Date.now() + RETRY_TIMEOUT_MS;
    let why = "an answer", beats = 0; // said after 2 s, and then every 10 s
    const timer = setInterval(() => beats++ % 5 || console.error(`waiting: ${why}`), 2000);
    try {
      for (let pause = 100; ; pause = Math.min(2 * pause, 2000)) {
        try {
          return await this.once(request);
        } catch (error) {
          const again = error instanceof Lost || (error instanceof Refused && error.problem.retryable);
          const wait = error instanceof Refused && error.retryAfterS ? 1000 * error.retryAfterS : pause;
          if (!again || Date.now() + wait > deadline) throw error;
          why = error.message;
          await sleep(wait);
        }
      }
    } finally {
      clearInterval(timer);
    }
  }

  /** Play until no episode is left; a lost session is replaced by a new one. */
  async play(
    runId: string, workerId: string,
    policy: (turn: Turn) => Promise<Action[]>, report: (result: EpisodeResult) => void,
  ): Promise<void> {
    for (;;) {
      const data = this.data(await this.untilOpen(runId));
      const attachWorker = { attach_key: randomUUID() };
      try {
        let turn = await this.ask(() => data.attachWorker({ runId, workerId, attachWorker }));
        while (!turn.done) {
          const predict = { session_id: turn.session_id, seq: turn.seq + 1, actions: await policy(turn) };
          turn = await this.ask(() => data.predict({ runId, workerId, predict }));
          if (turn.episode_result) report(turn.episode_result);
        }
        return;
      } catch (error) {
        if (!(error instanceof Refused)) throw error;
        const { code, state, ended_by } = error.problem;
        if (code === "illegal_transition" && state === "completed") return; // others played the rest
        if (code !== "session_ended" || ended_by === "run_stopped" || ended_by === "run_failed") throw error;
      }
    }
  }

  /** The run, as soon as workers may attach. */
  async untilOpen(runId: string): Promise<Run> {
    for (;;) {
      const run = await this.ask(() => this.control.getRun({ runId }));
      if (run.state !== "queued") return run;
      await sleep(100);
    }
  }
}

async function main(url: string, token: string, runId?: string): Promise<void> {
  const server = new Server(url, token);
  const submitRun = {
    benchmark_id: "calibration", policy: { name: "scripted" },
    options: { tasks: Array(8).fill("score"), max_steps: 20 },
  };
  const idempotencyKey = randomUUID();
  const run = runId
    ? await server.ask(() => server.control.resumeRun({ runId }))
    : await server.ask(() => server.control.submitRun({ submitRun, idempotencyKey }));
  console.log(`run ${run.run_id}: ${run.progress.episodes_total} episodes; its id, as RUN_ID, goes on with it`);
  const report = (r: EpisodeResult) => console.log(`  episode ${r.index} (${r.task}): ${r.outcome}, score ${r.score}`);
  const policy = async (turn: Turn) => Array(5).fill(act((turn.episode!.index % 5) / 4));
  await Promise.all([0, 1].map((i) => server.play(run.run_id, `worker-${i}`, policy, report)));
  const score = await server.ask(() => server.control.getScore({ runId: run.run_id }));
  console.log(`score ${score.score}`);
}

if (require.main === module) {
  const [url, runId] = process.argv.slice(2);
  const token = process.env.PROCTOR_TOKEN;
  if (!url || !token) {
    console.error("usage: node worker.js URL [RUN_ID]; the token is PROCTOR_TOKEN");
    process.exit(1);
  }
  main(url, token, runId).catch((error) => {
    console.error(error.message);
    process.exit(1);
  });
}
