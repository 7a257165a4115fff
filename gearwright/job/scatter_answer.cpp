#include "gearwright/job/scatter_answer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "gearwright/arrange/notes.hpp"
#include "gearwright/arrange/slice_resolutions.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/job/corrected_spec.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/scatter/tolerance.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace {

// Greatest number of samples for patterns, summed over all replicates.
constexpr int kPatternSamples = 256;
// Number of positions per pitch for loaded teeth, if [load] does not give this number.
constexpr int kLoadedPositions = 16;
// Greatest number of positions per pitch for patterns. A parabola interpolates the gap between
// positions.
constexpr int kDensityPositions = 16;

bool is_given(const std::vector<ScatterTolerance>& all, const std::string& name) {
  return std::any_of(all.begin(), all.end(),
                     [&](const ScatterTolerance& t) { return t.name == name; });
}

// Adds the tolerances of an accuracy grade, except those that the spec gives individually.
class Grades {
 public:
  Grades(const SolvedJob& job, std::vector<ScatterTolerance>& all) : job_(job), all_(all) {}

  std::optional<Error> add() {
    const ScatterInput& input = job_.spec.scatter;
    for (const int which : {1, 2}) {
      const std::size_t i = which - 1;
      const ToleranceInput& own = job_.completed.gear(which).tolerance;
      const std::optional<int> quality =
          input.quality ? std::optional((*input.quality)[i]) : own.quality;
      if (!quality) {
        if (auto error = needs_grade(which)) return error;
        continue;
      }
      const std::string field =
          input.quality ? "scatter.quality" : gear_field(which, "tolerance.quality");
      if (!has_class(own.edition, *quality))
        return Error{field, std::to_string(*quality), kClassesOfEditions};
      const auto flank = graded_flank(job_.pair->gear(which), own.edition, *quality);
      if (!flank)
        return Error{field, std::to_string(*quality),
                     "is allowed only for involute teeth with a usable flank; give the ranges in "
                     "[scatter.errors]",
                     FailureKind::no_flank};
      source_ = field;
      add_flank(which, *flank);
      if (flank->helix_total > helix_total_) worse_ = field;
      helix_total_ = std::max(helix_total_, flank->helix_total);
    }
    source_ = worse_;
    if (helix_total_ > 0.0) add_axes();
    return std::nullopt;
  }

 private:
  // Returns an error if the spec gives a key that requires a grade. The function is called only for
  // gears without a grade.
  std::optional<Error> needs_grade(int which) const {
    const ScatterGear& gear = job_.spec.scatter.gears[which - 1];
    const char* const key = gear.pitch           ? "pitch"
                            : gear.profile_waves ? "profile_waves"
                            : gear.helix_waves   ? "helix_waves"
                                                 : nullptr;
    if (!key) return std::nullopt;
    return Error{"scatter." + gear_field(which) + "." + key, "",
                 "needs a grade, for example quality = 6 in [scatter]"};
  }

  template <class Of>
  void add(const std::string& name, double unit, double half, const Of& of) {
    if (!is_given(all_, name))
      all_.push_back(
          {name, unit, Distribution::of({{-half / unit, half / unit}}).value(), of, source_});
  }
  void add_error(VaryingError error, double half) {
    const ErrorEntry& e = error_entries()[static_cast<std::size_t>(error)];
    add("errors." + std::string(e.key), e.si(), half, error);
  }

