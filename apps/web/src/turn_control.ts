// The controls that turn a pair: a slider over one pitch of gear 1, a button that lets the gears run,
// the angle in degrees.

import { button, h } from "./elements";
import { Turning, type Motion } from "./motion";

export class TurnControl {
  private readonly slider = h("input", {
    type: "range",
    min: -0.5,
    max: 0.5,
    step: 0.002,
    "aria-label": "rotation of gear 1",
    input: () => this.turning.set(Number(this.slider.value)),
  });
  private readonly angle = h("output", { class: "angle" });
  private readonly run = button("Turn", () => this.turning.toggle());
  readonly elements = [
    this.run,
    h("label", { class: "slide" }, h("span", {}, "rotation"), this.slider),
    this.angle,
  ];
  private readonly turning: Turning;

  constructor(changed: () => void) {
    this.turning = new Turning(changed);
  }
  /** Rotation of gear 1 in its pitches, −½ … ½. */
  get t(): number {
    return this.turning.t;
  }
  stop(): void {
    this.turning.stop();
  }
  show(motion: Motion | null): void {
    this.run.textContent = this.turning.runs ? "Stop" : "Turn";
    this.slider.value = String(this.t);
    if (motion) this.angle.textContent = (this.t * motion.pitchDeg).toFixed(2) + "°";
  }
}
