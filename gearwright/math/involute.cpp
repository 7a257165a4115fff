#include "gearwright/math/involute.hpp"

#include <iterator>

namespace gearwright::detail {

double tan_minus_self_series(double alpha) {
  // Coefficients of α³, α⁵, … in the series of tan α, which follow from the Bernoulli numbers. The
  // ratio of successive coefficients tends to (2/π)².
  static constexpr double kTan[] = {
      0.3333333333333333,    0.13333333333333333,    0.05396825396825397,
      0.021869488536155203,  0.008863235529902197,   0.003592128036572481,
      0.0014558343870513183, 0.000590027440945586,   0.00023912911424355248,
      9.691537956929451e-05, 3.927832388331683e-05,  1.5918905069328964e-05,
      6.451689215655431e-06, 2.6147711512907546e-06, 1.0597268320104654e-06,
      4.294911078273806e-07, 1.7406618963571648e-07, 7.054636946400968e-08,
  };
  const double square = alpha * alpha;
  double sum = 0.0;
  for (int i = static_cast<int>(std::size(kTan)) - 1; i >= 0; --i) sum = sum * square + kTan[i];
  return alpha * square * sum;
}

double self_minus_atan_series(double xi) {
  // ξ − atan ξ = ξ³/3 − ξ⁵/5 + …. At ξ = 0.28 the first omitted term, ξ³³/33, is 3e-18 of the sum.
  const double square = xi * xi;
  double sum = 0.0;
  for (int n = 31; n >= 3; n -= 2) sum = 1.0 / n - square * sum;
  return xi * square * sum;
}

}  // namespace gearwright::detail
