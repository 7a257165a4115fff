// The table of the designs that a search has found. A click on a heading sorts the table. A click on a row,
// or Enter, chooses a design. Columns and digits follow the catalogue. Values that all designs share
// are listed above the table.

import type { Quantity } from "../../engine/engine";
import { objective, quantities } from "../catalogue";
import { button, fill, h, scroller, symbol, tableOf } from "../elements";
import type { Json } from "../engine_worker";
import { shownUnit, textOf } from "../numbers";

export type Design = { [key: string]: Json };
export interface Column {
  info: Quantity;
  // Position of the value: an index of a list, a key of a record, or −1 for the value itself.
  place: number | string;
  words: string;
}
const kShown = 200;
/** If there are fewer designs than this, the table shows every column. */
const kLeastForCommon = 3;
/** Words for the two ends of a range, and their indices in a symbol. */
const kEnds = ["least", "greatest"];
const kEndIndices = ["min", "max"];
/** The words that name the point of a design in its region, as in the search report. */
const kPlaces: Record<string, string> = { eq11: "balanced", lo_hi: "middle" };

/** Returns an identifier of a column. The same column of the next list has the same identifier. */
export function idOf(column: Column): string {
  return `${column.info.key}.${column.place}`;
}
export function cellOf(design: Design, column: Column): string {
  const value = valueIn(design, column);
  const place = column.info.key === "point" && typeof value === "string" ? kPlaces[value] : undefined;
  return place ?? textOf(column.info, value);
}
export function varies(designs: Design[], column: Column): boolean {
  const first = designs[0] && cellOf(designs[0], column);
  return designs.some((design) => cellOf(design, column) !== first);
}

export function valueIn(design: Design, column: Column): Json | undefined {
  const value = design[column.info.key];
  if (typeof column.place === "string") return (value as Design | null)?.[column.place];
  return column.place < 0 || !Array.isArray(value) ? value : value[column.place];
}

/** Returns the columns that users see and in which at least one design has a value. If the search has
 *  a single objective, its values have no name, and `only` is the name of this objective. */
export function columnsOf(designs: Design[], only: string): Column[] {
  const columns: Column[] = [];
  for (const info of quantities("search.designs")?.quantities ?? []) {
    if (!info.page && !info.listing && info.key !== "objective") continue;
    const values = designs.map((one) => one[info.key]).filter((one) => one !== null && one !== undefined);
    if (!values.length) continue;
    // Each objective is a column with its own words and unit.
    if (info.key === "objective") {
      const several = typeof values[0] === "object";
      for (const name of several ? Object.keys(values[0] as Design) : [only]) {
        const known = objective(name);
        const own: Quantity = known
          ? { ...info, words: known.words, symbol: known.symbol, unit: known.unit, digits: 4, type: "number", greaterFirst: known.better === "greater" }
          : info;
        columns.push({ info: own, place: several ? name : -1, words: own.words });
      }
      continue;
    }
    if (
      info.type === "record" ||
      info.type === "map" ||
      (typeof values[0] === "object" && !Array.isArray(values[0]))
    )
      continue;
    if (Array.isArray(values[0])) {
      const names = info.two === "ends" ? kEnds : ["gear 1", "gear 2"];
      values[0].forEach((_, place) =>
        columns.push({ info, place, words: `${info.words}, ${names[place] ?? place + 1}` }),
      );
    }
    else columns.push({ info, place: -1, words: info.words });
  }
  return columns;
}

/** Finds pairs of columns whose values differ at most in sign. Only one column of a pair is shown.
 *  The result maps the omitted column to the shown one. If one of the two columns is an objective,
 *  the objective is omitted. */
function twinsOf(designs: Design[], columns: Column[]): Map<Column, Column> {
  const read = new Map<string, Column>();
  const twins = new Map<Column, Column>();
  const last = (one: Column) => Number(one.info.key === "objective");
  for (const column of [...columns].sort((a, b) => last(a) - last(b))) {
    const value = (design: Design) => {
      const one = valueIn(design, column);
      return typeof one === "number" ? Math.abs(one).toPrecision(9) : cellOf(design, column);
    };
    const all = column.info.unit + designs.map(value).join();
    const other = read.get(all);
    if (other) twins.set(column, other);
    else read.set(all, column);
  }
  return twins;
}

