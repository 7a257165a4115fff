// What the page tells about tooth contact, as plain data: results, patterns, maps, and the names
// and values of what was assumed.
//
//   TE   transmission error, rad: how far gear 2 is ahead of the ratio, > 0
//   δ    thickness of the marking compound, mm
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/error_map.hpp"
#include "gearwright/contact/pattern.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/pair/arc_pair.hpp"

namespace gearwright {

/// An axis as mounted, errors and all, in the housing.
struct ContactAxis {
  Vec3 point = Vec3::Zero();  ///< mm, the middle of the gear's face
  Vec3 direction = Vec3(0, 0, 1);
};

/// An error or a modification in plain words.
struct NamedAmount {
  std::string name;  ///< "out-of-plane shaft deviation"; plain text
  double value = 0.0;
  std::string unit;  ///< "°", "mm", "µm"
};

/// The pattern on gear 1 under one error alone, or under all.
struct PatternUnder {
  std::string name;  ///< "out-of-plane shaft deviation +0.03°"; plain text
  FlankRaster pattern;
  Angle peak_to_peak;         ///< NaN: nothing touches
  bool as_specified = false;  ///< all errors at once: what the other pictures show
};

/// Peak to peak over two errors.
struct ContactMap {
  ErrorMap map;                     ///< rad over the units below
  std::array<NamedAmount, 2> axes;  ///< of x and y: names, units and the values of the spec
};

struct ContactReport {
  std::array<const Gear*, 2> gears{};
  std::array<ContactAxis, 2> axes;
  bool gear2_drives = false;
  double marking = 0.0;           ///< δ  mm
  int positions = 0;              ///< per pitch
  ContactResult driving;          ///< `positions` of one pitch, from −half a pitch on
  ContactResult other;            ///< the non-working flanks, at the same positions
  std::optional<Angle> min_play;  ///< of gear 2; < 0: the gears jam
  std::array<FlankRaster, 2> patterns;
  std::optional<ContactPoint> middle;      ///< the position nearest to the middle that touches
  FlankRaster middle_gap;                  ///< on gear 1, there
  std::vector<NamedAmount> errors;         ///< those that are not zero
  std::vector<std::string> modifications;  ///< "gear 1: tip relief 15 µm"; plain text
  std::vector<PatternUnder> under;         ///< may be empty
  std::optional<ContactMap> map;
  const ArcPair* arc_pair = nullptr;  ///< the pair, of gears with circular-arc teeth
};

/// The pitch of gear 1, rad.
double pitch_of(const ContactReport& report);

/// "tip edge of gear 1"
const char* words_of(TouchKind kind);

/// A tooth pair's number with its sign; "0" is the one nearest the centre line.
std::string pair_words(int k);

/// Arc seconds with the digits that a reader can use.
std::string shown_arcsec(double arcsec);

inline constexpr double kConjugate = 1e-6;  ///< arcsec: a peak to peak below it is rounding

/// What tooth contact comes to, in the words of every door: how unevenly gear 2 runs, and whether
/// flanks touch, along lines or in points, or edges. One or two sentences, plain text.
std::string contact_words(const ContactResult& contact);

/// Place of a point of the housing on a gear: height along its axis and radius, mm.
struct FlankPlace {
  double height, radius;
};
FlankPlace place_on(const ContactAxis& axis, const Vec3& point);

/// The contact ellipse as gear `which` (0, 1) carries it, seen along the tooth's direction of
/// motion: points (height, radius), closed. None where it has no end, or there is none.
///
/// Units     mm, true size: the tangent plane of the contact point, projected
std::vector<FlankPlace> ellipse_on(const ContactReport& report, const ContactPoint& p,
                                   std::size_t which);

/// Signed and short, "+0.03°", "−0.02 mm".
std::string words_of(const NamedAmount& amount);

}  // namespace gearwright
