// A figure that the engine has drawn. The page adds a line at the chosen position, lets the user choose
// another position by a click or a drag, and offers the figure as a file.
//
//   t   position in pitches of gear 1, −½ … ½

import type { Figure } from "../engine/engine";
import style from "../../../gearwright/figure/figure_style.css?inline";
import { button, download, fill, h, svg } from "./elements";
import { nodesOf, patchChildren } from "./figure_patch";
import { bench } from "./workbench";

/** Returns an axis of a plot. The value `lo` is at the position `from`, and `hi` at `to`, px. */
export function axisOf(plot: Element, name: "x" | "y") {
  const [lo, hi, from, to] = plot.getAttribute(`data-${name}`)!.split(" ").map(Number) as [number, number, number, number];
  return {
    lo,
    hi,
    px: (value: number) => from + ((value - lo) / (hi - lo)) * (to - from),
    value: (px: number) => lo + ((px - from) / (to - from)) * (hi - lo),
    ends: [from, to] as const,
  };
}

export class FigureSlot {
  readonly element = h("div", { class: "figure-slot", hidden: true });
  private readonly picture = h("div", {});
  private readonly values = button("CSV", () => this.keepValues(), { title: "Save the values of this figure" });
  private readonly save = h(
    "div",
    { class: "figure-save" },
    button("SVG", () => this.keepSvg(), { title: "Save this figure" }),
    button("PDF", () => void this.keepPdf(), { title: "Save this figure for a document" }),
    this.values,
  );
  private figure: Figure | null = null;
  private reduced = false;
  private t = NaN;
  private turn: ((t: number, moved: boolean) => void) | null = null; // for the figure as drawn

  /** `chosen` is called when the user clicks or drags to a position. `at` is called with the values at the
   *  pointer when the pointer moves or clicks on the plot. */
  constructor(chosen?: (t: number) => void, at?: (x: number, y: number, clicked: boolean) => void) {
    fill(this.element, this.picture, this.save);
    const choose = (event: PointerEvent) => {
      const place = this.valuesAt(event);
      if (!place) return;
      at?.(...place.at, false);
      if (chosen && place.pitch && event.buttons & 1) {
        const pitches = place.at[0] / place.pitch;
        chosen(pitches - Math.round(pitches));
      }
    };
    this.picture.addEventListener("pointerdown", choose);
    this.picture.addEventListener("pointermove", choose);
    this.picture.addEventListener("click", (event) => {
      const place = this.valuesAt(event);
      if (place) at?.(...place.at, true);
    });
  }

  /** `reduce` removes parts of the figure that are not visible before it is shown. */
  show(figure: Figure | undefined, reduce?: (nodes: DocumentFragment) => void): void {
    this.element.hidden = !figure;
    if (figure?.html !== this.figure?.html || this.reduced) {
      const nodes = nodesOf(figure?.html ?? "");
      reduce?.(nodes);
      this.reduced = reduce !== undefined;
      patchChildren(this.picture, nodes);
      this.turn = this.plot && figureTurn(this.plot);
    }
    const data = figure?.data;
    this.values.hidden = !(data?.curves.length || data?.points?.length || data?.grid);
    this.figure = figure ?? null;
    this.mark(this.t);
  }

  /** Moves the line to a position. If the figure consists of frames, shows the frame of this position. */
  mark(t: number): void {
    this.t = t;
    const { plot } = this;
    if (!plot || !Number.isFinite(t)) return;
    for (const old of plot.querySelectorAll(".cursor")) old.remove();
    const pitch = Number(plot.getAttribute("data-pitch"));
    if (pitch) {
      const x = axisOf(plot, "x");
      const [y1, y2] = axisOf(plot, "y").ends;
      const reach = Math.ceil(Math.max(Math.abs(x.lo), Math.abs(x.hi)) / Math.abs(pitch)) + 1;
      for (let k = -reach; k <= reach; ++k) {
        const value = (t + k) * pitch;
        if (value < x.lo || value > x.hi) continue;
        const at = x.px(value);
        plot.append(svg("path", { class: "cursor", d: `M${at} ${y1}L${at} ${y2}` }));
      }
    }
    this.turn?.(t, true);
  }

  get plot(): SVGGElement | null {
    return this.picture.querySelector("g.plot");
  }

