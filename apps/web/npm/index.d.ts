// import { solve } from "gearwright"
import type { Engine, FileKind, Verb } from "./engine/engine.js";
export type { Engine, FileKind, Session, Verb } from "./engine/engine.js";
export { failed } from "./engine/engine.js";

/** TOML or JSON text, or the spec as an object: docs/spec.md. */
export type Spec = string | Record<string, unknown>;

/** A number, a list of them per gear, a word, a flag, a record; null: there is no such value. */
export type Value =
  | number
  | string
  | boolean
  | null
  | Value[]
  | { [key: string]: Value };
export type Values = { [key: string]: Value };

/** What a verb answers: docs/spec.md, and gearwright schema result. */
export interface Result {
  title?: string;
  gears?: Values[];
  pair?: Values;
  contact?: Values;
  compensate?: Values;
  scatter?: Values;
  load?: Values;
  rating?: Values;
  fit?: Values;
  identify?: Values;
  search?: Values;
  warnings?: { code: string; message: string; gear: number | null }[];
  verdict?: { level: "green" | "amber" | "red"; headline: string } & Values;
}

/** A spec that was refused. */
export class SpecError extends Error {
  key: string;
  value: string;
  line?: number;
  column?: number;
}

/** What `gearwright VERB SPEC --json` prints, as an object.   Throws  SpecError */
export function solve(spec: Spec, verb?: Verb): Result;

/** A file's bytes: of gear 1 or 2, or (0) of the pair as it is mounted.   Throws  SpecError */
export function file(
  spec: Spec,
  kind: FileKind,
  options?: { gear?: 0 | 1 | 2; toleranceMm?: number },
): Uint8Array;

/** The engine itself, for live work. */
export const engine: Engine;
