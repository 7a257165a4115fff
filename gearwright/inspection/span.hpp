// Span measurement: the distance of two parallel anvils over k teeth, or between k spaces of an
// internal gear.
//
//   k      teeth (internal: spaces) between the anvils    W_k   the reading, mm
//   p_bt   transverse base pitch, mm                      β_b   base helix angle, rad
//   s_bt   transverse base tooth thickness, mm            d_M   diameter of both contacts, mm
//                                              theory: docs/theory/10-inspection.md
//
// The anvils are planes normal to the base tangent, and an involute helicoid unwinds from it, so
// the reading is exactly a length of the base tangent, at any helix angle. Both contacts may be
// moved along the flanks. Symmetrical contacts are on the usable flank if any are.
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
  double min_face_width;    ///< mm, least face width with both contacts
  ContactPlace place;
  bool face_is_wide_enough;

  bool usable() const { return place == ContactPlace::usable && face_is_wide_enough; }
};

/// W_k over any k, also if an anvil cannot reach the flanks.
///
/// Formula   W_k = cos β_b ((k − 1) p_bt + s_bt), internal (spur) k p_bt − s_bt; [T10.2]
/// Units     mm
double span_length(const Gear& gear, int k);

/// The change of the normal tooth thickness at the reference cylinder per change of W_k: ±1/cos α_n.
double thickness_per_span(const Gear& gear);

/// The span over k teeth and its contacts. [T10.2], [T10.3]
///
/// Errors    `span_teeth` if neither k nor a neighbour has contacts, with the k that can be
///           measured; also for an internal helical gear, whose flanks leave no room for plane
///           anvils
Result<Span> span_over(const Gear& gear, int k);

/// The spans whose contacts lie on the usable flank, at most `most` nearest to the usual one.
std::vector<Span> usable_spans(const Gear& gear, int most);

/// The span whose contacts are nearest to the V circle; none if no k is usable.
std::optional<Span> usual_span(const Gear& gear);

}  // namespace gearwright
