// A table of the rows of a result. The engine makes the rows, as it does for the program and the report.

import type { Row } from "../engine/engine";
import { fill, h, symbol, tableOf } from "./elements";

export function fillCell(cell: Element, row: Row, i: number): void {
  const [text] = cell.childNodes;
  // A text that replaces the text of the same node is laid out faster than a new node.
  if (text instanceof Text && cell.childNodes.length === 1 && !row.ends[i]) {
    text.data = row.texts[i]!;
    return;
  }
  const title = "at both ends of the tolerances";
  fill(cell, row.texts[i], row.ends[i] && h("small", { class: "ends", title }, row.ends[i]));
}

export interface Extra {
  untitled?: string; // heading of rows without a heading
  notes?: string; // heading of an additional last column with the notes of the rows
}

/** Makes a table with a column for each gear. Also returns the cells of each row. */
export function quantityTable(
  rows: Row[],
  gears: number,
  { untitled = "", notes }: Extra = {},
): { element: HTMLTableElement; cells: Map<string, HTMLElement[]> } {
  const all = new Map<string, HTMLElement[]>();
  const lines: HTMLElement[] = [];
  let group = "";
  for (const row of rows) {
    const keys = row.id.split(".");
    const heading = row.group || untitled;
    // The pair and the gears have groups of their own, even if their headings are equal.
    const here = heading && `${keys[0]}: ${heading}`;
    if (here !== group) {
      group = here;
      const width = 3 + gears + (notes ? 1 : 0);
      lines.push(h("tr", { class: "group" }, h("th", { scope: "rowgroup", colspan: width }, heading)));
    }
    const cells = row.texts.map((_, i) => {
      const cell = h("td", {
        class: "value",
        "data-quantity": row.id,
        "data-column": i,
        colspan: row.texts.length === 1 && gears > 1 ? gears : null,
      });
      fillCell(cell, row, i);
      return cell;
    });
    all.set(row.id, cells);
    lines.push(
      h(
        "tr",
        {
          "data-words": `${row.words} ${row.symbol} ${keys.at(-1)}`.toLowerCase(),
          title: row.meaning,
        },
        h("th", { scope: "row" }, row.words),
        h("td", {}, row.symbol ? symbol(row.symbol) : ""),
        h("td", { class: "unit" }, row.unit),
        ...cells,
        notes ? h("td", { class: "place" }, row.note) : null,
      ),
    );
  }
  const head = (words: string, style?: string) => h("th", { scope: "col", class: style }, words);
  const heads = [
    head("quantity"),
    head("symbol"),
    head("unit"),
    ...Array.from({ length: gears }, (_, i) => head(`gear ${i + 1}`, `value g${i + 1}`)),
    notes && head(notes),
  ];
  return { element: tableOf("quantities", heads, ...lines), cells: all };
}
