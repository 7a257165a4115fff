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

// Variation of radius within which a land is a circle about the axis.
constexpr double kRound_mm = 1e-8;
constexpr double kLaw_mm = 1e-6;  // tolerance for the laws of an outline
constexpr int kWallLooks = 64;    // points of an arc that are examined for radius and side

Complex as_complex(const Vec2& v) { return {v.x(), v.y()}; }

// An arc that remains, with its ends after the removal of slivers.
struct Piece {
  const Arc* arc;
  Complex begin;
  Complex end;
  bool circle;
};

bool is_circle(const Arc& arc, Complex begin, Complex end) {
  if (arc.name != ArcName::root_land && arc.name != ArcName::tip_land) return false;
  const double radius = std::abs(begin);
  if (std::abs(std::abs(end) - radius) > kRound_mm) return false;
  for (const double u : {0.25, 0.5, 0.75}) {
    if (std::abs(arc.point(u).norm() - radius) > kRound_mm) return false;
  }
  return true;
}

std::vector<Piece> pieces_of(const Outline& outline) {
  std::vector<Piece> pieces;
  Complex cursor = as_complex(outline.arcs.front().begin_point);
  for (const Arc& arc : outline.arcs) {
    const Vec2 middle = arc.point(0.5);
    const double length = (middle - arc.begin_point).norm() + (arc.end_point - middle).norm();
    if (length < kShortestArc_mm) continue;
    pieces.push_back({&arc, cursor, as_complex(arc.end_point), false});
    cursor = pieces.back().end;
  }
  return pieces;
}

// Moves the first begin to the middle of the space and the last end to the middle of the tooth.
void close_ends(std::vector<Piece>& pieces, Complex space) {
  Piece& first = pieces.front();
  const Complex root = std::abs(first.begin) * space;
  GW_EXPECTS(std::abs(root - first.begin) <= kLaw_mm);
  first.begin = root;
  Piece& last = pieces.back();
  const Complex tip = {std::abs(last.end), 0.0};
  // Each sliver at the tip may have been nearly as long as the shortest arc.
  GW_EXPECTS(std::abs(tip - last.end) <= 4.0 * kLaw_mm);
  last.end = tip;
}

struct Extent {
  double inner;
  double outer;
  bool tooth_crossed;  // the half outline crosses the middle of the tooth
  bool space_crossed;  // the half outline crosses the middle of the space
};

