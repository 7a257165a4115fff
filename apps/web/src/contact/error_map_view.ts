// Peak to peak of the transmission error over two errors at once: computed in the background, row by
// row, with progress and a way out. A click mounts the pair with those errors.

import type { ErrorMap } from "../../engine/engine";
import { inputs, wordsAt, wordsOf } from "../catalogue";
import { button, colour, fill, h, sentenceOf } from "../elements";
import { fixed } from "../numbers";
import { markRevision } from "../revision";
import { at, bench } from "../workbench";

const kReach: Record<string, number> = { "°": 0.05, µm: 20, mm: 0.1 };
const kPoints = 33;
const kShades = [
  "#00204d",
  "#0b3370",
  "#37476b",
  "#555b6d",
  "#6f7073",
  "#8a8779",
  "#a69d75",
  "#c4b56c",
  "#e4cf5b",
  "#ffea46",
]; // the report's

export class ErrorMapView {
  private readonly x = this.chooser("across", "crossing_deg");
  private readonly y = this.chooser("up", "intersecting_deg");
  private readonly canvas = h("canvas", {
    role: "img",
    "aria-label": "peak to peak of the transmission error over two errors",
    click: (event: MouseEvent) => this.take(event),
    pointermove: (event: PointerEvent) => this.hover(event),
  });
  private readonly room = h("div", { class: "map-room" }, this.canvas);
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
      h("b", {}, "Peak to peak over two errors"),
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
  private axes = { x: "", y: "", rest: "", text: "" }; // of the map; its spec, and that without the two

  constructor() {
    this.stop.hidden = this.bar.hidden = this.canvas.hidden = true;
    bench.on("text", () => this.age());
    bench.on("solved", () => this.age());
    bench.on("opened", () => {
      if (!this.stop.hidden) bench.back.cancel();
      this.map = null;
      this.canvas.hidden = true;
      this.status.textContent = "";
    });
  }
  /** A map is of a spec but for the two errors that it runs over. */
  private restOf(x: string, y: string): string {
    const { errors, ...spec } = bench.good?.spec ?? {};
    const rest = Object.entries(errors ?? {}).filter(([key]) => key !== x && key !== y);
    return JSON.stringify([spec, rest]);
  }
  /** Dims the map if the spec has become another one. */
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
    const key = inputs("errors")!.keys.find((one) => one.key === select.value)!;
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
    const take = (map: ErrorMap) => {
      this.axes = axes;
      this.paint(map);
      this.age();
    };
    const question = { text: bench.good.text, x: this.axis(this.x), y: this.axis(this.y), positions: 32 };
    try {
      const map = await bench.back.latest("map", "errorMap", question, (done, of, sofar) => {
        this.bar.value = of ? done / of : 0;
        if (sofar) take(sofar as ErrorMap);
      });
      if (map) take(map);
      this.status.textContent = "A click mounts the pair so.";
    } catch (reason) {
      if (bench.design === design) this.status.textContent = sentenceOf(reason);
    } finally {
      this.stop.hidden = this.bar.hidden = true;
      this.go.hidden = false;
    }
  }

  private paint(map: ErrorMap): void {
    this.map = map;
    this.canvas.hidden = false;
    const nx = map.x.length;
    const ny = map.y.length;
    this.canvas.width = nx;
    this.canvas.height = ny;
    const c = this.canvas.getContext("2d")!;
    const real = map.peakToPeakArcsec.filter(Number.isFinite);
    const most = real.length ? Math.max(...real) : 1;
    for (let j = 0; j < ny; ++j)
      for (let i = 0; i < nx; ++i) {
        const value = map.peakToPeakArcsec[j * nx + i]!;
        c.fillStyle = Number.isFinite(value)
          ? kShades[Math.min(9, Math.floor((10 * value) / (most || 1)))]!
          : colour("panel");
        c.fillRect(i, ny - 1 - j, 1, 1);
      }
  }
  private cell(event: MouseEvent): [number, number] | null {
    if (!this.map) return null;
    const i = Math.floor((event.offsetX / this.canvas.clientWidth) * this.map.x.length);
    const j =
      this.map.y.length - 1 - Math.floor((event.offsetY / this.canvas.clientHeight) * this.map.y.length);
    return this.map.x[i] === undefined || this.map.y[j] === undefined ? null : [i, j];
  }
  private hover(event: PointerEvent): void {
    const cell = this.cell(event);
    if (!cell || !this.map) return;
    const [i, j] = cell;
    const value = this.map.peakToPeakArcsec[j * this.map.x.length + i]!;
    const at = (key: string, value: number) => `${wordsAt("errors", key)} ${fixed(value, 4)}`;
    this.status.textContent =
      `${at(this.axes.x, this.map.x[i]!)}, ${at(this.axes.y, this.map.y[j]!)}: ` +
      (Number.isFinite(value) ? value.toFixed(3) + "″" : "no contact");
  }
  private take(event: MouseEvent): void {
    const cell = this.cell(event);
    if (!cell || !this.map) return;
    bench.setKey("errors." + this.axes.x, Number(this.map.x[cell[0]]!.toPrecision(6)));
    bench.setKey("errors." + this.axes.y, Number(this.map.y[cell[1]]!.toPrecision(6)));
  }
}
