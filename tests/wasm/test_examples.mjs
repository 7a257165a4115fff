// Compares the output of the program with that of WebAssembly, for every example and every verb. The bytes are the
// same, because both have one set of elementary functions (cmake/gw_elementary.cmake) and Eigen's vectors of two
// doubles (cmake/gw_options.cmake).
//
// Two WebAssembly builds are tested, the engine of the page and the program under node.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { build, loadEngine, source } from "./engine.mjs";

const verbs = ["gear", "pair", "contact", "load", "rate", "measure", "fit", "identify"];
const native = process.env.GW_BIN ?? path.join(source, "build/release/gearwright");
const program = path.join(build, "cli/gearwright.js");

const run = (command, args) => {
  const { stdout, status } = spawnSync(command, args, { encoding: "utf8", maxBuffer: 1 << 28 });
  return { stdout, status };
};

const { engine } = await loadEngine();
const faults = [];
let answers = 0;
for (const name of readdirSync(path.join(source, "examples")).filter((n) => n.endsWith(".toml")).sort()) {
  const file = path.join(source, "examples", name);
  const text = readFileSync(file, "utf8");
  for (const verb of [...verbs, ...(name.includes("search") ? ["search"] : [])]) {
    const here = `${name} ${verb}`;
    const by = run(native, [verb, file, "--json"]);
    const wasm = run(process.execPath, [program, verb, file, "--json"]);
    if (by.status !== wasm.status) faults.push(`${here}: status ${by.status} and ${wasm.status}`);
    if (by.stdout !== wasm.stdout) faults.push(`${here}: the program under node has other bytes`);
    const page = JSON.parse(engine.run(verb, text));
    if (page.error) page.error.file = file; // the page's text has no name
    try {
      assert.deepEqual(page, JSON.parse(by.stdout));
    } catch (error) {
      faults.push(`${here}: the engine of the page: ${error.message.slice(0, 400)}`);
    }
    answers += 1;
  }
}
for (const fault of faults) console.log(fault);
console.log(`${answers} answers, ${faults.length} differences`);
process.exit(faults.length ? 1 : 0);
