#include "gearwright/job/drive_answer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "gearwright/base/printable.hpp"
#include "gearwright/catalogue/drive_quantities.hpp"
#include "gearwright/job/csv_answer.hpp"
#include "gearwright/job/drive_job.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/mesh_spec.hpp"
#include "gearwright/job/result_json.hpp"
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

// The function of a body in the drive, "input" or "held", or the number of its copies.
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

}  // namespace gearwright
