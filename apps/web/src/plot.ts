// Curves in rooms of their own, as uPlot draws them: they follow the room's width and the theme, and
// a position may be chosen on them.

import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { colour, font, h } from "./elements";

export function axis(label: string, size = 34): uPlot.Axis {
  return {
    stroke: colour("soft"),
    grid: { stroke: colour("faint"), width: 1 },
    ticks: { stroke: colour("faint"), width: 1 },
    font: font("12px"),
    labelFont: font("12px"),
    label,
    labelSize: 16,
    size,
    gap: 2,
  };
}

const kUpright = 52; // px
/** An axis that stands upright: as wide as its longest number, so that the label does not touch it. */
export function upright(label: string): uPlot.Axis {
  const size = (_: uPlot, ticks: string[] | null) =>
    Math.max(kUpright, 14 + 7.2 * Math.max(0, ...(ticks ?? []).map((tick) => tick.length)));
  return { ...axis(label), size };
}

const kHeight = 190; // px, as in the style sheet
/** A curve in a room of its own that follows the room's width. */
export abstract class Plot {
  readonly element = h("div", { class: "plot" });
  protected plot: uPlot | null = null;
  constructor() {
    this.element.setAttribute("role", "img");
    new ResizeObserver(() => this.resize()).observe(this.element);
  }
  protected abstract options(): Omit<uPlot.Options, "width" | "height">;
  protected draw(data: uPlot.AlignedData): void {
    if (!this.plot) {
      const width = this.element.clientWidth;
      if (!width) return;
      this.plot = new uPlot({ ...this.options(), width, height: kHeight }, data, this.element);
    } else this.plot.setData(data);
  }
  private resize(): void {
    if (this.element.clientWidth)
      this.plot?.setSize({ width: this.element.clientWidth, height: kHeight });
  }
  /** Light has become dark. */
  forget(): void {
    this.plot?.destroy();
    this.plot = null;
  }
}

export interface Curve {
  values: ArrayLike<number | null>; // NaN and null: a gap
  colour: string; // a name of the palette
  width?: number; // px
}
/** The ends of the upright axis for curves between two values. */
export type Ends = (lo: number, hi: number) => [number, number];
const room = (lo: number, hi: number) => 0.08 * (hi - lo || Math.abs(hi) || 1);
const kAround: Ends = (lo, hi) => [lo - room(lo, hi), hi + room(lo, hi)];
export const kFromNothing: Ends = (lo, hi) => [0, hi + room(lo, hi)];

/** Curves over the rotation of gear 1, with a line at the chosen position; a press or a drag chooses
 *  another. */
export class CurvePlot extends Plot {
  private curves: Curve[] = [];
  private marked = NaN;
  constructor(
    private readonly label: string,
    chosen: (index: number) => void,
    private readonly ends = kAround,
  ) {
    super();
    const choose = (event: PointerEvent) => {
      if (!this.plot || !(event.buttons & 1 || event.type === "pointerdown")) return;
      const left = event.clientX - this.plot.over.getBoundingClientRect().left;
      chosen(this.plot.posToIdx(left));
    };
    this.element.addEventListener("pointerdown", choose);
    this.element.addEventListener("pointermove", choose);
  }
  protected options(): Omit<uPlot.Options, "width" | "height"> {
    return {
      legend: { show: false },
      cursor: { y: false, drag: { x: false, y: false }, points: { show: false } },
      hooks: { draw: [(plot) => this.mark(plot)] },
      scales: { x: { time: false }, y: { range: (_, lo, hi) => this.ends(lo, hi) } },
      axes: [axis("rotation of gear 1, °"), upright(this.label)],
      series: [
        {},
        ...this.curves.map((one) => ({
          stroke: colour(one.colour),
          width: one.width ?? 2,
          points: { show: false },
        })),
      ],
    };
  }
  private mark(plot: uPlot): void {
    if (!Number.isFinite(this.marked)) return;
    const x = plot.valToPos(this.marked, "x", true);
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.strokeStyle = colour("action");
    ctx.lineWidth = 1.4 * devicePixelRatio;
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    ctx.restore();
  }
  show(x: ArrayLike<number>, curves: Curve[], at: number, label: string): void {
    const ink = (all: Curve[]) => all.map((one) => one.colour).join();
    if (ink(curves) !== ink(this.curves)) this.forget();
    this.curves = curves;
    this.marked = x[at] ?? NaN;
    this.element.setAttribute("aria-label", label);
    const real = (value: number | null) => (value !== null && Number.isFinite(value) ? value : null);
    this.draw([Array.from(x), ...curves.map((one) => Array.from(one.values, real))]);
  }
}
