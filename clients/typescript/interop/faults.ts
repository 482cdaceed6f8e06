/* What this package does at a server that is silent or sends what it should not: one JSON line.
 *
 * The servers are made here. tests/interop/test_interop.py judges.
 */

import { createServer, type IncomingMessage, type ServerResponse } from "node:http";
import type { AddressInfo } from "node:net";
import { ProctorError, Server, Session, decodeObservation, evaluate, protocol, type Actions, type EvaluateOptions } from "../src";
import { ActionLayout, chunkOf } from "../src/actions";
import { SilenceMeter, describe } from "../src/silence";

type Answer = (request: IncomingMessage, response: ServerResponse) => void;

const LEASE_S = 3.1; // a third of it is no whole number of milliseconds
const NOW = "2026-03-01T12:00:00Z";
const LEASE = { expires_at: NOW, idle_timeout_s: LEASE_S };
const RUN = {
  run_id: "r", state: "completed", reason: null, retryable: null, benchmark_id: "b", benchmark_version: "1",
  manifest_sha256: "0", policy: { name: "p" }, max_workers: 8, idle_timeout_s: LEASE_S,
  images: { codec: "raw", width: 1, height: 1 }, endpoint: "", queue_position: null, live_workers: 0,
  progress: { episodes_total: 1, episodes_scored: 1, episodes_in_progress: 0, episodes_pending: 0 },
  created_at: NOW, updated_at: NOW,
};
const TURN = {
  session_id: "s", seq: 0, executed_steps: 0, stopped_early: false, rewards: [], terminated: false, truncated: false,
  done: false, lease: LEASE, timing: { total_s: 0, queue_s: 0, simulate_s: 0, render_s: 0, encode_s: 0 },
  episode: { episode_id: "e", index: 0, task: "t", instruction: "", attempt: 1, step: 0, max_steps: 1 },
};
const LIMITS = { max_body_bytes: 1, max_workers: 8, max_chunk: 1, idle_timeout_s_min: 1, idle_timeout_s_max: 9, wait_s_max: 1 };
const SERVICE = {
  name: "n", version: "1", protocol: { min: "1.0", max: "1.0" }, profiles: [], limits: LIMITS, encodings: [],
  image_codecs: [], server_time: NOW,
};
const IMAGE = { codec: "jpeg", height: 1, width: 1, channels: 3 };
const silent: Answer = () => {};

const json = (response: ServerResponse, body: unknown) => void response.setHeader("Content-Type", "application/json").end(JSON.stringify(body));
const sleep = (ms: number) => new Promise((done) => setTimeout(done, ms));

async function at(answer: Answer, retryTimeoutS = 10, signal?: AbortSignal): Promise<Server> {
  const server = createServer(answer);
  await new Promise<void>((done) => server.listen(0, "127.0.0.1", done));
  return new Server(`http://127.0.0.1:${(server.address() as AddressInfo).port}`, "token", { retryTimeoutS, signal });
}

/** A session whose attach is answered; `rest` answers all that follows. */
function attach(rest: Answer): Promise<Session> {
  const answer: Answer = (request, response) => (request.method === "PUT" ? json(response, TURN) : rest(request, response));
  return at(answer).then((server) => Session.attach(server, { ...RUN, endpoint: server.retryPolicy.url } as unknown as protocol.Run, "w"));
}

/** How an action ended, in how many seconds. */
async function ending(action: () => unknown): Promise<{ error: string; seconds: number }> {
  const started = performance.now();
  let error = "none";
  try {
    await action();
  } catch (failure) {
    error = failure instanceof ProctorError ? failure.code : String((failure as Error).name ?? failure);
  }
  return { error, seconds: (performance.now() - started) / 1000 };
}

async function heartbeats(): Promise<number> {
  let count = 0;
  const session = await attach((_, response) => {
    count += 1;
    json(response, LEASE);
  });
  await session.whileAlive(() => sleep(1500));
  return count;
}

/** A heartbeat that cannot be sent for a reason of this program's. */
async function own_mistake() {
  const session = await attach(silent);
  return ending(() => session.whileAlive(async () => {
    (session as unknown as { address: unknown }).address = { runId: "r", workerId: "\ud800" }; // no URL
    await sleep(1500);
  }));
}

async function workers(): Promise<{ errors: string[]; requests: number }> {
  let requests = 0;
  const { url } = (await at((_, response) => {
    requests += 1;
    json(response, SERVICE);
  })).retryPolicy;
  const errors: string[] = [];
  for (const count of [0, -1, NaN, 2.5]) {
    const given = { url, token: "t", policy: () => { throw new RangeError("a policy"); }, runId: "r", workers: count, retryTimeoutS: 1 };
    errors.push((await ending(() => evaluate(given))).error);
  }
  return { errors, requests };
}

/** The states of a run whose first answer breaks off in its body. */
async function lost_body(): Promise<string[]> {
  let requests = 0;
  const server = await at((_, response) => {
    requests += 1;
    if (requests > 1) return json(response, RUN);
    response.writeHead(200, { "Content-Type": "application/json", "Content-Length": 1000 }).write("{");
    setTimeout(() => response.destroy(), 50);
  });
  for await (const run of server.changes("r")) return [run.state];
  return [];
}

/** A turn whose first request is lost on a connection that is dead without a sign of it. */
async function dead_connection() {
  const sockets = new Set<unknown>();
  const server = await at((request, response) => {
    sockets.add(request.socket);
    if (request.method === "PUT") return json(response, TURN);
    if (sockets.size > 1) json(response, { ...TURN, seq: 1, executed_steps: 1, rewards: [0], done: true });
  }, 60);
  const session = await Session.attach(server, { ...RUN, endpoint: server.retryPolicy.url } as unknown as protocol.Run, "w");
  return { ...(await ending(() => session.predict([{ values: {} }]))), connections: sockets.size };
}

