// The tab "rating" shows the strength to ISO 6336 or VDI 2736. The colour of each safety factor
// shows its level in the verdict. As in the report, every factor has its clause of the standard and
// the branch of the formula.

import type { Row } from "../../engine/engine";
import { AnswerView } from "../answer_view";
import { fill, h, symbol } from "../elements";
import type { Fault, Notice, Verdict } from "../engine_worker";
import { firstMaterial, firstSpeed, firstTorque } from "../form/offer";
import { judgement } from "../judgement";
import { at, bench } from "../workbench";

const kRating = ["rating"];
/** Each safety factor, and the code of the finding if the safety factor is too low. */
const kSafeties: [key: string, code: string][] = [
  ["S_F", "root_safety"],
  ["S_H", "flank_safety"],
];
const kNeeds = {
  keys: ["rating.torque_Nm", "rating.power_kW", "rating.spectrum"],
  without: "The spec has no load to rate.",
  alone: "A rating needs a second gear.",
  offer: "Strength of the teeth by ISO 6336. A rating needs:",
  go: "Rate the pair",
  panel: [
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
      title: "Manufacture",
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
      title: "Values that replace formulas",
      table: "rating",
      places: kRating,
      keys: ["dynamic_factor", "face_load_factor", "transverse_load_factor", "transverse_load_factor_root"],
    },
    {
      title: "Requirements",
      table: "rating",
      places: kRating,
      keys: ["safety_root_min", "safety_flank_min", "standard"],
    },
  ],
  offered: [
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
  ],
};
interface Rated {
  warnings: Notice[];
  verdict: Verdict;
}

export class RatingView extends AnswerView<Rated> {
  private readonly safeties = h("div", { class: "safeties" });

  constructor() {
    super("rating", kNeeds);
    this.room.append(this.safeties, this.notices, this.table);
  }

  async refresh(): Promise<void> {
    const solved = this.pair();
    if (!solved || solved.text === this.shown) return;
    // If the rating includes tooth contact under the rated load, the rating takes seconds. It then
    // runs in another worker, so that the next change of the spec does not have to wait.
    const link = at(solved.spec, "rating.tooth_contact") === true ? bench.press : bench.front;
    const answer = await link.latest("rate", "answer", { text: solved.text, verb: "rate" });
    if (!answer || bench.good?.text !== solved.text) return;
    const { result, rows } = answer;
    if (result["error"]) return this.refuse(result["error"] as unknown as Fault, solved.text);
    const rated = result as unknown as Rated;
    this.take(rated, solved.text);
    judgement.take("rating", solved.text, rated);
    this.draw(rated, rows);
  }
  judge(): Promise<void> {
    return this.refresh();
  }

  private draw(rated: Rated, rows: Row[]): void {
    fill(
      this.safeties,
      ...kSafeties.flatMap(([key, code]) => {
        const row = rows.find((one) => one.id === "rating." + key);
        return row ? [1, 2].map((gear) => this.safety(key, row, rated.verdict, code, gear)) : [];
      }),
    );
    this.show(rated, rows, { notes: "clause of the standard, branch" });
  }

  private safety(key: string, row: Row, verdict: Verdict, code: string, gear: number): HTMLElement {
    const short = verdict.findings.find((one) => one.code === code && one.gear === gear);
    return h(
      "div",
      { class: "safety", "data-level": short?.level ?? "green", "data-safety": `${key}.${gear}` },
      h("b", { class: "level" }, row.texts[gear - 1]),
      h("span", {}, symbol(row.symbol), " ", h("span", { class: `g${gear}` }, `gear ${gear}`)),
      h("span", { class: "soft" }, row.words),
    );
  }
}
