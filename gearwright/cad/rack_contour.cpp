#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/cad/contour.hpp"

namespace gearwright {

Contour rack_contour(const Outline& outline, const RackBlock& rack) {
  GW_EXPECTS(outline.teeth >= 1 && !outline.arcs.empty());
  const std::vector<Arc>& arcs = outline.arcs;
  const double root_height = arcs.front().begin_point.x();
  GW_EXPECTS(root_height > -rack.height);
  const int n = outline.teeth;
  const double end = n * rack.pitch / 2;
  const std::size_t first = arcs.front().name == ArcName::root_land ? 1 : 0;
  const std::size_t last = arcs.size() - (arcs.back().name == ArcName::tip_land ? 1 : 0);

  Contour contour{n, {}, 0.0, std::hypot(end, rack.height), rack};
  const auto straight_to = [&](std::size_t arc, int tooth, const Vec2& from, const Vec2& to) {
    contour.pieces.push_back({arc, tooth, false, true, from, to, 0.0});
  };
  Vec2 here(root_height, -end);
  for (int k = 0; k < n; ++k) {
    const Vec2 middle(0.0, rack.middle_of(k, n));
    const auto go = [&](std::size_t i, bool lower, const Vec2& to) {
      contour.pieces.push_back({i, k, lower, false, here, to, 0.0});
      here = to;
    };
    // The root land before this tooth ends exactly at the first point of the next arc.
    if (first == 1) {
      const Vec2 root = mirrored(arcs[0].end_point) + middle;
      straight_to(0, k, here, root);
      here = root;
    }
    for (std::size_t i = first; i < last; ++i) go(i, true, mirrored(arcs[i].end_point) + middle);
    if (last < arcs.size()) {
      const Vec2 tip = arcs[last].begin_point + middle;
      straight_to(last, k, here, tip);
      here = tip;
    }
    for (std::size_t i = last; i-- > first;) go(i, false, arcs[i].begin_point + middle);
    for (const Arc& arc : arcs)
      contour.outer_radius = std::max(contour.outer_radius, (arc.end_point + middle).norm());
  }
  const Vec2 corner(root_height, end), begin(root_height, -end);
  if (first == 1) {
    straight_to(0, n - 1, here, corner);
  } else {
    contour.pieces.back().end = corner;
  }
  const Vec2 back_end(-rack.height, end), back_begin(-rack.height, -end);
  straight_to(0, n - 1, corner, back_end);
  straight_to(0, n - 1, back_end, back_begin);
  straight_to(0, n - 1, back_begin, begin);
  contour.inner_radius = 0.0;
  return contour;
}

}  // namespace gearwright
