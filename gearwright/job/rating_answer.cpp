#include "gearwright/job/load_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/arrange/face_loads.hpp"
#include "gearwright/arrange/loaded_pair.hpp"
#include "gearwright/base/contract.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/job/contact_answer.hpp"

namespace gearwright {

namespace {

bool lead_is_modified(const FlankModifications& m) {
  return m.lead_crowning != 0.0 || m.lead_slope != 0.0 || m.end_relief.amount > 0.0 || m.topography;
}

void warn_of_limits(SolvedJob& job, const Rating& rating) {
  for (const int which : {1, 2}) {
    if (!job.gear(which).spec.root_fillet) continue;
    job.warnings.push_back({WarningCode::rating_root_fillet,
                            "The standard does not cover a circular root fillet; Y_F and Y_S are "
                            "computed for the root that the rack would cut.",
                            which});
  }
  for (const int which : {1, 2}) {
    const auto& [right, left] = job.spec.gear(which).modifications;
    if (job.spec.rating.input.face_load_factor || job.spec.rating.input.face_load_computed ||
        !(lead_is_modified(right) || lead_is_modified(left)))
      continue;
    job.warnings.push_back(
        {WarningCode::rating_crowning,
         "K_Hβ is computed without the crowning, helix slope and end relief of this gear. With "
         "`rating.face_load_factor` = \"computed\" and the shafts of the gears, K_Hβ is computed "
         "from the load along the teeth, which depends on these modifications.",
         which});
  }
  for (const Warning& limit : rating.limits) job.warnings.push_back(limit);
  if (!rating.tolerance) return;
  const auto& grades = *job.spec.rating.input.quality;
  for (const int which : {1, 2}) {
    const auto& own = job.spec.gear(which).tolerance.quality;
    const int rated = grades[which - 1];
    if (!own || *own == rated) continue;
    const bool inherited = which == 2 && job.spec.gear(1).tolerance.quality == own;
    if (inherited && grades[0] == rated) continue;
    std::string key = gear_field(which, "tolerance.quality");
    if (!job.spec.given.contains(key)) key = gear_field(which, "quality");
    job.warnings.push_back({WarningCode::rating_quality,
                            fmt::format("The rating uses grade {} for gear {}, but the drawing "
                                        "uses {} = {}.",
                                        rated, which, key, *own),
                            which});
  }
}

// Adds a note with the safety factors under the spectrum, and with the load of the other results.
void warn_of_spectrum(SolvedJob& job, const RatingAnswer& answer) {
  const double flank = std::min(answer.spectrum->S_H[0], answer.spectrum->S_H[1]);
  const double root = std::min(answer.spectrum->S_F[0], answer.spectrum->S_F[1]);
  job.warnings.push_back(
      {WarningCode::spectrum_rated,
       fmt::format("Under the spectrum, with K_A = 1, the lowest safety factor is {:.2f} against "
                   "pitting and {:.2f} against root breakage; {:g} and {:g} are required. Values "
                   "outside the group Spectrum apply to {:g} N m with K_A = {:g}.",
                   flank, root, answer.wanted.flank, answer.wanted.root, answer.input.torque,
                   answer.input.application_factor),
       0});
}

// Returns the loads along the teeth, from which K_Hβ is computed. Adds notes about gear bodies that
// the job does not have yet.
Result<FaceLoads> face_loads_of(SolvedJob& job, Progress* progress) {
  std::vector<Warning> notes;
  auto faces =
      FaceLoads::of(job, errors_of(job), job.spec.load, job.spec.rating.input, notes, progress);
  for (Warning& note : notes) {
    const auto is_same = [&](const Warning& w) {
      return w.code == note.code && w.gear == note.gear;
    };
    // If [rating] has tooth_contact, tooth_contact() adds these notes.
    if (!job.spec.rating.tooth_contact &&
        std::none_of(job.warnings.begin(), job.warnings.end(), is_same))
      job.warnings.push_back(std::move(note));
  }
  return faces;
}

Result<ToothContact> tooth_contact(SolvedJob& job, const RatingAnswer& answer, Progress* progress) {
  const Rating& r = answer.rating;
  const double torque = answer.input.torque * r.K_A.value * r.K_gamma.value * r.K_v.value;
  const auto of = [torque](const LoadedTorque& t) {
    return ToothContact{torque, t.max_pressure, t.max_root_stress, t.face_load_factor};
  };
  LoadInput input = job.spec.load;
  input.rotations.clear();  // the results are the greatest values over a whole pitch
  if (job.halves[0]) {
    input.torques = {torque};
    input.probes.clear();
    const auto both = loaded_halves(job, job.halves, errors_of(job), input, job.warnings, progress);
    if (!both) return both.error();
    return of(both->contact->torques.front());
  }
  const auto made = contact_under(job, errors_of(job), input, torque, job.warnings, progress);
  if (!made) return made.error();
  return of(made->torques.front());
}

}  // namespace

Result<RatingAnswer> answer_rating(SolvedJob& job, Progress* progress) {
  if (auto missing = missing_error(SpecUse::rate, job.spec)) return *missing;
  const RatingTable& table = job.spec.rating;
  RatingAnswer answer;
  answer.input = table.input;
  auto rated = rated_pair(*job.pair);
  if (!rated) return rated.error();
  answer.pair = *rated;
  if (job.halves[0]) answer.pair.halves = 2;
  for (const int which : {1, 2}) {
    const std::size_t i = which - 1;
    auto material = material_of(job.spec.gears[i]->material, material_table(job.spec, which),
                                table.input.edition);
    if (!material) return material.error();
    answer.input.materials[i] = std::move(material).take();
  }
  if (table.web_thickness) {
    answer.input.body = rated_body(*rated, *table.web_thickness, *table.rim_thickness);
  }
  if (auto& shafts = answer.input.shafts)
    shafts->hand1 = job.gear(1).spec.helix_angle.rad() < 0.0 ? -1.0 : 1.0;
  std::optional<FaceLoads> faces;
  if (answer.input.face_load_computed) {
    GW_EXPECTS(answer.pair.halves == 1);  // read_spec_tree() rejects "computed" for other gears
    auto of_teeth = face_loads_of(job, progress);
    if (!of_teeth) return of_teeth.error();
    faces = std::move(of_teeth).take();
    begin_stage(progress, "computing K_Hβ from the load along the teeth", 0);
    const auto K_Hbeta = faces->at(answer.pair, answer.input);
    if (!K_Hbeta) return K_Hbeta.error();
    answer.input.face_load_factor = *K_Hbeta;
  }
  auto made = rate(answer.pair, answer.input);
  if (!made) return made.error();
  answer.rating = std::move(made).take();
  answer.wanted = {table.safety_flank_min.value_or(1.0), table.safety_root_min.value_or(1.0)};
  if (!table.spectrum.empty()) {
    answer.steps = table.spectrum;
    for (LoadBin& step : answer.steps) {
      if (!faces) break;
      const auto K_Hbeta = faces->at(answer.pair, input_of(step, answer.input));
      if (!K_Hbeta) return K_Hbeta.error();
      step.face_load_factor = *K_Hbeta;
    }
    auto whole = rate_spectrum(answer.pair, answer.input, answer.steps);
    if (!whole) return whole.error();
    answer.spectrum = *whole;
  }
  if (!faces) {
    answer.torque_holding =
        torque_of_safety(answer.pair, answer.input, answer.wanted, answer.steps);
    answer.face_holding =
        face_width_of_safety(answer.pair, answer.input, answer.wanted,
                             kMostFaceModules * answer.pair.normal_module, answer.steps);
  } else if (answer.steps.empty()) {
    answer.torque_holding =
        torque_with_face_loads(answer.pair, answer.input, answer.wanted, *faces);
  }
  if (answer.face_holding && job.halves[0])
    answer.face_holding = 2 * *answer.face_holding + job.halves[0]->given.gap;
  warn_of_limits(job, answer.rating);
  if (answer.spectrum) warn_of_spectrum(job, answer);
  if (table.tooth_contact) {
    auto contact = tooth_contact(job, answer, progress);
    if (!contact) return contact.error();
    answer.contact = *contact;
  }
  return answer;
}

}  // namespace gearwright
