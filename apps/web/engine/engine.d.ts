// The engine in WebAssembly, for a page or a node program.
//
// It contains no formulas: every call passes a spec to the C++ code of `gearwright` and returns the
// result. Rules:
//
//   * No call throws. An error is a `Failed` with the message and the line that the program prints;
//     test `failed(x)` (or look for `error`).
//   * Lengths mm, angles at this interface degrees, by name. Keys of results are those of
//     `gearwright … --json` (docs/spec.md); the catalogue has words, symbol, unit and digits.
//   * Arrays are copies that belong to the caller: transfer them, keep them.
//   * Calls are synchronous and single-threaded: run the engine in a Web Worker. Long work is a
//     `Work`: step it for some milliseconds, look at messages, step again; drop it to cancel.
//   * Everything with `delete()` lives in the module's memory until it is deleted.
//   * A violated contract of the core, which is a defect of Gearwright, is a Failed that names it
//     and requests a report. The object of the call (a session, a work) is then unusable; others
//     can still be used. Only a trap or too deep a recursion stops the module: load the engine
//     again.
//
// Housing frame, rotations, signs: docs/theory/01-frames.md. Gear 1 turns clockwise seen from +z
// for growing `rotation1`, gear 2 as it is driven.

/** An error: the key of the spec, its value, and one sentence. */
export interface Failed {
  error: {
    key: string; // "gear1.normal_module_mm", or "" if the error has no key
    value: string;
    message: string; // the whole sentence, with key and value
    file?: string;
    line?: number; // counted from 1, line of the key (or its table) in the text
    column?: number; // in characters, from 1
    finder?: "search" | "fit" | "identify"; // of `open`: not an error; this verb computes the
                                            // missing numbers
  };
}

/** Every verb that returns JSON for a spec. */
export type Verb = "gear" | "pair" | "measure" | "contact" | "compensate" | "scatter" | "load" | "rate" | "fit" | "identify" | "search";

/** Files that the engine makes. `report` and `json` cover everything in the spec. */
export type FileKind = "stl" | "glb" | "3mf" | "dxf" | "svg" | "step" | "drawing" | "report" | "json";

// ---------------------------------------------------------------------------------- catalogue

/** One key of a spec. */
export interface InputKey {
  key: string; // "helix_angle_deg"
  symbol: string; // "β", may be empty
  kind: "number" | "whole" | "boolean" | "text" | "word" | "table" | "any";
  unit: string; // "mm", "°", "µm", "″", "1/min", … of the key's ending; "" of pure numbers
  suffix: string; // end of the key: "mm", "deg", "um", ""
  // Permitted words; for kinds other than words, words that are permitted in addition.
  words: string[];
  range: {
    lo: number | null; // null: unlimited
    hi: number | null;
    loOpen: boolean; // the limit itself is not permitted
    hiOpen: boolean;
    zero: boolean; // false: 0 is not permitted
    reason: string; // continues the sentence after the range: ", usually 14.5 to 30"
  } | null;
  list: { least: number; most: number; single: boolean } | null; // a list instead of one value
  form: string; // the permitted values as part of a sentence: "a number", "true or false"
  required: boolean;
  needs: string[]; // keys that must also be given
  excludes: string[]; // keys that must not be given together with this one
  tables: string[]; // for a table: names of the possible InputTables
  fallback: string; // value if the key is absent: a value as in the file, or words
  meaning: string; // one sentence, lower case, without the full stop
  also: string[]; // other names that users try: "module", "dp"
  documented: boolean; // false: omit it from forms
}
export interface InputTable {
  name: string; // "gear", "pair", "errors", "rack_circular_arc", …; the file itself is "spec"
  meaning: string;
  keys: InputKey[];
}

