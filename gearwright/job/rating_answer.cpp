#include "gearwright/job/load_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
    const int rated = grades[static_cast<std::size_t>(which - 1)];
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

// Adds a warning with the safety factors under the spectrum. The verdict does not contain them,
// because it applies to one torque with K_A.
void warn_of_spectrum(SolvedJob& job, const RatingAnswer& answer) {
  const double flank = std::min(answer.spectrum->S_H[0], answer.spectrum->S_H[1]);
  const double root = std::min(answer.spectrum->S_F[0], answer.spectrum->S_F[1]);
  const bool holds = flank >= answer.wanted.flank && root >= answer.wanted.root;
  job.warnings.push_back(
      {holds ? WarningCode::spectrum_rated : WarningCode::spectrum_safety,
       fmt::format("Under the spectrum, with K_A = 1, the lowest safety factor is {:.2f} against "
                   "pitting and {:.2f} against root breakage; {:g} and {:g} are required. Values "
                   "outside the group Spectrum apply to {:g} N m with K_A = {:g}.",
                   flank, root, answer.wanted.flank, answer.wanted.root, answer.input.torque,
                   answer.input.application_factor),
       0});
}

// K_Hβ of a pair from the load along its teeth, for any torque. It is the greater value at both
// limits of the mesh misalignment f_ma.
//
// Formula   [T11.53]
class FaceLoads {
 public:
  static Result<FaceLoads> of(SolvedJob& job, const RatedPair& pair, Progress* progress);
  /// K_Hβ at the torque, the speed and the load factors of `input`. Its `face_load_factor` has no
  /// effect.
  Result<double> at(const RatedPair& pair, RatingInput input);

 private:
  FaceLoads(LoadTask task, bool default_slices)
      : task_(std::move(task)), default_slices_(default_slices) {}
  Result<std::vector<LoadedContact>> at_limits(double deviation);

  struct Resolution {
    std::array<int, 2> slices;
    PairCompliance compliance;
  };

  LoadTask task_;
  bool default_slices_;                  // true if the spec does not give the number of slices
  std::vector<Resolution> resolutions_;  // the first is the finest; each of the others is halved
};

Result<FaceLoads> FaceLoads::of(SolvedJob& job, const RatedPair& pair, Progress* progress) {
  GW_EXPECTS(pair.halves == 1);  // read_spec_tree() rejects "computed" for other gears
  LoadInput input = job.spec.load;
  const RatingInput& rating = job.spec.rating.input;
  input.torques = {rating.torque * rating.application_factor * rating.mesh_load_factor};
  input.rotations.clear();
  std::vector<Warning> notes;  // about the gear bodies; the verbs for loaded contact give the same
  auto task = load_task(job, errors_of(job), input, notes);
  if (!task) return task.error();
  for (Warning& note : notes) {
    const auto is_same = [&](const Warning& w) {
      return w.code == note.code && w.gear == note.gear;
    };
    // tooth_contact() adds its own notes.
    if (!job.spec.rating.tooth_contact &&
        std::none_of(job.warnings.begin(), job.warnings.end(), is_same))
      job.warnings.push_back(std::move(note));
  }
  FaceLoads made(std::move(task).take(), !input.slices);
  made.task_.request.root_stress = false;
  made.task_.request.progress = progress;
  auto compliance = made.task_.compliance();
  if (!compliance) return compliance.error();
  made.resolutions_.push_back({made.task_.request.slices, std::move(compliance).take()});
  made.task_.request.progress = nullptr;
  return made;
}

// The contact at both limits of the helix slope `deviation`, mm normal to the flank. At each
// torque, the default numbers of slices are halved until there is a solution, as in `load`.
Result<std::vector<LoadedContact>> FaceLoads::at_limits(double deviation) {
  for (std::size_t i = 0;; ++i) {
    task_.request.slices = resolutions_[i].slices;
    auto contacts = contacts_at_limits(task_, resolutions_[i].compliance, deviation);
    const bool too_fine =
        std::any_of(contacts.begin(), contacts.end(),
                    [](const LoadedContact& contact) { return contact.slices_too_fine; });
    if (!too_fine || !default_slices_) return contacts;
    if (i + 1 < resolutions_.size()) continue;
    if (!halve_slices(task_.request.slices)) return contacts;
    auto compliance = task_.compliance();
    if (!compliance) return compliance.error();
    resolutions_.push_back({task_.request.slices, std::move(compliance).take()});
  }
}

