// The tab "search" shows results for a spec with unknown numbers. For a spec with [search], the tab
// evaluates all candidates. It shows a progress bar and a button that stops the search. If the
// gears are incomplete, the verb `fit` computes all solutions. A click shows a design. The list
// remains as long as the text on screen is the searched spec or the spec of a design from the list.

import { inputKey, quantity } from "../catalogue";
import { button, download, fill, h, sentenceOf } from "../elements";
import { Cancelled } from "../engine_link";
import type { Json } from "../engine_worker";
import { shownUnit, textOf } from "../numbers";
import { at, bench } from "../workbench";
import type { Tab } from "../tabs";
import { ParetoPicture, type Point } from "./pareto";
import { around, measured } from "./search_specs";
import { columnsOf, idOf, SearchTable, valueIn, varies, type Column, type Design } from "./search_table";

const kMostTrials = 1e7; // candidates; a search with more of them needs the native program
const kAtOnce = 30_000; // candidates; a search with no more than this starts without a button
const kMostDesigns = 2000;
/** Quantities for the axes, the most useful first. All others follow in the order of the catalogue. */
const kAxes = ["objective", "center_distance_mm", "contact_ratio", "sliding_max", "ratio"];

/** Returns the name of the objective of a spec with one objective. If none is given, it is the default. */
function onlyObjective(spec: Json | null): string {
  const given = [at(spec, "search.objective")].flat()[0];
  return typeof given === "string" ? given : inputKey("search", "objective")!.fallback.replaceAll('"', "");
}

export class SearchView implements Tab {
  readonly id = "search";
  private readonly status = h("p", { class: "search-said", role: "status" });
  private readonly go = button("Search", () => void this.search(), { class: "main" });
  private readonly stop = button("Cancel", () => bench.seek.cancel());
  private readonly back = button(
    "Back to the search",
    () => this.searched && bench.setText(this.searched, "back"),
  );
  private readonly save = button("Report of the search", () => void this.report());
  private readonly bar = h("progress", { max: 1, value: 0, "aria-label": "progress of the search" });
  private readonly across = h("select", {
    "aria-label": "horizontal axis of the Pareto chart",
    change: () => this.plot(),
  });
  private readonly up = h("select", { "aria-label": "vertical axis of the Pareto chart", change: () => this.plot() });
  private readonly chooser = h(
    "p",
    { class: "soft pareto-axes" },
    h("label", {}, "horizontal axis ", this.across),
    h("label", {}, "vertical axis ", this.up),
  );
  private readonly table = new SearchTable((row) => void this.take(row));
  private readonly pareto = new ParetoPicture((row) => void this.take(row));
  private readonly branches = h("div", { class: "branches" });
  readonly picture = h(
    "div",
    { class: "found" },
    this.branches,
    this.table.element,
    h("div", { class: "pareto-room" }, this.chooser, this.pareto.element),
  );
  readonly element = h(
    "div",
    { class: "search-view" },
    h(
      "div",
      { class: "search-head" },
      this.status,
      h("div", { class: "search-buttons" }, this.go, this.stop, this.back, this.save, this.bar),
    ),
    this.picture,
  );
  private searched = ""; // the text whose designs are listed
  private readonly of = new Set<string>(); // the searched text and the texts of the chosen designs
  private designs: Design[] = [];
  private front: number[] = [];
  private taken = -1;
  private looked = "";
  private running = ""; // the text of the running search
  private columns: Column[] = [];
  private only = onlyObjective(null); // the objective of the listed designs, if they have one

  constructor() {
    this.forget();
    bench.on("opened", () => this.forget());
  }

  get shown(): string {
    if (!this.designs.length) return this.branches.childElementCount ? this.looked : "";
    return this.of.has(bench.text) ? bench.text : this.searched;
  }

  async refresh(): Promise<void> {
    const solved = bench.solved;
    if (!solved || solved.text === this.looked || solved.text === this.running) return;
    this.end();
    this.looked = solved.text;
    fill(this.branches);
    const searching = solved.spec?.["search"] !== undefined;
    this.back.hidden = !this.searched || solved.text === this.searched;
    this.go.textContent = searching || !solved.hasPair ? "Search" : "Search around this pair";
    this.go.hidden = !searching && !solved.hasPair;
    if (this.designs.length && this.of.has(solved.text)) return;
    if (searching) return this.offer(solved.text);
    if (solved.fault || solved.spec?.["fit"] !== undefined) return this.fit(solved.text);
    if (!this.designs.length)
      this.status.textContent = solved.hasPair
        ? "“Search around this pair” searches for other pairs whose ratio differs by at most 3 % " +
          "and whose centre distance differs by at most 2 %."
        : "A search needs a pair, or a [search] table in the spec.";
  }

