// The engine in WebAssembly, for a page or a node program.
//
// It contains no formulas: every call passes a spec to the C++ code of `gearwright` and returns the
// result. Rules:
//
//   * No call throws. An error is a `Failed` with the message and the line that the program prints.
//     `failed(x)` tests a result for an error.
//   * Lengths are in mm. Angles at this interface are in degrees, as their names show. Keys of results are
//     those of `gearwright … --json` (docs/spec.md). The catalogue has words, symbol, unit and digits.
//   * Arrays are copies that belong to the caller, who may transfer or keep them.
//   * Calls are synchronous and single-threaded, so the engine should run in a Web Worker. Long work is a
//     `Work`. Call its step() for some milliseconds, handle messages, and repeat; delete it to cancel.
//   * An object with `delete()` stays in the memory of the module until it is deleted.
//   * A violated contract of the core is a defect of Gearwright. It becomes a Failed that names the contract
//     and requests a report. The object of the call (a session, a work) is then unusable, but other objects
//     can still be used. Only a trap or too deep a recursion stops the module. The engine must then be
//     loaded again.
//
// Housing frame, rotations and signs are described in docs/theory/01-frames.md. Gear 1 turns clockwise seen
// from +z when `rotation1` increases, and gear 2 turns accordingly.

/** An error: the key of the spec, its value, and one sentence. */
export interface Failed {
  error: {
    key: string; // "gear1.normal_module_mm", or "" if the error has no key
    value: string;
    message: string; // the whole sentence, with key and value
    file?: string;
    line?: number; // line of the key, or of its table, in the text; counted from 1
    column?: number; // in characters, counted from 1
    // Only from `open`: the spec is incomplete, and this verb computes the missing numbers.
    finder?: "search" | "fit" | "identify";
  };
}

/** Every verb that returns JSON for a spec. */
export type Verb = "gear" | "pair" | "measure" | "contact" | "compensate" | "propose" | "scatter" | "load" | "rate" | "fit" | "identify" | "search";

/** Files that the engine makes. `report` and `json` cover everything in the spec. */
export type FileKind = "stl" | "glb" | "3mf" | "dxf" | "svg" | "step" | "drawing" | "report" | "json";

// ---------------------------------------------------------------------------------- catalogue

/** One key of a spec. */
export interface InputKey {
  key: string; // "helix_angle_deg"
  symbol: string; // "β", may be empty
  kind: "number" | "whole" | "boolean" | "text" | "word" | "table" | "any";
  unit: string; // unit of the key's suffix, "mm", "°", "µm", "″", "1/min", …; "" for pure numbers
  suffix: string; // suffix of the key: "mm", "deg", "um", ""
  // Permitted words. If the kind is not "word", these are permitted in addition.
  words: string[];
  range: {
    lo: number | null; // null if there is no limit
    hi: number | null;
    loOpen: boolean; // true if the limit itself is not permitted
    hiOpen: boolean;
    zero: boolean; // false if 0 is not permitted
    reason: string; // continues the sentence after the range: ", usually 14.5 to 30"
  } | null;
  list: { least: number; most: number; single: boolean } | null; // for a list instead of one value
  form: string; // the permitted values as part of a sentence: "a number", "true or false"
  required: boolean;
  needs: string[]; // keys that must also be given
  excludes: string[]; // keys that must not be given together with this one
  tables: string[]; // for a table: names of the possible InputTables
  fallback: string; // the value if the key is absent, as in the file, or words
  meaning: string; // one sentence, lower case, without the full stop
  also: string[]; // other names that users may try: "module", "dp"
  documented: boolean; // false if forms should omit the key
}
export interface InputTable {
  name: string; // "gear", "pair", "errors", "rack_circular_arc", …; the file itself is "spec"
  meaning: string;
  keys: InputKey[];
}

