// A number of a strength rating. It is stored with the clause of the standard and the branch of the
// formula from which it was computed, so that users can compare it with another report.
//
// Clause and branch are string literals, so they cost no time. The design search can therefore use
// the same functions.
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "gearwright/base/numbers.hpp"

namespace gearwright {

/// Editions of ISO 6336-1, -2 and -3, and the guideline VDI 2736 for plastics. The changes in the
/// later edition of ISO 6336 are listed in docs/theory/11-rating.md.
enum class RatingEdition { iso_2006, iso_2019, vdi_2736 };

inline std::string_view name(RatingEdition edition) {
  constexpr std::array<std::string_view, 3> kNames{"ISO 6336:2006", "ISO 6336:2019",
                                                   "VDI 2736:2014"};
  return kNames[static_cast<std::size_t>(edition)];
}

struct Factor {
  double value = 1.0;
  const char* formula = "";  ///< "ISO 6336-3, clause 8"
  const char* branch = "";   ///< "helical, ε_β ≥ 1"; empty if the formula has only one form
};

inline constexpr Factor kNoFactor{kNoNumber, "", ""};
inline bool is_there(const Factor& f) { return !std::isnan(f.value); }

/// The two values of a factor. They belong either to pinion and wheel, or to gear 1 and gear 2.
using FactorPair = std::array<Factor, 2>;

inline constexpr const char* kGivenFactor = "given by the user";
inline constexpr const char* kSearchDefault = "default of a search, not given by the user";
inline constexpr const char* kNotAsked = "not given, so 1 is used";

}  // namespace gearwright
