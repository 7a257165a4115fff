// One field of the form. It shows the value of one key at one path of the spec.
//
// The user types a number, changes it with the arrow keys, or moves a slider. While a field has the focus,
// the note below its row shows the meaning of the key, its range, and a slider around the value. The note
// also shows errors of the value.

import type { InputKey } from "../../engine/engine";
import { materials, rangeOf } from "../catalogue";
import { h, onKeys } from "../elements";
import type { Json } from "../engine_worker";
import { fromShown, niceStep, onStep, short, shownUnit, toShown } from "../numbers";
import { bench } from "../workbench";

export interface Field {
  place: string; // "gear1.profile_shift"
  element: HTMLElement;
  /** Shows the value in the spec. If the spec has no value, shows the default `implied`. */
  show(value: Json | undefined, implied: string): void;
  fault(sentence: string | null): void;
}

/** The number of letters that fit into a field. In the form, in a panel and in a list of choices,
 *  the label is beside the field. `line` is a field on a line of its own. */
const kLetters = { form: 8, panel: 7, chooser: 7, line: 24 };
/** Moves the fields of a row below their label if a value does not fit beside it. */
function makeRoom(field: HTMLElement): void {
  const row = field.closest(".row");
  const most = field.closest(".key-panel") ? kLetters.panel : kLetters.form;
  const letters = (one: HTMLInputElement | HTMLSelectElement) => {
    const text = one instanceof HTMLInputElement ? one.value || one.placeholder : one.selectedOptions[0]?.text;
    return text?.length ?? 0;
  };
  const fields = [...(row?.querySelectorAll<HTMLInputElement | HTMLSelectElement>("input, select") ?? [])];
  const over = (one: HTMLInputElement | HTMLSelectElement) =>
    letters(one) > (one instanceof HTMLSelectElement ? kLetters.chooser : most);
  row?.classList.toggle("long", fields.some(over));
  row?.classList.toggle("longest", fields.some((one) => letters(one) > kLetters.line));
}

/** The note, which belongs to the field that has the focus. */
export interface Note {
  element: HTMLElement;
  open(key: InputKey, slider: HTMLElement | null): void;
  fault(sentence: string | null): void;
}

export function makeNote(): Note {
  const meaning = h("p", { class: "meaning" });
  const fault = h("p", { class: "fault", role: "alert" });
  const slot = h("div", { class: "slot" });
  const element = h("div", { class: "note" }, fault, slot, meaning);
  element.hidden = true;
  const show = () => (element.hidden = !fault.textContent && !element.classList.contains("open"));
  return {
    element,
    open(key, slider) {
      const range = rangeOf(key);
      meaning.textContent = `${key.meaning}${range ? "; " + range : ""}${key.fallback ? ". Default: " + key.fallback : ""}.`;
      slot.replaceChildren(...(slider ? [slider] : []));
      element.classList.add("open");
      show();
    },
    fault(sentence) {
      fault.textContent = sentence ?? "";
      show();
    },
  };
}

export function numberIn(text: string): number {
  const plain = text
    .trim()
    .replace("−", "-")
    .replace(/^([^.]*),([^,]*)$/, "$1.$2");
  return plain === "" ? NaN : Number(plain);
}

/** Converts a list that was typed as "contact ratio, sliding" to the words of a spec. */
function wordsIn(text: string): string[] {
  const parts = text.split(/[,;]+/).map((part) => part.trim().replaceAll(/\s+/g, "_"));
  return parts.filter(Boolean);
}

/** Converts a text to a value of this key. Returns null if the text is neither a number nor a
 *  permitted word. The engine checks the words of a list. */
function valueOf(key: InputKey, text: string): { value: Json | undefined } | null {
  const plain = text.trim();
  if (plain === "") return { value: undefined };
  if (key.kind === "text") return { value: text };
  const word = key.words.find((one) => one === plain || one.replaceAll("_", " ") === plain);
  if (word !== undefined) return { value: word };
  if (key.list) {
    const inner = plain.replace(/^\[|\]$/g, "");
    const parts = inner.split(/[,;…\s]+/).filter(Boolean);
    const numbers = parts.map(numberIn);
    if (numbers.some(Number.isNaN)) return key.kind === "word" ? { value: wordsIn(inner) } : null;
    const shown = numbers.map((one) => fromShown(one, key));
    return { value: shown.length === 1 && key.list.single ? shown[0]! : shown };
  }
  const number = numberIn(plain);
  return Number.isNaN(number) ? null : { value: fromShown(number, key) };
}

function shown(key: InputKey, value: Json | undefined): string {
  if (value === undefined || value === null) return "";
  if (Array.isArray(value)) return value.map((one) => shown(key, one)).join(", ");
  if (typeof value === "number") return short(toShown(value, key));
  if (key.kind === "word" && !String(value).includes(".")) return String(value).replaceAll("_", " ");
  return typeof value === "object" ? "(in the text)" : String(value);
}

/** True if the key is the name of a material. Its field then offers the table of materials. */
function isMaterial(key: InputKey, place: string): boolean {
  return key.key === "name" && place.endsWith(".material.name");
}

/** Returns the options of a field for materials, which are the names grouped by kind. */
export function materialGroups(): HTMLElement[] {
  const groups = new Map<string, HTMLElement>();
  for (const { name, kind, note } of materials()) {
    if (!groups.has(kind)) groups.set(kind, h("optgroup", { label: note.replace(/,.*$/, "") }));
    groups.get(kind)!.append(h("option", { value: name, title: note }, name));
  }
  return [...groups.values()];
}

