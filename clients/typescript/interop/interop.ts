/* What an evaluation in TypeScript sees: interop SCENARIO URL TOKEN prints one JSON line.
 *
 * The scenarios are those of tests/interop/scenarios.py, which judges; nothing is judged here.
 */

import {
  ProctorError, Server, Session, decodeObservation, evaluate, protocol,
  type Action, type EvaluateOptions, type Observation,
} from "../src";

const VECTOR = [-0, 0.1, 5e-324, 1.7976931348623157e308, 9007199254740991, 1 / 3, -2.5e-8, 1e22];
type Seen = Record<string, unknown>;
type Results = Record<string, protocol.EpisodeResult[]>;
type Task = protocol.CalibrationTask;

const repeat = <T>(count: number, item: T): T[] => Array(count).fill(item);
const hex = (data: ArrayBufferView) => Buffer.from(data.buffer, data.byteOffset, data.byteLength).toString("hex");
const sleep = (ms: number) => new Promise((done) => setTimeout(done, ms));

/** One action of `calibration`; its success is a score above one half. */
function act(score: number, values: Record<string, number[]> = {}) {
  const rest = { success: [score > 0.5 ? 1 : 0], end: [0], delay_s: [0], fault: [0] };
  return { score: [score], ...rest, vector: Array(8).fill(0), clipped: [0, 0], ...values };
}

const byIndex = (scores: number[]) => (seen: Observation) => repeat(2, act(scores[seen.turn.episode!.index]));

class Scenario {
  readonly server: Server;

  constructor(readonly url: string, readonly token: string) {
    this.server = new Server(url, token);
  }

  submit(tasks: Task[], max_steps = 10, more: Partial<protocol.SubmitRun> = {}, key?: string): Promise<protocol.Run> {
    const policy = { name: "interop" };
    return this.server.submit({ benchmark_id: "calibration", policy, options: { tasks, max_steps }, ...more }, key);
  }

  /** Evaluate, and say what was seen with the results by worker. */
  async evaluate(
    act: (seen: Observation) => Action[] | Promise<Action[]>, options: Partial<EvaluateOptions>,
  ): Promise<[Seen, Results]> {
    const results: Results = {};
    const onResult = (result: protocol.EpisodeResult, worker: string) => void (results[worker] ??= []).push(result);
    const { url, token } = this;
    const score = await evaluate({ url, token, benchmark: "calibration", policy: () => ({ act }), onResult, ...options });
    return [{ run_id: score.run_id, score: score.score, complete: score.complete }, results];
  }

  async submit_(): Promise<Seen> {
    const key = crypto.randomUUID();
    const runs = [await this.submit(["score"], 10, {}, key), await this.submit(["score"], 10, {}, key)];
    const { server } = this;
    const listed = await server.call((init) => server.control.listRuns({ limit: 1000 }, init));
    const { limits } = await server.service();
    const benchmark = await server.benchmark("calibration");
    const sizes = Object.entries(benchmark.action_space).map(([name, space]) => [name, space.size]);
    return {
      run_ids: runs.map((run) => run.run_id),
      listed: listed.runs.filter((run) => run.run_id === runs[0].run_id).length,
      max_workers: limits.max_workers,
      action_sizes: Object.fromEntries(sizes),
    };
  }

  async two_workers(): Promise<Seen> {
    const policy = (seen: Observation) => repeat(2, act(seen.turn.episode!.index % 2, { delay_s: [0.05] }));
    const [seen, results] = await this.evaluate(policy, { workers: 2, calibration: { tasks: repeat(8, "delay"), max_steps: 4 } });
    const played = Object.entries(results).map(([worker, list]) => [worker, list.map((r) => r.index)]);
    return { ...seen, played: Object.fromEntries(played) };
  }

  async chunks(): Promise<Seen> {
    const session = await Session.attach(this.server, await this.submit(["count"]), "worker-0");
    const turns: protocol.Turn[] = [];
    for (let i = 0; i < 3; i++) turns.push(await session.predict(repeat(4, { values: act(0) }), "all"));
    return {
      executed: turns.map((t) => t.executed_steps),
      counts: turns.map((t) => t.observations!.map((o) => o.state.count[0])),
      rewards: turns.map((t) => t.rewards.length),
      stopped_early: turns.map((t) => t.stopped_early),
      truncated: turns.map((t) => t.truncated),
      done: session.turn.done,
      steps: session.turn.episode_result!.steps,
    };
  }

