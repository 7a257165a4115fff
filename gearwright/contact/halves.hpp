// Contact of a double-helical pair: both halves, and the motion of the whole gears if one of them
// floats along its axis.
//
//   e_A, e_B   TE of the half at z > 0 and of the half at z < 0
//   k          rad of gear 2 per mm of gear 1 along its axis, (z1/z2) tan β/r_1 of half A
//   s          stagger of half B, pitches
//
// A half is a helical pair of its own. Half B is computed as its mirror image in the plane z = 0,
// which has the teeth of half A and the errors of mirrored(). Both halves transmit the same torque,
// because the axial forces on the floating gear cancel, so both touch:
//
//   TE = (e_A + e_B)/2,   Δz = (e_B − e_A)/(2k)      theory: docs/theory/08-contact.md, [T8.27]
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/pattern.hpp"

namespace gearwright {

/// z of the middle of half A of a double-helical gear, mm.
///
/// Domain    a gear with a gap, which may be 0 (contract)
double middle_of_half(const Gear& half);

/// The rotation of half B relative to that of the gears.
Angle behind(double stagger, const Gear& gear_1);

/// The rotations of half B and of its mirror image, for those of the gears. Empty if `rotations` is
/// empty, which stands for `positions` per pitch, and half B is at the same ones.
std::vector<Angle> rotations_of_second(const Gear& gear_1, double stagger,
                                       std::vector<Angle> rotations, int positions, int pitches);

/// A pattern on half B from that of its mirror image.
FlankRaster in_mirror(const FlankRaster& raster);

/// A double-helical pair under its errors, driven by one of its gears.
struct HalvesMesh {
  const Gear* gear_1 = nullptr;              ///< of half A
  std::array<const ContactPair*, 2> half{};  ///< A, and the mirror image of B
  double stagger = 0.0;                      ///< s

  /// The rotation of half B relative to that of the gear.
  Angle behind() const { return gearwright::behind(stagger, *gear_1); }
  /// True if half B equals the mirror image of half A at all rotations.
  bool alike() const {
    return stagger == 0.0 && half[0]->place().errors == half[1]->place().errors;
  }
};

/// Half B itself, from the analysis of its mirror image at rotations_of_second(): contact points,
/// normals and derivatives, which are by the errors of the pair and not by those of the image.
///
/// Domain    `per_pitch` is the number of positions in one pitch, 0 if the rotations were given
ContactResult second_half(const HalvesMesh& mesh, const ContactResult& image,
                          const std::vector<Influence>& influences, int per_pitch);

/// Both gears, from the results of the halves at the same rotations.
struct WholeContact {
  /// Rotations and TE of every position; the place of contact is NaN. `kind` is that of half A, or
  /// an edge that touches on half B only.
  ContactResult result;
  std::vector<double> float_axial;  ///< Δz  mm, of gear 1 relative to gear 2; NaN without contact
};

/// Formula   [T8.27]
/// Domain    results at the same positions (contract); `per_pitch` as for second_half()
WholeContact whole_contact(const HalvesMesh& mesh, const std::array<const ContactResult*, 2>& half,
                           int per_pitch);

/// TE of the whole gears over one pitch, as transmission_error() of a pair.
std::vector<double> transmission_error(const HalvesMesh& mesh, int positions);

/// Peak to peak of the continuous curve of TE; none if a half loses contact.
///
/// Accuracy  1e-12 rad at the extremes that it finds; a branch that leads for less than a step of
///           `positions` per pitch may be overlooked
std::optional<Angle> continuous_span(const HalvesMesh& mesh, int positions);

}  // namespace gearwright
