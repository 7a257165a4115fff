#include "gearwright/cad/walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/contract.hpp"
#include "gearwright/cad/bore_loop.hpp"

namespace gearwright {
namespace {

using std::numbers::pi;

// If the radius of a land varies by at most this value, the land counts as a circle about the axis.
constexpr double kRound_mm = 1e-8;
constexpr double kLaw_mm = 1e-6;  // tolerance for the laws of an outline
constexpr int kWallLooks = 64;    // number of examined points of an arc
constexpr int kLandLooks = 32;    // number of examined points of a land

Complex as_complex(const Vec2& v) { return {v.x(), v.y()}; }

struct Extent {
  double inner;
  double outer;
  bool tooth_crossed;  // true if the half outline crosses the centre line of the tooth
  bool space_crossed;  // true if the half outline crosses the middle of the space
};

Extent look_at(const Outline& outline, Complex space) {
  Extent extent{std::abs(as_complex(outline.arcs.front().begin_point)), 0.0, false, false};
  for (const Arc& arc : outline.arcs) {
    for (int i = 0; i <= kWallLooks; ++i) {
      const Complex w = as_complex(arc.point(static_cast<double>(i) / kWallLooks));
      extent.inner = std::min(extent.inner, std::abs(w));
      extent.outer = std::max(extent.outer, std::abs(w));
      // Distances from the two centre lines. If z = 1, both lie on the x axis.
      if (w.imag() < -kLaw_mm) extent.tooth_crossed = true;
      if ((w * std::conj(space)).imag() > kLaw_mm) extent.space_crossed = true;
    }
  }
  return extent;
}

Wall circle_wall(Complex begin, Complex end, double begin_angle, double end_angle) {
  return {WallShape::circle, begin, end, nullptr, {}, std::abs(begin), begin_angle, end_angle};
}

Wall turned(Wall wall, long long k, long long n) {
  const SinCos turn = sincos_turn(k, n);
  const Complex e(turn.cos, turn.sin);
  const double angle = 2.0 * pi * static_cast<double>(k) / static_cast<double>(n);
  wall.begin *= e;
  wall.end *= e;
  for (Complex& pole : wall.poles) pole *= e;
  wall.begin_angle += angle;
  wall.end_angle += angle;
  return wall;
}

// Spline walls of the lower half (mirrored, root to tip) and of the upper half (tip to root).
struct SplinePair {
  Wall lower;
  Wall upper;
};

SplinePair spline_walls(Complex begin, Complex end, const SectionSpline& fit) {
  const WallKnots knots = knots_of(fit.basis);
  std::vector<Complex> mirrored;
  for (const Complex& pole : fit.poles) mirrored.push_back(std::conj(pole));
  return {{WallShape::spline, std::conj(begin), std::conj(end),
           std::make_shared<const WallKnots>(knots), mirrored},
          {WallShape::spline, end, begin, std::make_shared<const WallKnots>(backward(knots)),
           std::vector<Complex>(fit.poles.rbegin(), fit.poles.rend())}};
}

// Returns the walls of tooth 0, from its lower half to the space before tooth 1.
std::vector<Wall> tooth_walls(const std::vector<Arc>& arcs, const std::vector<ArcFit>& fits,
                              int z) {
  std::vector<Wall> lower;
  std::vector<Wall> upper;  // still ordered from root to tip
  const double pitch = 2.0 * pi / z;
  std::optional<Wall> merged_root;
  std::optional<Wall> merged_tip;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const Complex begin = as_complex(arcs[i].begin_point), end = as_complex(arcs[i].end_point);
    if (fits[i].spline) {
      SplinePair pair = spline_walls(begin, end, *fits[i].spline);
      lower.push_back(std::move(pair.lower));
      upper.push_back(std::move(pair.upper));
      continue;
    }
    const bool root = i == 0;
    const double from = root ? pitch / 2.0 : std::arg(begin);
    const double to = root ? std::arg(end) : 0.0;
    const bool whole = std::abs(from - to) <= pi / 2.0;
    if (whole && root) {
      const SinCos next = sincos_turn(1, z);
      merged_root = circle_wall(end, std::conj(end) * Complex(next.cos, next.sin), to, pitch - to);
    } else if (whole) {
      merged_tip = circle_wall(std::conj(begin), begin, -from, from);
    } else {
      lower.push_back(circle_wall(std::conj(begin), std::conj(end), -from, -to));
      upper.push_back(circle_wall(end, begin, to, from));
    }
  }
  std::vector<Wall> walls = std::move(lower);
  if (merged_tip) walls.push_back(*merged_tip);
  walls.insert(walls.end(), upper.rbegin(), upper.rend());
  if (merged_root) walls.push_back(*merged_root);
  return walls;
}

WallLoop loop_of(const std::vector<Wall>& tooth, int z, const Band& band) {
  WallLoop loop;
  loop.walls.reserve(tooth.size() * static_cast<std::size_t>(z));
  for (int k = 0; k < z; ++k) {
    for (const Wall& wall : tooth) loop.walls.push_back(turned(wall, k, z));
  }
  double widest = 0.0;
  for (const Wall& wall : tooth) widest = std::max(widest, wall.end_angle - wall.begin_angle);
  const double most = std::min(pi, 1.5 * pi - widest);
  loop.slices = std::max(1, static_cast<int>(std::ceil(std::abs(band.twist) * band.width / most)));
  return loop;
}

}  // namespace

