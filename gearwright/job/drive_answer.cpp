#include "gearwright/job/drive_answer.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "gearwright/base/printable.hpp"
#include "gearwright/catalogue/drive_quantities.hpp"
#include "gearwright/catalogue/rating_quantities.hpp"
#include "gearwright/drive/drive_forces.hpp"
#include "gearwright/drive/drive_rating.hpp"
#include "gearwright/job/csv_answer.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/result_rows.hpp"
#include "gearwright/job/search_answer.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/read_drive.hpp"

namespace gearwright {

namespace {

// Returns the function of a body in the drive, "input", "held" or "output". For any other body with
// several copies, returns the number of copies.
std::string part_of(const Drive& drive, std::size_t body) {
  if (drive.graph.is_input(body)) return "input";
  if (drive.graph.is_fixed(body)) return "held";
  if (drive.graph.output == body) return "output";
  return drive.graph.bodies[body].count > 1 ? fmt::format("× {}", drive.graph.bodies[body].count)
                                            : "";
}

// Returns rows for the bodies or meshes of a drive for which `has` is true, below a title. If there
// are none, the text is empty.
template <class View, class List, class Has>
std::string rows_of(UnitSystem units, const char* title, const Quantities<View>& quantities,
                    const Drive& drive, const List& list, const Has& has,
                    std::initializer_list<std::string_view> keys) {
  std::vector<std::string> names;
  std::vector<ValueRecord> records;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!has(i)) continue;
    names.push_back(printable(list[i].name, 17));
    records.push_back(quantities.of({&drive, i}));
  }
  return names.empty() ? "" : title + row_listing(units, names, records, keys);
}

std::string body_listing(const Drive& drive, UnitSystem units) {
  const auto& bodies = drive.graph.bodies;
  std::vector<std::string> names;
  std::vector<ValueRecord> records;
  bool racks = false;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const std::string part = part_of(drive, b);
    names.push_back(printable(bodies[b].name, 13) + (part.empty() ? "" : ", " + part));
    records.push_back(drive_body_quantities().of({&drive, b}));
    racks = racks || drive.graph.moves(b);
  }
  return "\nBodies\n" +
         row_listing(units, names, records,
                     {"speed_ratio", "speed_ratio_exact", "relative_speed_ratio",
                      "travel_per_input_turn_mm", "speed_rpm", "speed_m_per_s", "torque_ratio",
                      "torque_Nm", "force_N", "power_kW"}) +
         (racks ? "  The speed ratio of a rack is in pitches per turn of the input.\n" : "");
}

std::string mesh_listing(const Drive& drive, UnitSystem units) {
  const auto& meshes = drive.graph.meshes;
  const auto& quantities = drive_mesh_quantities();
  const auto rated = [&](std::size_t m) { return m < drive.ratings.size() && drive.ratings[m]; };
  const auto analysed = [&](std::size_t m) {
    return m < drive.analyses.size() && drive.analyses[m];
  };
  return rows_of(units, "\nStrength by ISO 6336\n", quantities, drive, meshes, rated,
                 {"rating.torque_Nm", "rating.speed_rpm", "rating.S_H", "rating.S_F"}) +
         rows_of(units, "\nTooth contact\n", quantities, drive, meshes, analysed,
                 {"contact.continuous_peak_to_peak_arcsec", "contact.least_play_deg",
                  "contact.continuous_peak_to_peak_um", "contact.least_play_mm"}) +
         rows_of(units, "\nMeshes\n", quantities, drive, meshes, [](std::size_t) { return true; },
                 {"frequency_ratio", "frequency_hz", "efficiency", "power_ratio",
                  "pair.center_distance_mm", "pair.contact_ratio_true", "pair.backlash.normal_mm",
                  "rack_pair.center_distance_mm", "rack_pair.contact_ratio_true",
                  "rack_pair.backlash.normal_mm"});
}

std::string force_listing(const Drive& drive, UnitSystem units) {
  if (!drive.graph.torque_Nm) return "";
  const auto in_mesh = [&](std::size_t m) { return mesh_forces(drive, m).has_value(); };
  const auto on_body = [&](std::size_t b) { return body_forces(drive, b).has_value(); };
  const bool planets = !drive.sets.empty();
  const char* const meshes =
      planets ? "\nForces of the teeth on the first gear of each mesh, for one planet\n"
              : "\nForces of the teeth on the first gear of each mesh\n";
  const char* const bodies =
      planets ? "\nForces of all teeth on each body; each planet has the force of its row\n"
              : "\nForces of all teeth on each body\n";
  return rows_of(units, meshes, drive_mesh_quantities(), drive, drive.graph.meshes, in_mesh,
                 {"tangential_force_N", "separating_force_N", "axial_force_N"}) +
         rows_of(units, bodies, drive_body_quantities(), drive, drive.graph.bodies, on_body,
                 {"radial_force_N", "axial_force_N", "tilting_moment_Nm"});
}

std::string shift_listing(const Drive& drive) {
  const Member shifts = coaxial_quantities().of(drive).back();
  const std::string list = text_of(*shifts.info, shifts.value, "");
  return list.empty() ? "" : "\nProfile shifts: " + list + "\n";
}

std::string set_listing(const PlanetSet& set, UnitSystem units) {
  return "\nPlanets\n" + listing_of(units, assembly_quantities(), set) + "\nPhases\n" +
         listing_of(units, phasing_quantities(), set);
}

