// Plans the rows of the form from the catalogue of the engine. For each table of the spec, the form shows the
// most important keys and the keys that the text contains. It shows the other keys after a click on "more".

import type { InputKey } from "../../engine/engine";
import { inputs } from "../catalogue";
import { at, hasRack } from "../workbench";
import type { Json } from "../engine_worker";

/** A section of the form for one table. Each row has one field, or one field for each gear. */
export interface Section {
  id: string; // "gear", "gear.bore", "pair"
  title: string;
  meaning: string;
  table: string; // name of the table in the catalogue
  places: string[]; // the table in the spec: ["gear1.bore", "gear2.bore"], ["pair"]
  rows: InputKey[];
  more: InputKey[]; // shown after a click on "more"
  present: boolean; // true if the text contains the table
}

const kAlways: Record<string, string[]> = {
  gear: [
    "teeth",
    "normal_module_mm",
    "normal_pressure_angle_deg",
    "helix_angle_deg",
    "profile_shift",
    "thickness_allowance_mm",
    "face_width_mm",
    "tip_diameter_mm",
    "rack",
  ],
  pair: ["center_distance_mm", "shaft_angle_deg", "backlash_mm"],
  errors: ["center_distance_mm", "crossing_deg", "intersecting_deg", "axial_mm"],
  modifications: ["tip_relief_um", "tip_relief_start_mm", "lead_crowning_um", "profile_crowning_um"],
  bore: ["diameter_mm", "keyway", "keyway_width_mm", "keyway_depth_mm"],
  rack_bar: ["teeth", "face_width_mm", "height_mm", "thickness_allowance_mm"],
  search: ["ratio", "pinion_teeth", "modules_mm", "center_distance_mm", "helix_angle_deg", "objective"],
  contact: ["positions", "marking_mm"],
};
/** The keys of [pair] that a rack and its pinion have. */
const kOfRackPair = ["center_distance_mm", "speed_rpm"];
const kTitles: Record<string, string> = {
  gear: "Gears",
  errors: "Errors of mounting and teeth",
  compensate: "Corrections",
  basic: "Gear by its base cylinder",
  mounting: "Shaft and bearings",
  spectrum: "Load spectrum",
  plastic: "Plastics",
  tolerance: "Tolerances",
  measure: "Measuring",
  cut_by: "Pinion cutter",
  rack: "Basic rack",
  rack_bar: "Rack as gear 2",
  measured: "Readings",
  drawing: "Title block",
  scatter: "Scatter of tolerances",
};

/** Returns the title of a section. It is the entry of kTitles, or the name of the table with a capital letter. */
function titleOf(name: string): string {
  return kTitles[name] ?? name.charAt(0).toUpperCase() + name.slice(1).replaceAll("_", " ");
}

/** Returns the name of the table for a key. The table of a rack depends on the kind of the rack. */
function tableAt(key: InputKey, value: Json | undefined): string {
  if (key.tables.length < 2) return key.tables[0] ?? "";
  const kind = at(value ?? null, "kind");
  const named = key.tables.find(
    (name) => typeof kind === "string" && kind !== "" && name.endsWith("_" + kind),
  );
  return named ?? key.tables[0]!;
}

function isTable(value: Json | undefined): boolean {
  return value !== null && typeof value === "object" && !Array.isArray(value);
}

