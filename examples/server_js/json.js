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
export function write(value, order = (names) => names) {
  if (Object.is(value, -0)) return '-0.0';
  if (Array.isArray(value)) return `[${value.map((item) => write(item, order)).join(',')}]`;
  if (value === null || typeof value !== 'object') return JSON.stringify(value);
  const names = order(Object.keys(value).filter((name) => value[name] !== undefined));
  return `{${names.map((name) => `${JSON.stringify(name)}:${write(value[name], order)}`).join(',')}}`;
}

/** The same text for two values that are equal, whatever the order of their fields (PRED-025). */
export const canonical = (value) => write(value, (names) => names.sort());
