// The tab "load": teeth under torque. While the spec changes a draft follows; when it rests, the full
// answer takes its place. A spec without a torque is offered one. Every number is the engine's; the
// page draws.

import type { LoadedTorque } from "../../engine/engine";
import { quantities } from "../catalogue";
import { figure, fill, flankFigure, h, onThemeChange, scroller } from "../elements";
import { kOvertaken } from "../engine_link";
import type { Fault, Json, Loaded } from "../engine_worker";
import { firstMaterial, firstTorque, Offer } from "../form/offer";
import { KeyPanel } from "../form/panel";
import { judgement } from "../judgement";
import { CurvePlot } from "../plot";
import { quantityTable, rowsOf } from "../quantity_table";
import type { Tab } from "../tabs";
import { noticesOf } from "../verdict";
import { at, bench } from "../workbench";
import { PressureMap } from "./pressure_map";

/** A spec that has not changed for so long rests. */
const kRestMs = 1200;
const kOffered = "How the teeth share a load, yield and are stressed, for a torque:";
const kNoTorque = { key: "load.torque_Nm", value: "", message: "The spec has no torque." };
const kToothColours = ["g1", "g2", "alpha", "root-fillet", "action", "flank"];
type Answer = Exclude<Loaded, { fault: Fault }>;
type Records = { [key: string]: Json }[];

export class LoadView implements Tab {
  readonly id = "load";
  readonly words = "load";
  private readonly panel = new KeyPanel("load and materials", [
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
  ]);
  private readonly sentence = h("p", { class: "view-sentence", "aria-live": "polite" });
  private readonly bar = h("progress", { max: 1, value: 0, "aria-label": "progress of the load" });
  private readonly state = h("span", { class: "soft" });
  private readonly torques = h("div", { class: "choice", role: "group", "aria-label": "torque shown" });
  private readonly notices = h("ul", { class: "notices" });
  private readonly table = scroller("table-room", "numbers under load");
  private readonly plots = {
    te: new CurvePlot("loaded TE, ″", (i) => this.choose(i)),
    stiffness: new CurvePlot("N/(mm µm)", (i) => this.choose(i)),
    pointStiffness: new CurvePlot("N/µm", (i) => this.choose(i)),
    share: new CurvePlot("share", (i) => this.choose(i), true),
    root: new CurvePlot("root stress, MPa", (i) => this.choose(i), true),
  };
  private readonly maps = [new PressureMap(1), new PressureMap(2)];
  private readonly position = h("input", {
    type: "range",
    min: 0,
    step: 1,
    "aria-label": "position over the pitch",
    input: () => this.choose(Number(this.position.value)),
  });
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
  private readonly offer = new Offer(kOffered, "Load the teeth", [
    { table: "load", key: "torque_Nm", places: ["load.torque_Nm"], first: firstTorque },
    {
      table: "material",
      key: "name",
      places: ["gear1.material.name", "gear2.material.name"],
      instead: ["gear1.material.youngs_modulus_MPa", "gear2.material.youngs_modulus_MPa"],
      first: () => firstMaterial(""),
    },
  ]);
  private readonly room = h(
    "div",
    {},
    h("div", { class: "load-head" }, this.torques, this.bar, this.state),
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
    h("label", { class: "slide" }, h("span", {}, "position"), this.position, this.where),
    this.ofLines[1]!,
    this.table,
  );
  readonly picture = h("div", {}, this.sentence, this.room);
  readonly element = h(
    "div",
    { class: "side-view" },
    this.panel.element,
    scroller("side-room", "teeth under load", this.offer.element, this.picture),
  );
  readonly part = "load";
  private answer: Answer | null = null;
  shown = "";
  private full = false; // it is not a draft
  private torque = 0;
  private index = 0;
  private rest = 0;
  private asked = "";

  constructor() {
    this.bar.hidden = true;
    judgement.onChange(() => this.speak());
    new ResizeObserver(() => this.drawFlanks()).observe(this.maps[0]!.canvas);
    onThemeChange(() => {
      for (const plot of Object.values(this.plots)) plot.forget();
      this.draw();
    });
  }

