// The request schemas of openapi.yaml, without the fields of profiles: those are unknown here.
import { invalid } from './problems.js';

const DAY_S = 86400; // sessions do not end by themselves in Core
export const LIMITS = {
  max_body_bytes: 4194304, max_workers: 8, max_chunk: 32, wait_s_max: 0,
  idle_timeout_s_min: DAY_S, idle_timeout_s_max: DAY_S,
};

const text = (min, max, pattern) => ({ type: 'string', min, max, pattern });
const choice = (...choices) => ({ type: 'string', choices });
const number = (min, max) => ({ type: 'number', min, max });
const integer = (min, max) => ({ type: 'integer', min, max });
const array = (items, min, max) => ({ type: 'array', items, min, max });
const object = (fields, required = []) => ({ type: 'object', fields, required });
const map = (values) => ({ type: 'object', values, required: [], max: 64 });

export const SubmitRun = object({
  benchmark_id: text(1, 64, /^[a-z][a-z0-9_]{0,63}$/),
  policy: object({
    name: text(1, 200), version: text(0, 200), submitter: text(0, 200), homepage: text(0, 500, /^https?:\/\/[!-~]+$/),
  }, ['name']),
  max_workers: integer(1, 1024),
  options: object({
    tasks: array(choice('score', 'count', 'delay'), 1, 1000),
    max_steps: integer(1, 10000),
    success_rule: choice('any_step', 'last_step'),
  }),
}, ['benchmark_id', 'policy']);
export const StopRun = object({ mode: choice('abort') });
export const AttachWorker = object({ attach_key: text(1, 128) }, ['attach_key']);
export const Predict = object({
  session_id: text(1, 128),
  seq: integer(1, Number.MAX_SAFE_INTEGER),
  actions: array(object({ values: map(array(number(), 0, 4096)) }, ['values']), 1, 65536),
}, ['session_id', 'seq', 'actions']);

const IS = {
  string: (value) => typeof value === 'string',
  number: (value) => typeof value === 'number',
  integer: Number.isInteger,
  array: Array.isArray,
  object: (value) => value !== null && typeof value === 'object' && !Array.isArray(value),
};
/** What `min` and `max` count: characters, elements, fields, or the number itself. */
function sizeOf({ type }, value) {
  if (type === 'string') return [...value].length;
  return type === 'array' ? value.length : type === 'object' ? Object.keys(value).length : value;
}

/** A JSON pointer to a field or an element of what `pointer` points at. */
export const below = (pointer, name) => `${pointer}/${`${name}`.replaceAll('~', '~0').replaceAll('/', '~1')}`;

/** Refuse a body that breaks its schema, at its first fault. */
export function check(shape, value, pointer = '') {
  if (!IS[shape.type](value)) throw invalid(pointer, `must be of type ${shape.type}`);
  const size = sizeOf(shape, value);
  if (size < shape.min || size > shape.max) {
    throw invalid(pointer, `must lie between ${shape.min ?? 0} and ${shape.max}`);
  }
  if (shape.pattern && !shape.pattern.test(value)) throw invalid(pointer, `must match ${shape.pattern}`);
  if (shape.choices && !shape.choices.includes(value)) {
    throw invalid(pointer, `must be one of ${shape.choices.join(', ')}`);
  }
  if (shape.type === 'array') value.forEach((item, i) => check(shape.items, item, below(pointer, i)));
  if (shape.type !== 'object') return;
  for (const name of shape.required) {
    if (!Object.hasOwn(value, name)) throw invalid(pointer, `lacks the field ${name}`);
  }
  for (const [name, field] of Object.entries(value)) {
    const isKnown = shape.values || Object.hasOwn(shape.fields, name);
    if (!isKnown) throw invalid(below(pointer, name), 'is not known here');
    check(shape.values ?? shape.fields[name], field, below(pointer, name));
  }
}
