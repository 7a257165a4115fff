// Curves in rooms of their own, as uPlot draws them: they follow the room's width and the theme, and
// a position may be chosen on them.

import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { colour, h } from "./elements";

const font = () => `12px ${getComputedStyle(document.body).fontFamily}`;
export function axis(label: string, size: number): uPlot.Axis {
  return {
    stroke: colour("soft"),
    grid: { stroke: colour("faint"), width: 1 },
    ticks: { stroke: colour("faint"), width: 1 },
    font: font(),
    labelFont: font(),
    label,
    labelSize: 16,
    size,
    gap: 2,
  };
}

/** An axis that stands upright: as wide as its longest number, so that the label does not touch it. */
export function upright(label: string, least: number): uPlot.Axis {
  const size = (_: uPlot, ticks: string[] | null) =>
    Math.max(least, 14 + 7.2 * Math.max(0, ...(ticks ?? []).map((tick) => tick.length)));
  return { ...axis(label, least), size };
}

/** A curve in a room of its own that follows the room's width. */
export abstract class Plot {
  readonly element = h("div", { class: "plot" });
  protected plot: uPlot | null = null;
  constructor(private readonly height: number) {
    new ResizeObserver(() => this.resize()).observe(this.element);
  }
  protected abstract options(): Omit<uPlot.Options, "width" | "height">;
  protected draw(data: uPlot.AlignedData): void {
    if (!this.plot) {
      const width = this.element.clientWidth;
      if (!width) return;
      this.plot = new uPlot({ ...this.options(), width, height: this.height }, data, this.element);
    } else this.plot.setData(data);
  }
  private resize(): void {
    if (this.element.clientWidth)
      this.plot?.setSize({ width: this.element.clientWidth, height: this.height });
  }
  /** Light has become dark. */
  forget(): void {
    this.plot?.destroy();
    this.plot = null;
  }
}

/** With a line at the chosen position; a press or a drag chooses another. */
export abstract class MarkedPlot extends Plot {
  protected marked = NaN;
  constructor(
    height: number,
    private readonly chosen: (index: number) => void,
  ) {
    super(height);
    this.element.setAttribute("role", "img");
    const choose = (event: PointerEvent) => {
      if (!this.plot || !(event.buttons & 1 || event.type === "pointerdown")) return;
      const left = event.clientX - this.plot.over.getBoundingClientRect().left;
      this.chosen(this.plot.posToIdx(left));
    };
    this.element.addEventListener("pointerdown", choose);
    this.element.addEventListener("pointermove", choose);
  }
  protected shared(): Pick<uPlot.Options, "legend" | "cursor" | "hooks"> {
    return {
      legend: { show: false },
      cursor: { y: false, drag: { x: false, y: false }, points: { show: false } },
      hooks: {
        draw: [
          (u) => {
            if (!Number.isFinite(this.marked)) return;
            const x = u.valToPos(this.marked, "x", true);
            u.ctx.save();
            u.ctx.strokeStyle = colour("action");
            u.ctx.lineWidth = 1.4 * devicePixelRatio;
            u.ctx.beginPath();
            u.ctx.moveTo(x, u.bbox.top);
            u.ctx.lineTo(x, u.bbox.top + u.bbox.height);
            u.ctx.stroke();
            u.ctx.restore();
          },
        ],
      },
    };
  }
}

export interface Curve {
  values: ArrayLike<number | null>; // NaN and null: a gap
  colour: string; // a name of the palette
}

/** Curves over the rotation of gear 1. */
export class CurvePlot extends MarkedPlot {
  private curves: Curve[] = [];
  constructor(
    private readonly label: string,
    chosen: (index: number) => void,
    private readonly fromNothing = false,
  ) {
    super(190, chosen);
  }
  protected options(): Omit<uPlot.Options, "width" | "height"> {
    return {
      ...this.shared(),
      scales: {
        x: { time: false },
        y: {
          range: (_, lo, hi) => {
            const room = 0.08 * (hi - lo || Math.abs(hi) || 1);
            return [this.fromNothing ? 0 : lo - room, hi + room];
          },
        },
      },
      axes: [axis("rotation of gear 1, °", 34), upright(this.label, 52)],
      series: [
        {},
        ...this.curves.map((one) => ({
          stroke: colour(one.colour),
          width: 2,
          points: { show: false },
          spanGaps: false,
        })),
      ],
    };
  }
  show(x: number[], curves: Curve[], at: number, said: string): void {
    const ink = (all: Curve[]) => all.map((one) => one.colour).join();
    if (ink(curves) !== ink(this.curves)) this.forget();
    this.curves = curves;
    this.marked = x[at] ?? NaN;
    this.element.setAttribute("aria-label", said);
    const real = (value: number | null) => (value !== null && Number.isFinite(value) ? value : null);
    this.draw([x, ...curves.map((one) => Array.from(one.values, real))]);
  }
}
