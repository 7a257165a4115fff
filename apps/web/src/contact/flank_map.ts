// A flank laid flat: the face from left to right, the root below, the tip above. The light shade is
// what marking compound shows after a mesh, the darker steps the gap at this instant; the way of the
// contact point runs through it, dashed where an edge touches.

import type { ContactCurve, FlankRaster } from "../../engine/engine";
import { colour } from "../elements";
import { isEdge } from "./curves";
import { type Box, FlankFrame, mix, rgb } from "./flank_frame";

const kLevelsUm = [1, 2, 5, 10, 20, 50];

export class FlankMap extends FlankFrame {
  pattern: FlankRaster | null = null;
  gap: FlankRaster | null = null;

  constructor(private readonly gear: 0 | 1) {
    super(`flank of gear ${gear + 1}`);
  }

  draw(curve: ContactCurve | null, index: number, markingMm: number): void {
    const raster = this.pattern ?? this.gap;
    const d = raster?.diameter;
    const z = raster?.height;
    const room = this.begin(d && z ? [z[0]!, z[z.length - 1]!, d[0]!, d[d.length - 1]!] : null);
    if (!room) return;
    const { c, box, ratio } = room;
    this.shade(c, box, ratio, markingMm);
    this.frame(c, box);
    if (curve) this.way(c, box, curve, index);
  }

  /** Both shades, a dot of the canvas at a time, bilinear in the raster. */
  private shade(c: CanvasRenderingContext2D, box: Box, ratio: number, markingMm: number): void {
    const w = Math.max(1, Math.round(box.w * ratio));
    const hh = Math.max(1, Math.round(box.h * ratio));
    const image = c.createImageData(w, hh);
    const mark = rgb(colour("flank"));
    const paper = rgb(colour("paper"));
    const steps = kLevelsUm.map((_, i) => mix(paper, mark, 0.86 - 0.13 * i));
    const light = mix(paper, mark, 0.26);
    for (let j = 0; j < hh; ++j) {
      const v = 1 - (j + 0.5) / hh;
      for (let i = 0; i < w; ++i) {
        const u = (i + 0.5) / w;
        let dye: number[] | null = this.pattern && gapAt(this.pattern, u, v) < markingMm ? light : null;
        if (this.gap) {
          const um = 1000 * gapAt(this.gap, u, v);
          const level = kLevelsUm.findIndex((one) => um < one);
          if (level >= 0) dye = steps[level]!;
        }
        if (!dye) continue;
        const k = 4 * (j * w + i);
        image.data[k] = dye[0]!;
        image.data[k + 1] = dye[1]!;
        image.data[k + 2] = dye[2]!;
        image.data[k + 3] = 255;
      }
    }
    c.putImageData(image, Math.round(box.x * ratio), Math.round(box.y * ratio));
  }

  private way(c: CanvasRenderingContext2D, box: Box, curve: ContactCurve, index: number): void {
    const d = curve.columns["diameter_mm"];
    const z = curve.columns["height_mm"];
    const tooth = curve.columns["tooth"];
    const kinds = curve.columns["kind"];
    if (!(d instanceof Float64Array) || !(z instanceof Float64Array)) return;
    const point = (i: number) => this.px(box, z[2 * i + this.gear]!, d[2 * i + this.gear]!);
    for (let i = 0; i + 1 < curve.n; ++i) {
      if (!Number.isFinite(d[2 * i]) || !Number.isFinite(d[2 * i + 2])) continue;
      if (tooth instanceof Float64Array && tooth[i] !== tooth[i + 1]) continue;
      const kind = Array.isArray(kinds) ? kinds[i]! : "interior";
      const edge = isEdge(kind);
      c.strokeStyle = colour(edge ? "root-fillet" : "action");
      c.lineWidth = edge ? 3.5 : 2;
      c.beginPath();
      c.moveTo(...point(i));
      c.lineTo(...point(i + 1));
      c.stroke();
    }
    if (!Number.isFinite(d[2 * index])) return;
    c.beginPath();
    c.arc(...point(index), 5, 0, 2 * Math.PI);
    c.fillStyle = colour("paper");
    c.fill();
    c.lineWidth = 2;
    c.strokeStyle = colour("ink");
    c.stroke();
  }
}

/** u along the face, v up the profile, both 0 … 1. */
function gapAt(raster: FlankRaster, u: number, v: number): number {
  const columns = raster.height.length;
  const rows = raster.diameter.length;
  const x = u * (columns - 1);
  const y = v * (rows - 1);
  const i = Math.min(Math.floor(x), columns - 2);
  const j = Math.min(Math.floor(y), rows - 2);
  const at = (row: number, column: number) => raster.gap[row * columns + column]!;
  const low = at(j, i) + (x - i) * (at(j, i + 1) - at(j, i));
  const high = at(j + 1, i) + (x - i) * (at(j + 1, i + 1) - at(j + 1, i));
  const gap = low + (y - j) * (high - low);
  return Number.isNaN(gap) ? Infinity : gap;
}
