#include "gearwright/scatter/correlation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/math/statistics.hpp"

namespace gearwright {

namespace {

using Matrix = std::vector<std::vector<double>>;

// Least permitted square of a diagonal entry of L. If a square is smaller, one input is, apart from
// rounding, a function of the other inputs.
constexpr double kLeastPivot = 1e-9;
constexpr double kShownStep = 1e-4;  // resolution of the correlations in the text of an error

Matrix matrix_of(std::size_t size, std::span<const ToleranceCorrelation> correlations) {
  Matrix r(size, std::vector<double>(size));
  for (std::size_t i = 0; i < size; ++i) r[i][i] = 1.0;
  for (const ToleranceCorrelation& c : correlations)
    r[c.first][c.second] = r[c.second][c.first] = c.value;
  return r;
}

// Returns L of R = L Lᵀ, or none if R is not positive definite. [T14.30]
std::optional<Matrix> cholesky(const Matrix& r) {
  const std::size_t size = r.size();
  Matrix l(size, std::vector<double>(size));
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = r[i][j];
      for (std::size_t k = 0; k < j; ++k) rest -= l[i][k] * l[j][k];
      if (i == j && !(rest > kLeastPivot)) return std::nullopt;
      l[i][j] = i == j ? std::sqrt(rest) : rest / l[j][j];
    }
  }
  return l;
}

// Returns the matrix with two of its rows, and the same two columns, moved to the end.
Matrix with_last(const Matrix& r, std::size_t first, std::size_t second) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < r.size(); ++i)
    if (i != first && i != second) order.push_back(i);
  order.insert(order.end(), {first, second});
  Matrix moved(r.size(), std::vector<double>(r.size()));
  for (std::size_t i = 0; i < r.size(); ++i)
    for (std::size_t j = 0; j < r.size(); ++j) moved[i][j] = r[order[i]][order[j]];
  return moved;
}

// Returns the range of c in which R is positive definite if all other correlations stay the same,
// or none if there is no such range. The rows of the two inputs are moved to the end of R, so that
// c affects only the last row of L. The last pivot is positive within the range.
std::optional<std::array<double, 2>> range_of(const Matrix& r, const ToleranceCorrelation& c) {
  Matrix m = with_last(r, c.first, c.second);
  const std::size_t n = m.size();
  // For given values of all other inputs, the covariance of the two inputs is c − `middle`. Its
  // magnitude cannot exceed `half`, which is the product of their standard deviations.
  const auto without = [&](std::size_t last) {
    Matrix part(n - 1, std::vector<double>(n - 1));
    const auto at = [&](std::size_t i) { return i + 2 == n ? last : i; };
    for (std::size_t i = 0; i + 1 < n; ++i)
      for (std::size_t j = 0; j + 1 < n; ++j) part[i][j] = m[at(i)][at(j)];
    return cholesky(part);
  };
  const auto one = without(n - 2);
  const auto two = without(n - 1);
  if (!one || !two) return std::nullopt;
  const std::vector<double>&a = one->back(), &b = two->back();
  double middle = 0.0;
  for (std::size_t k = 0; k + 2 < n; ++k) middle += a[k] * b[k];
  const double half = a[n - 2] * b[n - 2];
  return std::array{middle - half, middle + half};
}

// Returns `value`, limited to the interval between the least and the greatest multiple of
// kShownStep that lie inside the range.
double nearest_inside(double value, const std::array<double, 2>& range) {
  const double lo = (std::floor(range[0] / kShownStep) + 1) * kShownStep;
  const double hi = (std::ceil(range[1] / kShownStep) - 1) * kShownStep;
  return std::clamp(value, std::min(lo, hi), std::max(lo, hi));
}

// Returns the greatest multiple of kStep by which all correlations can be multiplied so that R is
// positive definite.
double common_factor(std::size_t size, std::span<const ToleranceCorrelation> correlations) {
  double factor = 1.0;
  const auto exists = [&](double f) {
    std::vector<ToleranceCorrelation> scaled(correlations.begin(), correlations.end());
    for (ToleranceCorrelation& c : scaled) c.value *= f;
    return cholesky(matrix_of(size, scaled)).has_value();
  };
  constexpr double kStep = 0.01;
  while (factor > kStep && !exists(factor)) factor -= kStep;
  return factor;
}

