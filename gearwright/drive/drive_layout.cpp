#include "gearwright/drive/drive_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/lists.hpp"

namespace gearwright {

namespace {

constexpr double kMeets = 1e-6;  // allowed rounding error of a phase, rad; one pitch is 2π

double direction(const Vec2& v) { return std::atan2(v.y(), v.x()); }

// Returns the difference of a phase from the nearest whole number of periods, −π … π.
double off_phase(double phase) { return std::remainder(phase, kTurn); }

// Returns the whole face width of a gear or a rack, or 0 if it is unknown.
double face_of(const Drive& drive, std::size_t g) {
  const auto& gear = drive.geometry.gears[g];
  if (gear) return gear->whole_face(gear->spec.face_width);
  const RackPair* rack = rack_pair_of(drive, g);
  return rack ? rack->rack.face_width : 0.0;
}

class Layout {
 public:
  Layout(const Drive& drive, DrivePlaces places) : drive_(drive), graph_(drive.graph) {
    made_.places = std::move(places);
  }

  Result<DriveLayout> layout() {
    list_gears();
    if (auto error = find_angles()) return *error;
    find_heights();
    for (std::size_t i = 0; i < made_.gears.size(); ++i) {
      PlacedGear& gear = made_.gears[i];
      if (graph_.gears[gear.gear].rack) {
        place_rack(gear, phi_[i]);
      } else {
        gear.angle = phi_[i] + drive_.geometry.gears[gear.gear]->twist() * gear.height;
      }
    }
    return std::move(made_);
  }

  const Misfit& misfit() const { return misfit_; }

 private:
  // Turns a rack towards its pinion, and moves it along its datum line by φ/2π pitches. If the
  // number of teeth is even, a space is in the middle of the rack.
  void place_rack(PlacedGear& rack, double phi) {
    const RackGeometry& bar = rack_pair_of(drive_, rack.gear)->rack;
    const Vec2 up = pinion_axis(rack.gear) - rack.axis;
    rack.angle = direction(up);
    const double pitches = phi / kTurn + (bar.teeth % 2 == 0 ? 0.5 : 0.0) +
                           std::tan(bar.helix_angle.rad()) * rack.height / bar.transverse_pitch;
    rack.axis += std::remainder(pitches, 1.0) * bar.transverse_pitch * along_rack(rack);
  }

  Vec2 pinion_axis(std::size_t rack) const {
    for (const DriveMesh& mesh : graph_.meshes)
      if (mesh.gears[1] == rack) return made_.places.axes[graph_.gear(mesh, 0).body];
    contract_failed("precondition", "a rack meshes with a pinion", __FILE__, __LINE__);
  }

  // Returns the number of teeth in the equation of a mesh. A rack counts as a gear with one tooth,
  // and its angle is 2π per pitch of travel.
  int teeth_of(std::size_t gear) const {
    return graph_.gears[gear].rack ? 1 : graph_.gears[gear].teeth;
  }
  std::size_t body_of(std::size_t placed) const {
    return graph_.gears[made_.gears[placed].gear].body;
  }
  bool rides(std::size_t placed) const {
    return graph_.bodies[body_of(placed)].carrier.has_value();
  }

  void list_gears() {
    for (std::size_t g = 0; g < graph_.gears.size(); ++g) {
      const std::size_t body = graph_.gears[g].body;
      first_.push_back(made_.gears.size());
      for (int k = 0; k < graph_.bodies[body].count; ++k)
        made_.gears.push_back({g, k, made_.places.axis_of(drive_, body, k), 0.0, 0.0});
    }
    phi_.assign(made_.gears.size(), 0.0);
    known_.assign(made_.gears.size(), 0);
  }

  // Returns the placed gears of a mesh for one copy of its planets. A central gear has one copy.
  std::array<std::size_t, 2> placed(const DriveMesh& mesh, int copy) const {
    std::array<std::size_t, 2> two{};
    for (const std::size_t k : {0, 1}) {
      const std::size_t g = mesh.gears[k];
      const bool many = graph_.bodies[graph_.gears[g].body].count > 1;
      two[k] = first_[g] + static_cast<std::size_t>(many ? copy : 0);
    }
    return two;
  }

  // Returns z_a (θ_a − φ_a) + z_b (θ_b − φ_b) − π, a multiple of 2π if the teeth mesh. [T13.15c]
  double mesh_phase(const std::array<std::size_t, 2>& two) const {
    const PlacedGear &a = made_.gears[two[0]], &b = made_.gears[two[1]];
    const int z_a = teeth_of(a.gear), z_b = teeth_of(b.gear);
    const double theta_a = direction(z_b < 0 ? a.axis - b.axis : Vec2(b.axis - a.axis));
    const double theta_b = graph_.gears[b.gear].rack ? 0.0
                           : z_b < 0                 ? theta_a
                                                     : theta_a + kTurn / 2;
    return z_a * (theta_a - phi_[two[0]]) + z_b * (theta_b - phi_[two[1]]) - kTurn / 2;
  }

