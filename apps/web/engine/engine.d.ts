// The engine in WebAssembly, for a page or a node program.
//
// It contains no formulas. Every call passes a spec to the C++ code of `gearwright` and returns the
// result. Rules:
//
//   * No call throws. An error is a `Failed` with the message and the line that the program
//     prints. `failed(x)` tests a result for an error.
//   * Lengths are in mm. Angles at this interface are in degrees, as their names show. Keys of
//     results are the same as in `gearwright … --json` (docs/spec.md). For every key, the
//     catalogue contains words, symbol, unit and digits.
//   * Arrays are copies that belong to the caller, who may transfer or keep them.
//   * Calls are synchronous and single-threaded, so the engine should run in a Web Worker. A
//     long computation is a `Work`. Call its step() for some milliseconds, handle messages, and
//     repeat. Delete the `Work` to cancel the computation.
//   * An object with `delete()` stays in the memory of the module until it is deleted.
//   * A violated contract of the core is a defect of Gearwright. It becomes a Failed that names
//     the contract and requests a report. The object of the call (a session, a work) is then
//     unusable, but other objects can still be used. Only a trap or too deep a recursion stops
//     the module. The engine must then be loaded again.
//
// Housing frame, rotations and signs are described in docs/theory/01-frames.md. If `rotation1`
// increases, gear 1 turns clockwise seen from +z, and gear 2 turns accordingly.

/** An error with the key of the spec, its value, and the message. */
export interface Failed {
  error: {
    key: string; // "gear1.normal_module_mm", or "" if the error has no key
    value: string;
    message: string; // the whole sentence, with key and value
    kind: string; // "value", "missing", …; the list of docs/spec.md
    file?: string;
    line?: number; // line of the key, or of its table, in the text; counted from 1
    column?: number; // in characters, counted from 1
    // The verb that computes the missing values. Only `open` sets it, if the spec is incomplete.
    finder?: "search" | "fit" | "identify";
  };
}

export type Verb = "gear" | "pair" | "contact" | "compensate" | "propose" | "scatter" | "load" | "rate" | "drive" | "measure" | "identify" | "fit" | "search";

/** Kinds of files that the engine makes. `report` and `json` contain everything about the spec. */
export type FileKind = "stl" | "glb" | "3mf" | "dxf" | "svg" | "step" | "drawing" | "report" | "json";

// ---------------------------------------------------------------------------------- catalogue

export interface InputKey {
  key: string; // "helix_angle_deg"
  symbol: string; // "β", may be empty
  kind: "number" | "whole" | "boolean" | "text" | "word" | "table" | "any";
  unit: string; // unit of the key: "mm", "°", "µm", "″", "1/min", …; "" for pure numbers
  suffix: string; // the unit at the end of the key: "mm", "deg", "um"; may be ""
  // The permitted words. If the kind is not "word", these words are permitted in addition to other values.
  words: string[];
  range: {
    lo: number | null; // null if there is no limit
    hi: number | null;
    loOpen: boolean; // true if the limit itself is not permitted
    hiOpen: boolean;
    zero: boolean; // false if 0 is not permitted
    reason: string; // text that follows the range in a message: ", usually 14.5 to 30"
  } | null;
  list: { least: number; most: number; single: boolean } | null; // null for a single value
  form: string; // the permitted values as part of a sentence: "a number", "true or false"
  required: boolean;
  needs: string[]; // keys that must also be given
  excludes: string[]; // keys that must not be given together with this key
  tables: string[]; // for a table: names of the possible InputTables
  fallback: string; // the value if the key is absent, as TOML or in words
  meaning: string; // one sentence, lower case, without the full stop
  also: string[]; // other names under which users may search for the key: "module", "dp"
  documented: boolean; // false if forms should omit the key
}
export interface InputTable {
  name: string; // "gear", "pair", "errors", "rack_circular_arc", …; the file itself is "spec"
  meaning: string;
  keys: InputKey[];
}

