// Base class of the tabs that show teeth under load or their rating. Next to the result, the tab
// shows the keys of the spec on which the result depends. Above the result, the tab shows the
// verdict that is also in the bar at the top of the page. If the spec has no load, the tab shows
// fields for a load.

import { fill, h, scroller } from "./elements";
import type { Row } from "../engine/engine";
import type { Fault, Notice, Solved, Verdict } from "./engine_worker";
import { Offer, type Offered } from "./form/offer";
import { KeyPanel, type PanelGroup } from "./form/panel";
import { judgement, type Part } from "./judgement";
import { quantityTable, type Extra } from "./quantity_table";
import type { Tab } from "./tabs";
import { noticesOf } from "./verdict";
import { at, bench, hasRack } from "./workbench";

interface Needs {
  panel: PanelGroup[];
  keys: string[]; // keys of a load; if the spec has none of them, it has no load
  without: string; // the message if the spec has no load
  alone: string; // the message if there is only one gear
  offer: string; // text above the offered fields
  go: string;
  offered: Offered[];
}

export abstract class AnswerView<A extends { warnings: Notice[]; verdict: Verdict }> implements Tab {
  readonly id: string;
  protected readonly panel: KeyPanel;
  private readonly offer: Offer;
  protected readonly sentence = h("p", { class: "view-sentence", "aria-live": "polite" });
  protected readonly notices = h("ul", { class: "notices" });
  protected readonly table = scroller("table-room", "numbers");
  protected readonly room = h("div");
  readonly picture = h("div", {}, this.sentence, this.room);
  readonly element: HTMLElement;
  protected answer: A | null = null;
  shown = "";

  constructor(
    readonly part: Part,
    private readonly needs: Needs,
  ) {
    this.id = part;
    this.panel = new KeyPanel(`keys of the ${part}`, needs.panel);
    this.offer = new Offer(needs.offer, needs.go, needs.offered);
    this.element = h(
      "div",
      { class: "side-view" },
      this.panel.element,
      scroller("side-room", part, this.offer.element, this.picture),
    );
    judgement.onChange(() => this.showVerdict());
  }

  abstract refresh(): Promise<void>;
  abstract judge(): Promise<void>;

  /** Returns the pair of the spec. If there is no pair, shows the reason and returns null. */
  protected pair(): Solved | null {
    const solved = bench.good;
    this.panel.show();
    this.offer.hide();
    if (!solved?.hasPair) {
      this.clear(solved ? this.needs.alone : bench.nothing);
      return null;
    }
    if (hasRack(solved.spec)) {
      this.clear("This analysis needs two gears, but gear 2 is a rack.");
      return null;
    }
    if (this.needs.keys.some((key) => at(solved.spec, key) !== undefined)) return solved;
    this.panel.show(null);
    this.offer.show();
    judgement.take(this.part, solved.text, { error: { message: this.needs.without } });
    this.clear("");
    return null;
  }

  /** Stores the result for a text and removes any error from the panel. */
  protected take(answer: A, text: string): void {
    this.panel.show(null);
    this.answer = answer;
    this.shown = text;
  }
  /** Shows an error of the engine, in the panel at the field that caused it. */
  protected refuse(fault: Fault, text: string): void {
    judgement.take(this.part, text, { error: fault });
    this.clear(this.panel.show(fault), text);
  }
  private clear(sentence: string, text = ""): void {
    this.answer = null;
    this.shown = text;
    this.room.hidden = true;
    fill(this.sentence, sentence);
  }

  /** Shows the verdict, the conditions of the result, and its numbers. */
  protected show(answer: A, rows: Row[], extra?: Extra): void {
    this.room.hidden = false;
    this.showVerdict();
    fill(this.notices, ...noticesOf(answer.warnings, answer.verdict.findings));
    fill(this.table, quantityTable(rows, 2, extra).element);
  }
  private showVerdict(): void {
    if (this.answer && this.shown === bench.text) fill(this.sentence, judgement.verdict?.headline);
  }
}
