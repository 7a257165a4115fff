// The worker that runs the engine and answers the requests of the page.
//
// A request contains the text of the spec. The last spec stays open, so it is not solved again for
// a second request with the same text. Long requests are computed in steps of some milliseconds.
// Messages are handled between the steps, and an obsolete request ends there.

import createEngine, { failed } from "gearwright-engine/engine.js";
import type * as E from "../engine/engine";
import type { Motion } from "./motion";

export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };
export type Fault = E.Failed["error"];
/** The result for a spec. It is the output of the program with --json, or the reason why there is none. */
export interface Solved {
  text: string;
  spec: { [key: string]: Json } | null; // the tree of the text; null if the text cannot be read
  /** null if there is a fault, or if the page already has the result with this number. */
  result: { [key: string]: Json } | null;
  rows: E.Row[] | null; // the rows of the result; null in the same cases, or if they were not requested
  number: number; // the number of the result; results with equal numbers are equal
  fault: Fault | null;
  gears: number;
  hasPair: boolean;
  milliseconds: number;
}
/** The numbers of the result and of the rows that the page has. `rows` is null if the page needs no rows now. */
export interface Known {
  result: number;
  rows: number | null;
}
/** The tables of teeth under load, and the data for the page. */
export type Loaded =
  | { fault: Fault }
  | {
      load: { [key: string]: Json };
      rows: E.Row[][]; // for each torque
      warnings: Notice[];
      verdict: Verdict;
      milliseconds: number;
    };
export interface Notice {
  code: string;
  message: string;
  gear: number | null;
}
export interface Finding extends Notice {
  level: string;
  remedy: string | null;
}
export interface Verdict {
  level: string;
  headline: string;
  findings: Finding[];
  /** Parts of the verdict that the spec allows, but that this verb did not compute. */
  not_judged?: string[];
}
type Edit = [key: string, valueJson: string];
interface Step {
  // Resolves to true if the work must continue. `sofar` is a partial result.
  (done: number, of: number, sofar?: unknown): Promise<boolean>;
}

let engine: E.Engine;
/** The unit of lengths of figures, reports and drawings. */
let unit: "mm" | "in" = "mm";
let open: { text: string; session: E.Session } | null = null;
let search: E.SearchSession | null = null;
/** The last work that has figures. A figure is made when it is requested, in the requested width. */
let drawn: E.Work<unknown> | null = null;

/** The exception for a request that has no result. It contains the reason. */
class Refused extends Error {
  constructor(readonly fault: Fault) {
    super(fault.message);
  }
}
/** Returns the result of a call.   Throws  Refused if the call has failed */
function good<T>(answer: T | E.Failed): T {
  if (failed(answer)) throw new Refused(answer.error);
  return answer as T;
}
function session(text: string): E.Session {
  if (open?.text !== text) {
    const next = good(engine.open(text));
    open?.session.delete();
    open = { text, session: next };
  }
  open.session.showIn(unit);
  return open.session;
}

/** True if a spec is JSON. Like the engine, this tests whether the text begins with a brace. */
const isJson = (text: string) => text.trimStart().startsWith("{");
function treeOf(text: string): Solved["spec"] {
  const tree = engine.toJson(isJson(text) ? good(engine.toToml(text)) : text);
  return failed(tree) ? null : JSON.parse(tree);
}

/** The last result as text, and the unit of its rows. */
let printed: { text: string; unit: "mm" | "in"; number: number } = { text: "", unit, number: 0 };

/** Returns the verb of the result that the page shows for a session. */
const verbOf = (s: E.Session): E.Verb => (s.hasPair ? "pair" : s.gears ? "gear" : "drive");

/** Solves a spec. What the page already has is not sent again, because sending takes longer than solving. Most
 *  mounting errors do not change the result. */
function solve(text: string, known: Known): Solved {
  const begin = performance.now();
  const solved: Solved = {
    text,
    spec: null,
    result: null,
    rows: null,
    number: 0,
    fault: null,
    gears: 0,
    hasPair: false,
    milliseconds: 0,
  };
  try {
    solved.spec = treeOf(text);
  } catch {
    // The text cannot be read. The next call of the engine reports the reason.
  }
  try {
    const s = session(text);
    const { gears, hasPair } = s;
    Object.assign(solved, { gears, hasPair });
    const verb = verbOf(s);
    const result = s.json(verb);
    const same = result === printed.text && unit === printed.unit;
    if (!same) printed = { text: result, unit, number: printed.number + 1 };
    if (known.result !== printed.number) solved.result = good(JSON.parse(result));
    if (known.rows !== null && known.rows !== printed.number) solved.rows = good(s.rows(verb));
    solved.number = printed.number;
  } catch (reason) {
    if (!(reason instanceof Refused)) throw reason;
    solved.fault = reason.fault;
  }
  solved.milliseconds = performance.now() - begin;
  return solved;
}

