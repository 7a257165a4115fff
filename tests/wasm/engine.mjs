// Loads the engine of the WebAssembly build, for tests under node.
import { readFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";

const here = path.dirname(fileURLToPath(import.meta.url));
export const source = process.env.GW_SOURCE ?? path.resolve(here, "../..");
export const build = process.env.GW_WASM ?? path.join(source, "build/wasm");

/** The engine as used by a page, with its bytes read from disk. */
export async function loadEngine() {
  const folder = path.join(build, "engine");
  const { default: createEngine, failed } = await import(pathToFileURL(path.join(folder, "engine.js")));
  const engine = await createEngine({ wasmBinary: readFileSync(path.join(folder, "gearwright.wasm")) });
  return { engine, failed };
}
