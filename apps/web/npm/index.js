// The engine for node programs: solve(spec) and, for live work, the engine of the page itself.
import { readFileSync } from "node:fs";
import createEngine, { failed } from "./engine/engine.js";

/** The engine of this package, loaded once; its interface: engine/engine.d.ts. */
export const engine = await createEngine({
  wasmBinary: readFileSync(new URL("./engine/gearwright.wasm", import.meta.url)),
});
export { failed };

/** A spec that was refused: the key, its value, and the sentence. */
export class SpecError extends Error {
  constructor({ key, value, message, line, column }) {
    super(message);
    this.name = "SpecError";
    Object.assign(this, { key, value, line, column });
  }
}

const text = (spec) => (typeof spec === "string" ? spec : JSON.stringify(spec));

/** What `gearwright VERB SPEC --json` prints, as an object. */
export function solve(spec, verb = "pair") {
  const said = JSON.parse(engine.run(verb, text(spec)));
  if (failed(said)) throw new SpecError(said.error);
  return said;
}

/** A file of gear 1 or 2, or (0) of the pair as it is mounted: its bytes. */
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
