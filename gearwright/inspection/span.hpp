// Span measurement: what two parallel anvils read over k teeth, or between k spaces of an internal
// gear.
//
//   k      teeth (internal: spaces) between the anvils    W_k   the reading, mm
//   p_bt   transverse base pitch, mm                      β_b   base helix angle, rad
//   s_bt   transverse base tooth thickness, mm            d_M   diameter of both contacts, mm
//                                              theory: docs/theory/10-inspection.md
//
// The anvils are planes normal to the base tangent, and an involute helicoid is unwound from it: the
// reading is a length of the base tangent, exactly, at any helix angle. Both contacts may be moved
// along the flanks; laid symmetrically they are on the usable flank if they can be there at all.
#pragma once

#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/inspection/usable_flank.hpp"

namespace gearwright {

struct Span {
  int teeth;                ///< k; an internal gear's spaces
  double length;            ///< W_k  mm
  double contact_diameter;  ///< d_M  mm
  double min_face_width;    ///< mm: both contacts exist on a wider gear only
  ContactPlace place;
  bool face_is_wide_enough;

  bool usable() const { return place == ContactPlace::usable && face_is_wide_enough; }
};

/// W_k over any k, whether an anvil gets there or not.
///
/// Formula   W_k = cos β_b ((k − 1) p_bt + s_bt), internal (spur) k p_bt − s_bt; [T10.2]
/// Units     mm
double span_length(const Gear& gear, int k);

/// The change of the normal tooth thickness at the reference cylinder per change of W_k: ±1/cos α_n.
double thickness_per_span(const Gear& gear);

/// The span over k teeth, and where it touches. [T10.2], [T10.3]
///
/// Errors    `span_teeth`: no contact, nor a neighbour that has one, with the k that can be measured;
///           an internal helical gear, between whose flanks there is no room for plane anvils
Result<Span> span_over(const Gear& gear, int k);

/// The spans whose contacts lie on the usable flank, at most `most` nearest to the usual one.
std::vector<Span> usable_spans(const Gear& gear, int most);

/// The one that touches nearest to the V circle; none: no k is usable.
std::optional<Span> usual_span(const Gear& gear);

}  // namespace gearwright
