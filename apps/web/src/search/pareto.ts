// The designs as points over two of their numbers; those that no other beats in both are the front.

import type { Quantity } from "../../engine/engine";
import { fill, h, svg } from "../elements";
import { fixed, niceStep } from "../numbers";

export interface Point {
  row: number;
  x: number;
  y: number;
  front: boolean;
}
const kSize = { w: 420, h: 280, left: 62, right: 14, top: 12, bottom: 42 };

export class ParetoPicture {
  readonly element = h("figure", { class: "pareto" });
  private readonly picture = svg("svg", { viewBox: `0 0 ${kSize.w} ${kSize.h}`, role: "img" });

  constructor(private readonly choose: (row: number) => void) {
    this.element.append(this.picture);
  }

  show(points: Point[], x: Quantity, y: Quantity, chosen: number): void {
    const real = points.filter((one) => Number.isFinite(one.x) && Number.isFinite(one.y));
    this.element.hidden = real.length < 2;
    if (real.length < 2) return;
    const span = (values: number[]) => {
      const lo = Math.min(...values);
      const hi = Math.max(...values);
      const room = (hi - lo || Math.abs(hi) || 1) * 0.06;
      return [lo - room, hi + room] as const;
    };
    const [x0, x1] = span(real.map((one) => one.x));
    const [y0, y1] = span(real.map((one) => one.y));
    const px = (v: number) => kSize.left + ((v - x0) / (x1 - x0)) * (kSize.w - kSize.left - kSize.right);
    const py = (v: number) =>
      kSize.h - kSize.bottom - ((v - y0) / (y1 - y0)) * (kSize.h - kSize.top - kSize.bottom);
    const parts: SVGElement[] = [];
    const stepX = niceStep(x1 - x0, 5);
    const stepY = niceStep(y1 - y0, 5);
    const digits = (step: number) => Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    for (let v = Math.ceil(x0 / stepX) * stepX; v <= x1; v += stepX) {
      parts.push(
        svg("line", { class: "grid", x1: px(v), x2: px(v), y1: kSize.top, y2: kSize.h - kSize.bottom }),
      );
      parts.push(
        svg("text", { class: "m", x: px(v), y: kSize.h - kSize.bottom + 16 }, fixed(v, digits(stepX))),
      );
    }
    for (let v = Math.ceil(y0 / stepY) * stepY; v <= y1; v += stepY) {
      parts.push(
        svg("line", { class: "grid", x1: kSize.left, x2: kSize.w - kSize.right, y1: py(v), y2: py(v) }),
      );
      parts.push(svg("text", { class: "e", x: kSize.left - 7, y: py(v) + 4 }, fixed(v, digits(stepY))));
    }
    const unit = (q: Quantity) => (q.unit ? ", " + q.unit : "");
    parts.push(svg("text", { class: "m", x: kSize.w / 2, y: kSize.h - 6 }, x.words + unit(x)));
    parts.push(
      svg("text", { class: "m", transform: `translate(14 ${kSize.h / 2}) rotate(-90)` }, y.words + unit(y)),
    );
    for (const one of [...real].sort((a, b) => Number(a.front) - Number(b.front)))
      parts.push(
        svg(
          "circle",
          {
            class: (one.front ? "dot-front" : "dot-design") + (one.row === chosen ? " taken" : ""),
            cx: px(one.x),
            cy: py(one.y),
            r: one.front ? 4.5 : 3.5,
            click: () => this.choose(one.row),
          },
          svg("title", {}, `design ${one.row + 1}`),
        ),
      );
    fill(this.picture, svg("title", {}, `${y.words} over ${x.words}; the front is violet`), ...parts);
  }
}