bool round_land(const Arc& arc) {
  if (arc.name != ArcName::root_land && arc.name != ArcName::tip_land) return false;
  const double radius = arc.begin_point.norm();
  for (int i = 1; i <= kLandLooks; ++i) {
    const double here = arc.point(static_cast<double>(i) / kLandLooks).norm();
    if (std::abs(here - radius) > kRound_mm) return false;
  }
  return true;
}

Outline tidied(const Outline& outline) {
  GW_EXPECTS(!outline.arcs.empty());
  Outline tidy{outline.teeth, {}};
  Vec2 cursor = outline.arcs.front().begin_point;
  for (const Arc& arc : outline.arcs) {
    const Vec2 middle = arc.point(0.5);
    const double length = (middle - arc.begin_point).norm() + (arc.end_point - middle).norm();
    if (length < kShortestArc_mm) continue;
    tidy.arcs.push_back(arc);
    tidy.arcs.back().begin_point = cursor;
    cursor = arc.end_point;
  }
  GW_EXPECTS(!tidy.arcs.empty());
  const auto move = [](Vec2& end, const SinCos& ray, double most) {
    const Vec2 on_ray = std::hypot(end.x(), end.y()) * Vec2(ray.cos, ray.sin);
    GW_EXPECTS((on_ray - end).norm() <= most);
    end = on_ray;
  };
  move(tidy.arcs.front().begin_point, sincos_turn(1, 2LL * std::abs(outline.teeth)), kLaw_mm);
  // The tolerance is greater at the tip, because several slivers may be omitted at the tip.
  move(tidy.arcs.back().end_point, {0.0, 1.0}, 4.0 * kLaw_mm);
  return tidy;
}

WallKnots knots_of(const BSplineBasis& basis) {
  return {basis.degree(), basis.distinct_knots(), basis.multiplicities()};
}

WallKnots backward(WallKnots knots) {
  std::reverse(knots.distinct.begin(), knots.distinct.end());
  for (double& knot : knots.distinct) knot = 1.0 - knot;
  std::reverse(knots.multiplicity.begin(), knots.multiplicity.end());
  return knots;
}

Error no_spline(std::string_view face, double deviation) {
  return {"", "",
          fmt::format("the best spline for the {} deviates by {:.1e} mm, but at most {:.0e} mm is "
                      "allowed",
                      face, deviation, kSectionMax_mm)};
}

