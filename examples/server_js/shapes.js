// The request schemas of spec/openapi.yaml, and the small part of JSON Schema that they need.
import { invalid } from './problems.js';

export const LIMITS = {
  max_body_bytes: 4194304, max_workers: 8, max_chunk: 32, idle_timeout_s_min: 1, idle_timeout_s_max: 120, wait_s_max: 20,
};

const text = (min, max, pattern) => ({ type: 'string', min, max, pattern });
const number = (min, max) => ({ type: 'number', min, max });
const whole = (min, max) => ({ type: 'integer', min, max });
const list = (items, min, max) => ({ type: 'array', items, min, max });
const object = (properties, required = []) => ({ type: 'object', properties, required });
const map = (values, max = 64) => ({ type: 'object', values, max });
const choice = (...options) => ({ type: 'string', options });
const truth = { type: 'boolean' };

const name = text(0, 64, /^[a-z][a-z0-9_]{0,63}$/);
const conventions = {
  quantity: name, unit: text(0, 64), scale: number(), frame: text(0, 64), rotation: name, relative_to: name,
  gripper_open: number(), gripper_closed: number(),
};
const part = object({ start: whole(0, 2 ** 31 - 1), size: whole(1, 2 ** 31 - 1), ...conventions });
const assumption = object({ size: whole(1, 2 ** 31 - 1), ...conventions, parts: map(part, 256) });

export const SubmitRun = object({
  benchmark_id: text(1, 64, /^[a-z][a-z0-9_]{0,63}$/),
  policy: object({ name: text(1, 200), version: text(0, 200), submitter: text(0, 200), homepage: text(0, 500, /^https?:\/\/[!-~]+$/) }, ['name']),
  max_workers: whole(1, 1024),
  idle_timeout_s: number(1, 86400),
  images: object(
    { codec: choice('raw', 'png', 'jpeg'), width: whole(1, 4096), height: whole(1, 4096) },
    ['codec', 'width', 'height'],
  ),
  options: object({
    tasks: list(choice('score', 'count', 'echo', 'delay', 'fault'), 1, 1000),
    max_steps: whole(1, 10000),
    success_rule: choice('any_step', 'last_step'),
    max_attempts: whole(1, 10),
    max_faults: whole(1, 10),
    queue_s: number(0, 10),
  }),
}, ['benchmark_id', 'policy']);
export const StopRun = object({ mode: choice('abort', 'drain') });
export const AttachWorker = object({
  attach_key: text(1, 128),
  takeover: truth,
  assumes: object({ control_rate_hz: number(0), action: map(assumption), state: map(assumption) }),
}, ['attach_key']);
export const Predict = object({
  session_id: text(1, 128),
  seq: whole(1, Number.MAX_SAFE_INTEGER),
  actions: list(object({ values: map(list(number(), 0, 4096)) }, ['values']), 1),
  observe: choice('last', 'all'),
}, ['session_id', 'seq', 'actions']);
export const Heartbeat = object({ session_id: text(1, 128) }, ['session_id']);

const IS = {
  string: (value) => typeof value === 'string',
  number: (value) => Number.isFinite(value), // 1e999 reads as infinity
  integer: (value) => Number.isInteger(value),
  boolean: (value) => typeof value === 'boolean',
  array: Array.isArray,
  object: (value) => value !== null && typeof value === 'object' && !Array.isArray(value),
};

const step = (name) => `/${String(name).replaceAll('~', '~0').replaceAll('/', '~1')}`;

/** What `min` and `max` count: characters, elements, members, or the number itself. */
function extent(shape, value) {
  if (shape.type === 'string') return [...value].length;
  if (shape.type === 'array') return value.length;
  return shape.type === 'object' ? Object.keys(value).length : value;
}

function* faults(shape, value, pointer) {
  if (!IS[shape.type](value)) {
    yield [pointer, `must be of type ${shape.type}`];
    return;
  }
  const size = extent(shape, value);
  if (size < shape.min || size > shape.max) yield [pointer, `must lie between ${shape.min} and ${shape.max ?? 'any'}`];
  if (shape.pattern && !shape.pattern.test(value)) yield [pointer, `must match ${shape.pattern}`];
  if (shape.options && !shape.options.includes(value)) yield [pointer, `must be one of ${shape.options.join(', ')}`];
  if (shape.items) for (const [index, item] of value.entries()) yield* faults(shape.items, item, pointer + step(index));
  if (shape.type !== 'object') return;
  for (const name of shape.required ?? []) {
    if (!Object.hasOwn(value, name)) yield [pointer + step(name), 'is required'];
  }
  for (const [name, member] of Object.entries(value)) {
    const known = shape.values ?? (Object.hasOwn(shape.properties, name) ? shape.properties[name] : null);
    if (known) yield* faults(known, member, pointer + step(name));
    else yield [pointer + step(name), 'is not known here'];
  }
}

/** Refuse a body that breaks its schema; ten faults are enough to see what is wrong. */
export function check(shape, value) {
  const found = [];
  for (const fault of faults(shape, value, '')) if (found.push(fault) === 10) break;
  if (found.length) throw invalid(...found);
}