  inUnits(): void {
    const { taken } = this;
    this.list(this.designs, this.front, this.searched);
    this.looked = "";
    if (taken < 0) return;
    this.taken = taken;
    this.table.mark(taken);
    this.plot();
  }

  /** Removes the results of the previous design when another design is opened. */
  private forget(): void {
    this.end();
    this.looked = "";
    this.list([], [], "");
    fill(this.branches);
    this.status.textContent = "";
    this.back.hidden = this.save.hidden = true;
  }
  /** Ends the running search, because its spec is no longer on screen. */
  private end(): void {
    if (this.running) bench.seek.cancel();
    this.rest();
  }
  private rest(): void {
    this.running = "";
    this.stop.hidden = this.bar.hidden = true;
  }

  /** Shows the number of candidates of a [search]. A small search starts immediately. */
  private async offer(text: string): Promise<void> {
    try {
      const trials = await bench.seek.call("trials", { text });
      if (bench.text !== text) return;
      if (trials > kMostTrials) {
        this.go.hidden = true;
        this.status.textContent = `${count(trials)} candidates are too many for the page. The program computes them on all cores or on several machines:  gearwright search spec.toml --out found`;
        return;
      }
      this.status.textContent = `The search has ${count(trials)} candidates.`;
      if (trials <= kAtOnce) await this.search();
    } catch (reason) {
      if (bench.text === text) this.status.textContent = sentenceOf(reason);
    }
  }

  private async search(): Promise<void> {
    let text = bench.text;
    if (bench.solved?.spec?.["search"] === undefined) {
      text = around();
      bench.setText(text, "search around");
    }
    this.running = this.looked = text;
    this.go.hidden = this.back.hidden = this.save.hidden = true;
    this.stop.hidden = this.bar.hidden = false;
    this.bar.value = 0;
    const begin = performance.now();
    try {
      const found = await bench.seek.call("search", { text, most: kMostDesigns }, (done, of, sofar) => {
        if (this.running !== text) return;
        this.bar.value = of ? done / of : 0;
        const best = typeof sofar === "string" && sofar ? (JSON.parse(sofar) as Design[]) : [];
        this.status.textContent = `${Math.floor((100 * done) / Math.max(1, of))} % of the search is done.`;
        if (best.length) this.list(best, [], text);
      });
      if (!found || this.running !== text) return;
      const answer = JSON.parse(found.json) as {
        search?: { designs: Design[]; pareto?: number[]; rejected: Record<string, number> };
        error?: { message: string };
      };
      if (!answer.search) throw new Error(answer.error?.message ?? "the search returned no result");
      this.save.hidden = false;
      const time = ((performance.now() - begin) / 1000).toFixed(2);
      const words = `${count(found.feasible)} of ${count(found.tested)} candidates satisfy every limit.`;
      this.status.textContent = `${words} The search took ${time} s.` + why(found.feasible, answer.search.rejected);
      bench.setSearched(text, words);
      this.list(answer.search.designs, answer.search.pareto ?? [], text);
    } catch (reason) {
      if (this.running !== text) return;
      this.status.textContent = reason instanceof Cancelled ? "Cancelled." : sentenceOf(reason);
    } finally {
      if (this.running === text) {
        this.rest();
        this.go.hidden = false;
        this.go.textContent = "Search";
      }
    }
  }
  /** Lists the designs that were found for a text. The search may still be running. */
  private list(designs: Design[], front: number[], text: string): void {
    if (text !== this.searched) {
      this.searched = text;
      this.of.clear();
    }
    if (text) this.of.add(text);
    this.designs = designs;
    this.front = front;
    this.taken = -1;
    if (bench.solved?.text === text) this.only = onlyObjective(bench.solved.spec);
    this.table.show(designs, front, this.only);
    // A quantity with the same value in all designs is not useful on an axis.
    const rank = (column: Column) => (kAxes.indexOf(column.info.key) + kAxes.length + 1) % (kAxes.length + 1);
    this.columns = columnsOf(designs, this.only)
      .filter((one) => designs.some((design) => typeof valueIn(design, one) === "number"))
      .filter((one) => varies(designs, one))
      .sort((a, b) => rank(a) - rank(b));
    const ids = this.columns.map(idOf);
    for (const [i, select] of [this.across, this.up].entries()) {
      const before = select.value;
      fill(select, ...this.columns.map((column) => h("option", { value: idOf(column) }, column.words)));
      select.value = ids.includes(before) ? before : (ids[i] ?? "");
    }
    if (this.across.value === this.up.value) this.up.value = ids.find((id) => id !== this.across.value) ?? "";
    this.plot();
  }

