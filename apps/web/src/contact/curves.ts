// Transmission error over one pitch, and its spectrum, as uPlot draws them.

import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import type { ContactCurve } from "../../engine/engine";
import { colour, h } from "../elements";

/** A curve flatter than this is drawn flat. */
const kLeastArcsec = 0.02;
const font = () => `12px ${getComputedStyle(document.body).fontFamily}`;
function axis(label: string, size: number): uPlot.Axis {
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

/** A curve in a room of its own that follows the room's width. */
abstract class Plot {
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

export class TransmissionPlot extends Plot {
  private marked = NaN;
  constructor(private readonly chosen: (index: number) => void) {
    super(190);
    this.element.setAttribute("role", "img");
    const choose = (event: PointerEvent) => {
      if (!this.plot || !(event.buttons & 1 || event.type === "pointerdown")) return;
      const left = event.clientX - this.plot.over.getBoundingClientRect().left;
      this.chosen(this.plot.posToIdx(left));
    };
    this.element.addEventListener("pointerdown", choose);
    this.element.addEventListener("pointermove", choose);
  }
  protected options(): Omit<uPlot.Options, "width" | "height"> {
    const inside = { stroke: colour("flank"), width: 2, points: { show: false } };
    return {
      legend: { show: false },
      cursor: { y: false, drag: { x: false, y: false }, points: { show: false } },
      scales: {
        x: { time: false },
        y: { range: (_, lo, hi) => [Math.min(lo, -kLeastArcsec) * 1.1, Math.max(hi, kLeastArcsec) * 1.1] },
      },
      axes: [axis("rotation of gear 1, °", 34), axis("transmission error, ″", 44)],
      series: [
        {},
        inside,
        { stroke: colour("root-fillet"), width: 2.5, points: { show: false }, spanGaps: false },
      ],
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
  /** The curve from its middle; where an edge touches, in the colour of edges. */
  show(curve: ContactCurve, at: number): void {
    const x = curve.columns["rotation1_deg"] as Float64Array;
    const y = curve.columns["transmission_error_arcsec"] as Float64Array;
    const kinds = curve.columns["kind"] as string[];
    const real = y.filter(Number.isFinite);
    const middle = real.length ? (Math.min(...real) + Math.max(...real)) / 2 : 0;
    const edge = (i: number) => kinds[i] !== undefined && !["interior", "line", ""].includes(kinds[i]!);
    const all = Array.from(y, (value) => (Number.isFinite(value) ? value - middle : null));
    // An edge's stretch joins the points on either side of it.
    const edges = all.map((value, i) =>
      edge(i) || (i > 0 && edge(i - 1)) || (i + 1 < all.length && edge(i + 1)) ? value : null,
    );
    this.marked = x[at] ?? NaN;
    this.element.setAttribute(
      "aria-label",
      `transmission error over one pitch, peak to peak ${curve.peakToPeakArcsec.toFixed(3)} arc seconds`,
    );
    this.draw([Array.from(x), all, edges]);
  }
}

export class SpectrumPlot extends Plot {
  constructor() {
    super(190);
    this.element.setAttribute("role", "img");
  }
  protected options(): Omit<uPlot.Options, "width" | "height"> {
    return {
      legend: { show: false },
      cursor: { show: false },
      scales: {
        x: { time: false, range: (_, __, max) => [0.3, max + 0.7] },
        y: { range: (_, __, max) => [0, Math.max(max * 1.08, kLeastArcsec)] },
      },
      axes: [
        {
          ...axis("waves per pitch", 34),
          splits: (_, __, ___, max) => [1, 2, 5, 10, 15, 20].filter((n) => n <= max),
        },
        axis("amplitude, ″", 44),
      ],
      series: [
        {},
        {
          stroke: colour("alpha"),
          fill: colour("alpha"),
          width: 0,
          paths: uPlot.paths.bars!({ size: [0.62, 40] }),
          points: { show: false },
        },
      ],
    };
  }
  show(harmonics: Float64Array): void {
    this.element.setAttribute(
      "aria-label",
      `spectrum of the transmission error; the first wave has ${(harmonics[0] ?? 0).toFixed(3)} arc seconds`,
    );
    this.draw([Array.from(harmonics, (_, i) => i + 1), Array.from(harmonics)]);
  }
}
