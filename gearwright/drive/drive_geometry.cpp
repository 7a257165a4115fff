#include "gearwright/drive/drive_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/subject.hpp"
#include "gearwright/drive/geometry_remedy.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/math/involute.hpp"
#include "gearwright/pair/clearances.hpp"
#include "gearwright/pair/shift.hpp"

namespace gearwright {

namespace {

using Fault = GeometryFault;

// True if the tooth data of both gears of a mesh are known, not only the numbers of teeth.
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

// How a gear of a drive is made. A ring without a given tip diameter first gets no cutter, because
// its tip diameter follows from its mating gears.
enum class Teeth { cut, without_cutter };

// Makes a gear of a drive. If the gear is double-helical, the result is one half.
void make_drive_gear(const DriveGraph& graph, std::size_t g, std::optional<double> tip_diameter,
                     DriveGeometry& made, Teeth how = Teeth::cut) {
  const DriveGear& gear = graph.gears[g];
  CylindricalSpec spec = *gear.spec;
  spec.teeth = gear.teeth;
  spec.profile_shift = *made.shift[g];
  if (tip_diameter) spec.tip_diameter = tip_diameter;
  if (!(spec.face_width > 0)) spec.face_width = 10 * spec.normal_module;
  if (gear.double_helical) spec.face_width = (spec.face_width - gear.double_helical->gap) / 2;
  auto teeth = how == Teeth::cut ? make_gear_with_default_cutter(spec) : make_gear(spec);
  made.gears[g].reset();
  if (!teeth) {
    const bool of_half =
        gear.double_helical && subject_of(teeth.error().field).member == GearMember::face_width;
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

// Mounts the racks, and sets the centre distances of their meshes.
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

// True if the tip diameter follows from the generating rack and may therefore be changed.
bool free_tip(const DriveGear& gear) {
  return gear.spec && !gear.spec->tip_diameter && !gear.spec->tip_fillet;
}

// Mounts the gears after all tip diameters are known, because mounting includes a search for
// collisions. The tip diameters are found from the meshes of the flanks.
class MeshMounting {
 public:
  MeshMounting(const DriveGraph& graph, DriveGeometry& made)
      : graph_(graph), made_(made), meshes_(graph.meshes.size()) {}

  void mount_all() {
    for (std::size_t g = 0; g < graph_.gears.size(); ++g)
      if (graph_.gears[g].spec && made_.shift[g])
        make_drive_gear(graph_, g, std::nullopt, made_,
                        is_open_ring(g) ? Teeth::without_cutter : Teeth::cut);
    for (std::size_t m = 0; m < meshes_.size(); ++m) find_mesh(m);
    cut_back_tips();
    turn_out_rings();
    for (std::size_t m = 0; m < meshes_.size(); ++m)
      if (meshes_[m]) mount_mesh(graph_, m, made_);
  }

 private:
  bool is_open_ring(std::size_t g) const {
    return graph_.gears[g].is_ring() && free_tip(graph_.gears[g]);
  }
  std::array<const Gear*, 2> gears_of(std::size_t m) const {
    const auto& [one, two] = graph_.meshes[m].gears;
    return {&*made_.gears[one], &*made_.gears[two]};
  }

  // Computes the mesh of two involute gears. If there is no such mesh, calls mount_mesh(), which
  // mounts pairs of other teeth and reports why a pair cannot be mounted.
  void find_mesh(std::size_t m) {
    meshes_[m].reset();
    const auto& [one, two] = graph_.meshes[m].gears;
    if (!made_.gears[one] || !made_.gears[two] || !made_.distance[m]) return;
    const auto [g1, g2] = gears_of(m);
    if (g1->involute() && g2->involute()) {
      const auto place = involute_place(*g1, *g2, {.center_distance = made_.distance[m]});
      if (place && !place->shaft_angle) {
        const MeshInput<double> input = mesh_input(*g1, *g2, *place);
        const double least = base_radius_sum(input.gears), a = place->center_distance;
        if (a > least && a <= kMaxDistance * least) meshes_[m] = mesh_of(input);
      }
    }
    if (!meshes_[m]) mount_mesh(graph_, m, made_);
  }

  // With large shifts, the centre distance is less than a_d + (x1 + x2) m_n, so the tip clearance
  // is less than the clearance of the generating racks. If the verdict requires a greater tip
  // clearance, the tip is lowered by k m_n, which restores the clearance of the racks.
  void cut_back_tips() {
    constexpr double kLeast = 0.1;  // m_n, the tip clearance that the verdict requires
    for (std::size_t m = 0; m < meshes_.size(); ++m) {
      for (const std::size_t side : {0, 1}) {
        const std::size_t g = graph_.meshes[m].gears[side];
        if (!meshes_[m] || graph_.gears[g].is_ring() || !free_tip(graph_.gears[g])) continue;
        const auto [g1, g2] = gears_of(m);
        const double a = *made_.distance[m];
        const auto clearance =
            tip_clearances({g1->actual_tip_radius(), g2->actual_tip_radius()},
                           {g1->root_diameter / 2, g2->root_diameter / 2}, a, g2->side());
        if (!(clearance[side] < kLeast * graph_.gears[g].spec->normal_module)) continue;
        const double lower = g2->side() * (a - extended_center_distance(*g1, *g2));
        if (!(lower < 0.0)) continue;
        make_drive_gear(graph_, g, made_.gears[g]->tip_diameter + 2 * lower, made_);
        for (std::size_t n = 0; n < meshes_.size(); ++n)
          if (graph_.meshes[n].gears[0] == g || graph_.meshes[n].gears[1] == g) find_mesh(n);
      }
    }
  }

  // The tips of a ring with the full addendum of its rack often reach beyond the root ends of the
  // flanks of its mating gears. If no tip diameter is given, the tips are therefore cut back so
  // that they touch these flanks only.
  void turn_out_rings() {
    constexpr double kClear = 0.02;  // m_n, in radius: twice the margin that the verdict requires
    for (std::size_t g = 0; g < graph_.gears.size(); ++g) {
      if (!is_open_ring(g) || !made_.gears[g]) continue;
      std::optional<double> tip;
      for (std::size_t m = 0; m < meshes_.size(); ++m) {
        if (graph_.meshes[m].gears[1] != g || !meshes_[m]) continue;
        const double clear = kClear * graph_.gears[g].spec->normal_module;
        const auto least = tip_that_clears(gears_of(m), *meshes_[m], 2, clear);
        if (least && (!tip || *least > *tip)) tip = least;
      }
      if (tip && !(*tip < made_.gears[g]->root_diameter)) tip.reset();
      make_drive_gear(graph_, g, tip, made_);
    }
  }

  const DriveGraph& graph_;
  DriveGeometry& made_;
  std::vector<std::optional<Mesh<double>>> meshes_;  // none if mounted at once, or not at all
};

}  // namespace

std::optional<Error> check_distances(const DriveGraph& graph) {
  constexpr double kSame = 1e-6;  // mm; a rounding error, far below any tolerance
  for (const auto& meshes : distance_classes(graph)) {
    const DriveMesh* first = nullptr;
    for (const std::size_t m : meshes) {
      const DriveMesh& mesh = graph.meshes[m];
      if (!mesh.center_distance) continue;
      if (!first) first = &mesh;
      if (std::abs(*mesh.center_distance - *first->center_distance) <= kSame) continue;
      return refused(
          fmt::format("drive.mesh[\"{}\"].center_distance", mesh.name), *mesh.center_distance,
          fmt::format("contradicts the centre distance of {} mm that is given for the mesh {}, "
                      "because the axis of a planet has the same distance from all coaxial gears; "
                      "leave out one of the two",
                      format_number(*first->center_distance, *mesh.center_distance), first->name));
    }
  }
  return std::nullopt;
}

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
  MeshMounting(graph, made).mount_all();
  mount_racks(graph, made);
  return made;
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

// Returns the ratio of thickness to pitch on the circle with the pressure angle α_wt.
double thickness_share_at(const Gear& gear, double alpha_wt) {
  const auto& reference = gear.reference();
  return 0.5 +
         (2 * reference.generating_profile_shift * std::tan(gear.spec.normal_pressure_angle.rad()) +
          gear.spec.teeth * (involute(reference.transverse_pressure_angle) - involute(alpha_wt))) /
             std::numbers::pi;
}

}  // namespace

double thickness_share(const InvolutePair& pair, int which) {
  const std::size_t side = which - 1;
  return thickness_share_at(pair.gears[side], std::acos(pair.input.gears[side].radius /
                                                        pair.mesh.rack.sides[side].pitch_radius));
}

double thickness_share(const RackPair& pair) {
  return thickness_share_at(pair.pinion, pair.pinion.reference().transverse_pressure_angle);
}

}  // namespace gearwright
