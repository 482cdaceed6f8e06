// A Proctor server without dependencies: the benchmark `calibration`, JSON only. Start: node server.js
import { createHash } from 'node:crypto';
import { once } from 'node:events';
import { createServer } from 'node:http';
import { RunRegistry } from './registry.js';
import { describe } from './calibration.js';
import { listener, notHttp, page, parameter, readTokens } from './http.js';
import { write } from './json.js';
import { Problem, invalid } from './problems.js';
import { attach, detach, heartbeat, predict } from './sessions.js';
import { AttachWorker, Heartbeat, LIMITS, Predict, StopRun, SubmitRun } from './shapes.js';

const { PROCTOR_HOST: host = '127.0.0.1', PROCTOR_PORT: port = '8460', PROCTOR_DATABASE, PROCTOR_TOKENS } = process.env;
if (!PROCTOR_TOKENS) {
  console.error('Set PROCTOR_TOKENS to account:scopes:token, comma-separated, scopes being read, run or read+run.');
  process.exit(2);
}
const registry = new RunRegistry(PROCTOR_DATABASE);

function view(run, { headers }) {
  return { ...run.view(), endpoint: `http://${headers.host ?? `${host}:${port}`}`, queue_position: registry.queuePosition(run) };
}
const runOf = ({ account, params }) => registry.find(account, params.run_id);
const runView = (act) => (context) => {
  const run = runOf(context);
  act(run, context);
  return { body: view(run, context) };
};

/** A data-plane operation; the run comes first, so that a run of another account is not found whatever else is wrong. */
const forWorker = (act) => async (context) => {
  const run = runOf(context);
  const { worker_id } = context.params;
  if (!/^[A-Za-z0-9_-]{1,64}$/.test(worker_id)) throw invalid(['path:worker_id', 'breaks its pattern']);
  return { body: await act(run, worker_id, context) };
};

async function getRun(context) {
  const { headers } = context;
  const run = runOf(context);
  if (headers['if-none-match']?.length > 200) throw invalid(['header:If-None-Match', 'is longer than 200 characters']);
  let known = headers['if-none-match']?.split(',').map((tag) => tag.trim().replace(/^W\//, '')) ?? [];
  const [, wait] = /^wait=([0-9]{1,4})$/.exec(headers.prefer ?? 'wait=0') ?? [];
  if (wait === undefined) throw invalid(['header:Prefer', 'is wait=N']);
  const signal = AbortSignal.timeout(Math.min(Number(wait), LIMITS.wait_s_max) * 1000 + 1);
  for (;;) {
    const body = view(run, context);
    const ETag = `"${createHash('sha256').update(write(body)).digest('base64url')}"`;
    if (known.includes('*')) known = [ETag]; // it names the run as it was when the request came
    if (!known.includes(ETag)) return { body, headers: { ETag } };
    if (Number(wait) === 0 || signal.aborted) return { status: 304, headers: { ETag } };
    await once(registry.changes, 'change', { signal }).catch(() => {});
  }
}

function submit(context) {
  const key = context.headers['idempotency-key'];
  if (key !== undefined && !/^[\x21-\x7e]{1,128}$/.test(key)) throw invalid(['header:Idempotency-Key', 'breaks its pattern']);
  const run = registry.submit(context.account, key, context.body);
  return { status: 201, headers: { Location: `/v1/runs/${run.record.run_id}` }, body: view(run, context) };
}

function listRuns(context) {
  const mine = [...registry.runs.values()].filter((run) => run.record.account === context.account).reverse();
  const { shown, next_cursor } = page(mine, context.query, (run) => run.record.number);
  return { body: { runs: shown.map((run) => view(run, context)), next_cursor } };
}

function listEpisodes(context) {
  const { shown, next_cursor } = page(runOf(context).episodes, context.query, ({ index }) => index);
  const episodes = shown.map(({ episode_id, index, task, split, status, attempt, faults, result }) => (
    { episode_id, index, task, split, status, attempt, faults, result }));
  return { body: { episodes, next_cursor } };
}

const PROFILES = ['core', 'sessions', 'control', 'faults', 'accounts', 'submit_once', 'lists', 'waiting', 'observations',
  'conventions', 'strict_http'];

function service() {
  return {
    name: 'Proctor example in JavaScript', version: '1.0.0', protocol: { min: '1.0', max: '1.0' }, profiles: PROFILES,
    limits: LIMITS, encodings: ['application/json'], image_codecs: ['raw'], server_time: new Date().toISOString(),
  };
}

function benchmark({ params }) {
  if (params.benchmark_id !== 'calibration') throw new Problem('not_found');
  return { body: describe() };
}

function benchmarks() {
  const { benchmark_id, version, title, manifest_sha256, episodes_total } = describe();
  return { body: { benchmarks: [{ benchmark_id, version, title, manifest_sha256, episodes_total }] } };
}

const detachWorker = forWorker((run, worker, { query }) => {
  detach(run, worker, parameter(query, 'session_id', /^.{1,128}$/s));
});

const routes = [
  { path: '/v1', GET: { does: () => ({ body: service() }), open: true } },
  { path: '/v1/benchmarks', GET: { does: benchmarks } },
  { path: '/v1/benchmarks/:benchmark_id', GET: { does: benchmark } },
  { path: '/v1/runs', GET: { does: listRuns }, POST: { does: submit, shape: SubmitRun } },
  { path: '/v1/runs/:run_id', GET: { does: getRun } },
  { path: '/v1/runs/:run_id/stop', POST: { does: runView((run, { body }) => run.stop(body.mode ?? 'abort')), shape: StopRun } },
  { path: '/v1/runs/:run_id/resume', POST: { does: runView((run) => run.resume()) } },
  { path: '/v1/runs/:run_id/episodes', GET: { does: listEpisodes } },
  { path: '/v1/runs/:run_id/score', GET: { does: (context) => ({ body: runOf(context).score() }) } },
  {
    path: '/v1/runs/:run_id/workers/:worker_id',
    PUT: { does: forWorker((run, worker, { body }) => attach(run, worker, body)), shape: AttachWorker },
    DELETE: { does: async (context) => { await detachWorker(context); return { status: 204 }; }, silent: true },
  },
  {
    path: '/v1/runs/:run_id/workers/:worker_id/predict',
    POST: { does: forWorker((run, worker, { body }) => predict(run, worker, body)), shape: Predict },
  },
  {
    path: '/v1/runs/:run_id/workers/:worker_id/heartbeat',
    POST: { does: forWorker((run, worker, { body }) => heartbeat(run, worker, body)), shape: Heartbeat },
  },
];

const server = createServer({ keepAliveTimeout: 75_000 }, listener(routes, readTokens(PROCTOR_TOKENS)));
server.on('clientError', (_, socket) => socket.writable && socket.end(notHttp()));
server.listen(Number(port), host, () => console.log(`Proctor example on http://${host}:${server.address().port}`));
