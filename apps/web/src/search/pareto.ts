// The designs as points over two of their numbers; those that no other beats in both are the front.
// The picture is as large as its room.

import type { Quantity } from "../../engine/engine";
import { gridLines, ticksOf } from "../axes";
import { fill, h, svg } from "../elements";
import { niceStep, toShown, shownUnit } from "../numbers";

export interface Point {
  row: number;
  x: number;
  y: number;
  front: boolean;
}
const kRoom = { right: 16, top: 32, bottom: 42, letter: 7.2, gap: 16 };

export class ParetoPicture {
  readonly element = h("figure", { class: "pareto" });
  private readonly picture = svg("svg", { role: "img" });
  private last: [Point[], Quantity, Quantity, number] | null = null;

  constructor(private readonly choose: (row: number) => void) {
    this.element.append(this.picture);
    new ResizeObserver(() => this.draw()).observe(this.element);
  }

  show(points: Point[], x: Quantity, y: Quantity, chosen: number): void {
    const real = points.filter((one) => Number.isFinite(one.x) && Number.isFinite(one.y));
    this.last = [real, x, y, chosen];
    this.element.hidden = real.length < 2;
    this.draw();
  }
  clear(): void {
    this.last = null;
    this.element.hidden = true;
    fill(this.picture);
  }

  private draw(): void {
    const w = this.element.clientWidth;
    const tall = this.element.clientHeight;
    if (!this.last || !w || !tall) return;
    const [points, x, y, chosen] = this.last;
    const shown = points.map((one) => ({ ...one, x: toShown(one.x, x.unit), y: toShown(one.y, y.unit) }));
    const across = axisOf(shown.map((one) => one.x), w / 110);
    const up = axisOf(shown.map((one) => one.y), tall / 36);
    const left = kRoom.letter * Math.max(...up.ticks.map(([, text]) => text.length)) + kRoom.gap;
    const [right, bottom] = [w - kRoom.right, tall - kRoom.bottom];
    const px = (v: number) => left + ((v - across.lo) / (across.hi - across.lo)) * (right - left);
    const py = (v: number) => bottom - ((v - up.lo) / (up.hi - up.lo)) * (bottom - kRoom.top);
    const unit = (q: Quantity) => (shownUnit(q.unit) ? ", " + shownUnit(q.unit) : "");
    this.picture.setAttribute("viewBox", `0 0 ${w} ${tall}`);
    fill(
      this.picture,
      svg("title", {}, `${y.words} over ${x.words}; the front is violet`),
      ...gridLines({ left, right, top: kRoom.top, bottom }, { ...across, px }, { ...up, px: py }),
      svg("text", { class: "m", x: (left + right) / 2, y: tall - 7 }, x.words + unit(x)),
      svg("text", { class: "up", x: 8, y: 19 }, y.words + unit(y)),
      ...shown
        .sort((a, b) => Number(a.front) - Number(b.front))
        .map((one) =>
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
        ),
    );
  }
}

/** Ends with some room, and about so many ticks with their words. */
function axisOf(values: number[], count: number) {
  const least = Math.min(...values);
  const most = Math.max(...values);
  const room = (most - least || Math.abs(most) || 1) * 0.06;
  const [lo, hi] = [least - room, most + room];
  const step = niceStep(hi - lo, Math.min(8, Math.max(2, count)));
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  return { lo, hi, ticks: ticksOf(lo, hi, step, digits) };
}
