// A pair of cylindrical gears mounted in a housing: involute gears on parallel axes, on crossed
// axes, or gears with circular-arc teeth on parallel axes.
//
//   const auto pair = mount(pinion, wheel, {.center_distance = 61.4});
//   if (pair) use(pair->center_distance(), pair->involute()->mesh.backlash.normal);
#pragma once

#include <array>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "gearwright/pair/arc_pair.hpp"
#include "gearwright/pair/involute_pair.hpp"

namespace gearwright {

enum class PairKind { parallel_external, parallel_internal, crossed };
const char* to_string(PairKind kind);

/// A pair of any kind. This class has the members that all kinds have in common. ParallelPair,
/// CrossedPair and ArcPair have the members of one kind.
class Pair {
 public:
  Pair(ParallelPair pair);
  Pair(CrossedPair pair);
  Pair(ArcPair pair);

  /// Returns the pair as a `Kind`, which may also be the common base InvolutePair. Returns null if
  /// the pair is of another kind.
  template <class Kind>
  const Kind* as() const {
    return visit([](const auto& pair) -> const Kind* {
      if constexpr (std::is_convertible_v<decltype(&pair), const Kind*>) return &pair;
      return nullptr;
    });
  }
  const InvolutePair* involute() const { return as<InvolutePair>(); }
  const ParallelPair* parallel() const { return as<ParallelPair>(); }
  const CrossedPair* crossed() const { return as<CrossedPair>(); }
  const ArcPair* arcs() const { return as<ArcPair>(); }
  /// Calls `f` with the ParallelPair, the CrossedPair or the ArcPair.
  template <class F>
  decltype(auto) visit(F&& f) const {
    return std::visit(std::forward<F>(f), of_);
  }

  const MountedGears& mounted() const {
    return visit([](const MountedGears& m) -> const MountedGears& { return m; });
  }
  PairKind kind() const;
  /// Gear 1 or gear 2.   Domain  which is 1 or 2 (contract)
  const Gear& gear(int which) const {
    GW_EXPECTS(which == 1 || which == 2);
    return mounted().gears[which - 1];
  }
  double gear_ratio() const { return mounted().gear_ratio(); }          ///< z2/z1
  double center_distance() const { return mounted().center_distance; }  ///< a  mm
  Angle shaft_angle() const { return mounted().shaft_angle; }           ///< Σ
  double contact_ratio() const;                                         ///< up to the tips
  double contact_ratio_true() const;       ///< contact ratio on the usable flanks
  StatedBacklash stated_backlash() const;  ///< 0 for circular arcs without contact
  const std::vector<Warning>& warnings() const { return mounted().warnings; }
  Pose<Housing, Gear1> pose_1() const { return mounted().pose_1(); }
  Pose<Housing, Gear2> pose_2() const { return mounted().pose_2(); }

 private:
  std::variant<ParallelPair, CrossedPair, ArcPair> of_;
};

/// Mounts any two gears. If `spec` gives neither a centre distance nor a shaft angle, and the helix
/// angles of two external gears do not permit parallel axes, the result is a crossed pair, without
/// a warning. Two helical gears of the same hand are an example, because parallel axes need
/// opposite hands.
///
/// Errors    as involute_place, mount_parallel, mount_crossed and mount_arcs; `gearN.rack` if one
///           gear has involute teeth and the other has circular arcs; `pair.shaft_angle` if crossed
///           axes are requested for gears with circular arcs
Result<Pair> mount(Gear gear_1, Gear gear_2, const PairSpec& spec = {});

/// Mounts two gears and returns the pair as a `Kind`.   Domain: the pair is of this kind (contract)
template <class Kind>
Result<Kind> mount_as(Gear gear_1, Gear gear_2, const PairSpec& spec = {}) {
  const Result<Pair> pair = mount(std::move(gear_1), std::move(gear_2), spec);
  if (!pair) return pair.error();
  GW_EXPECTS(pair->template as<Kind>() != nullptr);
  return *pair->template as<Kind>();
}

// The backlash of a pair of involute or circular-arc gears, in four forms, and the part of the
// backlash that is free of collisions.

struct PairBacklash {
  double normal_base;                        ///< j_bn  mm, along the common normal
  double normal;                             ///< j_n   mm
  std::array<double, 2> circumferential;     ///< j_wt  mm, at the working pitch circles
  std::array<Angle, 2> rotation;             ///< j_φ of each gear while the other gear is held
  std::optional<std::array<Angle, 2>> free;  ///< the part of the rotation without collisions
};

/// Returns the backlash of a pair, or none for circular arcs without a point of contact.
std::optional<PairBacklash> backlash_of(const Pair& pair);

}  // namespace gearwright
