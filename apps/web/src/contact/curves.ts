// Transmission error over one pitch, and its spectrum.

import uPlot from "uplot";
import type { ContactCurve } from "../../engine/engine";
import { colour } from "../elements";
import { axis, type Curve, type Ends, Plot, upright } from "../plot";

/** A curve flatter than this is drawn flat. */
const kLeastArcsec = 0.02;

/** A kind of touch that is none of flanks. */
export function isEdge(kind: string): boolean {
  return !["interior", "line", "ridge", "none", ""].includes(kind);
}

/** Ends of the axis of a transmission error. */
export const kAboutNothing: Ends = (lo, hi) => [
  Math.min(lo, -kLeastArcsec) * 1.1,
  Math.max(hi, kLeastArcsec) * 1.1,
];
/** The transmission error from its middle; where an edge touches, in the colour of edges. */
export function transmissionCurves(curve: ContactCurve): Curve[] {
  const y = curve.columns["transmission_error_arcsec"] as Float64Array;
  const kinds = curve.columns["kind"] as string[];
  const real = y.filter(Number.isFinite);
  const middle = real.length ? (Math.min(...real) + Math.max(...real)) / 2 : 0;
  const edge = (i: number) => kinds[i] !== undefined && isEdge(kinds[i]);
  const all = y.map((value) => value - middle);
  // An edge's stretch joins the points on either side of it.
  const edges = all.map((value, i) => (edge(i - 1) || edge(i) || edge(i + 1) ? value : NaN));
  return [
    { values: all, colour: "flank" },
    { values: edges, colour: "root-fillet", width: 2.5 },
  ];
}

export class SpectrumPlot extends Plot {
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
          ...axis("order of mesh frequency"),
          splits: (_, __, ___, max) => [1, 2, 5, 10, 15, 20].filter((n) => n <= max),
        },
        upright("amplitude, ″"),
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
