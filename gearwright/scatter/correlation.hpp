// Correlates the inputs of a family by a Gaussian copula.
//
//   u′   independent coordinates in the unit cube       s = Φ⁻¹(u)   scores
//   R    correlations of the scores, R = L Lᵀ, L lower triangular
//   u = Φ(L Φ⁻¹(u′))                theory: docs/theory/14-scatter.md, [T14.30], [T14.32]
//
// The two scores of a bore are the coordinates of a point with the two-dimensional normal
// distribution, so the position of the bore stays uniform in its circle.
//
// The copula does not change the distribution of any input. For an input without a correlation, u
// and u′ are equal bit for bit.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "gearwright/base/error.hpp"
#include "gearwright/scatter/tolerance.hpp"

namespace gearwright {

/// The correlation of the scores of two coordinates of x.
struct ToleranceCorrelation {
  std::size_t first, second;  ///< indices of the coordinates
  double value;               ///< Pearson correlation of the scores, between −1 and 1
  std::size_t entry;          ///< N in the names of errors, for example `correlations[N].value`
};

/// Checks that inputs with these correlations exist.
///
/// Domain    each pair of coordinates at most once, |value| < 1, no coordinate with itself
///           (contract)
/// Errors    `correlations[N].between` if a coordinate has no score, or if both are of one bore.
///           `correlations[N].value` if R is not positive definite, with the nearest possible
///           value of one correlation in the text. If there is no such value, the field is
///           `correlations`, and the text gives a common factor for all correlations
std::optional<Error> check_correlations(std::span<const ScatterTolerance> tolerances,
                                        std::span<const ToleranceCorrelation> correlations);

/// Returns the sets of at least two tolerances that are connected by correlations other than 0.
std::vector<std::vector<std::size_t>> correlated_blocks(
    std::span<const ScatterTolerance> tolerances,
    std::span<const ToleranceCorrelation> correlations);

class Copula {
 public:
  /// Domain    correlations that check_correlations() accepts (contract)
  Copula(std::span<const ScatterTolerance> tolerances,
         std::span<const ToleranceCorrelation> correlations);

  /// Converts u′ to u, for all coordinates of the tolerances in order.   Formula [T14.30], [T14.32]
  ///
  /// Laws      (1) without correlations, or if all are 0, u = u′
  ///           (2) u is uniform if u′ is uniform
  std::vector<double> correlated(std::vector<double> u) const;

 private:
  // A correlated coordinate. Its score is a weighted sum of its own independent score and those of
  // earlier coordinates.
  struct Row {
    std::size_t coordinate;
    std::vector<std::pair<std::size_t, double>> sum;  // coordinates and entries of L
  };
  double score(std::span<const double> u, std::size_t coordinate) const;

  std::vector<Row> rows_;
  // For each coordinate of a bore, the index of the first coordinate of this bore. None for any
  // other coordinate.
  std::vector<std::optional<std::size_t>> disc_;
};

}  // namespace gearwright