function section(id: string, name: string, table: string, places: string[], spec: Json): Section | null {
  const list = inputs(table);
  if (!list) return null;
  const always = kAlways[table] ?? [];
  const stands = (key: InputKey) => places.some((place) => at(spec, place + "." + key.key) !== undefined);
  const plain = list.keys.filter(
    (key) => key.documented && key.kind !== "any" && !isTable(firstOf(spec, places, key)),
  );
  // A key that accepts only a table has its own section.
  const rows = plain.filter(
    (key) => (key.kind !== "table" || key.words.length > 0) && (always.includes(key.key) || stands(key)),
  );
  const more = plain.filter(
    (key) => key.kind !== "table" && !rows.includes(key) && !/^(left|right)_/.test(key.key),
  );
  rows.sort((a, b) => place(always, a) - place(always, b));
  const present = places.some((where) => at(spec, where) !== undefined);
  return {
    id,
    title: titleOf(name),
    meaning: list.meaning,
    table,
    places,
    rows,
    more,
    present,
  };
}
function place(always: string[], key: InputKey): number {
  const index = always.indexOf(key.key);
  return index < 0 ? 99 : index;
}
function firstOf(spec: Json, places: string[], key: InputKey): Json | undefined {
  for (const where of places) {
    const value = at(spec, where + "." + key.key);
    if (value !== undefined) return value;
  }
  return undefined;
}

export function planOf(spec: Json): Section[] {
  const searching = at(spec, "search") !== undefined;
  const rack = hasRack(spec);
  const gears = !rack && (at(spec, "gear2") !== undefined || searching) ? ["gear1", "gear2"] : ["gear1"];
  const sections: (Section | null)[] = [];
  const add = (one: Section | null) => sections.push(one);
  if (searching) add(section("search", "search", "search", ["search"], spec));
  // A search computes the gears, and the gears of a drive have other tables, so the form shows only
  // the gears that the text contains.
  const drive = ["planetary", "stage", "drive"].some((name) => at(spec, name) !== undefined);
  const fixed = searching || drive ? gears.filter((gear) => at(spec, gear) !== undefined) : gears;
  const gear = section("gear", "gear", "gear", fixed, spec);
  if (gear && (searching || drive))
    gear.rows = gear.rows.filter((key) =>
      fixed.some((where) => at(spec, `${where}.${key.key}`) !== undefined),
    );
  if (fixed.length) add(gear);
  if (rack) add(section("rack_bar", "rack_bar", "rack_bar", ["gear2"], spec));
  const pair = gears.length > 1 || rack ? section("pair", "pair", "pair", ["pair"], spec) : null;
  if (pair && rack) for (const list of ["rows", "more"] as const) pair[list] = pair[list].filter((key) => kOfRackPair.includes(key.key));
  if (!searching) add(pair);
  for (const key of inputs("gear")?.keys ?? []) {
    if (key.kind !== "table") continue;
    const holders = fixed.map((gear) => `${gear}.${key.key}`);
    const tables = holders.filter((where) => isTable(at(spec, where)));
    const offered = !searching && !drive && (key.key === "bore" || key.key === "modifications");
    if (!tables.length && !offered) continue;
    const name = tableAt(key, tables.length ? at(spec, tables[0]!) : undefined);
    add(section("gear." + key.key, key.key, name, offered ? holders : tables, spec));
    for (const inner of inputs(name)?.keys ?? []) {
      if (inner.kind !== "table") continue;
      const deeper = tables
        .map((where) => `${where}.${inner.key}`)
        .filter((where) => isTable(at(spec, where)));
      if (deeper.length)
        add(
          section(
            `gear.${key.key}.${inner.key}`,
            inner.key,
            tableAt(inner, at(spec, deeper[0]!)),
            deeper,
            spec,
          ),
        );
    }
  }
  for (const { key: name, tables } of inputs("spec")?.keys ?? []) {
    if (!tables.length || ["gear1", "gear2", "pair", "search"].includes(name)) continue;
    const shown = at(spec, name) !== undefined || (name === "errors" && (gears.length > 1 || rack) && !searching);
    if (shown) add(section(name, name, tables[0]!, [name], spec));
  }
  return sections.filter(
    (one): one is Section => one !== null && (one.rows.length > 0 || one.more.length > 0),
  );
}

/** Two plans with the same signature have the same rows and differ only in values. */
export function signatureOf(plan: Section[]): string {
  return plan
    .map((one) => [one.id, one.table, one.places, one.rows.map((row) => row.key)].join(":"))
    .join("|");
}
