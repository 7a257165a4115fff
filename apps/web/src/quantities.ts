// Shows every quantity of the result, in the words and the order of the catalogue, with the values of both
// gears side by side. A search box filters the quantities. Values that the last change has altered are
// highlighted.

import type { Row } from "../engine/engine";
import { fill, h, scroller } from "./elements";
import { onUnitChange } from "./numbers";
import { Pause } from "./pauses";
import { fillCell, quantityTable } from "./quantity_table";
import { markRevision } from "./revision";
import { bench } from "./workbench";

/** Pause after the last change before the highlight of altered values begins to fade, ms. */
const kFadeMs = 150;

export class QuantityPane {
  private readonly search = h("input", {
    type: "search",
    placeholder: "search quantities",
    "aria-label": "search quantities",
    input: () => this.filter(),
  });
  private readonly count = h("span", { class: "soft", "aria-live": "polite" });
  private readonly sheet = scroller("sheet", "quantities");
  readonly element = h(
    "section",
    { class: "numbers", "aria-label": "numbers" },
    h("div", { class: "numbers-head" }, this.search, this.count),
    this.sheet,
  );
  private signature = "";
  private shown = ""; // the text of the spec to which the shown numbers belong
  private cells = new Map<string, HTMLElement[]>();
  private rows: Row[] = [];
  private readonly altered = new Set<HTMLElement>();
  private readonly glow = new Pause(kFadeMs);

  constructor() {
    bench.on("read", () => this.update());
    bench.on("text", () => this.age());
    bench.on("opened", () => this.clear());
    onUnitChange(() => bench.again());
  }

  /** Dims the table of numbers if it does not belong to the spec on screen. */
  private age(): void {
    markRevision(this.sheet, this.shown, bench.text, !bench.settled);
  }
  private clear(): void {
    this.signature = this.shown = "";
    this.rows = [];
    fill(this.sheet);
    this.count.textContent = "";
    this.age();
  }

  update(): void {
    const { solved } = bench;
    this.element.classList.toggle("unsolved", bench.finder !== undefined);
    this.age();
    if (!solved?.rows && !bench.good) this.clear();
    if (!solved?.rows) return;
    this.shown = solved.text;
    this.age();
    if (solved.rows === this.rows && this.signature) return;
    const before = this.rows;
    this.rows = solved.rows;
    const signature = solved.gears + this.rows.map((row) => row.id + row.unit + row.texts.length).join();
    if (signature !== this.signature) {
      this.signature = signature;
      const table = quantityTable(this.rows, solved.gears, { untitled: "Drive" });
      this.cells = table.cells;
      this.altered.clear();
      fill(this.sheet, table.element);
      this.filter();
      return;
    }
    this.rows.forEach((row, k) => {
      const old = before[k]!;
      row.texts.forEach((text, i) => {
        if (old.texts[i] !== text || old.ends[i] !== row.ends[i]) this.alter(row, i);
      });
    });
    this.glow.run(() => this.fade());
  }

  /** Shows and highlights a new value. */
  private alter(row: Row, i: number): void {
    const cell = this.cells.get(row.id)![i]!;
    fillCell(cell, row, i);
    cell.classList.remove("glow");
    cell.classList.add("altered");
    this.altered.add(cell);
  }
  /** Lets the highlights fade. While values change in every frame, they do not fade, because the browser would
   *  paint each fading cell again in every frame. */
  private fade(): void {
    for (const cell of this.altered) cell.classList.replace("altered", "glow");
    this.altered.clear();
  }

  private filter(): void {
    const words = this.search.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    let heading: HTMLElement | null = null;
    for (const row of this.sheet.querySelectorAll<HTMLElement>("tbody tr")) {
      if (row.classList.contains("group")) {
        heading = row;
        heading.hidden = true;
        continue;
      }
      row.hidden = !words.every((word) => row.dataset["words"]!.includes(word));
      if (row.hidden) continue;
      ++shown;
      if (heading) heading.hidden = false;
    }
    this.count.textContent = words.length
      ? `${shown} of ${this.rows.length}`
      : `${this.rows.length} quantities`;
  }
}