  void meet(const std::array<std::size_t, 2>& two, std::size_t which) {
    const int z = teeth_of(made_.gears[two[which]].gear);
    phi_[two[which]] += off_phase(mesh_phase(two)) / z;
    known_[two[which]] = 1;
  }

  bool meets(const std::array<std::size_t, 2>& two) const {
    return std::abs(off_phase(mesh_phase(two))) < kMeets;
  }

  std::optional<Error> find_angles() {
    // Each gear on a fixed axis or on copy 0 of a planet is turned until its teeth mesh with a gear
    // whose angle is known.
    for (std::size_t root = 0; root < graph_.gears.size(); ++root) {
      if (known_[first_[root]]) continue;
      known_[first_[root]] = 1;
      for (bool found = true; found;) {
        found = false;
        for (const DriveMesh& mesh : graph_.meshes) {
          const auto two = placed(mesh, 0);
          if (known_[two[0]] == known_[two[1]]) continue;
          meet(two, known_[two[0]] ? 1 : 0);
          found = true;
        }
      }
    }
    for (std::size_t m = 0; m < graph_.meshes.size(); ++m) {
      if (meets(placed(graph_.meshes[m], 0))) continue;
      misfit_.mesh = m;
      return Error{"drive.mesh", graph_.meshes[m].name,
                   "this mesh closes a loop of gears whose teeth do not mesh at these angles of "
                   "the shafts"};
    }
    for (const PlanetSet& set : drive_.sets)
      for (int copy = 1; copy < set.group.count; ++copy)
        if (!turn_copy(set, copy)) {
          misfit_.planet = set.group.riders.front();
          return Error{
              "drive.body", graph_.bodies[set.group.riders.front()].name,
              fmt::format("the teeth of planet {} do not mesh with all central gears", copy + 1)};
        }
    return std::nullopt;
  }

  // Gives the gears of a copy the angles of copy 0, rotated about the carrier's axis. Then each
  // planet is turned about its own axis until its teeth mesh.
  bool turn_copy(const PlanetSet& set, int copy) {
    const double u = set.assembly.turns[static_cast<std::size_t>(copy)].value();
    for (std::size_t g = 0; g < graph_.gears.size(); ++g) {
      const auto& riders = set.group.riders;
      if (!is_in(graph_.gears[g].body, riders)) continue;
      phi_[first_[g] + static_cast<std::size_t>(copy)] = phi_[first_[g]] + kTurn * u;
    }
    return turn_rider(set, copy, 0);
  }

  // Turns planet k and the following planets until all their teeth mesh. Returns false if this is
  // impossible. The first mesh of planet k with a gear that is already placed permits z angles. The
  // function tries these angles one after another.
  bool turn_rider(const PlanetSet& set, int copy, std::size_t k) {
    if (k == set.group.riders.size()) return true;
    const std::size_t body = set.group.riders[k];
    std::vector<std::pair<std::array<std::size_t, 2>, std::size_t>> meshes;  // placed gears; side
                                                                             // of the rider
    for (const std::size_t m : set.group.meshes) {
      const auto two = placed(graph_.meshes[m], copy);
      for (const std::size_t side : {0, 1}) {
        if (body_of(two[side]) == body && stands(set, two[1 - side], k))
          meshes.emplace_back(two, side);
      }
    }
    if (meshes.empty()) return turn_rider(set, copy, k + 1);
    if (!set.assembly.clocking.empty()) {  // each gear of a clocked planet has its own angle
      for (const auto& [two, side] : meshes) meet(two, side);
      return turn_rider(set, copy, k + 1);
    }
    const auto& [first, side] = meshes.front();
    const int z = std::abs(graph_.gears[made_.gears[first[side]].gear].teeth);
    turn_body(body, copy, off_phase(mesh_phase(first)) / z);
    for (int tooth = 0; tooth < z; ++tooth) {
      const bool all = std::all_of(meshes.begin(), meshes.end(),
                                   [&](const auto& mesh) { return meets(mesh.first); });
      if (all && turn_rider(set, copy, k + 1)) return true;
      turn_body(body, copy, kTurn / z);
    }
    return false;
  }