  /** Returns the values at the pointer. If the pointer is outside the plot, returns null unless `beyond` is true. */
  valuesAt(event: MouseEvent, beyond = false): { at: [number, number]; pitch: number } | null {
    const picture = this.picture.querySelector("svg");
    const plot = picture?.querySelector("g.plot");
    if (!picture || !plot) return null;
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(picture.getScreenCTM()!.inverse());
    const [across, up] = [axisOf(plot, "x"), axisOf(plot, "y")];
    const outside = ([from, to]: readonly [number, number], px: number) => (px - from) * (px - to) > 0;
    if (!beyond && (outside(across.ends, x) || outside(up.ends, y))) return null;
    return { at: [across.value(x), up.value(y)], pitch: Number(plot.getAttribute("data-pitch")) };
  }

  /** Returns the visible picture as XML. */
  private xml(style = ""): string {
    const picture = this.picture.querySelector("svg")!.cloneNode(true) as SVGElement;
    if (style) picture.prepend(svg("style", {}, style));
    return new XMLSerializer().serializeToString(picture);
  }
  private keepSvg(): void {
    download(`${this.figure!.id}.svg`, this.xml(style), "image/svg+xml");
  }
  private async keepPdf(): Promise<void> {
    const { id, data } = this.figure!;
    const bytes = await bench.front.call("picturePdf", { svg: this.xml(), title: data.title });
    download(`${id}.pdf`, bytes as Uint8Array<ArrayBuffer>);
  }
  private keepValues(): void {
    const { x, y, curves, points, grid } = this.figure!.data;
    const words = (axis: { words: string; unit: string }) => (axis.unit ? `${axis.words}, ${axis.unit}` : axis.words);
    const cell = (text: string) => `"${text.replaceAll('"', '""')}"`;
    const rows = curves.flatMap(({ name, points }) =>
      points.map(([a, b]) => `${cell(name)},${a ?? ""},${b ?? ""}`),
    );
    rows.push(...(points ?? []).map(({ name, at: [a, b] }) => `${cell(name)},${a},${b}`));
    let head = ["curve", words(x), words(y)].map(cell).join();
    if (grid) {
      // The curves and points of a map are parts of its picture but not of its data. The file
      // contains only the values of the map.
      head = [words(x), words(y), words(grid)].map(cell).join();
      rows.splice(0, rows.length, ...grid.y.flatMap((b, i) => grid.x.map((a, k) => `${a},${b},${grid.values[i]![k] ?? ""}`)));
    }
    download(`${this.figure!.id}.csv`, [head, ...rows, ""].join("\n"), "text/csv");
  }
}

/** The figures of one result. A figure that is replaced keeps its place. New figures are added at the end. */
export class Figures {
  readonly element = h("div", { class: "plots" });
  private readonly slots = new Map<string, FigureSlot>();
  private t = NaN;
  private room = 0; // px, width of the element; 0 if it must be measured
  private width = 0; // px, the width of a figure when the figures were made last

  /** `resized` is called when the width of the figures changes. */
  constructor(
    private readonly chosen?: (t: number) => void,
    resized: () => void = () => undefined,
  ) {
    new ResizeObserver(() => {
      const before = this.width;
      this.room = this.element.clientWidth;
      if (!before || !this.room) return;
      if (Math.abs(this.fit() - before) > 8) resized();
      else this.width = before; // so that small changes add up
    }).observe(this.element);
  }

  /** Shows these figures. If `all` is true, removes all other figures. */
  show(figures: Figure[], all = true): void {
    for (const figure of figures) {
      if (!this.slots.has(figure.id)) {
        const slot = new FigureSlot(this.chosen);
        slot.mark(this.t);
        this.slots.set(figure.id, slot);
        this.element.append(slot.element);
      }
      this.slots.get(figure.id)!.show(figure);
    }
    if (!all) return;
    const ids = new Set(figures.map((one) => one.id));
    for (const [id, slot] of this.slots) if (!ids.has(id)) slot.show(undefined);
  }
  mark(t: number): void {
    this.t = t;
    for (const slot of this.slots.values()) slot.mark(t);
  }
  /** Arranges the figures in one column or in two. Returns the width of a figure, px. */
  fit(): number {
    this.room ||= this.element.clientWidth;
    const room = this.room || 600;
    const columns = Math.max(1, Math.min(2, Math.floor(room / 310)));
    this.element.style.gridTemplateColumns = `repeat(${columns}, minmax(0, 1fr))`;
    return (this.width = Math.round((room - 20) / columns));
  }
}