  async echo(): Promise<Seen> {
    const run = await this.submit(["echo"], 10, { images: { codec: "raw", width: 64, height: 48 } });
    const session = await Session.attach(this.server, run, "worker-0");
    const turn = await session.predict([{ values: act(0, { vector: VECTOR }) }]);
    const { images, tensors, state } = decodeObservation(turn.observation!);
    const seen = Object.entries(tensors).map(([name, t]) => {
      // Half precision is decoded: its bits are those that were sent.
      const data = t.dtype === "float16" ? turn.observation!.tensors[name].data : null;
      return [name, { dtype: t.dtype, shape: t.shape, data: data ? Buffer.from(data, "base64").toString("hex") : hex(t.data) }];
    });
    const { codec, height, width, channels, data } = images.pattern;
    return {
      codec, size: [height, width, channels], image: hex(data), tensors: Object.fromEntries(seen),
      vector: state.vector.map((number) => {
        const view = new DataView(new ArrayBuffer(8));
        view.setFloat64(0, number);
        return hex(view);
      }),
    };
  }

  async lost_answer(): Promise<Seen> {
    const run = await this.submit(["count"], 6);
    const session = await Session.attach(this.server, run, "worker-0");
    const counts: number[] = [];
    for (let i = 0; i < 2; i++) {
      const turn = await session.predict(repeat(3, { values: act(0) }), "all");
      counts.push(...turn.observations!.map((o) => o.state.count[0]));
    }
    return { run_id: run.run_id, counts, done: session.turn.done };
  }

  async lost_session(): Promise<Seen> {
    const calls: string[] = [];
    let runId = "";
    const policy = async (seen: Observation) => {
      calls.push(seen.turn.session_id);
      // Thinks until the lease is over; the gateway loses its heartbeats.
      if (calls.length === 2) while ((await this.server.run(runId)).live_workers) await sleep(100);
      return repeat(2, act(1));
    };
    const [seen, results] = await this.evaluate(policy, {
      calibration: { tasks: ["count"], max_steps: 10 }, idleTimeoutS: 2, onRun: (run) => void (runId = run.run_id),
    });
    return { ...seen, sessions: new Set(calls).size, attempt: results["worker-0"].at(-1)!.attempt };
  }

  async heartbeat(): Promise<Seen> {
    const sessions = new Set<string>();
    const policy = async (seen: Observation) => {
      sessions.add(seen.turn.session_id);
      if (seen.step === 2) await sleep(4000); // longer than the lease
      return repeat(2, act(1));
    };
    const calibration = { tasks: ["count"] as Task[], max_steps: 10 };
    const [seen, results] = await this.evaluate(policy, { calibration, idleTimeoutS: 3.1 }); // no whole number of ms in a third
    return { ...seen, sessions: sessions.size, attempt: results["worker-0"].at(-1)!.attempt };
  }

  async restart(): Promise<Seen> {
    const calibration = { tasks: repeat<Task>(4, "score"), max_steps: 6 };
    const [seen, results] = await this.evaluate(byIndex([0.25, 0.5, 0.75, 1]), { calibration });
    return { ...seen, attempts: results["worker-0"].map((r) => r.attempt) };
  }

  async worker_limit(): Promise<Seen> {
    const run = await this.submit(repeat(3, "score"), 10, { max_workers: 1, idle_timeout_s: 5 }), runId = run.run_id;
    const first = await Session.attach(this.server, run, "worker-0");
    const data = this.server.data(run);
    const problem = await problemOf(this.server.retryPolicy.once((init) =>
      data.attachWorker({ runId, workerId: "worker-1", attachWorker: { attach_key: "k" } }, init)));
    await first.detach();
    const [seen] = await this.evaluate(byIndex([1, 1, 1]), { runId, workers: 2 });
    return { ...seen, problem };
  }

  async stop_resume(): Promise<Seen> {
    const run = await this.submit(repeat(3, "score"), 2), runId = run.run_id;
    const session = await Session.attach(this.server, run, "worker-0");
    const chunk = (score: number) => repeat(2, { values: act(score) });
    await session.predict(chunk(0.5));
    const stopped = await this.server.stop(runId, "abort");
    const problem = await problemOf(session.predict(chunk(0.25)));
    const [seen, results] = await this.evaluate(byIndex([0.5, 0.25, 1]), { runId });
    return { ...seen, problem, stopped: stopped.state, after: results["worker-0"].map((r) => r.index) };
  }

