// The catalogue of the engine, which defines every key of a spec and every quantity of a result.

import type { Catalogue, InputKey, InputTable, NamedMaterial, Objective, Quantity, QuantityTable } from "../engine/engine";

let whole: Catalogue;

export function setCatalogue(catalogue: Catalogue): void {
  whole = catalogue;
}
export function inchUnit(unit: string): Catalogue["inchUnits"][string] | undefined {
  return whole.inchUnits[unit];
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

/** Returns the unit that a key with this suffix has, as users read it: "µm" for "um". */
export function unitOfSuffix(suffix: string): string {
  const keys = whole.inputs.flatMap((table) => table.keys);
  return keys.find((key) => key.suffix === suffix)?.unit ?? suffix;
}

export function materials(): NamedMaterial[] {
  return whole.materials;
}

export function objective(name: string): Objective | undefined {
  return whole.objectives.find((one) => one.name === name);
}

/** Maps the name of a table of keys to the tables of results that contain its quantities. A table
 *  that is not listed here belongs to the table of results with the same name. */
const kResultsOf: Record<string, string[]> = {
  material: ["rating"],
  rating_plastic: ["rating"],
  rating_spectrum: ["rating"],
  basic: ["gear"],
  measured: ["gear", "pair"],
  cutter: ["gear"],
  search: ["search.designs"],
};
/** Matches names of keys that users would not understand. Such names contain the end of a range
 *  ("min"), a single letter, a symbol, or a name without its apostrophe. */
const kRaw = /(^| )(min|max|[a-z]|\S*[A-Z0-9]\S*|youngs|poisson|coprime)( |$)/;
const kLongest = 44;

/** Returns the name of a key on the page. If the key sets a quantity, it is the name of this quantity.
 *  Otherwise it is the key in words, for example "normal module" for normal_module_mm. If these words are
 *  unclear, it is the beginning of the meaning of the key, provided that it is short. */
export function wordsOf(table: string, key: InputKey): string {
  const info = (kResultsOf[table] ?? [table])
    .map((name) => quantity(name, key.key))
    .find((one) => one && one.symbol === key.symbol);
  if (info) return info.words;
  const ending = key.suffix && "_" + key.suffix;
  const plain = key.key
    .slice(0, key.key.length - ending.length)
    .replace(/([12])$/, ", gear $1")
    .replaceAll("_", " ")
    .replace(/\bcenter\b/, "centre")
    .replace(/(?<=\w) (circumferential|flank|modules|root)$/, ", $1");
  if (!kRaw.test(plain.replace(/, gear [12]$/, ""))) return plain;
  const meaning = /^.*?(?=[;:(]|, |$)/.exec(key.meaning)?.[0].trim() ?? "";
  if (meaning && meaning.length <= kLongest) return meaning;
  return plain.replace(/^(.*) min$/, "least $1").replace(/^(.*) max$/, "greatest $1");
}
export function wordsAt(table: string, name: string): string {
  const key = inputKey(table, name);
  return key ? wordsOf(table, key) : name.replaceAll("_", " ");
}

/** Returns the range of a key in words, for example "from 1 to 60, usually 14.5 to 30". */
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
