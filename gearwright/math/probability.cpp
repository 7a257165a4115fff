#include "gearwright/math/probability.hpp"

#include <algorithm>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>

#include "gearwright/base/contract.hpp"
#include "gearwright/math/newton.hpp"

namespace gearwright {

namespace {

using boost::math::policies::promote_double;
constexpr boost::math::policies::policy<promote_double<false>> kPlainDoubles;

}  // namespace

double normal_cdf(double x) {
  return 0.5 * boost::math::erfc(-x / std::numbers::sqrt2, kPlainDoubles);
}

double normal_quantile(double u) {
  GW_EXPECTS(u > 0.0 && u < 1.0);
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2.0 * u, kPlainDoubles);
}

double beta_cdf(double x, double p, double q) {
  GW_EXPECTS(p > 0.0 && q > 0.0 && x >= 0.0 && x <= 1.0);
  return boost::math::ibeta(p, q, x, kPlainDoubles);
}

double beta_quantile(double u, double p, double q) {
  GW_EXPECTS(p > 0.0 && q > 0.0 && u >= 0.0 && u <= 1.0);
  if (u == 0.0 || u == 1.0) return u;
  // Boost's own inverse fails for some p and q that are far apart. Newton's step within a bracket
  // cannot fail.
  const auto f = [&](double x) {
    return Slope<double>{beta_cdf(x, p, q) - u,
                         boost::math::ibeta_derivative(p, q, x, kPlainDoubles)};
  };
  return newton_in_bracket(f, 0.0, 1.0, p / (p + q), true).x;
}

double student_quantile(double u, double nu) {
  GW_EXPECTS(nu > 0.0 && u > 0.0 && u < 1.0);
  // t²/(ν + t²), or its complement if that is smaller and therefore has more digits.
  const double middle = std::abs(2.0 * u - 1.0);
  double t = 0.0;
  if (middle < 0.5) {
    const double c = beta_quantile(middle, 0.5, 0.5 * nu);
    t = std::sqrt(nu * c / (1.0 - c));
  } else {
    const double b = beta_quantile(2.0 * std::min(u, 1.0 - u), 0.5 * nu, 0.5);
    t = std::sqrt(nu * (1.0 - b) / b);
  }
  return u < 0.5 ? -t : t;
}

}  // namespace gearwright