  void add_flank(int which, const GradedFlank& f) {
    const ScatterGear& gear = job_.spec.scatter.gears[which - 1];
    const std::string table = gear_field(which) + ".";
    add_error(which == 1 ? VaryingError::helix_slope1 : VaryingError::helix_slope2, f.helix_slope);
    add(table + "modifications.profile_slope_um", kMmPerUm, f.profile_slope,
        VaryingModification{which, Modification::profile_slope});
    constexpr std::array<int, 2> kWaves{1, 4};
    const Distribution share = Distribution::of({{0.0, 1.0}}).value();
    const auto add_waves = [&](const char* key, const VaryingWave& wave) {
      if (wave.waves[1] > 0) all_.push_back({table + key, 1.0, share, wave, source_});
    };
    add_waves("profile_waves", {which, false, gear.profile_waves.value_or(kWaves), f.profile_form});
    add_waves("helix_waves", {which, true, gear.helix_waves.value_or(kWaves), f.helix_form});
    // Pitch deviations affect only the transmission error over the long period. This error is
    // computed only for pairs that are not double-helical.
    if (!job_.halves[0])
      all_.push_back({table + "pitch", 1.0, share,
                      VaryingPitch{which, f.total_pitch, f.single_pitch}, source_});
  }

  void add_axes() {
    if (job_.spec.scatter.bearings || job_.pair->crossed()) return;
    const double face =
        std::min(job_.pair->gear(1).spec.face_width, job_.pair->gear(2).spec.face_width);
    const GradedAxes axes = graded_axes(helix_total_, face);
    add_error(VaryingError::crossing, axes.crossing);
    add_error(VaryingError::intersecting, axes.intersecting);
  }

  const SolvedJob& job_;
  std::vector<ScatterTolerance>& all_;
  std::string source_;        // key of the grade
  std::string worse_;         // key of the grade with the greatest F_β
  double helix_total_ = 0.0;  // F_β of the worse gear  mm
};

// Number of positions per pitch, if [contact] does not give this number. It is sufficient for the
// peak-to-peak transmission error.
constexpr int kScatterPositions = 32;

Distribution distribution_of(const DistributionSpec& spec) {
  auto made = Distribution::of(spec);  // cannot fail, because the reader has checked `spec`
  GW_EXPECTS(made);
  return std::move(made).take();
}

void add_bearings(const ScatterBearings& b, std::vector<ScatterTolerance>& all) {
  for (const bool far_end : {false, true}) {
    all.push_back({far_end ? "bearings.bore_b" : "bearings.bore_a", 1.0,
                   distribution_of({{-b.radius, b.radius}}), VaryingBore{b.span, b.offset, far_end},
                   "scatter.bearings"});
  }
}

std::optional<Error> add_gear(const SolvedJob& job, int which, const ScatterGear& gear,
                              std::vector<ScatterTolerance>& all) {
  const std::string table = gear_field(which) + ".";
  if (gear.thickness) {
    if (job.pair->arcs())
      return Error{"scatter." + table + "thickness_allowance_mm", "",
                   "is allowed only for involute teeth, because the thickness of circular-arc "
                   "teeth also changes the position of their contact"};
    all.push_back({table + "thickness_allowance_mm", 1.0, distribution_of(*gear.thickness),
                   VaryingThickness{which}, "scatter." + table + "thickness_allowance_mm"});
  }
  for (std::size_t i = 0; i < modification_entries().size(); ++i) {
    if (!gear.modifications[i]) continue;
    const ModificationEntry& m = modification_entries()[i];
    const std::string name = fmt::format("{}modifications.{}_um", table, m.name);
    const auto& flanks = job.completed.gear(which).modifications;
    if (!m.placed(flanks[0]) || !m.placed(flanks[1])) {
      return Error{"scatter." + name, "",
                   fmt::format("needs {}modifications.{}{}, which determines the position of the "
                               "relief; the amount of the relief may be 0",
                               table, m.name, m.reach)};
    }
    all.push_back({name, kMmPerUm, distribution_of(*gear.modifications[i]),
                   VaryingModification{which, m.kind}, "scatter." + name});
  }
  return std::nullopt;
}

