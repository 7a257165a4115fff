// The tab "contact" shows transmission error, spectrum and flanks. They are updated immediately when the
// user moves a slider of an error or a modification. The contact pattern is computed in the background
// when the slider rests.

import type { ContactCurve, ContactView as FigureView, Figure, FlankRaster } from "../../engine/engine";
import { fill, h, scroller, sentenceOf, slide, slider } from "../elements";
import { Figures } from "../figure_slot";
import { judgement } from "../judgement";
import { Pause } from "../pauses";
import { quantityTable } from "../quantity_table";
import { markRevision } from "../revision";
import { bench, hasRack } from "../workbench";
import type { Tab } from "../tabs";
import { Corrections } from "./corrections";
import { ErrorMapView } from "./error_map_view";
import { ContactSliders } from "./sliders";

const kPositions = 64;
/** The pause after the last change before the numbers of the verb contact are computed. */
const kPauseMs = 700;
type Timed = ContactCurve & { milliseconds: number };

export class ContactView implements Tab {
  readonly id = "contact";
  private readonly sliders = new ContactSliders();
  private readonly sentence = h("p", { class: "view-sentence", "aria-live": "polite" });
  private readonly curves = new Figures(
    (t) => this.choose(Math.round((t + 0.5) * kPositions)),
    () => void this.drawFigures(true),
  );
  private readonly flanks = new Figures();
  private readonly errorMap = new ErrorMapView();
  private readonly corrections = new Corrections();
  private readonly instant = slider(
    "position within the pitch",
    { min: 0, max: kPositions - 1, step: 1, value: kPositions / 2 },
    (index) => this.choose(index),
  );
  private readonly where = h("output", { class: "soft" });
  private readonly time = h("span", { class: "soft time" });
  private readonly table = scroller("table-room", "numbers");
  readonly picture = h(
    "div",
    {},
    this.sentence,
    this.curves.element,
    slide("position", this.instant, this.where, this.time),
    this.flanks.element,
    this.table,
  );
  readonly element = h(
    "div",
    { class: "side-view narrow" },
    this.sliders.element,
    scroller("side-room", "curves and flanks", this.picture, this.corrections.element, this.errorMap.element),
  );
  readonly part = "contact";
  private curve: Timed | null = null;
  private patterns: FlankRaster[] | null = null;
  private index = kPositions / 2;
  shown = "";
  private marked = ""; // the text of the spec whose pattern is shown on the flanks
  private asked = ""; // the spec text for which `contact` has run last, or is running
  private readonly pause = new Pause(kPauseMs);

  leave(): void {
    this.pause.cancel();
  }
  inUnits(): void {
    this.shown = this.asked = "";
    this.errorMap.clear();
  }

  async refresh(): Promise<void> {
    this.pause.cancel();
    this.sliders.build();
    this.errorMap.build();
    this.sliders.show();
    const solved = bench.good;
    if (!solved?.hasPair) {
      return this.clear(solved ? "Tooth contact needs a second gear." : bench.nothing);
    }
    this.corrections.show(solved.text);
    if (solved.text === this.shown) return this.draw();
    const view = this.view(true);
    try {
      const answer = await bench.about(bench.front, "contact", "contact", { text: solved.text, view });
      if (!answer) return;
      this.curve = answer.curve;
      this.shown = solved.text;
      this.draw();
      this.showFigures(answer.figures, view);
    } catch (reason) {
      return this.clear(sentenceOf(reason));
    }
    fill(this.table);
    if (!(await bench.rested(solved))) return;
    await this.pattern(solved.text);
    this.pause.run(() => void this.judge());
  }

  private clear(sentence: string): void {
    this.curve = this.patterns = null;
    fill(this.table);
    this.shown = this.marked = "";
    this.curves.show([]);
    this.flanks.show([]);
    this.where.textContent = this.time.textContent = "";
    fill(this.sentence, sentence);
    this.empty(true);
  }
  /** Hides everything except the sentence if `yes` is true. Otherwise shows everything again. */
  private empty(yes: boolean): void {
    for (const one of this.picture.children) if (one !== this.sentence) (one as HTMLElement).hidden = yes;
    // The map and the corrections need two gears.
    this.errorMap.element.hidden = this.corrections.element.hidden = yes || hasRack(bench.good?.spec);
  }

  private choose(index: number): void {
    this.index = Math.min(kPositions - 1, Math.max(0, index));
    this.instant.value = String(this.index);
    this.draw();
    void this.drawFigures(false);
  }

  private view(curves: boolean): FigureView {
    const { index, patterns } = this;
    this.flanks.fit();
    return { width: this.curves.fit(), positions: kPositions, index, patterns, curves };
  }
  private async drawFigures(curves: boolean): Promise<void> {
    const { curve, shown } = this;
    if (!curve) return;
    const view = this.view(curves);
    const figures = await bench.front
      .latest(curves ? "figures" : "flanks", "contactFigures", { text: shown, view })
      .catch(() => null); // the pair has been replaced
    if (figures && this.curve === curve) this.showFigures(figures, view);
  }
  private showFigures(figures: Figure[], { curves, index }: FigureView): void {
    const ofFlanks = figures.filter((one) => one.id.startsWith("bearing"));
    if (curves) this.curves.show(figures.filter((one) => !ofFlanks.includes(one)));
    if (index === this.index || !curves) this.flanks.show(ofFlanks);
    markRevision(this.flanks.element, this.marked, this.shown);
  }

  private async pattern(text: string): Promise<void> {
    const pattern = await bench.back
      .latest("pattern-flat", "pattern", { text, positions: 32, rows: 25, columns: 49 })
      .catch(() => null); // the pattern does not exist
    if (!pattern || this.shown !== text) return;
    this.patterns = pattern;
    this.marked = text;
    await this.drawFigures(false);
  }

  /** Requests the numbers and the verdict of the verb contact. The curves do not contain them. */
  async judge(): Promise<void> {
    const { text } = bench;
    if (text === this.asked) return;
    this.asked = text;
    const answer = await bench.press.latest("contact", "answer", { text, verb: "contact" });
    if (!answer) {
      if (this.asked === text) this.asked = "";
      return;
    }
    judgement.take("contact", text, answer.result as Parameters<typeof judgement.take>[2]);
    if (answer.rows.length && bench.good?.text === text) fill(this.table, quantityTable(answer.rows, 2).element);
  }

  private draw(): void {
    const { curve, index } = this;
    if (!curve) return;
    this.empty(false);
    this.curves.mark(index / kPositions - 0.5);
    const x = curve.columns["rotation1_deg"] as Float64Array;
    const kinds = curve.columns["kind"] as string[];
    fill(this.sentence, curve.words);
    this.where.textContent = `${x[index]!.toFixed(2)}°  ${kinds[index]?.replaceAll("_", " ") || "no contact"}`;
    this.time.textContent = `${curve.n} positions in ${curve.milliseconds.toFixed(1)} ms.`;
    markRevision(this.flanks.element, this.marked, this.shown);
  }
}
