#include "gearwright/pair/contact_lines.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"

namespace gearwright {

double contact_lines(double transverse_ratio, double overlap_ratio, double turn) {
  GW_EXPECTS(transverse_ratio >= 0.0 && overlap_ratio >= 0.0);
  const double first = turn - std::floor(turn);
  double sum = 0.0;
  for (double end = first; end < transverse_ratio + overlap_ratio; end += 1.0)
    sum += overlap_ratio > 0.0
               ? std::min(end, transverse_ratio) - std::max(end - overlap_ratio, 0.0)
               : 1.0;
  return overlap_ratio > 0.0 ? sum / overlap_ratio : sum;
}

ContactLineRange contact_line_range(double transverse_ratio, double overlap_ratio) {
  GW_EXPECTS(transverse_ratio >= 0.0 && overlap_ratio >= 0.0);
  const double whole = std::floor(transverse_ratio);
  const double r_alpha = transverse_ratio - whole;
  if (overlap_ratio == 0.0) return {whole, r_alpha > 0.0 ? whole + 1.0 : whole};
  const double r_beta = overlap_ratio - std::floor(overlap_ratio);
  // The variation depends only on the fractional parts r_α and r_β of the contact ratios ε_α and
  // ε_β. Consider two arcs of the lengths r_α and r_β on a circle of the circumference 1. λ ε_β is
  // a constant plus the length that both arcs have in common, whose mean is r_α r_β.
  const double mean = r_alpha * r_beta;
  const double most = std::min(r_alpha, r_beta);
  const double least = std::max(0.0, r_alpha + r_beta - 1.0);
  return {transverse_ratio - (mean - least) / overlap_ratio,
          transverse_ratio + (most - mean) / overlap_ratio};
}

std::optional<double> deflection_variation(double transverse_ratio, double overlap_ratio) {
  const auto [least, greatest] = contact_line_range(transverse_ratio, overlap_ratio);
  // If λ is below this limit, it is 0 within rounding.
  constexpr double kNoLine = 1e-9;
  if (!(least > kNoLine)) return std::nullopt;
  return transverse_ratio * (1.0 / least - 1.0 / greatest);
}

}  // namespace gearwright