/** Runs work in steps until it is finished. Returns null if a newer request has replaced it. */
async function stepped<T>(task: E.Work<T>, step: Step, sofar?: () => unknown): Promise<T | null> {
  for (;;) {
    const state = good(task.step(30));
    if (state.finished) return good(task.result() as T | E.Failed);
    if (!(await step(state.done, state.of, sofar?.()))) return null;
  }
}
async function work<T>(begun: E.Work<T> | E.Failed, step: Step): Promise<T | null> {
  const task = good(begun);
  try {
    return await stepped(task, step);
  } finally {
    task.delete();
  }
}
/** Runs work with figures until it is finished, and keeps it in `drawn`. `sofar` is called between
 *  steps. */
async function drawnWork<T>(begun: E.Work<T> | E.Failed, step: Step, sofar?: (task: E.Work<T>) => unknown): Promise<T | null> {
  const task = good(begun);
  const result = await stepped(task, step, sofar && (() => sofar(task))).catch((reason) => {
    task.delete();
    throw reason;
  });
  if (result === null) task.delete();
  else {
    drawn?.delete();
    drawn = task;
  }
  return result;
}

/** Returns the rows of the last load for each torque. */
function loadRows(): E.Row[][] {
  open?.session.showIn(unit);
  return drawn ? good(drawn.rows()) : [];
}

/** Adds to a result the time that its computation took. */
function timed<T extends object>(make: () => T): T & { milliseconds: number } {
  const begin = performance.now();
  const answer = make();
  return { ...answer, milliseconds: performance.now() - begin };
}
/** Returns the results of `make` for each gear of a session. */
function eachGear<T>(s: E.Session, make: (gear: 1 | 2) => T | E.Failed): T[] {
  return ([1, 2] as const).filter((gear) => gear <= s.gears).map((gear) => good(make(gear)));
}

/** Returns poses of the gears at `n` positions, and their contact, during one pitch of gear 1, from −½ to ½. */
function motionOf(s: E.Session, n: number): Motion {
  const { pitchDeg } = s;
  const curve = s.hasPair ? s.contactCurve(n - 1) : null;
  const places = eachGear(s, (gear) => {
    const all = new Float64Array(16 * n);
    for (let i = 0; i < n; ++i) all.set(good(s.pose(gear, pitchDeg * (i / (n - 1) - 0.5))), 16 * i);
    return all;
  });
  return { pitchDeg, n, places, curve: failed(curve) ? null : curve };
}

