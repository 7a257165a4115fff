// The usable flank between d_Ff and d_Fa, on which a measuring tool can touch.
//
//   d_Ff, d_Fa   form diameters, mm       d_y   diameter of a contact, mm
//   d_V          diameter of the V circle, |d ± 2 x m_n|, mm, at which tools of the usual size touch
//                                              theory: docs/theory/10-inspection.md
//
// The flank of an internal gear extends outward from d_Fa, because the tip lies inside.
#pragma once

#include <optional>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The position of a contact.
enum class ContactPlace {
  usable,           ///< on the involute between d_Ff and d_Fa
  below_flank,      ///< at the root fillet, which is not an involute; the reading has no meaning
  on_tip_rounding,  ///< between d_Fa and the tip, on a chamfer or a rounding
  beyond_tip        ///< beyond the tip of the tooth
};
struct UsableFlank {
  double root_end;  ///< d_Ff  mm; the root diameter for an internal gear without a tooth
  double tip_end;   ///< d_Fa  mm
  double tip;       ///< mm, diameter at which the tooth ends
  bool internal;

  double least() const { return internal ? tip_end : root_end; }
  double greatest() const { return internal ? root_end : tip_end; }
  double middle() const { return (root_end + tip_end) / 2; }
  bool contains(double diameter) const { return diameter >= least() && diameter <= greatest(); }
  ContactPlace place(double diameter) const;
};

/// The usable flank of a gear; none if no flank is left or the teeth are not involutes.
std::optional<UsableFlank> usable_flank(const Gear& gear);
/// The diameter d_V of the V circle.
///
/// Formula   d_V = |d| ± 2 x m_n, with minus for an internal gear; [T10.1]
double v_circle_diameter(const Gear& gear);
/// The contact diameter of tools of the usual size: d_V, or the middle of the usable flank if d_V is
/// outside the flank.
double usual_contact_diameter(const Gear& gear, const UsableFlank& flank);

}  // namespace gearwright
