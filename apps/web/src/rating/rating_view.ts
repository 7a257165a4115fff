// The tab "rating": strength by ISO 6336. The safeties in the verdict's colours, and every factor
// with its clause and the branch that was taken, as the report prints them. A spec without a load is
// offered what a rating needs.

import type { Quantity } from "../../engine/engine";
import { quantities, quantity } from "../catalogue";
import { fill, h, scroller, symbol } from "../elements";
import { kOvertaken } from "../engine_link";
import type { Fault, Json, Notice, Verdict } from "../engine_worker";
import { firstMaterial, firstSpeed, firstTorque, Offer } from "../form/offer";
import { KeyPanel } from "../form/panel";
import { judgement } from "../judgement";
import { onUnitChange, textOf } from "../numbers";
import { quantityTable, rowsOf, type Row } from "../quantity_table";
import type { Tab } from "../tabs";
import { noticesOf } from "../verdict";
import { at, bench } from "../workbench";

const kRating = ["rating"];
const kNoLoad = { key: "rating", value: "", message: "The spec has no load to rate." };
/** Safeties, and the finding that the verdict has where one falls short. */
const kSafeties: [key: string, code: string][] = [
  ["S_F", "root_safety"],
  ["S_H", "flank_safety"],
];
interface Rated {
  rating: { [key: string]: Json };
  warnings: Notice[];
  verdict: Verdict;
}
interface Source {
  formula: string;
  branch: string | string[];
}

export class RatingView implements Tab {
  readonly id = "rating";
  readonly words = "rating";
  private readonly panel = new KeyPanel("load and materials of the rating", [
    {
      title: "Load",
      table: "rating",
      places: kRating,
      keys: ["power_kW", "torque_Nm", "speed_rpm", "application_factor", "life_h", "mesh_load_factor", "reversed"],
    },
    {
      title: "Material",
      table: "material",
      places: ["gear1.material", "gear2.material"],
      keys: ["name", "surface_hardness_HV", "sigma_Hlim_MPa", "sigma_Flim_MPa"],
    },
    {
      title: "Making",
      table: "rating",
      places: kRating,
      keys: ["quality", "flank_roughness_um", "root_roughness_um", "lubricant_viscosity_40C_mm2_s"],
    },
    {
      title: "Mounting",
      table: "rating_mounting",
      places: ["rating.mounting"],
      keys: ["bearing_span_mm", "pinion_offset_mm", "shaft_diameter_mm", "arrangement"],
    },
    {
      title: "Instead of formulas",
      table: "rating",
      places: kRating,
      keys: ["dynamic_factor", "face_load_factor", "transverse_load_factor", "transverse_load_factor_root"],
    },
    {
      title: "Wanted",
      table: "rating",
      places: kRating,
      keys: ["safety_root_min", "safety_flank_min", "standard"],
    },
  ]);
  private readonly offer = new Offer("Whether the teeth hold, by ISO 6336. A rating needs:", "Rate the pair", [
    { table: "rating", key: "torque_Nm", places: ["rating.torque_Nm"], first: firstTorque },
    {
      table: "rating",
      key: "speed_rpm",
      places: ["rating.speed_rpm"],
      instead: ["rating.dynamic_factor"],
      first: firstSpeed,
    },
    {
      table: "material",
      key: "name",
      places: ["gear1.material.name", "gear2.material.name"],
      instead: ["gear1.material.sigma_Hlim_MPa", "gear2.material.sigma_Hlim_MPa"],
      first: () => firstMaterial("16MnCr5"),
    },
    {
      table: "rating",
      key: "quality",
      places: ["rating.quality"],
      instead: ["gear1.quality", "gear1.tolerance.quality"],
      first: () => 6,
    },
    {
      table: "rating",
      key: "face_load_factor",
      places: ["rating.face_load_factor"],
      instead: ["rating.mounting"],
      first: () => 1.2,
    },
  ]);
  private readonly sentence = h("p", { class: "view-sentence", "aria-live": "polite" });
  private readonly safeties = h("div", { class: "safeties" });
  private readonly notices = h("ul", { class: "notices" });
  private readonly table = scroller("table-room", "factors");
  readonly picture = h("div", {}, this.sentence, this.safeties, this.notices, this.table);
  readonly element = h(
    "div",
    { class: "side-view" },
    this.panel.element,
    scroller("side-room", "strength", this.offer.element, this.picture),
  );
  readonly part = "rating";
  shown = "";

