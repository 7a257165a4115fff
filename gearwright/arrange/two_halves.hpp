// Describes double-helical gears. Such a gear has two halves of opposite hands on one body, with or
// without a gap.
//
// Each half is an ordinary helical gear. Two mating halves form a helical pair with the face width
// of a half. The pair of the halves at z > 0 is arranged and mounted.
//
//   b      whole face with the gap, mm     b_B  face of one half, (b − gap)/2, mm
//   d_a0   outer diameter of the hob, mm           γ_0   lead angle of the hob
//   l_0    half of the cutting length of the hob, mm
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
  std::optional<double> hob_run_out;      ///< mm, least gap for the run-out of the hob
  /// Δz/e: axial shift of the floating gear per index error e between its halves. With this
  /// shift, both halves have the same share of the error.
  double axial_shift_per_index_error;
};

/// Replaces each double-helical gear by one of its halves.
///
/// Formula   [T2.42]
/// Errors    `gearN.face_width` if it is absent; `gearN.double_helical.gap` if the gap leaves no
///           face width for the halves;
///           `gearN.double_helical` if it is absent and the mating gear is double-helical;
///           `gear2.double_helical.gap` if the halves are not opposite each other;
///           `gear2.double_helical.stagger_pitches` if the staggers differ
std::optional<Error> halve(GivenPair& given);

/// Returns the values of a double-helical gear that follow from its input.
///
/// Formula   [T2.43], [T2.44]
/// Domain    `half` has the face width of one half
/// Errors    `helix_angle` if it is 0; `double_helical.groove_diameter` if the groove is not deeper
///           than the teeth; `double_helical.hob_diameter` if it is less than twice the depth of
///           the teeth
Result<Halves> halves_of(const Gear& half, const DoubleHelical& given);

/// Returns the given groove diameter, mm. If it is not given, returns d_f − m_n/2 for an external
/// gear and d_f + m_n/2 for an internal gear. Returns none without a gap.
std::optional<double> groove_diameter(const Gear& half, const DoubleHelical& given);

/// Returns a warning if staggered halves have no gap between them.
std::optional<Warning> stagger_warning(const Halves& halves, int which);

/// Returns a warning if the run-out of the hob needs a wider gap. Returns none if the gap is wide
/// enough or no hob is given.
std::optional<Warning> run_out_warning(const Halves& halves, int which);

}  // namespace gearwright
