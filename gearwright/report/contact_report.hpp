// The data of the report on tooth contact. In addition to the data of ContactScene, the report
// needs the patterns, the map, and the names and values of the assumed errors.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/figure/contact_figures.hpp"
#include "gearwright/pair/arc_pair.hpp"

namespace gearwright {

/// The pattern on gear 1 under a single error, or under all errors together.
struct PatternUnder {
  std::string name;  ///< "out-of-plane shaft deviation +0.03°"; plain text
  FlankRaster pattern;
  std::optional<Angle> peak_to_peak;  ///< peak-to-peak TE. If contact is not lost, it is computed
                                      ///< for the continuous curve. None if no teeth touch
  bool as_specified = false;          ///< true for all errors together, as in the other pictures
};

struct ContactReport : ContactScene {
  ContactResult other;            ///< the non-working flanks, at the positions of `driving`
  std::optional<Angle> min_play;  ///< least backlash, rotation of gear 2; < 0 if the gears jam
  std::array<FlankRaster, 2> patterns;
  std::optional<ContactPoint> middle;      ///< the contact point nearest to the middle of the flank
  FlankRaster middle_gap;                  ///< gap on gear 1 at the position of `middle`
  std::vector<NamedAmount> errors;         ///< the errors that are not zero
  std::vector<std::string> modifications;  ///< "gear 1: tip relief 15 µm"; plain text
  std::vector<PatternUnder> under;         ///< may be empty
  std::optional<ContactMap> map;
  const ArcPair* arc_pair = nullptr;  ///< the pair, if its gears have circular-arc teeth
  /// The halves of a double-helical pair at z > 0 and z < 0. There is only one entry if the halves
  /// are mirror images. An entry contains only its ContactScene, patterns and gap. All other data
  /// of this report belong to the whole gears.
  std::vector<ContactReport> halves;
};

/// Peak-to-peak transmission errors below this value, arcsec, are due to rounding. The flanks are
/// then conjugate.
inline constexpr double kConjugate = 1e-6;

/// Returns the result of tooth contact in a few sentences of plain text, for all interfaces. The
/// text states the transmission error, and whether the flanks touch along lines, at points or at
/// edges. If contact is lost, it states only this. `span` is the peak-to-peak value of the
/// continuous transmission error, if it was computed.
std::string contact_words(const ContactResult& contact, std::optional<Angle> span = {});

}  // namespace gearwright
