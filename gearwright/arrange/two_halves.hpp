// Double-helical gears: two halves of opposite hands on one body, with a gap or without one.
//
// Each half is an ordinary helical gear, and two halves mesh as a helical pair with the face width of a
// half. The half at z > 0 is arranged and mounted.
//
//   b      whole face with the gap, mm     b_B  face of one half, (b − gap)/2, mm
//   d_a0   outer diameter of the hob, mm   l_0  half its cutting length, mm     γ_0  its lead angle
//   h      depth of the teeth, mm          theory: docs/theory/02-involute-and-pair.md, 2.11
#pragma once

#include <optional>

#include "gearwright/arrange/arrange.hpp"

namespace gearwright {

/// A double-helical gear, and the values derived from its input.
struct Halves {
  DoubleHelical given;
  double face_width = 0.0;                ///< b    mm
  double half_face_width = 0.0;           ///< b_B  mm
  std::optional<double> groove_diameter;  ///< mm, as given or d_f ∓ m_n/2; none without a gap
  std::optional<double> hob_run_out;      ///< mm, the least gap for the run-out of the hob
  double axial_shift_per_index_error;  ///< Δz/e, the axial shift of the floating gear that divides
                                       ///< an index error between both halves
};

/// Replaces each double-helical gear by its half.
///
/// Formula   [T2.42]
/// Errors    `gearN.face_width` that is absent, `gearN.double_helical.gap` that leaves no half,
///           `gearN.double_helical` that is absent while the mating gear has one,
///           `gear2.double_helical.gap` if the halves are not opposite each other,
///           `gear2.double_helical.stagger_pitches` that differ
std::optional<Error> halve(GivenPair& given);

/// Formula   [T2.43], [T2.44]
/// Domain    `half` has the face of one half
/// Errors    `helix_angle` of 0, `double_helical.groove_diameter` of a groove that is not deeper than
///           the teeth, `double_helical.hob_diameter` of a hob that is less than twice as thick
///           as the teeth are deep
Result<Halves> halves_of(const Gear& half, const DoubleHelical& given);

/// The diameter of the groove between two halves, mm: as given, or d_f ∓ m_n/2; none without a gap.
std::optional<double> groove_diameter(const Gear& half, const DoubleHelical& given);

/// A warning that staggered halves have no gap between them.
std::optional<Warning> stagger_warning(const Halves& halves, int which);

/// A warning that the hob's run-out needs a wider gap; none if it does not, or if no hob is given.
std::optional<Warning> run_out_warning(const Halves& halves, int which);

}  // namespace gearwright