export class SearchTable {
  private readonly common = h("p", { class: "soft common" });
  private readonly room = scroller("designs-scroll", "table of the designs");
  readonly element = h("div", { class: "designs-room" }, this.common, this.room);
  private designs: Design[] = [];
  private columns: Column[] = [];
  private order: number[] = [];
  private by = -1;
  private down = false;
  private taken = -1;
  private most = kShown;
  private front = new Set<number>();

  constructor(private readonly take: (row: number) => void) {}

  show(designs: Design[], front: number[], only: string): void {
    this.designs = designs;
    this.front = new Set(front);
    const columns = columnsOf(designs, only);
    const few = designs.length < kLeastForCommon;
    const different = columns.filter((one) => few || varies(designs, one));
    const twins = few ? new Map<Column, Column>() : twinsOf(designs, different);
    this.columns = different.filter((one) => !twins.has(one));
    const same = columns
      .filter((one) => !different.includes(one))
      .map((one) => `${one.words} ${cellOf(designs[0]!, one)} ${shownUnit(one.info)}`.trim());
    for (const [one, other] of twins) {
      const sign = (column: Column) => Math.sign(designs.map((of) => valueIn(of, column)).find(Boolean) as number);
      same.push(`${one.words} ${sign(one) === -sign(other) ? "opposite to" : "equal to"} ${other.words}`);
    }
    this.common.textContent = same.length ? `Common to all designs: ${same.join("; ")}.` : "";
    this.room.scrollTop = 0;
    this.by = -1;
    this.taken = -1;
    this.most = kShown;
    this.sort();
  }
  mark(row: number): void {
    this.taken = row;
    for (const line of this.element.querySelectorAll<HTMLElement>("tbody tr"))
      line.classList.toggle("taken", Number(line.dataset["row"]) === row);
  }

  private sort(): void {
    this.order = this.designs.map((_, row) => row);
    const column = this.columns[this.by];
    if (column) {
      const of = (row: number) => valueIn(this.designs[row]!, column);
      this.order.sort((a, b) => {
        const [x, y] = [of(a), of(b)];
        const less =
          typeof x === "number" && typeof y === "number" ? x - y : String(x).localeCompare(String(y));
        return this.down ? -less : less;
      });
    }
    this.draw();
  }

  private head(column: Column, index: number): HTMLElement {
    const { info, place, words } = column;
    const inList = typeof place === "number" && place >= 0;
    const end = inList && (info.two === "ends" ? kEndIndices[place] : place + 1);
    const suffix = inList ? (info.symbol.includes("_") ? "" : "_") + end : "";
    const name = info.symbol ? symbol(info.symbol + suffix) : words;
    const sortBy = button(
      "",
      () => {
        this.down = this.by === index ? !this.down : info.greaterFirst;
        this.by = index;
        this.sort();
      },
      { title: words },
    );
    // Screen readers do not read symbols well, so hidden words accompany the symbol.
    if (info.symbol) (name as HTMLElement).setAttribute("aria-hidden", "true");
    fill(
      sortBy,
      name,
      info.symbol ? h("span", { class: "unseen" }, words) : null,
      shownUnit(info) ? h("span", { class: "unit" }, " " + shownUnit(info)) : null,
    );
    return h(
      "th",
      { scope: "col", "aria-sort": this.by === index ? (this.down ? "descending" : "ascending") : null },
      sortBy,
    );
  }

  private draw(): void {
    const rows = this.order.slice(0, this.most).map((row) => {
      const design = this.designs[row]!;
      const take = () => this.take(row);
      return h(
        "tr",
        {
          "data-row": row,
          class:
            [row === this.taken ? "taken" : "", this.front.has(row) ? "front" : ""].join(" ").trim() || null,
          click: take,
        },
        h(
          "th",
          { scope: "row" },
          button(String(row + 1), () => undefined, { "aria-label": `take design ${row + 1}` }),
        ),
        ...this.columns.map((column) => h("td", {}, cellOf(design, column))),
      );
    });
    this.element.hidden = !rows.length;
    const rest = this.designs.length - rows.length;
    fill(
      this.room,
      tableOf(
        "designs",
        [h("th", { scope: "col" }, "No."), ...this.columns.map((column, i) => this.head(column, i))],
        ...rows,
      ),
      rest > 0
        ? button(
            `${rest} more`,
            () => {
              this.most += 1000;
              this.draw();
            },
            { class: "quiet" },
          )
        : null,
    );
  }
}
