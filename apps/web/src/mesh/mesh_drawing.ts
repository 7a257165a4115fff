// The mesh in section, drawn on a canvas: both gears from +z, axis 1 left, the path of contact with
// its letters, and where the flanks touch now.
//
// The engine computes every point. This file only scales and colours them.

import type { MeshLines, Section } from "../../engine/engine";
import { colour, font, sheetOf } from "../elements";
import { poseAt, turnAt, type Motion } from "../motion";
import type { ViewWindow } from "./view_window";

export interface Shape {
  section: Section;
  body: Path2D; // outline and bore in the gear's own frame, mm
  reach: number; // radius of all of it
}

function ring(path: Path2D, points: Float64Array): void {
  for (let i = 0; i < points.length; i += 2) {
    if (i === 0) path.moveTo(points[i]!, points[i + 1]!);
    else path.lineTo(points[i]!, points[i + 1]!);
  }
  path.closePath();
}

export function shapeOf(section: Section): Shape {
  const body = new Path2D();
  ring(body, section.outline);
  let reach = 0;
  for (let i = 0; i < section.outline.length; i += 2)
    reach = Math.max(reach, Math.hypot(section.outline[i]!, section.outline[i + 1]!));
  if (section.bore.length) ring(body, section.bore);
  if (section.internal) {
    // A ring without its own rim is shown with one of a tenth of its radius.
    let rim = 0;
    for (let i = 0; i < section.bore.length; i += 2)
      rim = Math.max(rim, Math.hypot(section.bore[i]!, section.bore[i + 1]!));
    if (!section.bore.length) {
      rim = reach * 1.08;
      body.moveTo(rim, 0);
      body.arc(0, 0, rim, 0, 2 * Math.PI);
      body.closePath();
    }
    reach = rim;
  }
  return { section, body, reach };
}

/** Where a gear is drawn: the middle of its circle and the direction of its tooth 0. */
export interface Placed {
  x: number;
  y: number;
  angle: number;
}

/** Where the gears stand at t: in the housing, or side by side where the axes cross. */
export function placesOf(shapes: Shape[], lines: MeshLines | null, motion: Motion | null, t: number): Placed[] {
  const crossed = lines?.kind === "crossed";
  const beside = crossed && shapes[1] ? shapes[0]!.reach + 1.12 * shapes[1].reach : (lines?.centerDistance ?? 0);
  return shapes.map((_, i) => {
    const x = i ? beside : 0;
    if (!motion) return { x, y: 0, angle: 0 };
    if (crossed) return { x, y: 0, angle: turnAt(motion, i, t) };
    const pose = poseAt(motion, i, t);
    return { x: pose[12]!, y: pose[13]!, angle: Math.atan2(pose[1]!, pose[0]!) };
  });
}
/** The ends of all gears across, and their greatest height above the centre line. */
export function extentOf(shapes: Shape[], places: Placed[]): [left: number, right: number, tall: number] {
  const reach = (side: number) => shapes.map((shape, i) => places[i]!.x + side * shape.reach);
  return [Math.min(...reach(-1)), Math.max(...reach(1)), Math.max(...shapes.map((one) => one.reach))];
}

export interface Scene {
  shapes: Shape[];
  places: Placed[];
  lines: MeshLines | null; // of parallel axes
  touch: { x: number; y: number } | null;
  circles: boolean;
}

/** Where a picture shows a point, px, and how large, px per mm. */
export interface Projection {
  px(x: number, y: number): [number, number];
  now: { scale: number };
}

/** The gears themselves: each filled, then all outlines over them. */
export function drawBodies(
  c: CanvasRenderingContext2D,
  view: Projection,
  { shapes, places }: Pick<Scene, "shapes" | "places">,
): void {
  const { scale } = view.now;
  const each = (paint: (body: Path2D, ink: string) => void) =>
    shapes.forEach(({ body }, i) => {
      c.save();
      c.translate(...view.px(places[i]!.x, places[i]!.y));
      c.scale(scale, -scale);
      c.rotate(places[i]!.angle);
      paint(body, `g${i + 1}`);
      c.restore();
    });
  each((body, ink) => {
    c.fillStyle = colour(ink + "-fill");
    c.fill(body, "evenodd");
  });
  each((body, ink) => {
    c.strokeStyle = colour(ink);
    c.lineWidth = 1.3 / scale;
    c.lineJoin = "round";
    c.stroke(body);
  });
}

const kCircleDash: Record<string, number[]> = { d: [12, 4, 2, 4], d_w: [12, 4, 2, 4], d_b: [7, 4] };

export function draw(canvas: HTMLCanvasElement, view: ViewWindow, scene: Scene): void {
  const sheet = sheetOf(canvas, 3);
  if (!sheet) return;
  const { c, width, height } = sheet;
  const scale = view.now.scale;
  drawBodies(c, view, scene);
  if (scene.circles) {
    scene.shapes.forEach((shape, i) => {
      const [x, y] = view.px(scene.places[i]!.x, scene.places[i]!.y);
      c.strokeStyle = colour(`g${i + 1}`);
      c.globalAlpha = 0.65;
      c.lineWidth = 0.9;
      for (const circle of shape.section.circles) {
        c.setLineDash(kCircleDash[circle.symbol.replace(/\d$/, "")] ?? [1.5, 3]);
        c.beginPath();
        c.arc(x, y, circle.radius * scale, 0, 2 * Math.PI);
        c.stroke();
      }
      c.setLineDash([]);
      c.globalAlpha = 1;
    });
    circleNames(c, view, scene, width, height);
  }
  for (const place of scene.places) cross(c, view.px(place.x, place.y));
  if (scene.lines) contactLines(c, view, scene.lines);
  if (scene.touch) {
    const [x, y] = view.px(scene.touch.x, scene.touch.y);
    c.beginPath();
    c.arc(x, y, 6, 0, 2 * Math.PI);
    c.fillStyle = colour("paper");
    c.globalAlpha = 0.75;
    c.fill();
    c.globalAlpha = 1;
    c.strokeStyle = colour("action");
    c.lineWidth = 2.2;
    c.stroke();
  }
}

