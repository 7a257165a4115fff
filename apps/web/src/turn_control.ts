// Controls that turn a pair or a drive. They are a slider over one pitch of gear 1 or over one turn
// of a body, a button that starts and stops a continuous rotation, and the angle in degrees.

import { button, h, slide, slider } from "./elements";

export class TurnControl {
  /** Rotation of gear 1 in pitches, or of a body in turns, −½ … ½. */
  t = 0;
  /** Completed pitches or turns, which the slider does not show. */
  whole = 0;
  private readonly slider = slider("rotation of gear 1", { min: -0.5, max: 0.5, step: 0.002 }, (t) => {
    this.t = t;
    this.changed();
  });
  private readonly angle = h("output", { class: "angle" });
  private readonly run = button("Turn", () => this.toggle());
  readonly elements = [this.run, slide("rotation", this.slider), this.angle];
  private running = 0;
  private last = 0;

  constructor(private readonly changed: () => void) {}

  /** Shows the position. `motion` gives the range of the slider, and `what` names the part that turns. */
  show(motion: { pitchDeg: number } | null, what = "gear 1"): void {
    this.run.textContent = this.running ? "Stop" : "Turn";
    this.slider.value = String(this.t);
    this.slider.setAttribute("aria-label", `rotation of ${what}`);
    if (motion) this.angle.textContent = (this.t * motion.pitchDeg).toFixed(2) + "°";
  }
  stop(): void {
    cancelAnimationFrame(this.running);
    this.running = 0;
  }

  private toggle(): void {
    if (this.running) this.stop();
    else {
      this.last = performance.now();
      this.running = requestAnimationFrame(this.frame);
    }
    this.changed();
  }
  private readonly frame = (now: number) => {
    this.t += (now - this.last) / 4000; // one pitch in four seconds
    this.last = now;
    if (this.t > 0.5) {
      this.t -= 1;
      this.whole += 1;
    }
    this.running = requestAnimationFrame(this.frame);
    this.changed();
  };
}
