// The tab "shifts" shows the region of profile shifts within the limits for the tooth numbers of
// this pair, with exact borders. A point shows the shifts of the design. The user drags the point
// or moves it with the arrow keys, and all views follow. If the point is on a border, the tab names
// this border.

import type { ShiftRegion } from "../../engine/engine";
import { fill, h, onKeys, sentenceOf, svg } from "../elements";
import { axisOf, FigureSlot } from "../figure_slot";
import { fixed } from "../numbers";
import { bench } from "../workbench";
import type { Tab } from "../tabs";

const kAbout = 110; // px that axes and words need in width and in height

export class ShiftsView implements Tab {
  readonly id = "shifts";
  private readonly slot = new FigureSlot();
  private readonly sentence = h("p", { class: "shift-sentence", "aria-live": "polite" });
  private readonly key = h("div", { class: "shift-key" });
  readonly picture = h(
    "div",
    {
      class: "shift-room",
      tabindex: "0",
      role: "application",
      "aria-label": "chart of both profile shifts; the arrow keys move the design by 0.01, or by 0.1 with the Shift key",
      pointerdown: (event: PointerEvent) => this.grab(event),
      pointermove: (event: PointerEvent) => this.drag(event),
      pointerup: () => this.release(),
      pointercancel: () => this.release(),
    },
    this.slot.element,
  );
  readonly element = h(
    "div",
    { class: "shifts-view" },
    this.picture,
    h("div", { class: "shift-words" }, this.sentence, this.key),
  );
  private region: ShiftRegion | null = null;
  private held = false;
  shown = "";

  constructor() {
    new ResizeObserver(() => {
      this.shown = "";
      void this.refresh();
    }).observe(this.picture);
    onKeys(this.picture, {
      ArrowLeft: (event) => this.step(event, -1, 0),
      ArrowRight: (event) => this.step(event, 1, 0),
      ArrowUp: (event) => this.step(event, 0, 1),
      ArrowDown: (event) => this.step(event, 0, -1),
    });
  }

  async refresh(): Promise<void> {
    const solved = bench.good;
    if (!solved) return this.clear(bench.nothing);
    const { clientWidth: width, clientHeight: height } = this.picture;
    if (solved.text === this.shown || !width || !height) return;
    const aspect = Math.min(3, Math.max(0.4, (width - kAbout) / (height - kAbout)));
    const view = { width, aspect, window: this.held ? this.window() : null };
    try {
      const region = await bench.about(bench.front, "shifts", "shifts", { text: solved.text, view });
      if (!region) return;
      // During a drag, the point stays at the pointer, because the result of the engine belongs
      // to an earlier position of the pointer.
      if (this.held && this.region) region.point = this.region.point;
      this.region = region;
      this.shown = solved.text;
    } catch (reason) {
      return this.clear(sentenceOf(reason));
    }
    this.slot.show(this.region.figure ?? undefined);
    const caption = this.slot.element.querySelector("figcaption");
    if (caption) fill(this.key, caption);
    this.draw();
  }

  private clear(sentence: string): void {
    this.region = null;
    this.shown = "";
    this.slot.show(undefined);
    fill(this.key);
    this.sentence.textContent = sentence;
  }

  /** Returns the range that the figure shows. It stays the same while the user drags the point. */
  private window(): [number, number, number, number] | null {
    const { plot } = this.slot;
    if (!plot) return null;
    const [x, y] = [axisOf(plot, "x"), axisOf(plot, "y")];
    return [x.lo, x.hi, y.lo, y.hi];
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
    if (!this.region || (event.target as Element).closest("button") || !this.slot.valuesAt(event)) return;
    this.picture.setPointerCapture(event.pointerId);
    this.held = true;
    this.drag(event);
  }
  private drag(event: PointerEvent): void {
    const place = this.held ? this.slot.valuesAt(event, true) : null;
    if (place) this.move(...place.at);
  }
  private release(): void {
    this.held = false;
  }
  private step(event: KeyboardEvent, across: number, up: number): void {
    const step = event.shiftKey ? 0.1 : 0.01;
    if (this.region) this.move(this.region.point[0] + across * step, this.region.point[1] + up * step);
  }

  /** Moves the point of the design in the figure, and describes its position in words. */
  private draw(): void {
    const { region } = this;
    if (!region) return;
    const { plot } = this.slot;
    const stop = region.stoppedBy ? (region.borders[region.stoppedBy] ?? region.stoppedBy) : "";
    if (plot) {
      for (const old of plot.querySelectorAll(".design-point")) old.remove();
      const [cx, cy] = [axisOf(plot, "x").px(region.point[0]), axisOf(plot, "y").px(region.point[1])];
      plot.append(
        svg(
          "g",
          { class: "design-point" },
          svg("circle", { class: "hold", cx, cy, r: 13 }),
          svg("circle", { class: "design" + (region.inside ? "" : " outside"), cx, cy, r: 6.5 }),
          svg("text", { class: "halo letter e", x: cx - 16, y: cy + 5 }, "the design"),
        ),
      );
      for (const edge of plot.querySelectorAll("path.region-edge"))
        edge.classList.toggle("stops", stop !== "" && edge.getAttribute("data-name") === stop);
      for (const name of this.key.querySelectorAll(".key"))
        name.classList.toggle("stops", stop !== "" && name.textContent?.trim() === stop);
    }
    const where = `x1 = ${fixed(region.point[0], 4)}, x2 = ${fixed(region.point[1], 4)}`;
    fill(
      this.sentence,
      h("b", {}, where),
      ". ",
      !Object.keys(region.borders).length
        ? `No shifts satisfy the limits${region.whatKills ? ": " + region.whatKills : ""}.`
        : region.inside
          ? stop
            ? `The design is on a border of the region: ${stop}.`
            : `The design is inside the region, ${fixed(region.margin, 3)} modules from the nearest border.`
          : stop
            ? `The design is outside the region, beyond the border “${stop}”.`
            : "The design is outside the region.",
    );
  }
}
