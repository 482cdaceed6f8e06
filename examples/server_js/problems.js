// The closed list of refusals (x-problems of spec/openapi.yaml) and the one exception that carries them.

// code: [status, retryable, side_effects, title, act]
const PROBLEMS = {
  malformed_body: [400, false, 'none', 'The body cannot be parsed', 'Send one well-formed JSON document without NaN or excessive nesting.'],
  unsupported_version: [400, false, 'none', 'Protocol version not spoken here', 'Use a version inside the range that describe_service announces.'],
  unauthenticated: [401, false, 'none', 'No valid bearer token', 'Send `Authorization: Bearer <token>` with a token of this server.'],
  forbidden: [403, false, 'none', 'The token lacks a scope', 'Use a token that has the scope named in detail.'],
  not_found: [404, false, 'none', 'There is nothing here for this caller', 'Check the id and the path; runs of other accounts are not shown.'],
  method_not_allowed: [405, false, 'none', 'Method not allowed', 'Use a method named in the Allow header.'],
  not_acceptable: [406, false, 'none', 'No acceptable encoding', 'Accept application/json.'],
  illegal_transition: [409, false, 'none', 'Not possible in this state', 'Read `state`; the lifecycle table says what it allows.'],
  idempotency_conflict: [409, false, 'none', 'Idempotency-Key used for another body', 'Use a new key for a new request.'],
  worker_busy: [409, true, 'none', 'The worker has a live session', 'Wait until its lease ends, or attach with `takeover`.'],
  convention_mismatch: [409, false, 'none', 'The policy assumes other conventions', 'Convert as `errors` says, or correct what the policy assumes.'],
  session_superseded: [409, false, 'none', 'Another session has taken this worker over', 'Stop this client, or take over in turn.'],
  session_ended: [409, false, 'none', 'The session is not live any more', 'Attach again with a new attach_key; scored episodes are kept.'],
  seq_conflict: [409, false, 'none', 'The same seq with another body', 'Repeat the body that was sent under this seq, or go on with the next seq.'],
  seq_out_of_order: [409, false, 'none', 'Not the seq that is expected', 'Send `expected_seq`.'],
  no_episode: [409, false, 'none', 'The session is done', 'Detach; attach again if get_run shows pending episodes.'],
  body_too_large: [413, false, 'none', 'The body is too large', 'Stay below max_body_bytes of describe_service.'],
  unsupported_media_type: [415, false, 'none', "The body's media type is not read here", 'Send application/json.'],
  invalid_request: [422, false, 'none', "The request breaks the schema or the benchmark's spaces", 'Correct what `errors` points at.'],
  worker_limit: [429, true, 'none', 'The run has all the live workers it may have', 'Wait for Retry-After, or detach a worker.'],
  internal_error: [500, true, 'possible', 'A defect of the server', 'Retry with the same seq, attach_key or Idempotency-Key.'],
};

export class Problem extends Error {
  /** `members` go into the body (errors, state, expected_seq, ended_by), `headers` onto the answer. */
  constructor(code, members = {}, headers = {}) {
    super(code);
    const [status, retryable, side_effects, title, act] = PROBLEMS[code];
    const { detail = title, ...rest } = members;
    this.status = status;
    this.headers = status === 429 ? { 'Retry-After': '1', ...headers } : headers;
    this.body = {
      type: `urn:proctor:problem:${code}`, title, status, code, retryable, side_effects,
      detail: `${detail}. ${act}`, ...rest,
    };
  }
}

/** A request that breaks a schema or a space; `faults` are [pointer, detail] pairs. */
export function invalid(...faults) {
  const errors = faults.map(([pointer, detail]) => ({ pointer, detail }));
  return new Problem('invalid_request', { errors });
}
