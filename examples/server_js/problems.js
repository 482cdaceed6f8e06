// The refusals of a Core server: a part of `x-problems` in openapi.yaml.

// code: [status, retryable, title, what to do]
const PROBLEMS = {
  malformed_body: [400, false, 'The body cannot be parsed', 'Send one well-formed JSON document.'],
  unsupported_version: [400, false, 'Unknown protocol version', 'Use one that describe_service announces.'],
  unauthenticated: [401, false, 'No valid bearer token', 'Send `Authorization: Bearer <token>`.'],
  not_found: [404, false, 'There is nothing here for this account', 'Check the id and the path.'],
  method_not_allowed: [405, false, 'Method not allowed', 'Use a method of the Allow header.'],
  illegal_transition: [409, false, 'Not possible in this state', 'Read `state`.'],
  worker_busy: [409, true, 'The worker has a live session', 'Repeat its attach_key, or use another worker.'],
  session_ended: [409, false, 'The session is not live any more', 'Scored episodes are kept.'],
  seq_conflict: [409, false, 'Another body under the same seq', 'Repeat the first body, or send the next seq.'],
  seq_out_of_order: [409, false, 'Not the expected seq', 'Send `expected_seq`.'],
  no_episode: [409, false, 'No episode is left', 'Read the score.'],
  body_too_large: [413, false, 'The body is too large', 'Stay below max_body_bytes.'],
  unsupported_media_type: [415, false, 'Unknown media type', 'Send application/json.'],
  invalid_request: [422, false, 'The request breaks its schema or a space', 'Correct what `errors` points at.'],
  worker_limit: [429, true, 'All workers of the run are attached', 'Use one of them.'],
  internal_error: [500, true, 'A defect of the server', 'Retry with the same seq or attach_key.'],
};

/** What an operation throws to refuse a request. */
export class Problem extends Error {
  /** members: further fields of the body; headers: of the response. */
  constructor(code, members = {}, headers = {}) {
    super(code);
    const [status, retryable, title, act] = PROBLEMS[code];
    const { detail = title, ...rest } = members;
    const side_effects = code === 'internal_error' ? 'possible' : 'none';
    this.status = status;
    this.headers = status === 429 ? { 'Retry-After': '1', ...headers } : headers;
    this.body = {
      type: `urn:proctor:problem:${code}`, title, status, code, retryable, side_effects,
      detail: `${detail}. ${act}`, ...rest,
    };
  }
}

/** A value that breaks its schema or its space. */
export function invalid(pointer, detail) {
  return new Problem('invalid_request', { errors: [{ pointer, detail }] });
}
