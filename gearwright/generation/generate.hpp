// Computes the finished half tooth from the edge of a cutter. Between root circle and tip, the
// outline consists of the envelopes of all arcs of the edge, without the parts that other arcs
// remove.
//
// Each arc of the edge gives branches along which the radius increases. A cusp ends a branch. Parts
// of an envelope with decreasing radius lie inside the cut. The tooth is the region that remains
// between the branches, |θ| < min θ(ρ). If two neighbouring branches do not join smoothly, they
// intersect, and the intersection is found in a closed bracket.
//                            theory: docs/theory/03-rack-and-generation.md, [T3.11]…[T3.13]
#pragma once

#include <optional>

#include "gearwright/base/result.hpp"
#include "gearwright/generation/circular_fillets.hpp"
#include "gearwright/generation/outline.hpp"
#include "gearwright/generation/rack_envelope.hpp"
#include "gearwright/tool/cutter_edge.hpp"

namespace gearwright {

/// A half tooth as cut, with flags for special cases. If the tooth cannot exist, it has flags and
/// no arcs.
struct GeneratedTooth {
  GeneratedTooth() = default;  ///< an empty tooth; cut_by_rack() and cut_by_pinion() make teeth
  Outline outline;             ///< empty if `through_axis` or `severed` is true
  double root_radius;          ///< mm, signed; negative if the cutter passes through the axis
  double tip_radius;  ///< mm, end of the tooth: at the blank, the bottom of the cutter or the point
  std::optional<double> form_radius;      ///< mm, start of the flank; empty if no flank is left
  std::optional<double> tip_form_radius;  ///< mm, end of the flank
  std::optional<Angle> neck_half_angle;   ///< smallest half angle of the root fillet, signed
  std::optional<double> neck_radius;      ///< mm, radius at the neck_half_angle
  bool through_axis = false;  ///< true if the root circle would have a radius of 0 or less
  bool severed = false;       ///< true if the root fillets of both flanks meet (tooth cut off)
  bool pointed = false;       ///< true if the two flanks meet before blank or cutter ends the tooth
  bool tip_cut_by_rack = false;  ///< true if the bottom land of the cutter ends the tooth
  bool rounded_tip = false;      ///< true if a tip fillet without a land ends the tooth
  std::optional<FilletArc> root_fillet, tip_fillet;  ///< circular fillets, if requested
};

/// Returns the radius, mm, at which the bottom land of the rack ends the tooth. It is infinite if
/// the rack has no bottom land.
double left_by_land(const CutterEdge& edge, const RackMotion& motion);

/// Cuts a tooth with a rack and replaces root and tip by circular fillets if requested.
///
/// Units     mm, rad
/// Domain    teeth ≥ 1 (contract)
/// Errors    `tip_diameter` if the blank is no larger than the root circle; `root_fillet`,
///           `tip_fillet` if the rack leaves no flank at the point of tangency;
///           `root_fillet.offset`, `tip_fillet` if a fillet leaves no flank
Result<GeneratedTooth> cut_by_rack(const CutterEdge& edge, const RackMotion& motion, int teeth,
                                   double blank_radius, const CircularFillets& fillets = {});

}  // namespace gearwright
