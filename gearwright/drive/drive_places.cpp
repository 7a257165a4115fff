#include "gearwright/drive/drive_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "gearwright/base/lists.hpp"

namespace gearwright {

namespace {

constexpr double kCloses = 1e-6;  // allowed gap in a loop of shafts, relative to the distance

Vec2 polar(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

// Returns the axis of each body, as the least index of a body on this axis. The central gears that
// mesh with a planet are on the axis of the carrier of this planet.
std::vector<std::size_t> axes_of(const DriveGraph& graph) {
  std::vector<std::size_t> axis;
  for (std::size_t b = 0; b < graph.bodies.size(); ++b) axis.push_back(b);
  for (const DriveMesh& mesh : graph.meshes) {
    const auto frame = graph.frame(mesh);
    if (!frame) continue;
    for (const int side : {0, 1}) {
      const std::size_t body = graph.gear(mesh, side).body;
      if (graph.bodies[body].carrier) continue;
      const auto [low, high] = std::minmax(axis[body], axis[*frame]);
      std::replace(axis.begin(), axis.end(), std::size_t(high), std::size_t(low));
    }
  }
  return axis;
}

// True if the spec determines the positions of the two axes of a mesh without this mesh. They are
// determined for planets, for a single axis, if another mesh has the same two axes, and if meshes
// with given directions link the two axes.
bool has_determined_axes(const DriveGraph& graph, std::size_t mesh) {
  if (graph.frame(graph.meshes[mesh])) return true;
  const std::vector<std::size_t> axis = axes_of(graph);
  const auto ends = [&](std::size_t m) -> std::pair<std::size_t, std::size_t> {
    return std::minmax(axis[graph.gear(graph.meshes[m], 0).body],
                       axis[graph.gear(graph.meshes[m], 1).body]);
  };
  const auto own = ends(mesh);
  std::vector<std::size_t> linked = axis;
  for (std::size_t m = 0; m < graph.meshes.size(); ++m) {
    if (m == mesh || graph.frame(graph.meshes[m])) continue;
    const auto other = ends(m);
    if (other == own) return true;
    if (!graph.meshes[m].direction) continue;
    const std::size_t low = linked[other.first], high = linked[other.second];
    std::replace(linked.begin(), linked.end(), high, low);
  }
  return linked[own.first] == linked[own.second];
}

class Placing {
 public:
  explicit Placing(const Drive& drive) : drive_(drive), graph_(drive.graph) {}

  Result<DrivePlaces> places() {
    for (std::size_t g = 0; g < graph_.gears.size(); ++g) {
      const auto pinions = std::count_if(graph_.meshes.begin(), graph_.meshes.end(),
                                         [&](const DriveMesh& m) { return m.gears[1] == g; });
      if (graph_.gears[g].rack && pinions > 1)
        return Error{"drive.gear", graph_.gears[g].name,
                     fmt::format("is a rack with {} pinions, but the positions of the pinions "
                                 "along the rack are not known; files and pictures support only "
                                 "racks with one pinion",
                                 pinions)};
    }
    measure();
    axis_ = axes_of(graph_);
    if (auto error = place_axes()) return *error;
    if (auto error = place_riders()) return *error;
    find_slots();
    return std::move(made_);
  }

  /// What does not fit. Empty if places() has no error.
  const Misfit& misfit() const { return misfit_; }

 private:
  // If all meshes are mounted, the geometry gives the centre distances. Otherwise, the function
  // computes them from the numbers of teeth.
  void measure() {
    const DriveGeometry& geometry = drive_.geometry;
    made_.true_scale = true;
    for (std::size_t m = 0; m < graph_.meshes.size(); ++m)
      made_.true_scale = made_.true_scale && (geometry.pairs[m] || geometry.racks[m]);
    for (std::size_t m = 0; m < graph_.meshes.size(); ++m) {
      const int sum =
          graph_.gear(graph_.meshes[m], 0).teeth + graph_.gear(graph_.meshes[m], 1).teeth;
      distances_.push_back(made_.true_scale ? geometry.distance[m] : std::abs(sum) / 2.0);
    }
    for (std::size_t g = 0; g < graph_.gears.size(); ++g) {
      const int teeth = graph_.gears[g].teeth;
      if (graph_.gears[g].rack) {
        const RackPair* pair = rack_pair_of(drive_, g);
        made_.radii.push_back(made_.true_scale && pair ? pair->rack.addendum : 1.0);
        continue;
      }
      made_.radii.push_back(!made_.true_scale           ? std::abs(teeth) / 2.0 + 1.0
                            : graph_.gears[g].is_ring() ? geometry.gears[g]->root_diameter / 2
                                                        : geometry.gears[g]->tip_diameter / 2);
    }
  }

  const DriveGear& gear(std::size_t mesh, int which) const {
    return graph_.gear(graph_.meshes[mesh], which);
  }

  struct Link {
    std::size_t mesh, to;
  };
  // Returns the axes that meshes in the housing link with `axis`.
  std::vector<Link> links_of(std::size_t axis) const {
    std::vector<Link> links;
    for (std::size_t m = 0; m < graph_.meshes.size(); ++m) {
      if (graph_.frame(graph_.meshes[m])) continue;
      const std::size_t a = axis_[gear(m, 0).body], b = axis_[gear(m, 1).body];
      if (a == axis || b == axis) links.push_back({m, a == axis ? b : a});
    }
    return links;
  }

  std::optional<Error> place_axes() {
    made_.axes.assign(graph_.bodies.size(), Vec2::Zero());
    const std::size_t first = axis_[graph_.inputs.front()];
    std::vector<char> placed(graph_.bodies.size(), 0);
    std::vector<double> came(graph_.bodies.size(), 0.0);
    std::vector<Vec2> at(graph_.bodies.size(), Vec2::Zero());
    placed[first] = 1;
    for (std::deque<std::size_t> open{first}; !open.empty(); open.pop_front()) {
      const std::size_t from = open.front();
      std::vector<Link> fresh;
      for (const Link& link : links_of(from)) {
        if (link.to == from)
          return unmeet(link.mesh, "the two gears of this mesh turn about the same axis");
        if (!placed[link.to]) {
          fresh.push_back(link);
          placed[link.to] = 1;
        }
      }
      // A single following shaft continues the line. Several following shafts are placed at equal
      // angles, and none of them lies towards the previous shaft.
      const auto ways = static_cast<double>(fresh.size() + (from == first ? 0 : 1));
      for (std::size_t k = 0; k < fresh.size(); ++k) {
        const auto [mesh, to] = fresh[k];
        const double away = kTurn * static_cast<double>(k) / ways;
        const auto given = graph_.meshes[mesh].direction;
        const bool backwards = axis_[gear(mesh, 0).body] == to;
        came[to] = given           ? given->rad() + (backwards ? kTurn / 2 : 0.0)
                   : from == first ? away
                                   : came[from] + kTurn / 2 + away + kTurn / ways;
        at[to] = at[from] + polar(*distances_[mesh], came[to]);
        open.push_back(to);
      }
    }
    for (std::size_t b = 0; b < graph_.bodies.size(); ++b) made_.axes[b] = at[axis_[b]];
    for (std::size_t m = 0; m < graph_.meshes.size(); ++m) {
      if (graph_.frame(graph_.meshes[m])) continue;
      const double apart = (made_.axes[gear(m, 0).body] - made_.axes[gear(m, 1).body]).norm();
      if (std::abs(apart - *distances_[m]) > kCloses * *distances_[m])
        return unmeet(m, fmt::format("the axes of this mesh are {:.4f} mm apart instead of {:.4f} "
                                     "mm; give another direction for the other meshes of the loop",
                                     apart, *distances_[m]));
    }
    return std::nullopt;
  }

  std::optional<Error> place_riders() {
    made_.turned.assign(graph_.bodies.size(), 0.0);
    for (const PlanetSet& set : drive_.sets) {
      std::optional<GeometryFault> fault;
      const auto riders = rider_places(graph_, set.group, distances_, fault);
      if (!riders) misfit_.planet = set.group.riders.front();
      if (!riders)
        return Error{"drive.body", graph_.bodies[set.group.riders.front()].name,
                     fault ? fault->message : "this planet has no possible place on its carrier"};
      for (std::size_t i = 0; i < riders->size(); ++i) {
        const std::size_t body = set.group.riders[i];
        made_.turned[body] = (*riders)[i].angle;
        made_.axes[body] =
            made_.axes[set.group.carrier] + polar((*riders)[i].distance, (*riders)[i].angle);
      }
    }
    return std::nullopt;
  }

  std::optional<Error> unmeet(std::size_t mesh, const std::string& why) {
    misfit_.mesh = mesh;
    return Error{"drive.mesh", graph_.meshes[mesh].name, why};
  }

  bool meshed(std::size_t g, std::size_t h) const {
    return std::any_of(graph_.meshes.begin(), graph_.meshes.end(), [&](const DriveMesh& m) {
      return (m.gears[0] == g && m.gears[1] == h) || (m.gears[0] == h && m.gears[1] == g);
    });
  }

  // True if a gear would overlap a rack, which moves along its whole datum line. Two racks always
  // overlap unless they are on opposite sides of their pinions.
  bool beside_rack(std::size_t rack, std::size_t other) const {
    const auto towards_pinion = [&](std::size_t g) {
      const auto mesh = std::find_if(graph_.meshes.begin(), graph_.meshes.end(),
                                     [&](const DriveMesh& m) { return m.gears[1] == g; });
      return Vec2(
          (made_.axes[graph_.gear(*mesh, 0).body] - made_.axes[graph_.gears[g].body]).normalized());
    };
    const DriveGear& gear = graph_.gears[other];
    const Vec2 up = towards_pinion(rack), at = made_.axes[graph_.gears[rack].body];
    if (gear.rack && up.dot(towards_pinion(other)) > -1.0 + kCloses) return true;
    double height = std::numeric_limits<double>::infinity();
    for (int i = 0; i < graph_.bodies[gear.body].count; ++i)
      height = std::min(height, (made_.axis_of(drive_, gear.body, i) - at).dot(up));
    return height < made_.radii[rack] + made_.radii[other];
  }

  // True if two gears in the same plane would overlap.
  bool in_the_way(std::size_t g, std::size_t h) const {
    if (g == h || meshed(g, h)) return false;
    const DriveGear &a = graph_.gears[g], &b = graph_.gears[h];
    if (a.body == b.body) return true;
    if (a.rack || b.rack) return a.rack ? beside_rack(g, h) : beside_rack(h, g);
    const double r_a = made_.radii[g], r_b = made_.radii[h];
    for (int i = 0; i < graph_.bodies[a.body].count; ++i) {
      for (int k = 0; k < graph_.bodies[b.body].count; ++k) {
        const double apart =
            (made_.axis_of(drive_, a.body, i) - made_.axis_of(drive_, b.body, k)).norm();
        const bool ring_a = a.is_ring(), ring_b = b.is_ring();
        const bool cut = ring_a && ring_b ? apart < r_a + r_b
                         : ring_a         ? apart + r_b > r_a && apart - r_b < r_a
                         : ring_b         ? apart + r_a > r_b && apart - r_a < r_b
                                          : apart < r_a + r_b;
        if (cut) return true;
      }
    }
    return false;
  }

  bool in_the_way(const DriveMesh& m, const DriveMesh& n) const {
    for (const std::size_t g : m.gears)
      for (const std::size_t h : n.gears)
        if (in_the_way(g, h)) return true;
    return false;
  }

  bool share_an_axis(const DriveMesh& m, const DriveMesh& n) const {
    for (const int i : {0, 1})
      for (const int k : {0, 1})
        if (axis_[graph_.gear(m, i).body] == axis_[graph_.gear(n, k).body]) return true;
    return false;
  }

  // Assigns a slot to each mesh. The slot is the first one in which the gears of the mesh do not
  // overlap the gears already in the slot. If an earlier mesh shares an axis with this mesh, the
  // slot is not before the slot of the earlier mesh.
  void find_slots() {
    made_.slots.assign(graph_.gears.size(), {-1, -1});
    for (std::size_t m = 0; m < graph_.meshes.size(); ++m) {
      const DriveMesh& mesh = graph_.meshes[m];
      int slot = 0;
      for (std::size_t n = 0; n < m; ++n)
        if (share_an_axis(mesh, graph_.meshes[n])) slot = std::max(slot, made_.mesh_slot[n]);
      const auto taken = [&] {
        for (std::size_t n = 0; n < m; ++n)
          if (made_.mesh_slot[n] == slot && in_the_way(mesh, graph_.meshes[n])) return true;
        return false;
      };
      while (taken()) ++slot;
      made_.mesh_slot.push_back(slot);
      made_.slot_count = std::max(made_.slot_count, slot + 1);
      for (const std::size_t g : mesh.gears) {
        SlotRange& range = made_.slots[g];
        range.first = range.first < 0 ? slot : std::min(range.first, slot);
        range.last = std::max(range.last, slot);
      }
    }
    for (SlotRange& range : made_.slots)
      if (range.first < 0) range = {0, 0};
  }

  const Drive& drive_;
  const DriveGraph& graph_;
  DrivePlaces made_;
  Misfit misfit_;
  std::vector<std::optional<double>> distances_;
  std::vector<std::size_t> axis_;  // for each body: the least index of a body on the same axis
};

}  // namespace

Vec2 DrivePlaces::axis_of(const Drive& drive, std::size_t body, int copy) const {
  const auto carrier = drive.graph.bodies[body].carrier;
  if (!carrier || copy == 0) return axes[body];
  for (const PlanetSet& set : drive.sets) {
    const auto& riders = set.group.riders;
    if (!is_in(body, riders)) continue;
    const double u = set.assembly.turns[static_cast<std::size_t>(copy)].value();
    const double r = (axes[body] - axes[*carrier]).norm();
    return axes[*carrier] + polar(r, turned[body] + kTurn * u);
  }
  return axes[body];
}

const RackPair* rack_pair_of(const Drive& drive, std::size_t gear) {
  for (std::size_t m = 0; m < drive.graph.meshes.size(); ++m)
    if (drive.geometry.racks[m] && drive.graph.meshes[m].gears[1] == gear)
      return &*drive.geometry.racks[m];
  return nullptr;
}

std::optional<Warning> assembly_fault(const Drive& drive, const Misfit& misfit, const Error& why) {
  const DriveGraph& graph = drive.graph;
  const auto mounted = [&](std::size_t m) {
    return drive.geometry.pairs[m].has_value() || drive.geometry.racks[m].has_value();
  };
  bool certain = false;
  if (misfit.mesh) {
    const DriveMesh& mesh = graph.meshes[*misfit.mesh];
    const auto axis = axes_of(graph);
    const bool same = axis[graph.gear(mesh, 0).body] == axis[graph.gear(mesh, 1).body];
    certain = (same && !graph.frame(mesh)) ||
              (mounted(*misfit.mesh) && has_determined_axes(graph, *misfit.mesh));
  } else if (misfit.planet) {  // the distances must be those of the teeth
    certain = true;
    for (std::size_t m = 0; m < graph.meshes.size(); ++m) certain = certain && mounted(m);
  }
  if (!certain) return std::nullopt;
  return Warning{WarningCode::not_coaxial, no_assembly(misfit, why), 0};
}

std::string no_assembly(const Misfit& misfit, const Error& why) {
  std::string rule = why.rule;
  while (rule.ends_with('.')) rule.pop_back();
  const char* const joint = why.value.empty() ? "" : misfit.any() ? ": " : " ";
  return fmt::format("The drive cannot be assembled: {}{}{}.", why.value, joint, rule);
}

std::vector<Warning> shafts_through_gears(const Drive& drive, const DrivePlaces& places) {
  const DriveGraph& graph = drive.graph;
  std::vector<Warning> notes;
  if (!places.true_scale) return notes;
  const auto turns_in_housing = [&](std::size_t body) {
    return !graph.bodies[body].carrier && !graph.moves(body);
  };
  for (std::size_t g = 0; g < graph.gears.size(); ++g) {
    const DriveGear& gear = graph.gears[g];
    if (gear.is_ring() || gear.rack || !turns_in_housing(gear.body)) continue;
    std::vector<Vec2> named;  // the axes that already have a note; coaxial bodies share one note
    for (std::size_t b = 0; b < graph.bodies.size(); ++b) {
      const Vec2 axis = places.axes[b];
      const double apart = (axis - places.axes[gear.body]).norm();
      const double same_axis = kCloses * places.radii[g];
      if (!turns_in_housing(b) || apart >= places.radii[g] || apart <= same_axis) continue;
      if (std::any_of(named.begin(), named.end(),
                      [&](const Vec2& other) { return (axis - other).norm() <= same_axis; }))
        continue;
      named.push_back(axis);
      notes.push_back({WarningCode::shaft_through_gear,
                       fmt::format("The axis of {} is {:.4f} mm from the axis of the gear {}, "
                                   "whose tip radius is {:.4f} mm, so this shaft must end before "
                                   "the gear.",
                                   graph.bodies[b].name, apart, gear.name, places.radii[g])});
    }
  }
  return notes;
}

Result<DrivePlaces> drive_places(const Drive& drive, Misfit* misfit) {
  Placing placing(drive);
  auto made = placing.places();
  if (misfit) *misfit = placing.misfit();
  return made;
}

}  // namespace gearwright
