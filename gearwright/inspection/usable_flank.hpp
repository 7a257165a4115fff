// The usable flank between d_Ff and d_Fa, where a measuring tool may touch.
//
//   d_Ff, d_Fa   form diameters, mm       d_y   diameter of a contact, mm
//   d_V          the V circle, |d ± 2 x m_n|, mm: where a tool of the right size touches
//                                              theory: docs/theory/10-inspection.md
//
// The flank of an internal gear extends outward from d_Fa, because its tip lies inside.
#pragma once

#include <optional>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The position of a contact.
enum class ContactPlace {
  usable,           ///< on the involute between d_Ff and d_Fa
  below_flank,      ///< at the root fillet, which is not an involute, so the reading is meaningless
  on_tip_rounding,  ///< between d_Fa and the tip: chamfered or rounded away
  beyond_tip        ///< no tooth is there
};

struct UsableFlank {
  double root_end;  ///< mm, diameter: d_Ff; an internal gear's root end of the flank
  double tip_end;   ///< d_Fa  mm
  double tip;       ///< mm, where the tooth ends
  bool internal;

  double least() const { return internal ? tip_end : root_end; }
  double greatest() const { return internal ? root_end : tip_end; }
  double middle() const { return (root_end + tip_end) / 2; }
  bool contains(double diameter) const { return diameter >= least() && diameter <= greatest(); }
  ContactPlace place(double diameter) const;
};

/// None if no flank is left or the teeth are not involute.
std::optional<UsableFlank> usable_flank(const Gear& gear);

/// The contact diameter of tools of the usual size: d_V, or the middle of the usable flank if d_V
/// is outside it.
///
/// Formula   d_V = |d| ± 2 x m_n, minus internal; [T10.1]
double v_circle_diameter(const Gear& gear);
double usual_contact_diameter(const Gear& gear, const UsableFlank& flank);

}  // namespace gearwright