  async refresh(): Promise<void> {
    clearTimeout(this.rest);
    const solved = bench.good;
    this.panel.show();
    this.offer.hide();
    if (!solved?.hasPair) {
      return this.clear(solved ? "One gear bears nothing: a second one makes a pair." : bench.nothing);
    }
    if (at(solved.spec, "load.torque_Nm") === undefined) {
      this.panel.show(null);
      this.offer.show();
      judgement.take("load", solved.text, { error: kNoTorque });
      return this.clear("");
    }
    if (solved.text === this.shown) this.draw();
    else if (this.asked === "full" + solved.text) this.wait();
    else await this.ask(solved.text, "draft");
    if (this.shown === solved.text && !this.full && this.answer)
      this.rest = window.setTimeout(() => void this.finish(solved.text).catch(() => undefined), kRestMs);
  }
  leave(): void {
    clearTimeout(this.rest);
  }
  /** The spec rests: the draft gives way. */
  private async finish(text: string): Promise<void> {
    if (bench.good?.text === text) await this.ask(text, "full");
  }
  /** The full answer, though nobody looks; a draft that is on its way ends in one by itself. */
  async judge(): Promise<void> {
    const { text } = bench;
    if (!this.asked.endsWith(text) && !(this.shown === text && this.full)) await this.finish(text);
  }
  private wait(): void {
    this.bar.hidden = false;
    if (!this.answer) fill(this.sentence, "The teeth are being loaded …");
  }

  private async ask(text: string, accuracy: "draft" | "full"): Promise<void> {
    const drafted = at(bench.good?.spec ?? null, "load.accuracy") === "draft";
    const asked = accuracy + text;
    if (asked === this.asked) return; // under way
    this.asked = asked;
    this.bar.value = 0;
    this.wait();
    const question = { text, accuracy: drafted ? ("draft" as const) : accuracy };
    const answer = await bench.press
      .latest("load", "load", question, (done, of) => (this.bar.value = of ? done / of : 0))
      .finally(() => {
        if (this.asked !== asked) return;
        this.asked = "";
        this.bar.hidden = true;
      });
    if (answer === kOvertaken || answer === null || bench.good?.text !== text) return;
    if ("fault" in answer) {
      judgement.take("load", text, { error: answer.fault });
      return this.clear(this.panel.show(answer.fault), text);
    }
    this.shown = text;
    this.full = accuracy === "full" || drafted;
    if (this.full) judgement.take("load", text, answer);
    this.panel.show(null);
    this.answer = answer;
    this.draw();
  }

  private clear(sentence: string, text = ""): void {
    this.answer = null;
    this.shown = text;
    this.full = true;
    this.room.hidden = true;
    fill(this.sentence, sentence);
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
    this.room.hidden = false;
    this.torque = Math.min(this.torque, this.records.length - 1);
    const record = this.records[this.torque]!;
    const picture = answer.picture.torques[this.torque]!;
    const positions = record["positions"] as Records;
    this.index = Math.min(this.index || Math.floor(positions.length / 2), positions.length - 1);
    this.position.max = String(positions.length - 1);
    this.position.value = String(this.index);
    this.speak();
    this.state.textContent =
      `${this.full ? "" : "Draft. "}${positions.length} positions` +
      ` in ${(answer.milliseconds / 1000).toFixed(1)} s.`;
    fill(this.notices, ...noticesOf(answer.warnings, answer.verdict.findings));
    this.drawTorques();
    this.drawCurves(positions, picture);
    this.drawFlanks();
    const rows = rowsOf(quantities("load.torques")!, [record], "load", "", true);
    fill(this.table, quantityTable(rows, ["gear 1", "gear 2"]).element);
  }

  /** The verdict on the spec, the same as in the bar. */
  private speak(): void {
    if (this.answer && this.shown === bench.text) fill(this.sentence, judgement.verdict?.headline);
  }

  private drawTorques(): void {
    this.torques.hidden = this.records.length < 2;
    fill(
      this.torques,
      ...this.records.map((record, i) =>
        h(
          "button",
          {
            type: "button",
            "aria-pressed": String(i === this.torque),
            click: () => {
              this.torque = i;
              this.draw();
            },
          },
          `${record["torque_Nm"]} N m`,
        ),
      ),
    );
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
