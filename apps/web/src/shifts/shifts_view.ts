// The tab "shifts": all profile shifts within the limits for this pair of tooth numbers, with their
// exact borders. The point is the design. The user drags it or moves it with the arrow keys, and
// all views follow. If it stops at a border, the border is named.

import type { ShiftRegion } from "../../engine/engine";
import { gridLines, ticksOf } from "../axes";
import { fill, h, onKeys, sentenceOf, svg } from "../elements";
import { fixed, niceStep } from "../numbers";
import { bench } from "../workbench";
import type { Tab } from "../tabs";

const kRoom = { left: 66, right: 18, top: 16, bottom: 44 };
const kColours = [
  "var(--g1)",
  "var(--g2)",
  "var(--action)",
  "var(--trailing)",
  "var(--tip-fillet)",
  "var(--caution)",
  "var(--root-land)",
  "var(--problem)",
  "var(--ink)",
];

export class ShiftsView implements Tab {
  readonly id = "shifts";
  private readonly chart = svg("svg", {
    class: "shift-chart",
    tabindex: "0",
    role: "application",
    "aria-label": "chart of both profile shifts; arrows move the design by 0.01, with shift by 0.1",
    pointerdown: (event: PointerEvent) => this.grab(event),
    pointermove: (event: PointerEvent) => this.drag(event),
    pointerup: () => (this.held = false),
    pointercancel: () => (this.held = false),
  });
  private readonly sentence = h("p", { class: "shift-sentence", "aria-live": "polite" });
  private readonly legend = h("ul", { class: "shift-legend" });
  readonly picture = h("div", { class: "shift-room" }, this.chart);
  readonly element = h(
    "div",
    { class: "shifts-view" },
    this.picture,
    h("div", { class: "shift-words" }, this.sentence, this.legend),
  );
  private region: ShiftRegion | null = null;
  private frame: [number, number, number, number] = [-1, 1, -1, 1];
  private held = false;
  shown = "";

  constructor() {
    new ResizeObserver(() => this.draw()).observe(this.chart);
    onKeys(this.chart, {
      ArrowLeft: (event) => this.step(event, -1, 0),
      ArrowRight: (event) => this.step(event, 1, 0),
      ArrowUp: (event) => this.step(event, 0, 1),
      ArrowDown: (event) => this.step(event, 0, -1),
    });
  }

  async refresh(): Promise<void> {
    const solved = bench.good;
    if (!solved) return this.clear(bench.nothing);
    if (solved.text === this.shown) return;
    try {
      const region = await bench.about(bench.front, "shifts", "shifts", { text: solved.text });
      if (!region) return;
      this.region = region;
      this.shown = solved.text;
      if (!this.held) this.reframe();
    } catch (reason) {
      return this.clear(sentenceOf(reason));
    }
    this.draw();
  }

  private clear(sentence: string): void {
    this.region = null;
    this.shown = "";
    fill(this.legend);
    fill(this.chart);
    this.sentence.textContent = sentence;
  }

  /** The window: the region and the design, with room about them; the same scale both ways. */
  private reframe(): void {
    const region = this.region!;
    const x = [region.point[0]];
    const y = [region.point[1]];
    for (const piece of region.pieces)
      for (const border of piece)
        for (let i = 0; i < border.points.length; i += 2) {
          x.push(border.points[i]!);
          y.push(border.points[i + 1]!);
        }
    const room = 0.12 * Math.max(Math.max(...x) - Math.min(...x), Math.max(...y) - Math.min(...y), 0.4);
    this.frame = [Math.min(...x) - room, Math.max(...x) + room, Math.min(...y) - room, Math.max(...y) + room];
  }

  /** px per module, across and up: the room is filled, but no direction is drawn twice as large. */
  private get scale(): [number, number] {
    const [x0, x1, y0, y1] = this.frame;
    const across = (this.chart.clientWidth - kRoom.left - kRoom.right) / (x1 - x0);
    const up = (this.chart.clientHeight - kRoom.top - kRoom.bottom) / (y1 - y0);
    return [Math.min(across, 2 * up), Math.min(up, 2 * across)];
  }
  private px(x: number, y: number): [number, number] {
    const [across, up] = this.scale;
    return [
      kRoom.left + (x - this.frame[0]) * across,
      this.chart.clientHeight - kRoom.bottom - (y - this.frame[2]) * up,
    ];
  }
  private at(event: PointerEvent): [number, number] {
    const box = this.chart.getBoundingClientRect();
    const [across, up] = this.scale;
    return [
      this.frame[0] + (event.clientX - box.left - kRoom.left) / across,
      this.frame[2] + (box.bottom - kRoom.bottom - event.clientY) / up,
    ];
  }

