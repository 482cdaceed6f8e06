/* What a policy returns, checked and converted to the messages of the protocol. */

import type { Action as WireAction, Benchmark } from "../../../generated_clients/typescript/src";
import { ProctorError } from "./errors";

/** Every name of the action space with its numbers, or all numbers in the order of the space. */
export type Action = Record<string, ArrayLike<number>> | ArrayLike<number>;
/** One action, or a chunk: a list of actions to be executed in order. */
export type Actions = Action | Action[];

/** The names and sizes of an action, in the declared order. */
export class ActionLayout {
  private readonly benchmarkId: string;
  private readonly sizes: Map<string, number>;
  /** Names of vectors that only some tasks have; the server knows which task is played. */
  private readonly optional: Set<string>;

  constructor(benchmark: Benchmark) {
    const spaces = Object.entries(benchmark.action_space);
    this.benchmarkId = benchmark.benchmark_id;
    this.sizes = new Map(spaces.map(([name, space]) => [name, space.size]));
    this.optional = new Set(spaces.filter(([, space]) => space.tasks).map(([name]) => name));
  }

  /** The named vectors of a row of numbers. */
  split(row: number[], at: string): Record<string, number[]> {
    if (this.optional.size) throw invalid(at, "is an array, and actions of this benchmark have no fixed order", this);
    let first = 0;
    const values: Record<string, number[]> = {};
    for (const [name, size] of this.sizes) values[name] = row.slice(first, (first += size));
    if (row.length !== first) throw invalid(at, `is an array of ${row.length}`, this);
    return values;
  }

  check(values: Record<string, number[]>, at: string): void {
    for (const name of Object.keys(values)) if (!this.sizes.has(name)) throw invalid(at, `has ${name}, which is no name`, this);
    for (const [name, size] of this.sizes) {
      if (!(name in values)) {
        if (this.optional.has(name)) continue;
        throw invalid(at, `lacks ${name}`, this);
      }
      const { length } = values[name];
      if (length !== size) throw invalid(`${at}/${name}`, `has ${length} numbers; ${name} has ${size}`, this);
    }
  }

  describe(): string {
    const only = (name: string) => (this.optional.has(name) ? " (of some tasks)" : "");
    const names = [...this.sizes].map(([name, size]) => `${name} ${size}${only(name)}`).join(", ");
    if (this.optional.size) return `An action of ${this.benchmarkId} is: ${names}.`;
    const total = [...this.sizes.values()].reduce((sum, size) => sum + size, 0);
    return `An action of ${this.benchmarkId} is: ${names}, or an array of ${total} in this order.`;
  }
}

/** What a policy returned, as a list of schema Action; throws `invalid_request`. */
export function chunkOf(given: Actions, layout: ActionLayout): WireAction[] {
  const chunk = isChunk(given) ? given : [given];
  if (chunk.length === 0) throw invalid("/actions", "is empty; a chunk holds at least one action", layout);
  return chunk.map((action, i) => ({ values: valuesOf(action, `/actions/${i}/values`, layout) }));
}

/** A list of actions; a list of numbers is one action. */
function isChunk(given: Actions): given is Action[] {
  return Array.isArray(given) && typeof given[0] !== "number";
}

function valuesOf(action: Action, at: string, layout: ActionLayout): Record<string, number[]> {
  if (typeof action !== "object" || action === null) throw invalid(at, `is ${String(action)}, not an action`, layout);
  if (isNumbers(action)) {
    return layout.split(numbersOf(action, at, layout), at);
  }
  const vectors = Object.entries(action).map(([name, vector]) => [name, numbersOf(vector, `${at}/${name}`, layout)]);
  const values: Record<string, number[]> = Object.fromEntries(vectors);
  layout.check(values, at);
  return values;
}

function isNumbers(given: Action): given is ArrayLike<number> {
  return Array.isArray(given) || ArrayBuffer.isView(given);
}

function numbersOf(vector: ArrayLike<number>, at: string, layout: ActionLayout): number[] {
  if (!isNumbers(vector)) throw invalid(at, "is not an array of numbers", layout);
  const numbers = Array.from(vector);
  const wrong = numbers.findIndex((number) => !Number.isFinite(number));
  if (wrong >= 0) throw invalid(`${at}/${wrong}`, `is ${named(numbers[wrong])}, which is no finite number`, layout);
  return numbers;
}

/** The value with its type, where the value alone looks like a number. */
function named(value: unknown): string {
  if (typeof value === "string") return `the text ${JSON.stringify(value)}`;
  if (typeof value === "bigint") return `the BigInt ${value}n`;
  if (Array.isArray(value) || ArrayBuffer.isView(value)) return "an array";
  return typeof value === "object" && value !== null ? "an object" : String(value);
}

function invalid(at: string, what: string, layout: ActionLayout): ProctorError {
  const detail = `The policy returned actions that cannot be sent: ${at} ${what}. Correct what it returns. ${layout.describe()}`;
  return new ProctorError("invalid_request", detail);
}
