// The catalogue of the engine: every key of a spec and every quantity of a result, said once there.

import type { Catalogue, InputKey, InputTable, NamedMaterial, Quantity, QuantityTable } from "../engine/engine";

let whole: Catalogue;

export function setCatalogue(catalogue: Catalogue): void {
  whole = catalogue;
}
export function version(): string {
  return whole.version;
}
export function inputs(name: string): InputTable | undefined {
  return whole.inputs.find((table) => table.name === name);
}
export function quantities(name: string): QuantityTable | undefined {
  return whole.quantities.find((table) => table.name === name);
}
export function quantity(table: string, key: string): Quantity | undefined {
  return quantities(table)?.quantities.find((one) => one.key === key);
}
export function inputKey(table: string, key: string): InputKey | undefined {
  return inputs(table)?.keys.find((one) => one.key === key);
}

/** Rows of the shipped table of materials. */
export function materials(): NamedMaterial[] {
  return whole.materials;
}

/** What a key is called on the page: "normal module" of normal_module_mm. */
export function wordsOf(key: InputKey): string {
  let words = key.key;
  if (key.suffix && words.endsWith("_" + key.suffix)) words = words.slice(0, -key.suffix.length - 1);
  return words
    .replace(/([12])$/, " $1")
    .replaceAll("_", " ")
    .replace("center", "centre");
}

/** The range of a key as a sentence: "between 1 and 60, usually 14.5 to 30". */
export function rangeOf(key: InputKey): string {
  const range = key.range;
  if (!range) return "";
  const { lo, hi } = range;
  const beyond = (end: number | null) => end === null || Math.abs(end) >= 1e9;
  const from = beyond(lo) ? "" : (range.loOpen ? "more than " : "at least ") + lo;
  const to = beyond(hi) ? "" : (range.hiOpen ? "less than " : "at most ") + hi;
  const both =
    from && to && !range.loOpen && !range.hiOpen
      ? `from ${lo} to ${hi}`
      : [from, to].filter(Boolean).join(", ");
  return both + (range.reason ?? "");
}
