#include "gearwright/verdict/rating_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gearwright::detail {

namespace {

// The number rounded down to three significant digits.
double rounded_down(double x) {
  const double step = std::pow(10.0, std::floor(std::log10(x)) - 2);
  return std::floor(x / step) * step;
}

}  // namespace

std::string rating_remedy(const JudgedRating& rating) {
  const RatedPair& pair = *rating.pair;
  const auto face = face_width_of_safety(pair, *rating.input, rating.wanted,
                                         kMostFaceModules * pair.normal_module);
  const auto steel = steel_of_safety(pair, *rating.input, rating.wanted);
  std::string text;
  if (face && *face > pair.face_width) {
    const double more = pair.halves * (*face - pair.face_width);
    const int digits = more < 1.0 ? 1 : 0;
    const double step = digits == 1 ? 10.0 : 1.0;
    text = fmt::format("{:.{}f} mm more face width", std::ceil(more * step) / step, digits);
  }
  if (steel) text += (text.empty() ? "" : ", or ") + *steel;
  if (!text.empty()) return text + " would be sufficient.";
  text = fmt::format(
      "No face width of up to {:g} modules and no other steel in the list would be sufficient "
      "on its own.",
      kMostFaceModules);
  const auto torque = torque_of_safety(pair, *rating.input, rating.wanted);
  // Rounding down ensures that the printed torque is permissible.
  if (torque)
    text += fmt::format(" The greatest permissible torque on gear 1 is {:g} N m.",
                        rounded_down(*torque));
  return text;
}

std::vector<Finding> rating_findings(const JudgedRating& rating) {
  std::vector<Finding> findings;
  const Rating& r = *rating.rating;
  const auto judge = [&](WarningCode code, const char* what, int gear, double safety,
                         double wanted) {
    if (safety >= wanted) return;
    const std::string less =
        safety < 1.0 ? "less than 1" : fmt::format("less than the required {:g}", wanted);
    findings.push_back(
        {code,
         safety < 1.0 ? Level::red : Level::amber,
         gear,
         fmt::format("The safety factor of gear {} against {} is {:.2f}, which is {}.", gear, what,
                     safety, less),
         "",
         {{"safety", safety, false}, {"wanted", wanted, false}}});
  };
  for (const int which : {1, 2}) {
    const auto i = static_cast<std::size_t>(which - 1);
    judge(WarningCode::root_safety, "root breakage", which, r.S_F[i].value, rating.wanted.root);
    judge(WarningCode::flank_safety, "pitting", which, r.S_H[i].value, rating.wanted.flank);
  }
  // Within a level, the lowest safety factor comes first.
  std::stable_sort(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) {
    return a.values.front().value / a.values.back().value <
           b.values.front().value / b.values.back().value;
  });
  return findings;
}

}  // namespace gearwright::detail
