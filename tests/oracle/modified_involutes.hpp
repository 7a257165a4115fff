// Seeded involute pairs with all possible errors and options: errors of mounting and lead,
// modifications of either flank, external and internal pairs, either gear driving.
//
// The removal of a modification is implemented here a second time from the definitions in
// gear/modifications.hpp. A topography is a polynomial, so the spline of the engine reproduces it
// exactly.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "gearwright/gear/modifications.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/pair/pair.hpp"
#include "tests/oracle/contact_gears.hpp"
#include "tests/property/random_pair.hpp"

namespace gearwright::oracle {

/// C(ρ, z) of one flank, with its data in mm, plus `polynomial`.
inline std::function<double(double, double)> removed_by(
    const FlankModifications& m, const FlankExtent& e,
    std::function<double(double, double)> polynomial = {}) {
  return [=](double rho, double z) {
    const auto roll = [&](double r) { return std::sqrt(std::max(0.0, r * r - e.r0 * e.r0)); };
    const double l = roll(rho), l_f = roll(e.rho_root_form), l_a = roll(e.rho_tip_form);
    const auto relief = [](const Relief& r, double q) {
      if (!r.reach || q <= 0.0) return 0.0;
      return r.amount * (r.shape == ReliefShape::linear ? q : q * q);
    };
    const auto along = [&](const Relief& r, double end) {
      const double start = roll(r.reach.value_or(0.0) / 2);
      return relief(r, (l - start) / (end - start));
    };
    const double w = (l - 0.5 * (l_f + l_a)) / (l_a - l_f), v = z / e.face_width;
    const double length = m.end_relief.reach.value_or(1.0);
    double c = along(m.tip_relief, l_a) + along(m.root_relief, l_f) +
               m.profile_crowning * 4 * w * w + m.profile_slope * w + m.lead_crowning * 4 * v * v +
               m.lead_slope * v +
               relief(m.end_relief, (std::abs(z) - e.face_width / 2 + length) / length);
    if (polynomial) c += polynomial(rho, z);
    return c;
  };
}

inline FlankExtent extent_of(const Gear& g) {
  return {g.base_radius(), *g.root_form_radius(), g.tip_form_radius(), g.spec.face_width};
}

struct ModifiedPair {
  ContactSet set;
  BrutePair brute;
  std::string name;
};

struct Wanted {
  bool internal = false;
  bool errors = true, modifications = true;
  bool hollow = false;  ///< true if crownings with most removal in the middle, and topographies
                        ///< with several inflections, are included
};

/// Gears whose involutes touch along the whole common flank. Returns nothing if the draw does not
/// give such a pair.
inline std::optional<ModifiedPair> random_modified(property::Random& random, const Wanted& want) {
  property::SpecPair specs = property::random_pair(random, want.internal);
  specs.first.normal_pressure_angle = specs.second.normal_pressure_angle = Angle::degrees(20);
  specs.second.face_width = specs.first.face_width * random.uniform(0.7, 1.3);
  auto g1 = make_gear(specs.first);
  auto g2 = make_gear(specs.second);
  if (!g1 || !g2 || !g1->exists()) return std::nullopt;
  ModifiedPair out{{{std::move(g1).take(), std::move(g2).take()}, {}, {}}, {}, describe(specs)};
  auto& gears = out.set.gears;
  if (want.internal) {
    auto ring = cut_by_default(gears[1]);
    if (!ring) return std::nullopt;
    gears[1] = *ring;
  }
  if (!gears[1].exists() || !gears[0].root_form_radius() || !gears[1].root_form_radius())
    return std::nullopt;
  const double far = 2 * (gears[0].reference_diameter + gears[1].reference_diameter);
  const auto anywhere = mount_as<ParallelPair>(gears[0], gears[1], {far});
  if (!anywhere || !anywhere->backlash_free_center_distance) return std::nullopt;
  const double m = specs.first.normal_module;
  auto& place = out.set.mount;
  place.center_distance = *anywhere->backlash_free_center_distance;
  place.gear2_drives = random.chance(0.4);
  const auto pair = mount_as<ParallelPair>(gears[0], gears[1], {place.center_distance});
  if (!pair || !(pair->transverse_contact_ratio() > 1.05)) return std::nullopt;
  if (!pair->interference.empty() || !pair->beyond_flank.empty()) return std::nullopt;
  if (pair->margins && pair->margins->trimming && pair->margins->trimming->rad() < 0.0)
    return std::nullopt;
  if (pair->mesh.rho1_true_begin > pair->mesh.rho1_A + 1e-9 ||
      pair->mesh.rho1_true_end < pair->mesh.rho1_E - 1e-9)
    return std::nullopt;
  const auto sign = [&random] { return random.chance(0.5) ? 1.0 : -1.0; };
  if (want.errors) {
    auto& e = place.errors;
    const double size = random.logarithmic(1e-3, 1.0);
    const double slope = 3e-3 * m / specs.first.face_width * size;
    e.center_distance = 0.1 * m * size * random.unit() * (want.internal ? -1 : 1);
    if (random.chance(0.7)) e.crossing = Angle::radians(slope * sign() * random.unit());
    if (random.chance(0.7)) e.intersecting = Angle::radians(slope * sign() * random.unit());
    if (random.chance(0.5)) e.axial = 0.5 * m * sign() * random.unit();
    for (int i : {0, 1}) {
      const double r = gears[i].reference_diameter / 2;
      if (random.chance(0.4)) e.helix_twist[i] = slope / r * sign() * random.unit();
    }
  }
  std::array<std::function<double(double, double)>, 2> removed;
  for (int i : {0, 1}) {
    if (!want.modifications || random.chance(0.2)) continue;
    FlankModifications f;
    const FlankExtent e = extent_of(gears[i]);
    const double depth = std::abs(e.rho_tip_form - e.rho_root_form);
    const auto hollow = [&] { return want.hollow && random.chance(0.4) ? -1.0 : 1.0; };
    const auto amount = [&] { return m * random.logarithmic(1e-5, 8e-3); };
    const auto shape = [&] {
      return random.chance(0.5) ? ReliefShape::linear : ReliefShape::parabolic;
    };
    const auto start = [&](double from, double to) {
      return 2 * (to + (from - to) * random.uniform(0.1, 0.5));
    };
    if (random.chance(0.4))
      f.tip_relief = {amount(), start(e.rho_root_form, e.rho_tip_form), shape()};
    if (random.chance(0.2))
      f.root_relief = {amount(), start(e.rho_tip_form, e.rho_root_form), shape()};
    if (random.chance(0.4)) f.profile_crowning = amount() * hollow();
    if (random.chance(0.2)) f.profile_slope = amount() * sign();
    if (random.chance(0.5)) f.lead_crowning = amount() * hollow();
    if (random.chance(0.2)) f.lead_slope = amount() * sign();
    if (random.chance(0.3))
      f.end_relief = {amount(), e.face_width * random.uniform(0.05, 0.45), shape()};
    std::function<double(double, double)> polynomial;
    if (random.chance(0.2)) {
      const double c = amount(), middle = e.rho_root_form + e.rho_tip_form, b = e.face_width;
      const double most = want.hollow ? 1.0 : 0.25;  // below a third, the polynomial is convex
      const double p = random.uniform(-most, most), q = random.uniform(-most, most);
      const double s = random.uniform(-most, most);
      polynomial = [=](double rho, double z) {
        const double x = (2 * rho - middle) / depth, y = 2 * z / b;
        return c * (x * x + y * y + p * x * y * y + q * x * x * x + s * x * x * y);
      };
      Topography t;
      const double lo = 2 * std::min(e.rho_root_form, e.rho_tip_form);
      for (int k = 0; k < 6; ++k) t.diameters.push_back(lo - 1e-3 + (2 * depth + 2e-3) * k / 5);
      for (int k = 0; k < 7; ++k) t.heights.push_back(b * (k / 6.0 - 0.5));
      for (const double d : t.diameters)
        for (const double z : t.heights) t.removed.push_back(polynomial(d / 2, z));
      f.topography = std::make_shared<Topography>(t);
    }
    auto field = make_removal_field(f, e);
    if (!field) return std::nullopt;
    out.set.removal[i] = std::make_shared<RemovalField>(std::move(field).take());
    removed[i] = removed_by(f, e, polynomial);
  }
  out.brute = brute_pair(out.set);
  out.brute.one.removed = removed[0];
  out.brute.two.removed = removed[1];
  return out;
}

}  // namespace gearwright::oracle