export interface Quantity {
  key: string; // key in JSON: "tip_diameter_mm"
  words: string; // "tip diameter"
  symbol: string; // "d_a", with indices after the underscore; may be empty
  unit: string; // "mm", "°", "µm"; "" for pure numbers
  digits: number; // number of decimals shown to users
  group: string; // heading; may be empty
  meaning: string;
  type: "number" | "whole" | "index" | "flag" | "word" | "text" | "record" | "map";
  list: number[]; // lengths of nested lists (0: any length); [] for a single value
  two: "values" | "gears" | "ends" | "fraction"; // meaning of the two values of a list
  oneOf: string[]; // possible values of a word
  of: string; // for a record: name of its QuantityTable; otherwise ""
  page: boolean; // true if the tables of the report contain the quantity
  listing: boolean; // true if the output on the terminal contains the quantity
  percent: boolean; // true for a fraction of 1 that is shown to users as a percentage
  nothing: string; // text shown if there is no value; "" stands for "–"
  greaterFirst: boolean; // true if greater values are better
}
export interface QuantityTable {
  name: string; // "gear", "pair", "contact", "contact.positions", "search.designs", "verdict", …
  groups: string[]; // headings in their order
  quantities: Quantity[];
}
/** A row of the table of materials. Its name is a value of the key `name` in [gearN.material]. */
export interface NamedMaterial {
  name: string;
  kind: string; // letters of ISO 6336-5
  hardness_HV: number;
  note: string;
}
export interface Objective {
  name: string; // value of the key `objective` in [search]
  words: string;
  symbol: string;
  unit: string;
  better: "smaller" | "greater";
}
export interface Catalogue {
  version: string;
  materials: NamedMaterial[];
  objectives: Objective[];
  inputs: InputTable[]; // the table of the file itself comes first
  quantities: QuantityTable[];
  inchUnits: Record<string, [unit: string, size: number, digits: number]>; // by the unit that is replaced
}

// ---------------------------------------------------------------------------------- geometry

/** A closed mesh in the gear's own frame, for three.js buffers. Normals belong to the exact surface. */
export interface Mesh {
  positions: Float32Array; // x, y, z, …, mm
  normals: Float32Array;
  indices: Uint32Array;
  toleranceMm: number;
}

/** The solids of a drive in their places, and their motion. All ratios are turns per turn of the first input. */
export interface DriveSolids {
  parts: {
    name: string; // "planet 1"
    body: number; // index in `bodies`
    same: number | null; // an earlier part with the same mesh
    mesh: Mesh | null; // null if `same` is given
    pose: Float64Array; // column-major 4×4 matrix in the initial position
    turn: number; // ratio of the part
    about: [number, number]; // axis of its carrier, or its own axis, mm
    carried: number; // ratio of its carrier, 0 if it has none
    travel: [number, number]; // motion of a rack per turn of the first input, mm
  }[];
  bodies: {
    name: string;
    ratio: number; // 0 if the body is held, moves in a line, or if its speed is not known
    rides: boolean; // true for a planet
    colour: [number, number, number]; // linear RGB, as in GLB files
  }[];
  fixed: string[];
  inputs: string[];
  output: string;
}

/** Lines between the gears in the housing frame, mm. An array is empty if its line does not exist. */
export interface MeshLines {
  kind: "parallel_external" | "parallel_internal" | "crossed";
  centerDistance: number;
  shaftAngleDeg: number;
  lineOfAction: Float64Array; // x, y, z of both ends, which are the base tangent points
  trailingLine: Float64Array; // line of action of the non-working flanks
  pathOfContact: Float64Array; // x, y, z of A and E
  points: { name: "A" | "B" | "C" | "D" | "E"; x: number; y: number; z: number }[];
}

/** Columns by the keys of contact.positions. A missing value is NaN or "". If a value is a list of n
 *  numbers, the column contains these n numbers for each position, and `width[key]` is n. Members of a
 *  record have keys such as "ellipse.semi_major_mm". */
export interface ContactCurve {
  n: number;
  columns: Record<string, Float64Array | string[]>;
  width: Record<string, number>;
  peakToPeakArcsec: number; // NaN if no teeth touch, or if gear 2 is a rack, which has transmission_error_um
  meanSlope: number;
  harmonicsArcsec: Float64Array; // empty for a rack
  contactLost: boolean;
  words: string; // summary in words, as in the report
}

