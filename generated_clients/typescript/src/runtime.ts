/*
 * Written by hand, beside what is generated from the specification.
 */

/* The sending of requests and the reading of answers, below the operations of apis/. */

import { cleanBaseUrl, cleanToken } from './settings';
import { InvalidAnswer, read } from './answers';

const REDIRECTS_MAX = 5;
/* A gateway that answers so never lets this request pass. */
const UNPASSABLE = new Set([400, 405, 411, 413, 414, 415, 416, 417, 421, 426, 431, 501, 505]);

export interface ConfigurationParameters {
    /** Base URL of the control plane, or of a run's data plane (`run.endpoint`). */
    basePath?: string;
    /** The bearer token, or a function that returns it for each request. */
    accessToken?: string | Promise<string> | (() => string | Promise<string>);
    /** Sent with every request. */
    headers?: Record<string, string>;
    credentials?: RequestCredentials;
    /** Instead of the global `fetch`; it can change requests and answers. */
    fetchApi?: typeof fetch;
}

export class Configuration {
    readonly basePath: string;
    readonly parameters: ConfigurationParameters;

    /** Throws BadSetting for a base URL or a token that cannot be used. */
    constructor(parameters: ConfigurationParameters = {}) {
        const { accessToken } = parameters;
        this.basePath = cleanBaseUrl(parameters.basePath ?? 'http://127.0.0.1:8460');
        this.parameters = typeof accessToken === 'string' ? { ...parameters, accessToken: cleanToken(accessToken) } : parameters;
    }
}

/** The server refused the request; the body of `response` is a Problem, or what a gateway sent. */
export class ResponseError extends Error {
    override name = 'ResponseError';
    /** hint: what to change, if the base URL may be wrong. */
    constructor(readonly response: Response, url: string, readonly hint?: string) {
        const what = isPage(response.headers) ? ': a page, text/html' : '';
        super(`${url} answered HTTP status ${response.status}${what}. ${hint ?? ''}`.trimEnd());
    }
}

/** Whether an answer may soon be gone that is no message and no problem: the fault of a gateway, or, where a server of
 * Proctor has answered before, a page that is not the server's. */
export function mayPass(response: Response, hasAnswered: boolean): boolean {
    const { status, headers } = response;
    if (UNPASSABLE.has(status) || (status < 300 && !isPage(headers))) return false;
    return status === 429 || status >= 500 || (hasAnswered && !isOfProctor(headers));
}

/** Whether a server of Proctor has sent an answer, by its headers. */
export function isOfProctor(headers: Headers): boolean {
    return headers.has('Proctor-Version') || (headers.get('Content-Type') ?? '').startsWith('application/problem+json');
}

/** Whether an answer is a page in HTML. */
export function isPage(headers: Headers): boolean {
    return /^(text\/html|application\/xhtml\+xml)/i.test(headers.get('Content-Type') ?? '');
}

/** No answer came; `reason` and `cause` say why. What was sent may have had its effect. */
export class FetchError extends Error {
    override name = 'FetchError';
    readonly reason: string;
    constructor(cause: Error, url: string) {
        const reason = innermost(cause) + proxyNote(url);
        super(`no answer from ${url}: ${reason}`, { cause });
        this.reason = reason;
    }
}

/** A parameter that the operation needs was not given. */
export class RequiredError extends Error {
    override name = 'RequiredError';
    constructor(readonly field: string) {
        super(`the parameter ${field} is required`);
    }
}

/** The promise of a message; `withResponse` also gives the HTTP response, for its status and headers. */
export type Answer<Message> = Promise<Message> & {
    withResponse(): Promise<{ message: Message; response: Response }>;
};

type Values = Record<string, string | number | boolean | null | undefined>;

/* Parameters that are undefined or null are not sent. */
export interface RequestParts {
    path?: Values;
    query?: Values;
    headers?: Values;
    /** Sent as JSON, but for a `contentType` of another kind. */
    body?: unknown;
    contentType?: string;
}

/** Whether JSON breaks off whose end is that of the connection. */
function isCut(error: unknown, headers: Headers): boolean {
    const hasLength = headers.has('Content-Length') || headers.has('Transfer-Encoding');
    const isJson = headers.get('Content-Type')?.includes('json') ?? false;
    return error instanceof InvalidAnswer && error.cause instanceof SyntaxError && isJson && !hasLength;
}

export class BaseApi {
    constructor(protected readonly configuration = new Configuration()) {}

    /** Send a request whose success is answered by this message, or by none. */
    protected call<Message>(
        name: string | null, method: string, path: string, parts: RequestParts, init: RequestInit = {},
    ): Answer<Message> {
        const response = this.send(method, path, parts, init);
        const message = response.then(async (answer) => {
            if (name === null) return undefined as Message;
            const text = await answer.text().catch((error) => this.unanswered(error));
            try {
                return read<Message>(name, text);
            } catch (error) {
                if (isCut(error, answer.headers)) this.unanswered(new Error('the connection ended before the answer was whole'));
                throw error instanceof InvalidAnswer ? Object.assign(error, { method, response: answer }) : error;
            }
        });
        const withResponse = async () => ({ message: await message, response: await response });
        return Object.assign(message, { withResponse });
    }

