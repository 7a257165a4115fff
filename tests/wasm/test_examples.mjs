// Compares the output of the program with that of WebAssembly, for every example and every verb, and the files of drives.
//
//   Law       status and bytes are the same, because both have one set of elementary functions (cmake/gw_elementary.cmake)
//             and the same vectors of Eigen (cmake/eigen_vectors). Only 3MF files differ, which are compressed differently.
//
// Two WebAssembly builds are tested, the engine of the page and the program under node. Their texts must
// be the same bytes.
import { spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { compare } from "./differences.mjs";
import { build, loadEngine, source } from "./engine.mjs";

const verbs = ["gear", "pair", "contact", "load", "rate", "measure", "fit", "identify", "drive", "outline"];
const native = process.env.GW_BIN ?? path.join(source, "build/release/gearwright");
const program = path.join(build, "cli/gearwright.js");

const run = (command, args) => {
  const { stdout, status } = spawnSync(command, args, { encoding: "utf8", maxBuffer: 1 << 28 });
  return { stdout, status };
};
const ofNative = (args) => run(native, args);
const ofWasm = (args) => run(process.execPath, [program, ...args]);
const examples = (folder) =>
  readdirSync(path.join(source, folder))
    .filter((name) => name.endsWith(".toml"))
    .sort()
    .map((name) => path.join(source, folder, name));

const { engine } = await loadEngine();
const faults = [];
let numbers = 0;
const differing = [];
for (const file of [...examples("examples"), ...examples("examples/drives")]) {
  const name = path.basename(file);
  const text = readFileSync(file, "utf8");
  for (const verb of [...verbs, ...(name.includes("search") ? ["search"] : [])]) {
    const here = `${name} ${verb}`;
    const by = ofNative([verb, file, "--json"]);
    const wasm = ofWasm([verb, file, "--json"]);
    if (by.status !== wasm.status) faults.push(`${here}: status ${by.status} and ${wasm.status}`);
    if (by.status === 0 && by.stdout !== wasm.stdout) faults.push(`${here}: other bytes`);
    const b = JSON.parse(wasm.stdout);
    const page = JSON.parse(engine.run(verb, text));
    if (page.error) page.error.file = file; // the page's text has no name
    const order = (j) => JSON.stringify(j.error ? Object.entries(j.error).sort() : j);
    if (order(page) !== order(b)) faults.push(`${here}: the engine and the program under node differ`);
    const found = compare(JSON.parse(by.stdout), b, here);
    faults.push(...found.faults);
    numbers += found.numbers;
    differing.push(...found.differing);
  }
}
const folder = mkdtempSync(path.join(tmpdir(), "gearwright_wasm_"));
let files = 0;
try {
  for (const file of examples("examples/drives")) {
    const name = path.basename(file, ".toml");
    const [one, two] = ["native", "wasm"].map((by) => path.join(folder, `${name}_${by}`));
    const statuses = [ofNative(["run", file, "--out", one]).status, ofWasm(["run", file, "--out", two]).status];
    if (statuses[0] !== 0 || statuses[1] !== 0) faults.push(`run ${name}: status ${statuses.join(" and ")}`);
    const [names, others] = [one, two].map((out) => readdirSync(out).sort());
    if (names.join() !== others.join()) faults.push(`run ${name}: ${names} and ${others}`);
    for (const kind of names.filter((n) => !n.endsWith(".3mf") && others.includes(n))) {
      files += 1;
      if (!readFileSync(path.join(one, kind)).equals(readFileSync(path.join(two, kind)))) faults.push(`${kind} of ${name}: other bytes`);
    }
  }
} finally {
  rmSync(folder, { recursive: true });
}
differing.sort((x, y) => y.relative - x.relative);
for (const d of differing.slice(0, 40)) console.log(`${d.relative.toExponential(1)}  ${d.path}  ${d.a}  ${d.b}`);
for (const fault of faults) console.log(fault);
console.log(`${numbers} numbers, ${differing.length} with other bits; ${files} files of drives`);
process.exit(faults.length || differing.length ? 1 : 0);
