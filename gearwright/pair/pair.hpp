// A pair of cylindrical gears mounted in a housing: involute gears on parallel or crossed axes, or
// gears with circular-arc teeth on parallel ones.
//
//   const auto pair = mount(pinion, wheel, {.center_distance = 61.4});
//   if (pair) use(pair->center_distance(), pair->involute()->mesh.backlash.normal);
#pragma once

#include <utility>
#include <variant>

#include "gearwright/pair/arc_pair.hpp"
#include "gearwright/pair/involute_pair.hpp"

namespace gearwright {

/// Data common to both kinds of pair are members here. Data of one kind are members of that kind.
class Pair {
 public:
  Pair(InvolutePair pair);
  Pair(ArcPair pair);

  const InvolutePair* involute() const { return std::get_if<InvolutePair>(&of_); }
  const ArcPair* arcs() const { return std::get_if<ArcPair>(&of_); }
  /// Calls `f` with the InvolutePair or the ArcPair.
  template <class F>
  decltype(auto) visit(F&& f) const {
    return std::visit(std::forward<F>(f), of_);
  }

  const MountedGears& mounted() const {
    return visit([](const MountedGears& m) -> const MountedGears& { return m; });
  }
  PairKind kind() const { return mounted().kind; }
  bool crossed() const { return mounted().crossed(); }
  const Gear& gear(int which) const { return mounted().gears[static_cast<std::size_t>(which - 1)]; }
  double gear_ratio() const { return mounted().gear_ratio(); }          ///< z2/z1
  double center_distance() const { return mounted().center_distance; }  ///< a  mm
  Angle shaft_angle() const { return mounted().shaft_angle; }           ///< Σ
  double contact_ratio() const;                                         ///< over the whole face
  const std::vector<Warning>& warnings() const { return mounted().warnings; }
  Pose<Housing, Gear1> pose_1() const { return mounted().pose_1(); }
  Pose<Housing, Gear2> pose_2() const { return mounted().pose_2(); }

 private:
  std::variant<InvolutePair, ArcPair> of_;
};

/// Mounts any two gears.
///
/// Errors    as mount_involutes and mount_arcs; `gearN.rack` if one gear has involute teeth and the
///           other circular arcs, `pair.shaft_angle` for crossed axes with arcs
Result<Pair> mount(Gear gear_1, Gear gear_2, const PairSpec& spec = {});

}  // namespace gearwright
