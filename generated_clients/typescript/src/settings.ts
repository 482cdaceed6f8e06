/*
 * Written by hand, beside what is generated from the specification.
 */

/* The base URL and the token of a server: what copying adds to their ends is taken off, any other fault is refused. */

/** A setting that cannot be used. Nothing was sent; the message says what is wrong, and repeats no secret. */
export class BadSetting extends TypeError {
    override name = 'BadSetting';
}

const INVISIBLE = '\\s\\p{Cc}\\p{Cf}'; // byte order marks, too
const ENDS = new RegExp(`^[${INVISIBLE}]+|[${INVISIBLE}]+$`, 'gu');
const QUOTES: Record<string, string> = { '"': '"', "'": "'", '`': '`', '\u201c': '\u201d', '\u2018': '\u2019' };

function trimmed(text: string): string {
    for (;;) {
        text = text.replace(ENDS, '');
        if (text.length < 2 || QUOTES[text[0]] !== text.at(-1)) return text;
        text = text.slice(1, -1);
    }
}

/** The token without what editors, shells and web pages add to it. Throws BadSetting for what no header can carry. */
export function cleanToken(text: string): string {
    const token = trimmed(text).replace(/^(authorization:\s*)?bearer\s+/i, '');
    const place = [...token].findIndex((character) => character < '!' || character > '~');
    if (place < 0) return token;
    const character = [...token][place];
    const isInvisible = new RegExp(`[${INVISIBLE}]`, 'u').test(character);
    const code = character.codePointAt(0)!.toString(16).toUpperCase().padStart(4, '0');
    const what = character === ' ' ? 'a space' : isInvisible ? `an invisible character (U+${code})` : 'a character that is not ASCII';
    throw new BadSetting(`the token has ${what} at position ${place + 1} of ${[...token].length}: copy it again, as it was printed`);
}

/** The base URL without a slash at its end. Throws BadSetting. */
export function cleanBaseUrl(text: string): string {
    const url = trimmed(text).replace(/\/+$/, '');
    const [, place] = /^https?:\/\/([^/?#]*)/i.exec(url) ?? [];
    // Without what may be a secret: a password, a query.
    const shown = JSON.stringify(url.replace(/^([^/?#]*\/\/)?[^/?#]*@/, '$1').replace(/[?#].*/s, ''));
    if (place === undefined) throw new BadSetting(`the base URL must be like http://127.0.0.1:8460 or https://robots.example/path, not ${shown}`);
    const fault = faultOf(url, place);
    if (fault) throw new BadSetting(`the base URL ${shown} ${fault}`);
    return url;
}

function faultOf(url: string, place: string): string | undefined {
    if (place.includes('@')) return 'has a user or a password, which no request would carry: a server is given a token';
    if (place.includes('%')) {
        return 'names a network interface (a zone id, behind %), which only this machine knows: use another address, or the name of the server';
    }
    if (place.split(':').length > 2 && !place.startsWith('[')) return 'has an IPv6 address without brackets: write http://[::1]:8460';
    if (/[?#]/.test(url)) return 'ends with a query: give the part before the ? or #';
    try {
        new URL(url);
    } catch {
        return 'has an invalid host or port';
    }
    return new RegExp(`[${INVISIBLE}]`, 'u').test(url) ? 'has a space or an invisible character in it' : undefined;
}
