// Holds the text of the current design, its results and its history.
//
// The text defines the design. The form, the pictures and the tables show the design. A change is
// sent to the engine, which returns the new text (with its comments) and the new results. Then all
// views are updated.

import { type Answer, EngineLink, type Name, type Progress } from "./engine_link";
import type { Row } from "../engine/engine";
import type { Fault, Json, Known, Questions, Solved } from "./engine_worker";
import { Changes, Pause } from "./pauses";

type Listener = () => void;
/** The greatest length of a text that is accepted as a spec. The longest example has 1600 characters. */
export const kMostCharacters = 1_000_000;
/** Changes of the same field within this time are undone in one step. */
const kOneStepMs = 900;
/** While a value changes, words and numbers are renewed after this time, because nobody can read them faster, ms. */
const kReadMs = 100;

class Workbench {
  text = "";
  /** The result of the last text. It may be an error, which is shown at the field that caused it. */
  solved: Solved | null = null;
  /** The last spec that could be solved. Pictures show it while the user is typing an invalid value. */
  good: Solved | null = null;
  /** True while words and numbers show an earlier result than the last one. */
  unread = false;
  /** The number of designs opened so far. A result that belongs to an earlier design is ignored. */
  design = 0;
  /** Time from the last change to its result, ms. */
  lastMs = 0;
  /** The result of the last finished search in one sentence, and the text of this search. */
  searched = { text: "", words: "" };
  front!: EngineLink;
  back!: EngineLink;
  press!: EngineLink;
  seek!: EngineLink;

  private readonly past: string[] = [];
  private readonly future: string[] = [];
  private lastWhat = "";
  private lastWhen = 0;
  private readonly edits = new Map<string, string>();
  private busy = false;
  /** The last rows of a result, and the number of this result. */
  private rows: { list: Row[]; number: number } = { list: [], number: 0 };
  private lastRead = 0; // ms, the time at which words and numbers were renewed last
  private readonly reading = new Pause(kReadMs);
  private readonly results = new Changes();
  private readonly listeners = new Map<string, Set<Listener>>();

  /** "solved" is for pictures. "read" is for words and numbers, and comes less often while a value changes. */
  on(what: "text" | "solved" | "read" | "searched" | "history" | "opened", listener: Listener): void {
    if (!this.listeners.has(what)) this.listeners.set(what, new Set());
    this.listeners.get(what)!.add(listener);
  }
  private notify(what: string): void {
    for (const listener of this.listeners.get(what) ?? []) listener();
  }

  /** Replaces the whole text. `what` names the origin of the text, for example typed or opened. */
  setText(text: string, what: string): void {
    if (text === this.text) return;
    this.remember(what);
    this.text = text;
    this.edits.clear();
    if (what === "opened") {
      ++this.design;
      // Another design has been opened. Results of the previous design must not be shown with it.
      this.good = this.solved = null;
      this.notify("opened");
    }
    this.notify("text");
    void this.solve();
  }

  setSearched(text: string, words: string): void {
    this.searched = { text, words };
    this.notify("searched");
  }

  private remember(what: string): void {
    const now = performance.now();
    const goesOn = what === this.lastWhat && now - this.lastWhen < kOneStepMs;
    this.lastWhat = what;
    this.lastWhen = now;
    if (goesOn) return;
    if (this.text) this.past.push(this.text);
    if (this.past.length > 500) this.past.shift();
    this.future.length = 0;
    this.notify("history");
  }

  /** Sets one key, for example "gear1.profile_shift". If the value is undefined, removes the key.
   *  Simultaneous changes are combined. */
  setKey(key: string, value: Json | undefined): void {
    this.setKeys({ [key]: value });
  }
  setKeys(values: Record<string, Json | undefined>): void {
    for (const [key, value] of Object.entries(values))
      this.edits.set(key, value === undefined ? "null" : JSON.stringify(value));
    void this.applyEdits();
  }

  private async applyEdits(): Promise<void> {
    if (this.busy || !this.edits.size) return;
    this.busy = true;
    const begin = performance.now();
    const from = this.text;
    const { good } = this;
    const read = begin - this.lastRead >= kReadMs;
    const edits = [...this.edits];
    this.edits.clear();
    try {
      const answer = await this.front.call("edit", { text: from, edits, known: this.known(good, read) });
      // If the user has edited the text in the meantime, the edited text takes precedence over
      // this change.
      if (this.text !== from) return;
      if ("refused" in answer) {
        const { message, kind } = answer.refused;
        const fault = { key: edits[0]![0], value: edits[0]![1], message, kind };
        this.takeSolved({ ...(this.solved ?? faulty(from, "")), fault }, begin, null, true);
        return;
      }
      this.remember(edits.map(([key]) => key).join(" "));
      this.text = answer.text;
      this.notify("text");
      this.takeSolved(answer, begin, good, read);
    } finally {
      this.busy = false;
      void this.applyEdits();
    }
  }

