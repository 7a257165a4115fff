// Proposed flank modifications with their effects under load. A click replaces the design by the spec of a
// proposal. The engine computes the proposals on request, because they take several times as long as one load.

import { quantity } from "../catalogue";
import { h, tableOf } from "../elements";
import type { Json } from "../engine_worker";
import { shownUnit, textOf } from "../numbers";
import { Requested, type JsonRecord } from "../requested";
import { at } from "../workbench";

/** The values that are compared, by their keys in the catalogue. All of them except the value without load are
 *  scores under load. */
const kWithoutLoad = "peak_to_peak_without_load_arcsec";
const kValues = ["peak_to_peak_arcsec", kWithoutLoad, "max_pressure_MPa", "face_load_factor", "edge_carries"];

export class Proposals extends Requested {
  constructor() {
    super("propose", "proposals", "Propose modifications", "Computing the proposals …");
  }

  protected override read(answer: Json) {
    const proposals = (at(answer, "propose.proposals") ?? []) as JsonRecord[];
    const reason = at(answer, "propose.reason") ?? at(answer, "error.message");
    const best = Number(at(answer, "propose.recommended"));
    return { sentence: String(reason ?? ""), list: proposals.length ? this.list(proposals, best) : undefined };
  }

  private list(proposals: JsonRecord[], best: number): HTMLTableElement {
    const info = (key: string) => quantity(key === kWithoutLoad ? "propose.proposals" : "load.torques", key)!;
    const heads = kValues.map((key) => h("th", {}, info(key).words, " ", shownUnit(info(key))));
    return tableOf(
      "numbers",
      [h("th", {}, ""), h("th", {}, "modifications"), ...heads, h("th", {}, "")],
      ...proposals.map((proposal, i) => {
        const same = sameAs(proposals, i);
        if (same[0] !== i) return null;
        const values: JsonRecord = { ...(proposal["worst"] as JsonRecord), [kWithoutLoad]: proposal[kWithoutLoad]! };
        const take = this.takeButton(proposal["spec"]!, `proposal ${i + 1}`, `take proposal ${i + 1}`);
        return h(
          "tr",
          { class: i + 1 === best ? "taken" : null, "data-proposal": i + 1 },
          h("th", {}, String(i + 1)),
          h("td", {}, wordsOf(proposal), alsoOf(proposals, same), i + 1 === best && h("strong", {}, " recommended")),
          ...kValues.map((key) => h("td", { "data-score": key }, textOf(info(key), values[key]))),
          h("td", {}, i > 0 && take),
        );
      }),
    );
  }
}

/** Returns the text of a value with the keys of all records in alphabetical order. */
function sortedText(value: Json): string {
  if (Array.isArray(value)) return `[${value.map(sortedText).join()}]`;
  if (value === null || typeof value !== "object") return JSON.stringify(value);
  const keys = Object.keys(value).sort();
  return `{${keys.map((key) => `${key}:${sortedText((value as JsonRecord)[key]!)}`).join()}}`;
}
/** Returns the indices of the proposals with the same spec as proposal `i`. The order of keys is ignored. */
function sameAs(proposals: JsonRecord[], i: number): number[] {
  const specs = proposals.map((one) => sortedText(one["spec"]!));
  return proposals.map((_, k) => k).filter((k) => specs[k] === specs[i]);
}
/** Returns, for example, ". Also 3, 4: long tip relief; helix crowning". */
function alsoOf(proposals: JsonRecord[], same: number[]): string {
  const others = same.slice(1);
  if (!others.length) return "";
  const words = others.map((k) => proposals[k]!["words"]).join("; ");
  return `. Also ${others.map((k) => k + 1).join(", ")}: ${words}`;
}
/** Returns, for example, "long tip relief, helix crowning. Gear 1: tip relief 12 µm from 79.123 mm. Gear 2:
 *  tip relief 11 µm from …". */
function wordsOf(proposal: JsonRecord): string {
  const amounts = (proposal["gears"] as JsonRecord[]).map((gear, i) => gear["amounts"] && `Gear ${i + 1}: ${gear["amounts"]}`);
  return [proposal["words"], ...amounts].filter(Boolean).join(". ");
}
