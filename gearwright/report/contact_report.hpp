// The contact data of the report in addition to its scene: patterns, maps, and the names and values
// of the assumed errors.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/figure/contact_figures.hpp"
#include "gearwright/pair/arc_pair.hpp"

namespace gearwright {

/// The pattern on gear 1 under one error alone, or under all of them.
struct PatternUnder {
  std::string name;  ///< "out-of-plane shaft deviation +0.03°"; plain text
  FlankRaster pattern;
  Angle peak_to_peak;         ///< NaN if nothing touches
  bool as_specified = false;  ///< all errors together, as in the other pictures
};

struct ContactReport : ContactScene {
  ContactResult other;            ///< the non-working flanks, at the same positions
  std::optional<Angle> min_play;  ///< of gear 2; < 0 if the gears jam
  std::array<FlankRaster, 2> patterns;
  std::optional<ContactPoint> middle;      ///< the touching position nearest to the middle
  FlankRaster middle_gap;                  ///< on gear 1, at that position
  std::vector<NamedAmount> errors;         ///< those other than zero
  std::vector<std::string> modifications;  ///< "gear 1: tip relief 15 µm"; plain text
  std::vector<PatternUnder> under;         ///< may be empty
  std::optional<ContactMap> map;
  const ArcPair* arc_pair = nullptr;  ///< the pair, if its gears have circular-arc teeth
  /// The halves of a double-helical pair at z > 0 and at z < 0, or one of them if they are mirror images.
  /// They have patterns and the gap only, and the other members are those of the whole gears.
  std::vector<ContactReport> halves;
};

inline constexpr double kConjugate = 1e-6;  ///< arcsec; a smaller peak-to-peak value is a rounding
                                            ///< error

/// The result of tooth contact in one or two sentences of plain text, for all interfaces. The sentences
/// state the transmission error, and whether the flanks touch along lines, in points or at edges.
std::string contact_words(const ContactResult& contact);

}  // namespace gearwright
