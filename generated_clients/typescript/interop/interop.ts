/* What the TypeScript client sees: interop SCENARIO URL TOKEN prints one JSON line.
 *
 * The scenarios are those of tools/interop.py, which judges; nothing is judged here.
 */

import { randomUUID } from "node:crypto";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import * as api from "../src";
import { act } from "../example/calibration";
import { Refused, Server, sleep } from "../example/worker";

const VECTOR = [-0, 0.1, 5e-324, 1.7976931348623157e308, 9007199254740991, 1 / 3, -2.5e-8, 1e22];
type Seen = Record<string, unknown>;
type Policy = (turn: api.Turn) => Promise<api.Action[]>;

const repeat = <T>(count: number, item: T): T[] => Array(count).fill(item);
const hex = (base64: string) => Buffer.from(base64, "base64").toString("hex");

function bits(value: number): string {
  const buffer = Buffer.alloc(8);
  buffer.writeDoubleBE(value);
  return buffer.toString("hex");
}

function submit(
  server: Server, tasks: api.CalibrationTask[], max_steps = 10,
  more: Partial<api.SubmitRun> = {}, idempotencyKey: string = randomUUID(),
): Promise<api.Run> {
  const submitRun = { benchmark_id: "calibration", policy: { name: "interop" }, options: { tasks, max_steps }, ...more };
  return server.ask(() => server.control.submitRun({ submitRun, idempotencyKey }));
}

function attach(server: Server, run: api.Run, workerId: string): Promise<api.Turn> {
  const attachWorker = { attach_key: randomUUID() };
  return server.ask(() => server.data(run).attachWorker({ runId: run.run_id, workerId, attachWorker }));
}

function predict(
  server: Server, run: api.Run, turn: api.Turn, actions: api.Action[],
  observe?: api.Observe, seq = turn.seq + 1,
): Promise<api.Turn> {
  const predict = { session_id: turn.session_id, seq, actions, observe };
  return server.ask(() => server.data(run).predict({ runId: run.run_id, workerId: "worker-0", predict }));
}

async function play(server: Server, run: api.Run, policy: Policy, workers = 1): Promise<Record<string, api.EpisodeResult[]>> {
  const seen: Record<string, api.EpisodeResult[]> = {};
  for (let i = 0; i < workers; i++) seen[`worker-${i}`] = [];
  await Promise.all(Object.keys(seen).map((w) => server.play(run.run_id, w, policy, (r) => seen[w].push(r))));
  return seen;
}

const byIndex = (scores: number[]): Policy => async (turn) => repeat(2, act(scores[turn.episode!.index]));

async function theScore(server: Server, run: api.Run): Promise<Seen> {
  const score = await server.ask(() => server.control.getScore({ runId: run.run_id }));
  return { run_id: run.run_id, score: score.score, complete: score.complete };
}

async function problemOf(request: () => Promise<unknown>): Promise<Seen> {
  try {
    await request();
  } catch (error) {
    if (!(error instanceof Refused)) throw error;
    const { code, retryable, side_effects, errors, expected_seq, ended_by } = error.problem;
    return {
      status: error.status, code, retryable, side_effects, retry_after_s: error.retryAfterS,
      pointers: (errors ?? []).map((item) => item.pointer), expected_seq, ended_by,
    };
  }
  return { code: "accepted" };
}