function chooser(key: InputKey, place: string, label: string): Field {
  const yesNo = key.kind === "boolean";
  const option = (word: string, words = word) => h("option", { value: word }, words);
  const options = yesNo
    ? [option("true", "yes"), option("false", "no")]
    : isMaterial(key, place)
      ? materialGroups()
      : key.words.map((word) => option(word, word.replaceAll("_", " ")));
  const none = h("option", { value: "" }, "–");
  const select = h(
    "select",
    {
      "aria-label": label,
      "data-key": place,
      change: () =>
        bench.setKey(place, select.value === "" ? undefined : yesNo ? select.value === "true" : select.value),
    },
    none,
    ...options,
  );
  return {
    place,
    element: select,
    show(value, implied) {
      const absent = yesNo ? { true: "yes", false: "no" }[implied] : implied.replaceAll("_", " ");
      none.textContent = absent || "–";
      const meant = value === undefined || typeof value === "object" ? "" : String(value);
      if (key.kind === "text" && ![...select.options].some((one) => one.value === meant))
        select.append(option(meant)); // a name that is not in the table
      select.value = meant;
      select.classList.toggle("implied", value === undefined);
      makeRoom(select);
    },
    fault: (sentence) => void select.setAttribute("aria-invalid", String(sentence !== null)),
  };
}

export function makeField(key: InputKey, named: string, place: string, who: string, note: Note): Field {
  const label = [named, who, shownUnit(key)].filter(Boolean).join(", ");
  const words = key.words.length > 0 && !key.list && key.kind !== "number";
  if (key.kind === "boolean" || words || isMaterial(key, place)) {
    const field = chooser(key, place, label);
    field.element.addEventListener("focus", () => note.open(key, null));
    return field;
  }
  const numeric = (key.kind === "number" || key.kind === "whole") && (!key.list || key.list.single);
  let current: Json | undefined;
  let mine: string | null = null; // the text that the user is typing here

  const input = h("input", {
    type: "text",
    inputmode: numeric ? "text" : null,
    "aria-label": label,
    "data-key": place,
    autocomplete: "off",
    spellcheck: "false",
    class: numeric ? "number" : null,
  });
  const slider = numeric
    ? h("input", { type: "range", "aria-label": label + ", slider", tabindex: "-1" })
    : null;

  const send = (text: string) => {
    const meant = valueOf(key, text);
    if (!meant) return note.fault(`“${text.slice(0, 60)}” is not ${key.form || "a number"}.`);
    note.fault(null);
    bench.setKey(place, meant.value);
  };
  const base = () =>
    typeof current === "number" ? toShown(current, key) : numberIn(input.placeholder) || 0;
  const stepOf = (value: number) =>
    key.kind === "whole"
      ? 1
      : niceStep(Math.max(Math.abs(value), key.unit === "°" || key.unit === "µm" ? 10 : 1), 50);

  function aim(): void {
    if (!slider) return;
    const value = base();
    const step = stepOf(value);
    const reach = key.kind === "whole" ? Math.max(10, Math.round(Math.abs(value))) : 50 * step;
    const end = (limit: number | null | undefined, open: boolean | undefined, sign: number) =>
      limit === null || limit === undefined
        ? -sign * Infinity
        : toShown(limit, key) + (open ? sign * step : 0);
    slider.min = String(Math.max(onStep(value - reach, step), end(key.range?.lo, key.range?.loOpen, 1)));
    slider.max = String(Math.min(onStep(value + reach, step), end(key.range?.hi, key.range?.hiOpen, -1)));
    slider.step = String(step);
    slider.value = String(value);
  }

  input.addEventListener("input", () => {
    mine = input.value;
    send(input.value);
  });
  input.addEventListener("focus", () => {
    aim();
    note.open(key, slider);
  });
  input.addEventListener("blur", () => {
    mine = null;
    field.show(current, input.placeholder);
  });
  const arrow = (event: KeyboardEvent, sign: 1 | -1) => {
    const step = stepOf(base()) * (event.shiftKey ? 10 : 1);
    let value = onStep(base() + sign * step, key.kind === "whole" ? 1 : step / 100);
    if (key.range && !key.range.zero && value === 0) value += sign;
    mine = null;
    input.value = short(value);
    send(input.value);
  };
  if (numeric) onKeys(input, { ArrowUp: (event) => arrow(event, 1), ArrowDown: (event) => arrow(event, -1) });
  slider?.addEventListener("input", () => {
    mine = null;
    if (key.range && !key.range.zero && Number(slider.value) === 0) return;
    input.value = short(Number(slider.value));
    send(input.value);
  });

  const field: Field = {
    place,
    element: input,
    show(value, implied) {
      current = value;
      input.placeholder = implied;
      if (mine === null || document.activeElement !== input) {
        input.value = shown(key, value);
        makeRoom(input);
      }
      input.readOnly = value !== null && typeof value === "object" && !Array.isArray(value);
      if (slider) slider.hidden = Array.isArray(value);
      if (slider && document.activeElement !== slider) slider.value = String(base());
    },
    fault: (sentence) => void input.setAttribute("aria-invalid", String(sentence !== null)),
  };
  return field;
}
