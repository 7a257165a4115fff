// Shows a slider for every documented error and for the usual modifications. Its range is centred
// on 0, or starts at 0 if the key cannot be negative. The pictures follow the slider while it
// moves. A double click or the key 0 resets it.

import type { InputKey } from "../../engine/engine";
import { inputKey, inputs, wordsOf } from "../catalogue";
import { h } from "../elements";
import { keySlider, type KeySlider } from "../key_slider";
import { amount, niceStep, onStep, shownUnit } from "../numbers";
import { at, bench, hasRack } from "../workbench";

const kReach: Record<string, number> = { "°": 0.1, µm: 30, mm: 0.1 };
const kModifications = [
  "lead_crowning_um",
  "lead_slope_um",
  "profile_crowning_um",
  "profile_slope_um",
  "tip_relief_um",
  "root_relief_um",
  "end_relief_um",
];
/** Errors and modifications of the teeth of gear 2, which a rack does not have. */
const kOfGear2 = /^gear2\.|^errors\.\D+2_/;
/** For each modification, another key that must be given with it. */
const kNeeds: Record<string, string> = {
  tip_relief_um: "tip_relief_start_mm",
  root_relief_um: "root_relief_start_mm",
  end_relief_um: "end_relief_length_mm",
};

export class ContactSliders {
  readonly element = h("div", { class: "sliders", role: "group", "aria-label": "errors and modifications" });
  private slides: KeySlider[] = [];

  build(): void {
    if (this.slides.length) return;
    const errors = (inputs("errors")?.keys ?? []).filter((key) => key.documented && key.kind === "number");
    this.group(
      "Errors",
      "",
      errors.map((key) => ["errors." + key.key, key]),
      "errors",
    );
    for (const gear of ["gear1", "gear2"]) {
      const keys = kModifications
        .map((name) => inputKey("modifications", name))
        .filter((key) => key !== undefined);
      this.group(
        "Modifications, gear " + gear[4],
        "g" + gear[4],
        keys.map((key) => [`${gear}.modifications.${key.key}`, key]),
        "modifications",
      );
    }
  }

  private group(title: string, style: string, entries: [string, InputKey][], table: string): void {
    this.element.append(
      h("h3", { class: style, "data-of": entries[0]?.[0] }, title),
      ...entries.map(([place, key]) => this.slide(place, key, wordsOf(table, key))),
    );
  }

  private slide(place: string, key: InputKey, words: string): HTMLElement {
    const reach = kReach[key.unit] ?? 1;
    const name = `${words}, ${shownUnit(key)}${place.startsWith("gear") ? ", gear " + place[4] : ""}`;
    const range = { min: key.range?.lo === 0 ? 0 : -reach, max: reach, step: reach / 100, value: 0 };
    const set = (value: number) => bench.setKey(place, value === 0 ? undefined : value);
    const moved = () => {
      const value = onStep(Number(slide.input.value), niceStep(Number(slide.input.max), 100));
      slide.output.textContent = text(value, key);
      set(value);
    };
    const slide = keySlider({ place, key, words, name }, range, moved, () => set(0));
    this.slides.push(slide);
    return slide.row;
  }

  show(): void {
    const spec = bench.solved?.spec;
    if (!spec) return;
    const rack = hasRack(spec);
    for (const head of this.element.querySelectorAll<HTMLElement>("[data-of]"))
      head.hidden = rack && kOfGear2.test(head.dataset["of"]!);
    for (const { place, input, output, key, row } of this.slides) {
      const value = at(spec, place);
      const need = kNeeds[key.key];
      row.hidden = (rack && kOfGear2.test(place)) || (need !== undefined && at(spec, place.replace(/[^.]*$/, need)) === undefined);
      const number = typeof value === "number" ? value : 0;
      if (Math.abs(number) > Number(input.max)) {
        input.max = String(2 * Math.abs(number));
        if (Number(input.min) < 0) input.min = "-" + input.max;
      }
      if (document.activeElement !== input || Number(input.value) !== number) input.value = String(number);
      output.textContent = text(number, key);
      row.classList.toggle("moved", number !== 0);
    }
  }
}

function text(value: number, key: InputKey): string {
  return amount(value, key, key.unit === "µm" ? 1 : 3);
}
