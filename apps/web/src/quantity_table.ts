// A table of the quantities of a result, in the words, symbols, units and order of the catalogue.

import type { Quantity, QuantityTable } from "../engine/engine";
import { quantities } from "./catalogue";
import { fill, h, symbol, tableOf } from "./elements";
import type { Json } from "./engine_worker";
import { shownUnit, textOf } from "./numbers";

export interface Row {
  id: string;
  group: string;
  words: string;
  info: Quantity;
  values: (Json | undefined)[]; // one value, or one for each gear
  ends: (Json | undefined)[]; // values at both ends of the tolerances, if there are any
}

/** Makes the rows of a table. If `printed` is true, a record contains only the members that the program prints. */
export function rowsOf(
  table: QuantityTable,
  records: Json[],
  prefix: string,
  within = "",
  printed = false,
  intervals: (Json | undefined)[] = records.map((record) => member(record, "interval")),
  outer: Quantity | null = null,
): Row[] {
  const rows: Row[] = [];
  for (const info of table.quantities) {
    const values = records.map((record) => member(record, info.key));
    const ends = intervals.map((interval) => member(interval, info.key));
    if (values.every((value) => value === undefined || value === null)) continue;
    const id = `${prefix}.${info.key}`;
    if (info.type === "record" || info.type === "map") {
      const inner = quantities(info.of);
      if (inner && !info.list.length && (info.page || info.listing || !printed))
        rows.push(...rowsOf(inner, values as Json[], id, info.group || within, printed, ends, info));
      continue;
    }
    if (!info.page && !info.listing) continue;
    const perGear = records.length === 1 && info.two === "gears" && Array.isArray(values[0]);
    rows.push({
      id,
      group: info.group || within,
      words: wordsWithin(outer, info),
      info,
      values: perGear ? (values[0] as Json[]) : values,
      ends: perGear && Array.isArray(ends[0]) ? ends[0] : perGear ? [] : ends,
    });
  }
  const order = [...table.groups, ...rows.map((row) => row.group)];
  return rows.sort((a, b) => order.indexOf(a.group) - order.indexOf(b.group));
}

/** The words of a quantity in a record: "distance from A, point B", "specific sliding, gear 1". */
function wordsWithin(outer: Quantity | null, info: Quantity): string {
  if (!outer) return info.words;
  if (/^[A-E]$/.test(outer.key)) return `${info.words}, point ${outer.key}`;
  // If the catalogue has no words for a quantity, its words are the same as its key.
  if (info.words !== info.key && !/^gear [12]$/.test(info.words)) return info.words;
  const plain = (words: string) => words.replace(/_mm(_per_rad)?$/, "").replaceAll("_", " ");
  return `${plain(outer.words)}, ${plain(info.words)}`;
}

function member(record: Json | undefined, key: string): Json | undefined {
  return record && typeof record === "object" ? (record as { [key: string]: Json })[key] : undefined;
}

/** A value as text for users, and a second text with its values at both ends of the tolerances, the smaller
 *  value first. */
export function cellText(row: Row, i: number): [value: string, ends: string] {
  const ends = row.ends[i];
  const both = Array.isArray(ends) && ends.length === 2 && ends.every((one) => typeof one === "number");
  const value = textOf(row.info, row.values[i]);
  const sorted = both ? [...(ends as number[])].sort((a, b) => a - b) : [];
  return [value, sorted.map((one) => textOf(row.info, one)).join(" … ")];
}
export function fillCell(cell: Element, row: Row, i: number): void {
  const [value, ends] = cellText(row, i);
  const title = "at both ends of the tolerances";
  fill(cell, value, ends && h("small", { class: "ends", title }, ends));
}

export interface Extra {
  /** Texts that identify the group of a row. If one of them differs from the previous row, a new group
   *  starts. The last text is its heading. */
  headingOf?(row: Row, index: number): string[];
  /** An additional last column. */
  last?: { head: string; of(row: Row): string };
}

/** Makes a table with a column for each gear. Also returns the cells of each row. */
export function quantityTable(
  rows: Row[],
  gears: number,
  extra: Extra = {},
): { element: HTMLTableElement; cells: Map<string, HTMLElement[]> } {
  const all = new Map<string, HTMLElement[]>();
  const lines: HTMLElement[] = [];
  let group = "";
  rows.forEach((row, index) => {
    const heading = extra.headingOf?.(row, index) ?? [row.group];
    if (heading.join(": ") !== group) {
      group = heading.join(": ");
      const width = 3 + gears + (extra.last ? 1 : 0);
      lines.push(
        h("tr", { class: "group" }, h("th", { scope: "rowgroup", colspan: width }, heading[heading.length - 1])),
      );
    }
    const cells = row.values.map((_, i) => {
      const cell = h("td", {
        class: "value",
        "data-quantity": row.id,
        "data-column": i,
        colspan: row.values.length === 1 && gears > 1 ? gears : null,
      });
      fillCell(cell, row, i);
      return cell;
    });
    all.set(row.id, cells);
    const { info } = row;
    lines.push(
      h(
        "tr",
        {
          "data-words": `${row.words} ${info.symbol} ${info.key}`.toLowerCase(),
          title: info.meaning,
        },
        h("th", { scope: "row" }, row.words),
        h("td", {}, info.symbol ? symbol(info.symbol) : ""),
        h("td", { class: "unit" }, info.percent ? "%" : shownUnit(info)),
        ...cells,
        extra.last ? h("td", { class: "place" }, extra.last.of(row)) : null,
      ),
    );
  });
  const head = (words: string, style?: string) => h("th", { scope: "col", class: style }, words);
  const heads = [
    head("quantity"),
    head("symbol"),
    head("unit"),
    ...Array.from({ length: gears }, (_, i) => head(`gear ${i + 1}`, `value g${i + 1}`)),
    extra.last && head(extra.last.head),
  ];
  return { element: tableOf("quantities", heads, ...lines), cells: all };
}
