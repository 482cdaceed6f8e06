// JSON as the protocol needs it: reading that refuses what it should, writing that keeps −0.
import { Problem } from './problems.js';

const DEPTH = 64; // nothing in the protocol nests deeper than ten

/** Members by their colons. Nesting is counted before parsing: no parser and no recursion meets a million brackets. */
function countMembers(text) {
  let depth = 0;
  let members = 0;
  let quoted = false;
  for (let i = 0; i < text.length; i += 1) {
    const char = text[i];
    if (quoted) {
      if (char === '\\') i += 1;
      else if (char === '"') quoted = false;
    } else if (char === '"') quoted = true;
    else if (char === '[' || char === '{') depth += 1;
    else if (char === ']' || char === '}') depth -= 1;
    else if (char === ':') members += 1;
    if (depth > DEPTH) throw new SyntaxError('nested too deeply');
  }
  return members;
}

/** Half a surrogate pair is no character, and 1e999 no double: many parsers would choke on an answer that repeats it. */
function wellFormed(name, value) {
  if (value === Infinity || value === -Infinity) throw new SyntaxError('a number beyond the doubles');
  if (!name.isWellFormed() || (typeof value === 'string' && !value.isWellFormed())) throw new SyntaxError('half a surrogate pair');
  return value;
}

export function parse(bytes) {
  try {
    const text = new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(bytes);
    const sent = countMembers(text);
    let kept = -1; // the whole value is not a member, and is shown to the function, too
    const value = JSON.parse(text, function look(name, member) {
      if (!Array.isArray(this)) kept += 1;
      return wellFormed(name, member);
    });
    // Of members with one name the parser keeps the last: two programs may see two values.
    if (kept === sent) return value;
  } catch {
    // refused below: the parser's own words do not help a client
  }
  throw new Problem('malformed_body');
}

/** JSON.stringify writes −0 as 0; the state `vector` has to come back bit for bit. */
export function write(value) {
  if (Object.is(value, -0)) return '-0.0';
  if (Array.isArray(value)) return `[${value.map(write).join(',')}]`;
  if (value === null || typeof value !== 'object') return JSON.stringify(value);
  const members = Object.entries(value).filter(([, member]) => member !== undefined);
  return `{${members.map(([name, member]) => `${JSON.stringify(name)}:${write(member)}`).join(',')}}`;
}

/** The same for two bodies exactly if they say the same, whatever the order of their members. */
export function fingerprint(value) {
  if (Array.isArray(value)) return `[${value.map(fingerprint).join(',')}]`;
  if (value === null || typeof value !== 'object') return write(value);
  const names = Object.keys(value).sort();
  return `{${names.map((name) => `${JSON.stringify(name)}:${fingerprint(value[name])}`).join(',')}}`;
}
