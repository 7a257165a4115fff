// The engine as engine.d.ts describes it: the module's own functions with default arguments, and a
// catch around each call. Nothing is computed here.
import createCore from "./gearwright.mjs";

const kBroken =
  "the engine stopped at a mistake of its own, please report the spec; it has to be loaded again: ";

const broken = (e) => ({
  error: { key: "", value: "", message: kBroken + (e instanceof Error ? e.message : String(e)) },
});

/** Whether a call was refused. */
export function failed(x) {
  return typeof x === "object" && x !== null && "error" in x;
}

// Calls f and turns what it throws, a trap or too deep a recursion, into a Failed.
function calling(f) {
  try {
    return f();
  } catch (e) {
    return broken(e);
  }
}
const callingText = (f) => {
  const said = calling(f);
  return failed(said) ? JSON.stringify(said, null, 2) + "\n" : said;
};

// An object of the module, its methods guarded.
function handle(object, methods) {
  if (failed(object)) return object;
  const door = { delete: () => calling(() => object.delete()) };
  for (const [name, f] of Object.entries(methods)) door[name] = (...a) => calling(() => f(...a));
  return door;
}

const work = (object) =>
  handle(object, { step: (ms = 8) => object.step(ms), result: () => object.result() });

function session(s) {
  if (failed(s)) return s;
  const door = handle(s, {
    section: (gear, tolerance = 0.001) => s.section(gear, tolerance),
    mesh: (gear, tolerance = 0.02) => s.mesh(gear, tolerance),
    lines: () => s.lines(),
    pose: (gear, rotation1, nominal = false) => s.pose(gear, rotation1, nominal),
    contactCurve: (positions = 64) => s.contactCurve(positions),
    contactPoint: (rotation1) => s.contactPoint(rotation1),
    gapMap: (rotation1, k, rows = 33, columns = 65) => s.gapMap(rotation1, k, rows, columns),
    pattern: (positions = 64, rows = 33, columns = 65) => work(s.pattern(positions, rows, columns)),
    errorMap: (x, y, positions = 64) =>
      work(s.errorMap(x.key, x.from, x.to, x.n, y.key, y.from, y.to, y.n, positions)),
    load: (accuracy = "") => work(s.load(accuracy)),
    shiftRegion: () => s.shiftRegion(),
    file: (kind, gear = 0, tolerance = 0) => s.file(kind, gear, tolerance),
  });
  door.json = (verb) => callingText(() => s.json(verb));
  door.gears = s.gears;
  door.hasPair = s.hasPair;
  return door;
}

function search(s) {
  if (failed(s)) return s;
  const door = handle(s, {
    step: (ms = 8) => s.step(ms),
    result: () => s.result(),
    take: (design) => s.take(design),
    report: () => s.report(),
  });
  door.best = (most) => callingText(() => s.best(most));
  door.trials = s.trials;
  return door;
}

export default async function createEngine(options = {}) {
  const core = await createCore(options);
  return {
    version: () => core.version(),
    run: (verb, spec) => callingText(() => core.run(verb, spec)),
    schema: (of) => core.schema(of),
    catalogue: () => core.catalogue(),
    toToml: (json) => calling(() => core.toToml(json)),
    toJson: (toml) => calling(() => core.toJson(toml)),
    edit: (toml, key, value) => calling(() => core.edit(toml, key, value)),
    open: (spec) => calling(() => session(core.open(spec))),
    openSearch: (spec, most = 0) => calling(() => search(core.openSearch(spec, most))),
  };
}
