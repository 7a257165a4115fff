// Contact of a double-helical pair. One of its gears floats along its axis. The file computes the
// contact of both halves and the motion of the whole gears.
//
//   e_A, e_B   TE of the half at z > 0 and of the half at z < 0
//   k          rotation of gear 2 per axial displacement of gear 1, rad/mm; equal to
//              (z1/z2) tan β/r_1, where β is the helix angle of half A
//   s          stagger of half B, pitches
//
// Each half is a helical pair. Half B is replaced by its mirror image in the plane z = 0. The
// mirror image has the teeth of half A, and its errors are computed by mirrored(). The axial forces
// on the floating gear cancel, so both halves touch and transmit the same torque:
//
//   TE = (e_A + e_B)/2,   Δz = (e_B − e_A)/(2k)      theory: docs/theory/08-contact.md, [T8.27]
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/contact/pattern.hpp"

namespace gearwright {

/// z of the middle of half A of a double-helical gear, mm.
///
/// Domain    a gear with a gap, which may be 0 (contract)
double middle_of_half(const Gear& half);

/// Returns the difference that the stagger causes: rotation of half B minus rotation of gear 1.
Angle behind(double stagger, const Gear& gear_1);
/// Returns the rotations at which half B is analysed if the whole gear 1 is analysed at
/// `rotations`. If `rotations` is empty, equal steps with `positions` per pitch are used. Without a
/// stagger, both halves have the same rotations, and the function returns `rotations` unchanged.
std::vector<Angle> rotations_of_second(const Gear& gear_1, double stagger,
                                       std::vector<Angle> rotations, int positions, int pitches);

/// Converts the pattern on the mirror image of half B to the pattern on half B.
FlankRaster in_mirror(const FlankRaster& raster);

/// True if, at all rotations, half B of a pair with these errors is the mirror image of half A.
inline bool alike_halves(double stagger, const ContactErrors& errors) {
  return stagger == 0.0 && errors == mirrored(errors);
}

/// A double-helical pair under its errors, driven by one of its gears.
struct HalvesMesh {
  const Gear* gear_1 = nullptr;              ///< gear 1 of half A
  std::array<const ContactPair*, 2> half{};  ///< A, and the mirror image of B
  double stagger = 0.0;                      ///< s

  Angle behind() const { return gearwright::behind(stagger, *gear_1); }
  bool alike() const { return alike_halves(stagger, half[0]->place().errors); }
};

/// The pairs of both halves under the same errors. The pairs own their gears.
struct HalvesPair {
  std::array<std::shared_ptr<const ContactPair>, 2> half;  ///< A, and the mirror image of B
  HalvesMesh mesh;                                         ///< mesh of both pairs in `half`
};

/// Makes both halves of a double-helical pair under any errors.
class HalvesSetup {
 public:
  /// `setup` has the teeth of half A. `side` is −1 if half A lies at z < 0, and otherwise 1.
  ///
  /// Domain    the setup of a pair whose gears have a gap (contract)
  HalvesSetup(const ContactSetup& setup, double stagger, double side = 1.0);
  HalvesPair pair(const ContactErrors& errors, bool gear2_drives) const;
  const ContactSetup& half(bool below) const { return half_[below]; }
  double stagger() const { return stagger_; }

 private:
  std::array<ContactSetup, 2> half_;
  double stagger_;
};

/// The contact of both halves and of the whole gears at the same rotations of the gears.
struct HalvesContact {
  std::array<ContactResult, 2> half{};  ///< A and B
  /// The contact of the mirror image of half B, at the rotations of rotations_of_second().
  ContactResult image{};
  /// The rotations and the TE of the whole gears at every position. The point of contact is NaN,
  /// because each half touches at a point of its own. `kind` comes from half A. If only half B
  /// touches at an edge, `kind` comes from half B. If a half has no contact, `kind` is none.
  ContactResult whole{};
  std::vector<double> float_axial{};  ///< Δz  mm, of gear 1 relative to gear 2; NaN without contact

  /// Returns the positions of half A, followed by the positions of the mirror image of half B. A
  /// verdict on these positions applies to both halves.
  ContactResult on_halves() const;
};

/// Analyses the contact of both halves and of the whole gears. The derivatives of both halves refer
/// to the errors of the whole pair, and not to those of the mirror image.
///
/// Formula   [T8.27]
/// Domain    as for a ContactPair
HalvesContact analyse_contact(const HalvesMesh& mesh, const ContactRequest& request);

/// TE of the whole gears over one pitch, at the positions of transmission_error() of a ContactPair.
std::vector<double> transmission_error(const HalvesMesh& mesh, int positions);

/// Returns the peak to peak of the continuous curve of TE, or none if a half loses contact. The
/// function uses at least kLeastSpanPositions.
///
/// Accuracy  1e-12 rad at the extremes that are found. A branch may be overlooked if it has the
///           greatest T for less than one step. A step is the pitch divided by the number of
///           positions
std::optional<Angle> continuous_span(const HalvesMesh& mesh, int positions);

}  // namespace gearwright
