// From a request to a response: path, method, version, token, body, schema, operation.
import { createHash } from 'node:crypto';
import { parse, write } from './json.js';
import { Problem } from './problems.js';
import { LIMITS, check } from './shapes.js';

const VERSION = '1.0';
const hash = (token) => createHash('sha256').update(token).digest('hex');

/** Read `account:scopes:token`, comma-separated. Only hashes are kept; Core has no scopes. */
export function readTokens(text) {
  const entries = text.split(',').map((entry) => entry.trim().split(':'));
  return new Map(entries.map(([account, , ...token]) => [hash(token.join(':')), account]));
}

function match(routes, method, path) {
  const matching = routes.filter(({ pattern }) => pattern.test(path));
  if (matching.length === 0) throw new Problem('not_found');
  const route = matching.find((candidate) => candidate.method === method);
  const Allow = matching.map((candidate) => candidate.method).join(', ');
  if (!route) throw new Problem('method_not_allowed', {}, { Allow });
  return { route, params: { ...route.pattern.exec(path).groups } };
}

function authenticate(accounts, header = '') {
  const [, token] = /^bearer +(\S+)$/i.exec(header) ?? [];
  const account = token && accounts.get(hash(token));
  if (!account) throw new Problem('unauthenticated', {}, { 'WWW-Authenticate': 'Bearer' });
  return account;
}

async function readBody(request) {
  const type = request.headers['content-type']?.split(';')[0].trim().toLowerCase();
  const chunks = [];
  let size = 0;
  for await (const chunk of request) {
    size += chunk.length;
    // What follows is read all the same: a client that still sends would not see the response.
    if (size <= LIMITS.max_body_bytes) chunks.push(chunk);
  }
  if (size > LIMITS.max_body_bytes) throw new Problem('body_too_large');
  if (type !== 'application/json' && (size > 0 || type)) throw new Problem('unsupported_media_type');
  return parse(Buffer.concat(chunks));
}

async function respond(request, routes, accounts) {
  const { headers, method, url } = request;
  const { route, params } = match(routes, method, url.split('?')[0]);
  const asked = (headers['proctor-version'] ?? VERSION).split('.').map(Number).join('.'); // 01.0 is 1.0
  if (asked !== VERSION) throw new Problem('unsupported_version');
  const account = route.isOpen ? null : authenticate(accounts, headers.authorization);
  const context = { account, params, headers };
  if (route.shape) {
    context.body = await readBody(request);
    check(route.shape, context.body);
  }
  const body = await route.act(context);
  const location = route.status === 201 ? { Location: `${url.split('?')[0]}/${body.run_id}` } : {};
  return { status: route.status ?? 200, headers: location, type: 'application/json', body };
}

/** A listener for http.createServer. */
export function listener(table, accounts) {
  const pattern = (path) => new RegExp(`^${path.replace(/:(\w+)/g, '(?<$1>[^/]+)')}$`);
  const routes = table.map((route) => ({ ...route, pattern: pattern(route.path) }));
  return async (request, response) => {
    const answer = await respond(request, routes, accounts).catch((error) => {
      if (!(error instanceof Problem)) console.error(error);
      const problem = error instanceof Problem ? error : new Problem('internal_error');
      return { ...problem, type: 'application/problem+json' };
    });
    const { status, headers, type, body } = answer;
    response.writeHead(status, { 'Proctor-Version': VERSION, 'Content-Type': type, ...headers });
    response.end(write(body));
  };
}
