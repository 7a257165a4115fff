// The part of the plane that a picture shows, and its controls: wheel or pinch zooms about the
// pointer, a drag moves, a double click restores. The keys + − 0 and the arrows do the same.

import { onKeys } from "../elements";

const kStep = 40; // px, of an arrow key

export interface Window {
  x: number; // of the middle, mm
  y: number;
  scale: number; // px per mm
}

export class ViewWindow {
  now: Window = { x: 0, y: 0, scale: 1 };
  private home: Window = { x: 0, y: 0, scale: 1 };
  private touched = false;
  private readonly held = new Map<number, { x: number; y: number }>();

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly changed: () => void,
  ) {
    canvas.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        this.zoom(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0016)), event.offsetX, event.offsetY);
      },
      { passive: false },
    );
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      this.held.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
    });
    canvas.addEventListener("pointermove", (event) => this.drag(event));
    for (const name of ["pointerup", "pointercancel"] as const)
      canvas.addEventListener(name, (event) => void this.held.delete(event.pointerId));
    canvas.addEventListener("dblclick", () => this.restore());
    onKeys(canvas, {
      "+": () => this.come(1.25),
      "=": () => this.come(1.25),
      "-": () => this.come(0.8),
      "0": () => this.restore(),
      ArrowLeft: () => this.move(kStep, 0),
      ArrowRight: () => this.move(-kStep, 0),
      ArrowUp: () => this.move(0, kStep),
      ArrowDown: () => this.move(0, -kStep),
    });
  }

  /** The window that shows a rectangle, as the one to restore. Keeps a window that was moved by hand
   *  unless `take`. */
  frame(x0: number, x1: number, y0: number, y1: number, take: boolean, room = 0.06): void {
    const width = Math.max(1, this.canvas.clientWidth);
    const height = Math.max(1, this.canvas.clientHeight);
    const scale = Math.min(width / (x1 - x0), height / (y1 - y0)) * (1 - 2 * room);
    this.home = { x: (x0 + x1) / 2, y: (y0 + y1) / 2, scale };
    if (take || !this.touched) this.restore();
  }
  restore(): void {
    this.touched = false;
    this.now = { ...this.home };
    this.changed();
  }

  px(x: number, y: number): [number, number] {
    return [
      this.canvas.clientWidth / 2 + (x - this.now.x) * this.now.scale,
      this.canvas.clientHeight / 2 - (y - this.now.y) * this.now.scale,
    ];
  }
  mm(px: number, py: number): [number, number] {
    return [
      this.now.x + (px - this.canvas.clientWidth / 2) / this.now.scale,
      this.now.y - (py - this.canvas.clientHeight / 2) / this.now.scale,
    ];
  }

  private zoom(factor: number, px: number, py: number): void {
    const [x, y] = this.mm(px, py);
    const scale = Math.min(Math.max(this.now.scale * factor, this.home.scale * 0.2), this.home.scale * 1e5);
    const ratio = this.now.scale / scale;
    this.now = { x: x + (this.now.x - x) * ratio, y: y + (this.now.y - y) * ratio, scale };
    this.touched = true;
    this.changed();
  }
  private move(dx: number, dy: number): void {
    this.now.x -= dx / this.now.scale;
    this.now.y += dy / this.now.scale;
    this.touched = true;
    this.changed();
  }

  private drag(event: PointerEvent): void {
    const before = this.held.get(event.pointerId);
    if (!before) return;
    const here = { x: event.offsetX, y: event.offsetY };
    this.held.set(event.pointerId, here);
    const other = [...this.held].find(([id]) => id !== event.pointerId)?.[1];
    if (!other) return this.move(here.x - before.x, here.y - before.y);
    const apart = (p: { x: number; y: number }) => Math.hypot(p.x - other.x, p.y - other.y) || 1;
    this.zoom(apart(here) / apart(before), (here.x + other.x) / 2, (here.y + other.y) / 2);
    this.move((here.x - before.x) / 2, (here.y - before.y) / 2);
  }

  /** Comes closer to the middle. */
  private come(factor: number): void {
    this.zoom(factor, this.canvas.clientWidth / 2, this.canvas.clientHeight / 2);
  }
}
