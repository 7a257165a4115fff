// The grid of a chart in SVG: a line at each tick of both axes, with its number.

import { svg } from "./elements";
import { fixed } from "./numbers";

/** Edges of the grid, px. */
export interface Grid {
  left: number;
  right: number;
  top: number;
  bottom: number;
}
export interface Axis {
  ticks: [value: number, text: string][];
  px(value: number): number;
}

export function ticksOf(lo: number, hi: number, step: number, digits: number): Axis["ticks"] {
  const first = Math.ceil(lo / step);
  const last = Math.floor(hi / step + 1e-9);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => {
    const value = (first + i) * step;
    return [value, fixed(value, digits)];
  });
}

export function gridLines({ left, right, top, bottom }: Grid, across: Axis, up: Axis): SVGElement[] {
  const style = (value: number) => (value === 0 ? "zero" : "grid");
  return [
    ...across.ticks.flatMap(([value, text]) => {
      const x = across.px(value);
      return [
        svg("line", { class: style(value), x1: x, x2: x, y1: bottom, y2: top }),
        svg("text", { x, y: bottom + 16, class: "m" }, text),
      ];
    }),
    ...up.ticks.flatMap(([value, text]) => {
      const y = up.px(value);
      return [
        svg("line", { class: style(value), x1: left, x2: right, y1: y, y2: y }),
        svg("text", { x: left - 8, y: y + 4, class: "e" }, text),
      ];
    }),
  ];
}