/** A raster of a flank. Rows are diameters, and columns are heights z in the gear's own frame. */
export interface FlankRaster {
  diameter: Float64Array; // mm, ascending
  height: Float64Array; // mm, ascending
  gap: Float64Array; // mm, [row * columns + column]; Infinity where the mating gear never reaches
}

/** The distribution of the peak-to-peak transmission error of pairs within their tolerances. */
export interface Scattered {
  percentiles: { percent: number; arcsec: number }[]; // percentiles requested in [scatter]; empty if contact is lost
  figures: Figure[]; // "scatter-te" (histogram), its cumulative curve, "scatter-play", "scatter-pattern1" and 2
  samples?: number; // number of samples with complete contact analysis; absent for an estimate
  events?: { words: string; count: number; of: number; upper: number }[]; // upper: upper confidence
                                                                          // limit of count/of
}

/** The x1–x2 chart for the tooth numbers of this pair. Its borders are the limits of a search and are exact. */
export interface ShiftRegion {
  point: [number, number]; // the profile shifts of the spec
  inside: boolean;
  /** Distance of the point from the nearest border in modules. It is negative outside the region,
   *  and −Infinity if there is no region. */
  margin: number;
  /** The name of the nearest border if the point is on it or outside the region, otherwise "". */
  stoppedBy: string;
  borders: Record<string, string>; // words for every border that occurs: "contact ratio 1.2"; empty without a region
  whatKills: string; // words for the first limit that leaves no region; "" if there is a region
  figure: Figure | null; // null if no view was requested
}

// ---------------------------------------------------------------------------------- long work

/** A computation in steps. The worker can handle messages between the steps. */
export interface Work<T> {
  /** Works for about this number of milliseconds. Afterwards, `done` of `of` steps are complete. Steps may
   *  differ in duration. */
  step(milliseconds: number): { done: number; of: number; finished: boolean } | Failed;
  /** Returns the result. Before the work is finished, this is a partial result or null. */
  result(): T | Failed | null;
  /** Returns figures of the result. A map has one figure. For teeth under load, the figures show the torque with
   *  this index. */
  figures(torque: number, width: number): Figure[] | Failed;
  /** Returns the rows of each torque for teeth under load. The list is empty for other work. */
  rows(): Row[][] | Failed;
  delete(): void;
}

export interface SearchResult {
  json: string; // the output of `gearwright search SPEC --json`; "" until the search is finished
  tested: number;
  feasible: number;
}
export interface ErrorMap {
  x: Float64Array; // values of the error on this axis of the map, in the unit of its key
  y: Float64Array;
  peakToPeakArcsec: Float64Array; // [iy * nx + ix]; NaN if no teeth touch or if not yet computed
}

export interface LoadResult {
  json: string; // the output of `gearwright load SPEC --json`, without probes
}

// ---------------------------------------------------------------------------------- tables

/** A row of a table of a result, in the words and the order of the program's listing. */
export interface Row {
  id: string; // its place in the result, "pair.backlash.normal_mm"; of a gear, "gears.tip_diameter_mm"
  group: string; // heading; may be empty
  words: string;
  symbol: string; // with indices after the underscore; may be empty
  unit: string;
  meaning: string;
  texts: string[]; // one for each gear, or one for both
  /** For each text, the values at both ends of the tolerances. A text is empty if its value has no tolerance. The
   *  list is empty if no value has a tolerance. */
  ends: string[];
  note: string; // for a factor of a rating, its clause of the standard and the branch of the formula
}

// ---------------------------------------------------------------------------------- figures

/** A figure as in the report, with its picture, its caption and the data of its curves. Gears in section have
 *  no caption. The group of class "plot" describes the scales of its axes in `data-x` and `data-y`. Each
 *  attribute is "lo hi from to", where the value `lo` is at the position `from`, and `hi` is at `to`, in px.
 *  The word "log" follows for a logarithmic axis. */
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
    points?: { name: string; at: [number, number] }[]; // named points, such as A to E of a mesh
    // The values of a map, a row for each y.
    grid?: { words: string; unit: string; x: number[]; y: number[]; values: (number | null)[][] };
  };
}
export interface ContactView {
  width: number; // px, width of a figure
  positions: number; // number of positions per pitch
  index: number; // index of the position whose gap is shown on the flanks
  patterns: FlankRaster[] | null; // the result of `pattern`
  curves: boolean; // false to draw only the flanks
}

