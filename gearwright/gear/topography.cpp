#include "gearwright/gear/topography.hpp"

#include <algorithm>
#include <array>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

// Returns the slopes of the not-a-knot cubic spline at its points. The second derivative is
// continuous at every inner point. The third derivative is continuous at the first and at the last
// inner point. The elimination requires no pivoting, because all pivots are > 0.
std::vector<double> spline_slopes(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  std::vector<double> h(n - 1), s(n - 1);  // steps, and slopes of the chords
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h[i] = x[i + 1] - x[i];
    s[i] = (y[i + 1] - y[i]) / h[i];
  }
  if (n == 2) return {s[0], s[0]};
  if (n == 3) {
    const double half_second = (s[1] - s[0]) / (h[0] + h[1]);
    return {s[0] - h[0] * half_second, s[0] + h[0] * half_second, s[1] + h[1] * half_second};
  }
  // `m` contains first the right-hand side and finally the slopes. `above` contains the upper
  // diagonal divided by the pivots.
  std::vector<double> m(n), above(n);
  const double first = h[0] + h[1];
  above[0] = first / h[1];
  m[0] = ((h[0] + 2 * first) * h[1] * s[0] + h[0] * h[0] * s[1]) / first / h[1];
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double pivot = 2 * (h[i - 1] + h[i]) - h[i] * above[i - 1];
    above[i] = h[i - 1] / pivot;
    m[i] = (3 * (h[i] * s[i - 1] + h[i - 1] * s[i]) - h[i] * m[i - 1]) / pivot;
  }
  const double a = h[n - 3];
  const double b = h[n - 2];
  const double right = (b * b * s[n - 3] + (2 * (a + b) + b) * a * s[n - 2]) / (a + b);
  m[n - 1] = (right - (a + b) * m[n - 2]) / (a - (a + b) * above[n - 2]);
  for (std::size_t i = n - 1; i-- > 0;) m[i] -= above[i] * m[i + 1];
  return m;
}

// The cubic Hermite basis on a cell and its first and second derivatives. The basis functions
// belong to the values and slopes at both ends of the cell.
struct HermiteBasis {
  std::size_t cell;
  std::array<std::array<double, 4>, 3> b;  // [derivative][value left, right, slope left, right]
};

HermiteBasis hermite(const std::vector<double>& x, double at) {
  const auto next = std::upper_bound(x.begin() + 1, x.end() - 1, at);
  const auto cell = static_cast<std::size_t>(next - x.begin()) - 1;
  const double h = x[cell + 1] - x[cell];
  const double t = (at - x[cell]) / h;
  const double r = 1 - t;
  return {cell,
          {{{(1 + 2 * t) * r * r, t * t * (3 - 2 * t), h * t * r * r, -h * t * t * r},
            {-6 * t * r / h, 6 * t * r / h, r * (1 - 3 * t), t * (3 * t - 2)},
            {(12 * t - 6) / (h * h), (6 - 12 * t) / (h * h), (6 * t - 4) / h, (6 * t - 2) / h}}}};
}

}  // namespace

bool is_grid(const Topography& t) {
  const auto grows = [](const std::vector<double>& x) {
    return x.size() >= 2 && std::adjacent_find(x.begin(), x.end(), [](double a, double b) {
                              return !(a < b);
                            }) == x.end();
  };
  return grows(t.diameters) && grows(t.heights) &&
         t.removed.size() == t.diameters.size() * t.heights.size();
}

TopographySpline::TopographySpline(const Topography& grid)
    : diameters_(grid.diameters), heights_(grid.heights) {
  GW_EXPECTS(is_grid(grid));
  const std::size_t rows = diameters_.size();
  const std::size_t columns = heights_.size();
  nodes_.resize(rows * columns);
  const auto column_slopes = [&](std::size_t j, double Node::*from, double Node::*to) {
    std::vector<double> y(rows);
    for (std::size_t i = 0; i < rows; ++i) y[i] = nodes_[i * columns + j].*from;
    const std::vector<double> m = spline_slopes(diameters_, y);
    for (std::size_t i = 0; i < rows; ++i) nodes_[i * columns + j].*to = m[i];
  };
  for (std::size_t k = 0; k < nodes_.size(); ++k) nodes_[k].s = grid.removed[k];
  for (std::size_t i = 0; i < rows; ++i) {
    const auto begin = grid.removed.begin() + static_cast<std::ptrdiff_t>(i * columns);
    const std::vector<double> m =
        spline_slopes(heights_, {begin, begin + static_cast<std::ptrdiff_t>(columns)});
    for (std::size_t j = 0; j < columns; ++j) nodes_[i * columns + j].z = m[j];
  }
  for (std::size_t j = 0; j < columns; ++j) {
    column_slopes(j, &Node::s, &Node::d);
    column_slopes(j, &Node::z, &Node::dz);
  }
}

TopographySpline::Value TopographySpline::at(double diameter, double height) const {
  const HermiteBasis d = hermite(diameters_, diameter);
  const HermiteBasis z = hermite(heights_, height);
  const Node* node = &nodes_[d.cell * heights_.size() + z.cell];
  const std::array<const Node*, 2> lower{node, node + heights_.size()};
  const auto sum = [&](std::size_t by_d, std::size_t by_z) {
    double total = 0.0;
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) {
        const Node& n = lower[i][j];
        total += d.b[by_d][i] * (z.b[by_z][j] * n.s + z.b[by_z][j + 2] * n.z) +
                 d.b[by_d][i + 2] * (z.b[by_z][j] * n.d + z.b[by_z][j + 2] * n.dz);
      }
    }
    return total;
  };
  return {sum(0, 0), sum(1, 0), sum(0, 1), sum(2, 0), sum(1, 1), sum(0, 2)};
}

}  // namespace gearwright
