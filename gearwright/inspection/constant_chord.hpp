// The constant chord: the chord between the points at which a rack touches both sides of a tooth at the
// same time.
//
//   s_n   normal tooth thickness at the reference cylinder, mm     s_c   constant chord, mm
//   h_c   height of the tip over the chord, mm                     α_n   pressure angle of the rack
//                                              theory: docs/theory/10-inspection.md
//
// The common normals of rack and tooth intersect on the reference cylinder, in the middle of the tooth.
// The chord therefore depends on the rack and s_n only, not on the number of teeth or the helix angle.
#pragma once

#include <optional>

#include "gearwright/gear/gear.hpp"
#include "gearwright/inspection/usable_flank.hpp"

namespace gearwright {

struct ConstantChord {
  double chord;             ///< s_c  mm
  double tip_to_chord;      ///< h_c  mm, from the actual tip
  double contact_diameter;  ///< mm
  ContactPlace place;
};

/// The constant chord of a gear.
///
/// Formula   s_c = s_n cos² α_n, h_c = ±(d_a − d)/2 − s_n sin α_n cos α_n/2; [T10.13], [T10.14]
/// Units     mm
/// None      if there is no usable flank
std::optional<ConstantChord> constant_chord(const Gear& gear);

}  // namespace gearwright
