// The tab "mesh" shows the section at z = 0. A slider turns the gears. The picture contains the
// path of contact and named circles, and the tab shows the diameters at the pointer.
//
// The engine draws the figure, and the page turns its gears to the poses that the engine has
// computed. When the user has zoomed or moved the figure, the engine draws it again, so that it
// is sharp and its circles have labels.

import type { Figure, MeshView as View } from "../../engine/engine";
import { check, Choice, h, onNextFrame, svg } from "../elements";
import { axisOf, FigureSlot } from "../figure_slot";
import { poseAt, touchAt, turnAt, type Motion } from "../motion";
import { length } from "../numbers";
import { Changes } from "../pauses";
import { markRenewed } from "../revision";
import { bench, hasRack } from "../workbench";
import type { Tab } from "../tabs";
import { TurnControl } from "../turn_control";
import { centerOf, keepVisible } from "./visible_parts";

/** Number of positions in one pitch at which the engine computes poses. */
const kPositions = 25;
const kFrames = { whole: "whole", mesh: "mesh", flank: "flank" };

export class MeshView implements Tab {
  readonly id = "mesh";
  private readonly readout = h("output", { class: "readout" });
  private readonly repaint = onNextFrame(() => this.paint());
  private readonly turning = new TurnControl(() => this.repaint());
  private readonly slot = new FigureSlot(undefined, (x, y) => this.hover(x, y));
  private readonly frames = new Choice("content of the picture", kFrames, "mesh", (frame) => {
    this.frame = frame as View["frame"];
    this.restore();
  });
  private readonly circlesBox = h("input", {
    type: "checkbox",
    checked: true,
    change: () => this.picture.classList.toggle("no-circles", !this.circlesBox.checked),
  });
  readonly picture = h(
    "div",
    {
      class: "canvas-room",
      role: "group",
      "aria-label": "section of the gears; + and − zoom, arrows move, 0 shows the whole picture again",
      pointerleave: () => (this.readout.textContent = ""),
    },
    this.slot.element,
    this.readout,
  );
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
  private frame: View["frame"] = "mesh";
  /** The window that the user has chosen by zooming or moving, mm. */
  private window: View["window"] = null;
  private moves = 0; // how often the user has zoomed or moved the view
  private figure: Figure | undefined;
  /** Displacement of each axis from the centre of its circles in the figure, mm. */
  private shifts: [number, number][] = [
    [0, 0],
    [0, 0],
  ];
  private motion: Motion | null = null;
  private size: [number, number] = [0, 0];
  private readonly figures = new Changes(); // by changes of the spec, and by zooming and moving
  private design = -1;
  shown = "";

  constructor() {
    figureZoom(this.slot.element, {
      always: true,
      touch: true,
      home: () => this.restore(),
      moved: () => ++this.moves,
      settled: () => this.takeWindow(),
    });
    new ResizeObserver(() => {
      this.size = [0, 0];
      this.redraw();
    }).observe(this.picture);
  }

  leave(): void {
    this.turning.stop();
  }
  inUnits(): void {} // the figure contains no lengths

  async refresh(): Promise<void> {
    const solved = bench.good;
    if (!solved) {
      this.show(undefined);
      this.motion = null;
      this.shown = "";
      this.readout.textContent = bench.nothing;
      return;
    }
    if (solved.text === this.shown) return;
    this.readout.textContent = "";
    if (this.design !== bench.design) this.window = null;
    this.design = bench.design;
    if (!this.measured()[0]) return;
    await this.draw();
    // If the size of the picture has changed in the meantime, the request for this figure may
    // have been dropped in favour of a newer one, so the figure is drawn again.
    if (this.shown !== solved.text && bench.good?.text === solved.text) await this.draw();
  }

  /** Returns the width and the height of the picture, px. They are measured only after a change of size, because
   *  each measurement forces a layout of the page. */
  private measured(): [number, number] {
    if (!this.size[0]) this.size = [this.picture.clientWidth, this.picture.clientHeight];
    return this.size;
  }

  /** Draws the figure for the current size and window. The motion of its gears is computed once for each spec. */
  private async draw(): Promise<void> {
    const [width, height] = this.measured();
    if (!bench.good || !width || !height) return;
    const { text } = bench.good;
    const { moves } = this;
    const view: View = { frame: this.frame, width, height, window: this.window, bodies: false, name: "mesh" };
    try {
      const positions = text === this.shown ? 0 : kPositions;
      const answer = await bench.about(bench.front, "mesh", "mesh", { text, view, positions });
      // If the user has moved the view in the meantime, this figure is not shown. The figure is
      // requested again when the view stops.
      if (!answer || this.moves !== moves) return;
      this.motion = answer.motion ?? this.motion;
      this.shown = text;
      this.show(answer.figure);
    } catch (reason) {
      this.show(undefined);
      throw reason;
    }
  }