  bool stands(const PlanetSet& set, std::size_t placed, std::size_t before) const {
    if (!rides(placed)) return true;
    const auto& riders = set.group.riders;
    const auto end = riders.begin() + static_cast<std::ptrdiff_t>(before);
    return std::find(riders.begin(), end, body_of(placed)) != end;
  }

  void turn_body(std::size_t body, int copy, double angle) {
    for (std::size_t g = 0; g < graph_.gears.size(); ++g)
      if (graph_.gears[g].body == body) phi_[first_[g] + static_cast<std::size_t>(copy)] += angle;
  }

  // Places the slots one after the other. The width of a slot is the greatest face width of the
  // gears that are only in this slot. If there are no such gears, the width is the greatest face
  // width of all gears in the slot.
  void find_heights() {
    const auto& slots = made_.places.slots;
    std::vector<double> from, to;
    double module = 0.0;
    for (const auto& gear : drive_.geometry.gears)
      if (gear) module = std::max(module, gear->spec.normal_module);
    double at = 0.0;
    for (int slot = 0; slot < made_.places.slot_count; ++slot) {
      double alone = 0.0, any = 0.0;
      for (std::size_t g = 0; g < slots.size(); ++g) {
        if (slots[g].first > slot || slots[g].last < slot) continue;
        const double face = face_of(drive_, g);
        any = std::max(any, face);
        if (slots[g].first == slots[g].last) alone = std::max(alone, face);
      }
      from.push_back(at);
      to.push_back(at + (alone > 0.0 ? alone : any));
      at = to.back() + kBetweenFaces * module;
    }
    const double middle = from.empty() ? 0.0 : (from.front() + to.back()) / 2;
    for (PlacedGear& placed : made_.gears) {
      const SlotRange& range = slots[placed.gear];
      placed.height =
          (from[static_cast<std::size_t>(range.first)] + to[static_cast<std::size_t>(range.last)]) /
              2 -
          middle;
    }
    for (std::size_t slot = 0; slot < from.size(); ++slot) {
      DriveSection section{(from[slot] + to[slot]) / 2 - middle, {}};
      for (std::size_t i = 0; i < made_.gears.size(); ++i) {
        const SlotRange& range = slots[made_.gears[i].gear];
        if (range.first <= static_cast<int>(slot) && static_cast<int>(slot) <= range.last)
          section.gears.push_back(i);
      }
      made_.sections.push_back(std::move(section));
    }
  }

