// From a request to an answer: path, version, token, scope, encodings, size, schema, and then the operation.
import { createHash } from 'node:crypto';
import { parse, write } from './json.js';
import { Problem, invalid } from './problems.js';
import { LIMITS, check } from './shapes.js';

const VERSION = '1.0';
const hash = (secret) => createHash('sha256').update(secret).digest('hex');

/** `account:scopes:token`, comma-separated; scopes are `read`, `run` or `read+run`. Only hashes are kept. */
export function readTokens(text) {
  const callers = new Map();
  for (const entry of text.split(',').map((part) => part.trim()).filter(Boolean)) {
    const [account, scopes, ...secret] = entry.split(':');
    callers.set(hash(secret.join(':')), { account, scopes: scopes.split('+') });
  }
  return callers;
}

/** The route of a path and what stands in its variable segments; a worker id is judged by its operation. */
function match(routes, path) {
  const segments = path.split('/');
  for (const route of routes) {
    const names = route.path.split('/');
    const fits = names.length === segments.length
      && names.every((name, i) => (name.startsWith(':') ? segments[i] !== '' : name === segments[i]));
    if (!fits) continue;
    const variables = names.map((name, i) => [name.slice(1), segments[i]]).filter((_, i) => names[i].startsWith(':'));
    return { route, params: Object.fromEntries(variables) };
  }
  throw new Problem('not_found');
}

function checkVersion(wanted) {
  if (wanted !== undefined && wanted !== VERSION) throw new Problem('unsupported_version', { detail: `Only ${VERSION} is spoken` });
}

function authenticate(callers, header = '', scope) {
  const [, token] = /^bearer +(\S+)$/i.exec(header) ?? [];
  const caller = token && callers.get(hash(token));
  if (!caller) throw new Problem('unauthenticated', {}, { 'WWW-Authenticate': 'Bearer' });
  if (!caller.scopes.includes(scope)) throw new Problem('forbidden', { detail: `The scope ${scope} is missing` });
  return caller.account;
}

function checkAccept(header) {
  if (header === undefined) return;
  // The most exact range decides, as RFC 9110 says: `application/json;q=0, */*` wants anything else.
  const quality = new Map(header.split(',').map((range) => {
    const [type, ...parameters] = range.toLowerCase().split(';').map((part) => part.trim());
    const q = parameters.find((parameter) => parameter.startsWith('q='));
    return [type, q ? Number(q.slice(2)) : 1];
  }));
  const decisive = ['application/json', 'application/*', '*/*'].find((range) => quality.has(range));
  if (!decisive || !(quality.get(decisive) > 0)) throw new Problem('not_acceptable');
}

async function readBody(request) {
  const chunks = [];
  let size = 0;
  for await (const chunk of request) {
    size += chunk.length;
    if (size <= LIMITS.max_body_bytes) chunks.push(chunk);
    else chunks.length = 0; // read on: a client that is still sending would never see the answer
  }
  if (size > LIMITS.max_body_bytes) throw new Problem('body_too_large');
  const type = request.headers['content-type']?.split(';')[0].trim().toLowerCase();
  if (type !== 'application/json' && (size > 0 || type)) throw new Problem('unsupported_media_type');
  return parse(Buffer.concat(chunks));
}

/** A query parameter that has to match, or its fallback when it is absent. */
export function parameter(query, name, pattern, fallback) {
  const value = query.get(name);
  if (value === null && fallback === undefined) throw invalid([`query:${name}`, 'is required']);
  if (value !== null && !pattern.test(value)) throw invalid([`query:${name}`, `must match ${pattern}`]);
  return value ?? fallback;
}

/** One page of `items` and the cursor of the next; `place` is the number by which an item is found again. */
export function page(items, query, place) {
  const limit = Number(parameter(query, 'limit', /^0*([1-9][0-9]{0,2}|1000)$/, '100'));
  const cursor = parameter(query, 'cursor', /^after-[0-9]{1,12}$/, '');
  const after = Number(cursor.slice('after-'.length));
  const begin = cursor ? items.findIndex((item) => place(item) === after) + 1 : 0;
  if (cursor && begin === 0) throw invalid(['query:cursor', 'is not a cursor of this list']);
  const shown = items.slice(begin, begin + limit);
  return { shown, next_cursor: begin + limit < items.length ? `after-${place(shown.at(-1))}` : null };
}

async function answer(request, routes, callers) {
  const [path, search = ''] = request.url.split(/\?(.*)/s);
  checkVersion(request.headers['proctor-version']);
  const { route, params } = match(routes, path);
  const operation = Object.hasOwn(route, request.method) ? route[request.method] : null;
  if (!operation) {
    const methods = Object.keys(route).filter((name) => name !== 'path');
    throw new Problem('method_not_allowed', {}, { Allow: methods.join(', ') });
  }
  const scope = request.method === 'GET' ? 'read' : 'run';
  const account = operation.open ? null : authenticate(callers, request.headers.authorization, scope);
  if (!operation.silent) checkAccept(request.headers.accept);
  const context = { account, params, headers: request.headers, query: new URLSearchParams(search) };
  if (operation.shape) {
    context.body = await readBody(request);
    check(operation.shape, context.body);
  }
  return operation.does(context);
}

/** A listener for http.createServer. */
export function listener(routes, callers) {
  return async (request, response) => {
    let found;
    try {
      found = await answer(request, routes, callers);
    } catch (error) {
      if (!(error instanceof Problem)) console.error(error);
      const problem = error instanceof Problem ? error : new Problem('internal_error');
      found = { ...problem, type: 'application/problem+json' };
    }
    const { status = 200, headers = {}, body, type = 'application/json' } = found;
    const content = body === undefined ? {} : { 'Content-Type': type };
    response.writeHead(status, { 'Proctor-Version': VERSION, ...content, ...headers });
    response.end(body === undefined ? undefined : write(body));
  };
}

/** The whole answer to bytes that are no HTTP request; the list of problems has no better word for them. */
export function notHttp() {
  const content = write(new Problem('malformed_body', { detail: 'This is no HTTP request' }).body);
  const head = ['HTTP/1.1 400 Bad Request', `Proctor-Version: ${VERSION}`, 'Content-Type: application/problem+json'];
  return [...head, `Content-Length: ${Buffer.byteLength(content)}`, 'Connection: close', '', content].join('\r\n');
}
