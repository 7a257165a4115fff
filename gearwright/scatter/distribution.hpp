// The distribution of a toleranced number over its range.
//
//   [l, h]  closed range       m, w   middle and half width of the range     u   uniform in (0, 1)
//   C_pk    process capability: the mean lies at least 3 C_pk standard deviations inside the range
//                                    theory: docs/theory/14-scatter.md, [T14.1], [T14.2]
#pragma once

#include <array>

#include "gearwright/base/result.hpp"
#include "gearwright/math/statistics.hpp"

namespace gearwright {

struct DistributionSpec {
  enum class Kind {
    uniform,
    triangular,  ///< symmetric about m
    normal,      ///< truncated to the range, because inspection rejects other parts
    beta
  };
  std::array<double, 2> range{};  ///< l, h
  Kind kind = Kind::uniform;
  double cpk = 1.0;                       ///< C_pk, for Kind::normal only
  double offset = 0.0;                    ///< mean minus m, for Kind::normal only
  std::array<double, 2> shape{1.0, 1.0};  ///< p, q, for Kind::beta
};

class Distribution {
 public:
  /// Checks the spec and makes the distribution.
  ///
  /// Errors    `range` if l > h or if an end is not finite; `cpk` ≤ 0; `offset` not inside the
  ///           range; `shape` ≤ 0. A range with l = h is valid, but the number does not vary
  static Result<Distribution> of(const DistributionSpec& spec);

  /// Returns F⁻¹(u), the inverse of the distribution function.   Formula [T14.1]
  /// Domain    0 < u < 1 (contract)
  double at(double u) const;
  /// Returns mean and variance in closed form.
  Moments moments() const;

  double least() const { return spec_.range[0]; }
  double greatest() const { return spec_.range[1]; }
  bool varies() const { return spec_.range[0] < spec_.range[1]; }

 private:
  explicit Distribution(const DistributionSpec& spec);

  DistributionSpec spec_;
  double mean_ = 0.0, sigma_ = 0.0;  // mean and standard deviation before truncation
  double from_ = 0.0, to_ = 0.0;     // distribution function before truncation, at l and h
};

/// Converts two numbers in (0, 1) to the coordinates of a point in a disc.   Formula [T14.2]
std::array<double, 2> in_disc(double radius, double u, double v);

}  // namespace gearwright