  private move(x1: number, x2: number): void {
    if (!this.region) return;
    const round = (x: number) => Math.round(x * 1e4) / 1e4;
    this.region.point = [round(x1), round(x2)];
    bench.setKey("gear1.profile_shift", round(x1));
    bench.setKey("gear2.profile_shift", round(x2));
    this.draw();
  }
  private grab(event: PointerEvent): void {
    if (!this.region) return;
    this.chart.setPointerCapture(event.pointerId);
    this.held = true;
    this.drag(event);
  }
  private drag(event: PointerEvent): void {
    if (this.held) this.move(...this.at(event));
  }
  private step(event: KeyboardEvent, across: number, up: number): void {
    const step = event.shiftKey ? 0.1 : 0.01;
    if (this.region) this.move(this.region.point[0] + across * step, this.region.point[1] + up * step);
  }

  private draw(): void {
    const region = this.region;
    if (!region || !this.chart.clientWidth) return;
    const path = (points: Float64Array) =>
      Array.from({ length: points.length / 2 }, (_, i) =>
        this.px(points[2 * i]!, points[2 * i + 1]!)
          .map((one) => one.toFixed(1))
          .join(","),
      ).join(" ");
    const names = Object.keys(region.borders);
    const inkOf = (name: string) => kColours[names.indexOf(name) % kColours.length]!;
    const areas = region.pieces.map((piece) =>
      svg("polygon", { class: "region", points: piece.map((border) => path(border.points)).join(" ") }),
    );
    const borders = region.pieces.flat().map((border) =>
      svg(
        "polyline",
        {
          class: "border" + (border.border === region.stoppedBy ? " stops" : ""),
          points: path(border.points),
          stroke: inkOf(border.border),
        },
        svg("title", {}, region.borders[border.border] ?? border.border),
      ),
    );
    const [px, py] = this.px(...region.point);
    const chosen = region.chosen ? this.px(...region.chosen) : null;
    fill(
      this.chart,
      ...this.grid(),
      ...areas,
      ...borders,
      chosen && svg("circle", { class: "chosen", cx: chosen[0], cy: chosen[1], r: 5 }),
      svg("circle", { class: "halo", cx: px, cy: py, r: 13 }),
      svg("circle", { class: "design" + (region.inside ? "" : " outside"), cx: px, cy: py, r: 6.5 }),
      ...this.names([px, py], chosen),
    );
    this.describe(region, names, inkOf);
  }

  /** The words of the two points, on the side where there is room; below, where they are close. */
  private names(design: [number, number], chosen: [number, number] | null): SVGElement[] {
    const word = ([x, y]: [number, number], off: number, text: string) => {
      const left = x > this.chart.clientWidth - 190;
      return svg(
        "text",
        { class: "point-name" + (left ? " e" : ""), x: left ? x - off : x + off, y: y + 4 },
        text,
      );
    };
    const close = chosen && Math.abs(chosen[0] - design[0]) < 150 && Math.abs(chosen[1] - design[1]) < 16;
    const off = !close ? 0 : chosen[1] < design[1] ? -18 : 20;
    return [
      word(design, 17, "the design"),
      ...(chosen ? [word([chosen[0], chosen[1] + off], 10, "what a search would take")] : []),
    ];
  }

  private describe(region: ShiftRegion, names: string[], inkOf: (name: string) => string): void {
    const where = `x1 = ${fixed(region.point[0], 4)}, x2 = ${fixed(region.point[1], 4)}`;
    const stop = region.stoppedBy ? (region.borders[region.stoppedBy] ?? region.stoppedBy) : "";
    fill(
      this.sentence,
      h("b", {}, where),
      ". ",
      !region.pieces.length
        ? `No shifts satisfy the limits${region.whatKills ? ": " + (region.borders[region.whatKills] ?? region.whatKills) : ""}.`
        : region.inside
          ? stop
            ? `At a border: ${stop}.`
            : `Inside, ${fixed(region.margin, 3)} modules from the nearest border.`
          : stop
            ? `Outside: stopped by ${stop}.`
            : "Outside the region.",
    );
    fill(
      this.legend,
      ...names.map((name) =>
        h(
          "li",
          { class: name === region.stoppedBy ? "stops" : null },
          h("i", { style: `background:${inkOf(name)}` }),
          region.borders[name]!,
        ),
      ),
    );
  }

  private grid(): SVGElement[] {
    const [x0, x1, y0, y1] = this.frame;
    const { clientWidth: width, clientHeight: height } = this.chart;
    const box = { left: kRoom.left, right: width - kRoom.right, top: kRoom.top, bottom: height - kRoom.bottom };
    const end = Math.max(x1, x0 + (box.right - box.left) / this.scale[0]);
    const step = niceStep(Math.max(end - x0, y1 - y0), 6);
    const across = { ticks: ticksOf(x0, end, step, 2), px: (x: number) => this.px(x, y0)[0] };
    const up = { ticks: ticksOf(y0, y1, step, 2), px: (y: number) => this.px(x0, y)[1] };
    const left = `translate(13 ${height / 2}) rotate(-90)`;
    return [
      ...gridLines(box, across, up),
      svg("text", { x: width / 2, y: height - 8, class: "m g1" }, "profile shift of gear 1"),
      svg("text", { class: "m g2", transform: left }, "profile shift of gear 2"),
    ];
  }
}
