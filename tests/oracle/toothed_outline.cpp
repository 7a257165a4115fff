// The pieces of an outline, and the foot points on them.
//
// A foot point is a root of F(t) = (c(t) − q)·c′(t) at which F changes from − to +. If q is nearer
// than the least radius of curvature, F increases along a piece with a small turn, so there is at
// most one root. Further away on the concave side, there may be more roots. Then eighths of the
// piece are examined.
#include "tests/oracle/toothed_outline.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tests/oracle/numbers.hpp"
#include "tests/oracle/require.hpp"

namespace gearwright::oracle {
namespace {

using Eigen::Vector2d;

// Tolerance for the joints of curves and for the distance of the ends from the two rays. A gap
// changes a distance by at most this length.
constexpr double kGap = 1e-9;  // mm
// A piece as short as this deviates from any smooth curve by less than the square of its length
// divided by the radius of curvature, which is 1e-12 mm for 1 mm. This limit is needed if the speed
// is singular, as with √u at a base circle.
constexpr double kShort = 1e-6;  // mm
constexpr double kTurn = 0.3;    // rad
constexpr std::size_t kMaxPieces = 4096;
// Tangents at the ends are evaluated slightly inside the curve, because the speed may be zero at a
// base circle.
constexpr double kInside = 1 - 1e-5;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The left side is outside, because the chain runs clockwise about the centre.
Vector2d left(const Vector2d& v) { return {-v.y(), v.x()}; }

double turn_between(const Vector2d& a, const Vector2d& b) {
  return std::abs(std::atan2(cross(a, b), a.dot(b)));
}

}  // namespace

ToothedOutline::ToothedOutline(int teeth, const std::vector<Curve>& half_tooth) : teeth_(teeth) {
  require(teeth >= 1, "teeth: an outline has at least 1");
  for (const Curve& curve : half_tooth) {
    // A curve without length (a land of width zero) is skipped. The remaining gap is checked in
    // close().
    const Vector2d first = curve(0.0);
    if ((curve(0.5) - first).norm() + (curve(1.0) - first).norm() < 1e-12) continue;
    append(curve, 0.0, 1.0);
  }
  require(!pieces_.empty(), "half_tooth: has no curve with a length");
  close();
}

void ToothedOutline::append(const Curve& curve, double from, double to) {
  constexpr int kNodes = kDegree + 1;
  // Chebyshev nodes including the ends, so that neighbouring pieces have a common point.
  static const std::array<double, kNodes> nodes = [] {
    std::array<double, kNodes> t{};
    for (int i = 0; i < kNodes; ++i) t[i] = -std::cos(kPi * i / kDegree);
    t[kDegree / 2] = 0.0;
    return t;
  }();
  using Square = Eigen::Matrix<double, kNodes, kNodes>;
  static const Eigen::PartialPivLU<Square> solver = [] {
    Square powers;
    for (int i = 0; i < kNodes; ++i) {
      powers(i, 0) = 1.0;
      for (int k = 1; k < kNodes; ++k) powers(i, k) = powers(i, k - 1) * nodes[i];
    }
    return Eigen::PartialPivLU<Square>(powers);
  }();
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  const auto curve_at = [&](double t) {
    return curve(t == -1.0 ? from : t == 1.0 ? to : middle + half * t);
  };

  std::array<Vector2d, kNodes> points;
  for (int i = 0; i < kNodes; ++i) points[i] = curve_at(nodes[i]);
  Eigen::Matrix<double, kNodes, 2> values;
  for (int i = 0; i < kNodes; ++i) values.row(i) = (points[i] - points[kDegree / 2]).transpose();
  Piece piece;
  piece.c = solver.solve(values).transpose();
  piece.c.col(0) = points[kDegree / 2];

  double length = 0.0, turn = 0.0, radius = 0.0;
  for (int i = 0; i < kDegree; ++i) {
    length += (points[i + 1] - points[i]).norm();
    radius = std::max({radius, points[i].norm(), points[i + 1].norm()});
    if (i > 0) turn += turn_between(points[i] - points[i - 1], points[i + 1] - points[i]);
  }
  bool good = length < kShort;
  if (!good && turn < kTurn) {
    const double tolerance = 4e-14 + 16 * std::numeric_limits<double>::epsilon() * radius;
    good = true;
    for (int i = 0; i < 2 * kDegree && good; ++i) {
      const double left_node = nodes[i / 2], right_node = nodes[i / 2 + 1];
      const double t = left_node + (right_node - left_node) * (i % 2 == 0 ? 0.3 : 0.7);
      good = (jet(piece, t).value - curve_at(t)).norm() <= tolerance;
    }
  }
  if (!good) {
    require(middle > from && middle < to, "half_tooth: a curve has a gap in itself");
    append(curve, from, middle);
    append(curve, middle, to);
    return;
  }
  require(pieces_.size() < kMaxPieces, "half_tooth: a curve is rough, not smooth to 1e-13 mm");

  piece.reach = 0.0;
  for (int k = 1; k <= kDegree; ++k) piece.reach += piece.c.col(k).norm();
  piece.hollow = std::numeric_limits<double>::infinity();
  for (const double node : nodes) {
    const Jet j = jet(piece, node * kInside);
    const double speed = j.slope.norm();
    piece.hollow = std::min(
        piece.hollow, 0.9 * speed * speed * speed / std::abs(2 * cross(j.slope, j.half_bend)));
  }
  for (const int end : {0, 1}) {
    const double t = end == 0 ? -1.0 : 1.0;
    piece.ends[end] = points[end == 0 ? 0 : kDegree];
    piece.tangents[end] = jet(piece, t * kInside).slope.normalized();
  }
  const double gamma = kPi / teeth_;
  for (const Vector2d& p : points) {
    require(p.allFinite(), "half_tooth: a point is not a number");
    require(p.y() >= -kGap && p.x() * std::sin(gamma) - p.y() * std::cos(gamma) >= -kGap,
            "half_tooth: the chain leaves its half pitch");
  }
  outer_radius_ = std::max(outer_radius_, radius * (1 + 1e-3) + 1e-2 * length);
  pieces_.push_back(piece);
}

// Joints, the two rays, and the outward normals of neighbours. Beyond a mirror line, the chain
// continues as its own image, so the tangent v of the end continues as the mirror image of −v.
void ToothedOutline::close() {
  const double gamma = kPi / teeth_;
  const Vector2d ray(std::cos(gamma), std::sin(gamma));
  const Vector2d first = pieces_.front().ends[0], last = pieces_.back().ends[1];
  require(std::abs(cross(ray, first)) <= kGap && ray.dot(first) > 0,
          "half_tooth: must begin in the middle of the space");
  require(std::abs(last.y()) <= kGap && last.x() > 0,
          "half_tooth: must end in the middle of the tooth");
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    Piece& p = pieces_[i];
    Vector2d before, after;
    if (i == 0) {
      const Vector2d v = p.tangents[0];
      before = v - 2 * ray.dot(v) * ray;
    } else {
      require((pieces_[i - 1].ends[1] - p.ends[0]).norm() <= kGap,
              "half_tooth: two curves do not meet");
      before = pieces_[i - 1].tangents[1];
    }
    if (i + 1 == pieces_.size()) {
      after = {-p.tangents[1].x(), p.tangents[1].y()};
    } else {
      after = pieces_[i + 1].tangents[0];
    }
    p.outside[0] = left(before) + left(p.tangents[0]);
    p.outside[1] = left(p.tangents[1]) + left(after);
  }
}

