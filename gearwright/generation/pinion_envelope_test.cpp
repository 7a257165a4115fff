//   ψ   turn of the cutter; at ψ = 0, its tooth 0 points at space 0 of the gear
#include "gearwright/generation/pinion_envelope.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/generation/circular_fillets.hpp"
#include "gearwright/generation/rack_envelope.hpp"
#include "gearwright/generation/testing/cutter_piece.hpp"

namespace gearwright {
namespace {

Vec2 turned(const Vec2& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

using testing::CutterPiece;

// The normal that points out of the cutter, to the left of the direction from root to tip.
Vec2 normal_of(const CutterPiece& piece, double t) { return turned(piece.tangent(t), kPi / 2); }

struct Cutter {
  int teeth;
  Involute flank;
  double xi_c, xi_j;  // ends of the flank
};

// Cutters with circular fillets and their gears. In the last case the cutter is nearly as large as
// the gear.
std::vector<CutterPiece> pieces(Meeting meeting) {
  const Cutter eight{8, Involute(11.276, 0.2376), 0.004866, 0.9928};
  const Cutter two{2, Involute(1.8629, 1.3), 0.013, 2.1677};
  const Cutter one{1, Involute(1.472, 2.43), 0.0602, 3.4452};
  const Cutter twenty{20, Involute(18.794, 0.0934), 0.12, 0.55};
  const std::vector<std::pair<Cutter, PinionMotion>> sets{
      {eight, {8, 24, 48.0}},  {eight, {8, -30, 33.2}},  {two, {2, 60, 61.335}},
      {one, {1, 30, 54.05}},   {twenty, {20, 37, 57.5}}, {twenty, {20, -60, 40.1}},
      {twenty, {20, -26, 6.1}}};
  std::vector<CutterPiece> all;
  for (const auto& [cutter, motion] : sets) {
    const auto root = root_fillet_at(cutter.flank, cutter.teeth, cutter.xi_c);
    const auto tip = tip_fillet_at(cutter.flank, cutter.xi_j);
    EXPECT_TRUE(root && tip) << cutter.teeth;
    const double gamma = kPi / cutter.teeth;
    all.push_back({motion, std::make_shared<OffsetCircle>(tip->distance, 0.0, tip->radius),
                   tip->span.rad(), 0.0, meeting});
    const Vec2 j = cutter.flank.point(cutter.xi_j);
    const double nu = cutter.flank.base_half_angle() - cutter.xi_j + kPi / 2;
    all.push_back({motion, std::make_shared<CornerFan>(j), nu, std::atan2(j.y(), j.x()), meeting});
    if (meeting == Meeting::behind) continue;  // the root is not reached
    all.push_back({motion, std::make_shared<OffsetCircle>(root->distance, gamma, root->radius),
                   gamma - kPi, gamma - kPi + root->span.rad(), meeting});
  }
  if (meeting == Meeting::behind) return all;
  // The root that a rack leaves on a cutter with 20 teeth, module 2.
  const RackMotion rack{20.0, 1.0, 0.0};
  const EdgeCircle rounding{{-1.74, 0.65}, -0.76, Angle::radians(kPi / 2), Angle::radians(kPi / 9)};
  const auto trochoid = std::make_shared<RackTrochoid>(rack, rounding);
  for (const PinionMotion& motion : {PinionMotion{20, 45, 65.0}, PinionMotion{20, -60, 40.1}})
    all.push_back({motion, trochoid, kPi / 2, kPi / 9, meeting});
  return all;
}

constexpr double kParts[] = {0.03, 0.2, 0.37, 0.5, 0.71, 0.93};

bool reaches(const CutterPiece& piece, double t) {
  const double s = piece.curve->point(t).dot(piece.tangent(t));
  return s < 0.999 * piece.motion.cutter_pitch_radius();
}

// ϑ is the polar angle at which the normal meets the centrode, ahead or behind, within half a turn
// of the point.
double polar_of_pitch_point(const CutterPiece& piece, double t) {
  const Vec2 p = piece.curve->point(t), n = normal_of(piece, t);
  const double r_p = piece.motion.cutter_pitch_radius(), q = p.dot(n);
  const double w = std::sqrt(q * q - p.squaredNorm() + r_p * r_p);
  const Vec2 pitch = p + n * ((piece.meeting == Meeting::ahead ? w : -w) - q);
  const double theta = piece.curve->polar_angle(t);
  return theta + std::remainder(std::atan2(pitch.y(), pitch.x()) - theta, 2 * kPi);
}

// Places cutter and gear in the position in which the point is cut, and transforms the point to the
// frame of the gear.
Vec2 rolled(const CutterPiece& piece, double t) {
  const PinionMotion& m = piece.motion;
  const double psi = -polar_of_pitch_point(piece, t);
  const double gear_turn = m.cutter_teeth * psi / std::abs(m.teeth);
  const double half_pitch = kPi / std::abs(m.teeth);
  const Vec2 axis(m.distance, 0.0);
  const Vec2 p = piece.curve->point(t);
  if (m.teeth > 0) return turned(axis + turned(p, kPi + psi), half_pitch + gear_turn);
  // In an internal gear, the side y > 0 of the cutter faces the tooth above, which is tooth 0 in
  // the mirror image.
  return turned(mirrored(turned(axis + turned(p, psi), -gear_turn)), half_pitch);
}

TEST(PinionMotion, centrodes_touch) {
  const PinionMotion external{8, 24, 48.0}, ring{10, -40, 31.0};
  EXPECT_EQ(external.cutter_pitch_radius(), 12.0);
  EXPECT_EQ(external.pitch_radius(), 36.0);
  EXPECT_NEAR(ring.cutter_pitch_radius() + 31.0, -ring.pitch_radius(), 1e-14);
  EXPECT_NEAR(-ring.pitch_radius() / ring.cutter_pitch_radius(), 4.0, 1e-15);
}

TEST(PinionEnvelope, points_are_cut_when_the_normal_meets_the_pitch_point) {
  int points = 0;
  for (const Meeting meeting : {Meeting::ahead, Meeting::behind}) {
    for (const CutterPiece& piece : pieces(meeting)) {
      const PinionEnvelope envelope = piece.envelope();
      for (const double u : kParts) {
        const double t = piece.at(u);
        if (!reaches(piece, t)) continue;
        ++points;
        const Vec2 p = envelope.point(t);
        EXPECT_LE((p - rolled(piece, t)).norm(), 1e-13 * (p.norm() + piece.motion.distance))
            << piece.motion.cutter_teeth << ":" << piece.motion.teeth << " " << u;
        const double turns = envelope.polar_angle(t) - std::atan2(p.y(), p.x());
        EXPECT_NEAR(std::remainder(turns, 2 * kPi), 0.0, 1e-14);
      }
    }
  }
  EXPECT_GT(points, 180);
}

// The polar angle is continuous along a piece, although ν exceeds π on a cutter with one tooth.
TEST(PinionEnvelope, polar_angle_does_not_jump) {
  for (const Meeting meeting : {Meeting::ahead, Meeting::behind}) {
    for (const CutterPiece& piece : pieces(meeting)) {
      // These points lie far outside the gear and are never cut.
      if (meeting == Meeting::behind && piece.motion.teeth > 0) continue;
      const PinionEnvelope envelope = piece.envelope();
      const double pitch = 2 * kPi / std::abs(piece.motion.teeth);
      double before = std::numeric_limits<double>::quiet_NaN();
      for (int i = 0; i <= 2000; ++i) {  // to the end on the line of centres, where s = 0
        const double t = i == 2000 ? piece.tip : piece.at(i / 2000.0);
        if (!reaches(piece, t)) continue;
        const double here = envelope.polar_angle(t);
        EXPECT_FALSE(std::abs(here - before) > 0.1 * pitch)
            << piece.motion.cutter_teeth << ":" << piece.motion.teeth << " " << i;
        before = here;
      }
    }
  }
}

// dW/dσ = i G e^{i(κ−mϑ)} is zero at a cusp, where tangent and curvature are undefined.
bool near_cusp(const CutterPiece& piece, double t) {
  const PinionEnvelope envelope = piece.envelope();
  const double h = 1e-5;
  const double gear = (envelope.point(t + h) - envelope.point(t - h)).norm() / (2 * h);
  return gear < 0.05;
}

// The central differences use the step 1e-4. Their error and the rounding error, 1e-12 mm/h², stay
// below 1e-5 of the values if the curve is not near a cusp.
TEST(PinionEnvelope, tangent_and_curvature) {
  int places = 0;
  for (const Meeting meeting : {Meeting::ahead, Meeting::behind}) {
    for (const CutterPiece& piece : pieces(meeting)) {
      const PinionEnvelope envelope = piece.envelope();
      for (const double u : kParts) {
        const double t = piece.at(u), h = 1e-4;
        if (!reaches(piece, t + h) || !reaches(piece, t - h) || near_cusp(piece, t)) continue;
        ++places;
        const Vec2 before = envelope.point(t - h), here = envelope.point(t),
                   after = envelope.point(t + h);
        const Vec2 d = (after - before) / (2 * h), dd = (after - 2 * here + before) / (h * h);
        const CurvePoint p = envelope.at(t);
        EXPECT_EQ(p.point, here);
        const double turn = std::atan2(d.y(), d.x()) - p.tangent_angle;
        EXPECT_NEAR(std::remainder(turn, 2 * kPi), 0.0, 1e-4)
            << piece.motion.cutter_teeth << ":" << piece.motion.teeth << " " << u;
        const double curvature = (d.x() * dd.y() - d.y() * dd.x()) / std::pow(d.norm(), 3);
        EXPECT_NEAR(p.curvature, curvature, 1e-3 * (1 + std::abs(curvature)))
            << piece.motion.cutter_teeth << ":" << piece.motion.teeth << " " << u;
      }
    }
  }
  EXPECT_GT(places, 120);
}

// Law (2), d|W|²/dσ = −2 (r_g/r_p) s G, tested on all curves except corners.
TEST(PinionEnvelope, radius_law) {
  for (const Meeting meeting : {Meeting::ahead, Meeting::behind}) {
    for (const CutterPiece& piece : pieces(meeting)) {
      if (curve_if<CornerFan>(*piece.curve)) continue;
      const PinionEnvelope envelope = piece.envelope();
      const double direction = piece.tip > piece.root ? 1.0 : -1.0;
      for (const double u : kParts) {
        const double t = piece.at(u), h = 1e-5;
        if (!reaches(piece, t + h) || !reaches(piece, t - h)) continue;
        const double slope =
            direction * (envelope.point(t + h).squaredNorm() - envelope.point(t - h).squaredNorm());
        const double sigma = (piece.curve->point(t + h) - piece.curve->point(t - h)).norm();
        const Vec2 p = piece.curve->point(t);
        const double r_p = piece.motion.cutter_pitch_radius();
        const double s = p.dot(piece.tangent(t)), q = p.dot(normal_of(piece, t));
        const double w = (meeting == Meeting::ahead ? 1 : -1) * std::sqrt(r_p * r_p - s * s);
        const double lambda = w - q, k = direction * piece.curve->at(t).curvature;
        const double g = 1 + (1 + piece.motion.ratio()) * lambda * (1 - k * lambda) / w;
        const double law = -2 * piece.motion.pitch_radius() / r_p * s * g;
        EXPECT_NEAR(slope / sigma, law, 1e-5 * (piece.motion.distance + std::abs(law)))
            << piece.motion.cutter_teeth << ":" << piece.motion.teeth << " " << u;
      }
    }
  }
}

// The general formulas and the closed form give the same points, tangents and curvatures for the
// cutter's involute. On an internal gear, the roll angle is negative.
TEST(PinionInvolute, is_what_the_envelope_says) {
  for (const PinionMotion& motion : {PinionMotion{20, 45, 65.0}, PinionMotion{20, -60, 40.3},
                                     PinionMotion{2, 60, 61.335}, PinionMotion{1, 30, 54.05}}) {
    const double r_b = 0.93 * motion.cutter_pitch_radius();
    const auto cutter = std::make_shared<Involute>(r_b, 1.8 / motion.cutter_teeth);
    const auto cut = pinion_involute(motion, *cutter);
    ASSERT_TRUE(cut);
    EXPECT_NEAR(cut->flank.base_radius(), r_b * std::abs(motion.teeth) / motion.cutter_teeth,
                1e-13 * cut->flank.base_radius());
    const PinionEnvelope envelope(motion, cutter, Walk::forward);
    for (const double xi_0 : {0.01, 0.1, 0.3, 0.38, 0.8}) {
      const double xi = cut->roll(xi_0);
      const Vec2 p = envelope.point(xi_0);
      EXPECT_LE((cut->flank.point(xi) - p).norm(), 1e-13 * p.norm()) << xi_0;
      EXPECT_NEAR(cut->flank.polar_angle(xi), envelope.polar_angle(xi_0), 1e-13) << xi_0;
      if (motion.teeth > 0 && xi < 0.0) continue;  // behind the cusp
      EXPECT_EQ(envelope.cuts(xi_0), true) << xi_0;
      const CurvePoint a = cut->flank.at(xi), b = envelope.at(xi_0);
      // ξ decreases with ξ_0.
      EXPECT_NEAR(std::remainder(a.tangent_angle + kPi - b.tangent_angle, 2 * kPi), 0.0, 1e-13);
      EXPECT_NEAR(-a.curvature, b.curvature, 1e-11 * std::abs(a.curvature)) << xi_0;
    }
  }
}

// With Meeting::behind, pinion_involute() gives the curve that PinionEnvelope computes point by
// point.
TEST(PinionInvolute, behind_is_what_the_envelope_says) {
  for (const PinionMotion& motion :
       {PinionMotion{20, -60, 40.3}, PinionMotion{20, -26, 6.1}, PinionMotion{5, -9, 4.2}}) {
    const double r_b = 0.93 * motion.cutter_pitch_radius();
    const auto cutter = std::make_shared<Involute>(r_b, 1.8 / motion.cutter_teeth);
    const auto cut = pinion_involute(motion, *cutter, Meeting::behind);
    ASSERT_TRUE(cut);
    const PinionEnvelope envelope(motion, cutter, Walk::forward, Meeting::behind);
    for (const double xi_0 : {0.01, 0.1, 0.3, 0.38, 0.8}) {
      const double xi = cut->roll(xi_0);
      const Vec2 p = envelope.point(xi_0);
      EXPECT_LE((cut->flank.point(xi) - p).norm(), 1e-13 * (p.norm() + r_b)) << xi_0;
      EXPECT_NEAR(cut->flank.polar_angle(xi), envelope.polar_angle(xi_0), 1e-13) << xi_0;
    }
  }
}

// Cutter and gear touch on the line of action. Its length is the sum of the two roll lengths, or
// their difference on an internal gear. The base tangent points are (1 + m) r_b tan α_w apart.
TEST(PinionInvolute, rolls_add_up_to_the_line_of_action) {
  const PinionMotion external{20, 45, 65.0}, ring{20, -60, 40.3};
  for (const PinionMotion& motion : {external, ring}) {
    const double r_b = 18.794;
    const auto cut = pinion_involute(motion, Involute(r_b, 0.0934));
    ASSERT_TRUE(cut);
    const double r_b2 = cut->flank.base_radius();
    const double sum = motion.side() * r_b2 + r_b;
    const double line = std::sqrt((motion.distance - sum) * (motion.distance + sum));
    for (const double xi_0 : {0.0, 0.2, 0.5})
      EXPECT_NEAR(r_b * xi_0 + r_b2 * cut->roll(xi_0), motion.side() * line, 1e-12);
  }
}

TEST(PinionInvolute, is_nothing_inside_the_base_circle) {
  const PinionMotion motion{20, 45, 65.0};
  const double r_p = motion.cutter_pitch_radius();
  EXPECT_TRUE(pinion_involute(motion, Involute(r_p * (1 - 1e-12), 0.1)));
  EXPECT_FALSE(pinion_involute(motion, Involute(r_p, 0.1)));
  EXPECT_FALSE(pinion_involute(motion, Involute(r_p * (1 + 1e-12), 0.1)));
}

}  // namespace
}  // namespace gearwright