    /** No answer came, or it broke off. */
    private unanswered(error: unknown): never {
        throw error instanceof Error ? new FetchError(error, this.configuration.basePath) : error;
    }

    private async send(method: string, path: string, parts: RequestParts, init: RequestInit): Promise<Response> {
        const needed = 'body' in parts ? { ...parts.path, body: parts.body } : parts.path ?? {};
        for (const [field, value] of Object.entries(needed)) if (value == null) throw new RequiredError(field);
        const { accessToken, credentials, fetchApi = fetch } = this.configuration.parameters;
        const token = cleanToken(await (typeof accessToken === 'function' ? accessToken() : accessToken) ?? '');
        const filled = path.replace(/\{(\w+)\}/g, (_, field) => encodeURIComponent(String(parts.path![field])));
        const query = given(parts.query).map(([field, value]) => `${field}=${encodeURIComponent(value)}`).join('&');
        const headers = new Headers({ Accept: 'application/json, application/problem+json', ...this.configuration.parameters.headers });
        if (token) headers.set('Authorization', `Bearer ${token}`);
        if (parts.body != null) headers.set('Content-Type', parts.contentType ?? 'application/json');
        for (const [field, value] of given(parts.headers)) headers.set(field, value);
        new Headers(init.headers).forEach((value, field) => headers.set(field, value));
        const body = (parts.contentType ? parts.body : JSON.stringify(parts.body)) as BodyInit | undefined;
        const target = filled + (query && `?${query}`);
        let url = this.configuration.basePath + target;
        for (let left = REDIRECTS_MAX; ; left--) {
            let response: Response;
            try {
                // `fetch` would make a GET of a POST that is redirected.
                response = await fetchApi(url, { credentials, redirect: 'manual', ...init, method, headers, body });
            } catch (error) {
                return this.unanswered(error);
            }
            if (response.ok) return response;
            const place = newPlace(response, url);
            const isNear = place !== undefined && new URL(place).origin === new URL(url).origin;
            if (method !== 'GET' || !isNear || !left) {
                throw new ResponseError(response, this.configuration.basePath, hintOf(response, this.configuration.basePath, target, place));
            }
            await response.body?.cancel();
            url = place;
        }
    }
}

/* Where an answer redirects to. */
function newPlace(response: Response, url: string): string | undefined {
    const place = response.headers.get('Location');
    const isMoved = response.status > 300 && response.status < 400 && response.status !== 304;
    try {
        return isMoved && place !== null ? new URL(place, url).href : undefined;
    } catch {
        return undefined; // no URL
    }
}

function hintOf(response: Response, basePath: string, target: string, place?: string): string | undefined {
    if (place !== undefined) {
        const there = new URL(place);
        there.username = there.password = ''; // they may be secrets
        if (!there.href.endsWith(target)) return `It redirects to ${there.origin}: a network may want a sign-in in a browser.`;
        return `The server has moved to ${there.href.slice(0, -target.length)}: give that as the base URL.`;
    }
    if (!isOfProctor(response.headers)) {
        return 'Check that the URL is that of a Proctor server; a network that wants a sign-in in a browser answers so, too.';
    }
    if (response.status !== 404 || !basePath.endsWith('/v1')) return undefined;
    return `The base URL ends with /v1, which every request adds: give ${basePath.slice(0, -3)}.`;
}

/* The innermost reason: the operating system's, if there is one. OpenSSL's has its source line; `reason` is in words. */
function innermost(error: Error): string {
    let inner = error;
    while (inner.cause instanceof Error) inner = inner.cause;
    if (inner instanceof AggregateError && inner.errors.length) inner = inner.errors[0]; // one for each address
    const { code, reason } = inner as { code?: string; reason?: string };
    if (/^ERR_SSL_(WRONG_VERSION_NUMBER|PACKET_LENGTH_TOO_LONG)$/.test(code ?? '')) {
        return 'it does not speak TLS there: check the port, and whether the URL begins with http:// instead';
    }
    return reason || inner.message || code || String(inner);
}

type Program = { env: Record<string, string | undefined>; versions: { node?: string } };

/* Of the variables that name a proxy: Node's fetch leaves them aside, unless NODE_USE_ENV_PROXY is set. */
function proxyNote(url: string): string {
    const { process } = globalThis as { process?: Program }; // a browser has none
    const scheme = new URL(url).protocol.slice(0, -1);
    const name = [`${scheme}_proxy`, `${scheme}_proxy`.toUpperCase()].find((name) => process?.env[name]);
    if (!name || !process?.versions.node) return '';
    const isUsed = process.env.NODE_USE_ENV_PROXY === '1' && parseInt(process.versions.node) >= 24;
    if (isUsed) return `; through the proxy of ${name}, unless NO_PROXY lists the host`;
    if (/^(localhost|127\..*|\[::1\])$/.test(new URL(url).hostname)) return '';
    return `; without the proxy of ${name}, which fetch uses in Node.js 24 or newer with NODE_USE_ENV_PROXY=1`;
}

function given(values: Values = {}): [string, string][] {
    return Object.entries(values).filter(([, value]) => value != null).map(([field, value]) => [field, String(value)]);
}
