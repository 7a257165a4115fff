// The tab "contact": errors and modifications as sliders; transmission error, spectrum and flanks
// follow while they move. The pattern is made in the background and comes a moment later.

import type { ContactCurve } from "../../engine/engine";
import { figure, fill, flankFigure, h, onThemeChange, scroller, sentenceOf, slide, slider } from "../elements";
import { judgement } from "../judgement";
import { CurvePlot } from "../plot";
import { markRevision } from "../revision";
import { at, bench } from "../workbench";
import type { Tab } from "../tabs";
import { isEdge, kAboutNothing, SpectrumPlot, transmissionCurves } from "./curves";
import { ErrorMapView } from "./error_map_view";
import { FlankMap } from "./flank_map";
import { ContactSliders } from "./sliders";

const kPositions = 64;
type Timed = ContactCurve & { milliseconds: number };

export class ContactView implements Tab {
  readonly id = "contact";
  private readonly sliders = new ContactSliders();
  private readonly sentence = h("p", { class: "view-sentence", "aria-live": "polite" });
  private readonly edges = h(
    "span",
    { hidden: true },
    h("span", { class: "edge-ink" }, "Here an edge touches"),
    ". ",
  );
  private readonly te = new CurvePlot("transmission error, ″", (i) => this.choose(i), kAboutNothing);
  private readonly spectrum = new SpectrumPlot();
  private readonly maps = [new FlankMap(0), new FlankMap(1)];
  private readonly errorMap = new ErrorMapView();
  private readonly instant = slider(
    "position over the pitch",
    { min: 0, max: kPositions - 1, step: 1, value: kPositions / 2 },
    (index) => this.choose(index),
  );
  private readonly where = h("output", { class: "soft" });
  private readonly time = h("span", { class: "soft time" });
  /** The marking comes later than the curves. */
  private readonly flanks = h(
    "div",
    { class: "plots" },
    flankFigure(
      1,
      this.maps[0]!.canvas,
      ", marking; darker: the gap now, in steps of 1, 2, 5, 10, 20, 50 µm.",
    ),
    flankFigure(2, this.maps[1]!.canvas, ", marking after a mesh."),
  );
  readonly picture = h(
    "div",
    {},
    this.sentence,
    h(
      "div",
      { class: "plots" },
      figure(
        this.te.element,
        h("b", {}, "Transmission error"),
        ", from its middle. ",
        this.edges,
        this.time,
      ),
      figure(this.spectrum.element, h("b", {}, "Its spectrum"), ": the first bar is the tooth frequency."),
    ),
    slide("position", this.instant, this.where),
    this.flanks,
  );
  readonly element = h(
    "div",
    { class: "side-view narrow" },
    this.sliders.element,
    scroller("side-room", "curves and flanks", this.picture, this.errorMap.element),
  );
  readonly part = "contact";
  private curve: Timed | null = null;
  private index = kPositions / 2;
  shown = "";
  private marked = ""; // the text whose marking is on the flanks

  constructor() {
    new ResizeObserver(() => this.drawFlanks()).observe(this.maps[0]!.canvas);
    onThemeChange(() => {
      this.te.forget();
      this.spectrum.forget();
      this.draw();
    });
  }

  async refresh(): Promise<void> {
    this.sliders.build();
    this.errorMap.build();
    this.sliders.show();
    const solved = bench.good;
    if (!solved?.hasPair) {
      return this.clear(solved ? "One gear touches nothing: a second one makes a pair." : bench.nothing);
    }
    if (solved.text === this.shown) return this.draw();
    const question = { text: solved.text, positions: kPositions };
    try {
      const answer = await bench.about(bench.front, "curve", "curve", question);
      if (!answer) return;
      this.curve = answer;
    } catch (reason) {
      return this.clear(sentenceOf(reason));
    }
    this.shown = solved.text;
    for (const map of this.maps) map.gap = null;
    this.draw();
    await Promise.all([this.gapNow(), this.pattern(solved.text)]);
  }

  private clear(sentence: string): void {
    this.curve = null;
    this.shown = this.marked = "";
    this.te.forget();
    this.spectrum.forget();
    for (const map of this.maps) map.gap = map.pattern = null;
    this.where.textContent = this.time.textContent = "";
    fill(this.sentence, sentence);
    this.empty(true);
  }
  /** Without a curve there is the sentence alone. */
  private empty(yes: boolean): void {
    for (const one of this.picture.children) if (one !== this.sentence) (one as HTMLElement).hidden = yes;
    this.errorMap.element.hidden = yes;
  }

  private choose(index: number): void {
    this.index = Math.min(kPositions - 1, Math.max(0, index));
    this.instant.value = String(this.index);
    this.draw();
    void this.gapNow();
  }

  private async gapNow(): Promise<void> {
    const { curve, index } = this;
    const rotation = (curve?.columns["rotation1_deg"] as Float64Array | undefined)?.[index];
    const tooth = (curve?.columns["tooth"] as Float64Array | undefined)?.[index];
    if (!curve || rotation === undefined || tooth === undefined || !Number.isFinite(tooth)) return;
    const gap = await bench.front
      .latest("gap", "gapMap", { text: this.shown, rotation, tooth, rows: 25, columns: 49 })
      .catch(() => undefined); // there is none
    if (gap === null || this.curve !== curve) return;
    this.maps[0]!.gap = gap ?? null;
    this.drawFlanks();
  }

  private async pattern(text: string): Promise<void> {
    const pattern = await bench.back
      .latest("pattern-flat", "pattern", { text, positions: 32, rows: 25, columns: 49 })
      .catch(() => []); // there is none
    if (!pattern || this.shown !== text) return;
    this.maps.forEach((map, i) => (map.pattern = pattern[i] ?? null));
    this.marked = text;
    this.drawFlanks();
  }

  /** The verdict on the contact, which the curves alone do not have. */
  async judge(): Promise<void> {
    const { text } = bench;
    const answer = await bench.press.latest("contact", "run", { text, verb: "contact" });
    if (answer) judgement.take("contact", text, answer as Parameters<typeof judgement.take>[2]);
  }

  private draw(): void {
    const curve = this.curve;
    if (!curve) return;
    this.empty(false);
    const x = curve.columns["rotation1_deg"] as Float64Array;
    const peaks = `peak to peak ${curve.peakToPeakArcsec.toFixed(3)} arc seconds`;
    this.te.show(x, transmissionCurves(curve), this.index, `transmission error over one pitch, ${peaks}`);
    this.spectrum.show(curve.harmonicsArcsec);
    const kinds = curve.columns["kind"] as string[];
    this.edges.hidden = !kinds.some(isEdge);
    fill(this.sentence, curve.words);
    this.where.textContent = `${x[this.index]!.toFixed(2)}°  ${kinds[this.index]?.replaceAll("_", " ") || "no contact"}`;
    this.time.textContent = `${curve.n} positions in ${curve.milliseconds.toFixed(1)} ms.`;
    this.drawFlanks();
  }
  private drawFlanks(): void {
    const marking = (at(bench.good?.spec ?? null, "contact.marking_mm") as number | undefined) ?? 0.00635;
    for (const map of this.maps) map.draw(this.curve, this.index, marking);
    markRevision(this.flanks, this.marked, this.shown);
  }
}
