#include "gearwright/job/drive_job.hpp"

#include <fmt/format.h>

#include <cmath>

#include "gearwright/arrange/judge.hpp"
#include "gearwright/arrange/two_halves.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/catalogue/error_keys.hpp"
#include "gearwright/contact/rack_contact.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/read_drive.hpp"

namespace gearwright {

namespace {

// Returns the key of the quantity that `change` changes, in the table of the spec that describes
// the drive. Returns an empty text if there is no such key.
std::string key_of(const Json& tree, const DriveGraph& graph, const DriveChange& change) {
  const auto key = [&]() -> const char* {
    switch (change.what) {
      case Adjustable::center_distance: return "center_distance_mm";
      case Adjustable::tip_diameter: return "tip_diameter_mm";
      case Adjustable::profile_shift: return "profile_shift";
      case Adjustable::thickness_allowance: return "thickness_allowance_mm";
      case Adjustable::face_width: return "face_width_mm";
      default: return nullptr;
    }
  }();
  const bool mesh = change.what == Adjustable::center_distance;
  const std::string name = mesh ? graph.meshes[change.index].name : graph.gears[change.index].name;
  if (key == nullptr) return "";
  if (tree.contains("planetary")) return fmt::format("planetary.{}.{}", key, name);
  if (tree.contains("drive"))
    return fmt::format("drive.{}[{}].{}", mesh ? "mesh" : "gear", change.index + 1, key);
  return "";  // a stage has other keys
}

// Checks double-helical gears and adds their warnings.
std::optional<Error> find_halves(Drive& drive) {
  for (std::size_t g = 0; g < drive.graph.gears.size(); ++g) {
    const DriveGear& named = drive.graph.gears[g];
    const auto& gear = drive.geometry.gears[g];
    if (!named.double_helical || !gear) continue;
    const auto halves = halves_of(*gear, *named.double_helical);
    if (!halves) return of_drive_gear(named, halves.error());
    if (auto warning = run_out_warning(*halves, 0)) {
      warning->message = named.name + ": " + warning->message;
      drive.findings.push_back(std::move(*warning));
    }
  }
  return std::nullopt;
}

// Returns the error about the first gear whose flanks cannot have its modifications, as
// check_flanks() does for a pair. A relief without a start gets one in each mesh, so it is not
// checked here.
std::optional<Error> check_flanks(const Drive& drive) {
  for (std::size_t g = 0; g < drive.graph.gears.size(); ++g) {
    const DriveGear& named = drive.graph.gears[g];
    const auto& gear = drive.geometry.gears[g];
    if (!gear) continue;
    auto flanks = named.modifications;
    for (FlankModifications& flank : flanks)
      for (Relief* const relief : {&flank.tip_relief, &flank.root_relief})
        if (!relief->reach) relief->amount = 0.0;
    if (auto error = flank_error(*gear, flanks)) return of_drive_gear(named, *std::move(error));
  }
  return std::nullopt;
}

// Returns a note if the torque of the input has no effect, because the power flow is unknown.
// Redundant meshes and impossible teeth have findings of their own.
std::optional<Warning> unused_torque(const Json& tree, const Drive& drive) {
  if (!drive.graph.torque_Nm || drive.flow || !drive.motion.redundant.empty() ||
      !drive.geometry.faults.empty())
    return std::nullopt;
  std::vector<std::string> unknown;
  bool teeth = true;  // true if all meshes with an unknown efficiency have teeth
  for (std::size_t m = 0; m < drive.graph.meshes.size(); ++m) {
    if (drive.efficiencies[m]) continue;
    const DriveMesh& mesh = drive.graph.meshes[m];
    unknown.push_back(printable(mesh.name));
    teeth = teeth && drive.graph.gear(mesh, 0).spec;
  }
  std::string why = "the speeds of the inputs are not given; give speed_rpm";
  if (!unknown.empty())
    why = fmt::format("the efficienc{} of {} {} unknown; give {}{}",
                      unknown.size() == 1 ? "y" : "ies", enumerated(unknown),
                      unknown.size() == 1 ? "is" : "are",
                      tree.contains("drive") ? "efficiency in [[drive.mesh]]" : "mesh_efficiency",
                      teeth ? ""
                            : ", or give normal_module_mm, so that the efficiency is computed from "
                              "the teeth");
  return Warning{WarningCode::not_read,
                 fmt::format("The torque or power of the input has no effect, because {}.", why),
                 0};
}

// Returns a note for each table of the spec that has no effect on a drive.
std::vector<Warning> unused_tables(const JobSpec& spec) {
  std::vector<Warning> notes;
  for (const std::string table : {"gear1", "gear2", "pair", "compensate", "scatter", "fit"})
    if (spec.given.contains(table))
      notes.push_back(
          {WarningCode::not_read,
           fmt::format(
               "[{}] has no effect on a drive. The command `gearwright drive SPEC --take N` "
               "writes mesh N of the drive as a pair, for the verbs for pairs.",
               table),
           0});
  return notes;
}

}  // namespace

MeshErrors mesh_errors(const JobSpec& spec, const Drive& drive) {
  return [&](std::size_t mesh) {
    const auto& pair = drive.geometry.pairs[mesh];
    if (const auto& rack = drive.geometry.racks[mesh])
      return spec.errors.of({&rack->pinion, &rack->pinion});  // see check_rack_errors()
    return spec.errors.of({&pair->gear(1), &pair->gear(2)});
  };
}

Result<DriveJob> solve_drive(const JobSpec& spec) {
  if (!spec.drive) {
    return absent_input("planetary",
                        "; a drive is described by [planetary], [[stage]] or [drive], for example "
                        "by [planetary] with sun = 20, planet = 25, ring = 70 and planets = 3");
  }
  DriveInput input = *spec.drive;
  input.remedies = true;
  auto made = make_drive(input);
  if (!made) return of_drive_table(made.error(), spec.tree->tables);
  DriveJob job{spec, std::move(made).take(), {}, {}, {}, {}, {}};
  if (auto error = find_halves(job.drive)) return of_drive_table(*error, spec.tree->tables);
  if (auto error = check_flanks(job.drive)) return of_drive_table(*error, spec.tree->tables);
  for (Warning& note : unused_tables(spec)) job.drive.findings.push_back(std::move(note));
  if (spec.errors.any()) {
    const MeshErrors errors = mesh_errors(spec, job.drive);
    for (std::size_t m = 0; m < job.drive.geometry.racks.size(); ++m)
      if (job.drive.geometry.racks[m])
        if (auto error = check_rack_errors(errors(m))) return *error;
    job.drive.contacts = mesh_contacts(job.drive, errors);
    job.drive.error = transmission_error(job.drive, spec.drive->harmonics, errors);
  }
  Misfit of_places, of_layout;
  auto places = drive_places(job.drive, &of_places);
  auto layout = drive_layout(job.drive, &of_layout);
  if (!layout) {
    const Error& why = layout.error();
    job.why_no_layout = no_assembly(of_layout, why);
    const bool named = spec.tree->tables.contains("drive") && !why.value.empty();
    const char* const begin = of_layout.any() ? "the drive cannot be assembled, because " : "";
    job.layout_error =
        named ? Error{why.field, why.value, begin + why.rule} : Error{"", "", job.why_no_layout};
    // Without a module, there is no layout, but the places can show what does not fit.
    auto fault = places ? assembly_fault(job.drive, of_layout, why)
                        : assembly_fault(job.drive, of_places, places.error());
    if (fault) job.drive.findings.push_back(std::move(*fault));
  }
  if (places) {
    const auto notes = shafts_through_gears(job.drive, *places);
    job.drive.findings.insert(job.drive.findings.end(), notes.begin(), notes.end());
    job.places = std::move(places).take();
  }
  if (layout) {
    const auto findings = partial_faces(job.drive, *layout);
    job.drive.findings.insert(job.drive.findings.end(), findings.begin(), findings.end());
    job.layout = std::move(layout).take();
  }
  if (auto note = unused_torque(spec.tree->tables, job.drive))
    job.drive.findings.push_back(std::move(*note));
  // In every table of a drive, the members of a gear or a rack have the same keys as in [gear2].
  for (Warning& w : job.drive.findings) w.message = spelled(w.message, spec.given, "gear2");
  job.verdict = judge(job);
  return job;
}

namespace {

// Sets K_γ of each mesh if [rating] gives K_γ for single meshes or as "computed".
std::optional<Error> find_mesh_load_factors(const MeshLoadFactors& factors, const Drive& drive,
                                            DriveLoad& load) {
  const DriveGraph& graph = drive.graph;
  if (factors.computed && !drive.loaded)
    return Error{"rating.mesh_load_factor", "\"computed\"",
                 "needs the table [load], from which the loads of the planets are computed; add "
                 "this table to the spec of the drive, or give a number"};
  if (!factors.computed && factors.given.each.empty()) return std::nullopt;
  load.mesh_load_factors.assign(graph.meshes.size(), 1.0);
  if (factors.computed) {
    load.factor_origin = "computed for the planets under [load]";
    for (const PlanetShares& shares : drive.loaded->sets)
      for (const auto& [m, factor] : shares.mesh_load_factors) load.mesh_load_factors[m] = factor;
  }
  std::vector<std::string> shared;  // the names of the meshes of several planets
  for (std::size_t m = 0; m < graph.meshes.size(); ++m) {
    if (graph.copies(graph.meshes[m]) == 1) continue;
    shared.push_back(graph.meshes[m].name);
    if (const auto own = factors.given.of(shared.back())) load.mesh_load_factors[m] = *own;
  }
  for (const auto& [name, factor] : factors.given.each)
    if (!is_in(name, shared))
      return Error{
          fmt::format("rating.mesh_load_factor.{}", printable(name, 40)), format_number(factor),
          shared.empty()
              ? "is not used, because the drive has no meshes of several planets"
              : fmt::format(
                    "is not the name of a mesh of several planets; the names of such meshes are {}",
                    enumerated(shared))};
  return std::nullopt;
}

bool loads_differ(double own, double other) {
  constexpr double kSameLoad = 1e-9;  // relative; a torque from power and speed may differ by
                                      // rounding errors
  return std::abs(std::abs(own) - std::abs(other)) > kSameLoad * std::abs(own);
}

}  // namespace

std::optional<Error> other_torque(const char* field, double torque, const Drive& drive) {
  const auto& own = drive.graph.torque_Nm;
  if (!own || !loads_differ(*own, torque)) return std::nullopt;
  return Error{
      field, format_number(torque),
      fmt::format(
          "contradicts the torque of {} N m on the input of the drive; leave out one of the two",
          format_number(*own))};
}

std::optional<Error> contradictory_load(const JobSpec& spec, const Drive& drive) {
  const auto& own = drive.graph.torque_Nm;
  const auto& rated = spec.rating.torque;
  const auto& speed = spec.rating.input.speed;
  const auto other = rated ? other_torque("rating.torque_Nm", *rated, drive) : std::nullopt;
  if (other) {
    if (const auto& power = spec.rating.power)
      return Error{"rating.power_kW", format_number(*power),
                   fmt::format("is a torque of {} N m at {} 1/min, which contradicts the torque of "
                               "{} N m on the input of the drive; leave out one of the two",
                               format_number(*rated), format_number(*speed), format_number(*own))};
    return other;
  }
  if (speed && !drive.graph.speeds_rpm.empty() &&
      loads_differ(drive.graph.speeds_rpm.front(), *speed))
    return Error{
        "rating.speed_rpm", format_number(*speed),
        fmt::format(
            "contradicts the speed of {} 1/min of the input of the drive; leave out one of the two",
            format_number(drive.graph.speeds_rpm.front()))};
  return std::nullopt;
}

Result<DriveLoad> rating_load(const JobSpec& spec, const Drive& drive) {
  DriveLoad load;
  load.common = spec.rating.input;
  load.common.speed.reset();
  if (auto error = find_mesh_load_factors(read_mesh_load_factors(spec.tree->tables), drive, load))
    return *error;
  const auto& own = drive.graph.torque_Nm;
  const auto& rated = spec.rating.torque;
  if (!own && !rated)
    return absent_input(
        "rating.torque_Nm",
        "; a rating needs a load. Give torque_Nm, or power_kW with speed_rpm, on the "
        "input of the drive or in [rating]");
  if (auto error = contradictory_load(spec, drive)) return *error;
  load.torque = std::abs(rated.value_or(own.value_or(0.0)));
  if (!(load.torque > 0.0)) return Error{"rating.torque_Nm", "0", "must not be 0 for a rating"};
  if (!drive.graph.speeds_rpm.empty()) load.speed = std::abs(drive.graph.speeds_rpm.front());
  if (spec.rating.input.speed) load.speed = spec.rating.input.speed;
  return load;
}

std::function<std::optional<Error>(Drive&)> drive_rater(const JobSpec& spec) {
  return [&spec,
          materials = drive_materials(spec.tree->tables)](Drive& drive) -> std::optional<Error> {
    const auto load = rating_load(spec, drive);
    if (!load) return load.error();
    auto ratings = rate_meshes(drive, *load, [&](std::size_t gear) {
      const auto own = materials.find(drive.graph.gears[gear].name);
      const MaterialInput given = own != materials.end() ? own->second
                                  : spec.rating.material ? *spec.rating.material
                                                         : MaterialInput();
      return material_of(given, "rating.material", spec.rating.input.edition);
    });
    if (!ratings) return of_drive_table(ratings.error(), spec.tree->tables);
    drive.ratings = std::move(ratings).take();
    return std::nullopt;
  };
}

namespace {

// Returns a finding if the planets under load have a greater K_γ than the rating. Without a rating,
// returns a finding if the load shares of the planets are very unequal.
std::optional<Warning> greater_mesh_load_factor(const Drive& drive) {
  // If K_γ changes by a small fraction, S_F changes by the same fraction and S_H by half of this
  // fraction. One hundredth is far less than the uncertainty of S_F and S_H.
  constexpr double kSameFactor = 0.01;
  // Without a rating, there is a finding if a planet carries at least twice an equal share. If one
  // of two planets carries the whole load, its K_γ is 2 except for rounding errors.
  constexpr double kUnequal = 2.0 - 1e-9;
  const bool rated = !drive.ratings.empty();
  const PlanetShares* worst = nullptr;
  std::size_t mesh = 0;
  double excess = rated ? 1 + kSameFactor : kUnequal;  // K_γ divided by K_γ of the rating
  double factor = 1.0, used = 1.0;
  for (const PlanetShares& shares : drive.loaded->sets)
    for (const auto& [m, computed] : shares.mesh_load_factors) {
      const double own = rated && drive.ratings[m] ? drive.ratings[m]->input.mesh_load_factor : 1.0;
      if (computed <= excess * own) continue;
      worst = &shares;
      mesh = m;
      excess = computed / own;
      factor = computed;
      used = own;
    }
  if (!worst) return std::nullopt;
  const std::string shown = fixed_decimals(factor, 3), &name = drive.graph.meshes[mesh].name;
  if (!rated)
    return Warning{
        WarningCode::mesh_load_factor,
        fmt::format("In the mesh {}, the planets under this load have K_γ = {}, because one planet "
                    "carries {} times an equal share. Reduce the errors of the pins{}.",
                    name, shown, shown, worst->floating ? "" : ", or let one member float")};
  return Warning{WarningCode::mesh_load_factor,
                 fmt::format("In the mesh {}, the planets under this load have K_γ = {}, but the "
                             "safeties are computed with K_γ = {}; give mesh_load_factor = {} or "
                             "\"computed\" in [rating].",
                             name, shown, fixed_decimals(used, 3), shown)};
}

// Returns a finding if a planet carries no load over a whole period. K_γ can be small even then: if
// one of three planets carries nothing, it is between 1.5 and 3. A rating compares its own K_γ with
// the computed one, so there is no finding if the drive is rated.
std::optional<Warning> idle_planet(const Drive& drive) {
  if (!drive.ratings.empty()) return std::nullopt;
  constexpr double kNoShare = 1e-9;  // shares of this size are rounding errors
  for (const PlanetShares& shares : drive.loaded->sets)
    for (std::size_t i = 0; i < shares.greatest.size(); ++i) {
      if (shares.greatest[i] > kNoShare) continue;
      const auto& [mesh, factor] = shares.mesh_load_factor();
      return Warning{
          WarningCode::mesh_load_factor,
          fmt::format("Planet {} of {} carries no load at any position; in the mesh {}, the other "
                      "planets have K_γ = {}. Reduce the errors of the pins{}.",
                      i + 1, shares.greatest.size(), drive.graph.meshes[mesh].name,
                      fixed_decimals(factor, 3),
                      shares.floating ? "" : ", or let one member float")};
    }
  return std::nullopt;
}

}  // namespace

Result<DriveJob> solve_whole_drive(const JobSpec& spec, const DriveParts& parts,
                                   Progress* progress) {
  const auto wants = [](Wanted part, bool given) {
    return part == Wanted::yes || (part == Wanted::if_given && given);
  };
  begin_stage(progress, "computing the drive", 0);
  auto solved = solve_drive(spec);
  const bool rated = wants(parts.rating, spec.rating.given);
  const bool analysed = wants(parts.contact, spec.errors.given || spec.contact.given);
  const bool loaded = spec.given.contains("load");
  if (!solved || !(rated || loaded || analysed)) return solved;
  DriveJob job = std::move(solved).take();
  if (analysed)
    if (auto error = analyse_drive_contact(job, progress)) return *error;
  const bool needs_load = loaded && read_mesh_load_factors(spec.tree->tables).computed;
  if (rated && !needs_load)
    if (auto error = drive_rater(spec)(job.drive)) return *error;
  if (loaded)
    if (auto error = load_drive(job, progress)) return *error;
  if (rated && needs_load)
    if (auto error = drive_rater(spec)(job.drive)) return *error;
  if (loaded) {
    auto finding = greater_mesh_load_factor(job.drive);
    if (!finding) finding = idle_planet(job.drive);
    if (finding) job.drive.findings.push_back(std::move(*finding));
  }
  job.verdict = judge(job);
  return job;
}

Safeties wanted_safety(const JobSpec& spec) {
  return {spec.rating.safety_flank_min.value_or(1.0), spec.rating.safety_root_min.value_or(1.0)};
}

Verdict judge(const DriveJob& job) {
  Verdict verdict = judge_drive(
      job.drive, *job.spec.drive,
      [&](const DriveChange& change) {
        return key_of(job.spec.tree->tables, job.drive.graph, change);
      },
      wanted_safety(job.spec));
  const auto& contacts = job.drive.contacts;
  bool unknown = false;
  for (std::size_t m = 0; m < contacts.size(); ++m)
    unknown = unknown || (transverse_base_backlash(job.drive.geometry, m) && !contacts[m]);
  if (unknown) verdict.not_judged.emplace_back("contact");
  const auto& ratings = job.drive.ratings;
  for (std::size_t m = 0; m < ratings.size(); ++m)
    if (!ratings[m] && job.drive.flow->driver[m] >= 0)
      verdict.not_judged.push_back(
          fmt::format("rating of the mesh {}", printable(job.drive.graph.meshes[m].name)));
  const auto spell = [&](std::string& text) { text = spelled(text, job.spec.given, "gear2"); };
  spell(verdict.headline);
  for (Finding& f : verdict.findings) {
    spell(f.message);
    spell(f.remedy);
  }
  return verdict;
}

}  // namespace gearwright
