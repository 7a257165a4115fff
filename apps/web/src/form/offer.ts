// Offers inputs that a result needs and that the spec lacks. The offer consists of a few fields
// with sensible initial values, and a button. The values are written into the spec only when the
// user presses the button.

import type { InputKey } from "../../engine/engine";
import { inputKey, wordsOf } from "../catalogue";
import { fill, h, symbol } from "../elements";
import type { Json } from "../engine_worker";
import { shownUnit } from "../numbers";
import { at, bench } from "../workbench";
import { materialGroups, numberIn } from "./field";

export interface Offered {
  table: string; // table of the catalogue
  key: string;
  places: string[]; // the value is written to all these places: "rating.speed_rpm",
                    // "gear1.material.name"
  instead?: string[]; // keys that make this key unnecessary if they are given
  first(): Json; // initial value; "" for the material that applies if no name is given
}

export class Offer {
  private readonly rows = h("div", { class: "offer-rows" });
  private readonly wrong = h("p", { class: "fault", role: "alert" });
  private shown = "";
  private fields: { of: Offered; input: HTMLInputElement | HTMLSelectElement }[] = [];
  readonly element: HTMLFormElement;

  constructor(
    words: string,
    go: string,
    private readonly offered: Offered[],
  ) {
    this.element = h(
      "form",
      { class: "offered", novalidate: true, submit: (event: Event) => this.submit(event) },
      h("p", {}, words),
      this.rows,
      this.wrong,
      h("button", { type: "submit", class: "main" }, go),
    );
    this.element.hidden = true;
  }

  hide(): void {
    this.element.hidden = true;
    this.shown = "";
  }
  /** Shows a field for each value that the spec lacks. */
  show(): void {
    const spec = bench.good?.spec ?? null;
    const given = (place: string) => at(spec, place) !== undefined;
    const missing = this.offered.filter(
      (one) => !one.instead?.some(given) && !one.places.every(given),
    );
    const signature = missing.map((one) => one.key).join() + bench.design;
    if (signature !== this.shown) this.build(missing);
    this.shown = signature;
    this.element.hidden = false;
  }

  private build(missing: Offered[]): void {
    this.wrong.textContent = "";
    this.fields = [];
    fill(
      this.rows,
      ...missing.flatMap((of) => {
        const key = inputKey(of.table, of.key);
        return key ? [this.row(of, key)] : [];
      }),
    );
  }

  private row(of: Offered, key: InputKey): HTMLElement {
    const material = of.table === "material";
    const words = material ? "material" : wordsOf(of.table, key);
    const first = String(of.first());
    const input = material
      ? h("select", {}, !first && h("option", { value: "" }, "steel"), ...materialGroups())
      : h("input", { type: "text", inputmode: "decimal", class: "number", autocomplete: "off" });
    input.value = first;
    input.setAttribute("aria-label", [words, shownUnit(key)].filter(Boolean).join(", "));
    input.dataset["offered"] = of.places[0]!;
    this.fields.push({ of, input });
    return h(
      "label",
      { class: "offer-row", title: key.meaning },
      h("span", {}, words, " ", key.symbol ? symbol(key.symbol) : null),
      input,
      h("span", { class: "unit" }, shownUnit(key)),
    );
  }

  private submit(event: Event): void {
    event.preventDefault();
    const spec = bench.good?.spec ?? null;
    const values: [string, Json][] = [];
    for (const { of, input } of this.fields) {
      const text = input.value.trim();
      // The empty choice stands for the material that applies if no name is given.
      if (input instanceof HTMLSelectElement && !text) continue;
      const value = input instanceof HTMLSelectElement ? text : numberIn(text);
      if (Number.isNaN(value)) {
        this.wrong.textContent = `“${text.slice(0, 40)}” is not a number.`;
        return input.focus();
      }
      for (const place of of.places) if (at(spec, place) === undefined) values.push([place, value]);
    }
    for (const [place, value] of values) bench.setKey(place, value);
  }
}

/** Returns the number at the first of these places where the spec has one. */
function numberAt(places: string[]): number | null {
  for (const place of places) {
    const value = at(bench.good?.spec ?? null, place);
    const one = Array.isArray(value) ? value[0] : value;
    if (typeof one === "number") return one;
  }
  return null;
}

/** Tangential force divided by face width and module, F_t/(b m_n), N/mm². This is a light load for
 *  ordinary steel teeth. */
const kUnitLoad = 20;

/** Returns the torque that the spec gives, directly or by power and speed. Otherwise returns a torque
 *  of 1, 2 or 5 times a power of ten that loads the teeth lightly. */
export function firstTorque(): number {
  const given = numberAt(["load.torque_Nm", "rating.torque_Nm"]);
  if (given !== null) return given;
  const power = numberAt(["rating.power_kW"]);
  const speed = numberAt(["rating.speed_rpm"]);
  if (power !== null && speed !== null) return Number(((power * 30_000) / (Math.PI * speed)).toPrecision(3));
  const gears = (bench.good?.result?.["gears"] ?? []) as { [key: string]: Json }[];
  const of = (gear: { [key: string]: Json } | undefined, key: string) => Math.abs(Number(gear?.[key])) || 0;
  const face = Math.min(...gears.map((gear) => of(gear, "face_width_mm")));
  const torque =
    (kUnitLoad * face * of(gears[0], "normal_module_mm") * of(gears[0], "reference_diameter_mm")) / 2000;
  if (!(torque > 0) || !Number.isFinite(torque)) return 10;
  const ten = 10 ** Math.floor(Math.log10(torque));
  return Number(((torque < 2 * ten ? 1 : torque < 5 * ten ? 2 : 5) * ten).toPrecision(3));
}
export function firstSpeed(): number {
  return numberAt(["rating.speed_rpm", "pair.speed_rpm"]) ?? 1500;
}
/** Returns the material that the spec gives for a gear. If there is none, returns `otherwise`. */
export function firstMaterial(otherwise: string): string {
  const names = ["gear1", "gear2"].map((gear) => at(bench.good?.spec ?? null, `${gear}.material.name`));
  return (names.find((name) => typeof name === "string") as string | undefined) ?? otherwise;
}