/** One quantity of a result. */
export interface Quantity {
  key: string; // key in JSON: "tip_diameter_mm"
  words: string; // "tip diameter"
  symbol: string; // "d_a", with indices after the underscore; may be empty
  unit: string; // "mm", "°", "µm"; "" for pure numbers
  digits: number; // decimals for users
  group: string; // heading; may be empty
  meaning: string;
  type: "number" | "whole" | "index" | "flag" | "word" | "text" | "record" | "map";
  list: number[]; // lengths of nested lists, 0 for any length; [] for one value
  two: "values" | "gears" | "ends"; // the meaning of two values of a list
  oneOf: string[]; // possible words
  of: string; // for a record: name of its QuantityTable; otherwise ""
  page: boolean; // true if the tables of the report show the quantity
  listing: boolean; // true if the terminal shows the quantity
  percent: boolean; // true for a fraction of 1 that is shown to users times 100
  nothing: string; // text for users if there is no value; "" means "–"
  greaterFirst: boolean; // true if greater values are better
}
export interface QuantityTable {
  name: string; // "gear", "pair", "contact", "contact.positions", "search.designs", "verdict", …
  groups: string[]; // headings in their order
  quantities: Quantity[];
}
/** A row of the table of known materials, for the key `name` of [gearN.material]. */
export interface NamedMaterial {
  name: string;
  kind: string; // letters of ISO 6336-5
  hardness_HV: number;
  note: string;
}
export interface Catalogue {
  version: string;
  materials: NamedMaterial[];
  inputs: InputTable[]; // the table of the file itself comes first
  quantities: QuantityTable[];
}

// ---------------------------------------------------------------------------------- geometry

/** The transverse outline of the whole gear in the section z = 0, in the gear's own frame. */
export interface Section {
  teeth: number; // |z|
  internal: boolean;
  /** x, y, x, y, … in mm, counter-clockwise. The outline is closed, so the last point is joined to the first. */
  outline: Float64Array;
  /** Pieces of the outline in order. A piece consists of the points from[i] … to[i] (point indices, both included).
   *  The last `to` is the number of points, which means point 0. */
  pieces: { name: string; tooth: number; land: boolean; from: number; to: number }[];
  /** The bore, or the rim of an internal gear, as a closed outline x, y, …. It is empty if there is none. */
  bore: Float64Array;
  /** Circles about the axis that the catalogue contains: tip, reference, base, root and form circles and the
   *  working pitch circle. `key` is the key of the quantity, "base_diameter_mm". */
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
  lineOfAction: Float64Array; // x, y, z of both ends, which are the base tangent points
  trailingLine: Float64Array; // line of action of the non-working flanks
  pathOfContact: Float64Array; // x, y, z of A and E, or of the points of a curved path
  points: { name: "A" | "B" | "C" | "D" | "E"; x: number; y: number; z: number }[];
}

/** Columns by the keys of contact.positions. A missing value is NaN or "". Lists of n numbers are
 *  interleaved, and `width[key]` is n. The members of a record have keys like "ellipse.semi_major_mm". */
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

/** A raster of a flank. Rows are diameters, and columns are heights z in the gear's own frame. */
export interface FlankRaster {
  diameter: Float64Array; // mm, ascending
  height: Float64Array; // mm, ascending
  gap: Float64Array; // mm, [row * columns + column]; Infinity if the mating gear never reaches the point
}

/** The distribution of the peak-to-peak transmission error over tolerances. */
export interface Scattered {
  percentiles: { percent: number; arcsec: number }[]; // percentiles requested in [scatter]; empty if contact is lost
  figures: Figure[]; // "scatter-te" (histogram), its cumulative curve, "scatter-play", "scatter-pattern1" and 2
  samples?: number; // number of complete contacts; absent for an estimate
  events?: { words: string; count: number; of: number; upper: number }[]; // upper: upper limit of the share
}

/** The x1–x2 chart for the tooth numbers of this pair, with the exact borders of the search's limits. */
export interface ShiftRegion {
  point: [number, number]; // the profile shifts of the spec
  inside: boolean;
  /** Distance of the point from the nearest border in modules. It is negative outside the region. */
  margin: number;
  /** The border that limits the point, if the point is outside the region or at a border; otherwise "". */
  stoppedBy: string;
  area: number; // modules²
  pieces: { border: string; points: Float64Array }[][]; // each piece is a list of its borders; points x1, x2, …
  borders: Record<string, string>; // words for every border that occurs: "contact ratio 1.2"
  window: [number, number, number, number]; // x1 lo, x1 hi, x2 lo, x2 hi: the lower and upper limits
  chosen: [number, number] | null; // the point that a search would choose
  whatKills: string; // the first limit that leaves no region; "" if there is a region
  figure: Figure | null; // null if no view was given
}