const scenarios: Record<string, (server: Server, url: string) => Promise<Seen>> = {
  async submit(server) {
    const key = randomUUID();
    const runs = [await submit(server, ["score"], 10, {}, key), await submit(server, ["score"], 10, {}, key)];
    const listed = await server.ask(() => server.control.listRuns({ limit: 1000 }));
    const service = await server.ask(() => server.control.describeService());
    const benchmark = await server.ask(() => server.control.getBenchmark({ benchmarkId: "calibration" }));
    const sizes = Object.entries(benchmark.action_space).map(([name, space]) => [name, space.size]);
    return {
      run_ids: runs.map((run) => run.run_id),
      listed: listed.runs.filter((run) => run.run_id === runs[0].run_id).length,
      max_workers: service.limits.max_workers,
      action_sizes: Object.fromEntries(sizes),
    };
  },

  async two_workers(server) {
    const run = await submit(server, repeat(8, "delay"), 4);
    const seen = await play(server, run, async (turn) => repeat(2, act(turn.episode!.index % 2, { delay_s: [0.05] })), 2);
    const played = Object.entries(seen).map(([worker, results]) => [worker, results.map((r) => r.index)]);
    return { ...(await theScore(server, run)), played: Object.fromEntries(played) };
  },

  async chunks(server) {
    const run = await submit(server, ["count"]);
    let turn = await attach(server, run, "worker-0");
    const turns: api.Turn[] = [];
    for (let i = 0; i < 3; i++) {
      turn = await predict(server, run, turn, repeat(4, act(0)), "all");
      turns.push(turn);
    }
    return {
      executed: turns.map((t) => t.executed_steps),
      counts: turns.map((t) => t.observations!.map((o) => o.state.count[0])),
      rewards: turns.map((t) => t.rewards.length),
      stopped_early: turns.map((t) => t.stopped_early),
      truncated: turns.map((t) => t.truncated),
      done: turn.done,
      steps: turn.episode_result!.steps,
    };
  },

  async echo(server) {
    const run = await submit(server, ["echo"], 10, { images: { codec: "raw", width: 64, height: 48 } });
    const first = await attach(server, run, "worker-0");
    const seen = (await predict(server, run, first, [act(0, { vector: VECTOR })])).observation!;
    const image = seen.images.pattern;
    const tensors = Object.entries(seen.tensors).map(([name, t]) => [name, { dtype: t.dtype, shape: t.shape, data: hex(t.data) }]);
    return {
      codec: image.codec, size: [image.height, image.width, image.channels], image: hex(image.data),
      vector: seen.state.vector.map(bits), tensors: Object.fromEntries(tensors),
    };
  },

  async lost_answer(server) {
    const run = await submit(server, ["count"], 6);
    let turn = await attach(server, run, "worker-0");
    const counts: number[] = [];
    for (let i = 0; i < 2; i++) {
      turn = await predict(server, run, turn, repeat(3, act(0)), "all");
      counts.push(...turn.observations!.map((o) => o.state.count[0]));
    }
    return { run_id: run.run_id, counts, done: turn.done };
  },

  async lost_session(server) {
    const run = await submit(server, ["count"], 10, { idle_timeout_s: 2 });
    const calls: string[] = [];
    const seen = await play(server, run, async (turn) => {
      calls.push(turn.session_id);
      const live = async () => (await server.ask(() => server.control.getRun({ runId: run.run_id }))).live_workers;
      if (calls.length === 2) while (await live()) await sleep(100); // thinks for longer than the lease
      return repeat(2, act(1));
    });
    const attempt = seen["worker-0"].at(-1)!.attempt;
    return { ...(await theScore(server, run)), sessions: new Set(calls).size, attempt };
  },

  async restart(server) {
    const run = await submit(server, repeat(4, "score"), 6);
    const seen = await play(server, run, byIndex([0.25, 0.5, 0.75, 1]));
    return { ...(await theScore(server, run)), attempts: seen["worker-0"].map((r) => r.attempt) };
  },

  async worker_limit(server) {
    const run = await submit(server, repeat(3, "score"), 10, { max_workers: 1, idle_timeout_s: 5 });
    const data = server.data(run), runId = run.run_id;
    const first = await attach(server, run, "worker-0");
    const problem = await problemOf(() =>
      server.once(() => data.attachWorker({ runId, workerId: "worker-1", attachWorker: { attach_key: "k" } })));
    await server.ask(() => data.detachWorker({ runId, workerId: "worker-0", sessionId: first.session_id }));
    await play(server, run, byIndex([1, 1, 1]), 2);
    return { ...(await theScore(server, run)), problem };
  },

  async stop_resume(server) {
    const run = await submit(server, repeat(3, "score"), 2), runId = run.run_id;
    const policy = byIndex([0.5, 0.25, 1]);
    let turn = await attach(server, run, "worker-0");
    turn = await predict(server, run, turn, await policy(turn));
    const stopped = await server.ask(() => server.control.stopRun({ runId, stopRun: { mode: "abort" } }));
    const problem = await problemOf(async () => predict(server, run, turn, await policy(turn)));
    await server.ask(() => server.control.resumeRun({ runId }));
    const seen = await play(server, run, policy);
    return { ...(await theScore(server, run)), problem, stopped: stopped.state, after: seen["worker-0"].map((r) => r.index) };
  },

  async problems(server, url) {
    const unknown = { benchmark_id: "no_such", policy: { name: "interop" } };
    const unauthenticated = new Server(url, "not-a-token");
    const run = await submit(server, ["count"]);
    const turn = await attach(server, run, "worker-0");
    return {
      problems: [
        await problemOf(() => server.once(() => server.control.submitRun({ submitRun: unknown }))),
        await problemOf(() => server.once(() => server.control.getRun({ runId: "no_such" }))),
        await problemOf(() => unauthenticated.once(() => unauthenticated.control.listRuns())),
        await problemOf(() => predict(server, run, turn, [act(0, { vector: [1] })])),
        await problemOf(() => predict(server, run, turn, [act(0)], undefined, 7)),
      ],
    };
  },

  /** Every run that is listed is answered by what is no run. */
  async wrong_answers(server) {
    const errors: Seen = {};
    for (const { run_id: runId } of (await server.ask(() => server.control.listRuns())).runs) {
      errors[runId] = await server.control.getRun({ runId }).then(() => "accepted", (error) => {
        if (error instanceof api.InvalidAnswer) return "bad_answer";
        throw error;
      });
    }
    return { errors };
  },

  async later_version(server) {
    const service = await server.ask(() => server.control.describeService());
    const benchmark = await server.ask(() => server.control.getBenchmark({ benchmarkId: "calibration" }));
    const vector = benchmark.action_space["vector"];
    const run = await submit(server, ["echo"]);
    const seen = (await attach(server, run, "worker-0")).observation!;
    return {
      profiles: service.profiles, image_codecs: service.image_codecs, success_rule: benchmark.success_rule,
      rotation: vector.parts?.["all"]?.rotation, out_of_range: vector.out_of_range, mode: run.mode, policy: run.policy.name,
      codec: seen.images["pattern"].codec, dtype: seen.tensors["float64"].dtype,
      problem: await problemOf(() => server.once(() => server.control.getRun({ runId: "no_such" }))),
    };
  },

  async score(server) {
    const run = await submit(server, repeat(5, "score"), 2), runId = run.run_id;
    await play(server, run, byIndex([1, 0.5, 0.25, 0, 0.25]));
    const score = await server.ask(() => server.control.getScore({ runId }));
    const episodes: api.Episode[] = [];
    let pages = 0;
    for (let cursor: string | undefined; cursor || !pages; pages++) {
      const page = await server.ask(() => server.control.listEpisodes({ runId, cursor, limit: 2 }));
      episodes.push(...page.episodes);
      cursor = page.next_cursor ?? undefined;
    }
    const splits = Object.entries(score.by_split).map(([name, group]) => [name, group.mean]);
    return {
      run_id: runId, score: score.score, success_rate: score.success_rate,
      interval: [score.success_interval.low, score.success_interval.high], success: score.counts.success,
      splits: Object.fromEntries(splits), pages,
      episodes: episodes.map((e) => [e.index, e.result!.score, e.result!.seed]),
    };
  },
};

/** Each golden vector read by the client and written again. */
function vectors(directory: string): Seen {
  const seen: Seen = {};
  for (const file of readdirSync(directory).filter((name) => name.endsWith(".json"))) {
    for (const { id, schema, json, refused } of JSON.parse(readFileSync(join(directory, file), "utf8")).vectors) {
      if (refused) continue; // for servers
      try {
        seen[id] = JSON.stringify(api.read(schema, json));
      } catch (error) {
        if (!(error instanceof api.InvalidAnswer)) throw error;
        seen[id] = "refused";
      }
    }
  }
  return seen;
}

async function main(scenario: string, url: string, token: string): Promise<void> {
  const seen = scenario === "vectors" ? vectors(url) : await scenarios[scenario](new Server(url, token), url);
  console.log(JSON.stringify(seen));
}

main(process.argv[2], process.argv[3], process.argv[4]).catch((error) => {
  console.error(error);
  process.exit(1);
});
