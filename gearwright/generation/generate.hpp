// Computes the finished half tooth from the edge of a cutter: the envelope of every arc, without
// the parts that other arcs remove, between root circle and tip.
//
// Each arc of the edge gives branches along which the radius grows (a cusp ends a branch, and parts
// that run backward lie inside the cut). The tooth is the region that remains between the branches,
// |θ| < min θ(ρ). Two neighbours that do not join smoothly meet in a true intersection, found in
// closed bracket.
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
  GeneratedTooth() = default;  ///< empty, and not an aggregate; cut_by_rack() makes it
  Outline outline;             ///< empty when `through_axis` or `severed`
  double root_radius;          ///< mm, signed; negative if the cutter passes through the axis
  double tip_radius;           ///< mm, actual end of the tooth: blank, cutter's bottom or point
  std::optional<double> form_radius;  ///< mm, where the flank starts; none when no flank is left
  std::optional<double> tip_form_radius;  ///< mm, where it ends
  std::optional<Angle> neck_half_angle;   ///< smallest half angle of the root fillet, signed
  std::optional<double> neck_radius;      ///< mm, where that is
  bool through_axis = false;              ///< the root circle would have no or a negative radius
  bool severed = false;  ///< true if the root fillets of both flanks meet (tooth cut off)
  bool pointed = false;  ///< the sides meet before the blank or the cutter's bottom ends them
  bool tip_cut_by_rack = false;  ///< the cutter's bottom land, not the blank, ends the tooth
  bool rounded_tip = false;      ///< a tip fillet ends the tooth on its centre line, without a land
  std::optional<FilletArc> root_fillet, tip_fillet;  ///< the circular ones, if requested
};

/// The tip radius that the bottom land of the rack leaves if the blank does not end the tooth
/// earlier, mm; infinite if the rack has none.
double left_by_land(const CutterEdge& edge, const RackMotion& motion);

/// Cuts a tooth with a rack and replaces root and tip by circular fillets if requested.
///
/// Units     mm, rad
/// Domain    teeth ≥ 1 (contract)
/// Errors    `tip_diameter_mm` when the blank is no larger than the root circle; `root_fillet`,
///           `tip_fillet` when the rack leaves no flank where they touch
Result<GeneratedTooth> cut_by_rack(const CutterEdge& edge, const RackMotion& motion, int teeth,
                                   double blank_radius, const CircularFillets& fillets = {});

}  // namespace gearwright
