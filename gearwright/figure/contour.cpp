#include "gearwright/figure/contour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"

namespace gearwright {

namespace {

// The raster, surrounded by a frame of nodes with infinite values, so that every loop closes.
class Framed {
 public:
  Framed(const ContourField& field, double level) : field_(field), level_(level) {}

  std::size_t columns() const { return field_.columns + 2; }
  std::size_t rows() const { return field_.rows + 2; }
  double value(std::size_t row, std::size_t column) const {
    return frame(row, column) ? kInfinity : field_.at(row - 1, column - 1);
  }
  double level() const { return level_; }
  bool below(std::size_t row, std::size_t column) const { return value(row, column) < level_; }

  // Returns the number of an edge. Each node has one edge along its row and one along its column.
  std::size_t edge(std::size_t row, std::size_t column, bool along_row) const {
    return 2 * (row * columns() + column) + (along_row ? 0 : 1);
  }

  // Returns the position of the level on an edge, in node coordinates of the raster.
  Vec2 crossing(std::size_t edge) const {
    const bool along_row = edge % 2 == 0;
    const std::size_t row = edge / 2 / columns();
    const std::size_t column = edge / 2 % columns();
    const std::size_t row_2 = along_row ? row : row + 1;
    const std::size_t column_2 = along_row ? column + 1 : column;
    const double a = value(row, column);
    const double b = value(row_2, column_2);
    double t = 0.5;
    if (std::isinf(a)) {
      if (frame(row, column)) t = 1.0;
    } else if (std::isinf(b)) {
      if (frame(row_2, column_2)) t = 0.0;
    } else {
      t = (level_ - a) / (b - a);
    }
    const Vec2 from(static_cast<double>(column) - 1.0, static_cast<double>(row) - 1.0);
    return from + t * (along_row ? Vec2(1.0, 0.0) : Vec2(0.0, 1.0));
  }

 private:
  bool frame(std::size_t row, std::size_t column) const {
    return row == 0 || column == 0 || row > field_.rows || column > field_.columns;
  }
  const ContourField& field_;
  double level_;
};

// Adds the pieces of the border in one cell. A path that goes counter-clockwise around the cell
// leaves the region at some edges and enters it at others. Each piece of the border begins at an
// edge where the path leaves the region and ends at an edge where the path enters it.
void add_cell(const Framed& grid, std::size_t row, std::size_t column,
              std::map<std::size_t, std::size_t>& next) {
  const std::array<bool, 4> in{grid.below(row, column), grid.below(row, column + 1),
                               grid.below(row + 1, column + 1), grid.below(row + 1, column)};
  const std::array<std::size_t, 4> edges{
      grid.edge(row, column, true), grid.edge(row, column + 1, false),
      grid.edge(row + 1, column, true), grid.edge(row, column, false)};
  const bool saddle = in[0] == in[2] && in[1] == in[3] && in[0] != in[1];
  // In a saddle, two opposite corners are below the level. They belong to one region if the mean of
  // all four values is below the level.
  const double mean = 0.25 * (grid.value(row, column) + grid.value(row, column + 1) +
                              grid.value(row + 1, column + 1) + grid.value(row + 1, column));
  const bool joined = mean < grid.level();
  for (std::size_t i = 0; i < 4; ++i) {
    if (!in[i] || in[(i + 1) % 4]) continue;
    std::size_t entry = i;
    if (saddle) {
      entry = joined ? (i + 1) % 4 : (i + 3) % 4;
    } else {
      for (std::size_t k = 0; k < 4; ++k)
        if (!in[k] && in[(k + 1) % 4]) entry = k;
    }
    next[edges[i]] = edges[entry];
  }
}

}  // namespace

std::vector<std::vector<Vec2>> regions_below(const ContourField& field, double level) {
  GW_EXPECTS(field.columns >= 2 && field.rows >= 2);
  GW_EXPECTS(field.value.size() == field.columns * field.rows);
  for (const double v : field.value) GW_EXPECTS(!std::isnan(v));
  const Framed grid(field, level);
  std::map<std::size_t, std::size_t> next;
  for (std::size_t row = 0; row + 1 < grid.rows(); ++row)
    for (std::size_t column = 0; column + 1 < grid.columns(); ++column)
      add_cell(grid, row, column, next);
  std::vector<std::vector<Vec2>> loops;
  while (!next.empty()) {
    std::vector<Vec2> loop;
    // At each crossing, one piece ends and one piece begins, so the sequence returns to its
    // first crossing.
    std::size_t at = next.begin()->first;
    for (auto it = next.find(at); it != next.end(); it = next.find(at)) {
      const Vec2 p = grid.crossing(at);
      if (loop.empty() || (p - loop.back()).norm() > 1e-9) loop.push_back(p);
      at = it->second;
      next.erase(it);
    }
    if (loop.size() > 2) loops.push_back(std::move(loop));
  }
  return loops;
}

double area_of(const std::vector<std::vector<Vec2>>& loops) {
  double twice = 0.0;
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2& a = loop[i];
      const Vec2& b = loop[(i + 1) % loop.size()];
      twice += a.x() * b.y() - a.y() * b.x();
    }
  }
  // The borders of a region and of its holes have opposite directions. The sum of the signed areas
  // is therefore the area of the region.
  return std::abs(twice) / 2;
}

std::string shade_style(std::size_t i, std::size_t n) {
  const std::size_t shade = n <= 1 ? 0 : (9 * i + (n - 1) / 2) / (n - 1);
  return fmt::format("shade s{}", std::min<std::size_t>(9, shade));
}

}  // namespace gearwright
