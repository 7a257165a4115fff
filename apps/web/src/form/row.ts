// A row of the form for one key of the catalogue, with a field for each gear or table that has the
// key. Below the fields is the note of the field that has the focus.

import type { InputKey } from "../../engine/engine";
import { quantity, wordsOf } from "../catalogue";
import { h, symbol } from "../elements";
import type { Fault, Json } from "../engine_worker";
import { shownText, shownUnit } from "../numbers";
import { at, bench } from "../workbench";
import { makeField, makeNote, type Field, type Note } from "./field";

interface RowField {
  key: InputKey;
  field: Field;
  note: Note;
  shown: string; // the value and the default that the field shows, as JSON
}

/** Number of decimals of a limit in mm, which gives 0.1 µm. */
const kLimitDigits = 4;
/** Returns a value without zeros at its end. */
function trimmed(value: number, key: InputKey, digits: number): string {
  return shownText(value, key, digits)
    .replace(/(\.\d*?)0+$/, "$1")
    .replace(/\.$/, "");
}

/** Returns the value that applies if the key is absent. It is the value in the result, or the default of the
 *  catalogue. */
function implied(key: InputKey, place: string): string {
  const [head, ...rest] = place.split(".");
  const result = bench.solved?.result ?? bench.good?.result ?? null;
  if (rest.length === 1 && result) {
    const gear = head === "gear1" ? 0 : head === "gear2" ? 1 : -1;
    const owner =
      gear >= 0
        ? (result["gears"] as Json[] | undefined)?.[gear]
        : head === "pair"
          ? result["pair"]
          : undefined;
    const value = at(owner, rest[0]!);
    const info = quantity(gear >= 0 ? "gear" : "pair", rest[0]!);
    if (typeof value === "number" && info) return trimmed(value, key, info.digits);
    // If the value follows from a tolerance, the result contains the two limits of the value.
    const ends = at(owner, `interval.${rest[0]}`) as Json[] | undefined;
    if (ends?.length === 2 && ends.every((one) => typeof one === "number"))
      return [...(ends as number[])]
        .sort((a, b) => a - b)
        .map((one) => trimmed(one, key, kLimitDigits))
        .join(" … ");
  }
  const info = key.fallback.replace(/^"|"$/g, "");
  return /^-?[\d.]+$/.test(info) || key.words.includes(info) || info === "true" || info === "false"
    ? info
    : "";
}

/** The greatest number of letters of a word in a field, and of the label, in a row with two fields. */
const kNarrow = 8;
const kShortLabel = 26;

/** True if the fields of a row are wide (words or lists), so its label needs a separate line. */
function isWide(key: InputKey): boolean {
  if (key.kind === "text" || (key.list !== null && !key.list.single && key.list.most > 2)) return true;
  return key.kind !== "number" && key.words.some((word) => word.length > kNarrow);
}

/** Returns the headings above the columns of fields, "gear 1" and "gear 2". */
export function columnHeads(places: string[]): (HTMLElement | null)[] {
  return places.map((place) =>
    place.startsWith("gear") ? h("span", { class: "g" + place[4] }, "gear " + place[4]) : null,
  );
}

/** Rows of fields. Shows the errors that the engine reports for them. */
export class Rows {
  private fields: RowField[] = [];

  get empty(): boolean {
    return !this.fields.length;
  }
  clear(): void {
    this.fields = [];
  }
  /** Adds a row for each key of a table. `places` are the paths of this table in the spec, such as
   *  ["gear1.bore", "gear2.bore"] for "bore". */
  add(table: string, keys: InputKey[], places: string[]): HTMLElement {
    return h("div", { class: "rows" }, ...keys.flatMap((key) => this.row(table, key, places)));
  }
  show(spec: Json): void {
    for (const one of this.fields) {
      const value = at(spec, one.field.place);
      const absent = implied(one.key, one.field.place);
      const shown = JSON.stringify([value, absent]);
      // If the engine has rejected a value, the field must show the value of the spec again.
      if (shown === one.shown && !bench.solved?.fault) continue;
      one.shown = shown;
      one.field.show(value, absent);
    }
  }
  /** Shows an error at its field. If `within` is true, the error of a missing table is shown at the first
   *  field of this table. */
  blame(fault: Fault | null, within = false): Field | undefined {
    for (const { field, note } of this.fields) {
      field.fault(null);
      note.fault(null);
    }
    if (!fault?.key) return undefined;
    const find = (fits: (place: string) => boolean) => this.fields.find(({ field }) => fits(field.place));
    const blamed =
      find((place) => place === fault.key) ?? find((place) => within && place.startsWith(fault.key + "."));
    blamed?.field.fault(fault.message);
    blamed?.note.fault(fault.message);
    return blamed?.field;
  }

  private row(table: string, key: InputKey, places: string[]): HTMLElement[] {
    const words = wordsOf(table, key);
    const note = makeNote();
    const fields = places.map((place) => {
      const gear = /^gear[12]/.test(place) ? "gear " + place[4] : "";
      return makeField(key, words, `${place}.${key.key}`, gear, note);
    });
    this.fields.push(...fields.map((field) => ({ key, field, note, shown: "" })));
    const unit = shownUnit(key);
    const two = places.length > 1;
    const stacked = two && (isWide(key) || words.length > kShortLabel);
    const style = ["row", two ? "two" : "", stacked ? "stacked" : isWide(key) ? "wide" : ""];
    const label = h(
      "span",
      { class: "label", title: key.meaning },
      h("span", {}, words),
      " ",
      key.symbol ? symbol(key.symbol) : null,
      unit ? h("span", { class: "unit" }, " " + unit) : null,
    );
    const elements = fields.map((one) => one.element);
    return [h("div", { class: style.filter(Boolean).join(" ") }, label, ...elements), note.element];
  }
}