/** What is said of a page of a gateway that refuses. */
async function gateway(): Promise<string> {
  const server = await at((_, response) => void response.writeHead(405, { "Content-Type": "text/html" }).end("<html>"));
  return server.run("r").then(() => "", (error) => error.message);
}

async function html() {
  const server = await at((_, response) => void response.setHeader("Content-Type", "text/html").end("<html>"));
  return ending(() => server.changes("r").next());
}

async function interrupted() {
  const stop = new AbortController();
  const server = await at(silent, 10, stop.signal);
  setTimeout(() => stop.abort(new RangeError("enough")), 300);
  return ending(() => server.run("r"));
}

async function leave() {
  const session = await attach(silent);
  return ending(() => session.leave());
}

/** The requests that leave an episode for a reason, and the longest text of one. */
async function reason() {
  const requests: string[] = [];
  const session = await attach(async (request, response) => {
    let body = "";
    for await (const part of request) body += part;
    requests.push(`${request.method} ${body}`);
    if (request.method === "DELETE") response.writeHead(204).end();
    else json(response, LEASE);
  });
  const server = await at(silent);
  await session.leave(server.withoutSecrets("http://me:pw@host\n\ud800refused token"));
  return { requests, longest: server.withoutSecrets("\u{1f916}".repeat(501)) };
}

async function service() {
  const server = await at(silent, 0.01);
  return ending(() => server.service());
}

function base64(): Promise<string[]> {
  const images = (data: string) => ({ front: { ...IMAGE, data } });
  const texts = ["AAAA", "AAA=", "AA==", "", "AA*A", "AA\nA", "AAAA*", "AA=A", "A"];
  return Promise.all(texts.map(async (data) => (await ending(() => decodeObservation({ state: {}, images: images(data), tensors: {} }))).error));
}

/** Tensors of one byte, of none, and with sizes that are not theirs. */
function shapes(): Promise<string[]> {
  const given: [string, number[]][] = [["AA==", [1]], ["AA==", []], ["", [0, 5]], ["AA==", [2]], ["AA==", [-1, -1]], ["", [-1]]];
  return Promise.all(given.map(async ([data, shape]) =>
    (await ending(() => decodeObservation({ state: {}, images: {}, tensors: { t: { dtype: "uint8", shape, data } } }))).error));
}

/** Actions of a benchmark with a vector that some tasks alone have. */
function optional_vector(): Promise<string[]> {
  const action_space = { arm: { size: 2 }, base: { size: 1, tasks: ["drive"] } };
  const layout = new ActionLayout({ benchmark_id: "b", action_space } as unknown as protocol.Benchmark);
  const given: Actions[] = [
    { arm: [1, 2] }, { arm: [1, 2], base: [3] },
    { arm: [1] }, { arm: [1, 2], base: [3, 4] }, { base: [3] }, { arm: [1, 2], leg: [1] }, [1, 2, 3],
  ];
  return Promise.all(given.map(async (actions) => (await ending(() => chunkOf(actions, layout))).error));
}

/** The cause of a silence on clocks that a step moves: [awake, suspended] seconds, or what happened. */
function causes(): Promise<string[]> {
  const given: (string | [number, number])[][] = [
    [[5, 0]],
    [[1, 0], "failed", [4, 0]],
    [[1, 0], "failed", "answered", [4, 0]],
    [[0.5, 0], "sent", [4, 0]],
    [[4, 0], "sent", [0.1, 0]],
    [[0.5, 60], "sent", [0.1, 0]],
    [[1, 0], "beat", [4, 0]],
  ];
  return Promise.all(given.map(async (steps) => {
    let awake = 100, wall = 100;
    const meter = new SilenceMeter(() => awake, () => wall);
    for (const step of steps) {
      if (typeof step !== "string") [awake, wall] = [awake + step[0], wall + step[0] + step[1]];
      else if (step === "sent") meter.sent();
      else if (step === "answered") meter.answered();
      else if (step === "failed") meter.heartbeat(1).failed();
      else meter.heartbeat(1).answered();
    }
    const { silentS, cause } = meter.silence(3);
    return `${silentS.toFixed(1)} ${cause}`;
  }));
}

/** What is said of a session that a busy thread has lost; null: it ended for another reason. */
async function lost(): Promise<(string | null)[]> {
  return Promise.all(["lease_ended", "run_stopped"].map(async (ended_by) => {
    const problem = { code: "session_ended", detail: "d", retryable: false, side_effects: "none", ended_by };
    const session = await attach((_, response) => {
      response.statusCode = 409;
      json(response, problem);
    });
    const failure = await session.predict([]).catch((error: unknown) => error);
    const seen = session.lost(failure);
    return seen && describe(seen);
  }));
}

/** What is no function that makes a policy, and what it returns. */
async function policies(): Promise<string[]> {
  class Mine { act() { return {}; } }
  const given: unknown[] = [new Mine(), Mine];
  const url = "http://127.0.0.1:9";
  return Promise.all(given.map(async (policy) => (await ending(() => evaluate({ url, token: "t", policy } as EvaluateOptions))).error));
}

const faults = { causes, lost, policies, heartbeats, own_mistake, workers, lost_body, dead_connection, gateway, html, interrupted, leave, reason, service, base64, shapes, optional_vector };

async function main(): Promise<void> {
  const seen = await Promise.all(Object.entries(faults).map(async ([name, play]) => [name, await play().catch(String)] as const));
  console.log(JSON.stringify(Object.fromEntries(seen)));
}

// The servers hold connections that would keep the program alive.
main().then(() => process.exit(0), (error) => {
  console.error(error);
  process.exit(1);
});
