// The keys of [search] for a search for pairs.
#pragma once

#include <string_view>

#include "gearwright/catalogue/key.hpp"
#include "gearwright/design/search_problem.hpp"

namespace gearwright {

const KeyTable& search_keys();

/// Returns the modules of the series "ISO54-I", "ISO54-II" or "ISO54-I+II", in mm and in ascending
/// order. Returns an empty list for any other name.
std::vector<double> module_series(std::string_view name);

/// The word for teeth without allowances, which a spec may give in place of a series of DIN 3967.
inline constexpr std::string_view kNoAllowances = "none";
/// Returns the reason for rejecting a name that is not a series of thickness allowances of DIN
/// 3967. Returns an empty text for such a series, for kNoAllowances and for an empty name.
std::string series_fault(const std::string& series);

/// Returns the range of the coefficients of friction that are allowed for flanks.
KeyRange friction_range();

/// One number, or the least and the greatest number of a band.
inline constexpr KeyList kBand{
    .most = 2,
    .single = true,
    .order = {.sentence = "is an empty band, because no number lies between {} and {}; write the "
                          "least value first"}};

/// Returns the objective of which a word is a synonym, for example "mass" for "weight". Returns an
/// empty text if the word is not a synonym. The objective may belong to searches for pairs, to
/// searches for drives, or to both.
std::string_view objective_called(std::string_view word);

}  // namespace gearwright
