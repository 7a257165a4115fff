#include "gearwright/rating/accuracy.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

constexpr std::array kDiameters{5.0,    20.0,   50.0,   125.0,  280.0,  560.0,  1000.0,
                                1600.0, 2500.0, 4000.0, 6000.0, 8000.0, 10000.0};
constexpr std::array kModules{0.5, 2.0, 3.5, 6.0, 10.0, 16.0, 25.0, 40.0, 70.0};
constexpr std::array kFaces{4.0, 10.0, 20.0, 40.0, 80.0, 160.0, 250.0, 400.0, 650.0, 1000.0};

// The geometric mean of the range that contains x, or of the nearest range.
double mean_of_range(std::span<const double> ends, double x) {
  std::size_t i = 1;
  while (i + 1 < ends.size() && x > ends[i]) ++i;
  return std::sqrt(ends[i - 1] * ends[i]);
}

// Rounding of the tables of the standard: whole µm above 10, halves to 5, tenths below.
double rounded(double f) {
  const double step = f > 10.0 ? 1.0 : f >= 5.0 ? 0.5 : 0.1;
  return std::round(f / step) * step;
}

}  // namespace

Tolerances tolerances(RatingEdition edition, int grade, const RatedGear& gear, double normal_module,
                      double alpha_t) {
  GW_EXPECTS(grade >= kBestGrade && grade <= kWorstGrade);
  const double step = std::pow(2.0, 0.5 * (grade - 5));
  Tolerances t{};
  if (edition == RatingEdition::iso_2006) {
    const double m = mean_of_range(kModules, normal_module);
    const double d = std::sqrt(mean_of_range(kDiameters, gear.reference_diameter));
    const double b = std::sqrt(mean_of_range(kFaces, gear.face_width));
    t.f_pt = rounded((0.3 * (m + 0.4 * d) + 4.0) * step);
    t.f_falpha = rounded((2.5 * std::sqrt(m) + 0.17 * d + 0.5) * step);
    t.f_Hbeta = rounded((0.07 * d + 0.45 * b + 3.0) * step);
  } else {
    const double d = gear.reference_diameter;
    t.f_pt = rounded((0.001 * d + 0.4 * normal_module + 5.0) * step);
    t.f_falpha = rounded((0.55 * normal_module + 5.0) * step);
    t.f_Hbeta = rounded((0.05 * std::sqrt(d) + 0.35 * std::sqrt(gear.face_width) + 4.0) * step);
  }
  t.f_pb = t.f_pt * std::cos(alpha_t);
  return t;
}

}  // namespace gearwright
