// Quantities of a result as a table, in the catalogue's words, symbols, units and order.

import type { Quantity, QuantityTable } from "../engine/engine";
import { quantities } from "./catalogue";
import { fill, h, symbol } from "./elements";
import type { Json } from "./engine_worker";
import { shownUnit, textOf } from "./numbers";

export interface Row {
  id: string;
  group: string;
  said: Quantity;
  words: string;
  values: (Json | undefined)[]; // one, or one per gear
  ends: (Json | undefined)[]; // of a value that a tolerance moves: at its lower and its upper end
}

/** `printed`: of records only those that the program prints, too. */
export function rowsOf(
  table: QuantityTable,
  records: Json[],
  prefix: string,
  within = "",
  printed = false,
  intervals: (Json | undefined)[] = records.map((record) => member(record, "interval")),
): Row[] {
  const rows: Row[] = [];
  for (const said of table.quantities) {
    const values = records.map((record) => member(record, said.key));
    const ends = intervals.map((interval) => member(interval, said.key));
    if (values.every((value) => value === undefined || value === null)) continue;
    const id = `${prefix}.${said.key}`;
    if (said.type === "record" || said.type === "map") {
      const inner = quantities(said.of);
      if (inner && !said.list.length && (said.page || said.listing || !printed))
        rows.push(...rowsOf(inner, values as Json[], id, said.group || within, printed, ends));
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
      ends: perGear && Array.isArray(ends[0]) ? ends[0] : perGear ? [] : ends,
    });
  }
  const order = [...table.groups, ...rows.map((row) => row.group)];
  return rows.sort((a, b) => order.indexOf(a.group) - order.indexOf(b.group));
}

function member(record: Json | undefined, key: string): Json | undefined {
  return record && typeof record === "object" ? (record as { [key: string]: Json })[key] : undefined;
}

/** A value as people read it, and below it what a tolerance makes of it. */
export function cellText(row: Row, i: number): [value: string, ends: string] {
  const ends = row.ends[i];
  const both = Array.isArray(ends) && ends.length === 2 && ends.every((one) => typeof one === "number");
  const value = textOf(row.said, row.values[i]);
  return [value, both ? ends.map((one) => textOf(row.said, one)).join(" … ") : ""];
}
export function fillCell(cell: Element, row: Row, i: number): void {
  const [value, ends] = cellText(row, i);
  const title = "at the lower and at the upper end of the tolerances";
  fill(cell, value, ends && h("small", { class: "ends", title }, ends));
}

interface Extra {
  /** What tells one group of rows from the next; its last word is the heading. */
  headingOf?(row: Row, index: number): string[];
  /** A column at the end. */
  last?: { head: string; of(row: Row): string };
}

/** The table, and of each row the cells of its values. */
export function quantityTable(
  rows: Row[],
  heads: string[],
  extra: Extra = {},
): { element: HTMLTableElement; cells: Map<string, HTMLElement[]> } {
  const all = new Map<string, HTMLElement[]>();
  const body = h("tbody");
  const columns = heads.length;
  let group = "";
  rows.forEach((row, index) => {
    const heading = extra.headingOf?.(row, index) ?? [row.group];
    if (heading.join(": ") !== group) {
      group = heading.join(": ");
      const width = 3 + columns + (extra.last ? 1 : 0);
      body.append(
        h("tr", { class: "group" }, h("th", { scope: "rowgroup", colspan: width }, heading[heading.length - 1])),
      );
    }
    const cells = row.values.map((_, i) => {
      const cell = h("td", {
        class: "value",
        "data-quantity": row.id,
        "data-column": i,
        colspan: row.values.length === 1 && columns > 1 ? columns : null,
      });
      fillCell(cell, row, i);
      return cell;
    });
    all.set(row.id, cells);
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
        extra.last ? h("td", { class: "place" }, extra.last.of(row)) : null,
      ),
    );
  });
  const head = (words: string, style?: string) => h("th", { scope: "col", class: style }, words);
  const element = h(
    "table",
    { class: "quantities" },
    h(
      "thead",
      {},
      h(
        "tr",
        {},
        head("quantity"),
        head("symbol"),
        head("unit"),
        ...heads.map((words) => head(words, /^gear [12]$/.test(words) ? `value g${words[5]}` : "value")),
        extra.last ? head(extra.last.head) : null,
      ),
    ),
    body,
  );
  return { element, cells: all };
}