std::string drive_csv(const Drive& drive) {
  std::string out =
      "body,speed_ratio,relative_speed_ratio,speed_rpm,torque_ratio,speed_m_per_s\r\n";
  const auto cell = [](const std::optional<double>& x) { return x ? fmt::format("{}", *x) : ""; };
  const bool powered = drive.flow && !drive.flow->self_locking();
  for (std::size_t b = 0; b < drive.graph.bodies.size(); ++b)
    out += fmt::format("{},{},{},{},{},{}\r\n", csv_cell(Value(drive.graph.bodies[b].name)),
                       cell(drive.speed_ratio(b)), cell(drive.relative_speed_ratio(b)),
                       drive.graph.moves(b) ? "" : cell(drive.speed_rpm(b)),
                       powered ? fmt::format("{}", drive.flow->torque[b]) : "",
                       cell(drive.linear_speed(b)));
  return out;
}

std::string load_factor_sentence(const Drive& drive) {
  const auto computed = mesh_load_factor(drive), rated = rated_mesh_load_factor(drive);
  if (!computed || !rated) return "";
  return fmt::format("  The rating uses K_γ = {}; the planets under this load have K_γ = {}.\n",
                     fixed_decimals(*rated, 3), fixed_decimals(*computed, 3));
}

std::string drive_load_listing(const Drive& drive, UnitSystem units) {
  if (!drive.loaded) return "";
  std::string out = "\nUnder load\n" + listing_of(units, drive_load_quantities(), drive);
  for (const PlanetShares& shares : drive.loaded->sets) {
    const std::size_t carrier = drive.sets[shares.set].group.carrier;
    out += fmt::format("\nPlanets of {} under load\n", printable(drive.graph.bodies[carrier].name));
    out += listing_of(units, planet_share_quantities(), {&drive, &shares});
  }
  return out + load_factor_sentence(drive);
}

Answer answer_of(const JobSpec& spec, const std::shared_ptr<const DriveJob>& job,
                 std::string (*listing)(const Drive&, UnitSystem)) {
  Answer answer;
  answer.record = titled_record(spec, "drive", drive_quantities().of(job->drive));
  answer.warnings = job->drive.findings;
  for (const auto& r : job->drive.ratings)
    if (r)
      answer.warnings.insert(answer.warnings.end(), r->rating.limits.begin(),
                             r->rating.limits.end());
  answer.verdict = job->verdict;
  answer.listing = [job, listing, title = title_listing(spec, "\n"), units = spec.units()] {
    return title + listing(job->drive, units);
  };
  answer.csv = [job] { return drive_csv(job->drive); };
  answer.rows = [job](UnitSystem units) {
    return rows_json(units, {.name = "drive",
                             .quantities = drive_quantities().table(),
                             .records = {drive_quantities().of(job->drive)}});
  };
  return answer;
}

}  // namespace

std::string drive_listing(const Drive& drive, UnitSystem units) {
  std::string out = listing_of(units, drive_quantities(), drive);
  out += drive_load_listing(drive, units) + body_listing(drive, units) +
         mesh_listing(drive, units) + force_listing(drive, units) + shift_listing(drive);
  for (const PlanetSet& set : drive.sets) out += set_listing(set, units);
  return out;
}

Result<Answer> answer_drive(const JobSpec& spec, Progress* progress) {
  auto solved = solve_whole_drive(spec, {.rating = Wanted::no}, progress);
  if (!solved) return solved.error();
  if (spec.rating.given)
    if (auto error = contradictory_load(spec, solved->drive)) return *error;
  const auto job = std::make_shared<const DriveJob>(std::move(solved).take());
  Answer whole = answer_of(spec, job, drive_listing);
  if (spec.rating.given) whole.verdict->not_judged.emplace_back("rating");
  whole.drive_specs = [job] {
    DriveSpecs made{expanded_spec(job->spec.tree->tables, *job->spec.drive), {}, {}};
    for (std::size_t m = 0; m < job->drive.graph.meshes.size(); ++m) {
      MeshSpec mesh = mesh_spec(*job, made.expanded, m);
      made.meshes.push_back(std::move(mesh.tables));
      made.notes.push_back(std::move(mesh.notes));
    }
    return made;
  };
  return whole;
}

namespace {

// Lists the inputs, factors and safety factors of each mesh, as in the rating of a pair.
std::string factor_listing(const Drive& drive, UnitSystem units) {
  std::string out = rates_equal_shares(drive) ? "\n" + wrapped(std::string(kEqualShares)) : "";
  for (std::size_t m = 0; m < drive.ratings.size(); ++m) {
    const auto record = mesh_rating(drive, m);
    if (!record) continue;
    const DriveMesh& mesh = drive.graph.meshes[m];
    const std::vector<std::string> names{printable(drive.graph.gear(mesh, 0).name, 13),
                                         printable(drive.graph.gear(mesh, 1).name, 13)};
    out += fmt::format("\nStrength of {}\n", printable(mesh.name));
    out += quantity_listing(
        units, rating_quantities().table(), {*record}, names, [&](const QuantityInfo& q) {
          return sentence_in(units, source_text(drive.ratings[m]->rating, q.key));
        });
  }
  return out;
}

}  // namespace

Result<Answer> answer_drive_rating(const JobSpec& spec, Progress* progress) {
  auto solved = solve_whole_drive(spec, {Wanted::yes, Wanted::no}, progress);
  if (!solved) return solved.error();
  return answer_of(spec, std::make_shared<const DriveJob>(std::move(solved).take()),
                   [](const Drive& drive, UnitSystem units) {
                     return drive_load_listing(drive, units) + body_listing(drive, units) +
                            mesh_listing(drive, units) + factor_listing(drive, units);
                   });
}

}  // namespace gearwright
