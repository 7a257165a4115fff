// The tab "load": teeth under torque. While the spec changes a draft follows; when it rests, the full
// answer takes its place. A spec without a torque is offered one. Every number is the engine's; the
// page draws.

import type { LoadedTorque } from "../../engine/engine";
import { AnswerView } from "../answer_view";
import { quantities } from "../catalogue";
import { Choice, figure, fill, flankFigure, h, onThemeChange, slide, slider } from "../elements";
import type { Fault, Json, Loaded } from "../engine_worker";
import { firstMaterial, firstTorque } from "../form/offer";
import { judgement } from "../judgement";
import { CurvePlot, kFromNothing } from "../plot";
import { rowsOf } from "../quantity_table";
import { at, bench } from "../workbench";
import { PressureMap } from "./pressure_map";

/** A spec that has not changed for so long rests. */
const kRestMs = 1200;
const kNeeds = {
  keys: ["load.torque_Nm"],
  without: "The spec has no torque.",
  alone: "One gear bears nothing: a second one makes a pair.",
  offer: "How the teeth share a load, yield and are stressed, for a torque:",
  go: "Load the teeth",
  panel: [
    {
      title: "Load",
      table: "load",
      places: ["load"],
      keys: ["torque_Nm", "driver", "positions", "slices", "deflection_slope_um", "deflection_bow_um"],
    },
    {
      title: "Material",
      table: "material",
      places: ["gear1.material", "gear2.material"],
      keys: ["name", "youngs_modulus_MPa", "poisson_ratio"],
    },
    { title: "Bore", table: "bore", places: ["gear1.bore", "gear2.bore"], keys: ["diameter_mm"] },
  ],
  offered: [
    { table: "load", key: "torque_Nm", places: ["load.torque_Nm"], first: firstTorque },
    {
      table: "material",
      key: "name",
      places: ["gear1.material.name", "gear2.material.name"],
      instead: ["gear1.material.youngs_modulus_MPa", "gear2.material.youngs_modulus_MPa"],
      first: () => firstMaterial(""),
    },
  ],
};
const kToothColours = ["g1", "g2", "alpha", "root-fillet", "action", "flank"];
type Answer = Exclude<Loaded, { fault: Fault }>;
type Records = { [key: string]: Json }[];

export class LoadView extends AnswerView<Answer> {
  private readonly bar = h("progress", { max: 1, value: 0, "aria-label": "progress of the load" });
  private readonly state = h("span", { class: "soft" });
  private readonly torques = new Choice("torque shown", [], "", (torque) => {
    this.torque = Number(torque);
    this.draw();
  });
  private readonly plots = {
    te: new CurvePlot("loaded TE, ″", (i) => this.choose(i)),
    stiffness: new CurvePlot("N/(mm µm)", (i) => this.choose(i)),
    pointStiffness: new CurvePlot("N/µm", (i) => this.choose(i)),
    share: new CurvePlot("share", (i) => this.choose(i), kFromNothing),
    root: new CurvePlot("root stress, MPa", (i) => this.choose(i), kFromNothing),
  };
  private readonly maps = [new PressureMap(1), new PressureMap(2)];
  private readonly position = slider("position over the pitch", { min: 0, max: 1, step: 1 }, (i) =>
    this.choose(i),
  );
  private readonly where = h("output", { class: "soft" });
  /** What only teeth that touch along lines have; and only those that touch at points. */
  private readonly ofLines = [
    figure(this.plots.stiffness.element, h("b", {}, "Mesh stiffness"), ", secant."),
    h(
      "div",
      { class: "plots" },
      flankFigure(
        1,
        this.maps[0]!.canvas,
        ", pressure over the mesh; lines: where teeth bear now.",
      ),
      flankFigure(2, this.maps[1]!.canvas, ", the same."),
    ),
  ];
  private readonly ofPoints = figure(
    this.plots.pointStiffness.element,
    h("b", {}, "Stiffness"),
    " of the points of contact, secant.",
  );
  private full = false; // it is not a draft
  private torque = 0;
  private index = 0;
  private rest = 0;
  private wanted = ""; // accuracy and text of the answer that is under way

  constructor() {
    super("load", kNeeds);
    this.room.append(
      h("div", { class: "load-head" }, this.torques.element, this.bar, this.state),
      this.notices,
      h(
        "div",
        { class: "plots" },
        figure(this.plots.te.element, h("b", {}, "Loaded transmission error")),
        this.ofLines[0]!,
        this.ofPoints,
        figure(this.plots.share.element, h("b", {}, "Load shares"), ", a colour for each tooth pair."),
        figure(
          this.plots.root.element,
          h("b", {}, "Greatest root stress"),
          ": ",
          h("span", { class: "g1" }, "gear 1"),
          ", ",
          h("span", { class: "g2" }, "gear 2"),
          ".",
        ),
      ),
      slide("position", this.position, this.where),
      this.ofLines[1]!,
      this.table,
    );
    this.bar.hidden = true;
    new ResizeObserver(() => this.drawFlanks()).observe(this.maps[0]!.canvas);
    onThemeChange(() => {
      for (const plot of Object.values(this.plots)) plot.forget();
      this.draw();
    });
  }