function cross(c: CanvasRenderingContext2D, [x, y]: [number, number]): void {
  c.strokeStyle = colour("ink");
  c.lineWidth = 1;
  c.beginPath();
  c.moveTo(x - 6, y);
  c.lineTo(x + 6, y);
  c.moveTo(x, y - 6);
  c.lineTo(x, y + 6);
  c.stroke();
}

/** The symbol of each circle beside it: where it leaves the picture or, if all of it is seen, above
 *  its middle; where two are too close, on the next free height. */
function circleNames(
  c: CanvasRenderingContext2D,
  view: ViewWindow,
  scene: Scene,
  width: number,
  height: number,
): void {
  const taken: [number, number][] = [];
  c.font = font("12px");
  c.textBaseline = "middle";
  c.textAlign = "center";
  c.lineWidth = 3.5;
  c.lineJoin = "round";
  const rightwards = scene.shapes.length > 1 && !scene.shapes[1]!.section.internal;
  const facing = (i: number) => (rightwards && i === 0 ? 0 : Math.PI);
  scene.shapes.forEach((shape, i) => {
    const { x, y } = scene.places[i]!;
    const circles = [...shape.section.circles].sort((a, b) => a.radius - b.radius);
    for (const { symbol, radius } of circles) {
      // The first visible and free place from the side of the mesh upwards, in steps of 2°.
      for (let step = 4; step < 90; ++step) {
        const angle = facing(i) + (facing(i) === 0 ? 1 : -1) * (step * Math.PI) / 90;
        const [px, py] = view.px(x + radius * Math.cos(angle), y + radius * Math.sin(angle));
        if (px < 18 || px > width - 18 || py < 12 || py > height - 30) continue;
        if (taken.some(([tx, ty]) => Math.abs(tx - px) < 30 && Math.abs(ty - py) < 17)) continue;
        if (scene.lines?.points.some((point) => near(view.px(point.x, point.y), px, py))) continue;
        taken.push([px, py]);
        writeSymbol(c, symbol, px, py, colour(`g${i + 1}`));
        break;
      }
    }
  });
}
function near([ax, ay]: [number, number], px: number, py: number): boolean {
  return Math.abs(ax - px) < 28 && Math.abs(ay - py) < 18;
}
/** A symbol, "d_a1", its index lower, on a halo of the picture's ground. */
function writeSymbol(c: CanvasRenderingContext2D, symbol: string, x: number, y: number, ink: string): void {
  const [head, index = ""] = symbol.split("_");
  const large = `italic 13px "STIX Two Text", "Times New Roman", "DejaVu Serif", serif`;
  const small = font("10px");
  c.textAlign = "left";
  c.font = large;
  const first = c.measureText(head!).width;
  c.font = small;
  const left = x - (first + c.measureText(index).width) / 2;
  c.strokeStyle = colour("panel");
  c.fillStyle = ink;
  for (const paint of ["strokeText", "fillText"] as const) {
    c.font = large;
    c[paint](head!, left, y);
    c.font = small;
    c[paint](index, left + first + 0.5, y + 4);
  }
}

function polyline(c: CanvasRenderingContext2D, view: ViewWindow, points: Float64Array): void {
  c.beginPath();
  for (let i = 0; i + 2 < points.length; i += 3) {
    const [x, y] = view.px(points[i]!, points[i + 1]!);
    if (i === 0) c.moveTo(x, y);
    else c.lineTo(x, y);
  }
  c.stroke();
}

function contactLines(c: CanvasRenderingContext2D, view: ViewWindow, lines: MeshLines): void {
  c.strokeStyle = colour("trailing");
  c.lineWidth = 1;
  c.setLineDash([3, 3]);
  polyline(c, view, lines.trailingLine);
  c.strokeStyle = colour("action");
  polyline(c, view, lines.lineOfAction);
  c.setLineDash([]);
  c.lineWidth = 3;
  polyline(c, view, lines.pathOfContact);
  c.font = font("italic 600 14px");
  c.textAlign = "center";
  c.textBaseline = "middle";
  const placed: [number, number][] = [];
  for (const point of lines.points) {
    const [x, y] = view.px(point.x, point.y);
    c.beginPath();
    c.arc(x, y, 3, 0, 2 * Math.PI);
    c.fillStyle = colour(point.name === "C" ? "ink" : "action");
    c.fill();
    if (placed.some(([px, py]) => Math.hypot(px - x, py - y) < 15)) continue;
    placed.push([x, y]);
    c.lineWidth = 4;
    c.strokeStyle = colour("panel");
    c.fillStyle = colour("ink");
    c.strokeText(point.name, x - 13, y - 2);
    c.fillText(point.name, x - 13, y - 2);
  }
}