/** Options of the figure of the gears in section. */
export interface MeshView {
  frame: "whole" | "mesh" | "flank"; // all of the gears, their mesh, or the path of contact
  width: number; // px, width of the figure
  height: number;
  window: [number, number, number, number] | null; // x0, x1, y0, y1 in mm; null for the window that belongs to `frame`
  bodies: boolean; // true to draw only the bodies of the gears
  name: string; // name of the picture and its shapes, unique in the page
}

/** Options of the figure of the profile shifts. */
export interface ShiftView {
  width: number; // px, width of the figure
  aspect: number; // width over height of the plot
  // Least and greatest x1, then least and greatest x2. If the value is null, the window surrounds the region.
  window: [number, number, number, number] | null;
}

/** A quantity of designs. For an objective, `better` states which values are better. For other quantities, it is "". */
export interface DesignAxis {
  words: string;
  unit: string;
  symbol: string;
  better: Objective["better"] | "";
  values: number[];
}
/** Designs as dots over two of their quantities, in the order of drawing. The values must be finite. If both
 *  axes are objectives, a staircase borders the dots of the front. */
export interface DesignDots {
  width: number; // px, width of the figure
  tall: number; // height over width of the plot
  x: DesignAxis;
  y: DesignAxis;
  styles: string[]; // "dot-front" or "dot-design"; for the chosen design, " taken" is added
  names: string[]; // names of the designs, shown with the values at the pointer
}

// ---------------------------------------------------------------------------------- a session