// Returns the correlation nearest to the value of `c` with which R is positive definite, rounded to
// ten decimals. `middle` is a correlation with which R is positive definite.
double nearest_permitted(Matrix r, const ToleranceCorrelation& c, double middle) {
  constexpr int kHalvings = 60;
  constexpr double kTenDecimals = 1e10;
  double good = middle, bad = c.value;
  for (int i = 0; i < kHalvings; ++i) {
    const double value = (good + bad) / 2;
    r[c.first][c.second] = r[c.second][c.first] = value;
    (cholesky(r) ? good : bad) = value;
  }
  // Rounding away from c.value keeps the result in the permitted range.
  const double scaled = good * kTenDecimals;
  return (good > middle ? std::floor(scaled) : std::ceil(scaled)) / kTenDecimals;
}

// Returns the index of the tolerance of each coordinate.
std::vector<std::size_t> owners_of(std::span<const ScatterTolerance> tolerances) {
  std::vector<std::size_t> owner;
  for (std::size_t t = 0; t < tolerances.size(); ++t)
    owner.resize(owner.size() + static_cast<std::size_t>(tolerances[t].coordinates()), t);
  return owner;
}

}  // namespace

std::optional<Error> check_correlations(std::span<const ScatterTolerance> tolerances,
                                        std::span<const ToleranceCorrelation> correlations) {
  const auto field = [](const ToleranceCorrelation& c) {
    return fmt::format("correlations[{}]", c.entry);
  };
  const std::vector<std::string> names = coordinate_names(tolerances);
  std::vector<bool> scored;
  std::vector<std::string> possible;
  for (const ScatterTolerance& t : tolerances)
    for (int k = 0; k < t.coordinates(); ++k) {
      scored.push_back(t.has_score(k));
      if (scored.back()) possible.push_back(names[scored.size() - 1]);
    }
  const std::vector<std::size_t> owner = owners_of(tolerances);
  for (const ToleranceCorrelation& c : correlations) {
    for (const std::size_t at : {c.first, c.second})
      if (!scored[at])
        return Error{field(c) + ".between", names[at],
                     fmt::format("cannot be correlated, because it is a phase or a constant number "
                                 "of waves; the numbers that can be correlated are {}",
                                 fmt::join(possible, ", "))};
    if (owner[c.first] == owner[c.second] && tolerances[owner[c.first]].bore())
      return Error{field(c) + ".between", names[c.second],
                   fmt::format("cannot be correlated with {}, because the positions of a bore are "
                               "uniform in its circle; correlate it with another bore",
                               names[c.first])};
  }
  const Matrix r = matrix_of(names.size(), correlations);
  if (cholesky(r)) return std::nullopt;
  std::optional<std::size_t> best;
  double nearest = 0.0;
  double change = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < correlations.size(); ++i) {
    const auto range = range_of(r, correlations[i]);
    if (!range) continue;
    const double value = nearest_inside(correlations[i].value, *range);
    if (!(std::abs(value - correlations[i].value) < change)) continue;
    best = i;
    nearest = value;
    change = std::abs(value - correlations[i].value);
  }
  const char* const why =
      "no inputs can have these correlations, because their matrix is not positive definite";
  if (!best)
    return Error{"correlations", "",
                 fmt::format("{}; multiply all correlations by at most {:.2f}", why,
                             common_factor(names.size(), correlations))};
  const ToleranceCorrelation& c = correlations[*best];
  if (const auto range = range_of(r, c); range && c.value > (*range)[0] && c.value < (*range)[1]) {
    return Error{
        field(c) + ".value", fmt::format("{}", c.value),
        fmt::format("this value is possible, but at least {} of the variance of every input must "
                    "be independent of the other inputs, so that rounding errors stay small; the "
                    "nearest permitted correlation of {} and {} is {:.10f}",
                    kLeastPivot, names[c.first], names[c.second],
                    nearest_permitted(r, c, ((*range)[0] + (*range)[1]) / 2))};
  }
  return Error{
      field(c) + ".value", fmt::format("{}", c.value),
      fmt::format(
          "{}; if the other correlations are kept, the nearest possible correlation of {} and {} "
          "is {:.4f}",
          why, names[c.first], names[c.second], nearest)};
}

