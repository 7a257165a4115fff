// Compares the output of the program with that of WebAssembly, for every example and every verb.
//
//   same      the bytes of every verb except the two below, because both have one set of elementary functions
//             (cmake/gw_elementary.cmake)
//   near      contact and load: words, flags, lists and keys are identical, and numbers are within kNear, or kSolved
//             under load, as near.mjs measures. Eigen adds products in another order where it has vectors.
//
// Two WebAssembly builds are tested, the engine of the page and the program under node. Their texts must
// be the same bytes.
import { spawnSync } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { compare, kNear, kSolved } from "./near.mjs";
import { build, loadEngine, source } from "./engine.mjs";

const verbs = ["gear", "pair", "contact", "load", "rate", "measure", "fit", "identify"];
const kSummed = { contact: kNear, load: kSolved };
const native = process.env.GW_BIN ?? path.join(source, "build/release/gearwright");
const program = path.join(build, "cli/gearwright.js");

const run = (command, args) => {
  const { stdout, status } = spawnSync(command, args, { encoding: "utf8", maxBuffer: 1 << 28 });
  return { stdout, status };
};

const { engine } = await loadEngine();
const faults = [];
let numbers = 0;
let bits = 0;
const far = [];
for (const name of readdirSync(path.join(source, "examples")).filter((n) => n.endsWith(".toml")).sort()) {
  const file = path.join(source, "examples", name);
  const text = readFileSync(file, "utf8");
  for (const verb of [...verbs, ...(name.includes("search") ? ["search"] : [])]) {
    const here = `${name} ${verb}`;
    const by = run(native, [verb, file, "--json"]);
    const wasm = run(process.execPath, [program, verb, file, "--json"]);
    if (by.status !== wasm.status) faults.push(`${here}: status ${by.status} and ${wasm.status}`);
    const a = JSON.parse(by.stdout);
    const b = JSON.parse(wasm.stdout);
    const page = JSON.parse(engine.run(verb, text));
    if (page.error) page.error.file = file; // the page's text has no name
    const order = (j) => JSON.stringify(j.error ? Object.entries(j.error).sort() : j);
    if (order(page) !== order(b)) faults.push(`${here}: the engine and the program under node differ`);
    if (by.status === 0 && !(verb in kSummed) && by.stdout !== wasm.stdout) faults.push(`${here}: other bytes`);
    const found = compare(a, b, here);
    faults.push(...found.faults);
    numbers += found.numbers;
    bits += found.bits;
    far.push(...found.differing.filter((d) => d.error > (kSummed[verb] ?? 0)));
  }
}
far.sort((x, y) => y.error - x.error);
for (const d of far.slice(0, 40)) console.log(`${d.error.toExponential(1)}  ${d.path}  ${d.a}  ${d.b}`);
for (const fault of faults) console.log(fault);
console.log(`${numbers} numbers, ${bits} the same bits, ${numbers - bits - far.length} near, ${far.length} not`);
process.exit(faults.length || far.length ? 1 : 0);