// ---------------------------------------------------------------------------------- long work

/** Work that is done in steps, so that messages can be handled between them. */
export interface Work<T> {
  /** Works for about this number of milliseconds. `done` of `of` steps are then complete. The steps may take
   *  different times. */
  step(milliseconds: number): { done: number; of: number; finished: boolean } | Failed;
  /** The result. Before the end of the work it is a partial result or null. */
  result(): T | Failed | null;
  /** Figures of the result. A map has one figure. Teeth under load have those of the torque with this index. */
  figures(torque: number, width: number): Figure[] | Failed;
  delete(): void;
}

export interface SearchResult {
  json: string; // exactly what `gearwright search SPEC --json` prints; "" before the end
  tested: number;
  feasible: number;
}
export interface ErrorMap {
  x: Float64Array; // values in the unit of the key
  y: Float64Array;
  peakToPeakArcsec: Float64Array; // [iy * nx + ix]; NaN if nothing touches or the value is not yet computed
}

/** Teeth under load. */
export interface LoadResult {
  json: string; // what `gearwright load SPEC --json` prints, without probes
}

// ---------------------------------------------------------------------------------- figures

/** A figure as in the report: its picture and caption (gears in section have no caption), and the data
 *  of its curves. The group of class "plot" has the scales of its axes in `data-x` and `data-y`. Each is
 *  "lo hi from to", in which lo and hi are values and from and to their positions in px. */
export interface Figure {
  id: string; // name, "te", "spectrum", "bearing1", "pressure2"
  html: string; // a `figure` element; its classes are those of figure_style.css
  data: {
    title: string;
    description: string;
    x: { words: string; unit: string };
    y: { words: string; unit: string };
    curves: { name: string; points: [number | null, number | null][] }[];
    circles?: { gear: 0 | 1; name: string; center: [number, number]; radius: number }[];
    points?: { name: string; at: [number, number] }[]; // named points of a mesh, such as A to E
  };
}
/** Options of the figures of contact. */
export interface ContactView {
  width: number; // px, width of a figure
  positions: number; // number per pitch
  index: number; // index of the position whose gap is shown on the flanks
  patterns: [FlankRaster, FlankRaster] | null; // the result of `pattern`
  curves: boolean; // false if only the flanks are drawn
}

/** Options of the figure of the gears in section. */
export interface MeshView {
  frame: "whole" | "mesh" | "flank"; // all of the gears, their mesh, or the path of contact
  width: number; // px
  height: number;
  window: [number, number, number, number] | null; // x0, x1, y0, y1 in mm; replaces the window of the frame
  bodies: boolean; // true if only the bodies are drawn
  name: string; // name of the picture and its shapes, unique in the page
}

/** Options of the figure of the profile shifts. */
export interface ShiftView {
  width: number; // px
  aspect: number; // width over height of the plot
  window: [number, number, number, number] | null; // visible range of x1 and x2; null for the range of
                                                   // the region
}

/** Designs as dots, in order, over two of their quantities, which must be finite. */
export interface DesignDots {
  width: number; // px
  tall: number; // height over width of the plot
  x: { words: string; unit: string; values: number[] };
  y: { words: string; unit: string; values: number[] };
  styles: string[]; // "dot-front" or "dot-design"; " taken" is added for the chosen design
  names: string[]; // names of the designs, which the pointer shows with the values
}

// ---------------------------------------------------------------------------------- a session