  const Drive& drive_;
  const DriveGraph& graph_;
  DriveLayout made_;
  Misfit misfit_;
  std::vector<std::size_t> first_;  // for each gear: index of its copy 0 in made_.gears
  std::vector<double> phi_;         // φ of each placed gear in the section z = 0
  std::vector<char> known_;
};

// Returns the least T > 0 whose product with each of the speeds is a whole number. T is the least
// common multiple of the denominators of the speeds, divided by the greatest common divisor of
// their numerators.
std::optional<Rational> least_common_turn(const std::vector<Rational>& speeds) {
  long long p = 0;
  Rational q = 1;
  for (const Rational& a : speeds) {
    const auto num = a.numerator(), den = a.denominator();
    if (!num || !den) return std::nullopt;
    if (*num == 0) continue;
    p = std::gcd(p, *num);
    q = least_common_multiple(q, Rational(*den));
  }
  if (p == 0 || !q.fits()) return std::nullopt;
  return q / Rational(p);
}

}  // namespace

double DriveLayout::angle_at(const Drive& drive, std::size_t placed, double height) const {
  const PlacedGear& gear = gears[placed];
  if (drive.graph.gears[gear.gear].rack) return gear.angle;
  return gear.angle + drive.geometry.gears[gear.gear]->twist() * (height - gear.height);
}

Vec2 along_rack(const PlacedGear& rack) { return {-std::sin(rack.angle), std::cos(rack.angle)}; }

Vec2 DriveLayout::axis_at(const Drive& drive, std::size_t placed, double height) const {
  const PlacedGear& gear = gears[placed];
  const RackPair* rack = rack_pair_of(drive, gear.gear);
  if (!rack) return gear.axis;
  return gear.axis +
         std::tan(rack->rack.helix_angle.rad()) * (height - gear.height) * along_rack(gear);
}

Result<DriveLayout> drive_layout(const Drive& drive, Misfit* misfit) {
  const auto& gears = drive.geometry.gears;
  const auto& faults = drive.geometry.faults;
  std::string why = faults.empty() ? "some gears cannot be mounted" : faults.front().message;
  while (why.ends_with('.')) why.pop_back();
  for (std::size_t g = 0; g < gears.size(); ++g) {
    if (rack_pair_of(drive, g)) continue;
    if (!gears[g] && !faults.empty()) return Error{"drive.mesh", "", why};
    if (!gears[g])
      return Error{"drive.gear", drive.graph.gears[g].name,
                   "has no teeth to be drawn, because its module is unknown; give "
                   "the module"};
  }
  auto places = drive_places(drive, misfit);
  if (!places) return places.error();
  if (!places->true_scale) return Error{"drive.mesh", "", why};
  Layout layout(drive, std::move(places).take());
  auto made = layout.layout();
  if (misfit) *misfit = layout.misfit();
  return made;
}

std::vector<Warning> partial_faces(const Drive& drive, const DriveLayout& layout) {
  constexpr double kSameFace = 1e-9;  // relative rounding error of a face width
  const DriveGraph& graph = drive.graph;
  std::vector<double> height(graph.gears.size(), 0.0);
  for (const PlacedGear& placed : layout.gears) height[placed.gear] = placed.height;
  const auto spans = [&](std::size_t g) {
    return layout.places.slots[g].first < layout.places.slots[g].last;
  };
  // Returns the least face width with which a gear covers the faces of all its mating gears.
  const auto needed = [&](std::size_t g) {
    double half = 0.0;
    for (const DriveMesh& mesh : graph.meshes)
      for (const std::size_t side : {0, 1})
        if (mesh.gears[side] == g) {
          const std::size_t mate = mesh.gears[1 - side];
          half = std::max(half, std::abs(height[mate] - height[g]) + face_of(drive, mate) / 2);
        }
    return 2 * half;
  };
  std::vector<Warning> findings;
  for (const DriveMesh& mesh : graph.meshes) {
    const auto [a, b] = mesh.gears;
    const double b_a = face_of(drive, a), b_b = face_of(drive, b);
    const double common = std::min(height[a] + b_a / 2, height[b] + b_b / 2) -
                          std::max(height[a] - b_a / 2, height[b] - b_b / 2);
    const double computed = std::min(b_a, b_b);
    if (common > computed * (1 - kSameFace)) continue;
    const std::size_t wide = spans(a) ? a : b;
    findings.push_back(
        {WarningCode::partial_face,
         fmt::format("In the mesh {}, the gears share {:.4f} mm of their faces, but the results "
                     "are for {:.4f} mm, because {} meshes with gears in several planes. Give {} "
                     "the `face_width` {:.4f} mm.",
                     mesh.name, std::max(common, 0.0), computed, graph.gears[wide].name,
                     graph.gears[wide].name, needed(wide)),
         0});
  }
  return findings;
}

DriveLayout turned(const Drive& drive, DriveLayout layout, double input_turns) {
  const auto angle = [&](std::size_t body) {
    const auto ratio = drive.speed_ratio(body);
    GW_EXPECTS(ratio.has_value());
    return *ratio * input_turns * kTurn;
  };
  for (PlacedGear& placed : layout.gears) {
    const std::size_t body = drive.graph.gears[placed.gear].body;
    if (const auto pitch = drive.rack_pitch(body)) {
      placed.axis += angle(body) / kTurn * *pitch * -along_rack(placed);
      continue;
    }
    placed.angle += angle(body);
    if (const auto carrier = drive.graph.bodies[body].carrier) {
      const Vec2 about = layout.places.axes[*carrier];
      placed.axis = about + Eigen::Rotation2Dd(angle(*carrier)) * (placed.axis - about);
    }
  }
  return layout;
}

std::optional<Rational> turns_until_alike(const Drive& drive) {
  if (drive.graph.inputs.size() != 1) return std::nullopt;
  const auto speed = [&](std::size_t body) { return drive.motion.speeds[body][0]; };
  std::vector<Rational> whole;
  for (const DriveGear& gear : drive.graph.gears)
    if (!drive.graph.bodies[gear.body].carrier)
      whole.push_back(speed(gear.body) * Rational(gear.teeth));
  for (const PlanetSet& set : drive.sets) {
    // Equally spaced planets that have only one gear are interchangeable.
    std::size_t gears = 0;
    for (const DriveGear& gear : drive.graph.gears)
      if (drive.graph.bodies[gear.body].carrier == set.group.carrier) ++gears;
    const bool alike = set.assembly.equal && set.assembly.clocking.empty() && gears == 1;
    whole.push_back(speed(set.group.carrier) * Rational(alike ? set.group.count : 1));
    for (const DriveGear& gear : drive.graph.gears)
      if (!alike && drive.graph.bodies[gear.body].carrier == set.group.carrier)
        whole.push_back(speed(gear.body) * Rational(gear.teeth));
  }
  return least_common_turn(whole);
}

}  // namespace gearwright
