#include "gearwright/cad/contour.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/contract.hpp"
#include "gearwright/cad/walls.hpp"

namespace gearwright {
namespace {

constexpr double kShortestArc = 1e-6;  // mm, 1/100 of the resolution of machine tools
constexpr double kOnItsRay = 1e-6;     // mm, tolerance for points on a centre line
constexpr int kArcLooks = 32;          // number of points per arc that are examined

// Adding zero turns −0 into 0, so that equal points are written as equal text.
Vec2 tidy_turned(const Vec2& p, const SinCos& turn) {
  return {turn.cos * p.x() - turn.sin * p.y() + 0.0, turn.sin * p.x() + turn.cos * p.y() + 0.0};
}

// An arc of the half outline that becomes pieces of the contour. If adjacent slivers are omitted,
// the ends of the arc are moved to close the gap.
struct Link {
  std::size_t arc;
  Vec2 begin;
  Vec2 end;
};

std::vector<Link> links_of(const Outline& outline) {
  std::vector<Link> links;
  Vec2 begin = outline.arcs.front().begin_point;
  for (std::size_t i = 0; i < outline.arcs.size(); ++i) {
    const Arc& arc = outline.arcs[i];
    GW_EXPECTS(i == 0 || arc.begin_point == outline.arcs[i - 1].end_point);
    // The middle is also examined, because a long arc may end where it begins.
    const double reach = std::max((arc.point(0.5) - arc.begin_point).norm(),
                                  (arc.end_point - arc.begin_point).norm());
    if (reach < kShortestArc) continue;
    links.push_back({i, begin, arc.end_point});
    begin = arc.end_point;
  }
  GW_EXPECTS(!links.empty());
  links.back().end = outline.arcs.back().end_point;
  return links;
}

}  // namespace

Result<Contour> closed_contour(const Outline& outline) {
  GW_EXPECTS(outline.teeth != 0);
  GW_EXPECTS(!outline.arcs.empty());
  const int z = std::abs(outline.teeth);
  const SinCos ray = sincos_turn(1, 2LL * z);  // the middle of the space
  const auto beyond_space = [&](const Vec2& p) { return ray.cos * p.y() - ray.sin * p.x(); };
  GW_EXPECTS(std::abs(beyond_space(outline.arcs.front().begin_point)) < kOnItsRay);
  GW_EXPECTS(std::abs(outline.arcs.back().end_point.y()) < kOnItsRay);

  Contour contour{z, {}, outline.arcs.front().begin_point.norm(), 0.0};
  for (const Arc& arc : outline.arcs) {
    for (int i = 0; i <= kArcLooks; ++i) {
      const Vec2 p = arc.point(static_cast<double>(i) / kArcLooks);
      contour.inner_radius = std::min(contour.inner_radius, p.norm());
      contour.outer_radius = std::max(contour.outer_radius, p.norm());
      // If there is only one tooth, the middle of the space is the negative x axis. The condition y
      // < 0 then covers both centre lines.
      if (p.y() < -kOnItsRay || (z > 1 && beyond_space(p) > kOnItsRay)) {
        return Error{
            "teeth", std::to_string(outline.teeth),
            "the outline of the tooth crosses the centre line of the tooth or of the tooth space, "
            "so the outline does not enclose a body; less undercut (a greater profile shift "
            "or more teeth) would help"};
      }
    }
  }

  const std::vector<Link> links = links_of(outline);
  const bool root_land = round_land(outline.arcs[links.front().arc]);
  const bool tip_land =
      round_land(outline.arcs[links.back().arc]) && !(root_land && links.size() == 1);
  const std::size_t first = root_land ? 1 : 0;
  const std::size_t last =
      links.size() - (tip_land ? 1 : 0);  // end of the links before the tip land

  double tip_sweep = 0.0;
  double root_sweep = 0.0;
  if (tip_land) {
    const Vec2& p = links.back().begin;
    tip_sweep = 2.0 * std::atan2(p.y(), p.x());
  }
  if (root_land) {
    const Vec2& p = links.front().end;
    root_sweep = 2.0 * (std::numbers::pi / z - std::atan2(p.y(), p.x()));
  }

  // Without a land, two halves meet at a joint on the centre line of the tooth or space. Both
  // halves use the joint of the upper half.
  const Vec2 tip = links.back().end;
  const Vec2 root = links.front().begin;
  for (int k = 0; k < z; ++k) {
    const SinCos here = sincos_turn(k, z);
    const SinCos next = sincos_turn(k + 1, z);
    if (tip_land) {
      const Vec2& p = links.back().begin;
      contour.pieces.push_back({links.back().arc, k, false, true, tidy_turned(mirrored(p), here),
                                tidy_turned(p, here), tip_sweep});
    }
    for (std::size_t i = last; i-- > first;) {
      contour.pieces.push_back({links[i].arc, k, false, false, tidy_turned(links[i].end, here),
                                tidy_turned(links[i].begin, here), 0.0});
    }
    if (root_land) {
      const Vec2& p = links.front().end;
      contour.pieces.push_back({links.front().arc, k, false, true, tidy_turned(p, here),
                                tidy_turned(mirrored(p), next), root_sweep});
    }
    for (std::size_t i = first; i < last; ++i) {
      const bool at_root = i == 0;                // true only without a root land
      const bool at_tip = i + 1 == links.size();  // true only without a tip land
      contour.pieces.push_back(
          {links[i].arc, (k + 1) % z, true, false,
           at_root ? tidy_turned(root, here) : tidy_turned(mirrored(links[i].begin), next),
           at_tip ? tidy_turned(tip, next) : tidy_turned(mirrored(links[i].end), next), 0.0});
    }
  }
  return contour;
}

std::vector<Vec2> placed(const Contour& contour, const ContourPiece& piece,
                         const std::vector<Vec2>& root_to_tip) {
  GW_EXPECTS(!piece.land);
  GW_EXPECTS(root_to_tip.size() >= 2);
  const SinCos turn = sincos_turn(piece.tooth, contour.teeth);
  const auto put = [&](const Vec2& p) -> Vec2 {
    if (!contour.rack) return tidy_turned(p, turn);
    return p + Vec2(0.0, contour.rack->middle_of(piece.tooth, contour.teeth));
  };
  std::vector<Vec2> points;
  points.reserve(root_to_tip.size());
  for (const Vec2& p : root_to_tip) points.push_back(put(piece.mirrored ? mirrored(p) : p));
  if (!piece.mirrored) std::reverse(points.begin(), points.end());
  // The ends of the piece may differ from the ends of the arc for two reasons. Slivers are omitted,
  // and joints are moved to the centre lines.
  GW_EXPECTS((points.front() - piece.begin).norm() < 3 * kShortestArc);
  GW_EXPECTS((points.back() - piece.end).norm() < 3 * kShortestArc);
  points.front() = piece.begin;
  points.back() = piece.end;
  return points;
}

}  // namespace gearwright
