// The tab "scatter" shows the effect of the tolerances, with a slider for each tolerance. While the
// user moves a slider, the distribution is estimated to first order. When the user releases the
// slider, complete contact analyses replace the estimate.

import type { Scattered } from "../../engine/engine";
import { button, fill, h, scroller, sentenceOf } from "../elements";
import { Figures } from "../figure_slot";
import { fixed } from "../numbers";
import { Pause } from "../pauses";
import type { Tab } from "../tabs";
import { at, bench, hasRack } from "../workbench";
import { ToleranceSliders } from "./tolerance_sliders";

/** The pause after the last change before the contact analyses start. */
const kPauseMs = 400;
/** Tolerances of a housing of average accuracy. A button adds them to a spec that has none. */
const kFirst: Record<string, [number, number]> = {
  "scatter.errors.center_distance_mm": [-0.02, 0.02],
  "scatter.errors.crossing_deg": [-0.02, 0.02],
  "scatter.errors.intersecting_deg": [-0.02, 0.02],
};
type Timed = Scattered & { milliseconds: number };

export class ScatterView implements Tab {
  readonly id = "scatter";
  private readonly sliders = new ToleranceSliders((moving) => this.moved(moving));
  private readonly sentence = h("p", { class: "view-sentence", "aria-live": "polite" });
  private readonly state = h("p", { class: "soft scatter-state" });
  private readonly events = h("ul", { class: "soft scatter-events" });
  private readonly figures = new Figures();
  private readonly first = button(
    "Add tolerances of the housing",
    () => Object.entries(kFirst).forEach(([place, range]) => bench.setKey(place, range)),
    { class: "main" },
  );
  readonly picture = h("div", {}, this.sentence, this.first, this.state, this.figures.element, this.events);
  readonly element = h(
    "div",
    { class: "side-view narrow" },
    this.sliders.element,
    scroller("side-room", "scatter", this.picture),
  );
  private moving = false; // true while a slider is held
  private readonly pause = new Pause(kPauseMs);
  private full = ""; // the text whose contact analyses are shown or in progress
  shown = "";

  async refresh(): Promise<void> {
    this.pause.cancel();
    const solved = bench.good;
    this.sliders.show(solved?.spec ?? null);
    if (!solved?.hasPair)
      return this.clear(solved ? "The effect of tolerances needs a second gear." : bench.nothing);
    if (hasRack(solved.spec)) return this.clear("The effect of tolerances needs two gears, but gear 2 is a rack.");
    this.first.hidden = at(solved.spec, "scatter") !== undefined;
    if (!this.first.hidden) return this.clear("The spec has no tolerances.");
    const { text } = solved;
    if (text !== this.shown) {
      this.full = "";
      const sketch = await this.request("scatterSketch", text);
      if (!sketch) return;
      this.draw(sketch, text, `First-order estimate, ${sketch.milliseconds.toFixed(0)} ms.`);
    }
    if (!this.moving) this.later();
  }
  leave(): void {
    this.pause.cancel();
  }

  private moved(moving: boolean): void {
    this.moving = moving;
    this.pause.cancel();
    if (!moving) this.later();
  }
  private later(): void {
    this.pause.run(() => void this.finish());
  }
  /** Runs complete contact analyses. Their result replaces the estimate. */
  private async finish(): Promise<void> {
    const text = bench.good?.text;
    if (!text || text !== this.shown || text === this.full) return;
    this.full = text;
    const found = await this.request("scatter", text);
    if (!found || this.shown !== text) return;
    const seconds = (found.milliseconds / 1000).toFixed(1);
    this.draw(found, text, `${found.samples} pairs in ${seconds} s.`);
  }

  private async request(name: "scatterSketch" | "scatter", text: string): Promise<Timed | null> {
    const link = name === "scatter" ? bench.back : bench.front;
    try {
      const answer = await bench.about(link, name, name, { text, width: this.figures.fit() });
      return answer && bench.good?.text === text ? answer : null;
    } catch (reason) {
      if (bench.good?.text === text) this.clear(sentenceOf(reason), text);
      return null;
    }
  }

  private draw(found: Scattered, text: string, state: string): void {
    this.shown = text;
    const highest = found.percentiles.at(-1);
    fill(
      this.sentence,
      highest
        ? `The peak-to-peak transmission error of ${highest.percent} % of the pairs is at most ${fixed(highest.arcsec, 2)}″.`
        : "Contact is lost in every pair.",
    );
    const others = found.percentiles.slice(0, -1).map((p) => `${p.percent} %: ${fixed(p.arcsec, 2)}″`);
    this.state.textContent = [state, ...others].join("  ");
    fill(
      this.events,
      ...(found.events ?? []).map((e) =>
        h("li", {}, `${e.words}: ${e.count} of ${e.of}${e.count ? "" : `, less than ${(100 * e.upper).toPrecision(2)} %`}`),
      ),
    );
    this.figures.show(found.figures, found.samples !== undefined);
  }

  private clear(sentence: string, text = ""): void {
    this.shown = text;
    this.full = text;
    fill(this.sentence, sentence);
    this.state.textContent = "";
    fill(this.events);
    this.figures.show([]);
  }
}
