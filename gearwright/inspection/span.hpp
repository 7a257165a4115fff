// Computes the span measurement, which is the distance between two parallel anvils over k teeth, or
// over k spaces of an internal gear.
//
//   k      teeth (internal: spaces) between the anvils    W_k   the reading, mm
//   p_bt   transverse base pitch, mm                      β_b   base helix angle, rad
//   s_bt   transverse base tooth thickness, mm            d_M   diameter of both contacts, mm
//                                              theory: docs/theory/10-inspection.md
//
// The anvils are planes normal to a base tangent, so at any helix angle the reading is exactly a
// length along this tangent. The gauge can be moved along both flanks without a change of the
// reading. The results apply to the symmetrical position. If both contacts can lie on the usable
// flanks in some position, they also do so in the symmetrical position.
#pragma once

#include <vector>

#include "gearwright/base/result.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/inspection/evaluation_ranges.hpp"

namespace gearwright {

struct Span {
  int teeth;                ///< k; number of spaces for an internal gear
  double length;            ///< W_k  mm
  double contact_diameter;  ///< d_M  mm
  double min_face_width;    ///< mm, least face width that includes both contacts
  ContactPlace place;
  bool face_is_wide_enough;

  bool usable() const { return place == ContactPlace::usable && face_is_wide_enough; }
};

/// The reason why no span of an internal helical gear can be measured.
inline constexpr const char* kNoPlaneAnvils =
    "plane anvils do not fit into the tooth spaces of an internal helical gear; measure between "
    "balls";

/// Returns W_k for any k, even if an anvil cannot reach the flanks.
///
/// Formula   W_k = cos β_b ((k − 1) p_bt + s_bt); k p_bt − s_bt for an internal spur gear; [T10.2]
/// Units     mm
double span_length(const Gear& gear, int k);
/// Returns the change of the normal tooth thickness at the reference cylinder divided by the change
/// of W_k, which is ±1/cos α_n.
double thickness_per_span(const Gear& gear);

/// Returns the face width, mm, that measuring practice requires for a span of a helical gear. With
/// this width, each anvil rests on enough of the flank and does not tip off. [T10.36]
double practical_face_width(const Gear& gear, const Span& span);

/// Returns the span over k teeth and its contacts. [T10.2], [T10.3]
///
/// Errors    `span_teeth` if the gear has no usable involute flank, if it is an internal helical
///           gear (plane anvils do not fit into its spaces), if k is not from 1 to |z|, if the
///           flanks do not face the anvils, or if the contacts lie beyond the tip and no
///           neighbouring k has contacts on the usable flank. The message gives the k that can be
///           measured
Result<Span> span_over(const Gear& gear, int k);
/// Returns the usable spans whose k is nearest to the k of usual_span(), at most `most` of them.
std::vector<Span> usable_spans(const Gear& gear, int most);
/// Returns the usable span whose contacts are nearest to the V circle, or none if no k is usable.
std::optional<Span> usual_span(const Gear& gear);

}  // namespace gearwright