std::vector<std::vector<std::size_t>> correlated_blocks(
    std::span<const ScatterTolerance> tolerances,
    std::span<const ToleranceCorrelation> correlations) {
  const std::vector<std::size_t> owner = owners_of(tolerances);
  std::vector<std::size_t> block(tolerances.size());
  std::iota(block.begin(), block.end(), std::size_t{0});
  for (const ToleranceCorrelation& c : correlations) {
    if (c.value == 0.0) continue;
    const auto [to, from] = std::minmax(block[owner[c.first]], block[owner[c.second]]);
    std::replace(block.begin(), block.end(), std::size_t{from}, std::size_t{to});
  }
  std::vector<std::vector<std::size_t>> blocks;
  for (std::size_t b = 0; b < block.size(); ++b) {
    std::vector<std::size_t> members;
    for (std::size_t t = 0; t < block.size(); ++t)
      if (block[t] == b) members.push_back(t);
    if (members.size() > 1) blocks.push_back(std::move(members));
  }
  return blocks;
}

Copula::Copula(std::span<const ScatterTolerance> tolerances,
               std::span<const ToleranceCorrelation> correlations) {
  for (const ScatterTolerance& t : tolerances) {
    const std::size_t first = disc_.size();
    disc_.resize(first + static_cast<std::size_t>(t.coordinates()),
                 t.bore() ? std::optional(first) : std::nullopt);
  }
  const auto l = cholesky(matrix_of(disc_.size(), correlations));
  GW_EXPECTS(l.has_value());
  for (std::size_t i = 0; i < disc_.size(); ++i) {
    Row row{i, {}};
    for (std::size_t j = 0; j <= i; ++j)
      if ((*l)[i][j] != 0.0) row.sum.emplace_back(j, (*l)[i][j]);
    if (row.sum.size() > 1) rows_.push_back(std::move(row));
  }
}

double Copula::score(std::span<const double> u, std::size_t coordinate) const {
  const std::optional<std::size_t> first = disc_[coordinate];
  if (!first) return normal_quantile(u[coordinate]);
  const double distance = std::sqrt(-2.0 * std::log1p(-u[*first]));
  const double turn = 2.0 * kPi * u[*first + 1];
  return distance * (coordinate == *first ? std::cos(turn) : std::sin(turn));
}

std::vector<double> Copula::correlated(std::vector<double> u) const {
  if (rows_.empty()) return u;
  std::vector<double> independent;
  for (std::size_t i = 0; i < u.size(); ++i) independent.push_back(score(u, i));
  std::vector<double> scores = independent;
  for (const Row& row : rows_) {
    scores[row.coordinate] = 0.0;
    for (const auto& [at, factor] : row.sum) scores[row.coordinate] += factor * independent[at];
  }
  // Φ of a large score is rounded to 1, but u must be less than 1.
  constexpr double kEnd = std::numeric_limits<double>::epsilon();
  for (const Row& row : rows_) {
    if (const std::optional<std::size_t> first = disc_[row.coordinate]) {
      const double x = scores[*first], y = scores[*first + 1];
      const double turn = std::atan2(y, x) / (2.0 * kPi);
      u[*first] = std::clamp(-std::expm1(-0.5 * (x * x + y * y)), kEnd, 1.0 - kEnd);
      u[*first + 1] = turn < 0.0 ? turn + 1.0 : turn;
    } else {
      u[row.coordinate] = std::clamp(normal_cdf(scores[row.coordinate]), kEnd, 1.0 - kEnd);
    }
  }
  return u;
}

}  // namespace gearwright