/** One quantity of a result. */
export interface Quantity {
  key: string; // in JSON: "tip_diameter_mm"
  words: string; // "tip diameter"
  symbol: string; // "d_a", indices after the underscore; may be empty
  unit: string; // "mm", "°", "µm"; "" of pure numbers
  digits: number; // decimals for users
  group: string; // heading; may be empty
  meaning: string;
  type: "number" | "whole" | "index" | "flag" | "word" | "text" | "record" | "map";
  list: number[]; // lengths of nested lists, 0: any; []: one value
  two: "values" | "gears" | "ends"; // the meaning of two values of a list
  oneOf: string[]; // of a word
  of: string; // for a record: name of its QuantityTable; otherwise ""
  page: boolean; // true if the tables of the report show it
  listing: boolean; // true if the terminal shows it
  percent: boolean; // a fraction of 1; users see 100 times it
  nothing: string; // text for users if there is no value; "" means "–"
  greaterFirst: boolean; // greater values are better
}
export interface QuantityTable {
  name: string; // "gear", "pair", "contact", "contact.positions", "search.designs", "verdict", …
  groups: string[]; // headings in their order
  quantities: Quantity[];
}
/** A row of the shipped table of materials, for the key `name` of [gearN.material]. */
export interface NamedMaterial {
  name: string;
  kind: string; // letters of ISO 6336-5
  hardness_HV: number;
  note: string;
}
export interface Catalogue {
  version: string;
  materials: NamedMaterial[];
  inputs: InputTable[]; // the file itself first
  quantities: QuantityTable[];
}

// ---------------------------------------------------------------------------------- geometry

/** The transverse outline of the whole gear in the section z = 0, in the gear's own frame. */
export interface Section {
  teeth: number; // |z|
  internal: boolean;
  /** x, y, x, y, … counter-clockwise, mm. Closed, so the last point is joined to the first. */
  outline: Float64Array;
  /** Pieces of the outline in order: points from[i] … to[i] inclusive (point indices). The last `to` is
   *  the number of points, which means point 0. */
  pieces: { name: string; tooth: number; land: boolean; from: number; to: number }[];
  /** The bore, or the rim of an internal gear: closed, x, y, …; empty if there is none. */
  bore: Float64Array;
  /** Circles about the axis that the catalogue contains: tip, reference, base, root, form circles,
   *  working pitch. `key` is that of the quantity, "base_diameter_mm". */
  circles: { key: string; symbol: string; words: string; radius: number }[];
  toleranceMm: number; // greatest distance of a chord from the exact curve
}

/** A closed mesh in the gear's own frame, for three.js buffers. Normals are those of the exact surface. */
export interface Mesh {
  positions: Float32Array; // x, y, z, …, mm
  normals: Float32Array;
  indices: Uint32Array;
  toleranceMm: number;
}

/** Geometry between the gears in the housing frame, mm. An array is empty if there is no such geometry. */
export interface MeshLines {
  kind: "parallel_external" | "parallel_internal" | "crossed";
  centerDistance: number;
  shaftAngleDeg: number;
  lineOfAction: Float64Array; // x, y, z of both ends (base tangent points)
  trailingLine: Float64Array; // of the non-working flanks
  pathOfContact: Float64Array; // x, y, z of A and E, or of the points of a curved path
  points: { name: "A" | "B" | "C" | "D" | "E"; x: number; y: number; z: number }[];
}

/** Columns by the keys of contact.positions; NaN or "" if there is no value. Lists of n numbers are
 *  interleaved, with `width[key]` = n. For a record the keys are "ellipse.semi_major_mm". */
export interface ContactCurve {
  n: number;
  columns: Record<string, Float64Array | string[]>;
  width: Record<string, number>;
  peakToPeakArcsec: number; // NaN if nothing touches
  meanSlope: number;
  harmonicsArcsec: Float64Array;
  contactLost: boolean;
  words: string; // summary in words, as in the report
}

/** A flank as a raster. Rows are diameters, and columns are heights z in the gear's own frame. */
export interface FlankRaster {
  diameter: Float64Array; // mm, growing
  height: Float64Array; // mm, growing
  gap: Float64Array; // mm, [row * columns + column]; Infinity where the mating gear never reaches
}

/** The distribution of the peak-to-peak transmission error over tolerances. */
export interface Scattered {
  percentiles: { percent: number; arcsec: number }[]; // those of [scatter]; empty if contact is lost
  figures: Figure[]; // "scatter-te", its cumulative curve, "scatter-play", "scatter-pattern1" and 2
  samples?: number; // of complete contacts; absent for an estimate
  events?: { words: string; count: number; of: number; upper: number }[]; // upper limit of the share
}

/** The x1–x2 chart of this pair of tooth numbers: exact borders of the search's limits. */
export interface ShiftRegion {
  point: [number, number]; // the shifts of the spec itself
  inside: boolean;
  /** Distance of the point from the nearest border, modules; < 0 outside. */
  margin: number;
  /** The border that limits the point if it is outside or at a border; otherwise "". */
  stoppedBy: string;
  area: number; // modules²
  pieces: { border: string; points: Float64Array }[][]; // per piece its borders, x1, x2, …
  borders: Record<string, string>; // words of every border that occurs: "contact ratio 1.2"
  window: [number, number, number, number]; // x1 lo, x1 hi, x2 lo, x2 hi: lower and upper limits
  chosen: [number, number] | null; // point that the search would choose
  whatKills: string; // the first limit that leaves no region; "" if there is a region
  figure: Figure | null; // if a view was given and some shifts are left
}

