#include "gearwright/drive/drive_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/subject.hpp"
#include "gearwright/drive/geometry_remedy.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/math/involute.hpp"
#include "gearwright/pair/clearances.hpp"
#include "gearwright/pair/shift.hpp"

namespace gearwright {

namespace {

using Fault = GeometryFault;

// True if the tooth data of both gears of a mesh are known. The numbers of teeth alone are not
// enough.
bool has_teeth(const DriveGraph& graph, const DriveMesh& mesh) {
  return graph.gear(mesh, 0).spec && graph.gear(mesh, 1).spec;
}

// Returns the profile shift of a gear before absent shifts are computed. A circular-arc gear
// without a given shift has the shift 0, because the position of its arcs determines the depth of
// its teeth.
std::optional<double> known_shift(const DriveGear& gear) {
  const bool arcs = gear.spec && !is_straight(gear.spec->rack);
  return arcs ? gear.shift.value_or(0.0) : gear.shift;
}

ShiftProblem shift_problem(const DriveGraph& graph, const DriveMesh& mesh,
                           const DriveGeometry& made) {
  const DriveGear& a = graph.gear(mesh, 0);
  const DriveGear& b = graph.gear(mesh, 1);
  ShiftProblem problem;
  problem.z1 = a.teeth;
  problem.z2 = b.teeth;
  problem.normal_module = a.spec->normal_module;
  problem.normal_pressure_angle = a.spec->normal_pressure_angle;
  problem.helix_angle = {a.spec->helix_angle, b.spec->helix_angle};
  problem.x1 = made.shift[mesh.gears[0]];
  problem.x2 = made.shift[mesh.gears[1]];
  return problem;
}

class Completion {
 public:
  Completion(const DriveGraph& graph, DriveGeometry& made) : graph_(graph), made_(made) {}

  void of_class(std::vector<std::size_t> meshes) {
    std::erase_if(meshes, [&](std::size_t m) { return !has_teeth(graph_, graph_.meshes[m]); });
    if (meshes.empty()) return;
    std::optional<double> distance;
    for (const std::size_t m : meshes)
      if (!distance) distance = graph_.meshes[m].center_distance;
    if (!distance) {
      const DriveMesh& first = graph_.meshes[meshes.front()];
      for (const std::size_t g : first.gears) made_.shift[g] = made_.shift[g].value_or(0.0);
      const auto solved = complete_shifts(shift_problem(graph_, first, made_));
      if (!solved) return fault(first, solved.error());
      distance = solved->center_distance;
    }
    while (!meshes.empty()) {
      const auto next = std::min_element(meshes.begin(), meshes.end(),
                                         [&](auto m, auto n) { return unknowns(m) < unknowns(n); });
      complete(*next, *distance);
      meshes.erase(next);
    }
  }

 private:
  // Returns the number of unknown shifts of a mesh. Meshes with two unknown shifts are completed
  // last, because another mesh may determine one of these shifts.
  int unknowns(std::size_t m) const {
    int count = 0;
    for (const std::size_t g : graph_.meshes[m].gears) count += made_.shift[g] ? 0 : 1;
    return count;
  }

  void complete(std::size_t m, double distance) {
    const DriveMesh& mesh = graph_.meshes[m];
    made_.distance[m] = distance;
    if (unknowns(m) == 0) return;
    ShiftProblem problem = shift_problem(graph_, mesh, made_);
    problem.center_distance = distance;
    const auto solved = complete_shifts(problem);
    if (!solved && mesh.center_distance) return fault(mesh, solved.error());
    if (!solved) {
      made_.faults.push_back(
          {Fault::Kind::not_coaxial,
           fmt::format("No profile shift is possible for the mesh {} at the centre distance of "
                       "{:.4f} mm, which the other meshes of the planet determine.",
                       mesh.name, distance)});
      return;
    }
    made_.shift[mesh.gears[0]] = solved->x1;
    made_.shift[mesh.gears[1]] = solved->x2;
  }

