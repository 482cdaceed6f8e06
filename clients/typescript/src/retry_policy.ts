/* The retry policy: the only place that decides whether a request is repeated.
 *
 * Every request may be repeated, because operations that must not be executed twice carry a
 * seq, an attach_key or an Idempotency-Key. So the answer alone decides.
 */

import { ProctorError, fromFailure } from "./errors";
import { reportWait } from "./wait_report";

const FIRST_PAUSE_S = 0.1;
const LONGEST_PAUSE_S = 5;
const REQUEST_TIMEOUT_S = 60;
const DEFECT_S = 10; // a defect of the server seldom disappears by itself
/* For a page in the place of a server that has answered, such as a network's sign-in. */
const PAGE_S = 60;
/* Refusals of a healthy server at its capacity: repeated without a limit of time. */
const FULL = new Set(["worker_limit", "no_capacity"]);

/** What is known of a server: whether it has ever answered as one of Proctor does. */
interface Contact {
  hasAnswered: boolean;
}

/** How long failing requests to `url` are repeated; `signal` ends every wait and request.
 *
 * controlUrl: where `url` is the endpoint of a run, the server that named it.
 */
export class RetryPolicy {
  constructor(
    readonly url: string,
    readonly totalS: number,
    readonly signal: AbortSignal,
    private readonly onWaiting?: (why: string | null) => void,
    private readonly requestS: number = REQUEST_TIMEOUT_S,
    private readonly controlUrl?: string,
    private readonly contact: Contact = { hasAnswered: false },
  ) {}

  /** The result of `send`, which is called until it succeeds.
   *
   * limitsS: code → limit for this refusal. Throws ProctorError for what cannot be repeated or
   * exceeds its limit, and the reason of `signal`.
   */
  async call<T>(send: (init: RequestInit) => Promise<T>, limitsS: Record<string, number> = {}): Promise<T> {
    const onWaiting = this.onWaiting ?? reportWait(this.url);
    let last: ProctorError | null = null;
    let since = now(), pauseS = FIRST_PAUSE_S;
    try {
      for (;;) {
        this.signal.throwIfAborted();
        const [beganAt, isFirst] = [now(), !this.contact.hasAnswered];
        try {
          return await this.once(send);
        } catch (failure) {
          if (!(failure instanceof ProctorError)) throw failure;
          // The silence of who has never answered is a part of its time.
          const isPage = this.isPage(failure);
          const isOther = last?.code !== failure.code || last.retryable !== failure.retryable;
          if (isOther) [since, pauseS] = [isFirst ? beganAt : now(), FIRST_PAUSE_S];
          const waitS = jittered(failure, pauseS);
          const limitS = this.limitS(failure.code, isPage, limitsS);
          const isRetryable = failure.retryable || isPage;
          if (!isRetryable || waitS > since + limitS - now()) throw failure;
          const bound = isPage ? ` This program repeats the request for up to ${limitS} s.` : "";
          if (last?.detail !== failure.detail) onWaiting(failure.detail + bound);
          [last, pauseS] = [failure, Math.min(2 * pauseS, LONGEST_PAUSE_S)];
          await this.pause(waitS);
        }
      }
    } finally {
      if (last !== null || this.onWaiting === undefined) onWaiting(null);
    }
  }

  /** Send one request; what it throws becomes a ProctorError, but for the reason of `signal`. */
  async once<T>(send: (init: RequestInit) => Promise<T>, timeoutS = this.requestS): Promise<T> {
    const { signal } = this;
    signal.throwIfAborted();
    // By hand: AbortSignal.any leaves a reference in `signal` for every request.
    const request = new AbortController();
    const abort = () => request.abort(signal.reason);
    const late = () => request.abort(new DOMException(`no answer in ${timeoutS} s`, "TimeoutError"));
    const timer = setTimeout(late, milliseconds(timeoutS));
    signal.addEventListener("abort", abort, { once: true });
    try {
      const message = await send({ signal: request.signal });
      this.contact.hasAnswered = true;
      return message;
    } catch (failure) {
      signal.throwIfAborted();
      throw await fromFailure(failure, this.url, this.controlUrl);
    } finally {
      clearTimeout(timer);
      signal.removeEventListener("abort", abort);
    }
  }

  /** Wait; throws the reason of `signal` if it is aborted meanwhile. */
  pause(waitS: number): Promise<void> {
    const { signal } = this;
    return new Promise((resolve, reject) => {
      const abort = () => {
        clearTimeout(timer);
        reject(signal.reason);
      };
      const timer = setTimeout(() => {
        signal.removeEventListener("abort", abort);
        resolve();
      }, milliseconds(waitS));
      if (signal.aborted) abort();
      else signal.addEventListener("abort", abort, { once: true });
    });
  }

  /** The same, with other limits or another signal. */
  with(other: {
    totalS?: number; requestS?: number; signal?: AbortSignal; onWaiting?: (why: string | null) => void;
  }): RetryPolicy {
    const { totalS, requestS, signal, onWaiting } = { ...this, ...other };
    return new RetryPolicy(this.url, totalS, signal, onWaiting, requestS, this.controlUrl, this.contact);
  }

  /** The same for requests to the data plane of a run. */
  atEndpoint(endpoint: string): RetryPolicy {
    const { totalS, requestS, signal, onWaiting } = this;
    const url = endpoint.replace(/\/+$/, "");
    // Another address may never have been a server of Proctor.
    const contact = url === this.url ? this.contact : { hasAnswered: false };
    return new RetryPolicy(url, totalS, signal, onWaiting, requestS, this.url, contact);
  }

  /** Whether something in the place of a server that has answered may soon be gone, as a sign-in page. */
  private isPage({ retryable, mayPass }: ProctorError): boolean {
    return mayPass && !retryable && this.contact.hasAnswered;
  }

  private limitS(code: string, isPage: boolean, limitsS: Record<string, number>): number {
    if (code in limitsS) return limitsS[code];
    if (FULL.has(code)) return Infinity;
    if (isPage) return Math.min(PAGE_S, this.totalS);
    return code === "internal_error" ? Math.min(DEFECT_S, this.totalS) : this.totalS;
  }
}

/** What timers take: a whole number of at most 31 bits. */
export const milliseconds = (seconds: number) => Math.min(Math.ceil(1000 * seconds), 2 ** 31 - 1);

const now = () => performance.now() / 1000;

/** With chance, so that workers that failed together do not repeat together. */
function jittered(error: ProctorError, pauseS: number): number {
  if (error.retryAfterS) return error.retryAfterS + FIRST_PAUSE_S * Math.random();
  return pauseS * (0.5 + 0.5 * Math.random());
}