// ---------------------------------------------------------------------------------- long work

/** Work that is done in steps, so that messages can be handled between them. */
export interface Work<T> {
  /** Works for about this number of milliseconds. `done` of `of` steps are complete; they take unequal
   *  times. */
  step(milliseconds: number): { done: number; of: number; finished: boolean } | Failed;
  /** The result. Before the end, the partial result, or null. */
  result(): T | Failed | null;
  /** Figures of the result: one for a map; for teeth under load, those of the torque with this index. */
  figures(torque: number, width: number): Figure[] | Failed;
  delete(): void;
}

export interface SearchResult {
  json: string; // exactly what `gearwright search SPEC --json` prints; "" before the end
  tested: number;
  feasible: number;
}
export interface ErrorMap {
  x: Float64Array; // in the unit of the key
  y: Float64Array;
  peakToPeakArcsec: Float64Array; // [iy * nx + ix]; NaN if nothing touches, or if not yet computed
}

/** Teeth under load. */
export interface LoadResult {
  json: string; // what `gearwright load SPEC --json` prints, without probes
}

// ---------------------------------------------------------------------------------- figures

/** A figure as in the report: its picture and caption (gears in section have no caption), and the data
 *  of its curves. The group of class "plot" has the scale in `data-x` and `data-y`, "lo hi from to":
 *  values and their px. */
export interface Figure {
  id: string; // "te", "spectrum", "bearing1", "pressure2"
  html: string; // a `figure` element; its classes are those of figure_style.css
  data: {
    title: string;
    description: string;
    x: { words: string; unit: string };
    y: { words: string; unit: string };
    curves: { name: string; points: [number | null, number | null][] }[];
    circles?: { gear: 0 | 1; name: string; center: [number, number]; radius: number }[];
    points?: { name: string; at: [number, number] }[]; // letters of a mesh
  };
}
/** Options of the figures of contact. */
export interface ContactView {
  width: number; // px, of a figure
  positions: number; // per pitch
  index: number; // of the position whose gap is shown on the flanks
  patterns: [FlankRaster, FlankRaster] | null; // as `pattern` made them
  curves: boolean; // false: only the flanks
}

/** Options of the figure of the gears in section. */
export interface MeshView {
  frame: "whole" | "mesh" | "flank"; // all of the gears, their mesh, the path of contact
  width: number; // px
  height: number;
  window: [number, number, number, number] | null; // x0, x1, y0, y1 in mm, in place of the frame's
  bodies: boolean; // only the bodies
  name: string; // of the picture and its shapes, unique in the page
}

/** Options of the figure of the profile shifts. */
export interface ShiftView {
  width: number; // px
  aspect: number; // of the plot, width over height
  window: [number, number, number, number] | null; // visible x1 and x2 range; null: the range of
                                                   // the region
}

/** Designs as dots, in order, over two of their quantities, which must be finite. */
export interface DesignDots {
  width: number; // px
  tall: number; // height of the plot over its width
  x: { words: string; unit: string; values: number[] };
  y: { words: string; unit: string; values: number[] };
  styles: string[]; // "dot-front", "dot-design"; " taken" is added for the chosen one
  names: string[]; // of the designs; shown at the pointer with the values
}

// ---------------------------------------------------------------------------------- a session

