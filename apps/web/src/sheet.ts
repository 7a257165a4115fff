// The tab "sheet": the report, the same page that the program writes. It lives in a frame of its own
// without any right to this page.

import { h } from "./elements";
import { kOvertaken } from "./engine_link";
import { bench } from "./workbench";
import type { Tab } from "./tabs";

export class SheetView implements Tab {
  readonly id = "sheet";
  readonly words = "sheet";
  private readonly frame = h("iframe", { sandbox: "allow-scripts", title: "the report", class: "report" });
  private readonly state = h("p", { class: "soft sheet-state", role: "status" });
  readonly element = h("div", { class: "sheet-view" }, this.state, this.frame);
  private shown = "";
  private timer = 0;

  refresh(): void {
    if (!bench.good) {
      this.frame.srcdoc = this.shown = "";
      this.state.textContent = "There is no pair yet.";
      return;
    }
    if (bench.good.text === this.shown) return;
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.load(), this.shown ? 350 : 0); // a report is read, not played with
  }

  private async load(): Promise<void> {
    const text = bench.good!.text;
    this.state.textContent = this.shown ? "" : "Writing the report …";
    try {
      const bytes = await bench.back.latest("report", "file", { text, kind: "report", gear: 0 });
      if (bytes === kOvertaken) return;
      this.shown = text;
      this.frame.srcdoc = new TextDecoder().decode(bytes);
      this.state.textContent = "";
    } catch (reason) {
      this.state.textContent = reason instanceof Error ? reason.message : String(reason);
    }
  }
}
