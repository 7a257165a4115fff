// The engine that engine.d.ts describes. It calls the functions of the module, adds default arguments, and
// catches the exceptions of each call. It contains no computation.
import createCore from "./gearwright.mjs";

const kBroken =
  "a defect stopped the engine; please report the spec, and load the engine again: ";

const broken = (e) => ({
  error: { key: "", value: "", message: kBroken + (e instanceof Error ? e.message : String(e)), kind: "defect" },
});

export function failed(x) {
  return typeof x === "object" && x !== null && "error" in x;
}

/** Calls that return JSON as text. For these calls, an error is also returned as text. */
const kTexts = ["run", "json", "best"];
const kDefaults = {
  openSearch: ["", 0],
  step: [8],
  mesh: [1, 0.02],
  pose: [1, 0, false],
  shiftRegion: [null],
  contactCurve: [64],
  gapMap: [0, 0, 33, 65],
  pattern: [64, 33, 65],
  errorMap: [{}, {}, 64],
  file: ["", 0, 0],
};

// Wraps the module, or an object of it. If a call causes a trap or too deep a recursion, it returns a Failed.
function guarded(object, defaults) {
  const call = (name) => (...given) => {
    const all = [...given];
    defaults[name]?.forEach((value, i) => (all[i] ??= value));
    try {
      const answer = object[name](...all);
      return typeof answer?.delete === "function" ? guarded(answer, defaults) : answer;
    } catch (e) {
      return kTexts.includes(name) ? JSON.stringify(broken(e), null, 2) + "\n" : broken(e);
    }
  };
  return new Proxy(object, {
    get: (_, name) => (typeof object[name] === "function" ? call(name) : object[name]),
  });
}

export default async function createEngine(options = {}) {
  const core = await createCore(options);
  // The compliance tables of teeth under load are shared by all sessions.
  return guarded(core, { ...kDefaults, load: ["", new core.ToothTables()] });
}