Result<double> FaceLoads::at(const RatedPair& pair, RatingInput input) {
  input.face_load_factor = 1.0;  // K_v does not depend on K_Hβ
  const auto rated = rate(pair, input);
  if (!rated) return rated.error();
  const double f_ma = input.misalignment ? *input.misalignment
                                         : std::hypot((*rated->tolerance)[0].f_Hbeta,
                                                      (*rated->tolerance)[1].f_Hbeta);
  const double torque = input.torque * rated->K_A.value * rated->K_gamma.value * rated->K_v.value;
  task_.request.torques = {from_newton_metres(torque)};
  double greatest = 1.0;
  const auto limits = at_limits(f_ma * std::cos(pair.beta_b) * kMmPerUm);
  if (!limits) return limits.error();
  for (const LoadedContact& limit : *limits) {
    std::vector<Warning> unused;  // warnings of `load`, which apply at the limits only
    if (auto error = judge_load(task_, limit, unused)) return *error;
    const auto scores = loaded_scores(limit);
    if (scores.empty())
      return Error{"rating.face_load_factor", "\"computed\"",
                   fmt::format("at {} N m and f_ma = {} µm, teeth do not touch or forces do not "
                               "converge at some positions; give a number, or stiffer shafts",
                               format_number(torque), format_number(f_ma)),
                   FailureKind::not_converged};
    greatest = std::max(greatest, *scores.front().face_load_factor);
  }
  return greatest;
}

// The greatest torque with the required safeties, N m, if K_Hβ changes with the torque. It solves
// torque_of_safety(K_Hβ(T)) = T by the secant method for ln T. None if there is no such torque, or
// if the load along the teeth cannot be computed at a torque of the iteration.
//
// Accuracy  1e-5, relative; the returned torque has the required safeties
std::optional<double> torque_with_face_loads(const RatedPair& pair, RatingInput input,
                                             const Safeties& wanted, FaceLoads& faces) {
  constexpr double kSameTorque = 2e-6;  // greatest relative distance to the torque of safety
  constexpr int kMostSteps = 12;
  double log_torque = std::log(input.torque);
  std::optional<std::array<double, 2>> before;  // ln T and its distance in the step before
  for (int step = 0; step < kMostSteps; ++step) {
    input.torque = std::exp(log_torque);
    const auto K_Hbeta = faces.at(pair, input);
    if (!K_Hbeta) return std::nullopt;
    input.face_load_factor = *K_Hbeta;
    const auto torque = torque_of_safety(pair, input, wanted);
    if (!torque) return std::nullopt;
    const double distance = std::log(*torque) - log_torque;
    if (distance >= 0.0 && distance <= kSameTorque) return input.torque;
    const double missing = distance - kSameTorque / 2;
    const double slope = before ? (distance - (*before)[1]) / (log_torque - (*before)[0]) : -1.0;
    before = {log_torque, distance};
    log_torque -= missing / (slope < 0.0 ? slope : -1.0);
  }
  return std::nullopt;
}

Result<ToothContact> tooth_contact(SolvedJob& job, const RatingAnswer& answer, Progress* progress) {
  const Rating& r = answer.rating;
  const double torque = answer.input.torque * r.K_A.value * r.K_gamma.value * r.K_v.value;
  const auto of = [torque](const LoadedTorque& t) {
    return ToothContact{torque, t.max_pressure, t.max_root_stress, t.face_load_factor};
  };
  if (job.halves[0]) {
    LoadInput input = job.spec.load;
    input.torques = {torque};
    input.probes.clear();
    const auto both = loaded_halves(job, job.halves, errors_of(job), input, job.warnings, progress);
    if (!both) return both.error();
    return of(both->contact->torques.front());
  }
  const auto made =
      contact_under(job, errors_of(job), job.spec.load, torque, job.warnings, progress);
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
    const auto i = static_cast<std::size_t>(which - 1);
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
    auto of_teeth = FaceLoads::of(job, answer.pair, progress);
    if (!of_teeth) return of_teeth.error();
    faces = std::move(of_teeth).take();
    const auto K_Hbeta = faces->at(answer.pair, answer.input);
    if (!K_Hbeta) return K_Hbeta.error();
    answer.input.face_load_factor = *K_Hbeta;
  }
  auto made = rate(answer.pair, answer.input);
  if (!made) return made.error();
  answer.rating = std::move(made).take();
  answer.wanted = {table.safety_flank_min.value_or(1.0), table.safety_root_min.value_or(1.0)};
  if (!table.spectrum.empty()) {
    std::vector<LoadBin> steps = table.spectrum;
    for (LoadBin& step : steps) {
      if (!faces) break;
      const auto K_Hbeta = faces->at(answer.pair, input_of(step, answer.input));
      if (!K_Hbeta) return K_Hbeta.error();
      step.face_load_factor = *K_Hbeta;
    }
    auto whole = rate_spectrum(answer.pair, answer.input, steps);
    if (!whole) return whole.error();
    answer.spectrum = *whole;
  }
  answer.torque_holding =
      faces ? torque_with_face_loads(answer.pair, answer.input, answer.wanted, *faces)
            : torque_of_safety(answer.pair, answer.input, answer.wanted);
  if (!faces)
    answer.face_holding = face_width_of_safety(answer.pair, answer.input, answer.wanted,
                                               kMostFaceModules * answer.pair.normal_module);
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
