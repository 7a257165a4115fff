// The tab "sheet" shows the same report that the program writes. The report is in a frame that has no access
// to this page.

import { h, sentenceOf } from "./elements";
import { bench } from "./workbench";
import type { Tab } from "./tabs";

const kPauseMs = 350; // pause before the report is updated

export class SheetView implements Tab {
  readonly id = "sheet";
  readonly ofDrives = true;
  private readonly frame = h("iframe", { sandbox: "allow-scripts", title: "the report", class: "report" });
  private readonly state = h("p", { class: "soft sheet-state", role: "status" });
  readonly element = h("div", { class: "sheet-view" }, this.state, this.frame);
  readonly picture = this.frame;
  shown = "";

  async refresh(): Promise<void> {
    if (!bench.good) {
      this.frame.srcdoc = this.shown = "";
      this.state.textContent = bench.nothing;
      return;
    }
    const { text } = bench.good;
    if (text === this.shown) return;
    if (this.shown) await new Promise((rested) => setTimeout(rested, kPauseMs));
    if (bench.good?.text === text) await this.load(text);
  }

  private async load(text: string): Promise<void> {
    this.state.textContent = this.shown ? "" : "Writing the report …";
    try {
      const bytes = await bench.back.latest("report", "file", { text, kind: "report", gear: 0 });
      if (!bytes || bench.good?.text !== text) return;
      this.shown = text;
      const loaded = new Promise((done) => this.frame.addEventListener("load", done, { once: true }));
      this.frame.srcdoc = new TextDecoder().decode(bytes);
      await loaded;
      this.state.textContent = "";
    } catch (reason) {
      this.state.textContent = sentenceOf(reason);
    }
  }
}