Result<std::vector<ScatterTolerance>> tolerances_of(const SolvedJob& job) {
  const ScatterInput& input = job.spec.scatter;
  std::vector<ScatterTolerance> all;
  for (std::size_t i = 0; i < kErrorCount; ++i) {
    if (!input.errors[i]) continue;
    const ErrorEntry& e = error_entries()[i];
    all.push_back({"errors." + std::string(e.key), e.si(), distribution_of(*input.errors[i]),
                   static_cast<VaryingError>(i), "scatter.errors." + std::string(e.key)});
  }
  if (input.bearings) {
    if (job.pair->crossed())
      return Error{"scatter.bearings", "",
                   "is allowed only on parallel axes; on crossed axes give center_distance_mm, "
                   "crossing_deg and intersecting_deg in [scatter.errors]"};
    add_bearings(*input.bearings, all);
  }
  for (const int which : {1, 2}) {
    const ScatterGear& gear = input.gears[which - 1];
    if (auto error = add_gear(job, which, gear, all)) return *error;
  }
  for (ScatterTolerance& t : drawn_tolerances(job))
    if (!is_given(all, t.name)) all.push_back(std::move(t));
  if (auto error = Grades(job, all).add()) return *error;
  return all;
}

// Returns the groups of the spec and, for each input without a group, a group of its own. The
// groups are sorted by the index of their first input in `tolerances`.
Result<std::vector<ToleranceGroup>> groups_of(const ScatterInput& input,
                                              const std::vector<ScatterTolerance>& tolerances) {
  std::vector<std::string> names;
  for (const ScatterTolerance& t : tolerances) names.push_back(t.name);
  std::vector<ToleranceGroup> groups;
  std::vector<bool> taken(tolerances.size());
  for (const auto& given : input.groups) {
    ToleranceGroup group{given.name, {}};
    for (const std::string& name : given.inputs) {
      const auto at = std::find(names.begin(), names.end(), name);
      const std::string field = "scatter.groups." + given.name;
      if (at == names.end())
        return Error{field, name, "is not an input of this spec; " + word_hint(name, names)};
      const auto index = static_cast<std::size_t>(at - names.begin());
      if (taken[index])
        return Error{field, name, "can be in one group only; remove it from the other groups"};
      taken[index] = true;
      group.tolerances.push_back(index);
    }
    std::sort(group.tolerances.begin(), group.tolerances.end());
    groups.push_back(std::move(group));
  }
  for (std::size_t i = 0; i < tolerances.size(); ++i)
    if (!taken[i]) groups.push_back({tolerances[i].name, {i}});
  std::stable_sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) {
    return a.tolerances.front() < b.tolerances.front();
  });
  return groups;
}

// Returns the contact point of the nominal circular-arc racks, from which contact_along_profile is
// measured. For all other teeth, the result is empty.
ProfileTarget profile_target(const Pair& pair) {
  constexpr Angle kProfileEnd = Angle::degrees(10);
  const ArcPair* arcs = pair.arcs();
  if (!arcs || arcs->contacts.empty()) return {};
  return {arcs->first_contact().at.theta, kProfileEnd};
}

Result<RobustTask> robust_task(const ContactSetup& setup, const ScatterRobust& input) {
  auto corrections = corrections_of(setup, input.corrections, "scatter.robust.corrections");
  if (!corrections) return corrections.error();
  RobustTask task{std::move(corrections).take(), {}, input.percentile};
  for (const WorkshopCorrection& c : task.corrections) {
    Correction bounds = bounds_of(setup, c);
    if (input.range) bounds.lo = (*input.range)[0];
    if (input.range) bounds.hi = (*input.range)[1];
    task.bounds.push_back(bounds);
  }
  return task;
}

// Returns the number of samples of each replicate for patterns and loaded teeth. It is the greatest
// power of two that is at most task.samples and gives at most `most` samples in all replicates
// together. The result is at least 1.
int few_samples(const ScatterTask& task, int most) {
  int samples = 1;
  while (2 * samples <= std::min(task.samples, most / task.replicates)) samples *= 2;
  return samples;
}

