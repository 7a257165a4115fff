// The tab "load" shows teeth under torque. While the user changes the spec, the tab shows a draft.
// After a pause, the full result replaces the draft. If the spec has no torque, the tab shows
// fields for a torque. The engine computes all numbers and draws all figures.

import { AnswerView } from "../answer_view";
import { Choice, fill, h, slide, slider } from "../elements";
import { Figures } from "../figure_slot";
import type { Fault, Json, Loaded } from "../engine_worker";
import { firstMaterial, firstTorque } from "../form/offer";
import { judgement } from "../judgement";
import { Pause } from "../pauses";
import { at, bench } from "../workbench";
import { Proposals } from "./proposals";

/** The pause after the last change before the full result is computed. */
const kPauseMs = 1200;
const kNeeds = {
  keys: ["load.torque_Nm"],
  without: "The spec has no torque.",
  alone: "An analysis under load needs a second gear.",
  offer: "Load sharing, deflection and stress of the teeth. An analysis under load needs:",
  go: "Apply this load",
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
type Answer = Exclude<Loaded, { fault: Fault }>;
type Records = { [key: string]: Json }[];

export class LoadView extends AnswerView<Answer> {
  private readonly bar = h("progress", { max: 1, value: 0, "aria-label": "progress of the analysis under load" });
  private readonly state = h("span", { class: "soft" });
  private readonly torques = new Choice("torque shown", [], "", (torque) => {
    this.torque = Number(torque);
    this.draw();
    void this.drawFigures();
  });
  private readonly figures = new Figures(
    (t) => this.choose(Math.round((t + 0.5) * this.positions.length)),
    () => void this.drawFigures(),
  );
  private readonly position = slider("position within the pitch", { min: 0, max: 1, step: 1 }, (i) =>
    this.choose(i),
  );
  private readonly proposals = new Proposals();
  private readonly where = h("output", { class: "soft" });
  private full = false; // false if the result is a draft
  private torque = 0;
  private index = -1;
  private readonly pause = new Pause(kPauseMs);
  private wanted = ""; // accuracy and text of the current request

  constructor() {
    super("load", kNeeds);
    this.room.append(
      h("div", { class: "load-head" }, this.torques.element, this.bar, this.state),
      this.notices,
      slide("position", this.position, this.where),
      this.figures.element,
      this.table,
      this.proposals.element,
    );
    this.bar.hidden = true;
  }

  async refresh(): Promise<void> {
    this.pause.cancel();
    const solved = this.pair();
    if (!solved) return;
    this.proposals.show(solved.text);
    if (solved.text === this.shown) this.draw();
    else if (this.wanted === "full" + solved.text) this.wait();
    else await this.compute(solved.text, "draft");
    if (this.shown === solved.text && !this.full && this.answer)
      this.pause.run(() => void this.finish(solved.text).catch(() => undefined));
  }
  inUnits(): void {
    const { answer } = this;
    if (!answer) return;
    void this.drawFigures();
    void bench.press.latest("load-rows", "loadRows", undefined as never).then((rows) => {
      if (!rows || this.answer !== answer) return;
      answer.rows = rows;
      this.draw();
    });
  }
  leave(): void {
    this.pause.cancel();
  }
  /** Replaces the draft by the full result after a pause in the changes of the spec. */
  private async finish(text: string): Promise<void> {
    if (bench.good?.text === text) await this.compute(text, "full");
  }
  /** Computes the full result even if the tab is not open. If a draft is in progress, the full result follows it. */
  async judge(): Promise<void> {
    const { text } = bench;
    if (!this.wanted.endsWith(text) && !(this.shown === text && this.full)) await this.finish(text);
  }
  private wait(): void {
    this.bar.hidden = false;
    if (!this.answer) fill(this.sentence, "Computing the teeth under load …");
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
    await this.drawFigures();
  }

  private get records(): Records {
    return (this.answer?.load["torques"] ?? []) as Records;
  }
  private get positions(): Records {
    return (this.records[this.torque]?.["positions"] ?? []) as Records;
  }
  private choose(index: number): void {
    this.index = Math.min(this.positions.length - 1, Math.max(0, index));
    this.draw();
  }

  private draw(): void {
    const answer = this.answer;
    if (!answer) return;
    this.torque = Math.min(this.torque, this.records.length - 1);
    const { positions } = this;
    const n = positions.length;
    this.index = Math.min(this.index < 0 ? Math.floor(n / 2) : this.index, n - 1);
    this.position.max = String(n - 1);
    this.position.value = String(this.index);
    this.show(answer, answer.rows[this.torque]!);
    this.state.textContent =
      `${this.full ? "" : "Draft. "}${n} positions` + ` in ${(answer.milliseconds / 1000).toFixed(1)} s.`;
    this.torques.element.hidden = this.records.length < 2;
    this.torques.offer(
      this.records.map((one) => `${one["torque_Nm"]} N m`),
      String(this.torque),
    );
    this.figures.mark(this.index / n - 0.5);
    const now = positions[this.index]!;
    const pressure = now["max_pressure_MPa"] as number | null;
    this.where.textContent =
      `${(now["rotation1_deg"] as number).toFixed(2)}°` + (pressure === null ? "" : `  ${pressure.toFixed(0)} MPa`);
  }

  private async drawFigures(): Promise<void> {
    const { answer, torque } = this;
    if (!answer) return;
    const figures = await bench.press
      .latest("load-figures", "loadFigures", { torque, width: this.figures.fit() })
      .catch(() => null); // the result has been replaced
    if (!figures || this.answer !== answer || this.torque !== torque) return;
    this.figures.show(figures);
  }
}