/** A spec that has been read and solved, with all results that a page shows while the user changes the spec. */
export interface Session {
  readonly gears: number; // 1 or 2, including a rack; 0 for a drive, which has json("drive"), solids, figures and files only
  readonly hasPair: boolean; // true for two gears, and for a rack and its pinion
  readonly pitchDeg: number; // one pitch of gear 1; 0 for a drive
  /** Sets the unit of lengths of figures, rows, the report and drawings. The initial unit is "mm". The figure
   *  of the gears in section and all other results are in mm. */
  showIn(unit: "mm" | "in"): void;
  /** Returns the output of `gearwright VERB SPEC --json` including its line feed, or a Failed as JSON. */
  json(verb: Verb): string;
  /** Returns the rows of the result of `gear`, `pair`, `drive`, `contact` or `rate`. The result is empty for other
   *  verbs, and if the verb fails. A verb is not computed again if the last call of `json` had the same verb. */
  rows(verb: Verb): Row[] | Failed;
  /** Returns the solid of gear 1 or 2 within the tolerance (default 0.02 mm). */
  mesh(gear: 1 | 2, toleranceMm?: number): Mesh | Failed;
  driveSolids(): DriveSolids | Failed;
  /** Returns the scheme of a drive ("scheme") and its power flow ("power"). */
  driveFigures(width: number): Figure[] | Failed;
  /** Returns the curves of a drive under load. The result is empty without [load]. Computing the load takes
   *  seconds. */
  driveLoadFigures(width: number): Figure[] | Failed;
  lines(): MeshLines | Failed;
  /** Returns the gears in section, in mm. Each shape of a gear is a `use` element with `data-gear`, whose
   *  transformation is relative to the position of the gear. */
  meshFigure(view: MeshView): Figure | Failed;
  /** Returns the transformation from the frame of a gear to the housing frame at a rotation of gear 1, as a
   *  column-major 4×4 matrix for three.js. The gears have the errors of the spec, and gear 2 is turned until its
   *  working flanks touch. If there is no contact, its rotation follows from the gear ratio, and its teeth are in the
   *  middle of the backlash. If `nominal` is true, this rotation is used without errors. */
  pose(gear: 1 | 2, rotation1Deg: number, nominal?: boolean): Float64Array | Failed;
  /** Returns the contact at `positions` per pitch under the errors and modifications of the spec. The first position
   *  is half a pitch before the centre line. */
  contactCurve(positions: number): ContactCurve | Failed;
  /** Returns figures of the transmission error, of its spectrum and of both flanks. A figure without data is
   *  omitted. */
  contactFigures(view: ContactView): Figure[] | Failed;
  /** Returns the contact at one position, with the keys of contact.positions. If no teeth touch, `kind` is
   *  "none". */
  contactPoint(rotation1Deg: number): Record<string, unknown> | Failed;
  /** Returns the gap on the flank of gear 1 at one position, for tooth pair k (`tooth` of a position). */
  gapMap(rotation1Deg: number, k: number, rows?: number, columns?: number): FlankRaster | Failed;
  /** Returns the least gap at each point of both flanks while the gears rotate, which shows the pattern of the
   *  marking compound. For a rack and its pinion, only the flank of the pinion is returned. If the halves of a
   *  double-helical pair differ, both flanks of the half at z < 0 follow. */
  pattern(positions: number, rows?: number, columns?: number): Work<FlankRaster[]> | Failed;
  /** Returns the peak-to-peak transmission error as a function of two errors, which are keys of [errors]. */
  errorMap(x: ErrorAxis, y: ErrorAxis, positions?: number): Work<ErrorMap> | Failed;
  /** Computes teeth under the torques of [load]. `accuracy` replaces the accuracy in the spec. The engine
   *  keeps the compliance of the teeth. If only torque, errors or modifications have changed, the next call
   *  therefore takes much less time. */
  load(accuracy?: "draft" | "full"): Work<LoadResult> | Failed;
  /** Returns an estimate, to first order, of the effect of the tolerances of [scatter] on the peak-to-peak
   *  transmission error. The estimate takes a fraction of a second. `width` is the width of a figure in px. */
  scatterSketch(width: number): Scattered | Failed;
  /** Returns the effect of the tolerances of [scatter], computed by complete contact analyses. The number of samples
   *  is at most 1024 and at most that of the spec. It is smaller if the analysis would take longer
   *  than about one second. */
  scatter(width: number): Scattered | Failed;
  shiftRegion(view?: ShiftView | null): ShiftRegion | Failed;
  /** Returns the bytes of a file of gear 1 or 2, or of the mounted pair or the drive if `gear` is 0. `gear` has
   *  no effect on report and json, nor on files of a drive. */
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
  /** Returns the designs found so far, best first, as JSON with the rows of search.designs. */
  best(most: number): string;
  /** Returns a design of the finished search as a TOML spec. Ranks start at 1. */
  take(design: number): string | Failed;
  /** Returns the report of the search as HTML, as the program writes it. */
  report(): Uint8Array | Failed;
}

// ---------------------------------------------------------------------------------- the engine

export interface Engine {
  version(): string;
  /** Returns the output of `gearwright VERB --json`, byte for byte. If there is an error, the output is the JSON of
   *  a `Failed`. A text that begins with a brace is read as JSON, any other text as TOML. `search` runs to its end
   *  in this call. */
  run(verb: Verb, spec: string): string;
  /** JSON Schema of specs or results, as `gearwright schema` prints it. */
  schema(of: "spec" | "result"): string;
  /** JSON text of a `Catalogue`. */
  catalogue(): string;
  /** Converts a spec from JSON to TOML, or from TOML to JSON. Values are preserved, but comments are lost. */
  toToml(json: string): string | Failed;
  toJson(toml: string): string | Failed;
  /** Returns the same spec in mm. A spec in mm is unchanged, and any other spec becomes TOML.
   *  Sessions and searches need specs in mm. */
  metric(text: string): string | Failed;
  /** Sets one key of a TOML text, for example "gear1.profile_shift", and returns the new text. The value
   *  is JSON, "0.25" or "\"left\"". "null" removes the key. Comments and order are preserved. */
  edit(toml: string, key: string, valueJson: string): string | Failed;
  open(spec: string): Session | Failed;
  openSearch(spec: string, most?: number): SearchSession | Failed;
  designs(of: DesignDots): Figure | Failed;
  /** Returns a picture as a PDF of one page. `svg` is XML with the elements and classes of `Figure.html`. */
  picturePdf(svg: string, title: string): Uint8Array | Failed;
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
