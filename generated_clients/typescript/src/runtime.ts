/*
 * Generated from spec/openapi.yaml by `make generate`; never edited by hand.
 */

/* The sending of requests and the reading of answers, below the operations of apis/. */

import { read } from './shapes';

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

    constructor(readonly parameters: ConfigurationParameters = {}) {
        this.basePath = (parameters.basePath ?? 'http://127.0.0.1:8460').replace(/\/+$/, '');
    }
}

/** The server refused the request; the body of `response` is a Problem, or what a gateway sent. */
export class ResponseError extends Error {
    override name = 'ResponseError';
    constructor(readonly response: Response) {
        super(`HTTP status ${response.status}`);
    }
}

/** No answer came; `cause` says why. What was sent may have had its effect. */
export class FetchError extends Error {
    override name = 'FetchError';
    constructor(cause: Error) {
        super(`no answer: ${cause.message}`, { cause });
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

export class BaseApi {
    constructor(protected readonly configuration = new Configuration()) {}

    /** Send a request whose success is answered by this message, or by none. */
    protected call<Message>(
        name: string | null, method: string, path: string, parts: RequestParts, init: RequestInit = {},
    ): Answer<Message> {
        const response = this.send(method, path, parts, init);
        const message = response.then(async (answer) =>
            name === null ? (undefined as Message) : read<Message>(name, await answer.text()));
        const withResponse = async () => ({ message: await message, response: await response });
        return Object.assign(message, { withResponse });
    }

    private async send(method: string, path: string, parts: RequestParts, init: RequestInit): Promise<Response> {
        const needed = 'body' in parts ? { ...parts.path, body: parts.body } : parts.path ?? {};
        for (const [field, value] of Object.entries(needed)) if (value == null) throw new RequiredError(field);
        const { accessToken, credentials, fetchApi = fetch } = this.configuration.parameters;
        const token = await (typeof accessToken === 'function' ? accessToken() : accessToken);
        const filled = path.replace(/\{(\w+)\}/g, (_, field) => encodeURIComponent(String(parts.path![field])));
        const query = given(parts.query).map(([field, value]) => `${field}=${encodeURIComponent(value)}`).join('&');
        const headers = new Headers({ Accept: 'application/json, application/problem+json', ...this.configuration.parameters.headers });
        if (token) headers.set('Authorization', `Bearer ${token}`);
        if (parts.body != null) headers.set('Content-Type', parts.contentType ?? 'application/json');
        for (const [field, value] of given(parts.headers)) headers.set(field, value);
        new Headers(init.headers).forEach((value, field) => headers.set(field, value));
        const body = (parts.contentType ? parts.body : JSON.stringify(parts.body)) as BodyInit | undefined;
        const url = this.configuration.basePath + filled + (query && `?${query}`);
        let response: Response;
        try {
            response = await fetchApi(url, { credentials, ...init, method, headers, body });
        } catch (error) {
            throw error instanceof Error ? new FetchError(error) : error;
        }
        if (!response.ok) throw new ResponseError(response);
        return response;
    }
}

function given(values: Values = {}): [string, string][] {
    return Object.entries(values).filter(([, value]) => value != null).map(([field, value]) => [field, String(value)]);
}
