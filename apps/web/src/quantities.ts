// Every quantity of the result, in the catalogue's words and order: a search box, the values of both
// gears side by side, and a glow on what the last change has moved.

import type { Quantity, QuantityTable } from "../engine/engine";
import { quantities } from "./catalogue";
import { fill, h, symbol } from "./elements";
import type { Json } from "./engine_worker";
import { onUnitChange, shownUnit, textOf } from "./numbers";
import { bench } from "./workbench";

interface Row {
  id: string;
  group: string;
  said: Quantity;
  words: string;
  values: (Json | undefined)[]; // one, or one per gear
}

function rowsOf(table: QuantityTable, records: Json[], prefix: string, within = ""): Row[] {
  const rows: Row[] = [];
  for (const said of table.quantities) {
    const values = records.map((record) => (record as { [key: string]: Json } | null)?.[said.key]);
    if (values.every((value) => value === undefined || value === null)) continue;
    const id = `${prefix}.${said.key}`;
    if (said.type === "record" || said.type === "map") {
      const inner = quantities(said.of);
      if (inner && !said.list.length) rows.push(...rowsOf(inner, values as Json[], id, said.group || within));
      continue;
    }
    if (!said.page && !said.listing) continue;
    const perGear = records.length === 1 && said.two === "gears" && Array.isArray(values[0]);
    rows.push({
      id,
      group: said.group || within,
      said,
      words: said.words,
      values: perGear ? (values[0] as Json[]) : values,
    });
  }
  const order = [...table.groups, ...rows.map((row) => row.group)];
  return rows.sort((a, b) => order.indexOf(a.group) - order.indexOf(b.group));
}

export class QuantityPane {
  private readonly search = h("input", {
    type: "search",
    placeholder: "search quantities",
    "aria-label": "search quantities",
    input: () => this.filter(),
  });
  private readonly count = h("span", { class: "soft", "aria-live": "polite" });
  private readonly sheet = h("div", {
    class: "sheet",
    tabindex: "0",
    role: "region",
    "aria-label": "quantities",
  });
  readonly element = h(
    "section",
    { class: "numbers", "aria-label": "numbers" },
    h("div", { class: "numbers-head" }, this.search, this.count),
    this.sheet,
  );
  private signature = "";
  private cells = new Map<string, HTMLElement[]>();
  private rows: Row[] = [];

  constructor() {
    bench.on("solved", () => this.update());
    onUnitChange(() => {
      this.signature = "";
      this.update();
    });
  }

  update(): void {
    const result = bench.solved?.result;
    this.element.classList.toggle("stale", !result && bench.good !== null);
    this.element.classList.toggle("asking", bench.asks);
    if (!result) return;
    const gearTable = quantities("gear");
    const pairTable = quantities("pair");
    const gears = gearTable ? rowsOf(gearTable, (result["gears"] ?? []) as Json[], "gears") : [];
    const pair = pairTable && result["pair"] ? rowsOf(pairTable, [result["pair"]], "pair") : [];
    this.rows = [...pair, ...gears];
    const columns = ((result["gears"] as Json[] | undefined) ?? []).length;
    const signature = columns + this.rows.map((row) => row.id + row.values.length).join();
    if (signature !== this.signature) {
      this.signature = signature;
      this.build(columns, pair.length);
      return;
    }
    for (const row of this.rows) {
      const cells = this.cells.get(row.id)!;
      row.values.forEach((value, i) => {
        const text = textOf(row.said, value);
        const cell = cells[i]!;
        if (cell.textContent === text) return;
        cell.textContent = text;
        cell.classList.remove("glow");
        void cell.offsetWidth; // starts the glow anew
        cell.classList.add("glow");
      });
    }
  }

  private build(columns: number, pairRows: number): void {
    this.cells.clear();
    const body = h("tbody");
    let group = "";
    this.rows.forEach((row, index) => {
      const heading = (index < pairRows ? "Pair: " : "Gears: ") + row.group;
      if (heading !== group) {
        group = heading;
        body.append(
          h("tr", { class: "group" }, h("th", { scope: "rowgroup", colspan: 3 + columns }, row.group)),
        );
      }
      const cells = row.values.map((value, i) =>
        h(
          "td",
          {
            class: "value",
            "data-quantity": row.id,
            "data-column": i,
            colspan: row.values.length === 1 && columns > 1 ? columns : null,
          },
          textOf(row.said, value),
        ),
      );
      this.cells.set(row.id, cells);
      body.append(
        h(
          "tr",
          {
            "data-words": `${row.words} ${row.said.symbol} ${row.said.key}`.toLowerCase(),
            title: row.said.meaning,
          },
          h("th", { scope: "row" }, row.words),
          h("td", {}, row.said.symbol ? symbol(row.said.symbol) : ""),
          h("td", { class: "unit" }, shownUnit(row.said.percent ? "%" : row.said.unit)),
          ...cells,
        ),
      );
    });
    const heads = Array.from({ length: columns }, (_, i) =>
      h("th", { scope: "col", class: `value g${i + 1}` }, `gear ${i + 1}`),
    );
    fill(
      this.sheet,
      h(
        "table",
        { class: "quantities" },
        h(
          "thead",
          {},
          h(
            "tr",
            {},
            h("th", { scope: "col" }, "quantity"),
            h("th", { scope: "col" }, "symbol"),
            h("th", { scope: "col" }, "unit"),
            ...heads,
          ),
        ),
        body,
      ),
    );
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