/** A spec that is read and solved, and all results that a page shows while the user changes the spec. */
export interface Session {
  readonly gears: number; // 1 or 2
  readonly hasPair: boolean;
  /** Returns the output of `gearwright VERB SPEC --json` with its line feed, or a Failed as JSON. */
  json(verb: Verb): string;
  /** The outline of gear 1 or 2 within the tolerance (default 0.001 mm). */
  section(gear: 1 | 2, toleranceMm?: number): Section | Failed;
  /** The solid of gear 1 or 2 within the tolerance (default 0.02 mm). */
  mesh(gear: 1 | 2, toleranceMm?: number): Mesh | Failed;
  lines(): MeshLines | Failed;
  /** The gears in section, in mm. The shapes of a gear are `use` elements with `data-gear`, relative to the
   *  position of the gear. */
  meshFigure(view: MeshView): Figure | Failed;
  /** The transformation from the frame of a gear to the housing at a rotation of gear 1, with the errors of
   *  the spec. It is a column-major 4×4 matrix for three.js. Gear 2 is in the position in which its working
   *  flanks touch. Without contact, or if `nominal`, its position follows from the gear ratio, and at rest it
   *  is in the middle of the backlash. */
  pose(gear: 1 | 2, rotation1Deg: number, nominal?: boolean): Float64Array | Failed;
  /** The contact at `positions` per pitch under the errors and modifications of the spec. The first position is
   *  half a pitch before the centre line. */
  contactCurve(positions: number): ContactCurve | Failed;
  /** Figures of the transmission error, the spectrum and both flanks. Figures that do not exist are omitted. */
  contactFigures(view: ContactView): Figure[] | Failed;
  /** The contact at one position as an object with the keys of contact.positions. Without contact, `kind` is
   *  "none". */
  contactPoint(rotation1Deg: number): Record<string, unknown> | Failed;
  /** The gap on the flank of gear 1 at one position, for tooth pair k (`tooth` of a position). */
  gapMap(rotation1Deg: number, k: number, rows?: number, columns?: number): FlankRaster | Failed;
  /** The least gap during a mesh on both flanks. It shows the pattern of marking compound. */
  pattern(positions: number, rows?: number, columns?: number): Work<[FlankRaster, FlankRaster]> | Failed;
  /** The peak-to-peak transmission error over two errors, which are keys of [errors]. */
  errorMap(x: ErrorAxis, y: ErrorAxis, positions?: number): Work<ErrorMap> | Failed;
  /** Teeth under the torques of [load]. `accuracy` replaces the accuracy in the spec. The compliance of the
   *  teeth is kept, so the next torque, error or modification takes much less time. */
  load(accuracy?: "draft" | "full"): Work<LoadResult> | Failed;
  /** The effect of the tolerances of [scatter] on the peak-to-peak transmission error. This is an estimate to
   *  first order, which takes a fraction of a second. `width` is that of a figure in px. */
  scatterSketch(width: number): Scattered | Failed;
  /** The same effect from complete contacts. There are at most 1024 samples, as many as take about three seconds. */
  scatter(width: number): Scattered | Failed;
  shiftRegion(view?: ShiftView | null): ShiftRegion | Failed;
  /** The bytes of a file of gear 1 or 2, or for 0 of the pair as mounted. report and json require gear 0. */
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
  /** The designs found so far, best first, as JSON text with rows of search.designs. */
  best(most: number): string;
  /** A design of the finished search, counted from 1, as TOML. It can be opened as the design on screen. */
  take(design: number): string | Failed;
  /** The same page as the search report of the program. */
  report(): Uint8Array | Failed;
}

// ---------------------------------------------------------------------------------- the engine

export interface Engine {
  version(): string;
  /** Returns the output of `gearwright VERB --json`, byte for byte. An error is the JSON of a `Failed`.
   *  The text is JSON if it begins with a brace, otherwise TOML. `search` runs to its end in this call. */
  run(verb: Verb, spec: string): string;
  /** JSON Schema of specs or results, as `gearwright schema` prints it. */
  schema(of: "spec" | "result"): string;
  /** JSON text of a `Catalogue`. */
  catalogue(): string;
  /** Converts a spec from JSON to TOML, or from TOML to JSON. The tree is the same, but comments are lost. */
  toToml(json: string): string | Failed;
  toJson(toml: string): string | Failed;
  /** Returns the TOML text after one key was set, for example "gear1.profile_shift". The value is JSON text,
   *  "0.25" or "\"left\"", and "null" removes the key. Comments and order are kept. */
  edit(toml: string, key: string, valueJson: string): string | Failed;
  open(spec: string): Session | Failed;
  openSearch(spec: string, most?: number): SearchSession | Failed;
  designs(of: DesignDots): Figure | Failed;
}

export function failed(x: unknown): x is Failed;

export interface EngineOptions {
  /** The location of engine.wasm. By default it is next to the script. */
  locateFile?(name: string): string;
  /** The bytes of the module, if the page is one self-contained file. */
  wasmBinary?: ArrayBuffer | Uint8Array;
}
/** `import createEngine from "./engine.js"` (ES6: page, worker) */
export default function createEngine(options?: EngineOptions): Promise<Engine>;
