// Controls for the solids of a drive. The user chooses the body whose rotation the slider sets, and
// the held, driving and driven bodies of a planetary set. The names of the bodies are shown in
// their colours. All bodies turn with their exact speed ratios.

import type { DriveSolids } from "../../engine/engine";
import { fill, h } from "../elements";
import { at, bench } from "../workbench";

const kRoles = { fixed: "held", input: "drives", output: "driven" };
type Role = keyof typeof kRoles;

function menu(words: string, options: string[], now: string, pick: (value: string) => void): HTMLElement {
  const list = h("select", { "aria-label": words }, ...options.map((one) => h("option", { selected: one === now }, one)));
  list.addEventListener("change", () => pick(list.value));
  return h("label", { class: "check", "data-menu": words }, words, list);
}

/** Returns a component of linear light as a CSS component from 0 to 255. */
const shade = (x: number) => Math.round(255 * (x > 0.0031308 ? 1.055 * x ** (1 / 2.4) - 0.055 : 12.92 * x));

export class DriveControls {
  readonly element = h("div", { class: "controls drive-controls", hidden: true });
  private solids: DriveSolids | null = null;
  /** The body whose rotation the slider gives. */
  turning = "";

  constructor(private readonly changed: () => void) {}

  /** Shows the controls of a drive. If `solids` is null, the controls are hidden. */
  show(solids: DriveSolids | null): void {
    this.solids = solids;
    this.element.hidden = !solids;
    if (!solids) return;
    const { bodies, parts, fixed, inputs, output } = solids;
    const turning = bodies.filter((body) => body.ratio).map((body) => body.name);
    if (!turning.includes(this.turning)) this.turning = turning.find((name) => inputs.includes(name)) ?? turning[0] ?? "";
    const turned = menu("slider turns", turning, this.turning, (name) => {
      this.turning = name;
      this.changed();
    });
    const roles = { fixed: fixed[0]!, input: inputs[0]!, output };
    const central = bodies.filter((body) => !body.rides).map((body) => body.name);
    const isSet = at(bench.good?.spec ?? undefined, "planetary") !== undefined;
    const choices = isSet && fixed.length === 1 && inputs.length === 1 && central.includes(output);
    const seen = bodies.filter((_, i) => parts.some((part) => part.body === i));
    fill(
      this.element,
      turned,
      ...(choices ? (Object.keys(kRoles) as Role[]) : []).map((role) =>
        menu(kRoles[role], central, roles[role], (name) => this.assign(roles, role, name)),
      ),
      h("ul", { class: "legend", "aria-label": "bodies" }, ...seen.map(({ name, colour }) =>
        h("li", {}, h("span", { class: "swatch", style: `background: rgb(${colour.map(shade).join()})` }), name))),
    );
  }

  /** Gives a role to a body. If the body already has another role, the two bodies exchange their
   *  roles. */
  private assign(roles: Record<Role, string>, role: Role, name: string): void {
    for (const other of Object.keys(kRoles) as Role[]) if (roles[other] === name) roles[other] = roles[role];
    roles[role] = name;
    bench.setKeys(Object.fromEntries(Object.entries(roles).map(([key, body]) => ["planetary." + key, body])));
  }

  /** Returns the pose of each part if the chosen body has made `whole` + t turns, as column-major 4×4 matrices. A
   *  rack returns to its start after each turn, because it would otherwise leave its pinion. */
  poses(t: number, whole: number): number[][] {
    const { parts, bodies } = this.solids!;
    const moves = parts.some(({ travel }) => travel[0] || travel[1]);
    const turns = (moves ? t : whole + t) / (bodies.find((body) => body.name === this.turning)?.ratio || 1);
    return parts.map(({ pose: start, turn, about, carried, travel }) => {
      const pose = Array.from(start);
      const rotate = (i: number, angle: number) => {
        const [x, y, c, s] = [pose[i]!, pose[i + 1]!, Math.cos(angle), Math.sin(angle)];
        [pose[i], pose[i + 1]] = [c * x - s * y, s * x + c * y];
      };
      for (const column of [0, 4, 8]) rotate(column, 2 * Math.PI * turn * turns);
      for (const k of [0, 1] as const) pose[12 + k]! -= about[k];
      rotate(12, 2 * Math.PI * carried * turns);
      for (const k of [0, 1] as const) pose[12 + k]! += about[k] + travel[k] * turns;
      return pose;
    });
  }
}
