// JSON as the protocol needs it: what breaks other parsers is refused, and −0 is kept.
import { Problem } from './problems.js';

/** Half a surrogate pair is no character, and 1e999 no double: ERR-002 refuses both. */
function wellFormed(name, value) {
  const isText = typeof value === 'string';
  if (!name.isWellFormed() || (isText && !value.isWellFormed())) throw new SyntaxError('half a pair');
  if (value === Infinity || value === -Infinity) throw new SyntaxError('beyond the doubles');
  return value;
}

export function parse(bytes) {
  try {
    const text = new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(bytes);
    return JSON.parse(text, wellFormed);
  } catch {
    throw new Problem('malformed_body'); // the words of the parser do not help a client
  }
}

/** JSON.stringify writes −0 as 0, but the state `vector` returns it bit for bit (ENC-003). */
export function write(value, order = null) {
  if (Object.is(value, -0)) return order ? '0' : '-0.0';
  if (Array.isArray(value)) return `[${value.map((item) => write(item, order)).join(',')}]`;
  if (value === null || typeof value !== 'object') return JSON.stringify(value);
  const shown = Object.keys(value).filter((name) => value[name] !== undefined);
  const names = order?.(shown) ?? shown;
  return `{${names.map((name) => `${JSON.stringify(name)}:${write(value[name], order)}`).join(',')}}`;
}

/** The same text for equal values, as 0 and −0 are, in any order of fields (PRED-025, RFC 8785). */
export const canonical = (value) => write(value, (names) => names.sort());