const questions = {
  catalogue: () => JSON.parse(engine.catalogue()) as E.Catalogue,
  solve: (q: { text: string; known: Known }) => solve(q.text, q.known),
  rows(q: { text: string }) {
    const s = session(q.text);
    return good(s.rows(verbOf(s)));
  },
  /** Sets keys in the text and solves the new text. */
  edit(q: { text: string; edits: Edit[]; known: Known }): Solved | { refused: Fault } {
    let text = isJson(q.text) ? good(engine.toToml(q.text)) : q.text;
    for (const [key, value] of q.edits) {
      const next = engine.edit(text, key, value);
      if (failed(next)) return { refused: next.error };
      text = next;
    }
    return solve(text, q.known);
  },
  /** Returns the figure of the mesh, and the motion of its gears at `positions` positions. */
  mesh(q: { text: string; view: E.MeshView; positions: number }) {
    const s = session(q.text);
    return { figure: good(s.meshFigure(q.view)), motion: q.positions ? motionOf(s, q.positions) : null };
  },
  motion: (q: { text: string; n: number }) => motionOf(session(q.text), q.n),
  meshes(q: { text: string; tolerance: number }) {
    const s = session(q.text);
    return eachGear(s, (gear) => s.mesh(gear, q.tolerance));
  },
  driveSolids: (q: { text: string }) => good(session(q.text).driveSolids()),
  driveFigures: (q: { text: string; width: number }) => good(session(q.text).driveFigures(q.width)),
  driveLoadFigures: (q: { text: string; width: number }) => good(session(q.text).driveLoadFigures(q.width)),
  /** Returns the contact over one pitch with its figures. The time in the answer is the time of the contact analysis
   *  without the figures. */
  contact(q: { text: string; view: E.ContactView }) {
    const curve = timed(() => good(session(q.text).contactCurve(q.view.positions)));
    return { curve, figures: good(session(q.text).contactFigures(q.view)) };
  },
  contactFigures: (q: { text: string; view: E.ContactView }) => good(session(q.text).contactFigures(q.view)),
  pattern: (q: { text: string; positions: number; rows: number; columns: number }, step: Step) =>
    work(session(q.text).pattern(q.positions, q.rows, q.columns), step),
  /** Computes a map and its figure. Partial figures are sent during the computation. */
  async errorMap(q: { text: string; x: E.ErrorAxis; y: E.ErrorAxis; positions: number; width: number }, step: Step) {
    const drawnMap = (task: E.Work<E.ErrorMap>) => ({ map: task.result() as E.ErrorMap, figure: good(task.figures(0, q.width))[0]! });
    const map = await drawnWork(session(q.text).errorMap(q.x, q.y, q.positions), step, drawnMap);
    return map && drawnMap(drawn as E.Work<E.ErrorMap>);
  },
  designs: (q: E.DesignDots) => good(engine.designs(q)),
  picturePdf: (q: { svg: string; title: string }) => good(engine.picturePdf(q.svg, q.title)),
  loadRows,
  loadFigures(q: { torque: number; width: number }) {
    open?.session.showIn(unit);
    return drawn ? good(drawn.figures(q.torque, q.width)) : [];
  },
  /** Computes teeth under load. An error contains its key, so that the page can show it at the field of this key. */
  async load(q: { text: string; accuracy?: "draft" | "full" }, step: Step): Promise<Loaded | null> {
    const begin = performance.now();
    try {
      const found = await drawnWork(session(q.text).load(q.accuracy), step);
      if (!found) return null;
      const { load, warnings, verdict } = JSON.parse(found.json);
      return { load, rows: loadRows(), warnings, verdict, milliseconds: performance.now() - begin };
    } catch (reason) {
      if (reason instanceof Refused) return { fault: reason.fault };
      throw reason;
    }
  },
  scatterSketch: (q: { text: string; width: number }) => timed(() => good(session(q.text).scatterSketch(q.width))),
  scatter: (q: { text: string; width: number }) => timed(() => good(session(q.text).scatter(q.width))),
  shifts: (q: { text: string; view: E.ShiftView }) => good(session(q.text).shiftRegion(q.view)),
  run: (q: { text: string; verb: E.Verb }) =>
    JSON.parse(engine.run(q.verb, q.text)) as { [key: string]: Json },
  /** Runs a verb on a spec that can be solved. Returns its parsed JSON and its rows. */
  answer(q: { text: string; verb: E.Verb }): { result: { [key: string]: Json }; rows: E.Row[] } {
    try {
      const s = session(q.text);
      return { result: JSON.parse(s.json(q.verb)), rows: good(s.rows(q.verb)) };
    } catch (reason) {
      if (reason instanceof Refused) return { result: { error: { ...reason.fault } as Json }, rows: [] };
      throw reason;
    }
  },
  /** Returns the output of the program with --json. Tests compare it with the native program. */
  print: (q: { text: string; verb: E.Verb }) => engine.run(q.verb, q.text),
  trials(q: { text: string }) {
    const s = good(engine.openSearch(q.text, 1));
    const trials = s.trials;
    s.delete();
    return trials;
  },
  async search(q: { text: string; most: number }, step: Step) {
    search?.delete();
    search = null;
    const s = (search = good(engine.openSearch(q.text, q.most)));
    const result = await stepped(s, step, () => s.best(20));
    return result && { ...result, trials: s.trials };
  },
  take(q: { design: number }): string {
    if (!search) throw new Error("the search no longer exists; run it again");
    return good(search.take(q.design));
  },
  searchReport(): Uint8Array {
    if (!search) throw new Error("run the search first");
    return good(search.report());
  },
  file: (q: { text: string; kind: E.FileKind; gear: 0 | 1 | 2 }) =>
    good(session(q.text).file(q.kind, q.gear)),
  tomlOf: (q: { json: string }) => good(engine.toToml(q.json)),
  metric: (q: { text: string }) => good(engine.metric(q.text)),
};
export type Questions = typeof questions;

// ------------------------------------------------------------------------------- messages

const overtaken = new Set<number>();
const running = new Map<string, number>();
const letThrough = new MessageChannel();
/** Returns a promise that resolves after the waiting messages have been handled. */
const moment = () =>
  new Promise<void>((go) => {
    letThrough.port1.onmessage = () => go();
    letThrough.port2.postMessage(0);
  });

interface Question {
  id: number;
  name: keyof Questions;
  question: never;
  channel?: string;
}
let queue: Promise<void> = Promise.resolve();
let ready: Promise<void> | null = null;

async function answer(q: Question): Promise<void> {
  await ready;
  if (q.channel) running.set(q.channel, q.id);
  const step: Step = async (done, of, sofar) => {
    postMessage({ id: q.id, progress: [done, of, sofar] });
    await moment();
    return !overtaken.has(q.id);
  };
  try {
    const result = await (questions[q.name] as (question: unknown, step: Step) => unknown)(q.question, step);
    // A finished result is sent even if a newer request is waiting. Otherwise the picture would not change
    // while a slider moves.
    postMessage({ id: q.id, answer: result });
  } catch (reason) {
    postMessage({ id: q.id, failed: reason instanceof Error ? reason.message : String(reason) });
  } finally {
    overtaken.delete(q.id);
  }
}

onmessage = (event: MessageEvent) => {
  const message = event.data;
  if (message.unit) unit = message.unit;
  if (message.wasm) {
    ready = createEngine({ wasmBinary: message.wasm, locateFile: (name) => name }).then((made) => {
      engine = made;
    });
    ready.catch((reason) => postMessage({ broken: String(reason) }));
  } else if (message.overtake) {
    const id = running.get(message.overtake);
    if (id !== undefined) overtaken.add(id);
  } else {
    queue = queue.then(() => answer(message)); // requests are handled one after the other, in order
  }
};
