// The tab "solid" shows the pair in space, at any shaft angle. The user turns the view, cuts the solids, and
// moves the gears apart. The contact point and its ellipse move over the flanks. The contact pattern stays on
// the flanks. While a value changes, the solids are coarser and have no pattern. A drive is shown with all its
// bodies, which turn with their exact speed ratios.

import { loadScene } from "gearwright:parts";
import type { Mesh } from "../../engine/engine";
import type { Solved } from "../engine_worker";
import { check, h, onThemeChange, slide, slider } from "../elements";
import { poseAt, type Motion } from "../motion";
import { at, bench, isDrive } from "../workbench";
import type { Tab } from "../tabs";
import { TurnControl } from "../turn_control";
import { DriveControls } from "./drive_controls";
import type { SolidScene } from "./scene";

const kPositions = 64; // in one pitch
/** Chord tolerance while a value changes relative to that of a value at rest, and number of positions. */
const kCoarse = 8;
const kCoarsePositions = 16;

export class SolidView implements Tab {
  readonly id = "solid";
  readonly ofDrives = true;
  private readonly canvas = h("canvas", {
    tabindex: "0",
    role: "img",
    "aria-label": "the gears in three dimensions; the arrow keys turn the view, + and − zoom, 0 restores the view",
  });
  private readonly state = h("output", { class: "readout" });
  private readonly turning = new TurnControl(() => this.arrange());
  private readonly cut = slider("section along the axis", { min: 0, max: 1, step: 0.005, value: 1 }, () =>
    this.arrange(),
  );
  private readonly apart = slider("gears apart", { min: 0, max: 1, step: 0.01, value: 0 }, () =>
    this.arrange(),
  );
  private readonly markBox = h("input", {
    type: "checkbox",
    checked: true,
    change: () => void this.paintPattern(),
  });
  private readonly drive = new DriveControls(() => this.arrange());
  private readonly ofPair = [slide("apart", this.apart), check("marking", this.markBox)];
  readonly picture = h("div", { class: "canvas-room" }, this.canvas, this.state);
  readonly element = h(
    "div",
    { class: "picture solid-view" },
    this.picture,
    h(
      "div",
      { class: "controls" },
      ...this.turning.elements,
      slide("section", this.cut),
      ...this.ofPair,
    ),
    this.drive.element,
  );
  private scene: SolidScene | null = null;
  private motion: Motion | null = null;
  shown = "";
  private low = 0;
  private high = 0;
  private size = 1;
  private internal = false;

  constructor() {
    new ResizeObserver(() => this.scene?.repaint()).observe(this.canvas);
    onThemeChange(() => this.scene?.recolour());
  }
  leave(): void {
    this.turning.stop();
  }
  inUnits(): void {} // the solids contain no lengths

  async refresh(): Promise<void> {
    const solved = bench.good;
    if (!solved) {
      this.scene?.setMeshes([], [], 1);
      this.scene?.marks.show(null, 0, 1);
      this.drive.show(null);
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
          "This browser does not support WebGL, so the solids cannot be drawn. The files can still be downloaded.",
        );
      }
    }
    if (solved.text === this.shown) return this.scene.repaint();
    for (const control of this.ofPair) control.hidden = isDrive();
    if (isDrive()) return this.showDrive(solved.text);
    const { moving } = bench;
    await this.showGears(solved, moving);
    if (!(await bench.rested(solved))) return;
    if (moving) await this.showGears(solved, false);
    await this.paintPattern();
  }

  /** Shows the gears and their motion, which two workers compute at the same time. */
  private async showGears(solved: Solved, coarse: boolean): Promise<void> {
    const { text } = solved;
    const tolerance = this.tolerance() * (coarse ? kCoarse : 1);
    const n = (coarse ? kCoarsePositions : kPositions) + 1;
    const [answer, motion] = await Promise.all([
      bench.about(bench.back, "meshes", "meshes", { text, tolerance }),
      bench.about(bench.front, "motion", "motion", { text, n }),
    ]);
    if (!answer || !motion || !this.scene) return;
    this.drive.show(null);
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
    this.settle(text, fresh, answer);
  }

  private async showDrive(text: string): Promise<void> {
    const solids = await bench.about(bench.back, "solids", "driveSolids", { text });
    if (!solids || !this.scene) return;
    const fresh = this.scene.count !== solids.parts.length;
    this.motion = null;
    this.scene.marks.show(null, 0, 1);
    this.scene.setParts(solids);
    this.drive.show(solids);
    this.settle(text, fresh, solids.parts.map(({ mesh, same }) => (mesh ?? solids.parts[same!]!.mesh)!));
  }

  /** Shows the new solids at the current position. */
  private settle(text: string, fresh: boolean, meshes: Mesh[]): void {
    const scene = this.scene!;
    this.shown = text;
    this.arrange();
    ({ low: this.low, high: this.high, size: this.size } = scene.extent());
    scene.frame(fresh);
    this.arrange();
    const triangles = meshes.reduce((sum, mesh) => sum + mesh.indices.length / 3, 0);
    this.state.textContent = `${(triangles / 1000).toFixed(0)} thousand triangles`;
  }

  /** Returns a chord tolerance in mm that is too small to be visible. It is a ten-thousandth of the
   *  size of the pair, but at least 0.002 mm and at most 0.05 mm. */
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
    const marked = this.markBox.checked && solved.hasPair && this.motion?.curve;
    const question = { text: solved.text, positions: 24, rows: 25, columns: 49 };
    const pattern = marked ? await bench.back.latest("pattern", "pattern", question).catch(() => []) : [];
    if (!pattern || this.shown !== solved.text) return;
    for (const gear of [0, 1]) scene.marking(gear)?.set(pattern[gear] ?? null, thickness);
    scene.repaint();
  }

  private arrange(): void {
    const { scene, motion } = this;
    if (!this.drive.element.hidden) this.turning.show({ pitchDeg: 360 }, this.drive.turning);
    else this.turning.show(motion);
    if (!scene) return;
    const share = Number(this.cut.value);
    scene.section(share >= 1 ? Infinity : this.low + share * (this.high - this.low));
    const { t, whole } = this.turning;
    if (!this.drive.element.hidden) this.drive.poses(t, whole).forEach((pose, part) => scene.place(part, pose));
    if (!motion) return;
    const apart = Number(this.apart.value);
    // To separate the gears, only gear 2 is moved. If one of the gears is internal, gear 2 moves
    // along its axis, otherwise along the centre line.
    motion.places.forEach((_, gear) => {
      const pose = poseAt(motion, gear, this.turning.t);
      if (gear === 1) pose[this.internal ? 14 : 12]! += apart * this.size * 0.5;
      scene.place(gear, pose);
    });
    const positions = motion.n - 1;
    const i = ((Math.round((this.turning.t + 0.5) * positions) % positions) + positions) % positions;
    scene.marks.show(apart < 0.02 ? motion.curve : null, i, this.size);
    scene.repaint();
  }
}