ToothedOutline::Jet ToothedOutline::jet(const Piece& p, double t) {
  Jet j{p.c.col(kDegree), Vector2d::Zero(), Vector2d::Zero()};
  for (int k = kDegree - 1; k >= 0; --k) {
    j.half_bend = j.half_bend * t + j.slope;
    j.slope = j.slope * t + j.value;
    j.value = j.value * t + p.c.col(k);
  }
  return j;
}

ToothedOutline::Place ToothedOutline::end_place(const Piece& p, int end, const Vector2d& q) {
  const Vector2d d = q - p.ends[end];
  const double squared = d.squaredNorm();
  return {squared, std::copysign(std::sqrt(squared), d.dot(p.outside[end]))};
}

/// The root of F between lo and hi at which F changes from − to +. Newton's method is kept within
/// the bracket.
ToothedOutline::Place ToothedOutline::root_place(const Piece& p, double lo, double hi,
                                                 const Vector2d& q) {
  const Vector2d chord = p.c.col(1);
  double t = (q - p.c.col(0)).dot(chord) / chord.squaredNorm();
  if (!(t > lo && t < hi)) t = 0.5 * (lo + hi);
  for (int i = 0; i < 100; ++i) {
    const Jet j = jet(p, t);
    const double f = (j.value - q).dot(j.slope);
    (f < 0 ? lo : hi) = t;
    double next = t - f / (j.slope.squaredNorm() + 2 * (j.value - q).dot(j.half_bend));
    if (!(next >= lo && next <= hi)) next = 0.5 * (lo + hi);
    const double step = std::abs(next - t);
    t = next;
    if (step < 1e-10)
      break;  // the next step would be the square of this one, which is below
              // rounding
  }
  const Jet j = jet(p, t);
  const Vector2d d = q - j.value;
  // The distance is measured perpendicular to the tangent. An error e of the foot point along the
  // curve then changes it by only e², whereas |d| would change by e.
  const double across = cross(j.slope, d) / j.slope.norm();
  const double squared = d.squaredNorm();
  const double length = std::sqrt(squared);
  return {squared, length > 1e-6 ? std::copysign(length, across) : across};
}

