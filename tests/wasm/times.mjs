// Prints the least time of each call of the engine over many calls: node tests/wasm/times.mjs [EXAMPLE …]
import { readFileSync } from "node:fs";
import path from "node:path";
import { loadEngine, source } from "./engine.mjs";

const begin = performance.now();
const { engine, failed } = await loadEngine();
console.log(`loaded in ${(performance.now() - begin).toFixed(0)} ms`);

function best(f, seconds = 0.4) {
  let least = Infinity;
  const end = performance.now() + 1000 * seconds;
  for (let i = 0; i < 3 || performance.now() < end; ++i) {
    const t = performance.now();
    f();
    least = Math.min(least, performance.now() - t);
  }
  return `${least.toFixed(2).padStart(9)} ms`;
}

const names = process.argv.slice(2);
for (const name of names.length ? names : ["helical_pair", "misaligned_pair", "crossed_pair", "ring_pair", "circular_arc_drive"]) {
  const text = readFileSync(path.join(source, "examples", `${name}.toml`), "utf8");
  const s = engine.open(text);
  if (failed(s)) throw new Error(s.error.message);
  console.log(name);
  const row = (what, f) => console.log(`  ${what.padEnd(28)}${best(f)}`);
  row("open, pair as JSON", () => {
    const t = engine.open(text);
    JSON.parse(t.json("pair"));
    t.delete();
  });
  row("text to tree", () => engine.toJson(text));
  row("mesh of both, 20 µm", () => [1, 2].map((g) => s.mesh(g)));
  row("contact curve, 64", () => s.contactCurve(64));
  row("contact point", () => s.contactPoint(1.5));
  row("poses of both", () => [1, 2].map((g) => s.pose(g, 1.5)));
  row("gap map 33 x 65", () => s.gapMap(0, 0));
  row("pattern 64, 33 x 65", () => {
    const w = s.pattern();
    if (!failed(w)) while (!w.step().finished);
  });
  row("chart of shifts", () => s.shiftRegion());
  s.delete();
}
