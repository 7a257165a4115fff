// The pressure on a flank laid flat: the shade is what a tooth bears while it goes through the mesh,
// the lines where teeth bear at this instant, drawn side by side on one flank.

import type { LoadedTorque } from "../../engine/engine";
import { type Box, FlankFrame, mix, rgb } from "../contact/flank_frame";
import { colour } from "../elements";

const kShades = 16;
interface Place {
  diameter: number;
  pressure: number;
}

export class PressureMap extends FlankFrame {
  constructor(private readonly gear: 1 | 2) {
    super(`pressure on the flank of gear ${gear}`);
  }

  draw(torque: LoadedTorque | null, height: Float64Array, index: number, greatest: number): void {
    const columns = torque ? this.columns(torque, height.length) : [];
    const all = columns.flat().map((one) => one.diameter);
    const step = height.length > 1 ? Math.abs(height[1]! - height[0]!) : 1;
    const ends = [Math.min(...height) - step / 2, Math.max(...height) + step / 2];
    const room = this.begin(
      torque && all.length ? [ends[0]!, ends[1]!, Math.min(...all), Math.max(...all)] : null,
    );
    if (!room || !torque) return;
    const { c, box } = room;
    columns.forEach((places, j) => this.shade(c, box, places, height[j]!, step, greatest));
    this.frame(c, box);
    for (const tooth of torque.teeth) this.line(c, box, tooth, height, index);
  }

  /** Of each slice of the face what it bears over the mesh, from the root to the tip. */
  private columns(torque: LoadedTorque, slices: number): Place[][] {
    const columns: Place[][] = Array.from({ length: slices }, () => []);
    for (const tooth of torque.teeth) {
      const diameter = this.gear === 1 ? tooth.diameter1 : tooth.diameter2;
      tooth.pressure.forEach((pressure, i) => {
        if (Number.isFinite(pressure)) columns[i % slices]!.push({ diameter: diameter[i]!, pressure });
      });
    }
    for (const places of columns) places.sort((a, b) => a.diameter - b.diameter);
    return columns;
  }

  /** Bands from one place to the next, each in the mean of both. */
  private shade(
    c: CanvasRenderingContext2D,
    box: Box,
    places: Place[],
    height: number,
    step: number,
    most: number,
  ): void {
    const left = this.px(box, height - step / 2, 0)[0];
    const right = this.px(box, height + step / 2, 0)[0];
    const paper = rgb(colour("paper"));
    const ink = rgb(colour("root-fillet"));
    for (let i = 0; i + 1 < places.length; ++i) {
      const [a, b] = [places[i]!, places[i + 1]!];
      const share = (a.pressure + b.pressure) / 2 / (most || 1);
      if (!(share > 0)) continue;
      const [r, g, blue] = mix(paper, ink, Math.ceil(kShades * Math.min(1, share)) / kShades);
      c.fillStyle = `rgb(${r} ${g} ${blue})`;
      const low = this.px(box, height, a.diameter)[1];
      const high = this.px(box, height, b.diameter)[1];
      c.fillRect(Math.floor(left), high - 0.5, Math.ceil(right) - Math.floor(left), low - high + 1);
    }
  }

  private line(
    c: CanvasRenderingContext2D,
    box: Box,
    tooth: LoadedTorque["teeth"][number],
    height: Float64Array,
    index: number,
  ): void {
    const diameter = this.gear === 1 ? tooth.diameter1 : tooth.diameter2;
    c.strokeStyle = colour("ink");
    c.lineWidth = 2;
    c.beginPath();
    let down = false;
    height.forEach((z, j) => {
      const i = index * height.length + j;
      if (!(tooth.pressure[i]! > 0)) {
        down = false;
        return;
      }
      const [x, y] = this.px(box, z, diameter[i]!);
      if (down) c.lineTo(x, y);
      else c.moveTo(x - 1, y);
      down = true;
    });
    c.stroke();
  }
}