  private plot(): void {
    const of = (select: HTMLSelectElement) => this.columns.find((one) => idOf(one) === select.value);
    const [x, y] = [of(this.across), of(this.up)];
    this.chooser.hidden = !x || !y;
    if (!x || !y) return this.pareto.clear();
    const front = new Set(this.front);
    const listed = (design: Design, key: string) => [design[key]].flat().join(":");
    const points: Point[] = this.designs.map((design, row) => ({
      row,
      name: `${row + 1}: ${listed(design, "module_mm")} · ${listed(design, "teeth")}`,
      x: real(valueIn(design, x)),
      y: real(valueIn(design, y)),
      front: front.has(row),
    }));
    this.pareto.show(points, x, y, this.taken);
  }

  private async take(row: number): Promise<void> {
    try {
      const text = await bench.seek.call("take", { design: row + 1 });
      this.taken = row;
      this.looked = text;
      this.of.add(text);
      this.table.mark(row);
      this.plot();
      bench.setText(text, "design " + row);
      this.back.hidden = false;
    } catch (reason) {
      this.status.textContent = sentenceOf(reason);
    }
  }

  private async report(): Promise<void> {
    try {
      const page = await bench.seek.call("searchReport", undefined as never);
      download("search.html", page as Uint8Array<ArrayBuffer>, "text/html");
    } catch (reason) {
      this.status.textContent = sentenceOf(reason);
    }
  }

  /** Shows all solutions of a spec without [search]. For incomplete gears, these are the branches of the
   *  verb fit. For readings of an unknown gear, they are the gears that agree with the readings. */
  private async fit(text: string): Promise<void> {
    const verb = measured(bench.solved?.spec ?? null) ? "identify" : "fit";
    const list = verb === "fit" ? "branches" : "candidates";
    this.status.textContent = `Searching for gears ${verb === "fit" ? "that fit the spec" : "that match the readings"} …`;
    try {
      const answer = await bench.seek.call("run", { text, verb });
      if (this.looked !== text) return;
      const found = (at(answer, `${verb}.${list}`) ?? []) as Design[];
      const hint = (path: string, before: string, after = "") => {
        const reading = at(answer, `identify.${path}.reading`);
        return typeof reading === "string" ? before + reading.replaceAll("_", " ") + after : "";
      };
      const reason = at(answer, verb + ".reason") ?? at(answer, "error.message");
      this.status.textContent = found.length
        ? `${found.length === 1 ? "There is one solution" : `There are ${found.length} solutions`}. Click a button to use a solution as the design.` +
          hint("contradiction", " The reading ", " contradicts the others.") +
          hint("next_measurement", " To decide between the solutions, measure ", ".")
        : String(reason ?? "There is no solution.");
      const table = verb === "fit" ? "fit.branches" : "identify.candidate";
      fill(this.branches, ...found.slice(0, 12).map((one, i) => this.branch(one, i, table)));
    } catch (reason) {
      if (this.looked === text) this.status.textContent = sentenceOf(reason);
    }
  }
  private branch(branch: Design, i: number, table: string): HTMLElement {
    const facts = Object.entries(branch).flatMap(([key, value]) => {
      const info = quantity(table, key);
      // Records, such as the spec of the design, are not listed.
      const record = typeof value === "object" && !Array.isArray(value);
      if (record || !info || info.type === "record") return [];
      const texts = (Array.isArray(value) ? value : [value]).map((one) => textOf(info, one)).join(" / ");
      return [h("dt", {}, info.words), h("dd", {}, `${texts} ${info.percent ? "%" : shownUnit(info)}`)];
    });
    const use = async () => {
      const text = await bench.front.call("tomlOf", { json: JSON.stringify(branch["spec"]) });
      this.list([], [], "");
      this.searched = bench.text;
      this.back.hidden = false;
      bench.setText(text, "branch " + i);
    };
    return h(
      "article",
      { class: "branch" },
      h("h3", {}, `Solution ${i + 1}`),
      h("dl", {}, ...facts),
      button("Use as the design", () => void use(), { class: "main" }),
    );
  }
}

function real(value: Json | undefined): number {
  return typeof value === "number" ? value : NaN;
}
function count(n: number): string {
  return n.toLocaleString("en").replaceAll(",", "\u202f");
}
/** Returns a sentence about the limit that rejected the most candidates, or "" if some design is feasible. */
function why(feasible: number, rejected: { [key: string]: Json | number }): string {
  if (feasible > 0) return "";
  const worst = Object.entries(rejected).sort((a, b) => Number(b[1]) - Number(a[1]))[0];
  return worst ? ` Most candidates violate the limit of ${worst[0].replaceAll("_", " ")}.` : "";
}
