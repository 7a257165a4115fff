// Shows every quantity of the result, in the words and the order of the catalogue, with the values of both
// gears side by side. A search box filters the quantities. Values that the last change has altered are
// highlighted.

import { quantities, quantity } from "./catalogue";
import { fill, h, scroller } from "./elements";
import type { Json } from "./engine_worker";
import { onUnitChange } from "./numbers";
import { cellText, fillCell, quantityTable, rowsOf, type Row } from "./quantity_table";
import { markRevision } from "./revision";
import { at, bench } from "./workbench";

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
  private result: unknown = null; // the result whose numbers are shown

  constructor() {
    bench.on("solved", () => this.update());
    bench.on("text", () => this.age());
    bench.on("opened", () => this.clear());
    onUnitChange(() => {
      this.signature = "";
      this.update();
    });
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
    const result = bench.solved?.result;
    this.element.classList.toggle("unsolved", bench.finder !== undefined);
    this.age();
    if (!result && !bench.good) this.clear();
    if (!result) return;
    this.shown = bench.solved!.text;
    this.age();
    if (result === this.result && this.signature) return;
    this.result = result;
    const records = (result["gears"] ?? []) as Json[];
    const rack = at(records[1], "form") === "rack";
    const gears = rowsOf(quantities("gear")!, records, "gears");
    const pairTable = quantities(rack ? "rack_pair" : "pair")!;
    const drive = result["drive"] ? rowsOf(quantities("drive")!, [result["drive"]], "drive") : [];
    const pair = result["pair"] ? rowsOf(pairTable, [result["pair"]], "pair") : drive;
    this.rows = [...pair, ...gears];
    if (rack) {
      const table = quantities("rack")!;
      const own = table.quantities.filter((info) => !quantity("gear", info.key));
      this.rows.push(...rowsOf({ ...table, quantities: own }, [null, records[1]!], "gears"));
    }
    const columns = records.length;
    const signature = columns + this.rows.map((row) => row.id + row.values.length).join();
    if (signature !== this.signature) {
      this.signature = signature;
      this.build(columns, pair.length);
      return;
    }
    for (const row of this.rows) {
      const cells = this.cells.get(row.id)!;
      row.values.forEach((_, i) => {
        const cell = cells[i]!;
        if (cell.textContent === cellText(row, i).join("")) return;
        fillCell(cell, row, i);
        cell.classList.remove("glow");
        void cell.offsetWidth; // a forced layout restarts the highlight
        cell.classList.add("glow");
      });
    }
  }

  private build(columns: number, pairRows: number): void {
    const table = quantityTable(this.rows, columns, {
      headingOf: (row, index) => [index < pairRows ? "Pair" : "Gears", row.group || "Drive"],
    });
    this.cells = table.cells;
    fill(this.sheet, table.element);
    this.filter();
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