/** A spec that is read and solved, with everything that a page shows while the user changes it. */
export interface Session {
  readonly gears: number; // 1 or 2
  readonly hasPair: boolean;
  /** Returns the output of `gearwright VERB SPEC --json` with its line feed, or a Failed as JSON. */
  json(verb: Verb): string;
  /** Outline of gear 1 or 2 within the tolerance (default 0.001 mm). */
  section(gear: 1 | 2, toleranceMm?: number): Section | Failed;
  /** Solid of gear 1 or 2 (default 0.02 mm). */
  mesh(gear: 1 | 2, toleranceMm?: number): Mesh | Failed;
  lines(): MeshLines | Failed;
  /** The gears in section, mm. The shapes of a gear are `use` elements with `data-gear`, about the
   *  gear's position. */
  meshFigure(view: MeshView): Figure | Failed;
  /** Transformation from gear frame to housing, as a column-major 4×4 matrix for three.js, at a rotation
   *  of gear 1, with the errors of the spec. Gear 2 is in the position in which its working flanks
   *  touch. Without contact, or if `nominal`, its position follows from the ratio, in the middle of the
   *  backlash at rest. */
  pose(gear: 1 | 2, rotation1Deg: number, nominal?: boolean): Float64Array | Failed;
  /** Contact at `positions` per pitch, starting half a pitch before the centre line, with the errors and
   *  modifications of the spec. */
  contactCurve(positions: number): ContactCurve | Failed;
  /** Transmission error, spectrum and both flanks. Figures that do not exist are omitted. */
  contactFigures(view: ContactView): Figure[] | Failed;
  /** One position as an object with the keys of contact.positions. `kind` is "none" if there is no
   *  contact. */
  contactPoint(rotation1Deg: number): Record<string, unknown> | Failed;
  /** Gap on the flank of gear 1 of tooth pair k (`tooth` of a position) at one position. */
  gapMap(rotation1Deg: number, k: number, rows?: number, columns?: number): FlankRaster | Failed;
  /** Least gap over a mesh on both flanks, which is the pattern that marking compound would show. */
  pattern(positions: number, rows?: number, columns?: number): Work<[FlankRaster, FlankRaster]> | Failed;
  /** Peak-to-peak transmission error over two errors (keys of [errors]). */
  errorMap(x: ErrorAxis, y: ErrorAxis, positions?: number): Work<ErrorMap> | Failed;
  /** Teeth under the torques of [load]. `accuracy` replaces that of the spec. The compliance of the
   *  teeth is kept, so the next torque, error or modification takes a fraction of the time. */
  load(accuracy?: "draft" | "full"): Work<LoadResult> | Failed;
  /** The effect of the tolerances of [scatter] on the peak-to-peak transmission error: an estimate to
   *  first order, in a fraction of a second. `width` of a figure, px. */
  scatterSketch(width: number): Scattered | Failed;
  /** The same by complete contacts of at most 1024 samples, as many as take about three seconds. */
  scatter(width: number): Scattered | Failed;
  shiftRegion(view?: ShiftView | null): ShiftRegion | Failed;
  /** The bytes of a file of gear 1 or 2, or (0) of the pair as mounted. report and json require gear 0. */
  file(kind: FileKind, gear: 0 | 1 | 2, toleranceMm?: number): Uint8Array | Failed;
  delete(): void;
}
export interface ErrorAxis {
  key: string; // "crossing_deg"
  from: number;
  to: number;
  n: number;
}

export interface SearchSession extends Work<SearchResult> {
  readonly trials: number;
  /** Rows of search.designs so far, best first, as JSON text. */
  best(most: number): string;
  /** A design (counted from 1) of the finished search as TOML, to be opened as the design on screen. */
  take(design: number): string | Failed;
  /** The same page as the program's search report. */
  report(): Uint8Array | Failed;
}

// ---------------------------------------------------------------------------------- the engine

export interface Engine {
  version(): string;
  /** Returns the output of `gearwright VERB --json`, byte for byte; an error is the JSON of a `Failed`.
   *  The text is JSON if it begins with a brace, otherwise TOML. `search` runs to its end here. */
  run(verb: Verb, spec: string): string;
  /** JSON Schema of specs or results, as `gearwright schema` prints it. */
  schema(of: "spec" | "result"): string;
  /** JSON text of a `Catalogue`. */
  catalogue(): string;
  /** Converts a spec from JSON to TOML, or from TOML to JSON, with the same tree. Comments are lost. */
  toToml(json: string): string | Failed;
  toJson(toml: string): string | Failed;
  /** Returns the TOML text with one key set ("gear1.profile_shift", value as JSON text: "0.25",
   *  "\"left\"") or, with "null", removed. Comments and order are kept. */
  edit(toml: string, key: string, valueJson: string): string | Failed;
  open(spec: string): Session | Failed;
  openSearch(spec: string, most?: number): SearchSession | Failed;
  designs(of: DesignDots): Figure | Failed;
}

export function failed(x: unknown): x is Failed;

export interface EngineOptions {
  /** The location of engine.wasm; default: next to the script. */
  locateFile?(name: string): string;
  /** The bytes of the module, for one self-contained file. */
  wasmBinary?: ArrayBuffer | Uint8Array;
}
/** `import createEngine from "./engine.js"` (ES6: page, worker) */
export default function createEngine(options?: EngineOptions): Promise<Engine>;