Result<BodyWalls> make_walls(const ToothedBody& body) {
  GW_EXPECTS(body.face_width > 0.0 && std::isfinite(body.twist));
  GW_EXPECTS(body.outline.teeth != 0 && !body.outline.arcs.empty());
  const int z = std::abs(body.outline.teeth);
  const SinCos half = sincos_turn(1, 2LL * z);
  const Complex space(half.cos, half.sin);

  const Vec2& root = body.outline.arcs.front().begin_point;
  if (!(root.dot(Vec2(half.cos, half.sin)) > 0.0)) {
    return not_a_body(body.outline.teeth, "the root lies beyond the axis");
  }
  const Extent extent = look_at(body.outline, space);
  if (extent.tooth_crossed)
    return not_a_body(body.outline.teeth, "the flanks of a tooth cross each other");
  if (extent.space_crossed)
    return not_a_body(body.outline.teeth, "the flanks of a tooth space cross each other");
  std::optional<WallLoop> bore;
  if (body.bore || body.ring()) {
    auto made = make_bore(body, extent.inner, extent.outer);
    if (!made) return made.error();
    bore = std::move(made).take();
  }

  const std::vector<Arc> arcs = tidied(body.outline).arcs;
  std::vector<ArcFit> fits;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const Arc& arc = arcs[i];
    fits.push_back({arc.name, std::nullopt});
    // A circle and its mirror image form one wall only if they meet at the centre line of a tooth
    // or space.
    if ((i == 0 || i + 1 == arcs.size()) && round_land(arc)) continue;
    fits.back().spline = fit_section(arc);
    const double deviation = fits.back().spline->deviation_mm;
    if (!(deviation <= kSectionMax_mm)) return no_spline(to_string(arc.name), deviation);
  }

  const std::vector<Band> bands = body.bands();
  WallLoop teeth = loop_of(tooth_walls(arcs, fits, z), z, bands.front());
  std::vector<HelixSpline> helices;
  for (const Band& band : bands)
    helices.push_back(fit_helix(band.twist * band.width / teeth.slices, extent.outer));
  return BodyWalls{std::move(teeth), std::move(bore), std::move(helices),
                   std::move(fits),  extent.inner,    extent.outer};
}

std::vector<WallLevel> levels_of(const Band& band, int slices) {
  std::vector<WallLevel> levels;
  for (int i = 0; i <= slices; ++i) {
    const double z = band.middle + band.width * (2 * i - slices) / (2.0 * slices);
    levels.push_back({z, band.angle(z), std::polar(1.0, band.angle(z))});
  }
  return levels;
}

WallSlice slice_between(const WallLevel& low, const WallLevel& high, const HelixSpline& helix) {
  WallSlice slice{low, high, 0.5 * (low.angle + high.angle), {}, {}, {}};
  const Complex middle = std::polar(1.0, slice.middle_angle);
  const auto z_at = [&](double v) { return low.z + (high.z - low.z) * v; };
  for (const Complex& h : helix.poles) slice.helix.push_back(middle * h);
  for (const double g : helix.basis.greville()) slice.height.push_back(z_at(g));
  slice.knots = knots_of(helix.basis);
  for (double& knot : slice.knots.distinct) knot = z_at(knot);
  slice.helix.front() = low.turn;
  slice.helix.back() = high.turn;
  slice.height.back() = high.z;
  slice.knots.distinct.back() = high.z;
  return slice;
}

Vec3 point_at(Complex section_point, const WallLevel& level) {
  const Complex w = section_point * level.turn;
  return {w.real(), w.imag(), level.z};
}

Vec3 climbing_pole(Complex section_point, const WallSlice& slice, std::size_t j) {
  const Complex w = section_point * slice.helix[j];
  return {w.real(), w.imag(), slice.height[j]};
}

}  // namespace gearwright