  private rated = false;

  constructor() {
    judgement.onChange(() => this.speak());
    onUnitChange(() => (this.shown = ""));
  }

  async refresh(): Promise<void> {
    const solved = bench.good;
    this.panel.show();
    this.offer.hide();
    if (!solved?.hasPair) {
      return this.clear(solved ? "A rating is of a pair: a second gear makes one." : bench.nothing);
    }
    const load = ["torque_Nm", "power_kW", "spectrum"];
    if (load.every((key) => at(solved.spec, "rating." + key) === undefined)) {
      this.panel.show(null);
      this.offer.show();
      judgement.take("rating", solved.text, { error: kNoLoad });
      return this.clear("");
    }
    if (solved.text === this.shown) return;
    // Teeth in contact under the rated load take seconds: not where the next change of a key waits.
    const link = at(solved.spec, "rating.tooth_contact") === true ? bench.press : bench.front;
    const answer = await link.latest("rate", "run", { text: solved.text, verb: "rate" });
    if (answer === kOvertaken || bench.good?.text !== solved.text) return;
    this.shown = solved.text;
    judgement.take("rating", solved.text, answer as unknown as Partial<Rated>);
    const fault = answer["error"] as unknown as Fault | undefined;
    const sentence = this.panel.show(fault ?? null);
    if (fault) return this.clear(sentence, solved.text);
    this.show(answer as unknown as Rated);
  }
  judge(): Promise<void> {
    return this.refresh();
  }

  /** The verdict on the spec, the same as in the bar. */
  private speak(): void {
    if (this.rated && this.shown === bench.text) fill(this.sentence, judgement.verdict?.headline);
  }

  private clear(sentence: string, text = ""): void {
    this.rated = false;
    this.shown = text;
    fill(this.sentence, sentence);
    for (const one of [this.safeties, this.notices, this.table]) fill(one);
  }

  private show({ rating, warnings, verdict }: Rated): void {
    this.rated = true;
    this.speak();
    fill(
      this.safeties,
      ...kSafeties.flatMap(([key, code]) => {
        const said = quantity("rating", key);
        return said ? [1, 2].map((gear) => this.safety(said, rating, verdict, code, gear)) : [];
      }),
    );
    fill(this.notices, ...noticesOf(warnings, verdict.findings));
    const sources = rating["formulas"] as unknown as { [key: string]: Source };
    fill(
      this.table,
      quantityTable(rowsOf(quantities("rating")!, [rating], "rating"), ["gear 1", "gear 2"], {
        last: { head: "place in the standard, branch", of: (row: Row) => placeOf(sources[row.said.key]) },
      }).element,
    );
  }

  private safety(
    said: Quantity,
    rating: { [key: string]: Json },
    verdict: Verdict,
    code: string,
    gear: number,
  ): HTMLElement {
    const short = verdict.findings.find((one) => one.code === code && one.gear === gear);
    return h(
      "div",
      { class: "safety", "data-level": short?.level ?? "green", "data-safety": `${said.key}.${gear}` },
      h("b", { class: "level" }, textOf(said, (rating[said.key] as Json[])[gear - 1])),
      h("span", {}, symbol(said.symbol), " ", h("span", { class: `g${gear}` }, `gear ${gear}`)),
      h("span", { class: "soft" }, said.words),
    );
  }
}

/** "ISO 6336-1, 6.5.4, (13): subcritical", as the report has it. */
function placeOf(source: Source | undefined): string {
  if (!source) return "";
  const branch = [source.branch].flat().filter(Boolean).join("; ");
  return [source.formula, branch].filter(Boolean).join(": ");
}
