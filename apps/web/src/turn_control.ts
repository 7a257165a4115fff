// Controls that turn a pair or a drive. They are a slider over one pitch of gear 1 or over one turn
// of a body, a button that starts and stops a continuous rotation, and the angle in degrees.

import { h, slide } from "./elements";

const kSeconds = 4; // per pitch

export class TurnControl {
  /** Rotation of gear 1 in pitches, or of a body in turns, −½ … ½. */
  t = 0;
  /** Completed pitches or turns, which the slider does not show. */
  whole = 0;
  private readonly run = h("button", { type: "button" }, "Turn");
  private readonly slider = h("input", { type: "range", min: -0.5, max: 0.5, step: 0.002, "aria-label": "rotation of gear 1" });
  private readonly angle = h("output", { class: "angle" });
  readonly elements = [this.run, slide("rotation", this.slider), this.angle];
  readonly stop: () => void;

  constructor(changed: () => void) {
    const turned = (t: number, whole: number) => {
      Object.assign(this, { t, whole });
      changed();
    };
    this.stop = figureDrive(this.run, this.slider, kSeconds, turned).stop;
  }

  /** Shows the position as an angle. `motion` contains the angle of the whole range of the slider,
   *  and `what` names the part that turns. */
  show(motion: { pitchDeg: number } | null, what = "gear 1"): void {
    this.slider.setAttribute("aria-label", `rotation of ${what}`);
    if (motion) this.angle.textContent = (this.t * motion.pitchDeg).toFixed(2) + "°";
  }
}
