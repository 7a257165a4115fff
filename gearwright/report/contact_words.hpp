// What tooth contact comes to, in the words of every door: how unevenly gear 2 runs, and whether
// flanks touch, along lines or in points, or edges.
#pragma once

#include <string>

#include "gearwright/contact/contact.hpp"

namespace gearwright {

inline constexpr double kConjugate = 1e-6;  ///< arcsec: a peak to peak below it is rounding

/// One or two sentences, plain text.
std::string contact_words(const ContactResult& contact);

}  // namespace gearwright