// Returns the family of loaded teeth for the first samples of each replicate. All samples have the
// same compliance.
Result<LoadedFamily> loaded_family(SolvedJob& job, const ScatterTask& task) {
  if (auto error = other_driver(job.spec)) return *error;
  auto made = load_tasks(job);
  if (!made) return made.error();
  std::vector<LoadTask> sides = std::move(made).take();
  for (LoadTask& side : sides) {
    side.request.rotations.clear();
    side.request.root_stress = false;
    if (!job.spec.given.contains("load.positions")) side.request.positions = kLoadedPositions;
    side.request.progress = task.progress;
  }
  const bool two = sides.size() > 1 && !equal_halves(*job.halves[0], errors_of(job), job.spec.load);
  SliceResolutions resolutions(job.spec.load.slices.has_value());
  const auto solved =
      resolutions.solve(sides[0], [&](const LoadTask& first, const PairCompliance& compliance) {
        std::vector<LoadedContact> contacts = one_contact(first, compliance);
        if (two) contacts.push_back(sides[1].contact(compliance));
        return contacts;
      });
  if (!solved) return solved.error();
  // If a sample loses contact, it may have no results. The nominal pair must have results.
  for (std::size_t i = 0; i < sides.size(); ++i) {
    LoadTask& side = sides[i];
    side.request.slices = solved->slices;
    side.request.progress = nullptr;
    if (i >= solved->contacts.size()) continue;
    std::vector<Warning> found;
    if (auto error = judge_load(side, solved->contacts[i], found)) return *error;
    add_new(std::move(found), job.warnings, i == 1 ? kSecondHalf : "");
  }
  LoadedFamily family{*solved->compliance, sides[0].request,
                      few_samples(task, job.spec.scatter.loaded_samples)};
  if (sides.size() > 1) family.second_half = sides[1].request;
  return family;
}

// Returns the error for the first given key that applies only to single-helical pairs. Such a key
// requests patterns or the long period, which belong to one pair of flanks.
std::optional<Error> not_for_halves(const ScatterInput& input) {
  for (const auto& [key, given] :
       {std::pair("pattern", input.pattern), std::pair("gear1.pitch", input.gears[0].pitch),
        std::pair("gear2.pitch", input.gears[1].pitch)})
    if (given)
      return Error{fmt::format("scatter.{}", key), "",
                   "is not supported for double-helical gears; leave out this key"};
  return std::nullopt;
}

}  // namespace

std::optional<Error> other_driver(const JobSpec& spec) {
  const int driver = spec.load.driver;
  if (driver == spec.contact.driver) return std::nullopt;
  return Error{"load.driver", std::to_string(driver),
               fmt::format("must equal driver = {} of [contact] in a scatter under load; give "
                           "driver = {} in [contact] if gear {} drives",
                           spec.contact.driver, driver, driver)};
}

Error of_scatter(const ScatterTask& task, Error error) {
  const auto of_input = [&](const ScatterTolerance& t) { return t.name == error.field; };
  if (std::any_of(task.tolerances.begin(), task.tolerances.end(), of_input))
    error.field = "scatter." + error.field;
  return error;
}

DensityRequest density_request(const SolvedJob& job, const ScatterTask& task, int most) {
  DensityRequest request;
  request.marking = job.spec.contact.marking;
  request.positions = std::min(task.member.positions, kDensityPositions);
  request.samples = few_samples(task, most > 0 ? most : kPatternSamples);
  return request;
}

PatternDensity density_of(const SolvedJob& job, const ScatterAnswer& answer, Progress* progress,
                          int most) {
  ScatterTask task = answer.task;
  task.progress = progress;
  return pattern_density(answer.setup, task, answer.scatter, density_request(job, task, most));
}

Result<VariedInputs> varied_inputs(const SolvedJob& job) {
  const ScatterInput& input = job.spec.scatter;
  if (job.halves[0])
    if (auto error = not_for_halves(input)) return *error;
  VariedInputs varied;
  auto tolerances = tolerances_of(job);
  if (!tolerances) return tolerances.error();
  varied.tolerances = std::move(tolerances).take();
  auto groups = groups_of(input, varied.tolerances);
  if (!groups) return groups.error();
  varied.groups = std::move(groups).take();
  auto correlations = correlations_of(job.spec, varied.tolerances, varied.groups);
  if (!correlations) return correlations.error();
  varied.correlations = std::move(correlations).take();
  return varied;
}