ToothedOutline::Place ToothedOutline::nearest(const Piece& p, const Vector2d& q) {
  const bool behind = (p.ends[0] - q).dot(p.tangents[0]) >= 0;
  const bool ahead = (p.ends[1] - q).dot(p.tangents[1]) <= 0;
  const double least = (q - p.c.col(0)).norm() - p.reach;
  if (!behind && !ahead && least < p.hollow) return root_place(p, -1, 1, q);
  const Place first = end_place(p, 0, q), last = end_place(p, 1, q);
  Place best = first.squared < last.squared ? first : last;
  if (least < p.hollow) return best;
  constexpr int kParts = 8;
  double before = -1, f_before = behind ? 1.0 : -1.0;
  for (int i = 1; i <= kParts; ++i) {
    const double t = -1 + 2.0 * i / kParts;
    double f = ahead ? -1.0 : 1.0;
    if (i < kParts) {
      const Jet j = jet(p, t);
      f = (j.value - q).dot(j.slope);
    }
    if (f_before < 0 && f >= 0) {
      const Place place = root_place(p, before, t, q);
      if (place.squared < best.squared) best = place;
    }
    before = t, f_before = f;
  }
  return best;
}

ToothedOutline::Foot ToothedOutline::foot(Vector2d q, std::size_t start) const {
  const double pitch = 2 * kPi / teeth_;
  const double turns = std::nearbyint(std::atan2(q.y(), q.x()) / pitch);
  if (turns != 0.0) {
    const double s = std::sin(turns * pitch), c = std::cos(turns * pitch);
    q = Vector2d(c * q.x() + s * q.y(), c * q.y() - s * q.x());
  }
  q.y() = std::abs(q.y());

  if (start >= pieces_.size()) start = 0;
  Foot found{0.0, start};
  Place best = nearest(pieces_[start], q);
  double reach = std::sqrt(best.squared);
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const double limit = reach + pieces_[i].reach;
    if (i == start || (q - pieces_[i].c.col(0)).squaredNorm() >= limit * limit) continue;
    const Place place = nearest(pieces_[i], q);
    if (place.squared < best.squared) {
      best = place;
      reach = std::sqrt(best.squared);
      found.piece = i;
    }
  }
  found.distance = best.signed_distance;
  return found;
}

}  // namespace gearwright::oracle
