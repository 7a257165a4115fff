// A row of a form: a key of the catalogue with a field at each place where it may stand, and below
// them the note of the field with the focus.

import type { InputKey } from "../../engine/engine";
import { quantity, unitOf, wordsOf } from "../catalogue";
import { h, symbol } from "../elements";
import type { Json } from "../engine_worker";
import { fixed, shownUnit, toShown } from "../numbers";
import { at, bench } from "../workbench";
import { makeField, makeNote, type Field, type Note } from "./field";

export interface RowField {
  key: InputKey;
  field: Field;
  note: Note;
}

/** What holds for a key that is absent: the result's value, else what the catalogue says. */
export function implied(key: InputKey, place: string): string {
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
    const said = quantity(gear >= 0 ? "gear" : "pair", rest[0]!);
    if (typeof value === "number" && said)
      return fixed(toShown(value, said.unit), said.digits)
        .replace(/(\.\d*?)0+$/, "$1")
        .replace(/\.$/, "");
  }
  const said = key.fallback.replace(/^"|"$/g, "");
  return /^-?[\d.]+$/.test(said) || key.words.includes(said) || said === "true" || said === "false"
    ? said
    : "";
}

/** Letters of a word, and of the label of two fields, that a row of numbers has room for. */
const kNarrow = 8;
const kShortLabel = 26;

/** A row with a label of its own line: words and lists are longer than numbers. */
function isWide(key: InputKey): boolean {
  if (key.kind === "text" || (key.list !== null && !key.list.single && key.list.most > 2)) return true;
  return key.kind !== "number" && key.words.some((word) => word.length > kNarrow);
}

/** `places` are those of a table of the catalogue: ["gear1.bore", "gear2.bore"] of "bore". */
export function makeRow(
  table: string,
  key: InputKey,
  places: string[],
): { elements: HTMLElement[]; fields: RowField[] } {
  const words = wordsOf(table, key);
  const note = makeNote();
  const fields = places.map((place) => {
    const who = /^gear[12]/.test(place) ? "gear " + place[4] : "";
    return { key, field: makeField(key, words, `${place}.${key.key}`, who, note), note };
  });
  const unit = shownUnit(unitOf(key));
  const two = places.length > 1;
  const stacked = two && (isWide(key) || words.length > kShortLabel);
  const kind = ["row", two ? "two" : "", stacked ? "stacked" : isWide(key) ? "wide" : ""].join(" ").trim();
  const label = h(
    "span",
    { class: "label", title: key.meaning },
    h("span", {}, words),
    " ",
    key.symbol ? symbol(key.symbol) : null,
    unit ? h("span", { class: "unit" }, " " + unit) : null,
  );
  return {
    elements: [h("div", { class: kind }, label, ...fields.map((one) => one.field.element)), note.element],
    fields,
  };
}
