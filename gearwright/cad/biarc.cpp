#include "gearwright/cad/biarc.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/cad/drawing.hpp"
#include "gearwright/cad/fitting.hpp"

namespace gearwright {
namespace {

constexpr double kStraight = 1e-9;  // mm; an arc with a smaller sagitta is written as a line
// One arc replaces a biarc if the angle from the start tangent to the chord and the angle from the
// chord to the end tangent differ by less than this value, rad.
constexpr double kOneCircle = 1e-9;
// The first number is the length of the shortest biarc, in units of the curve parameter, which runs
// from 0 to 1 along the arc. The second number is the relative error of the length that the search
// for the longest possible biarc finds.
constexpr StepLimits kLimits{1.0 / 4096, 1.0 / 128};
constexpr int kVouching = 256;  // number of points per biarc at which the tolerance is verified

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Returns the bulge tan(φ/2) of an arc that starts in the direction `tangent` and ends at the end
// of `chord`. φ is the angle from `tangent` to `chord`. If the sagitta is less than kStraight, the
// bulge is 0.
double bulge_of(const Vec2& tangent, const Vec2& chord) {
  const double length = chord.norm();
  const double bulge = cross(tangent, chord) / (length + tangent.dot(chord));
  return std::abs(bulge) * length < 2.0 * kStraight ? 0.0 : bulge;
}

struct End {
  Vec2 point;
  Vec2 tangent;
};

struct Biarc {
  Vec2 joint;  // equals the end point if there is only one arc
  int arcs;    // 1 or 2
  double bulges[2];
};

Biarc join(const End& a, const End& b) {
  const Vec2 v = b.point - a.point;
  const double length = v.norm();
  const double turn_a = std::atan2(cross(a.tangent, v), a.tangent.dot(v));
  const double turn_b = std::atan2(cross(v, b.tangent), v.dot(b.tangent));
  if (std::abs(turn_a - turn_b) < kOneCircle) return {b.point, 1, {bulge_of(a.tangent, v), 0.0}};
  const double along = v.dot(a.tangent + b.tangent);
  const double open = 2.0 * (1.0 - a.tangent.dot(b.tangent));
  // d is the positive root of the quadratic equation in biarc.hpp, in a form without cancellation.
  const double d = length * length / (along + std::sqrt(along * along + open * length * length));
  const Vec2 joint = 0.5 * (a.point + b.point) + 0.5 * d * (a.tangent - b.tangent);
  // The bulge of the second arc is computed from its end to its start, which changes its sign.
  return {joint, 2, {bulge_of(a.tangent, joint - a.point), -bulge_of(-b.tangent, joint - b.point)}};
}

// The circle of an arc, described by one point of the circle, the unit normal at this point and the
// curvature kappa, 1/mm. If the arc is a line, kappa is 0.
struct ArcCircle {
  Vec2 from;
  Vec2 normal;
  double kappa;
};

ArcCircle circle_of(const Vec2& from, const Vec2& to, double bulge) {
  const Vec2 chord = to - from;
  const double length = chord.norm();
  const double scale = 1.0 / (1.0 + bulge * bulge);
  const double cosine = (1.0 - bulge * bulge) * scale;
  const double sine = 2.0 * bulge * scale;
  const Vec2 unit = chord / length;
  const Vec2 tangent(cosine * unit.x() + sine * unit.y(), cosine * unit.y() - sine * unit.x());
  return {from, {-tangent.y(), tangent.x()}, 2.0 * sine / length};
}

class Fitter {
 public:
  Fitter(const Arc& arc, int looks) : arc_(arc), looks_(looks) {}

  End end(double u) const {
    const double angle = arc_.at(u).tangent_angle;
    return {arc_.point(u), {std::cos(angle), std::sin(angle)}};
  }

