// Corrections of the flanks for the errors of the pair. The engine searches for them on request. A click replaces
// the design by the corrected spec.

import { quantity, unitOfSuffix } from "../catalogue";
import { h, tableOf } from "../elements";
import type { Json } from "../engine_worker";
import { shownUnit, textOf } from "../numbers";
import { Requested, type JsonRecord } from "../requested";
import { at } from "../workbench";

export class Corrections extends Requested {
  constructor() {
    super("compensate", "corrections", "Find corrections", "Searching for corrections …");
  }

  protected override read(answer: Json) {
    const found = at(answer, "compensate") as JsonRecord | undefined;
    if (!found) return { sentence: String(at(answer, "error.message") ?? "") };
    return { sentence: wordsOf(found), list: found["nothing_to_correct"] ? undefined : this.list(found) };
  }

  private list(found: JsonRecord): HTMLElement {
    const rows = (found["corrections"] as JsonRecord[]).map((one) =>
      h(
        "tr",
        { "data-correction": String(one["key"]) },
        h("th", {}, String(one["words"])),
        h("td", {}, `${Number(Number(one["value"]).toPrecision(6))} ${unitOfSuffix(String(one["unit"]))}`),
        h("td", {}, one["at_bound"] ? "at the end of the searched range" : ""),
      ),
    );
    const head = ["correction", "value", ""].map((words) => h("th", {}, words));
    const take = this.takeButton(found["spec"]!, "corrections", "take the corrections");
    return h("div", {}, tableOf("numbers", head, ...rows), take);
  }
}

/** Returns, for example, "transmission error, peak to peak: 3.2 → 0.4 ″.". */
function wordsOf(found: JsonRecord): string {
  if (found["nothing_to_correct"]) return "No correction reduces the transmission error.";
  const loads = found["under_load"] as JsonRecord[] | undefined;
  const key = loads?.length ? "peak_to_peak_arcsec" : "continuous_peak_to_peak_arcsec";
  const info = quantity(loads?.length ? "load.torques" : "contact", key);
  const scores = loads?.length ? loads[0]! : found;
  const [before, after] = ["before", "after"].map((when) => {
    const value = at(scores[when] ?? null, key);
    return info ? textOf(info, value) : String(value);
  });
  return `${info?.words ?? "transmission error"}: ${before} → ${after} ${info ? shownUnit(info) : "″"}.`;
}
