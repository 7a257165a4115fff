// The tab "solid": the pair in space, at any shaft angle. It turns, opens along a section, comes
// apart; the contact point and its ellipse move over the flanks, and the marking stays on them.

import { loadScene } from "gearwright:parts";
import { h, onThemeChange } from "../elements";
import { kOvertaken } from "../engine_link";
import { poseAt, type Motion } from "../motion";
import { at, bench } from "../workbench";
import type { Tab } from "../tabs";
import { TurnControl } from "../turn_control";
import type { SolidScene } from "./scene";

const kPositions = 64;

export class SolidView implements Tab {
  readonly id = "solid";
  readonly words = "solid";
  private readonly canvas = h("canvas", {
    tabindex: "0",
    role: "img",
    "aria-label": "the gears in space; arrows turn the view, + and − come closer, 0 restores",
  });
  private readonly state = h("output", { class: "readout" });
  private readonly turning = new TurnControl(() => this.arrange());
  private readonly cut = h("input", {
    type: "range",
    min: 0,
    max: 1,
    step: 0.005,
    value: 1,
    "aria-label": "section along the axis",
    input: () => this.arrange(),
  });
  private readonly apart = h("input", {
    type: "range",
    min: 0,
    max: 1,
    step: 0.01,
    value: 0,
    "aria-label": "gears apart",
    input: () => this.arrange(),
  });
  private readonly markBox = h("input", {
    type: "checkbox",
    checked: true,
    change: () => void this.paintPattern(),
  });
  readonly picture = h("div", { class: "canvas-room" }, this.canvas, this.state);
  readonly element = h(
    "div",
    { class: "picture solid-view" },
    this.picture,
    h(
      "div",
      { class: "controls" },
      ...this.turning.elements,
      h("label", { class: "slide short" }, h("span", {}, "section"), this.cut),
      h("label", { class: "slide short" }, h("span", {}, "apart"), this.apart),
      h("label", { class: "check" }, this.markBox, "marking"),
    ),
  );
  private scene: SolidScene | null = null;
  private motion: Motion | null = null;
  shown = "";
  private low = 0;
  private high = 0;
  private size = 1;
  private internal = false;

  constructor() {
    new ResizeObserver(() => this.scene?.ask()).observe(this.canvas);
    onThemeChange(() => this.scene?.recolour());
  }
  leave(): void {
    this.turning.stop();
  }

  async refresh(): Promise<void> {
    const solved = bench.good;
    if (!solved) {
      this.scene?.setMeshes([], [], 1);
      this.scene?.marks.show(null, 0, 1);
      this.shown = "";
      this.state.textContent = bench.nothing;
      this.motion = null;
      return;
    }
    if (!this.scene) {
      const { SolidScene } = await loadScene();
      try {
        this.scene = new SolidScene(this.canvas);
      } catch {
        throw new Error(
          "This browser shows no WebGL: the solids cannot be drawn here. The files can still be taken home.",
        );
      }
    }
    if (solved.text === this.shown) return this.scene.ask();
    const { design } = bench;
    const late = () => bench.design !== design || !bench.good;
    const answer = await bench.back.latest("meshes", "meshes", {
      text: solved.text,
      tolerance: this.tolerance(),
    });
    if (answer === kOvertaken || late()) return;
    const motion = await bench.back.latest("motion-solid", "motion", {
      text: solved.text,
      n: kPositions + 1,
    });
    if (motion === kOvertaken || late()) return;
    const fresh = this.scene.count !== answer.length;
    const gears = (solved.result?.["gears"] ?? []) as unknown as { teeth: number }[];
    this.internal = gears.some((gear) => gear.teeth < 0);
    const driver = at(solved.spec, "contact.driver") === 2 ? 2 : 1;
    this.scene.setMeshes(
      answer,
      gears.map((gear) => gear.teeth < 0),
      driver,
    );
    this.motion = motion;
    this.shown = solved.text;
    this.arrange();
    ({ low: this.low, high: this.high, size: this.size } = this.scene.extent());
    this.scene.frame(fresh);
    this.arrange();
    this.state.textContent = `${(answer.reduce((sum, mesh) => sum + mesh.indices.length / 3, 0) / 1000).toFixed(0)} thousand triangles`;
    await this.paintPattern();
  }

  /** Chords that the eye cannot see: a ten-thousandth of the size of the pair. */
  private tolerance(): number {
    const pair = bench.good?.result?.["pair"];
    const gears = (bench.good?.result?.["gears"] ?? []) as unknown as { tip_diameter_mm: number }[];
    const size = Math.max(
      ...gears.map((gear) => gear.tip_diameter_mm || 0),
      (at(pair, "center_distance_mm") as number) || 0,
    );
    return Math.min(0.05, Math.max(0.002, size * 1e-4));
  }

  private async paintPattern(): Promise<void> {
    const solved = bench.good;
    const scene = this.scene;
    if (!solved || !scene || solved.text !== this.shown) return;
    const thickness = (at(solved.spec, "contact.marking_mm") as number | undefined) ?? 0.00635;
    const clear = () => [0, 1].forEach((gear) => scene.marking(gear)?.set(null, 0));
    if (!this.markBox.checked || !solved.hasPair || !this.motion?.curve) {
      clear();
      return scene.ask();
    }
    const pattern = await bench.back
      .latest("pattern", "pattern", { text: solved.text, positions: 24, rows: 25, columns: 49 })
      .catch(() => null);
    if (pattern === kOvertaken || this.shown !== solved.text) return;
    if (!pattern) clear();
    else pattern.forEach((raster, gear) => scene.marking(gear)?.set(raster, thickness));
    scene.ask();
  }

  private arrange(): void {
    const { scene, motion } = this;
    this.turning.show(motion);
    if (!scene || !motion) return;
    const apart = Number(this.apart.value);
    // A pinion leaves its ring along the axis; other gears move away from each other.
    motion.places.forEach((_, gear) => {
      const pose = poseAt(motion, gear, this.turning.t);
      if (gear === 1) pose[this.internal ? 14 : 12]! += apart * this.size * 0.5;
      scene.place(gear, pose);
    });
    const share = Number(this.cut.value);
    scene.section(share >= 1 ? Infinity : this.low + share * (this.high - this.low));
    const i = ((Math.round((this.turning.t + 0.5) * kPositions) % kPositions) + kPositions) % kPositions;
    scene.marks.show(apart < 0.02 ? motion.curve : null, i, this.size);
    scene.ask();
  }
}