  /** Requests a result about the design on screen. Returns null if a newer request has replaced this one,
   *  or if another design has been opened. */
  async about<N extends Name>(
    link: EngineLink,
    channel: string,
    name: N,
    question: Parameters<Questions[N]>[0],
    progress?: Progress,
  ): Promise<Answer<N> | null> {
    const { design } = this;
    const answer = await link.latest(channel, name, question, progress);
    return this.design === design && this.good ? answer : null;
  }

  /** True while a value changes continuously. */
  get moving(): boolean {
    return this.results.moving;
  }
  /** If a value changes continuously, waits until it rests. Returns false if the result is not the last one. */
  async rested({ text }: Solved): Promise<boolean> {
    await this.results.rest();
    return this.good?.text === text;
  }

  /** Solves the design on screen again, for example with rows in another unit. */
  again(): void {
    void this.solve();
  }

  private async solve(): Promise<void> {
    const begin = performance.now();
    if (this.text.length > kMostCharacters) {
      const millions = (this.text.length / 1e6).toFixed(1);
      this.takeSolved(
        faulty(this.text, `This text has ${millions} million characters; a spec has at most one million.`),
        begin,
        null,
        true,
      );
      return;
    }
    const { good } = this;
    const answer = await this.front.latest("solve", "solve", { text: this.text, known: this.known(good, true) });
    if (answer?.text === this.text) this.takeSolved(answer, begin, good, true);
  }

  private known(good: Solved | null, read: boolean): Known {
    return { result: good?.number ?? 0, rows: read ? this.rows.number : null };
  }

  /** `known` is the design whose result the engine does not send again. If `read` is true, words and numbers are
   *  renewed at once, otherwise after a pause in the changes. */
  private takeSolved(solved: Solved, begin: number, known: Solved | null, read: boolean): void {
    if (known && solved.number === known.number) solved.result ??= known.result;
    this.solved = solved;
    if (solved.result) this.good = solved;
    else if (this.finder) this.good = null;
    this.lastMs = performance.now() - begin;
    // If the page was busy with a picture, the next change has come in the meantime.
    this.results.add(this.edits.size > 0);
    this.unread = true;
    this.notify("solved");
    if (solved.rows) this.rows = { list: solved.rows, number: solved.number };
    this.reading.cancel();
    if (read) void this.read(solved);
    else this.reading.run(() => void this.read(solved));
  }

  /** Renews words and numbers. */
  private async read(solved: Solved): Promise<void> {
    const { text, result, number } = solved;
    if (result && number !== this.rows.number) {
      const list = await this.front.latest("rows", "rows", { text });
      if (!list || this.solved !== solved) return;
      this.rows = { list, number };
    }
    solved.rows = result && this.rows.list;
    this.lastRead = performance.now();
    this.unread = false;
    this.notify("read");
  }

  /** The verb that computes the unknown values of the spec, if there are any. Such a spec is not an error. */
  get finder(): Fault["finder"] {
    const { fault, spec } = this.solved ?? {};
    if (!fault || !spec) return undefined;
    if (spec["search"] !== undefined) return "search";
    return fault.finder ?? (spec["fit"] !== undefined ? "fit" : undefined);
  }

  get fault(): Fault | null {
    return this.finder ? null : (this.solved?.fault ?? null);
  }

  /** True if the result of the engine belongs to the text on screen. */
  get settled(): boolean {
    return this.solved?.text === this.text;
  }

  /** The text to show instead of a picture if there is no pair. */
  get nothing(): string {
    return this.settled ? "There is no pair yet." : "";
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }
  get canRedo(): boolean {
    return this.future.length > 0;
  }
  undo(): void {
    this.step(this.past, this.future);
  }
  redo(): void {
    this.step(this.future, this.past);
  }
  private step(from: string[], to: string[]): void {
    const text = from.pop();
    if (text === undefined) return;
    to.push(this.text);
    this.text = text;
    this.lastWhat = "";
    this.edits.clear();
    this.notify("text");
    this.notify("history");
    void this.solve();
  }
}

function faulty(text: string, message: string): Solved {
  const fault: Fault = { key: "", value: "", message, kind: "value" };
  return { text, spec: null, result: null, rows: null, number: 0, fault, gears: 0, hasPair: false, milliseconds: 0 };
}

export const bench = new Workbench();

export function isDrive(): boolean {
  return at(bench.good?.result ?? undefined, "drive") !== undefined;
}

export function hasRack(spec: Json | null | undefined): boolean {
  return at(spec ?? undefined, "gear2.form") === "rack";
}

/** Returns the value at a path of nested records: at(result, "pair.backlash.normal_mm"). */
export function at(tree: Json | undefined, path: string): Json | undefined {
  let here: Json | undefined = tree;
  for (const name of path.split(".")) {
    if (here === null || typeof here !== "object") return undefined;
    here = (here as { [key: string]: Json })[name];
  }
  return here;
}
