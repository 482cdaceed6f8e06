/* The exceptions of this package; every message says what happened and what to do.
 *
 * A refusal of the server and an error found here have the same class, with the members of
 * the specification's schema Problem. Nothing is sent from here.
 */

import { FetchError, InvalidAnswer, ResponseError, isOfProctor, isPage, mayPass, type Problem, type Run } from "../../../generated_clients/typescript/src";

/* What acts in a terminal, but for tab and line feed: control sequences, marks of direction. */
const UNPRINTABLE = /[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]/g;

/* What helps in this package, beside the words of the server. */
const HINTS: Record<string, string> = {
  unauthenticated: "In this package: the option `token`.",
  worker_busy: "In this package: `takeover: true`.",
  session_superseded: "In this package: `takeover: true` with the run's `runId`.",
};

export interface ErrorMembers {
  retryable?: boolean;
  sideEffects?: "none" | "possible";
  status?: number;
  problem?: Problem;
  retryAfterS?: number;
  mayPass?: boolean;
  cause?: unknown;
}

/** A request was refused, could not be sent, or would be refused if it were sent. */
export class ProctorError extends Error {
  /** One of the specification's codes, or `unreachable`, `bad_answer`, `run_failed`, `run_stopped`. */
  readonly code: string;
  /** What happened and what to do about it. */
  readonly detail: string;
  /** Whether the same request can succeed later. */
  readonly retryable: boolean;
  /** `possible` when the request may have been carried out. */
  readonly sideEffects: "none" | "possible";
  /** The HTTP status, if there was an answer. */
  readonly status?: number;
  /** The server's problem document, if it sent one. */
  readonly problem?: Problem;
  /** The server's Retry-After, seconds. */
  readonly retryAfterS?: number;
  /** Whether something in the place of a server that has answered before may soon be gone, as a sign-in page. */
  readonly mayPass: boolean;

  constructor(code: string, detail: string, members: ErrorMembers = {}) {
    const errors = (members.problem?.errors ?? []).map((item) => `\n  ${item.pointer}: ${item.detail}`);
    super(printable(`${detail} [${code}]${errors.join("")}`), { cause: members.cause });
    this.name = new.target.name;
    this.code = printable(code);
    this.detail = printable(detail);
    this.retryable = members.retryable ?? false;
    this.sideEffects = members.sideEffects ?? "none";
    this.status = members.status;
    this.problem = members.problem;
    this.retryAfterS = members.retryAfterS;
    this.mayPass = members.mayPass ?? false;
  }
}

/** The run is `failed`; `run.reason` says why. `retryable`: whether `runId` may resume it. */
export class RunFailed extends ProctorError {
  constructor(readonly run: Run) {
    const cure = run.retryable ? `Scored episodes are kept; ${howToResume(run.run_id)}.` : "It cannot be resumed.";
    super("run_failed", `Run ${run.run_id} failed: ${run.reason} ${cure}`, { retryable: run.retryable ?? false });
  }
}

/** The run was stopped during the evaluation. */
export class RunStopped extends ProctorError {
  constructor(readonly run: Run) {
    const cure = `Scored episodes are kept; ${howToResume(run.run_id)}.`;
    super("run_stopped", `Run ${run.run_id} is stopped: ${run.reason} ${cure}`, { retryable: true });
  }
}

export function howToResume(runId: string): string {
  return `evaluate({ ..., runId: "${runId}" }) continues it`;
}

/** The ProctorError for what a request to `url` threw; anything else is thrown again.
 *
 * controlUrl: that of the server that named `url` as the endpoint of a run.
 */
export async function fromFailure(failure: unknown, url: string, controlUrl?: string): Promise<ProctorError> {
  const error = await withoutEndpoint(failure, url);
  const isMisled = ["unreachable", "bad_answer", "not_found"].includes(error.code);
  if (!isMisled || controlUrl === undefined || controlUrl === url) return error;
  const detail =
    `${error.detail} ${url} is the endpoint of the run, which ${controlUrl} has named. If clients reach the ` +
    "server elsewhere, its operator sets --public-url.";
  return new ProctorError(error.code, detail, error);
}

async function withoutEndpoint(failure: unknown, url: string): Promise<ProctorError> {
  if (failure instanceof ResponseError) return fromAnswer(failure, url);
  if (failure instanceof FetchError) {
    const detail = `${url} is unreachable (${failure.reason}). Check the URL, and that the server runs.`;
    return new ProctorError("unreachable", detail, { retryable: true, sideEffects: "possible", cause: failure });
  }
  if (failure instanceof InvalidAnswer || failure instanceof TypeError) return invalidAnswer(failure, url);
  throw failure;
}

/** A success whose body is not the message: of the server, or of something else. */
function invalidAnswer(failure: InvalidAnswer | TypeError, url: string): ProctorError {
  const { method, response } = failure instanceof InvalidAnswer ? failure : {};
  const isFromElsewhere = response !== undefined && !isOfProctor(response.headers);
  const what = isFromElsewhere && isPage(response.headers) ? `a page, ${response.headers.get("Content-Type")}` : failure.message;
  const cure = isFromElsewhere
    ? ". A network that wants a sign-in answers so, too: open any page of the web in a browser on this machine."
    : "; if it is, report this to its operator.";
  const safe = " The request may have been carried out; to repeat it as it was is safe.";
  const detail =
    `${url} sent an invalid response (${what}). ` +
    `Check that the URL is that of a Proctor server${cure}${method === "GET" ? "" : safe}`;
  const sideEffects = method === "GET" ? "none" : "possible";
  return new ProctorError("bad_answer", detail, { sideEffects, mayPass: response && mayPass(response, true), cause: failure });
}

async function fromAnswer({ response, hint: move }: ResponseError, url: string): Promise<ProctorError> {
  const body: unknown = await response.json().catch(() => null);
  const { status } = response;
  const wait = response.headers.get("Retry-After") ?? "";
  const retryAfterS = /^\d+$/.test(wait) ? Number(wait) : undefined; // a date is ignored
  if (!isProblem(body)) {
    // Sent by a gateway in front of the server, not by the server itself.
    const what = isPage(response.headers) ? "with a page, text/html" : "without a problem document";
    const cure = [502, 503, 504].includes(status)
      ? "A proxy before a server answers so while it reaches none. If this lasts, check the URL, and ask its operator."
      : "Check that the URL is that of a Proctor server.";
    const detail = `${url} answered ${status} ${what}. ${move ?? cure}`;
    return new ProctorError("bad_answer", detail, {
      retryable: mayPass(response, false), mayPass: mayPass(response, true), sideEffects: "possible", status, retryAfterS,
    });
  }
  const hint = move ?? HINTS[body.code];
  return new ProctorError(body.code, hint ? `${body.detail} ${hint}` : body.detail, {
    retryable: body.retryable, sideEffects: body.side_effects, status, problem: body, retryAfterS,
  });
}

function isProblem(body: unknown): body is Problem {
  if (typeof body !== "object" || body === null) return false;
  const { code, detail, retryable } = body as Problem;
  return typeof code === "string" && typeof detail === "string" && typeof retryable === "boolean";
}

/** The text with an escape, such as \x1b, for each character that acts in a terminal. */
function printable(text: string): string {
  return text.replace(UNPRINTABLE, (found) => `\\u${found.charCodeAt(0).toString(16).padStart(4, "0")}`);
}
