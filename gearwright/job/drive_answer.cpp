#include "gearwright/job/drive_answer.hpp"

#include "gearwright/catalogue/search_keys.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "gearwright/base/printable.hpp"
#include "gearwright/catalogue/drive_quantities.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
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
  return rows_of(units, "\nStrength by ISO 6336\n", quantities, drive, meshes, rated,
                 {"rating.torque_Nm", "rating.speed_rpm", "rating.S_H", "rating.S_F"}) +
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
  return rows_of(units, "\nForces of the teeth on the first gear of each mesh, for one planet\n",
                 drive_mesh_quantities(), drive, drive.graph.meshes, in_mesh,
                 {"tangential_force_N", "separating_force_N", "axial_force_N"}) +
         rows_of(units, "\nForces of all teeth on each body, for one planet\n",
                 drive_body_quantities(), drive, drive.graph.bodies, on_body,
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

Result<Answer> answer_of(const JobSpec& spec, Result<DriveJob> solved,
                         std::string (*listing)(const Drive&, UnitSystem)) {
  if (!solved) return solved.error();
  const auto job = std::make_shared<const DriveJob>(std::move(solved).take());
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
  const auto solved = solve_whole_drive(spec, progress, RateMeshes::no);
  auto answer = answer_of(spec, solved, drive_listing);
  if (!answer) return answer.error();
  Answer whole = std::move(answer).take();
  if (spec.rating.given) whole.verdict->not_judged.emplace_back("rating");
  whole.expanded = expanded_spec(spec.tree->tables, *spec.drive);
  for (std::size_t m = 0; m < solved->drive.graph.meshes.size(); ++m) {
    MeshSpec mesh = mesh_spec(*solved, whole.expanded, m);
    whole.specs.push_back(std::move(mesh.tables));
    whole.notes.push_back(std::move(mesh.notes));
  }
  return whole;
}

namespace {

// Lists the inputs, factors and safety factors of each mesh, as in the rating of a pair.
std::string factor_listing(const Drive& drive, UnitSystem units) {
  std::string out;
  for (std::size_t m = 0; m < drive.ratings.size(); ++m) {
    const auto record = mesh_rating(drive, m);
    if (!record) continue;
    out += fmt::format("\nStrength of {}\n", printable(drive.graph.meshes[m].name));
    out += quantity_listing(
        units, rating_quantities().table(), {*record}, gear_columns(2), [&](const QuantityInfo& q) {
          return sentence_in(units, source_text(drive.ratings[m]->rating, q.key));
        });
  }
  return out;
}

}  // namespace

Result<Answer> answer_drive_rating(const JobSpec& spec, Progress* progress) {
  return answer_of(spec, solve_whole_drive(spec, progress, RateMeshes::yes),
                   [](const Drive& drive, UnitSystem units) {
                     return drive_load_listing(drive, units) + body_listing(drive, units) +
                            mesh_listing(drive, units) + factor_listing(drive, units);
                   });
}

namespace {

// Tables of the spec of a drive that also apply to each of its meshes.
constexpr const char* kShared[] = {"errors", "contact", "drawing", "scatter"};

// Returns the series of DIN 3967 whose mean allowance the gear has. Returns an empty text if there
// is no such series. `name` is the name of the gear in the graph, for example "s2_gear1" for a gear
// of stage 2.
std::string series_of(const Json& tables, const std::string& name, const CylindricalSpec& gear) {
  std::vector<const Json*> forms;
  const auto add = [&](const Json& table, const char* key) {
    if (table.contains(key) && table[key].is_object()) forms.push_back(&table[key]);
  };
  add(tables, "planetary");
  for (std::size_t k = 0; tables.contains("stage") && k < tables["stage"].size(); ++k) {
    if (!name.starts_with(fmt::format("s{}_", k + 1))) continue;
    forms.push_back(&tables["stage"][k]);
    add(tables["stage"][k], "planetary");
  }
  const double diameter =
      gear.normal_module * std::abs(gear.teeth) / std::cos(gear.helix_angle.rad());
  for (const Json* form : forms) {
    const std::string series = form->value("thickness_series", "");
    if (!series.empty() && series != kNoAllowances &&
        mean_allowance(series, diameter) == gear.thickness_allowance)
      return series;
  }
  return "";
}

Json gear_table(const DriveJob& job, const Json& expanded, std::size_t gear) {
  Json table = expanded["drive"]["gear"][gear];
  table.erase("name");
  table.erase("body");
  if (const auto& rack = job.drive.graph.gears[gear].rack) {
    Json bar = Json::object();  // the table of the pinion describes the teeth
    for (const auto& [key, value] : table.items())
      if (rack_bar_keys().find(key)) bar[key] = value;
    if (rack->thickness_allowance != 0.0) bar["thickness_allowance_mm"] = rack->thickness_allowance;
    return bar;
  }
  // Adding 0 replaces −0 by 0.
  if (table.contains("helix_angle_deg"))
    table["helix_angle_deg"] = table["helix_angle_deg"].get<double>() + 0.0;
  const auto& solved = job.drive.geometry.gears[gear];
  const auto& given = job.spec.drive->graph.gears[gear].spec;
  if (solved && solved->spec.thickness_allowance != given->thickness_allowance)
    table["thickness_allowance_mm"] = solved->spec.thickness_allowance;
  // If an allowance is the mean of a series, the name of the series replaces it. The drawing then
  // has the limits of the series.
  const std::string series =
      solved ? series_of(job.spec.tree->tables, job.drive.graph.gears[gear].name, solved->spec)
             : "";
  if (!series.empty()) {
    table.erase("thickness_allowance_mm");
    table["tolerance"]["thickness_series"] = series;
  }
  if (!solved || !solved->involute() || table.contains("basic")) return table;
  table.erase("profile_shift_pair");
  table["profile_shift"] = solved->spec.profile_shift;
  const bool round = solved->spec.root_fillet || solved->spec.tip_fillet;
  if (!round && !table.contains("tip_diameter_mm")) table["tip_diameter_mm"] = solved->tip_diameter;
  return table;
}

// The load of a mesh in the rating of a drive, and the number of engagements of its flanks.
struct RatedLoad {
  RatingInput input;
  std::array<FlankUse, 2> use;
};

// Returns the table [rating] for one mesh. The load is that of one copy of the mesh. The life is
// that of the gear with more engagements. The bending counts as reversed if it is reversed for one
// of the gears.
Json rating_table(const Json& of_drive, const RatedLoad& load) {
  Json table = of_drive;
  for (const char* key : {"power_kW", "speed_rpm", "mesh_load_factor", "spectrum"})
    table.erase(key);
  table["torque_Nm"] = load.input.torque;
  if (load.input.speed) table["speed_rpm"] = *load.input.speed;
  if (load.input.mesh_load_factor != 1.0) table["mesh_load_factor"] = load.input.mesh_load_factor;
  const int engagements = std::max(load.use[0].engagements, load.use[1].engagements);
  if (load.input.life_h && engagements > 1) table["life_h"] = *load.input.life_h * engagements;
  if (load.use[0].both || load.use[1].both) table["reversed"] = true;
  return table;
}

}  // namespace

MeshSpec mesh_spec(const DriveJob& job, const Json& expanded, std::size_t mesh) {
  const Drive& drive = job.drive;
  const DriveMesh& m = drive.graph.meshes[mesh];
  Json spec = Json::object();
  spec["title"] = job.spec.title.empty() ? m.name : fmt::format("{}, {}", job.spec.title, m.name);
  const bool rack = drive.graph.gear(m, 0).rack || drive.graph.gear(m, 1).rack;
  const std::size_t first = drive.graph.gear(m, 0).rack ? 1 : 0;
  spec["gear1"] = gear_table(job, expanded, m.gears[first]);
  spec["gear2"] = gear_table(job, expanded, m.gears[1 - first]);
  Json& pair = spec["pair"] = Json::object();
  if (const auto& distance = drive.geometry.distance[mesh]) pair["center_distance_mm"] = *distance;
  if (const double friction = m.friction.value_or(drive.graph.friction); friction > 0.0)
    pair["friction_coefficient"] = friction;
  const bool halves = drive.graph.gear(m, 0).double_helical.has_value();
  const bool locks = drive.flow && drive.flow->self_locking();
  const bool carries = drive.flow && !locks && drive.flow->driver[mesh] >= 0 && !rack;
  std::optional<double> torque = drive.graph.torque_Nm;
  if (!torque && job.spec.load.torques.size() == 1) torque = job.spec.load.torques.front();
  if (carries && torque.value_or(0.0) != 0.0) {
    const RatingInput load = mesh_load(
        drive, mesh, {std::abs(*torque), drive.speed_rpm(drive.graph.inputs.front()), {}});
    if (load.speed) pair["speed_rpm"] = *load.speed;
    spec["load"]["torque_Nm"] = load.torque;
    if (drive.flow->driver[mesh] == 1) spec["load"]["driver"] = 2;
    for (const char* key : {"positions", "slices", "accuracy"})
      if (expanded.contains("load") && expanded["load"].contains(key))
        spec["load"][key] = expanded["load"][key];
  }
  for (const std::string name : kShared)
    if (expanded.contains(name) && !(halves && name == "scatter")) spec[name] = expanded[name];
  if (spec.contains("load") && drive.flow->driver[mesh] == 1) spec["contact"]["driver"] = 2;

  std::vector<std::string> notes{
      fmt::format("This pair is the mesh {} of the drive. All digits of the numbers are written, "
                  "so that the results of the pair and of the drive agree to the last bit.",
                  printable(m.name))};
  if (job.verdict.level == Level::red) notes.push_back(job.verdict.headline);
  if (locks) notes.emplace_back("The pair has no load, because the input cannot drive the output.");
  if (job.spec.rating.given) {
    const auto load = rating_load(job.spec, drive);
    if (carries && load) {
      const RatedLoad rated{mesh_load(drive, mesh, *load),
                            {flank_use(drive, mesh, 0), flank_use(drive, mesh, 1)}};
      spec["rating"] = rating_table(expanded["rating"], rated);
      add_grade(spec["gear1"], rated.input, 0);
      add_grade(spec["gear2"], rated.input, 1);
      if (rated.use[0].engagements != rated.use[1].engagements ||
          rated.use[0].both != rated.use[1].both)
        notes.push_back(
            fmt::format("The flanks of the gears engage {} and {} times per turn. The keys life_h "
                        "and reversed in [rating] apply to the gear with the more severe use.",
                        rated.use[0].engagements, rated.use[1].engagements));
      if (expanded["rating"].contains("spectrum"))
        notes.push_back(
            "The spectrum of [rating] is left out, because it applies to the whole drive.");
    } else {
      const char* why = rack      ? "a rack is not rated"
                        : carries ? "the drive has no load"
                                  : "the mesh carries no load";
      notes.push_back(fmt::format("The table [rating] is left out, because {}.", why));
    }
  }
  if (spec["pair"].empty()) spec.erase("pair");  // added tables may invalidate the reference `pair`
  return {std::move(spec), std::move(notes)};
}

}  // namespace gearwright
