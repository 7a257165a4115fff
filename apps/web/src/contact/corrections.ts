// Corrections of the flanks for the errors of the pair. The engine searches for them on request. A click replaces
// the design by the corrected spec.

import { quantity } from "../catalogue";
import { button, fill, h, scroller, sentenceOf, tableOf } from "../elements";
import type { Json } from "../engine_worker";
import { shownUnit, textOf } from "../numbers";
import { at, bench } from "../workbench";

type Record = { [key: string]: Json };

export class Corrections {
  private readonly go = button("Find corrections", () => void this.compute(), { class: "main" });
  private readonly state = h("span", { class: "soft", "aria-live": "polite" });
  private readonly table = scroller("table-room", "corrections");
  readonly element = h(
    "div",
    { class: "corrections" },
    h("div", { class: "load-head" }, this.go, this.state),
    this.table,
  );
  private of = ""; // text of the spec of the corrections that are shown or computed

  /** Removes the corrections of another spec. */
  show(text: string): void {
    if (this.of === text) return;
    this.of = "";
    this.go.disabled = false;
    fill(this.state);
    fill(this.table);
  }

  private async compute(): Promise<void> {
    const text = bench.good?.text;
    if (!text) return;
    this.of = text;
    this.go.disabled = true;
    this.state.textContent = "Searching for corrections …";
    try {
      const answer = await bench.press.call("run", { text, verb: "compensate" });
      if (this.of !== text) return;
      const found = at(answer, "compensate") as Record | undefined;
      this.state.textContent = found ? wordsOf(found) : String(at(answer, "error.message") ?? "");
      if (found && !found["nothing_to_correct"]) fill(this.table, this.list(found));
    } catch (reason) {
      if (this.of === text) this.state.textContent = sentenceOf(reason);
    }
  }

  private list(found: Record): HTMLElement {
    const take = button("Take", () => void this.take(found["spec"]!), {
      class: "main",
      "aria-label": "take the corrections",
    });
    const rows = (found["corrections"] as Record[]).map((one) =>
      h(
        "tr",
        { "data-correction": String(one["key"]) },
        h("th", {}, String(one["key"])),
        h("td", {}, `${Number(Number(one["value"]).toPrecision(6))} ${one["unit"]}`),
        h("td", {}, one["at_bound"] ? "at the end of the searched range" : ""),
      ),
    );
    const head = ["correction", "value", ""].map((words) => h("th", {}, words));
    return h("div", {}, tableOf("numbers", head, ...rows), take);
  }

  private async take(spec: Json): Promise<void> {
    const text = await bench.front.call("tomlOf", { json: JSON.stringify(spec) });
    bench.setText(text, "corrections");
  }
}

/** "Transmission error, peak to peak 3.2 → 0.4 ″." */
function wordsOf(found: Record): string {
  if (found["nothing_to_correct"]) return "No correction reduces the transmission error.";
  const loads = found["under_load"] as Record[] | undefined;
  const key = loads?.length ? "peak_to_peak_arcsec" : "continuous_peak_to_peak_arcsec";
  const info = quantity(loads?.length ? "load.torques" : "contact", key);
  const scores = loads?.length ? loads[0]! : found;
  const [before, after] = ["before", "after"].map((when) => {
    const value = at(scores[when] ?? null, key);
    return info ? textOf(info, value) : String(value);
  });
  return `${info?.words ?? "transmission error"}: ${before} → ${after} ${info ? shownUnit(info) : "″"}.`;
}
