// What the report tells about tooth contact beside its scene: patterns, maps, and the names and values
// of what was assumed.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/figure/contact_figures.hpp"
#include "gearwright/pair/arc_pair.hpp"

namespace gearwright {

/// The pattern on gear 1 under one error alone, or under all.
struct PatternUnder {
  std::string name;  ///< "out-of-plane shaft deviation +0.03°"; plain text
  FlankRaster pattern;
  Angle peak_to_peak;         ///< NaN: nothing touches
  bool as_specified = false;  ///< all errors at once: what the other pictures show
};

struct ContactReport : ContactScene {
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

inline constexpr double kConjugate = 1e-6;  ///< arcsec: a peak to peak below it is rounding

/// What tooth contact comes to, in the words of every door: how unevenly gear 2 runs, and whether
/// flanks touch, along lines or in points, or edges. One or two sentences, plain text.
std::string contact_words(const ContactResult& contact);

}  // namespace gearwright
