// Seeded pairs of finished gears on parallel axes with every feature that shapes a tooth: racks
// with protuberance, chamfer and fillets, circular fillets, allowances, tip diameters, few teeth,
// pinion cutters and internal gears. Most of them could be real designs. Many of them overlap.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/pair/pair.hpp"
#include "tests/oracle/random_pinion_cut.hpp"

namespace gearwright::oracle {

struct MountedPair {
  InvolutePair pair;
  std::string text;  ///< description from which the pair can be made again
};

namespace mounted_pair {

struct Made {
  Gear gear;
  std::string text;
};

inline StraightRack rack(Random& random, Angle alpha) {
  if (random.chance(0.25)) {
    static constexpr const char* kNames[] = {"ISO53-A", "ISO53-B", "ISO53-C", "ISO53-D"};
    return *iso53_rack(kNames[random.integer(0, 3)]);
  }
  StraightRack rack;
  rack.addendum = random.chance(0.5) ? 1.0 : random.uniform(0.7, 1.3);
  rack.dedendum = random.chance(0.5) ? 1.25 : random.uniform(1.05, 1.6);
  if (random.chance(0.3)) {
    rack.protuberance = random.uniform(0.0, 0.06);
    rack.protuberance_angle = Angle::radians(alpha.rad() * random.uniform(0.2, 0.9));
  }
  const double full = std::max(0.0, full_radius(rack, alpha));
  rack.root_fillet_radius = random.chance(0.15) ? 0.0 : random.uniform(0.0, std::min(full, 0.5));
  switch (random.integer(0, 5)) {
    case 0: rack.tip_fillet_radius = random.uniform(0.02, 0.35); break;
    case 1:
    case 2:
      rack.tool_addendum = random.uniform(0.6, 1.0);
      rack.semi_topping_angle = Angle::degrees(random.uniform(alpha.deg() + 5, 70.0));
      break;
    case 3: rack.tool_addendum = random.uniform(0.8, 1.1); break;
    default: break;
  }
  return rack;
}

struct Common {
  double module;
  Angle alpha, beta;
};

inline CylindricalSpec spec(Random& random, const Common& common, int teeth, double beta_sign) {
  CylindricalSpec s =
      testing::plain_spec({.teeth = teeth,
                           .module = common.module,
                           .x = random.chance(0.3) ? 0.0 : random.uniform(-0.5, 0.9),
                           .face_width = 10.0});
  s.normal_pressure_angle = common.alpha;
  s.helix_angle = Angle::radians(beta_sign * common.beta.rad());
  if (random.chance(0.3)) s.thickness_allowance = -common.module * random.uniform(0.0, 0.1);
  s.rack = rack(random, common.alpha);
  if (teeth < 0) return s;
  if (random.chance(0.15))
    s.root_fillet =
        RootFilletSpec{random.chance(0.3) ? 0.0 : random.uniform(0.0, 0.3) * common.module};
  if (random.chance(0.15)) {
    s.tip_fillet =
        TipFilletSpec{TipFilletSpec::By::radius, random.uniform(0.02, 0.4) * common.module};
  } else if (random.chance(0.3)) {
    const double r = teeth / (2 * std::cos(common.beta.rad()));
    s.tip_diameter = 2 * common.module * (r + s.profile_shift + random.uniform(0.7, 1.4));
  }
  return s;
}

inline std::optional<Made> by_rack(Random& random, const Common& common, int teeth,
                                   double beta_sign) {
  const CylindricalSpec s = spec(random, common, teeth, beta_sign);
  auto gear = make_gear(s);
  if (!gear || !gear->exists()) return std::nullopt;
  if (teeth > 0) return Made{std::move(gear).take(), property::describe(s)};
  auto cut = cut_by_default(*gear);
  if (!cut) return std::nullopt;
  return Made{*cut, property::describe(s)};
}

inline std::optional<Made> by_pinion(Random& random, const Common& common, int teeth,
                                     const Gear& mate) {
  // The cutter is sometimes the mating gear itself. Its hand is correct for the gear that it cuts.
  const bool by_mate = random.chance(0.15);
  const int most = teeth < 0 ? std::min(-teeth - 3, 40) : 40;
  if (most < 4) return std::nullopt;
  std::optional<Gear> cutter;
  std::string text;
  if (by_mate) {
    cutter = mate;
    text = "cut by gear1";
  } else {
    const double sign = mate.spec.helix_angle.rad() < 0.0 ? -1.0 : 1.0;
    CylindricalSpec s = spec(random, common, random.integer(4, most), sign);
    s.profile_shift = random.uniform(-0.4, 0.6);
    auto made = make_gear(s);
    if (!made || !made->exists()) return std::nullopt;
    cutter = std::move(made).take();
    text = "cutter: " + property::describe(s);
  }
  if (check_cutter(*cutter, teeth)) return std::nullopt;
  auto distance = generating_distance(*cutter, teeth, random.uniform(-0.5, 0.7));
  if (!distance) return std::nullopt;
  PinionCutSpec cut;
  cut.teeth = teeth;
  cut.distance = *distance;
  cut.face_width = 10.0;
  if (random.chance(0.7)) {
    const double side = teeth < 0 ? -1.0 : 1.0;
    const double root = cut.distance - side * cutter->tooth->tip_radius;
    cut.tip_diameter = 2 * (std::abs(root) + side * common.module * random.uniform(1.6, 2.5));
  }
  auto gear = make_pinion_cut_gear(*cutter, cut);
  if (!gear || !gear->exists()) return std::nullopt;
  return Made{std::move(gear).take(), text + "; " + describe(cut)};
}

}  // namespace mounted_pair

/// Returns nothing if the drawn gear does not exist.
inline std::optional<MountedPair> random_mounted_pair(Random& random) {
  using namespace mounted_pair;
  Common common{random.pick({0.5, 1.0, 2.0, 2.5, 4.0}),
                Angle::degrees(random.pick({14.5, 20.0, 20.0, 20.0, 22.5, 25.0})),
                Angle::degrees(random.chance(0.5) ? 0.0 : random.uniform(5.0, 35.0))};
  const bool ring = random.chance(0.4);
  const double sign = random.chance(0.5) ? 1.0 : -1.0;
  const int z_1 = random.chance(0.15) ? random.integer(3, 8) : random.integer(9, 60);
  const auto one = by_rack(random, common, z_1, sign);
  if (!one) return std::nullopt;
  const int z_2 =
      ring ? -(z_1 + (random.chance(0.5) ? random.integer(2, 10) : random.integer(11, 80)))
           : random.integer(7, 90);
  const auto two = random.chance(0.5) ? by_pinion(random, common, z_2, one->gear)
                                      : by_rack(random, common, z_2, ring ? sign : -sign);
  if (!two || !two->gear.tooth) return std::nullopt;
  const double m = common.module;
  // The backlash-free distance as mounting would compute it. It avoids mounting twice.
  const BasePair<double> bases = mesh_input(one->gear, two->gear, {}).gears;
  const auto free = transverse_angle_at_min_distance(bases);
  if (!free) return std::nullopt;
  double a = base_radius_sum(bases) / std::cos(*free);
  const double apart =
      m * (random.chance(0.5) ? random.uniform(0.0, 0.05) : random.uniform(0.0, 0.4));
  if (random.chance(0.7)) a += ring ? -apart : apart;
  auto pair = mount_as<ParallelPair>(one->gear, two->gear, {a});
  if (!pair) return std::nullopt;
  return MountedPair{std::move(pair).take(),
                     fmt::format("a = {}\n  gear1: {}\n  gear2: {}", a, one->text, two->text)};
}

}  // namespace gearwright::oracle
