// Properties of a touch: kinds, lines, normals, curvatures.
#include "gearwright/contact/contact_point.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

ContactPoint at(const testing::SamplePair& p, double rotation) {
  ContactRequest request;
  request.rotations = {Angle::radians(rotation)};
  return analyse_contact(p.pair(), request).positions[0];
}

TEST(ContactPoint, a_spur_pair_touches_along_its_face) {
  const ContactPoint p = at(testing::involutes(20, 41, 0), 0.05);
  ASSERT_EQ(p.kind, TouchKind::line);
  ASSERT_TRUE(p.line);
  EXPECT_NEAR((*p.line)[0].z(), -9.0, 1e-9);  // the narrower face
  EXPECT_NEAR((*p.line)[1].z(), 9.0, 1e-9);
  EXPECT_NEAR(p.point.z(), 0.0, 1e-9);
  // The normal is along the path of contact, at α = 20° to the common tangent of the pitch circles.
  // It points from gear 1, which turns clockwise, to gear 2.
  const double alpha = 20 * std::numbers::pi / 180;
  EXPECT_LT((p.normal - Vec3(std::sin(alpha), -std::cos(alpha), 0)).norm(), 1e-12);
  // The relative curvature is 1/ρ1 + 1/ρ2 across the contact line and 0 along it.
  const double r_b1 = 20 * std::cos(alpha), r_b2 = 41 * std::cos(alpha);
  const double rho_1 = std::sqrt(std::pow(p.diameter[0] / 2, 2) - r_b1 * r_b1);
  const double rho_2 = std::sqrt(std::pow(p.diameter[1] / 2, 2) - r_b2 * r_b2);
  ASSERT_TRUE(p.gap_curvature && p.ellipse);
  EXPECT_EQ((*p.gap_curvature)[0], 0.0);
  EXPECT_NEAR((*p.gap_curvature)[1], 1 / rho_1 + 1 / rho_2, 1e-10);
  EXPECT_FALSE(p.ellipse->semi_major);
  EXPECT_NEAR(p.ellipse->semi_minor, std::sqrt(2 * 0.00635 * rho_1 * rho_2 / (rho_1 + rho_2)),
              1e-9);
  EXPECT_NEAR(p.ellipse->angle.rad(), 0.0, 1e-9);
}

TEST(ContactPoint, a_ring_pair) {
  const ContactPoint p = at(testing::involutes(20, -61, 0), 0.02);
  ASSERT_EQ(p.kind, TouchKind::line);
  EXPECT_LT(p.point.x(), 0.0);  // the mesh lies beyond axis 1
  const double alpha = 20 * std::numbers::pi / 180;
  const double r_b1 = 20 * std::cos(alpha), r_b2 = 61 * std::cos(alpha);
  const double rho_1 = std::sqrt(std::pow(p.diameter[0] / 2, 2) - r_b1 * r_b1);
  const double rho_2 = std::sqrt(std::pow(p.diameter[1] / 2, 2) - r_b2 * r_b2);
  EXPECT_NEAR((*p.gap_curvature)[1], 1 / rho_1 - 1 / rho_2, 1e-10);
  // A clockwise rotation moves a point on the −x axis towards +y.
  EXPECT_GT(p.normal.y(), 0.0);
  EXPECT_NEAR(std::abs(p.normal.y()), std::cos(alpha), 1e-12);
}

TEST(ContactPoint, kinds) {
  auto p = testing::involutes(20, 41, 0);
  p.place.errors.crossing = Angle::radians(1e-4);
  EXPECT_EQ(at(p, 0.05).kind, TouchKind::face2);
  std::swap(p.gears[0].spec.face_width, p.gears[1].spec.face_width);
  EXPECT_EQ(at(p, 0.05).kind, TouchKind::face1);
  // Helical gears with a large tilt touch at tip edges over a part of the pitch.
  auto h = testing::involutes(20, 41, 25);
  h.place.errors.crossing = Angle::radians(1e-3);
  int tips = 0;
  const auto curve = analyse_contact(h.pair(), {});
  for (const ContactPoint& q : curve.positions)
    tips += q.kind == TouchKind::tip1 || q.kind == TouchKind::tip2;
  EXPECT_GT(tips, 0);
  auto a = testing::arcs();
  const ContactPoint inside = at(a, 0.1);
  EXPECT_EQ(inside.kind, TouchKind::interior);
  EXPECT_FALSE(inside.line);
  ASSERT_TRUE(inside.ellipse && inside.ellipse->semi_major);
  EXPECT_GT(*inside.ellipse->semi_major, inside.ellipse->semi_minor);
  EXPECT_NEAR(inside.rack_angle->rad(), std::numbers::pi / 6, 0.01);
}

// The gears are so far apart that the path of contact is shorter than a pitch. Between the paths of
// two tooth pairs, a tip edge is in contact along the whole face. An edge has no curvature.
TEST(ContactPoint, a_tip_that_touches_along_its_edge_is_an_edge) {
  auto p = testing::involutes(20, 41, 0);
  p.place.errors.center_distance = 2.3;
  ContactRequest request;
  request.positions = 16;
  int lines = 0, tips = 0;
  for (const ContactPoint& q : analyse_contact(p.pair(), request).positions) {
    const bool at_tip_1 = std::abs(q.diameter[0] / 2 - p.gears[0].tip_form_radius()) < 1e-6;
    const bool at_tip_2 = std::abs(q.diameter[1] / 2 - p.gears[1].tip_form_radius()) < 1e-6;
    const TouchKind want = at_tip_1   ? TouchKind::tip1
                           : at_tip_2 ? TouchKind::tip2
                                      : TouchKind::line;
    EXPECT_EQ(q.kind, want);
    EXPECT_EQ(q.gap_curvature.has_value(), want == TouchKind::line);
    ++(want == TouchKind::line ? lines : tips);
  }
  EXPECT_GT(lines, 5);
  EXPECT_GT(tips, 2);
}

// Contact with less than a nanometre of crowning counts as a line, otherwise as a point.
TEST(ContactPoint, a_line_ends_at_a_nanometre) {
  auto p = testing::involutes(20, 41, 0);
  for (const double crowning : {0.5e-6, 3e-6}) {
    FlankModifications m;
    m.lead_crowning = crowning;
    p.modify(1, m);
    EXPECT_EQ(at(p, 0.05).kind, crowning < 1e-6 ? TouchKind::line : TouchKind::interior);
  }
}

// Crowning C_β over the face width b gives the gap a curvature of 8 C_β/b² along the tooth, from
// which the ellipse follows.
TEST(ContactPoint, curvature_of_crowning) {
  auto p = testing::involutes(20, 41, 0);
  FlankModifications m;
  m.lead_crowning = 0.012;
  p.modify(1, m);
  const ContactPoint q = at(p, 0.05);
  ASSERT_EQ(q.kind, TouchKind::interior);
  EXPECT_NEAR((*q.gap_curvature)[0], 8 * 0.012 / (20.0 * 20.0), 1e-9);
  EXPECT_NEAR(*q.ellipse->semi_major, std::sqrt(2 * 0.00635 * 400 / (8 * 0.012)), 1e-4);
}

}  // namespace
}  // namespace gearwright