  void fault(const DriveMesh& mesh, const Error& error) {
    made_.faults.push_back(
        {Fault::Kind::not_coaxial,
         fmt::format("No profile shift is possible for the mesh {} at its centre distance: {}.",
                     mesh.name, error.rule)});
  }

  const DriveGraph& graph_;
  DriveGeometry& made_;
};

// Makes a gear of a drive. For a double-helical gear, the function makes one half.
void make_drive_gear(const DriveGraph& graph, std::size_t g, std::optional<double> tip_diameter,
                     DriveGeometry& made) {
  const DriveGear& gear = graph.gears[g];
  CylindricalSpec spec = *gear.spec;
  spec.teeth = gear.teeth;
  spec.profile_shift = *made.shift[g];
  if (tip_diameter) spec.tip_diameter = tip_diameter;
  if (!(spec.face_width > 0)) spec.face_width = 10 * spec.normal_module;
  if (gear.double_helical) spec.face_width = (spec.face_width - gear.double_helical->gap) / 2;
  auto teeth = make_gear_with_default_cutter(spec);
  made.gears[g].reset();
  if (!teeth) {
    const bool of_half = gear.double_helical && teeth.error().field == "face_width";
    made.faults.push_back(
        {Fault::Kind::no_gear,
         fmt::format(
             "The teeth of {} cannot be made: {}{}.", gear.name,
             of_half ? fmt::format("beside the gap of {} mm, each half has ",
                                   format_number(gear.double_helical->gap, gear.spec->face_width))
                     : std::string(),
             teeth.error().quoted())});
    return;
  }
  made.gears[g] = std::move(teeth).take();
  made.gears[g]->bore = gear.bore;
  if (gear.double_helical) made.gears[g]->gap = gear.double_helical->gap;
}

void mount_mesh(const DriveGraph& graph, std::size_t m, DriveGeometry& made) {
  const DriveMesh& mesh = graph.meshes[m];
  const auto& one = made.gears[mesh.gears[0]];
  const auto& two = made.gears[mesh.gears[1]];
  if (!one || !two || !made.distance[m]) return;
  auto pair =
      mount(*one, *two,
            {made.distance[m], std::nullopt, mesh.friction.value_or(graph.friction), std::nullopt});
  if (pair) {
    made.pairs[m] = std::move(pair).take();
  } else {
    std::string why = pair.error().rule;
    while (why.ends_with('.')) why.pop_back();
    const bool given = known_shift(graph.gear(mesh, 0)) && known_shift(graph.gear(mesh, 1));
    made.faults.push_back(
        {Fault::Kind::no_pair,
         fmt::format("{} the mesh {} at a centre distance of {:.4f} mm{} profile shifts of {:.4f} "
                     "and {:.4f}: {}.",
                     given ? "It is impossible to mount" : "No teeth are possible for", mesh.name,
                     *made.distance[m], given ? " with" : ", which would require",
                     *made.shift[mesh.gears[0]], *made.shift[mesh.gears[1]], why)});
  }
}

// Returns the reason why a rack and its pinion cannot be mounted. The text names the gear of the
// drive instead of "gear1" or "gear2".
std::string reason_of_rack(const DriveGraph& graph, const DriveMesh& mesh, Error error) {
  const bool of_rack = subject_of(error.field).gear == 2;
  const std::string& name = graph.gear(mesh, of_rack ? 1 : 0).name;
  while (error.rule.ends_with('.')) error.rule.pop_back();
  const std::size_t dot = error.field.find('.');
  if (dot == std::string::npos) return fmt::format("{} {}", name, error.rule);
  error.field.erase(0, dot + 1);
  return fmt::format("{}: {}", name, error.quoted());
}

// Mounts the racks. If the shift of a pinion is not given, it is 0.
void mount_racks(const DriveGraph& graph, DriveGeometry& made) {
  for (std::size_t m = 0; m < graph.meshes.size(); ++m) {
    const DriveMesh& mesh = graph.meshes[m];
    const auto& bar = graph.gear(mesh, 1).rack;
    const auto& pinion = made.gears[mesh.gears[0]];
    if (!bar || !pinion) continue;
    auto pair =
        mount_rack(*pinion, *bar, mesh.center_distance, {}, mesh.friction.value_or(graph.friction));
    if (pair) {
      made.racks[m] = std::move(pair).take();
      made.distance[m] = made.racks[m]->center_distance;
    } else {
      made.faults.push_back(
          {Fault::Kind::no_pair, fmt::format("The mesh {} cannot be mounted: {}.", mesh.name,
                                             reason_of_rack(graph, mesh, pair.error()))});
    }
  }
}

// Makes the teeth of a gear again with the given tip diameter, and mounts its meshes again.
void turn_tip(const DriveGraph& graph, std::size_t g, double tip_diameter, DriveGeometry& made) {
  make_drive_gear(graph, g, tip_diameter, made);
  for (std::size_t m = 0; m < graph.meshes.size(); ++m)
    if (graph.meshes[m].gears[0] == g || graph.meshes[m].gears[1] == g) mount_mesh(graph, m, made);
}

// True if the generating rack determines the tip diameter of a gear. The tip diameter may then be
// changed.
bool free_tip(const DriveGraph& graph, std::size_t g, const DriveGeometry& made) {
  const DriveGear& gear = graph.gears[g];
  return made.gears[g] && !gear.spec->tip_diameter && !gear.spec->tip_fillet;
}

// With large shifts, the centre distance is less than a_d + (x1 + x2) m_n, so the tip clearance is
// less than that of the generating racks. If this tip clearance is too small for the verdict, the
// function lowers the tip by k m_n. This restores the tip clearance of the racks.
void cut_back_tips(const DriveGraph& graph, DriveGeometry& made) {
  constexpr double kLeast = 0.1;  // m_n, the tip clearance that the verdict requires
  for (std::size_t m = 0; m < graph.meshes.size(); ++m) {
    for (const std::size_t side : {0, 1}) {
      const std::size_t g = graph.meshes[m].gears[side];
      const ParallelPair* pair = made.involutes(m);
      if (!pair || graph.gears[g].is_ring() || !free_tip(graph, g, made)) continue;
      const double module = graph.gears[g].spec->normal_module;
      const double lower = pair->tip_shortening;
      if (pair->tip_clearance[side] < kLeast * module && lower < 0.0)
        turn_tip(graph, g, made.gears[g]->tip_diameter + 2 * lower, made);
    }
  }
}

// If the tips of a ring have the full addendum of its rack, they often extend beyond the root ends
// of the flanks of the mating gears. If no tip diameter is given, the tips are therefore cut back
// until they touch only these flanks.
void turn_out_rings(const DriveGraph& graph, DriveGeometry& made) {
  constexpr double kClear = 0.02;  // m_n, in radius: twice the margin that the verdict requires
  for (std::size_t g = 0; g < graph.gears.size(); ++g) {
    const DriveGear& gear = graph.gears[g];
    if (!gear.is_ring() || !free_tip(graph, g, made)) continue;
    std::optional<double> tip;
    for (std::size_t m = 0; m < graph.meshes.size(); ++m) {
      const ParallelPair* pair = made.involutes(m);
      if (graph.meshes[m].gears[1] != g || !pair) continue;
      const auto least = tip_that_clears(*pair, 2, kClear * gear.spec->normal_module);
      if (least && (!tip || *least > *tip)) tip = least;
    }
    if (tip && *tip < made.gears[g]->root_diameter) turn_tip(graph, g, *tip, made);
  }
}

// The position of a rider in the frame of the carrier, and the greatest tip diameter of its gears.
struct Rider {
  double distance, angle, tip_diameter;
};

std::optional<double> distance_between(const DriveGraph& graph, const PlanetGroup& group,
                                       const std::vector<std::optional<double>>& distances,
                                       std::size_t a, std::optional<std::size_t> b) {
  for (const std::size_t m : group.meshes) {
    const std::size_t one = graph.gear(graph.meshes[m], 0).body;
    const std::size_t two = graph.gear(graph.meshes[m], 1).body;
    const auto other = one == a ? std::optional(two) : two == a ? std::optional(one) : std::nullopt;
    if (!other) continue;
    const bool matches = b ? *other == *b : !graph.bodies[*other].carrier;
    if (matches) return distances[m];
  }
  return std::nullopt;
}

std::optional<std::vector<Rider>> place_riders(const DriveGraph& graph, const PlanetGroup& group,
                                               const DriveGeometry& geometry,
                                               std::optional<Fault>& fault) {
  const auto places = rider_places(graph, group, geometry.distance, fault);
  if (!places) return std::nullopt;
  std::vector<Rider> riders;
  for (std::size_t i = 0; i < group.riders.size(); ++i) {
    double tip = 0.0;
    for (std::size_t g = 0; g < graph.gears.size(); ++g) {
      if (graph.gears[g].body != group.riders[i]) continue;
      if (!geometry.gears[g]) return std::nullopt;
      tip = std::max(tip, geometry.gears[g]->tip_diameter);
    }
    riders.push_back({(*places)[i].distance, (*places)[i].angle, tip});
  }
  return riders;
}

double tip_gap(const Rider& a, const Rider& b, double turned) {
  const double angle = b.angle + turned - a.angle;
  // The distance of two points in polar coordinates, in a form with little cancellation. For equal
  // radii, the distance is 2 a sin(Δ/2).
  const double half = std::sin(angle / 2);
  const double d = a.distance - b.distance;
  const double between = std::sqrt(d * d + 4 * a.distance * b.distance * half * half);
  return between - (a.tip_diameter + b.tip_diameter) / 2;
}

// Returns the least gap between the tips of planet bodies of different copies.
double least_gap_of(const std::vector<Rider>& riders, const std::vector<double>& turned) {
  double least = kInfinity;
  for (std::size_t i = 0; i < turned.size(); ++i)
    for (std::size_t j = i + 1; j < turned.size(); ++j)
      for (const Rider& a : riders)
        for (const Rider& b : riders) least = std::min(least, tip_gap(a, b, turned[j] - turned[i]));
  return least;
}

}  // namespace

DriveGeometry drive_geometry(const DriveGraph& graph) {
  DriveGeometry made;
  made.distance.resize(graph.meshes.size());
  made.pairs.resize(graph.meshes.size());
  made.racks.resize(graph.meshes.size());
  made.gears.resize(graph.gears.size());
  for (const DriveGear& gear : graph.gears) made.shift.push_back(known_shift(gear));
  Completion completion(graph, made);
  for (const auto& meshes : distance_classes(graph)) completion.of_class(meshes);
  for (const DriveMesh& mesh : graph.meshes)
    if (auto& shift = made.shift[mesh.gears[0]]; graph.gear(mesh, 1).rack && !shift) shift = 0.0;
  for (std::size_t g = 0; g < graph.gears.size(); ++g)
    if (graph.gears[g].spec && made.shift[g]) make_drive_gear(graph, g, std::nullopt, made);
  for (std::size_t m = 0; m < graph.meshes.size(); ++m) mount_mesh(graph, m, made);
  cut_back_tips(graph, made);
  turn_out_rings(graph, made);
  mount_racks(graph, made);
  return made;
}

std::optional<std::vector<RiderPlace>> rider_places(
    const DriveGraph& graph, const PlanetGroup& group,
    const std::vector<std::optional<double>>& distances, std::optional<GeometryFault>& fault) {
  std::vector<RiderPlace> riders;
  // The angle of each planet body after the first one follows from a triangle. The corners of the
  // triangle are the axes of the carrier, of this body, and of a body whose angle is known.
  for (std::size_t i = 0; i < group.riders.size(); ++i) {
    const std::size_t body = group.riders[i];
    const auto a = distance_between(graph, group, distances, body, std::nullopt);
    if (!a) return std::nullopt;
    double angle = 0.0;
    for (std::size_t j = 0; j < i; ++j) {
      const auto between = distance_between(graph, group, distances, body, group.riders[j]);
      if (!between) continue;
      const double r = riders[j].distance;
      const double cosine = (*a * *a + r * r - *between * *between) / (2 * *a * r);
      if (!(std::abs(cosine) <= 1.0)) {
        fault = {Fault::Kind::not_coaxial,
                 fmt::format("{} and {} have no possible place on {}, because no triangle has the "
                             "sides {:.4f} mm, {:.4f} mm and {:.4f} mm.",
                             graph.bodies[body].name, graph.bodies[group.riders[j]].name,
                             graph.bodies[group.carrier].name, *a, r, *between)};
        return std::nullopt;
      }
      // The idler is counter-clockwise from its planet.
      angle = riders[j].angle + std::acos(cosine);
      break;
    }
    riders.push_back({*a, angle});
  }
  return riders;
}

std::optional<Neighbours> neighbours(const DriveGraph& graph, const PlanetGroup& group,
                                     const DriveGeometry& geometry, const Assembly& assembly,
                                     std::optional<GeometryFault>& fault) {
  const auto riders = place_riders(graph, group, geometry, fault);
  if (!riders) return std::nullopt;
  Neighbours found{kInfinity, 1};
  std::vector<double> turned;
  for (const Rational& u : assembly.turns) turned.push_back(2 * std::numbers::pi * u.value());
  found.clearance = least_gap_of(*riders, turned);
  constexpr int kMost = 1000;  // greatest number of planets that is tried
  for (int n = 2; n <= kMost; ++n) {
    turned.clear();
    for (int i = 0; i < n; ++i) turned.push_back(2 * std::numbers::pi * i / n);
    // At equal pitch, every distance between two copies is also the distance of some copy from copy
    // 0.
    double gap = kInfinity;
    for (int i = 1; i < n; ++i)
      for (const Rider& a : *riders)
        for (const Rider& b : *riders)
          gap = std::min(gap, tip_gap(a, b, turned[static_cast<std::size_t>(i)]));
    if (gap < 0.0) break;
    found.most = n;
  }
  return found;
}

std::optional<StatedBacklash> DriveGeometry::stated_backlash(std::size_t mesh) const {
  if (racks[mesh]) return racks[mesh]->stated_backlash();
  return pairs[mesh] ? std::optional(pairs[mesh]->stated_backlash()) : std::nullopt;
}

bool DriveGeometry::touches(std::size_t mesh) const {
  if (racks[mesh]) return racks[mesh]->true_contact_ratio() > 0.0;
  return pairs[mesh] && pairs[mesh]->contact_ratio_true() > 0.0;
}

std::optional<double> transverse_base_backlash(const DriveGeometry& geometry, std::size_t mesh) {
  const auto along = [](double normal_base, const Gear& first) {
    return normal_base / std::cos(first.reference().base_helix_angle);
  };
  if (const auto& rack = geometry.racks[mesh]) return along(rack->base_backlash(), rack->pinion);
  const ParallelPair* pair = geometry.involutes(mesh);
  if (!pair) return std::nullopt;
  return along(pair->mesh.backlash.normal_base, pair->gears[0]);
}

namespace {

// Returns the ratio of tooth thickness to pitch on the circle with the transverse pressure angle
// α_wt.
double thickness_share_at(const Gear& gear, double alpha_wt) {
  const auto& reference = gear.reference();
  return 0.5 +
         (2 * reference.generating_profile_shift * std::tan(gear.spec.normal_pressure_angle.rad()) +
          gear.spec.teeth * (involute(reference.transverse_pressure_angle) - involute(alpha_wt))) /
             std::numbers::pi;
}

}  // namespace

double thickness_share(const InvolutePair& pair, int which) {
  const auto side = static_cast<std::size_t>(which - 1);
  return thickness_share_at(pair.gears[side], std::acos(pair.input.gears[side].radius /
                                                        pair.mesh.rack.sides[side].pitch_radius));
}

double thickness_share(const RackPair& pair) {
  return thickness_share_at(pair.pinion, pair.pinion.reference().transverse_pressure_angle);
}

}  // namespace gearwright