Result<ScatterAnswer> prepared_scatter(const SolvedJob& job) {
  const ScatterInput& input = job.spec.scatter;
  if (const auto missing = missing_error(SpecUse::scatter, job.spec)) return *missing;
  auto varied = varied_inputs(job);
  if (!varied) return varied.error();
  auto made = setup_of(job, errors_of(job));
  if (!made) return made.error();
  ScatterAnswer answer{std::move(made).take(), {}, {}, {}};
  ScatterTask& task = answer.task;
  static_cast<VariedInputs&>(task) = std::move(varied).take();
  const ContactInput& contact = job.spec.contact;
  task.member = {
      job.spec.given.contains("contact.positions") ? contact.positions : kScatterPositions,
      contact.driver == 2,
      profile_target(*job.pair),
      {}};
  if (job.halves[0]) task.member.stagger = job.halves[0]->given.stagger_pitches;
  static_cast<ScatterPlan&>(task) = input;
  task.seed = static_cast<std::uint64_t>(input.seed);
  return answer;
}

Result<ScatterAnswer> answer_scatter(SolvedJob& job, Progress* progress, int threads) {
  const ScatterInput& input = job.spec.scatter;
  auto prepared = prepared_scatter(job);
  if (!prepared) return prepared.error();
  ScatterAnswer answer = std::move(prepared).take();
  ScatterTask& task = answer.task;
  task.progress = progress;
  task.threads = threads;
  const bool robust_under_load = input.robust && under_load(input.robust->aim);
  std::optional<LoadedFamily> load;
  if (input.loaded || robust_under_load) {
    auto family = loaded_family(job, task);
    if (!family) return family.error();
    load = std::move(family).take();
  }
  if (input.loaded) task.load = load;
  if (input.pattern) task.density = density_request(job, task);
  auto scatter = scatter_of(answer.setup, task);
  if (!scatter) return of_scatter(task, scatter.error());
  answer.scatter = std::move(scatter).take();
  for (Warning& w : sample_warnings(answer.scatter)) job.warnings.push_back(std::move(w));
  const PairInput& pair = job.completed.pair;
  if (input.bearings && (pair.distance_tolerance || pair.distance_deviations))
    job.warnings.push_back({WarningCode::not_read,
                            "The tolerance of the centre distance is not varied, because the bores "
                            "of [scatter.bearings] determine the centre distance. To include the "
                            "tolerance, give a greater radius_mm."});
  if (input.robust) {
    auto made_robust = robust_task(answer.setup, *input.robust);
    if (!made_robust) return made_robust.error();
    RobustTask robust = std::move(made_robust).take();
    if (robust_under_load) robust.load = std::move(load);
    auto found = robust_corrections(answer.setup, task, robust);
    if (!found) return of_scatter(task, found.error());
    // The warning already counts the samples of the scatter. `before` and `after` count the samples
    // of the comparison. The text therefore calls them "other samples".
    const Probability &before = found->before.edge, &after = found->after.edge;
    for (Warning& w : job.warnings)
      if (w.code == WarningCode::samples_touch_edges && found->any())
        w.message += fmt::format(
            " In a comparison with other samples, an edge {} in {} samples without the corrections "
            "of [scatter.robust], and in {} of {} samples with these corrections.",
            robust.load ? "carries load" : "is in contact", before.count, after.count, after.of);
    Json corrected = corrected_spec(job, answer.setup, robust.corrections, found->value,
                                    task.member.gear2_drives);
    corrected["scatter"].erase("robust");
    answer.robust = {std::move(robust), std::move(found).take(),
                     std::make_shared<const SpecTree>(SpecTree{std::move(corrected)})};
  }
  task.progress = nullptr;
  return answer;
}

}  // namespace gearwright
