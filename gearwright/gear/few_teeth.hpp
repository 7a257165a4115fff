// Circular fillets of gears with few teeth, by what a drawing gives of them.
//
//   l    mm along the straight flank of the rack, in its normal section, from its lower end
//   F    where undercut begins, ξ = 0         C, J    where root and tip fillet touch the flank
//                                              theory: docs/theory/06-few-teeth.md
//
// Everything is linear in l: the rack's height x, and with it the roll angle ξ.
#pragma once

#include <optional>

#include "gearwright/base/result.hpp"
#include "gearwright/generation/generate.hpp"

namespace gearwright {

/// [gearN.root_fillet]
struct RootFilletSpec {
  double offset = 0.0;  ///< mm, l_C = max(l_F, 0) + offset
};

/// [gearN.tip_fillet]: one number, and what it is.
struct TipFilletSpec {
  enum class By {
    radius,     ///< r_t
    l,          ///< l_J
    end_radius  ///< of the finished tip on the tooth's centre line
  };
  By by = By::radius;
  double value = 0.0;  ///< mm
};

/// The rack's straight flank as a ruler of roll angles. [T6.5]
struct FlankRuler {
  Involute flank;
  double roll_at_0;    ///< ξ at l = 0
  double roll_per_mm;  ///< dξ/dl
  double end;          ///< l of the flank's upper end, mm, or infinite

  double roll(double l) const { return roll_at_0 + roll_per_mm * l; }
  double l(double roll) const { return (roll - roll_at_0) / roll_per_mm; }
  double undercut_l() const { return l(0.0); }  ///< l_F, signed: < 0 without undercut
};

FlankRuler flank_ruler(const CutterEdge& edge, const RackMotion& motion);

/// Roll angles at C and J of what is asked for. `tip_radius` is the blank's, where it is given.
///
/// Errors    `root_fillet.offset_mm`, `tip_fillet.radius_mm`, `tip_fillet.l_mm`, `tip_fillet`: with
///           the range that fits
Result<FilletRolls> fillet_rolls(const FlankRuler& ruler, int teeth,
                                 const std::optional<RootFilletSpec>& root,
                                 const std::optional<TipFilletSpec>& tip,
                                 std::optional<double> tip_radius);

}  // namespace gearwright
