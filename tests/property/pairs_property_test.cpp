// Mounts any two gears at any distance. The result is a pair with finite numbers, or an error with
// its key. A contract is never violated, however little remains of the teeth.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "gearwright/pair/pair.hpp"
#include "tests/property/at_hand.hpp"
#include "tests/property/random_spec.hpp"

namespace gearwright::property {
namespace {

// A mating gear with the same base pitch but different teeth, shift, rack and tip.
CylindricalSpec random_mate(Random& random, const CylindricalSpec& spec, bool internal) {
  CylindricalSpec mate = random_spec(random);
  mate.thickness_allowance *= spec.normal_module / mate.normal_module;
  if (mate.tip_diameter)
    mate.tip_diameter = *mate.tip_diameter * spec.normal_module / mate.normal_module;
  mate.normal_module = spec.normal_module;
  mate.normal_pressure_angle = spec.normal_pressure_angle;
  mate.helix_angle = internal ? spec.helix_angle : -spec.helix_angle;
  mate.rack = random_rack(random, mate.normal_pressure_angle);
  if (internal) mate.teeth = -(std::abs(mate.teeth) + (random.chance(0.8) ? spec.teeth : 0));
  return mate;
}

bool finite(const std::optional<double>& v) { return !v || std::isfinite(*v); }

// Returns a sentence about values that are not finite, or an empty text if all values are finite.
std::string not_finite(const ParallelPair& p) {
  const auto& m = p.mesh;
  const double plain[] = {m.rack.sides[0].transverse_angle,
                          m.rack.normal_pressure_angle,
                          m.rack.sides[0].helix_angle,
                          m.rack.sides[0].pitch_radius,
                          m.rack.sides[1].pitch_radius,
                          m.base_tangent_distance,
                          m.rho1_A,
                          m.rho1_B,
                          m.rho1_C,
                          m.rho1_D,
                          m.rho1_E,
                          m.path_length,
                          m.path_ratio,
                          m.overlap_ratio,
                          m.true_ratio,
                          m.backlash.normal_base,
                          m.backlash.normal,
                          m.backlash.circumferential[0],
                          m.backlash.rotation[0],
                          m.backlash.rotation[1],
                          p.extended_center_distance,
                          p.tip_shortening,
                          p.tip_clearance[0],
                          p.tip_clearance[1]};
  for (std::size_t i = 0; i < std::size(plain); ++i) {
    if (!std::isfinite(plain[i])) return fmt::format("number {} of the mesh is {}", i, plain[i]);
  }
  for (int i : {0, 1}) {
    if (!finite(p.form_clearance[i]) || !finite(p.contact_root_diameter[i]))
      return "form clearance";
    if (!finite(p.fillet_clearance[i])) return fmt::format("fillet clearance {}", i);
  }
  if (p.margins) {
    if (!finite(p.margins->involute)) return "a margin of the internal pair";
    for (const auto& margin : {p.margins->trochoid, p.margins->trimming}) {
      if (margin && !std::isfinite(margin->rad())) return "a margin of the internal pair";
    }
  }
  if (!finite(p.backlash_free_center_distance)) return "backlash-free distance";
  for (const SpecificSliding<double>& s : {p.sliding_A, p.sliding_E}) {
    if (!finite(s.zeta_1) || !finite(s.zeta_2)) return "specific sliding";
  }
  return {};
}

void check_pairs(std::uint64_t seed, int n) {
  const PrintsAtHand handler;
  Random random(seed);
  int mounted = 0, refused = 0, failures = 0;
  for (int i = 0; i < n && failures < 10; ++i) {
    const CylindricalSpec one = random_spec(random);
    const CylindricalSpec two = random_mate(random, one, random.chance(0.3));
    const auto g1 = make_gear(one), g2 = make_gear(two);
    if (!g1 || !g2) continue;
    const double d1 = g1->reference_diameter, d2 = g2->reference_diameter;
    double a = (two.teeth > 0 ? d2 + d1 : d2 - d1) / 2;
    const double least = a * std::cos(g1->reference().transverse_pressure_angle);
    switch (random.integer(0, 3)) {
      case 0: a += one.normal_module * random.uniform(-1.0, 2.0); break;
      case 1:
        a += one.normal_module * (one.profile_shift + two.profile_shift) * (two.teeth > 0 ? 1 : -1);
        break;
      case 2: a = least * (1 + random.logarithmic(1e-15, 1.0)); break;  // α_wt from 0 upwards
      default: break;
    }
    at_hand = fmt::format("\n  gear1: {}\n  gear2: {}\n  a = {}", describe(one), describe(two), a);
    const auto pair = mount_as<ParallelPair>(*g1, *g2, {a});
    if (!pair) {
      ++refused;
      if (pair.error().message().find(pair.error().field) == std::string::npos) {
        ++failures;
        ADD_FAILURE() << pair.error().message() << at_hand;
      }
      continue;
    }
    ++mounted;
    const std::string broken = not_finite(*pair);
    if (!broken.empty()) {
      ++failures;
      ADD_FAILURE() << broken << at_hand;
    }
  }
  EXPECT_GT(mounted, n / 6);
  EXPECT_GT(refused, n / 20);
}

TEST(Pairs, are_finite_or_refused) { check_pairs(401, 20000); }

TEST(LongPairs, are_finite_or_refused) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) check_pairs(seed, 50000);
}

}  // namespace
}  // namespace gearwright::property
