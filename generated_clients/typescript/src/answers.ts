/*
 * Written by hand, beside what is generated from the specification.
 */

/* The reader that checks an answer against the members of its message. */

import { MESSAGES, type Shape } from './shapes';

/** A success that is not the message expected. What was sent may have had its effect. */
export class InvalidAnswer extends Error {
    override name = 'InvalidAnswer';
    /** The method of the request, and the answer to it, whose body was read. */
    method?: string;
    response?: Response;
}

/** The message that a JSON text holds. Throws InvalidAnswer, with the place of what is wrong. */
export function read<Message>(name: string, text: string): Message {
    let value: unknown;
    try {
        value = JSON.parse(text);
    } catch (cause) {
        throw new InvalidAnswer('the answer is not JSON', { cause });
    }
    return valueOf(value, name, '', name) as Message;
}

function messageOf(value: unknown, name: string, at: string, message: string): object {
    const given = contentOf(value, 'object', at, message);
    const members: Record<string, unknown> = { ...given }; // those of a later version, too
    for (const [member, choice] of Object.entries(MESSAGES[name])) {
        const { shape, absent } = typeof choice === 'object' && 'shape' in choice ? choice : { shape: choice, absent: null };
        if (given[member] === undefined && absent !== true) throw invalid(message, `${at}/${member} is missing`);
        if (given[member] != null || absent === null) members[member] = valueOf(given[member], shape, `${at}/${member}`, message);
        else if (absent) delete members[member];
    }
    return members;
}

function valueOf(value: unknown, shape: Shape, at: string, message: string): unknown {
    if (typeof shape === 'object' && 'list' in shape) {
        const items: unknown[] = contentOf(value, 'array', at, message);
        return items.map((item, i) => valueOf(item, shape.list, `${at}/${i}`, message));
    }
    if (typeof shape === 'object') {
        const entries = Object.entries(contentOf(value, 'object', at, message));
        return Object.fromEntries(entries.map(([key, item]) => [key, valueOf(item, shape.map, `${at}/${key}`, message)]));
    }
    if (shape in MESSAGES) return messageOf(value, shape, at, message);
    if (shape === 'Date') return new Date(contentOf(value, 'string', at, message));
    return contentOf(value, shape, at, message);
}

/** The value, which must be of this type of JSON. */
function contentOf(value: unknown, kind: string, at: string, message: string): any {
    const own = value === null ? 'null' : Array.isArray(value) ? 'array' : typeof value;
    if (own !== kind) throw invalid(message, `${at || 'it'} is not of the type ${kind}`);
    return value;
}

function invalid(message: string, fault: string): InvalidAnswer {
    return new InvalidAnswer(`the answer is not the message ${message}: ${fault}`);
}
