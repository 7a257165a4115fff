#include "gearwright/job/drive_answer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "gearwright/base/printable.hpp"
#include "gearwright/catalogue/drive_quantities.hpp"
#include "gearwright/catalogue/pair_keys.hpp"
#include "gearwright/drive/drive_rating.hpp"
#include "gearwright/job/csv_answer.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/search_answer.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/read_drive.hpp"

namespace gearwright {

namespace {

constexpr const char* kAbsent = "-";

std::string number(const std::optional<double>& x, int decimals) {
  return x && std::isfinite(*x) ? fixed_decimals(*x, decimals) : kAbsent;
}

std::string fraction(const Rational& r) {
  const auto p = r.numerator(), q = r.denominator();
  if (!p || !q) return number(r.value(), 6);
  return *q == 1 ? fmt::format("{}", *p) : fmt::format("{}/{}", *p, *q);
}

// The function of a body in the drive, "input", "held" or "output". Otherwise, the number of its
// copies, if it has several.
std::string part_of(const Drive& drive, std::size_t body) {
  if (drive.graph.is_input(body)) return "input";
  if (drive.graph.is_fixed(body)) return "held";
  if (drive.graph.output == body) return "output";
  return drive.graph.bodies[body].count > 1 ? fmt::format("× {}", drive.graph.bodies[body].count)
                                            : "";
}

std::string body_listing(const Drive& drive) {
  const bool powered = drive.flow && !drive.flow->self_locking();
  const auto& torque = drive.graph.torque_Nm;
  bool racks = false;
  std::string out =
      fmt::format("\nBodies\n  {:<14}{:<8}{:>16}{:>14}{:>14}{:>12}{:>14}\n", "", "", "speed ratio",
                  "", "in its frame", "1/min", torque ? "torque N m" : "torque ratio");
  for (std::size_t b = 0; b < drive.graph.bodies.size(); ++b) {
    const bool one = drive.graph.inputs.size() == 1;
    const double t = powered ? drive.flow->torque[b] * torque.value_or(1.0) : 0.0;
    const bool rack = drive.graph.moves(b);
    const auto v = drive.linear_speed(b), force = drive.force(b);
    const std::string speed = !rack ? number(drive.speed_rpm(b), 2)
                              : v   ? fmt::format("{:.4f} m/s", *v)
                                    : kAbsent;
    const std::string load = rack ? force ? fmt::format("{:.2f} N", *force) : kAbsent
                             : powered && t != 0.0 ? fixed_decimals(t, 4)
                                                   : kAbsent;
    out += fmt::format("  {:<14}{:<8}{:>16}{:>14}{:>14}{:>12}{:>14}\n",
                       printable(drive.graph.bodies[b].name, 13), part_of(drive, b),
                       number(drive.speed_ratio(b), 6),
                       one ? fraction(drive.motion.speeds[b][0]) : kAbsent,
                       number(drive.relative_speed_ratio(b), 6), speed, load);
    racks = racks || rack;
  }
  if (racks) out += "  The speed ratio of a rack is in pitches per turn of the input.\n";
  return out;
}

std::string mesh_listing(const Drive& drive, UnitSystem units) {
  const bool powered = drive.flow && !drive.flow->self_locking();
  const auto head = [&](const char* what) {
    return fmt::format("{} {}", what, unit_text(units, Unit::mm));
  };
  const auto length = [&](const std::optional<double>& mm) {
    return mm ? text_in(units, Unit::mm, *mm, 4) : std::string(kAbsent);
  };
  std::string out =
      fmt::format("\nMeshes\n  {:<18}{:>14}{:>12}{:>12}{:>12}{:>14}{:>12}{:>10}\n", "",
                  "teeth/turn", "Hz", "η", "P_m/P_in", head("a"), "ε_γ", head("j_n"));
  const auto n = drive.speed_rpm(drive.graph.inputs.front());
  for (std::size_t m = 0; m < drive.graph.meshes.size(); ++m) {
    const auto& pair = drive.geometry.pairs[m];
    const auto teeth = drive.frequency_ratio(m);
    const auto& eta = drive.efficiencies[m];
    const auto& rack = drive.geometry.racks[m];
    std::optional<double> power, backlash, ratio;
    if (powered && drive.flow->power_in > 0.0)
      power = drive.flow->mesh_power[m] / drive.flow->power_in;
    if (pair && pair->involute()) backlash = pair->normal_backlash();
    if (rack) backlash = rack->normal_backlash();
    if (pair) ratio = pair->contact_ratio();
    if (rack) ratio = rack->transverse_contact_ratio() + rack->overlap_ratio;
    out += fmt::format("  {:<18}{:>14}{:>12}{:>12}{:>12}{:>14}{:>12}{:>10}\n",
                       printable(drive.graph.meshes[m].name, 17), number(teeth, 5),
                       teeth && n ? fixed_decimals(*teeth * std::abs(*n) / 60, 3) : kAbsent,
                       eta ? fixed_decimals(eta->first_drives, 5) : kAbsent, number(power, 4),
                       length(drive.geometry.distance[m]), number(ratio, 3), length(backlash));
  }
  return out;
}

std::string shift_listing(const Drive& drive) {
  std::string list;
  for (std::size_t g = 0; g < drive.graph.gears.size(); ++g)
    if (const auto& x = drive.geometry.shift[g])
      list += fmt::format("{}{} {}", list.empty() ? "" : ", ", drive.graph.gears[g].name,
                          fixed_decimals(*x, 5));
  return list.empty() ? "" : "\nProfile shifts: " + list + "\n";
}

std::string set_listing(const PlanetSet& set, UnitSystem units) {
  return "\nPlanets\n" +
         quantity_listing(units, assembly_quantities().table(), {assembly_quantities().of(set)},
                          {}) +
         "\nPhases\n" +
         quantity_listing(units, phasing_quantities().table(), {phasing_quantities().of(set)}, {});
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

// A sentence with the K_γ of the rating and the K_γ of the planets under load, which may differ.
std::string load_factor_sentence(const Drive& drive) {
  const auto computed = mesh_load_factor(drive), rated = rated_mesh_load_factor(drive);
  if (!computed || !rated) return "";
  return fmt::format("  The rating uses K_γ = {}; the planets under this load have K_γ = {}.\n",
                     fixed_decimals(*rated, 3), fixed_decimals(*computed, 3));
}

std::string load_listing(const Drive& drive, UnitSystem units) {
  if (!drive.loaded) return "";
  std::string out = "\nUnder load\n" + quantity_listing(units, drive_load_quantities().table(),
                                                        {drive_load_quantities().of(drive)}, {});
  for (const PlanetShares& shares : drive.loaded->sets) {
    const std::size_t carrier = drive.sets[shares.set].group.carrier;
    out += fmt::format("\nPlanets of {} under load\n", printable(drive.graph.bodies[carrier].name));
    out += quantity_listing(units, planet_share_quantities().table(),
                            {planet_share_quantities().of({&drive, &shares})}, {});
  }
  return out + load_factor_sentence(drive);
}

std::string safety_listing(const Drive& drive) {
  std::string out =
      fmt::format("\nStrength by ISO 6336\n  {:<18}{:>14}{:>12}{:>10}{:>10}{:>10}{:>10}\n", "",
                  "T1 N m", "n1 1/min", "S_H1", "S_H2", "S_F1", "S_F2");
  for (std::size_t m = 0; m < drive.ratings.size(); ++m) {
    const auto& r = drive.ratings[m];
    const auto safety = [&](const FactorPair& s, std::size_t i) {
      return r ? fixed_decimals(s[i].value, 3) : std::string(kAbsent);
    };
    if (!r) continue;
    out += fmt::format(
        "  {:<18}{:>14}{:>12}{:>10}{:>10}{:>10}{:>10}\n", printable(drive.graph.meshes[m].name, 17),
        fixed_decimals(r->input.torque, 3), number(r->input.speed, 2), safety(r->rating.S_H, 0),
        safety(r->rating.S_H, 1), safety(r->rating.S_F, 0), safety(r->rating.S_F, 1));
  }
  return out;
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
  return answer;
}

}  // namespace

std::string drive_listing(const Drive& drive, UnitSystem units) {
  std::string out =
      quantity_listing(units, drive_quantities().table(), {drive_quantities().of(drive)}, {});
  if (drive.motion.ratio && !drive.motion.ratio->whole())
    out += "  exact ratio " + fraction(*drive.motion.ratio) + "\n";
  if (!drive.ratings.empty()) out += safety_listing(drive);
  out += load_listing(drive, units);
  out += body_listing(drive) + mesh_listing(drive, units) + shift_listing(drive);
  for (const PlanetSet& set : drive.sets) out += set_listing(set, units);
  return out;
}

Result<Answer> answer_drive(const JobSpec& spec, Progress* progress) {
  const auto solved = with_load(solve_drive(spec), progress);
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

Result<Answer> answer_drive_rating(const JobSpec& spec, Progress* progress) {
  return answer_of(spec, with_load(solve_rated_drive(spec), progress),
                   [](const Drive& drive, UnitSystem units) {
                     return safety_listing(drive) + load_listing(drive, units) +
                            body_listing(drive) + mesh_listing(drive, units);
                   });
}

namespace {

// The tables of a drive's spec that also apply to each of its meshes.
constexpr const char* kShared[] = {"errors", "contact", "drawing", "scatter"};

Json gear_table(const DriveJob& job, const Json& expanded, std::size_t gear) {
  Json table = expanded["drive"]["gear"][gear];
  table.erase("name");
  table.erase("body");
  if (job.drive.graph.gears[gear].rack) {  // the teeth are in the table of its pinion
    Json bar = Json::object();
    for (const auto& [key, value] : table.items())
      if (rack_bar_keys().find(key)) bar[key] = value;
    return bar;
  }
  // The addition replaces −0 by 0.
  if (table.contains("helix_angle_deg"))
    table["helix_angle_deg"] = table["helix_angle_deg"].get<double>() + 0.0;
  const auto& solved = job.drive.geometry.gears[gear];
  if (!solved || !solved->involute() || table.contains("basic")) return table;
  table.erase("profile_shift_pair");
  table["profile_shift"] = solved->spec.profile_shift;
  const bool round = solved->spec.root_fillet || solved->spec.tip_fillet;
  if (!round && !table.contains("tip_diameter_mm")) table["tip_diameter_mm"] = solved->tip_diameter;
  return table;
}

// The load of a mesh in the rating of a drive, and how often its flanks engage.
struct RatedLoad {
  RatingInput input;
  std::array<FlankUse, 2> use;
};

// The table [rating] for one mesh. Its load is the load of one copy of the mesh. Its life and its
// reversed bending apply to the gear with the more severe use.
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
  if (!rack && drive.graph.friction > 0.0) pair["friction_coefficient"] = drive.graph.friction;
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
      fmt::format("This pair is the mesh {} of the drive. Numbers have all their digits, so that "
                  "the results of the pair and of the drive agree to the last bit.",
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
            fmt::format("The flanks of the gears engage {} and {} times per turn; life_h and "
                        "reversed in [rating] apply to the gear with the more severe use.",
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
  if (spec["pair"].empty()) spec.erase("pair");  // `pair` is invalid after other tables were added
  return {std::move(spec), std::move(notes)};
}

}  // namespace gearwright