  private show(figure: Figure | undefined): void {
    const focused = this.slot.element.contains(document.activeElement);
    this.figure = figure;
    markRenewed(this.picture);
    // While figures follow each other quickly, only the visible parts are drawn.
    this.figures.add();
    const { moves } = this;
    const { moving } = this.figures;
    this.figures.atRest(() => this.moves === moves && this.show(this.figure));
    this.slot.show(figure, moving ? (nodes) => keepVisible(nodes, this.slot.plot, this.measured()) : undefined);
    const { plot } = this.slot;
    if (plot && !plot.querySelector(".touches"))
      plot.append(
        svg(
          "g",
          { class: "touches", visibility: "hidden" },
          svg("g", { class: "lb", transform: "translate(0 0)" }, svg("circle", { class: "touch", r: 6 })),
        ),
      );
    if (focused) plot?.closest("svg")?.focus();
    this.paint();
  }

  private restore(): void {
    this.window = null;
    this.redraw();
  }

  /** Stores the visible part of the figure as the window. */
  private takeWindow(): void {
    const { plot } = this.slot;
    const box = plot?.closest("svg")?.viewBox.baseVal;
    if (!plot || !box) return;
    const [x, y] = [axisOf(plot, "x"), axisOf(plot, "y")];
    this.window = [x.value(box.x), x.value(box.x + box.width), y.value(box.y + box.height), y.value(box.y)];
    this.redraw();
  }
  private redraw(): void {
    this.draw().catch(() => undefined); // the tab shows the reason instead of the picture
  }

  private hover(x: number, y: number): void {
    const { circles = [], points = [] } = this.figure?.data ?? {};
    const { plot } = this.slot;
    if (!plot || !circles.length) return;
    const { a: zoom } = plot.closest("svg")!.getScreenCTM()!;
    const near = 5 / zoom / Math.abs(axisOf(plot, "x").px(1) - axisOf(plot, "x").px(0));
    const words = [0, 1].flatMap((gear) => {
      const own = circles.filter((one) => one.gear === gear);
      if (!own.length) return [];
      const [cx, cy] = own[0]!.center;
      const [dx, dy] = this.shifts[gear]!;
      const radius = Math.hypot(x - cx - dx, y - cy - dy);
      const circle = own.find((one) => Math.abs(one.radius - radius) < near);
      return `gear ${gear + 1}: ⌀ ${length(2 * (circle?.radius ?? radius))}${circle ? " " + circle.name : ""}`;
    });
    const named = points.find(({ at }) => Math.hypot(at[0] - x, at[1] - y) < 2 * near);
    this.readout.textContent = (named ? named.name.replace("_", "") + "   " : "") + words.join("   ");
  }

  /** Moves the circles of a gear to its axis. Mounting errors have moved this axis to `axis`, mm. */
  private shiftCircles(gear: number, axis: [number, number]): void {
    const { plot } = this.slot;
    const center = this.figure?.data.circles?.find((one) => one.gear === gear)?.center;
    if (!plot || !center) return;
    this.shifts[gear] = [axis[0] - center[0], axis[1] - center[1]];
    const [x, y] = [axisOf(plot, "x"), axisOf(plot, "y")];
    const [cx, cy] = [x.px(center[0]), y.px(center[1])];
    const move = `translate(${x.px(axis[0]) - cx} ${y.px(axis[1]) - cy})`;
    const kRounding = 0.1; // px, rounding of the numbers in the SVG
    for (const circle of plot.querySelectorAll("circle.thin, [data-center]")) {
      const [x, y] = centerOf(circle);
      if (Math.hypot(x - cx, y - cy) < kRounding) circle.setAttribute("transform", move);
    }
  }

  /** Turns the gears to their current positions and moves the contact point with them. */
  private paint(): void {
    this.turning.show(this.motion);
    const { plot } = this.slot;
    if (!plot) return;
    plot.classList.toggle("unplaced", !this.motion);
    if (!this.motion) return;
    const { motion } = this;
    const [x, y] = [axisOf(plot, "x"), axisOf(plot, "y")];
    const { t } = this.turning;
    let meshing = false;
    for (const use of plot.querySelectorAll<SVGUseElement>("use[data-gear]")) {
      const gear = Number(use.dataset["gear"]);
      if (!motion.places[gear]) continue;
      const [, at, scale] = /^(translate\([^)]*\)) (scale\([^)]*\))/.exec(use.getAttribute("transform")!)!;
      let place = at;
      let angle = 0;
      if (use.dataset["turn"] || hasRack(bench.good?.spec)) {
        const pose = poseAt(motion, gear, t);
        place = `translate(${x.px(pose[12]!)} ${y.px(pose[13]!)})`;
        angle = Math.atan2(pose[1]!, pose[0]!);
        this.shiftCircles(gear, [pose[12]!, pose[13]!]);
        meshing = true;
      } else angle = turnAt(motion, gear, t); // a single gear, or a gear of a crossed pair
      use.setAttribute("transform", `${place} ${scale} rotate(${(-angle * 180) / Math.PI})`);
    }
    const touch = meshing ? touchAt(motion, t) : null;
    const dot = plot.querySelector(".touches");
    dot?.setAttribute("visibility", touch ? "visible" : "hidden");
    if (touch) dot?.setAttribute("transform", `translate(${x.px(touch.x)} ${y.px(touch.y)})`);
  }
}
