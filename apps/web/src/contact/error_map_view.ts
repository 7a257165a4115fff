// The map of the peak-to-peak transmission error as a function of two errors. It is computed point
// by point in the background, with a progress bar and a button that stops it. A click on the map
// sets both errors in the spec to the values at the node that is nearest to the pointer.

import type { ErrorMap, Figure } from "../../engine/engine";
import { inputs, wordsAt, wordsOf } from "../catalogue";
import { button, fill, h, sentenceOf } from "../elements";
import { FigureSlot } from "../figure_slot";
import { amount, fromShown } from "../numbers";
import { markRevision } from "../revision";
import { at, bench } from "../workbench";

const kReach: Record<string, number> = { "°": 0.05, µm: 20, mm: 0.1 };
const kPoints = 33;
const keyOf = (name: string) => inputs("errors")!.keys.find((one) => one.key === name)!;

export class ErrorMapView {
  private readonly x = this.chooser("across", "crossing_deg");
  private readonly y = this.chooser("up", "intersecting_deg");
  private readonly slot = new FigureSlot(undefined, (x, y, clicked) => this.at(x, y, clicked));
  private readonly room = h("div", { class: "map-room" }, this.slot.element);
  private readonly go = button("Map", () => void this.make());
  private readonly stop = button("Cancel", () => bench.back.cancel());
  private readonly bar = h("progress", { max: 1, value: 0, "aria-label": "progress of the map" });
  private readonly status = h("span", { class: "soft", role: "status" });
  readonly element = h(
    "figure",
    { class: "error-map" },
    h(
      "div",
      { class: "map-head" },
      h("b", {}, "Peak-to-peak transmission error as a function of two errors"),
      this.x,
      this.y,
      this.go,
      this.stop,
      this.bar,
      this.status,
    ),
    this.room,
  );
  private map: ErrorMap | null = null;
  // The axes of the map, the text of its spec, and this spec without the two errors.
  private axes = { x: "", y: "", rest: "", text: "" };

  constructor() {
    this.stop.hidden = this.bar.hidden = true;
    bench.on("text", () => this.age());
    bench.on("solved", () => this.age());
    bench.on("opened", () => this.clear());
  }
  clear(): void {
    if (!this.stop.hidden) bench.back.cancel();
    this.map = null;
    this.slot.show(undefined);
    this.status.textContent = "";
  }
  /** Returns the spec without the two errors of the map, on which the map does not depend. */
  private restOf(x: string, y: string): string {
    const { errors, ...spec } = bench.good?.spec ?? {};
    const rest = Object.entries(errors ?? {}).filter(([key]) => key !== x && key !== y);
    return JSON.stringify([spec, rest]);
  }
  /** Dims the map if the spec has changed in anything except the two errors. */
  private age(): void {
    const { x, y, rest, text } = this.axes;
    const fresh = bench.settled && this.restOf(x, y) === rest;
    markRevision(this.room, this.map ? (fresh ? bench.text : text) : "", bench.text, !this.stop.hidden);
  }
  private chooser(where: string, first: string): HTMLSelectElement {
    return h("select", { "aria-label": "error " + where, "data-first": first });
  }
  build(): void {
    if (this.x.options.length) return;
    for (const select of [this.x, this.y]) {
      fill(
        select,
        ...(inputs("errors")?.keys ?? [])
          .filter((key) => key.documented)
          .map((key) => h("option", { value: key.key }, wordsOf("errors", key))),
      );
      select.value = select.dataset["first"]!;
    }
  }

  private axis(select: HTMLSelectElement): { key: string; from: number; to: number; n: number } {
    const key = keyOf(select.value);
    const now = at(bench.good?.spec ?? null, "errors." + key.key);
    const reach = Math.max(kReach[key.unit] ?? 1, typeof now === "number" ? 1.5 * Math.abs(now) : 0);
    return { key: key.key, from: -reach, to: reach, n: kPoints };
  }

  private async make(): Promise<void> {
    if (this.x.value === this.y.value) {
      this.status.textContent = "Choose two different errors.";
      return;
    }
    if (!bench.good) return;
    this.stop.hidden = this.bar.hidden = false;
    this.go.hidden = true;
    this.status.textContent = "";
    const [x, y] = [this.x.value, this.y.value];
    const { design } = bench;
    const axes = { x, y, rest: this.restOf(x, y), text: bench.good.text };
    const take = ({ map, figure }: { map: ErrorMap; figure: Figure }) => {
      this.axes = axes;
      this.map = map;
      this.slot.show(figure);
      this.age();
    };
    const width = Math.min(520, this.element.clientWidth || 520);
    const question = { text: bench.good.text, x: this.axis(this.x), y: this.axis(this.y), positions: 32, width };
    try {
      const answer = await bench.back.latest("map", "errorMap", question, (done, of, sofar) => {
        this.bar.value = of ? done / of : 0;
        if (sofar) take(sofar as { map: ErrorMap; figure: Figure });
      });
      if (answer) take(answer);
      this.status.textContent = "Click a point to set these two errors in the spec.";
    } catch (reason) {
      if (bench.design === design) this.status.textContent = sentenceOf(reason);
    } finally {
      this.stop.hidden = this.bar.hidden = true;
      this.go.hidden = false;
    }
  }

  /** Handles the pointer at a point of the map. A move shows the value at the nearest node. A click sets
   *  both errors of the spec to the values at this node. */
  private at(x: number, y: number, clicked: boolean): void {
    const { map, axes } = this;
    if (!map) return;
    const nearest = (all: Float64Array, value: number) =>
      all.reduce((best, one, i) => (Math.abs(one - value) < Math.abs(all[best]! - value) ? i : best), 0);
    const [keyX, keyY] = [keyOf(axes.x), keyOf(axes.y)];
    const [i, j] = [nearest(map.x, fromShown(x, keyX)), nearest(map.y, fromShown(y, keyY))];
    if (clicked) {
      bench.setKey("errors." + axes.x, Number(map.x[i]!.toPrecision(6)));
      bench.setKey("errors." + axes.y, Number(map.y[j]!.toPrecision(6)));
      return;
    }
    const value = map.peakToPeakArcsec[j * map.x.length + i]!;
    this.status.textContent =
      `${wordsAt("errors", axes.x)} ${amount(map.x[i]!, keyX, 4)}, ${wordsAt("errors", axes.y)} ${amount(map.y[j]!, keyY, 4)}: ` +
      (Number.isFinite(value) ? value.toFixed(3) + "″" : "no contact");
  }
}