Extent look_at(const Outline& outline, Complex space) {
  Extent extent{std::abs(as_complex(outline.arcs.front().begin_point)), 0.0, false, false};
  for (const Arc& arc : outline.arcs) {
    for (int i = 0; i <= kWallLooks; ++i) {
      const Complex w = as_complex(arc.point(static_cast<double>(i) / kWallLooks));
      extent.inner = std::min(extent.inner, std::abs(w));
      extent.outer = std::max(extent.outer, std::abs(w));
      // Distances from the two lines, which coincide with the x axis for z = 1.
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

SplinePair spline_walls(const Piece& piece, const SectionSpline& fit) {
  auto forward = std::make_shared<WallKnots>(
      WallKnots{fit.basis.degree(), fit.basis.distinct_knots(), fit.basis.multiplicities()});
  auto backward = std::make_shared<WallKnots>(*forward);
  std::reverse(backward->distinct.begin(), backward->distinct.end());
  for (double& knot : backward->distinct) knot = 1.0 - knot;
  std::reverse(backward->multiplicity.begin(), backward->multiplicity.end());
  std::vector<Complex> mirrored;
  for (const Complex& pole : fit.poles) mirrored.push_back(std::conj(pole));
  return {{WallShape::spline, std::conj(piece.begin), std::conj(piece.end), forward, mirrored},
          {WallShape::spline, piece.end, piece.begin, backward,
           std::vector<Complex>(fit.poles.rbegin(), fit.poles.rend())}};
}

// Walls of tooth 0, from its lower half round to the space before tooth 1.
std::vector<Wall> tooth_walls(const std::vector<Piece>& pieces, const std::vector<ArcFit>& fits,
                              int z) {
  std::vector<Wall> lower;
  std::vector<Wall> upper;  // still ordered from root to tip
  const double pitch = 2.0 * pi / z;
  std::optional<Wall> merged_root;
  std::optional<Wall> merged_tip;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    if (!piece.circle) {
      SplinePair pair = spline_walls(piece, *fits[i].spline);
      lower.push_back(std::move(pair.lower));
      upper.push_back(std::move(pair.upper));
      continue;
    }
    const bool root = i == 0;
    const double from = root ? pitch / 2.0 : std::arg(piece.begin);
    const double to = root ? std::arg(piece.end) : 0.0;
    const bool whole = std::abs(from - to) <= pi / 2.0;
    if (whole && root) {
      const SinCos next = sincos_turn(1, z);
      merged_root = circle_wall(piece.end, std::conj(piece.end) * Complex(next.cos, next.sin), to,
                                pitch - to);
    } else if (whole) {
      merged_tip = circle_wall(std::conj(piece.begin), piece.begin, -from, from);
    } else {
      lower.push_back(circle_wall(std::conj(piece.begin), std::conj(piece.end), -from, -to));
      upper.push_back(circle_wall(piece.end, piece.begin, to, from));
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

Error unmet(const Arc& arc, double deviation) {
  return {"", "",
          fmt::format("the {} cannot be drawn as a spline closer than {:.1e} mm; at most {:.0e} mm "
                      "is allowed",
                      to_string(arc.name), deviation, kSectionMax_mm)};
}

}  // namespace

Result<BodyWalls> make_walls(const ToothedBody& body) {
  GW_EXPECTS(body.face_width > 0.0 && std::isfinite(body.twist));
  GW_EXPECTS(body.outline.teeth != 0 && !body.outline.arcs.empty());
  const int z = std::abs(body.outline.teeth);
  const SinCos half = sincos_turn(1, 2LL * z);
  const Complex space(half.cos, half.sin);

  const Vec2& root = body.outline.arcs.front().begin_point;
  if (!(root.dot(Vec2(half.cos, half.sin)) > 0.0)) {
    return not_a_body(body.outline.teeth, "its root lies beyond the axis");
  }
  const Extent extent = look_at(body.outline, space);
  if (extent.tooth_crossed) return not_a_body(body.outline.teeth, "the flanks of a tooth cross");
  if (extent.space_crossed) return not_a_body(body.outline.teeth, "the flanks of a space cross");
  std::optional<WallLoop> bore;
  if (body.bore || body.outline.teeth < 0) {
    auto made = make_bore(body, extent.inner, extent.outer);
    if (!made) return made.error();
    bore = std::move(made).take();
  }

  std::vector<Piece> pieces = pieces_of(body.outline);
  GW_EXPECTS(!pieces.empty());
  close_ends(pieces, space);
  std::vector<ArcFit> fits;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Piece& piece = pieces[i];
    // A circle can form one wall together with its mirror image only at the middle of a tooth or
    // space.
    piece.circle =
        (i == 0 || i + 1 == pieces.size()) && is_circle(*piece.arc, piece.begin, piece.end);
    fits.push_back({piece.arc->name, std::nullopt});
    if (piece.circle) continue;
    fits.back().spline = fit_section(*piece.arc, piece.begin, piece.end);
    const double deviation = fits.back().spline->deviation_mm;
    if (!(deviation <= kSectionMax_mm)) return unmet(*piece.arc, deviation);
  }

  const std::vector<Band> bands = body.bands();
  WallLoop teeth = loop_of(tooth_walls(pieces, fits, z), z, bands.front());
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
  slice.knots = {helix.basis.degree(), helix.basis.distinct_knots(), helix.basis.multiplicities()};
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
