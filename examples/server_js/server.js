// A Proctor Core server without dependencies: the benchmark `calibration`, in JSON, in memory.
// Start it with: PROCTOR_TOKENS=alice:read+run:secret node server.js
import { createServer } from 'node:http';
import { describe, plan } from './calibration.js';
import { listener, readTokens } from './http.js';
import { Problem, invalid } from './problems.js';
import { Run } from './run.js';
import { AttachWorker, LIMITS, Predict, StopRun, SubmitRun } from './shapes.js';

const { PROCTOR_HOST: host = '127.0.0.1', PROCTOR_PORT: port = '8460', PROCTOR_TOKENS } = process.env;
if (!PROCTOR_TOKENS) {
  console.error('Set PROCTOR_TOKENS to account:scopes:token, comma-separated.');
  process.exit(2);
}
const runs = new Map(); // run id → run
function findRun({ account, params }) {
  const run = runs.get(params.run_id);
  if (run?.account !== account) throw new Problem('not_found');
  return run;
}
const view = (run, { headers }) => ({ ...run.view(), endpoint: `http://${headers.host ?? `${host}:${port}`}` });

const describeService = () => ({
  name: 'Proctor Core in JavaScript', version: '1.0.0', protocol: { min: '1.0', max: '1.0' },
  profiles: ['core'], limits: LIMITS, encodings: ['application/json'], image_codecs: ['raw'],
  server_time: new Date().toISOString(),
});

function listBenchmarks() {
  const { benchmark_id, version, title, manifest_sha256, episodes_total } = describe();
  return { benchmarks: [{ benchmark_id, version, title, manifest_sha256, episodes_total }] };
}

function getBenchmark({ params }) {
  if (params.benchmark_id !== 'calibration') throw new Problem('not_found');
  return describe();
}

function submitRun({ account, body }) {
  const { benchmark_id, policy, options, max_workers = LIMITS.max_workers } = body;
  if (benchmark_id !== 'calibration') throw invalid('/benchmark_id', 'is not offered here');
  if (max_workers > LIMITS.max_workers) throw invalid('/max_workers', `is above ${LIMITS.max_workers}`);
  const run = new Run(account, policy, max_workers, plan(options));
  runs.set(run.run_id, run);
  return run;
}

const stopRun = (context) => findRun(context).stop();
const attachWorker = (context) => findRun(context).attach(context.params.worker_id, context.body);
const predict = (context) => findRun(context).predict(context.params.worker_id, context.body);
const show = (act) => (context) => view(act(context), context);

const routes = [
  { method: 'GET', path: '/v1', act: describeService, isOpen: true },
  { method: 'GET', path: '/v1/benchmarks', act: listBenchmarks },
  { method: 'GET', path: '/v1/benchmarks/:benchmark_id', act: getBenchmark },
  { method: 'POST', path: '/v1/runs', act: show(submitRun), shape: SubmitRun, status: 201 },
  { method: 'GET', path: '/v1/runs/:run_id', act: show(findRun) },
  { method: 'GET', path: '/v1/runs/:run_id/score', act: (context) => findRun(context).score() },
  { method: 'POST', path: '/v1/runs/:run_id/stop', act: show(stopRun), shape: StopRun },
  { method: 'PUT', path: '/v1/runs/:run_id/workers/:worker_id', act: attachWorker, shape: AttachWorker },
  { method: 'POST', path: '/v1/runs/:run_id/workers/:worker_id/predict', act: predict, shape: Predict },
];
const server = createServer(listener(routes, readTokens(PROCTOR_TOKENS)));
server.listen(Number(port), host, () => console.log(`Proctor Core on http://${host}:${server.address().port}`));
