// A flank laid flat: the face from left to right, the root below, the tip above; its edges and axes.

import { colour, font, h, type Sheet, sheetOf } from "../elements";
import { fixed, shownUnit, toShown } from "../numbers";

const kRoom = { left: 46, right: 12, top: 10, bottom: 34 };

export interface Box {
  x: number;
  y: number;
  w: number;
  h: number;
}
/** Ends of the face and of the diameters, mm. */
export type Span = [height0: number, height1: number, diameter0: number, diameter1: number];

export abstract class FlankFrame {
  readonly canvas = h("canvas", { role: "img" });
  protected span: Span = [0, 1, 0, 1];

  constructor(label: string) {
    this.canvas.setAttribute("aria-label", label);
  }

  /** An empty flank of this span, or nothing where the canvas has no room. */
  protected begin(span: Span | null): (Sheet & { box: Box }) | null {
    const sheet = sheetOf(this.canvas, 2);
    if (!sheet || !span) return null;
    const { c, width, height } = sheet;
    this.span = span;
    const box = {
      x: kRoom.left,
      y: kRoom.top,
      w: width - kRoom.left - kRoom.right,
      h: height - kRoom.top - kRoom.bottom,
    };
    c.fillStyle = colour("paper");
    c.fillRect(box.x, box.y, box.w, box.h);
    return { ...sheet, box };
  }

  protected frame(c: CanvasRenderingContext2D, box: Box): void {
    c.strokeStyle = colour("ink");
    c.lineWidth = 1.2;
    c.strokeRect(box.x, box.y, box.w, box.h);
    this.axes(c, box);
  }

  protected px(box: Box, height: number, diameter: number): [number, number] {
    const [z0, z1, d0, d1] = this.span;
    return [box.x + ((height - z0) / (z1 - z0)) * box.w, box.y + (1 - (diameter - d0) / (d1 - d0)) * box.h];
  }

  private axes(c: CanvasRenderingContext2D, box: Box): void {
    const [z0, z1, d0, d1] = this.span;
    c.fillStyle = colour("soft");
    c.font = font("11.5px");
    c.textAlign = "right";
    c.textBaseline = "middle";
    for (const d of [d0, (d0 + d1) / 2, d1])
      c.fillText(fixed(toShown(d, "mm"), 2), box.x - 5, this.px(box, z0, d)[1]);
    c.textBaseline = "top";
    for (const z of [z0, 0, z1]) {
      c.textAlign = z === z0 ? "left" : z === z1 ? "right" : "center";
      c.fillText(fixed(toShown(z, "mm"), 1), this.px(box, z, d0)[0], box.y + box.h + 4);
    }
    c.textAlign = "center";
    c.fillText(`along the face, ${shownUnit("mm")}`, box.x + box.w / 2, box.y + box.h + 19);
  }
}

export function rgb(text: string): number[] {
  const hex = text.length === 4 ? text.replace(/[0-9a-f]/gi, "$&$&") : text;
  return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16));
}
export function mix(a: number[], b: number[], share: number): number[] {
  return a.map((one, i) => Math.round(one + share * (b[i]! - one)));
}