  // Returns the greatest distance from the biarc to `looks` points of the exact curve between u0
  // and u1. Points of the curve beyond the normal at the joint are compared with the second arc.
  double deviation(const Biarc& biarc, const End& a, const End& b, double u0, double u1,
                   int looks) const {
    const ArcCircle first = circle_of(a.point, biarc.joint, biarc.bulges[0]);
    const ArcCircle second =
        biarc.arcs == 2 ? circle_of(biarc.joint, b.point, biarc.bulges[1]) : first;
    const Vec2 forward(second.normal.y(), -second.normal.x());
    double worst = 0.0;
    for (int i = 0; i < looks; ++i) {
      const Vec2 p = arc_.point(u0 + (u1 - u0) * ((i + 0.5) / looks));
      const bool behind = biarc.arcs == 2 && (p - biarc.joint).dot(forward) > 0.0;
      const ArcCircle& t = behind ? second : first;
      worst = std::max(worst, circle_distance(p - t.from, t.normal, t.kappa));
    }
    return worst;
  }

  BiarcChain chain(double tolerance) const {
    BiarcChain result{{arc_.begin_point}, {}, 0.0};
    const auto fits = [&](double u0, const End& a, double u1) {
      const End b = end(u1);
      if (b.point == a.point) return false;
      return deviation(join(a, b), a, b, u0, u1, looks_) <= tolerance;
    };
    double u0 = 0.0;
    double step = 1.0;
    End a = end(0.0);
    while (u0 < 1.0) {
      const double u1 =
          longest_step(u0, 1.0, step, kLimits, [&](double u) { return fits(u0, a, u); });
      const End b = end(u1);
      const Biarc biarc = join(a, b);
      for (int i = 0; i < biarc.arcs; ++i) {
        result.bulges.push_back(biarc.bulges[i]);
        result.points.push_back(i + 1 < biarc.arcs ? biarc.joint : b.point);
      }
      result.deviation_mm =
          std::max(result.deviation_mm, deviation(biarc, a, b, u0, u1, kVouching));
      step = u1 - u0;
      u0 = u1;
      a = b;
    }
    return result;
  }

 private:
  const Arc& arc_;
  int looks_;
};

}  // namespace

BiarcChain fit_biarcs(const Arc& arc, double tolerance_mm) {
  GW_EXPECTS(tolerance_mm > 0.0);
  GW_EXPECTS(arc.begin_point != arc.end_point);
  // 24 samples give the greatest error within 1 % if the error along a biarc has one or two maxima
  // and if the speed of the parametrization is nearly constant. In other cases, the verification
  // with kVouching samples may find a greater error. The fit is then repeated with more samples.
  BiarcChain chain{};
  for (const int looks : {24, 96, kVouching}) {
    chain = Fitter(arc, looks).chain(0.98 * tolerance_mm);
    // If the error exceeds twice the tolerance, more samples do not help. The curve then needs more
    // than 4096 steps, or rounding errors are too large.
    if (chain.deviation_mm <= tolerance_mm || chain.deviation_mm > 2.0 * tolerance_mm) break;
  }
  return chain;
}

// The fit of an arc runs from root to tip. A piece of the contour is this fit, either mirrored or
// reversed. Both operations change the sign of a bulge.
Result<BiarcChain> biarc_contour(const Outline& outline, const Contour& contour,
                                 double tolerance_mm) {
  const auto fits = fit_arcs(outline, contour, tolerance_mm, fit_biarcs);
  if (!fits) return fits.error();
  BiarcChain result{{}, {}, fits->deviation_mm};
  for (const ContourPiece& piece : contour.pieces) {
    if (piece.land) {
      result.points.push_back(piece.begin);
      result.bulges.push_back(std::tan(piece.sweep / 4.0));
      continue;
    }
    const BiarcChain& chain = *fits->arcs[piece.arc];
    const std::vector<Vec2> here = placed(contour, piece, chain.points);
    result.points.insert(result.points.end(), here.begin(), here.end() - 1);
    const std::size_t n = chain.bulges.size();
    for (std::size_t i = 0; i < n; ++i)
      result.bulges.push_back(-chain.bulges[piece.mirrored ? i : n - 1 - i]);
  }
  return result;
}

}  // namespace gearwright
