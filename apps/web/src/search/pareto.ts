// Shows the designs as points over two of their quantities. The engine draws the figure in the available
// size. A click on a point chooses its design.

import { h } from "../elements";
import { FigureSlot } from "../figure_slot";
import { shownUnit, toShown } from "../numbers";
import { bench } from "../workbench";
import type { Column } from "./search_table";

export interface Point {
  row: number;
  name: string;
  x: number;
  y: number;
  front: boolean;
}
/** Space that axes and words need around the plot, px. */
const kRoom = { across: 110, up: 84 };

export class ParetoPicture {
  private readonly slot = new FigureSlot();
  readonly element = h("div", { class: "pareto", click: (event: Event) => this.press(event) }, this.slot.element);
  private last: [Point[], Column, Column, number] | null = null;
  private asked = 0;

  constructor(private readonly choose: (row: number) => void) {
    new ResizeObserver(() => void this.draw()).observe(this.element);
  }

  show(points: Point[], x: Column, y: Column, chosen: number): void {
    // The points of the Pareto front are drawn last and cover the others.
    const real = points
      .filter((one) => Number.isFinite(one.x) && Number.isFinite(one.y))
      .sort((a, b) => Number(a.front) - Number(b.front));
    this.last = [real, x, y, chosen];
    this.element.hidden = real.length < 2;
    void this.draw();
  }
  clear(): void {
    this.last = null;
    this.element.hidden = true;
    this.slot.show(undefined);
  }

  private async draw(): Promise<void> {
    const [width, height] = [this.element.clientWidth, this.element.clientHeight];
    const asked = ++this.asked;
    if (!this.last || !width || !height) return;
    const [points, x, y, chosen] = this.last;
    const axis = ({ info, place, words }: Column, values: number[]) => ({
      words,
      unit: shownUnit(info),
      symbol: place === -1 || typeof place === "string" ? info.symbol : "",
      better: info.key !== "objective" ? ("" as const) : info.greaterFirst ? ("greater" as const) : ("smaller" as const),
      values: values.map((value) => toShown(value, info)),
    });
    const figure = await bench.front.call("designs", {
      width,
      tall: Math.max(0.1, (height - kRoom.up) / (width - kRoom.across)),
      x: axis(x, points.map((one) => one.x)),
      y: axis(y, points.map((one) => one.y)),
      names: points.map((one) => one.name),
      styles: points.map(
        (one) => (one.front ? "dot-front" : "dot-design") + (one.row === chosen ? " taken" : ""),
      ),
    });
    if (asked === this.asked && this.last) this.slot.show(figure);
  }
  private press(event: Event): void {
    const dots = [...this.element.querySelectorAll("g.plot circle")];
    const point = this.last?.[0][dots.indexOf(event.target as Element)];
    if (point) this.choose(point.row);
  }
}
