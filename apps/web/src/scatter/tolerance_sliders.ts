// Shows a slider for half of the width of each tolerance in [scatter], and a slider for the accuracy grade of
// the teeth. The middle of a range does not change. A double click or the key 0 sets the width of a range to 0.

import type { InputKey } from "../../engine/engine";
import { inputKey, wordsOf } from "../catalogue";
import { fill, h } from "../elements";
import type { Json } from "../engine_worker";
import { keySlider, type KeySlider } from "../key_slider";
import { amount, niceStep, onStep, shownUnit } from "../numbers";
import { at, bench } from "../workbench";

type Tree = { [key: string]: Json };
interface Tolerance {
  place: string; // path in the spec of the range or the radius
  table: string; // table of the key in the catalogue
  key: InputKey;
}
/** For each unit, the upper end of the slider if the width in the spec is 0. */
const kReach: Record<string, number> = { "°": 0.05, µm: 10, mm: 0.05 };

/** Keys that have a single number instead of a range, with the least and the greatest permitted number. */
const kSingle: Record<string, [number, number?]> = { radius_mm: [0.001], quality: [1, 11] };

/** Returns the tolerances in a spec. Those of one table are in the order of the spec. */
function tolerancesOf(spec: Tree | null): Tolerance[] {
  const list: Tolerance[] = [];
  const add = (place: string, table: string, only?: string[]) => {
    const values = at(spec, place);
    if (typeof values !== "object" || values === null) return;
    for (const name of Object.keys(values)) {
      const key = inputKey(table, name);
      if (!key || (only && !only.includes(name))) continue;
      const range = at(values, name);
      const given = typeof range === "object" && range !== null && !Array.isArray(range);
      list.push({ place: `${place}.${name}${given ? ".range" : ""}`, table, key });
    }
  };
  if (typeof at(spec ?? undefined, "scatter.quality") === "number") add("scatter", "scatter", ["quality"]);
  add("scatter.errors", "scatter_errors");
  add("scatter.bearings", "scatter_bearings", ["radius_mm"]);
  for (const gear of ["gear1", "gear2"]) {
    add(`scatter.${gear}`, "scatter_gear", ["thickness_allowance_mm"]);
    add(`scatter.${gear}.modifications`, "scatter_modifications");
  }
  return list;
}

function endsOf(value: Json | undefined): [number, number] {
  if (typeof value === "number") return [-value, value];
  const [lo, hi] = Array.isArray(value) ? value : [0, 0];
  return [Number(lo), Number(hi)];
}

export class ToleranceSliders {
  readonly element = h("div", { class: "sliders", role: "group", "aria-label": "tolerances" });
  private slides: KeySlider[] = [];
  private design = -1;

  /** `moved` is called with true while the user holds a slider, and with false when the user releases it. */
  constructor(private readonly moved: (moving: boolean) => void) {}

  show(spec: Tree | null): void {
    const all = tolerancesOf(spec);
    const same =
      this.design === bench.design &&
      all.length === this.slides.length &&
      all.every((one, i) => one.place === this.slides[i]!.place);
    if (!same) {
      this.design = bench.design;
      this.slides = [];
      const rows = all.map((one) => this.slide(one));
      fill(this.element, all.length > 0 && h("h3", {}, "Tolerances"), ...rows);
    }
    for (const { place, key, input, output } of this.slides) {
      const [lo, hi] = endsOf(at(spec ?? undefined, place));
      const half = (hi - lo) / 2;
      if (!kSingle[key.key]?.[1] && (!same || half > Number(input.max))) {
        const reach = half > 0 ? 2 * half : (kReach[key.unit] ?? 1);
        input.max = String(reach);
        input.step = String(niceStep(reach));
      }
      if (document.activeElement !== input) input.value = String(half);
      output.textContent = text(half, key);
    }
  }

  private slide({ place, table, key }: Tolerance): HTMLElement {
    const single = kSingle[key.key];
    const set = (half: number) => {
      const [lo, hi] = endsOf(at(bench.good?.spec ?? undefined, place));
      const middle = onStep((lo + hi) / 2, 1e-9);
      const end = (side: number) => Number((middle + side * half).toPrecision(12));
      bench.setKey(place, single ? half : [end(-1), end(1)]);
    };
    const gear = /gear([12])/.exec(place)?.[1];
    const words = wordsOf(table, key) + (gear ? `, gear ${gear}` : "");
    const range = { min: single?.[0] ?? 0, max: single?.[1], step: single?.[1] && 1, change: () => this.moved(false) };
    const moved = () => {
      this.moved(true);
      const half = onStep(Number(slide.input.value), single?.[1] ? 1 : niceStep(Number(slide.input.max)));
      slide.output.textContent = text(half, key);
      set(half);
    };
    const name = `tolerance of ${words}, ${shownUnit(key)}`;
    const slide = keySlider({ place, key, words, name }, range, moved, () => !single && set(0));
    this.slides.push(slide);
    return slide.row;
  }
}

function text(half: number, key: InputKey): string {
  if (kSingle[key.key]?.[1]) return String(half);
  return `± ${amount(half, key, key.unit === "µm" ? 1 : 4)}`;
}
