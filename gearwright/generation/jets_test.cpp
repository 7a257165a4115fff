// Tests the laws of the jets of all curves with the same code. The derivatives are compared with
// central differences of point() in 50 digits.
//
//   W    point as a complex number       W′, W″   its derivatives with respect to the parameter
//   h    step 1e-15; the differences have errors of about h² = 1e-30 and 1e-50/h² = 1e-20
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <memory>

#include "gearwright/base/numbers.hpp"
#include "gearwright/generation/pinion_envelope.hpp"
#include "gearwright/generation/rack_envelope.hpp"

namespace gearwright {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_50;

constexpr double kDifference = 1e-15;  // of exact derivatives
constexpr double kDouble = 2e-13;      // of values in double, at places that are not near a cusp

// The angle within half a turn.
double principal(const Exact& a) { return static_cast<double>(atan2(sin(a), cos(a))); }

Plane<Exact> quotient(const Plane<Exact>& a, const Plane<Exact>& b) {
  const Exact norm = b.x * b.x + b.y * b.y;
  return times<Exact>(a, {b.x / norm, -b.y / norm});
}

void expect_equal(const Plane<Exact>& a, const Plane<Exact>& b) {
  const Exact size = sqrt(b.x * b.x + b.y * b.y);
  EXPECT_LE(sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y)), kDifference * size);
}

// The jet is a template, and the curve is its view in double. `jet` returns the jet in 50 digits.
template <class Jet>
void expect_laws(const Curve& curve, const Jet& jet, double t) {
  const Exact h(1e-15);
  const auto before = jet(Exact(t) - h).point(), after = jet(Exact(t) + h).point();
  const auto j = jet(Exact(t));
  const Plane<Exact> w = j.point(),
                     d{(after.x - before.x) / (2 * h), (after.y - before.y) / (2 * h)};
  const Plane<Exact> dd{(after.x - 2 * w.x + before.x) / (h * h),
                        (after.y - 2 * w.y + before.y) / (h * h)};
  EXPECT_LE(std::abs(principal(j.tangent_angle() - atan2(d.y, d.x))), kDifference);
  const Exact speed = sqrt(d.x * d.x + d.y * d.y);
  const Exact curvature = (d.x * dd.y - d.y * dd.x) / (speed * speed * speed);
  EXPECT_LE(abs(j.curvature() - curvature),
            kDifference * (1 / sqrt(w.x * w.x + w.y * w.y) + abs(curvature)));
  if constexpr (requires { j.polar_angle(); }) {
    EXPECT_LE(std::abs(principal(j.polar_angle() - atan2(w.y, w.x))), kDifference);
  }
  if constexpr (requires { j.log_slopes(); }) {
    const auto [d1, d2] = j.log_slopes();
    const Plane<Exact> first = quotient(d, w), square = times(first, first);
    const Plane<Exact> second = quotient(dd, w);
    expect_equal(d1, first);
    expect_equal(d2, {second.x - square.x, second.y - square.y});
    const Plane<Exact> polar = jets::turned(j.factor(), j.phase());
    expect_equal(polar, w);
  }
  // The views in double.
  const CurvePoint p = curve.at(t);
  EXPECT_EQ(curve.point(t), p.point);
  const double size = p.point.norm();
  EXPECT_NEAR(p.point.x(), static_cast<double>(w.x), kDouble * size);
  EXPECT_NEAR(p.point.y(), static_cast<double>(w.y), kDouble * size);
  EXPECT_NEAR(p.tangent_angle, static_cast<double>(j.tangent_angle()), kDouble);
  EXPECT_NEAR(p.curvature, static_cast<double>(curvature),
              kDouble * static_cast<double>(1 / size + abs(curvature)));
  EXPECT_NEAR(principal(curve.polar_angle(t) - atan2(w.y, w.x)), 0.0, kDouble);
}

