// Provides the engine for node programs as solve(spec) and file(spec, kind), and the engine itself for
// interactive use.
import { readFileSync } from "node:fs";
import createEngine, { failed } from "./engine/engine.js";

/** The engine of this package, loaded once. Its interface is engine/engine.d.ts. */
export const engine = await createEngine({
  wasmBinary: readFileSync(new URL("./engine/gearwright.wasm", import.meta.url)),
});
export { failed };

/** An error in a spec, with the key, its value, and the message. */
export class SpecError extends Error {
  constructor({ key, value, message, kind, line, column }) {
    super(message);
    this.name = "SpecError";
    Object.assign(this, { key, value, kind, line, column });
  }
}

const text = (spec) => (typeof spec === "string" ? spec : JSON.stringify(spec));

/** Returns the output of `gearwright VERB SPEC --json` as an object. */
export function solve(spec, verb = "pair") {
  const said = JSON.parse(engine.run(verb, text(spec)));
  if (failed(said)) throw new SpecError(said.error);
  return said;
}

/** Returns the bytes of a file of gear 1 or 2, or of the mounted pair or the drive if `gear` is 0. */
export function file(spec, kind, { gear = 0, toleranceMm = 0 } = {}) {
  const session = engine.open(text(spec));
  if (failed(session)) throw new SpecError(session.error);
  try {
    const bytes = session.file(kind, gear, toleranceMm);
    if (failed(bytes)) throw new SpecError(bytes.error);
    return bytes;
  } finally {
    session.delete();
  }
}