  async refresh(): Promise<void> {
    clearTimeout(this.rest);
    const solved = this.pair();
    if (!solved) return;
    if (solved.text === this.shown) this.draw();
    else if (this.wanted === "full" + solved.text) this.wait();
    else await this.compute(solved.text, "draft");
    if (this.shown === solved.text && !this.full && this.answer)
      this.rest = window.setTimeout(() => void this.finish(solved.text).catch(() => undefined), kRestMs);
  }
  leave(): void {
    clearTimeout(this.rest);
  }
  /** The spec rests: the draft gives way. */
  private async finish(text: string): Promise<void> {
    if (bench.good?.text === text) await this.compute(text, "full");
  }
  /** The full answer, though the tab is not open; a draft that is on its way ends in one by itself. */
  async judge(): Promise<void> {
    const { text } = bench;
    if (!this.wanted.endsWith(text) && !(this.shown === text && this.full)) await this.finish(text);
  }
  private wait(): void {
    this.bar.hidden = false;
    if (!this.answer) fill(this.sentence, "The teeth are being loaded …");
  }

  private async compute(text: string, accuracy: "draft" | "full"): Promise<void> {
    const drafted = at(bench.good?.spec ?? null, "load.accuracy") === "draft";
    const wanted = accuracy + text;
    if (wanted === this.wanted) return;
    this.wanted = wanted;
    this.bar.value = 0;
    this.wait();
    const question = { text, accuracy: drafted ? ("draft" as const) : accuracy };
    const answer = await bench.press
      .latest("load", "load", question, (done, of) => (this.bar.value = of ? done / of : 0))
      .finally(() => {
        if (this.wanted !== wanted) return;
        this.wanted = "";
        this.bar.hidden = true;
      });
    if (!answer || bench.good?.text !== text) return;
    this.full = accuracy === "full" || drafted || "fault" in answer;
    if ("fault" in answer) return this.refuse(answer.fault, text);
    this.take(answer, text);
    if (this.full) judgement.take("load", text, answer);
    this.draw();
  }

  private get records(): Records {
    return (this.answer?.load["torques"] ?? []) as Records;
  }
  private choose(index: number): void {
    this.index = index;
    this.draw();
  }

  private draw(): void {
    const answer = this.answer;
    if (!answer) return;
    this.torque = Math.min(this.torque, this.records.length - 1);
    const record = this.records[this.torque]!;
    const picture = answer.picture.torques[this.torque]!;
    const positions = record["positions"] as Records;
    this.index = Math.min(this.index || Math.floor(positions.length / 2), positions.length - 1);
    this.position.max = String(positions.length - 1);
    this.position.value = String(this.index);
    this.show(answer, rowsOf(quantities("load.torques")!, [record], "load", "", true));
    this.state.textContent =
      `${this.full ? "" : "Draft. "}${positions.length} positions` +
      ` in ${(answer.milliseconds / 1000).toFixed(1)} s.`;
    this.torques.element.hidden = this.records.length < 2;
    this.torques.offer(
      this.records.map((one) => `${one["torque_Nm"]} N m`),
      String(this.torque),
    );
    this.drawCurves(positions, picture);
    this.drawFlanks();
  }

  private drawCurves(positions: Records, picture: LoadedTorque): void {
    const of = (key: string) => positions.map((one) => one[key] as number | null);
    const gear = (i: number) =>
      positions.map((one) => (one["root_stress_MPa"] as number[] | null)?.[i] ?? null);
    const x = of("rotation1_deg") as number[];
    const { te, share, root } = this.plots;
    const points = this.records[this.torque]!["contact_stiffness_N_per_um"] !== undefined;
    const stiffness = points ? this.plots.pointStiffness : this.plots.stiffness;
    for (const one of this.ofLines) one.hidden = points;
    this.ofPoints.hidden = !points;
    const record = this.records[this.torque]!;
    te.show(
      x,
      [{ values: of("transmission_error_arcsec"), colour: "flank" }],
      this.index,
      `loaded transmission error, peak to peak ${record["peak_to_peak_arcsec"]} arc seconds`,
    );
    stiffness.show(x, [{ values: picture.stiffness, colour: "flank" }], this.index, "mesh stiffness");
    share.show(
      x,
      picture.teeth.map((tooth, i) => ({
        values: tooth.share,
        colour: kToothColours[i % kToothColours.length]!,
      })),
      this.index,
      `shares of ${picture.teeth.length} tooth pairs`,
    );
    root.show(
      x,
      [0, 1].map((i) => ({ values: gear(i), colour: `g${i + 1}` })),
      this.index,
      "greatest root stress of both gears",
    );
    const now = positions[this.index]!;
    const pressure = now["max_pressure_MPa"] as number | null;
    this.where.textContent =
      `${x[this.index]!.toFixed(2)}°` + (pressure === null ? "" : `  ${pressure.toFixed(0)} MPa`);
  }

  private drawFlanks(): void {
    const { answer } = this;
    const torque = answer?.picture.torques[this.torque] ?? null;
    const most = (this.records[this.torque]?.["max_pressure_MPa"] as number | undefined) ?? 1;
    for (const map of this.maps) map.draw(torque, answer?.picture.height ?? new Float64Array(), this.index, most);
  }
}
