// Computes the finished half tooth from the edge of a cutter. It is the envelope of every arc,
// without the parts that other arcs remove, between root circle and tip.
//
// Each arc of the edge gives branches along which the radius grows. A cusp ends a branch, and parts
// that run backward lie inside the cut. The tooth is the region that remains between the branches,
// |θ| < min θ(ρ). Two neighbours that do not join smoothly meet in a true intersection, which is
// found in a closed bracket.
//                            theory: docs/theory/03-rack-and-generation.md, [T3.11]…[T3.13]
#pragma once

#include <optional>

#include "gearwright/base/result.hpp"
#include "gearwright/generation/circular_fillets.hpp"
#include "gearwright/generation/outline.hpp"
#include "gearwright/generation/rack_envelope.hpp"
#include "gearwright/tool/cutter_edge.hpp"

namespace gearwright {

/// A half tooth as cut, with flags for special cases. A tooth that cannot exist has flags and no
/// arcs.
struct GeneratedTooth {
  GeneratedTooth() = default;  ///< empty; not an aggregate, so that only cut_by_rack() can make a
                               ///< tooth
  Outline outline;             ///< empty when `through_axis` or `severed`
  double root_radius;          ///< mm, signed; negative if the cutter passes through the axis
  double tip_radius;  ///< mm, actual end of the tooth: blank, bottom of the cutter or point
  std::optional<double> form_radius;      ///< mm, start of the flank; none if no flank is left
  std::optional<double> tip_form_radius;  ///< mm, end of the flank
  std::optional<Angle> neck_half_angle;   ///< smallest half angle of the root fillet, signed
  std::optional<double> neck_radius;      ///< mm, radius of the neck
  bool through_axis = false;              ///< the root circle would have a radius of 0 or less
  bool severed = false;          ///< true if the root fillets of both flanks meet (tooth cut off)
  bool pointed = false;          ///< the two sides meet before the blank or the cutter ends them
  bool tip_cut_by_rack = false;  ///< the cutter's bottom land, not the blank, ends the tooth
  bool rounded_tip = false;      ///< a tip fillet ends the tooth on its centre line, without a land
  std::optional<FilletArc> root_fillet, tip_fillet;  ///< the circular ones, if requested
};

/// Returns the tip radius, mm, that the bottom land of the rack leaves if the blank does not end
/// the tooth earlier. It is infinite if the rack has no bottom land.
double left_by_land(const CutterEdge& edge, const RackMotion& motion);

/// Cuts a tooth with a rack and replaces root and tip by circular fillets if requested.
///
/// Units     mm, rad
/// Domain    teeth ≥ 1 (contract)
/// Errors    `tip_diameter_mm` if the blank is no larger than the root circle; `root_fillet`,
///           `tip_fillet` if the rack leaves no flank where they touch
Result<GeneratedTooth> cut_by_rack(const CutterEdge& edge, const RackMotion& motion, int teeth,
                                   double blank_radius, const CircularFillets& fillets = {});

}  // namespace gearwright
