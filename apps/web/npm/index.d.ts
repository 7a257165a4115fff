// Example: import { solve } from "gearwright"
import type { Engine, FileKind, Verb } from "./engine/engine.js";
export type { Engine, FileKind, Session, Verb } from "./engine/engine.js";
export { failed } from "./engine/engine.js";

/** A spec as TOML or JSON text or as an object. Its keys are described in docs/spec.md. */
export type Spec = string | Record<string, unknown>;

/** A number, a list with a number for each gear, a word, a flag, or a record. null means that there is no such
 *  value. */
export type Value =
  | number
  | string
  | boolean
  | null
  | Value[]
  | { [key: string]: Value };
export type Values = { [key: string]: Value };

/** The answer of a verb. It is described in docs/spec.md and by `gearwright schema result`. */
export interface Result {
  title?: string;
  gears?: Values[];
  pair?: Values;
  drive?: Values;
  contact?: Values;
  compensate?: Values;
  propose?: Values;
  scatter?: Values;
  load?: Values;
  rating?: Values;
  fit?: Values;
  identify?: Values;
  search?: Values;
  warnings?: { code: string; message: string; gear: number | null }[];
  verdict?: { level: "green" | "amber" | "red"; headline: string } & Values;
}

export class SpecError extends Error {
  key: string;
  value: string;
  /** The kind of the error, such as "missing"; docs/spec.md lists all kinds. */
  kind: string;
  line?: number;
  column?: number;
}

/** Returns the output of `gearwright VERB SPEC --json` as an object.   Throws  SpecError */
export function solve(spec: Spec, verb?: Verb): Result;

/** Returns the bytes of a file of gear 1 or 2, or of the mounted pair or the drive if `gear` is 0.
 *  Throws  SpecError */
export function file(
  spec: Spec,
  kind: FileKind,
  options?: { gear?: 0 | 1 | 2; toleranceMm?: number },
): Uint8Array;

/** The engine itself, for interactive use. */
export const engine: Engine;
