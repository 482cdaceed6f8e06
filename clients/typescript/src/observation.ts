/* What a policy receives: state vectors, images and tensors, decoded from a turn. */

import type { Observation as WireObservation, Tensor as WireTensor, Turn } from "../../../generated_clients/typescript/src";
import { ProctorError } from "./errors";

/** An image, row 0 on top. `raw`: height × width × channels bytes; else a file of this codec. */
export interface Picture {
  codec: string;
  height: number;
  width: number;
  channels: number;
  data: Uint8Array;
}

export type Numbers =
  | Uint8Array | Int8Array | Uint16Array | Int16Array | Uint32Array | Int32Array
  | Float32Array | Float64Array | BigInt64Array | BigUint64Array;

/** An array in C order. `bool` is bytes 0 and 1; `float16` is decoded to a Float32Array. */
export interface NumericTensor {
  dtype: string;
  shape: number[];
  data: Numbers;
}

/** One observation, in the units and frames of the benchmark's spaces. */
export interface Observation {
  state: Record<string, number[]>;
  images: Record<string, Picture>;
  tensors: Record<string, NumericTensor>;
  /** The task of this episode, in natural language. */
  instruction: string;
  task: string;
  episodeId: string;
  /** Actions executed in this attempt so far; 0 in an episode's first observation. */
  step: number;
  /** The whole message as received. */
  turn: Turn;
}

const ARRAYS: Record<string, new (buffer: ArrayBuffer) => Numbers> = {
  bool: Uint8Array, uint8: Uint8Array, int8: Int8Array, uint16: Uint16Array, int16: Int16Array,
  uint32: Uint32Array, int32: Int32Array, uint64: BigUint64Array, int64: BigInt64Array,
  float16: Uint16Array, float32: Float32Array, float64: Float64Array,
};

/** The observation of a turn that is not done; `bad_answer` if it is missing or does not decode. */
export function observationOf(turn: Turn): Observation {
  const { episode, observation } = turn;
  if (!episode || !observation) throw broken("the turn", "has no observation, and is not done");
  return {
    ...decodeObservation(observation), instruction: episode.instruction, task: episode.task,
    episodeId: episode.episode_id, step: episode.step, turn,
  };
}

/** The parts of one observation. A tensor of a dtype that a later version has is left out. */
export function decodeObservation(seen: WireObservation): Pick<Observation, "state" | "images" | "tensors"> {
  const images = mapEntries(seen.images, (image, name) => {
    const { codec, height, width, channels } = image;
    const data = bytesOf(image.data, name);
    if (codec === "raw" && data.length !== productOf([height, width, channels])) throw broken(name, "does not have its declared size");
    return { codec, height, width, channels, data };
  });
  const known = Object.entries(seen.tensors).filter(([, tensor]) => tensor.dtype in ARRAYS);
  return { state: seen.state, images, tensors: mapEntries(Object.fromEntries(known), tensorOf) };
}

function tensorOf(tensor: WireTensor, name: string): NumericTensor {
  const { dtype, shape } = tensor;
  const { buffer } = bytesOf(tensor.data, name);
  const width = new ARRAYS[dtype](new ArrayBuffer(0)).BYTES_PER_ELEMENT;
  if (buffer.byteLength !== productOf([...shape, width])) throw broken(name, "does not have its declared size");
  const data = new ARRAYS[dtype](buffer);
  return { dtype, shape, data: dtype === "float16" ? Float32Array.from(data as Uint16Array, fromFloat16) : data };
}

/** NaN if a size is negative. */
function productOf(sizes: number[]): number {
  return sizes.some((size) => size < 0) ? NaN : sizes.reduce((product, size) => product * size, 1);
}

function fromFloat16(bits: number): number {
  const sign = bits & 0x8000 ? -1 : 1, exponent = (bits >> 10) & 31, fraction = bits & 1023;
  if (exponent === 31) return fraction ? NaN : sign * Infinity;
  return sign * (exponent ? 2 ** (exponent - 15) * (1 + fraction / 1024) : 2 ** -14 * (fraction / 1024));
}

/** Base64 as bytes with a buffer of their own. */
function bytesOf(text: string, name: string): { buffer: ArrayBuffer } & Uint8Array {
  const bytes = new Uint8Array(Buffer.from(text, "base64"));
  // Buffer leaves out what is no Base64, and ends at the first "=": then bytes are missing.
  const padding = text.endsWith("==") ? 2 : text.endsWith("=") ? 1 : 0;
  if (text.length % 4 || bytes.length !== (text.length / 4) * 3 - padding) throw broken(name, "is no Base64");
  return bytes;
}

function mapEntries<A, B>(given: Record<string, A>, make: (value: A, name: string) => B): Record<string, B> {
  return Object.fromEntries(Object.entries(given).map(([name, value]) => [name, make(value, name)]));
}

function broken(name: string, what: string): ProctorError {
  const detail = `The observation cannot be decoded: ${name} ${what}. Report it to the server's operator.`;
  return new ProctorError("bad_answer", detail, { sideEffects: "possible" });
}
