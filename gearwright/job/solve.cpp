#include "gearwright/job/solved_job.hpp"

#include <fmt/format.h>

#include <utility>

#include "gearwright/arrange/tolerance_ends.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/job/measures.hpp"

namespace gearwright {

namespace {

// Returns a note about the material and the quality that gear 2 takes from gear 1. The note is
// necessary, because the dimensions of gear 2 do not show the origin of these values.
std::optional<Warning> note_inherited(const JobSpec& spec) {
  std::string text;
  for (const std::string& key : spec.inherited) {
    const GearInput& gear = spec.gear(2);
    const std::string value = key == "quality"     ? fmt::format(" {}", *gear.tolerance.quality)
                              : gear.material.name ? " " + printable(*gear.material.name)
                                                   : "";
    text += fmt::format("{}`{}`{}", text.empty() ? "" : ", ", key, value);
  }
  if (text.empty()) return std::nullopt;
  return Warning{WarningCode::inherited,
                 fmt::format("Gear 2 takes these absent values from gear 1: {}.", text), 2};
}

// Returns notes about fits and textures of the drawing that apply to no gear of the spec.
std::vector<Warning> note_unused_fits(const JobSpec& spec) {
  bool bore = false, keyway = false;
  for (const auto& gear : spec.gears) {
    if (!gear || !gear->bore || gear->cylindrical.teeth < 0) continue;
    bore = true;
    keyway = keyway || gear->bore->has_keyway();
  }
  std::vector<Warning> notes;
  const auto note = [&](const std::string& fit, const char* key, const char* of, const char* with) {
    if (fit.empty()) return;
    notes.push_back({WarningCode::not_read,
                     fmt::format("`drawing.{}` = {} has no effect, because no external gear of the "
                                 "spec has a {}. To define a {}, give {} in `gear1.bore`.",
                                 key, printable(fit), of, of, with),
                     0});
  };
  if (!bore) {
    note(spec.drawing.bore_fit, "bore_fit", "bore", "diameter_mm");
    note(spec.drawing.bore_roughness, "bore_roughness", "bore", "diameter_mm");
  }
  if (!keyway)
    note(spec.drawing.keyway_fit, "keyway_fit", "keyway",
         "either keyway or both keyway_width_mm and keyway_depth_mm");
  return notes;
}

// Adds the data of double-helical gears. `job` contains one half of each such gear.
std::optional<Error> find_halves(SolvedJob& job) {
  for (std::size_t i = 0; i < job.gears.size(); ++i) {
    const int which = static_cast<int>(i) + 1;
    const auto& given = job.spec.gear(which).double_helical;
    if (!given) continue;
    auto halves = halves_of(job.gears[i], *given);
    if (!halves) return of_gear(which, halves.error());
    job.halves[i] = std::move(halves).take();
    for (const auto& warning : {run_out_warning, stagger_warning})
      if (auto w = warning(*job.halves[i], which)) job.warnings.push_back(*w);
  }
  const bool any = job.halves[0] || job.halves[1];
  if (!any || !job.pair || !job.pair->crossed()) return std::nullopt;
  return Error{"pair.shaft_angle", "",
               "makes the axes cross, but double-helical gears run only on parallel axes and with "
               "opposite hands"};
}

// True if the verb `fit` can compute the numbers that the error reports as missing. These numbers
// are the position of the gears, the helix angles and the profile shifts.
bool is_found_by_fit(const JobSpec& spec, const Error& error) {
  if (error.kind != FailureKind::placement && error.kind != FailureKind::missing) return false;
  const bool helices = spec.gear(1).helix_given || spec.gear(2).helix_given;
  return spec.given.contains("fit") || (spec.pair.shaft_angle && !helices);
}

// Solves the gears and the pair. For double-helical gears, the result contains one half of each
// gear and the pair of these halves.
Result<SolvedJob> solve_gears(const JobSpec& spec, Scope scope) {
  if (!spec.has(1) && spec.measured[0]) {
    return absent_input("gear1.normal_module",
                        "; the spec contains readings of an unknown gear. The command `gearwright "
                        "identify SPEC --take 1` writes a spec for this verb");
  }
  if (spec.drive) {
    return Error{"", "",
                 "the spec describes a drive; use one of the verbs drive, rate, run and export. "
                 "The command `gearwright drive SPEC --take 1` writes the spec of the first mesh "
                 "for this verb"};
  }
  if (!spec.has(1)) {
    return absent_input("gear1.teeth",
                        "; the spec describes a search. The command `gearwright search SPEC --take "
                        "1` writes a spec for this verb");
  }
  GivenPair given = spec;
  if (auto note = note_inherited(spec)) given.notes.push_back(*note);
  for (Warning& note : note_unused_fits(spec)) given.notes.push_back(std::move(note));
  if (auto error = halve(given)) return *error;
  auto arranged = arrange(given, scope);
  if (!arranged) {
    Error error = arranged.error();
    if (spec.has(2) && is_found_by_fit(spec, error))
      error.rule +=
          "; some values of the spec are absent. The command `gearwright fit SPEC --take 1` "
          "computes them and writes a spec for this verb";
    return error;
  }
  SolvedJob job{std::move(arranged).take(), spec};
  if (auto error = find_halves(job)) return *error;
  if (auto error = check_flanks(job)) return *error;
  // The author of the file reads the warnings. Their texts therefore contain keys of the file
  // instead of names of members.
  for (Warning& w : job.warnings)
    w.message = spelled(w.message, spec.given, w.gear == 0 ? "" : gear_field(w.gear));
  return job;
}

}  // namespace

const std::vector<Arranged>& SolvedJob::corners() const {
  const std::lock_guard lock(shared_corners->mutex);
  if (!shared_corners->list) shared_corners->list = arranged_corners(*this);
  return *shared_corners->list;
}

std::optional<Error> one_helix_error(const SolvedJob& job) {
  if (!job.halves[0]) return std::nullopt;
  return Error{"gear1.double_helical", "",
               "makes the gears double-helical, and this analysis supports single-helical gears "
               "only. The verbs contact, load, scatter and run compute double-helical gears, "
               "and [scatter.robust] finds corrections for them. To analyse one half alone, leave "
               "out `double_helical` and "
               "give the face width of the half and half of the torque"};
}

std::string_view finder_of(const JobSpec& spec, const Error& error) {
  if (spec.drive) return "";
  if (!spec.has(1)) return spec.measured[0] ? "identify" : "search";
  return spec.has(2) && is_found_by_fit(spec, error) ? "fit" : "";
}

std::optional<Error> two_gears_error(const JobSpec& spec) {
  if (!spec.rack) return std::nullopt;
  return Error{
      "gear2.form", "rack",
      "makes gear 2 a rack, but this verb needs two gears. The verbs gear, pair, contact, outline, "
      "export and run compute a rack and its pinion. For `gearwright load` and `gearwright rate`, "
      "a gear 2 with teeth = 200 can replace the rack. docs/spec.md explains how to choose the "
      "bore of this gear, and how its flank stress and its life differ from those of the rack"};
}

Result<SolvedJob> solve(const JobSpec& spec, Scope scope) {
  if (scope != Scope::gears)
    if (auto error = two_gears_error(spec)) return *error;
  return solve_gears(spec, scope);
}

Result<SolvedJob> solve_any(const JobSpec& spec, Scope scope) {
  if (!spec.rack) return solve(spec, scope);
  auto solved = solve_gears(spec, Scope::everything);
  if (!solved) return solved;
  SolvedJob job = std::move(solved).take();
  job.rack->rack.bar.pin_diameter =
      pin_of_diametral_pitch(spec, 2, false, job.gear(1).spec.normal_module);
  return job;
}

}  // namespace gearwright