  async problems(): Promise<Seen> {
    const { server } = this;
    const unauthenticated = new Server(this.url, "not-a-token");
    const run = await this.submit(["count"]);
    const session = await Session.attach(server, run, "worker-0");
    const { session_id } = session.turn;
    const skipped = { session_id, seq: 7, actions: [{ values: act(0) }] };
    return {
      problems: [
        await problemOf(this.submit(["count"], 10, { benchmark_id: "no_such" })),
        await problemOf(server.run("no_such")),
        await problemOf(unauthenticated.call((init) => unauthenticated.control.listRuns({}, init))),
        await problemOf(session.predict([{ values: act(0, { vector: [1] }) }])),
        await problemOf(server.call((init) =>
          server.data(run).predict({ runId: run.run_id, workerId: "worker-0", predict: skipped }, init))),
      ],
    };
  }

  /** Every run that is listed is answered by what is no run. */
  async wrong_answers(): Promise<Seen> {
    const errors: Seen = {};
    const { runs } = await this.server.call((init) => this.server.control.listRuns({}, init));
    for (const { run_id } of runs) errors[run_id] = (await problemOf(this.server.run(run_id))).code;
    return { errors };
  }

  async later_version(): Promise<Seen> {
    const service = await this.server.service();
    const benchmark = await this.server.benchmark("calibration");
    const vector = benchmark.action_space["vector"];
    const run = await this.submit(["echo"]);
    const session = await Session.attach(this.server, run, "worker-0");
    const seen = decodeObservation(session.turn.observation!); // drops what it cannot know
    return {
      profiles: service.profiles, image_codecs: service.image_codecs, success_rule: benchmark.success_rule,
      rotation: vector.parts?.["all"]?.rotation, out_of_range: vector.out_of_range, mode: run.mode, policy: run.policy.name,
      codec: seen.images["pattern"].codec, dtype: session.turn.observation!.tensors["float64"].dtype,
      problem: await problemOf(this.server.run("no_such")),
    };
  }

  async score(): Promise<Seen> {
    const calibration = { tasks: repeat<Task>(5, "score"), max_steps: 2 };
    const [{ run_id }] = await this.evaluate(byIndex([1, 0.5, 0.25, 0, 0.25]), { calibration });
    const runId = String(run_id);
    const score = await this.server.score(runId);
    const episodes: protocol.Episode[] = [];
    for await (const episode of this.server.episodes(runId, 2)) episodes.push(episode);
    const splits = Object.entries(score.by_split).map(([name, group]) => [name, group.mean]);
    return {
      run_id, score: score.score, success_rate: score.success_rate,
      interval: [score.success_interval.low, score.success_interval.high], success: score.counts.success,
      splits: Object.fromEntries(splits),
      episodes: episodes.map((e) => [e.index, e.result!.score, e.result!.seed]),
    };
  }
}

async function problemOf(request: Promise<unknown>): Promise<Seen> {
  try {
    await request;
  } catch (error) {
    if (!(error instanceof ProctorError)) throw error;
    const { code, retryable, sideEffects, status, problem } = error;
    return {
      status, code, retryable, side_effects: sideEffects, retry_after_s: error.retryAfterS ?? null,
      pointers: (problem?.errors ?? []).map((item) => item.pointer),
      expected_seq: problem?.expected_seq, ended_by: problem?.ended_by,
    };
  }
  return { code: "accepted" };
}

const [name, url, token] = process.argv.slice(2);
const scenario = new Scenario(url, token);
const scenarios: Record<string, () => Promise<Seen>> = {
  submit: () => scenario.submit_(), two_workers: () => scenario.two_workers(), chunks: () => scenario.chunks(),
  echo: () => scenario.echo(), lost_answer: () => scenario.lost_answer(), lost_session: () => scenario.lost_session(),
  heartbeat: () => scenario.heartbeat(), restart: () => scenario.restart(), worker_limit: () => scenario.worker_limit(),
  stop_resume: () => scenario.stop_resume(), problems: () => scenario.problems(), score: () => scenario.score(),
  wrong_answers: () => scenario.wrong_answers(), later_version: () => scenario.later_version(),
};
scenarios[name]().then((seen) => console.log(JSON.stringify(seen)), (error) => {
  console.error(error);
  process.exitCode = 1;
});
