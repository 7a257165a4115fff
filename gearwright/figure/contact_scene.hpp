// Contains the data of the contact figures, which are the gears, their mounted axes and the
// results.
//
//   TE   transmission error, rad: rotation by which gear 2 is ahead of |z1/z2| φ1, where φ1 is the
//        rotation of gear 1
//   δ    thickness of the marking compound, mm
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/contact/contact.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The axis of a gear as mounted with its errors, in the housing frame.
struct ContactAxis {
  Vec3 point = Vec3::Zero();  ///< mm, the middle of the gear's face
  Vec3 direction = Vec3(0, 0, 1);
};

/// An error or a modification with its name and value.
struct NamedAmount {
  std::string name;  ///< "out-of-plane shaft deviation"; plain text
  double value = 0.0;
  std::string unit;  ///< "°", "mm", "µm"
};

struct ContactScene {
  std::array<const Gear*, 2> gears{};
  std::array<ContactAxis, 2> axes;
  bool gear2_drives = false;
  double marking = 0.0;   ///< δ  mm
  int positions = 0;      ///< number of positions per pitch of gear 1
  ContactResult driving;  ///< results at `positions` positions of one pitch, from −½ pitch
  /// Peak-to-peak values of the continuous TE of the working flanks and of the non-working flanks.
  /// A value is missing if contact is lost or if the value was not computed.
  std::array<std::optional<Angle>, 2> span{};
  /// Suffix of the ids of figures. It is "-2" for the second half of a double-helical pair,
  /// otherwise empty.
  std::string part{};
};

/// Makes the scene of a pair whose contact was computed over one pitch.
ContactScene contact_scene(const std::array<const Gear*, 2>& gears, const ContactPair& pair,
                           double marking, ContactResult driving);

/// Replaces the axes by their mirror images in the plane z = 0. Their directions still point to +z.
void mirror_axes(ContactScene& scene);

/// Returns the angular pitch of gear 1, rad.
double pitch_of(const ContactScene& scene);

/// Returns the name of a kind of contact, for example "tip edge of gear 1".
const char* words_of(TouchKind kind);

/// Returns the number of a tooth pair with its sign. "0" is the pair nearest the centre line.
std::string pair_words(int k);
/// Returns the style class of a tooth pair. Successive pairs use three classes in turn.
const char* pair_style(int k);

/// Returns a value in arc seconds, with a number of decimals that suits its size.
std::string shown_arcsec(double arcsec);
int arcsec_decimals(double arcsec);

/// The unit of a transmission error, which is seconds of arc or, along a rack, µm.
struct TeUnit {
  double per_rad;
  const char* symbol;  ///< "″" or " µm"
  const char* words;   ///< "arc seconds" or "µm"

  double of(Angle angle) const { return per_rad * angle.rad(); }
  std::string text(Angle angle) const { return shown_arcsec(of(angle)) + symbol; }  ///< "12.35″"
};
TeUnit te_unit(const RackTravel& rack);

/// Returns the amount with its sign and unit, "+0.03°", "−0.02 mm".
std::string words_of(const NamedAmount& amount);

/// Position of a housing point relative to a gear. It consists of the height along the gear axis,
/// mm, and of the radius, mm.
struct FlankPlace {
  double height, radius;
};
FlankPlace place_on(const ContactAxis& axis, const Vec3& point);

/// Returns the contact ellipse on gear `which` (0, 1) as a closed polygon of points (height,
/// radius). The ellipse lies in the tangent plane at the contact point and is projected along the
/// direction of motion of the tooth. The result is empty if the contact has no ellipse, or if the
/// ellipse is unbounded.
///
/// Units     mm
std::vector<FlankPlace> ellipse_on(const ContactScene& scene, const ContactPoint& p,
                                   std::size_t which);

}  // namespace gearwright