TEST(Jets, of_circles_lines_and_involutes) {
  for (const double t : {-2.6, -1.3, -0.4, 0.3, 0.9, 2.1}) {
    SCOPED_TRACE(t);
    expect_laws(
        AxisCircle(7.5),
        [](const Exact& x) {
          return jets::AxisCircle<Exact>{7.5, x};
        },
        t);
    expect_laws(
        Involute(20.0, 0.12),
        [](const Exact& x) {
          return jets::Involute<Exact>{20.0, 0.12, x};
        },
        t);
    expect_laws(
        OffsetCircle(9.0, 0.7, 2.5),
        [](const Exact& x) {
          return jets::OffsetCircle<Exact>{9.0, 0.7, 2.5, x};
        },
        t);
    expect_laws(
        StraightLine({1, 2}, {-3, 5}),
        [](const Exact& x) {
          return jets::StraightLine<Exact>{{1, 2}, {-4, 3}, x};
        },
        t);
    for (const double k : {1.0, 1.3})
      expect_laws(
          StretchedCircle({4, -1}, 2.0, k),
          [k](const Exact& x) {
            return jets::StretchedCircle<Exact>{{4, -1}, 2.0, k, x, cos(x), sin(x)};
          },
          t);
  }
}

auto exact_trochoid(const RackTrochoid& curve) {
  const RackMotion m = curve.motion();
  const EdgeCircle c = curve.circle();
  return [m, c](const Exact& tau) {
    return jets::RackTrochoid<Exact>{
        {m.pitch_radius, m.cos_beta, {c.center.x(), c.center.y()}, c.q}, sin(tau), cos(tau)};
  };
}

TEST(Jets, of_trochoids) {
  const EdgeCircle tip{{-1.74, 2.4}, -0.76, {}, {}}, corner{{-2.5, 2.4}, 0.0, {}, {}},
      bottom{{1.4, 0.5}, 0.5, {}, {}};
  for (const RackMotion& motion :
       {RackMotion{20.0, 1.0, 0.4}, RackMotion{17.0, std::cos(kPi / 7), -0.9}}) {
    for (const EdgeCircle& circle : {tip, corner, bottom}) {
      const RackTrochoid curve(motion, circle);
      for (const double tau : {0.5, 0.8, 1.2, 1.5}) expect_laws(curve, exact_trochoid(curve), tau);
    }
  }
}

// The envelope of the curve `cutter`, whose jet in 50 digits is `jet`.
template <class Jet>
void expect_envelope_laws(const PinionMotion& motion, const CurvePtr& cutter, const Jet& jet,
                          double t) {
  for (const Meeting meeting : {Meeting::ahead, Meeting::behind}) {
    for (const Walk walk : {Walk::forward, Walk::backward}) {
      SCOPED_TRACE(motion.teeth);
      const jets::PinionWay<Exact> way(motion, walk, meeting);
      const auto exact = [&](const Exact& x) {
        const auto c = jet(x);
        Exact polar = atan2(c.point().y, c.point().x);
        if constexpr (requires { c.polar_angle(); }) polar = c.polar_angle();
        return jets::PinionEnvelope<Exact>{
            way, {way, c.point(), c.tangent_angle(), c.curvature()}, polar};
      };
      const PinionEnvelope curve(motion, cutter, walk, meeting);
      ASSERT_TRUE(curve.reaches(t));
      // If the tangent points the other way, s is 0. Such a curve is no outline.
      if (exact(Exact(t)).contact.s > 0) expect_laws(curve, exact, t);
    }
  }
}

TEST(Jets, of_envelopes_of_a_pinion) {
  for (const PinionMotion& motion : {PinionMotion{20, 45, 65.0}, PinionMotion{20, -60, 40.1}}) {
    for (const double t : {0.35, 0.6, 1.1}) {
      SCOPED_TRACE(t);
      expect_envelope_laws(
          motion, std::make_shared<OffsetCircle>(19.0, 0.02, 0.7),
          [](const Exact& x) {
            return jets::OffsetCircle<Exact>{19.0, 0.02, 0.7, x};
          },
          t);
      expect_envelope_laws(
          motion, std::make_shared<CornerFan>(Vec2(20.5, 0.3)),
          [](const Exact& x) {
            return jets::CornerFan<Exact>{{20.5, 0.3}, x};
          },
          t);
      expect_envelope_laws(
          motion, std::make_shared<Involute>(18.794, 0.0934),
          [](const Exact& x) {
            return jets::Involute<Exact>{18.794, 0.0934, x};
          },
          t / 2);
      const auto root = std::make_shared<RackTrochoid>(RackMotion{20.0, 1.0, 0.0},
                                                       EdgeCircle{{-1.74, 0.65}, -0.76, {}, {}});
      expect_envelope_laws(motion, root, exact_trochoid(*root), 0.4 + t);
    }
  }
}

}  // namespace
}  // namespace gearwright
