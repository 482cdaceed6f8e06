/* Evaluate a robot policy on any Proctor server; README.md has the first program. */

export { evaluate, type EvaluateOptions, type Policy } from "./evaluate";
export { type Action, type Actions } from "./actions";
export { decodeObservation, observationOf, type NumericTensor, type Observation, type Picture } from "./observation";
export { ProctorError, RunFailed, RunStopped } from "./errors";
export { Server, type ServerOptions } from "./server";
export { Session } from "./session";
export * as protocol from "../../../generated_clients/typescript/src";
