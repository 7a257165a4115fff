// The tab "mesh": the section at z = 0 that turns with its slider, the path of contact, circles by
// name, and under the pointer the diameters there.

import type { MeshLines } from "../../engine/engine";
import { check, Choice, h, onNextFrame, onThemeChange } from "../elements";
import { touchAt, type Motion } from "../motion";
import { length } from "../numbers";
import { bench } from "../workbench";
import type { Tab } from "../tabs";
import { TurnControl } from "../turn_control";
import { draw, extentOf, placesOf, shapeOf, type Placed, type Scene, type Shape } from "./mesh_drawing";
import { ViewWindow } from "./view_window";

const kFrames = { whole: "whole", mesh: "mesh", flank: "flank" };

export class MeshView implements Tab {
  readonly id = "mesh";
  private readonly canvas = h("canvas", {
    tabindex: "0",
    role: "img",
    "aria-label": "the gears in section; + and − zoom, arrows move, 0 restores",
    pointermove: (event: PointerEvent) => this.hover(event),
    pointerleave: () => (this.readout.textContent = ""),
  });
  private readonly repaint = onNextFrame(() => this.paint());
  private readonly readout = h("output", { class: "readout" });
  private readonly turning = new TurnControl(() => this.repaint());
  private readonly frames = new Choice("what the picture shows", kFrames, "mesh", (frame) => {
    this.frame = frame;
    this.fit(true);
  });
  private readonly circlesBox = h("input", { type: "checkbox", checked: true, change: () => this.repaint() });
  readonly picture = h("div", { class: "canvas-room" }, this.canvas, this.readout);
  readonly element = h(
    "div",
    { class: "picture mesh-view" },
    this.picture,
    h(
      "div",
      { class: "controls" },
      ...this.turning.elements,
      this.frames.element,
      check("circles", this.circlesBox),
    ),
  );
  private readonly view = new ViewWindow(this.canvas, () => this.repaint());
  private frame = "mesh";
  private shapes: Shape[] = [];
  private lines: MeshLines | null = null;
  private motion: Motion | null = null;
  /** The gears' places are on their way, and there are none of a spec before. */
  private unplaced = false;
  shown = "";
  private sizeOf = "";

  constructor() {
    new ResizeObserver(() => this.fit(false)).observe(this.canvas);
    onThemeChange(() => this.repaint());
  }

  leave(): void {
    this.turning.stop();
  }

  async refresh(): Promise<void> {
    const solved = bench.good;
    if (!solved) {
      this.shapes = [];
      this.motion = null;
      this.shown = "";
      this.readout.textContent = bench.nothing;
      return this.repaint();
    }
    if (solved.text === this.shown) return;
    this.readout.textContent = "";
    const { text } = solved;
    const answer = await bench.about(bench.front, "sections", "sections", { text, tolerance: 0.002 });
    if (!answer) return;
    this.shapes = answer.gears.map(shapeOf);
    this.lines = answer.lines;
    if (this.motion?.places.length !== this.shapes.length) this.motion = null;
    const size =
      this.shapes.map((one) => one.reach.toPrecision(3)).join() +
      (answer.lines?.kind ?? "") +
      (answer.lines?.centerDistance.toPrecision(3) ?? "");
    this.unplaced = !this.motion;
    if (!this.motion || size !== this.sizeOf) this.fit(size !== this.sizeOf && !this.sizeOf);
    this.sizeOf = size;
    this.repaint();
    // Until the positions of the gears are computed, those of the previous spec are used, and the
    // picture stays dimmed.
    const motion = await bench
      .about(bench.back, "motion", "motion", { text, n: 25 })
      .finally(() => (this.unplaced = false));
    if (motion?.places.length !== this.shapes.length) return;
    this.motion = motion;
    this.shown = text;
    this.repaint();
  }

  private get crossed(): boolean {
    return this.lines?.kind === "crossed";
  }
  private places(): Placed[] {
    return placesOf(this.shapes, this.lines, this.motion, this.turning.t);
  }

  private fit(take: boolean): void {
    if (!this.shapes.length || !this.canvas.clientWidth) return;
    const [one, two] = this.shapes as [Shape, Shape | undefined];
    const places = placesOf(this.shapes, this.lines, null, 0);
    const path = this.lines?.pathOfContact;
    if (this.frame === "whole" || !two || this.crossed || !path) {
      const [x0, x1, tall] = extentOf(this.shapes, places);
      return this.view.frame(x0, x1, -tall, tall, take);
    }
    const x2 = places[1]!.x;
    let [x0, x1, y0, y1] = [Infinity, -Infinity, Infinity, -Infinity];
    if (!path.length) {
      // There is no path in this section, so the overlap of the gears is shown.
      [x0, x1] = [Math.min(x2 - two.reach, one.reach), Math.max(x2 - two.reach, one.reach)];
      [y0, y1] = [x0 - x1, x1 - x0];
    }
    for (let i = 0; i < path.length; i += 3) {
      x0 = Math.min(x0, path[i]!);
      x1 = Math.max(x1, path[i]!);
      y0 = Math.min(y0, path[i + 1]!);
      y1 = Math.max(y1, path[i + 1]!);
    }
    const room = Math.max(x1 - x0, y1 - y0) * (this.frame === "mesh" ? 0.62 : 0.06);
    this.view.frame(x0 - room, x1 + room, y0 - room, y1 + room, take);
  }

  private hover(event: PointerEvent): void {
    const [x, y] = this.view.mm(event.offsetX, event.offsetY);
    const near = 5 / this.view.now.scale;
    const words = this.places().map((place, i) => {
      const radius = Math.hypot(x - place.x, y - place.y);
      const circle = this.shapes[i]!.section.circles.find((one) => Math.abs(one.radius - radius) < near);
      return `gear ${i + 1}: ⌀ ${length(2 * (circle?.radius ?? radius))}${circle ? " " + circle.words : ""}`;
    });
    const named = this.crossed
      ? undefined
      : this.lines?.points.find((one) => Math.hypot(one.x - x, one.y - y) < 2 * near);
    this.readout.textContent = (named ? named.name + "   " : "") + words.join("   ");
  }

  private paint(): void {
    this.turning.show(this.motion);
    if (!this.shapes.length || this.unplaced)
      return void this.canvas.getContext("2d")!.clearRect(0, 0, this.canvas.width, this.canvas.height);
    if (!this.canvas.clientWidth) return;
    const touch = this.motion && !this.crossed ? touchAt(this.motion, this.turning.t) : null;
    const scene: Scene = {
      shapes: this.shapes,
      places: this.places(),
      lines: this.crossed ? null : this.lines,
      touch,
      circles: this.circlesBox.checked,
    };
    draw(this.canvas, this.view, scene);
  }
}
