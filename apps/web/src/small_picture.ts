// The small picture of a card: both gears in section, whole, without letters.

import type { MeshLines, Section } from "../engine/engine";
import { colour } from "./elements";
import { shapeOf } from "./mesh/mesh_drawing";
import { turnAt, poseAt, type Motion } from "./motion";

export interface Turnable {
  sections: Section[];
  lines: MeshLines | null;
  motion: Motion | null;
}

export function paintSmall(canvas: HTMLCanvasElement, what: Turnable): void {
  const c = canvas.getContext("2d")!;
  const shapes = what.sections.map(shapeOf);
  const crossed = what.lines?.kind === "crossed";
  const x2 = shapes[1]
    ? crossed
      ? shapes[0]!.reach + 1.1 * shapes[1].reach
      : (what.lines?.centerDistance ?? 0)
    : 0;
  const left = Math.min(-shapes[0]!.reach, x2 - (shapes[1]?.reach ?? 0));
  const right = Math.max(shapes[0]!.reach, x2 + (shapes[1]?.reach ?? 0));
  const tall = Math.max(...shapes.map((one) => one.reach));
  const scale = 0.9 * Math.min(canvas.width / (right - left), canvas.height / (2 * tall));
  c.clearRect(0, 0, canvas.width, canvas.height);
  const each = (paint: (i: number) => void) =>
    shapes.forEach((_, i) => {
      const angle = !what.motion
        ? 0
        : crossed
          ? turnAt(what.motion, i, 0)
          : angleOf(poseAt(what.motion, i, 0));
      c.save();
      c.translate(canvas.width / 2 + ((i ? x2 : 0) - (left + right) / 2) * scale, canvas.height / 2);
      c.scale(scale, -scale);
      c.rotate(angle);
      paint(i);
      c.restore();
    });
  each((i) => {
    c.fillStyle = colour(`g${i + 1}-fill`);
    c.fill(shapes[i]!.body, "evenodd");
  });
  each((i) => {
    c.strokeStyle = colour(`g${i + 1}`);
    c.lineWidth = 1.2 / scale;
    c.stroke(shapes[i]!.body);
  });
}
function angleOf(pose: number[]): number {
  return Math.atan2(pose[1]!, pose[0]!);
}
