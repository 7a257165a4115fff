// Compares the point cloud with the case file, the five equations, the touching screws and closed
// formulas. These methods share only the flanks with it.
#include "tests/oracle/point_cloud.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/oracle/circular_arc_cases.hpp"
#include "tests/oracle/five_equation.hpp"
#include "tests/oracle/numbers.hpp"
#include "tests/oracle/touching_screws.hpp"

namespace gearwright::oracle::tca {
namespace {

using nlohmann::json;

#define EXPECT_CLOSE(value, wanted, tolerance) \
  EXPECT_NEAR(static_cast<double>((value) - (wanted)), 0.0, tolerance)

/// The flanks of `composite_te` with the limits of the case file: on gear 1 the face width and
/// 0.012 ≤ ρ − r_1 ≤ 0.45 in, on gear 2 only the ends of the arc.
CloudPair composite_cloud(const ArcPair& p) {
  constexpr Real kNoFace = 100;  // in
  CloudPair out;
  out.flank_1 = cloud_flank(flank_1(p), p.f.theta_low, p.f.theta_high, p.lead_1, p.half_face_1);
  out.flank_1.rho_low = p.pitch_radius_1 + 0.012L, out.flank_1.rho_high = p.pitch_radius_1 + 0.45L;
  out.flank_2 = cloud_flank(flank_2(p), p.p.theta_low, p.p.theta_high, p.lead_2, kNoFace);
  out.teeth_1 = p.teeth_1, out.teeth_2 = p.teeth_2;
  out.mounting = p.mounting;
  return out;
}

void composite_rows(int every) {
  int rows = 0, edges = 0;
  for (const json& composite : circular_arc_file().at("composite_te")) {
    const ArcPair pair = composite_pair(composite);
    const CloudPair cloud = composite_cloud(pair);
    const ArcOutline outline(flank_1(pair), pair.f.theta_low, pair.f.theta_high);
    for (std::size_t i = 0; i < composite.at("rows").size(); i += every) {
      const json& row = composite.at("rows").at(i);
      const Real rotation_1 = number(row, "phi1p_deg") * kLongDegree;
      SCOPED_TRACE(static_cast<double>(rotation_1 / kLongDegree));
      const auto t = cloud_touch(cloud, rotation_1);
      ASSERT_TRUE(t.has_value());
      ++rows;
      EXPECT_EQ(t->pair, row.at("pair_edges").get<int>());
      // The search of the file is accurate to 5e-10 arcsec, which is 2.4e-15 rad, and to 3e-6 in.
      EXPECT_CLOSE(t->rotation_2 - rotation_1 * pair.teeth_1 / pair.teeth_2,
                   number(row, "te_with_edges_arcsec") * kArcsec, 3e-15);
      EXPECT_CLOSE(t->rho_1 - pair.pitch_radius_1, number(row, "x_contact"), 1e-6);
      EXPECT_CLOSE(t->z_1, number(row, "z1_contact"), 3e-6);
      if (row.at("kind") == "face edge") {
        ++edges;
        // At the edge's end, ρ is the lower border of the file, and the edge ends in a corner of
        // face and border.
        const bool corner = t->rho_1 - pair.pitch_radius_1 < 0.0121L;
        EXPECT_EQ(t->kind, corner ? CloudKind::corner : CloudKind::face_1);
      } else {
        EXPECT_EQ(t->kind, CloudKind::interior);
        const auto five = carrying_arc_touch(pair, rotation_1, 3);
        ASSERT_TRUE(five.has_value());
        EXPECT_EQ(five->pair, t->pair);
        EXPECT_CLOSE(five->touch.at.rotation_2, t->rotation_2, 1e-17);
        EXPECT_CLOSE(five->touch.at.s_1, outline.theta(t->rho_1), 1e-7);
        EXPECT_CLOSE(five->touch.at.z_1, t->z_1, 1e-7);
      }
    }
  }
  EXPECT_EQ(rows, 2 * ((25 + every - 1) / every));
  EXPECT_GT(edges, 0);
}

TEST(PointCloud, CompositeOfTheFile) { composite_rows(5); }
TEST(LongPointCloud, CompositeOfTheFileWhole) { composite_rows(1); }

// Compares the five equations and the cloud under errors of every kind, including lead errors and
// crowned leads.
TEST(PointCloud, ArcsUnderEveryError) {
  for (const json& c : circular_arc_file().at("cases")) {
    const std::string name = c.at("name");
    if (name.rfind("m", 0) != 0) continue;
    SCOPED_TRACE(name);
    ArcPair pair = arc_pair(c);
    const Real module = 2 * pair.pitch_radius_1 * std::sin(pair.lead_angle_f) / pair.teeth_1;
    pair.lead_1.crowning = 2e-7L / module, pair.lead_2.crowning = -1e-8L / module;
    pair.f.theta_low = 12 * kLongDegree, pair.f.theta_high = 50 * kLongDegree;
    pair.p.theta_low = 13 * kLongDegree, pair.p.theta_high = 52 * kLongDegree;
    pair.half_face_1 = pair.half_face_2 = 12 * module;
    CloudPair cloud = composite_cloud(pair);
    cloud.flank_1 = cloud_flank(flank_1(pair), pair.f.theta_low, pair.f.theta_high, pair.lead_1,
                                pair.half_face_1);
    cloud.flank_2.z_low = -pair.half_face_2, cloud.flank_2.z_high = pair.half_face_2;
    const Real rotation_1 = 0.03L;
    const FiveEquationTouch five = arc_touch(pair, rotation_1);
    ASSERT_TRUE(five.holds());
    const auto t = cloud_touch_of_pair(cloud, rotation_1, 0);
    ASSERT_TRUE(t.has_value());
    EXPECT_EQ(t->kind, CloudKind::interior);
    EXPECT_CLOSE(t->rotation_2, five.at.rotation_2, 1e-17);
    EXPECT_CLOSE((t->point_f - five.point_f).norm() / pair.f.rho, 0, 1e-6);
  }
}

/// A pair of involute screws in both notations.
struct Screws {
  ScrewPair pair;
  CloudPair cloud;
  std::array<InvoluteFlank, 2> flanks;
};

/// Reference gears of one normal module and 20°, mounted tight at Σ = β_1 + β_2, tooth 0 and space
/// 0 on the centre line.
Screws screws(int z_1, int z_2, double beta_1, double beta_2, double half_face) {
  Screws out;
  const double module = 3, alpha_n = static_cast<double>(20 * kLongDegree);
  const std::array<int, 2> teeth = {z_1, z_2};
  const std::array<double, 2> beta = {beta_1, beta_2};
  std::array<Screw*, 2> screw = {&out.pair.first, &out.pair.second};
  std::array<CloudFlank*, 2> cloud = {&out.cloud.flank_1, &out.cloud.flank_2};
  double distance = 0;
  for (int i = 0; i < 2; ++i) {
    const double r = teeth[i] * module / (2 * std::cos(beta[i]));
    const double alpha_t = std::atan(std::tan(alpha_n) / std::cos(beta[i]));
    const double r_b = r * std::cos(alpha_t);
    const double eta = std::numbers::pi / (2 * teeth[i]) + std::tan(alpha_t) - alpha_t;
    const double beta_b = std::asin(std::sin(beta[i]) * std::cos(alpha_n));
    *screw[i] = {teeth[i], r_b, 2 * eta * r_b, beta_b, r + module};
    const Real tau = std::tan(static_cast<Real>(beta_b)) / r_b;
    const Real center = i == 0 ? 0 : kLongPi + kLongPi / teeth[i];
    out.flanks[i] = {i + 1, r_b, eta, center, tau, -1};
    *cloud[i] = cloud_flank(out.flanks[i], r_b * (1 + 1e-9L), r + module, {}, half_face);
    distance += r;
  }
  out.pair.center_distance = distance, out.pair.shaft_angle = beta_1 + beta_2;
  out.pair.half_face = half_face;
  out.cloud.flank_2.z_low = -1000, out.cloud.flank_2.z_high = 1000;
  out.cloud.teeth_1 = z_1, out.cloud.teeth_2 = z_2;
  out.cloud.mounting.center_distance = distance;
  out.cloud.mounting.shaft_angle = out.pair.shaft_angle;
  return out;
}

Real roll(const InvoluteFlank& f, Real rho) {
  return std::sqrt((rho - f.base_radius) * (rho + f.base_radius)) / f.base_radius;
}

/// The five equations of tooth pair 0 with the given lead errors, started from the position that
/// the cloud found.
FiveEquationTouch five_equations(const Screws& s, std::array<LeadTurn, 2> lead, const Mounting& m,
                                 Real rotation_1, const CloudTouch& near) {
  FlankPair p;
  p.flank_1 = turned(involute_surface(s.flanks[0]), lead[0]);
  p.flank_2 = turned(involute_surface(s.flanks[1]), lead[1]);
  p.mounting = m;
  p.ratio = static_cast<Real>(s.cloud.teeth_1) / s.cloud.teeth_2;
  p.scale = s.flanks[0].base_radius;
  const Real back = 2 * kLongPi * near.pair;
  const Unknowns start{roll(s.flanks[0], near.rho_1), near.z_1, roll(s.flanks[1], near.rho_2),
                       near.z_2, near.rotation_2 - back / s.cloud.teeth_2};
  return solve(p, rotation_1 - back / s.cloud.teeth_1, start);
}

// Crossed involutes without errors transmit motion exactly at any centre distance. The five
// equations and the cloud confirm this wherever a point inside both flanks carries the load.
TEST(PointCloud, CrossedInvolutesTransmitExactly) {
  const Screws s = screws(14, 23, 0.7, 0.5, 20);
  for (const Real wider : {0.0L, 0.3L}) {
    CloudPair cloud = s.cloud;
    cloud.mounting.d_center = wider;
    Real constant = 0;
    int inside = 0;
    for (int i = -3; i <= 3; ++i) {
      const Real rotation_1 = i * 2 * kLongPi / 14 / 7;
      const auto t = cloud_touch(cloud, rotation_1);
      ASSERT_TRUE(t.has_value());
      if (t->kind != CloudKind::interior) continue;
      const FiveEquationTouch five = five_equations(s, {}, cloud.mounting, rotation_1, *t);
      ASSERT_TRUE(five.solved);
      EXPECT_TRUE(five.opens);
      EXPECT_CLOSE((five.point_f - t->point_f).norm(), 0, 1e-6);
      const Real error = t->rotation_2 - rotation_1 * 14 / 23;
      EXPECT_CLOSE(error, five.transmission_error, 1e-17);
      if (inside++ == 0) constant = error;
      EXPECT_CLOSE(error, constant, 1e-16);  // the base pitches have the rounding errors of doubles
    }
    EXPECT_GE(inside, 5);
    // Gears without backlash have no transmission error. Their data are doubles, and the flanks
    // have the resulting thickness.
    if (wider == 0)
      EXPECT_CLOSE(constant, 0, 1e-15);
    else
      EXPECT_LT(constant, -1e-4L);
  }
}

// All errors at once, with crowned leads, for small shaft angles and for a right angle.
TEST(PointCloud, CrossedInvolutesUnderErrors) {
  for (const auto& [beta_1, beta_2] : {std::pair{0.9, 0.67}, {0.4, -0.3}, {0.35, 0.25}}) {
    SCOPED_TRACE(beta_1 + beta_2);
    const Screws s = screws(17, 29, beta_1, beta_2, 20);
    const std::array<LeadTurn, 2> lead = {{{3e-5L, 2e-6L}, {-1e-5L, 1e-6L}}};
    CloudPair cloud = s.cloud;
    for (int i = 0; i < 2; ++i) {
      CloudFlank& f = i == 0 ? cloud.flank_1 : cloud.flank_2;
      f = cloud_flank(s.flanks[i], f.rho_low, f.rho_high, lead[i], 20);
    }
    Mounting& m = cloud.mounting;
    m.d_center = 0.05L, m.crossing = 1e-3L, m.intersecting = -7e-4L, m.axial = 0.2L;
    int inside = 0;
    for (const Real rotation_1 : {-0.09L, 0.0L, 0.11L}) {
      const auto t = cloud_touch(cloud, rotation_1);
      ASSERT_TRUE(t.has_value());
      if (t->kind != CloudKind::interior) continue;
      ++inside;
      const FiveEquationTouch five = five_equations(s, lead, m, rotation_1, *t);
      ASSERT_TRUE(five.solved);
      EXPECT_TRUE(five.opens);
      EXPECT_CLOSE(five.transmission_error + rotation_1 * 17 / 29, t->rotation_2, 1e-17);
      EXPECT_CLOSE((five.point_f - t->point_f).norm(), 0, 1e-6);
    }
    EXPECT_GE(inside, 2);
  }
}

// Parallel helical gears with crowned leads touch in a point, too, and the tilt moves this point.
TEST(PointCloud, CrownedParallelInvolutes) {
  const Screws s = screws(17, 29, 0.3, -0.3, 15);
  const std::array<LeadTurn, 2> lead = {{{0, 5e-6L}, {}}};
  CloudPair cloud = s.cloud;
  cloud.flank_1 =
      cloud_flank(s.flanks[0], cloud.flank_1.rho_low, cloud.flank_1.rho_high, lead[0], 15);
  for (const Real crossing : {0.0L, 5e-5L}) {
    cloud.mounting.crossing = crossing;
    const auto t = cloud_touch(cloud, 0.02L);
    ASSERT_TRUE(t.has_value());
    ASSERT_EQ(t->kind, CloudKind::interior);
    const FiveEquationTouch five = five_equations(s, lead, cloud.mounting, 0.02L, *t);
    ASSERT_TRUE(five.solved);
    EXPECT_TRUE(five.opens);
    EXPECT_CLOSE(five.transmission_error + 0.02L * 17 / 29, t->rotation_2, 1e-17);
    EXPECT_CLOSE((five.point_f - t->point_f).norm(), 0, 1e-6);
  }
}

// The touching screws find contacts at tips and faces by another method. They must give the same
// rotation, tooth and kind of contact. On narrow gears, the edges at the faces carry the load over
// a part of the pitch.
TEST(PointCloud, EdgesOfTouchingScrews) {
  int tips = 0, faces = 0, insides = 0;
  for (const double half_face : {1.0, 20.0}) {
    const Screws s = screws(9, 14, 0.75, 0.55, half_face);
    for (int i = 0; i < 9; ++i) {
      const double rotation_1 = (i + 0.3) * 2 * std::numbers::pi / 9 / 9;
      SCOPED_TRACE(rotation_1);
      for (const int k : {-1, 0, 1}) {
        const auto wanted = touch_of_tooth(s.pair, rotation_1, Side::leading, k);
        const auto t = cloud_touch_of_pair(s.cloud, rotation_1, k);
        ASSERT_EQ(t.has_value(), wanted.has_value());
        if (!t || wanted->where == Where::base_1 || wanted->where == Where::base_2) continue;
        ASSERT_NE(wanted->where, Where::unsettled);
        EXPECT_CLOSE(t->rotation_2, wanted->rotation_2, 1e-13);
        if (wanted->margin < 1e-5 && wanted->where == Where::flanks) continue;
        const auto is = [&](Where where, CloudKind kind, int& count) {
          // The touching screws name only one of the two edges that meet in a corner.
          if (wanted->where != where) return;
          EXPECT_TRUE(t->kind == kind || t->kind == CloudKind::corner) << where;
          count += t->kind == kind;
        };
        is(Where::flanks, CloudKind::interior, insides);
        is(Where::tip_1, CloudKind::tip_1, tips);
        is(Where::tip_2, CloudKind::tip_2, tips);
        is(Where::face_1, CloudKind::face_1, faces);
      }
    }
  }
  EXPECT_GE(insides, 5);
  EXPECT_GE(tips, 5);
  EXPECT_GE(faces, 5);
}

// Spur gears crossed by Δγ touch with a face end. To first order, TE = Δγ b/(2 r_2), with b the
// narrower face. If gear 2 is narrower, its edge touches, which is a curve across flank 1. If the
// axes are tilted by Δδ instead, TE = Δδ b tan α/(2 r_2).
TEST(PointCloud, MisalignedSpurGearsTouchWithAFaceEnd) {
  const Screws s = screws(20, 37, 0, 0, 10);
  const Real r_2 = 37 * 3 / 2.0L, b = 16, small = 1e-5L;
  CloudPair cloud = s.cloud;
  for (const bool first_narrow : {true, false}) {
    CloudFlank& narrow = first_narrow ? cloud.flank_1 : cloud.flank_2;
    CloudFlank& wide = first_narrow ? cloud.flank_2 : cloud.flank_1;
    narrow.z_low = -b / 2, narrow.z_high = b / 2;
    wide.z_low = -10, wide.z_high = 10;
    for (const int sign : {-1, 1}) {
      cloud.mounting.crossing = sign * small, cloud.mounting.intersecting = 0;
      const auto crossed_axes = cloud_touch(cloud, 0.01L);
      ASSERT_TRUE(crossed_axes.has_value());
      EXPECT_EQ(crossed_axes->kind, first_narrow ? CloudKind::face_1 : CloudKind::face_2);
      EXPECT_CLOSE(crossed_axes->z_1, sign * -b / 2, 1e-3);
      const Real error = crossed_axes->rotation_2 - 0.01L * 20 / 37;
      EXPECT_CLOSE(error / (small * b / 2 / r_2), 1, 1e-3);

      cloud.mounting.crossing = 0, cloud.mounting.intersecting = sign * small;
      const auto tilted_axes = cloud_touch(cloud, 0.01L);
      ASSERT_TRUE(tilted_axes.has_value());
      const Real tilt_error = tilted_axes->rotation_2 - 0.01L * 20 / 37;
      EXPECT_CLOSE(tilt_error / (small * b / 2 / r_2 * std::tan(20 * kLongDegree)), 1, 2e-3);
    }
  }
}

TEST(PointCloud, NothingWhereNoToothReaches) {
  CloudPair cloud = screws(9, 14, 0.75, 0.55, 5).cloud;
  cloud.mounting.d_center = 10;
  EXPECT_FALSE(cloud_touch(cloud, 0.1L).has_value());
}

TEST(ArcOutline, IsTheSurfacesSection) {
  for (const int gear : {1, 2}) {
    const ArcFlank flank{gear, 7 + 0.75L * (gear - 1), 2.11L, 1.2L, 70 * kLongDegree, 53, false};
    const ArcOutline outline(flank, 12 * kLongDegree, 50 * kLongDegree);
    for (int i = 0; i <= 10; ++i) {
      const Real theta = (12 + 3.8L * i) * kLongDegree;
      const Vector3 r = arc_surface(flank)(theta, 0).r;
      const Real rho = std::hypot(r.x(), r.y());
      EXPECT_CLOSE(outline.theta(rho), theta, 1e-16);
      const Vector3 back = turn_about_z(outline(rho)) * Vector3(rho, 0, 0);
      EXPECT_CLOSE((back - r).norm(), 0, 1e-15);
    }
    EXPECT_THROW(outline.theta(outline.rho_high() + 0.1L), std::invalid_argument);
  }
  // Beyond the undercut limit, 7.08° here, the outline turns back.
  const ArcFlank undercut{
      1,    0.7L, 0.21121778264910707L, 0.12194664367009782L, 75 * kLongDegree, 3.1058285412302493L,
      false};
  EXPECT_THROW(ArcOutline(undercut, 1 * kLongDegree, 50 * kLongDegree), std::invalid_argument);
}

}  // namespace
}  // namespace gearwright::oracle::tca
