// The positions of the planets in the frame of their carrier, and the clearance between them.
//                                              theory: docs/theory/13-drives.md, 13.3
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/base/numbers.hpp"
#include "gearwright/drive/drive_geometry.hpp"

namespace gearwright {

namespace {

using Fault = GeometryFault;

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
  // The distance of two points given in polar coordinates, in a form with little cancellation. For
  // equal radii it is 2 a sin(Δ/2).
  const double half = std::sin(angle / 2);
  const double d = a.distance - b.distance;
  const double between = std::sqrt(d * d + 4 * a.distance * b.distance * half * half);
  return between - (a.tip_diameter + b.tip_diameter) / 2;
}

// Returns the least gap between the tips of riders of different copies.
double least_gap_of(const std::vector<Rider>& riders, const std::vector<double>& turned) {
  double least = kInfinity;
  for (std::size_t i = 0; i < turned.size(); ++i)
    for (std::size_t j = i + 1; j < turned.size(); ++j)
      for (const Rider& a : riders)
        for (const Rider& b : riders) least = std::min(least, tip_gap(a, b, turned[j] - turned[i]));
  return least;
}

// Returns the greatest number of copies at equal pitch whose tips do not overlap.
int most_of(const std::vector<Rider>& riders) {
  constexpr int kMost = 1000;  // greatest number of planets that is tried
  for (int n = 2; n <= kMost; ++n) {
    // At equal pitch, every distance between two copies also occurs between copy 0 and another one.
    for (int i = 1; i < n; ++i)
      for (const Rider& a : riders)
        for (const Rider& b : riders)
          if (tip_gap(a, b, 2 * std::numbers::pi * i / n) < 0.0) return n - 1;
  }
  return kMost;
}

}  // namespace

std::optional<int> most_copies(const DriveGraph& graph, const PlanetGroup& group,
                               const DriveGeometry& geometry) {
  std::optional<Fault> ignored;
  const auto riders = place_riders(graph, group, geometry, ignored);
  return riders ? std::optional(most_of(*riders)) : std::nullopt;
}

std::optional<std::vector<RiderPlace>> rider_places(
    const DriveGraph& graph, const PlanetGroup& group,
    const std::vector<std::optional<double>>& distances, std::optional<GeometryFault>& fault) {
  std::vector<RiderPlace> riders;
  // The angle of each rider after the first follows from a triangle. Its corners are the axes of
  // the carrier, of this rider, and of a rider whose angle is known.
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
      const double between_them = std::acos(cosine);
      const bool clockwise = graph.bodies[body].side == IdlerSide::clockwise;
      angle = riders[j].angle + (clockwise ? -between_them : between_them);
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
  found.most = most_of(*riders);
  return found;
}

}  // namespace gearwright
