// Compares the contact room with independent computations. If the flanks touch inside, these are
// the case file and the five equations. If an edge touches, it is the point cloud. All are in long
// double and share no code with the room.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gearwright/contact/contact.hpp"
#include "tests/oracle/circular_arc_cases.hpp"
#include "tests/oracle/contact_gears.hpp"
#include "tests/oracle/modified_involutes.hpp"
#include "tests/oracle/point_cloud.hpp"
#include "tests/oracle/random_contacts.hpp"

namespace gearwright::oracle {
namespace {

using nlohmann::json;
using property::Random;

double number_of(const json& of, const char* key) { return of.at(key).get<double>(); }

/// All positions of `rotations`, each computed without a start value.
ContactResult at_rotations(const ContactPair& pair, const std::vector<double>& rotations,
                           double marking = 0.00635) {
  ContactRequest request;
  for (const double r : rotations) request.rotations.push_back(Angle::radians(r));
  request.marking = marking;
  return analyse_contact(pair, request);
}

tca::ArcPair with_ends(tca::ArcPair pair, tca::Real low, tca::Real high, tca::Real half_face) {
  pair.f.theta_low = pair.p.theta_low = low * kLongDegree;
  pair.f.theta_high = pair.p.theta_high = high * kLongDegree;
  pair.half_face_1 = pair.half_face_2 = half_face;
  return pair;
}

// Every printed number of the file is compared: rotations to 1e-12 rad; positions, curvatures and
// ellipses to a relative error of 1e-10. The file describes one tooth pair. The face width is
// therefore one pitch, so that no other pair touches.
TEST(ContactEngine, case_file) {
  int positions = 0;
  for (const json& c : tca::circular_arc_file().at("cases")) {
    SCOPED_TRACE(c.at("name").get<std::string>());
    tca::ArcPair pair = tca::arc_pair(c);
    const double size = static_cast<double>(pair.pitch_radius_1);
    const ContactSet set = contact_set(with_ends(pair, 7.2L, 62, 6 * pair.pitch_radius_1));
    const ContactPair contact = set.pair();
    GapField field = contact.field(contact.patches(1)[0], contact.patches(2)[0]);
    for (const json& t : c.at("tca")) {
      ++positions;
      field.set_rotation(number_of(t, "phi1p"));
      const gearwright::Touch touch =
          TouchSearch(field, contact.mesh_azimuth(), contact.reach()).cold();
      ASSERT_TRUE(touch.found());
      EXPECT_TRUE(touch.active.inside());
      EXPECT_NEAR(touch.te, number_of(t, "te_rad"), 1e-12);
      EXPECT_NEAR(touch.s / (number_of(t, "thF_deg") * std::numbers::pi / 180), 1.0, 1e-10);
      double s2 = touch.s2;
      const GapJet j = field.at(touch.s, touch.z, s2);
      s2 = contact.patches(2)[0].profile.s_of(j.u.v);
      EXPECT_NEAR(s2 / (number_of(t, "thP_deg") * std::numbers::pi / 180), 1.0, 1e-10);
      const Vec3 want = tca::vector(t, "point_f").cast<double>();
      EXPECT_LT((contact.in_housing(j.w1, touch.z) - want).norm(), 1e-10 * size);
    }
    // The contact room computes one of these positions, with the flank data at this point.
    const json& k = c.at("contact");
    const double rotation = number_of(k, "phi1p"), delta = number_of(k, "delta");
    Transmission transmission(contact);
    field.set_rotation(rotation);
    PairTouch alone{TouchSearch(field, 0.0, contact.reach()).cold(), 0, rotation, 0};
    const ContactPoint p = describe(transmission, alone, Angle::radians(rotation), delta);
    ASSERT_EQ(p.kind, TouchKind::interior);
    ASSERT_TRUE(p.gap_curvature && p.ellipse && p.ellipse->semi_major);
    for (int i : {0, 1})
      EXPECT_NEAR((*p.gap_curvature)[i] / k.at("relative_principal").at(i).get<double>(), 1.0,
                  1e-10);
    EXPECT_NEAR(*p.ellipse->semi_major / number_of(k, "semi_major"), 1.0, 1e-10);
    EXPECT_NEAR(p.ellipse->semi_minor / number_of(k, "semi_minor"), 1.0, 1e-10);
    EXPECT_NEAR(p.ellipse->angle.deg(), number_of(k, "major_angle_deg"), 1e-8);
    for (const json& t : c.at("tca")) {
      if (number_of(t, "phi1p") != rotation) continue;
      EXPECT_LT((p.normal - tca::vector(t, "normal_f").cast<double>()).norm(), 1e-10);
      EXPECT_NEAR(p.diameter[0] / (2 * number_of(t, "radius1")), 1.0, 1e-11);
      EXPECT_NEAR(p.diameter[1] / (2 * number_of(t, "radius2")), 1.0, 1e-11);
      EXPECT_NEAR(p.rack_angle->deg(), number_of(t, "thF_deg"), 1e-8);
    }
  }
  EXPECT_GE(positions, 50);
}

// Changing the lead angle afterwards is equivalent to cutting the gear with the changed lead angle.
TEST(ContactEngine, cutter_lead_is_another_rack) {
  int changed = 0;
  for (const json& c : tca::circular_arc_file().at("cases")) {
    const tca::ArcPair pair = with_ends(tca::arc_pair(c), 9, 58, 20);
    if (pair.lead_angle_f == pair.lead_angle_p) continue;
    SCOPED_TRACE(c.at("name").get<std::string>());
    ++changed;
    tca::ArcPair equal = pair;
    equal.lead_angle_f = pair.lead_angle_p;
    ContactSet as_error = contact_set(equal);
    as_error.mount.errors.cutter_lead[0] =
        Angle::radians(static_cast<double>(pair.lead_angle_f - pair.lead_angle_p));
    const std::vector<double> rotations{-0.2, 0.0, 0.13};
    const auto a = at_rotations(contact_set(pair).pair(), rotations);
    const auto b = at_rotations(as_error.pair(), rotations);
    for (std::size_t i = 0; i < rotations.size(); ++i) {
      EXPECT_EQ(a.positions[i].kind, b.positions[i].kind);
      EXPECT_NEAR(a.positions[i].te.rad(), b.positions[i].te.rad(), 1e-13);
      EXPECT_EQ(a.positions[i].pair, b.positions[i].pair);
    }
  }
  EXPECT_GE(changed, 1);
}

// The curves of the file that contain edges, to 1e-6 of their height. As in the file, flank 1 ends
// 0.012 in above the pitch circle.
TEST(ContactEngine, composite_curves_with_edges) {
  for (const json& composite : tca::circular_arc_file().at("composite_te")) {
    tca::ArcPair pair = tca::composite_pair(composite);
    pair.half_face_2 = 10;
    ContactSet set = contact_set(pair);
    Arc& arc = set.gears[0].tooth->outline.arcs[0];
    const double r_1 = static_cast<double>(pair.pitch_radius_1);
    const auto cut = [&](double rho) {
      return arc.curve->parameter_at_radius(rho, static_cast<double>(pair.f.theta_low),
                                            static_cast<double>(pair.f.theta_high));
    };
    arc = flank_arc(arc.curve, cut(r_1 + 0.012), cut(r_1 + 0.45));
    const ContactPair contact = set.pair();
    double least = 1e300, greatest = -1e300;
    std::vector<double> rotations;
    for (const json& row : composite.at("rows")) {
      const double te = number_of(row, "te_with_edges_arcsec");
      least = std::min(least, te), greatest = std::max(greatest, te);
      rotations.push_back(number_of(row, "phi1p_deg") * std::numbers::pi / 180);
    }
    const double second = static_cast<double>(tca::kArcsec);
    const double height = (greatest - least) * second;
    const auto r = at_rotations(contact, rotations);
    for (std::size_t i = 0; i < rotations.size(); ++i) {
      const json& row = composite.at("rows").at(i);
      SCOPED_TRACE(row.dump());
      const ContactPoint& p = r.positions[i];
      EXPECT_NEAR(p.te.rad(), number_of(row, "te_with_edges_arcsec") * second,
                  std::min(1e-6 * height, 1e-14));
      EXPECT_EQ(p.pair, row.at("pair_edges").get<int>());
      EXPECT_NEAR(p.diameter[0] / 2 - r_1, number_of(row, "x_contact"), 1e-6);
      EXPECT_NEAR(p.height[0], number_of(row, "z1_contact"), 3e-6);
      const bool corner = number_of(row, "x_contact") < 0.01201;
      EXPECT_EQ(p.kind, row.at("kind") != "face edge" ? TouchKind::interior
                        : corner                      ? TouchKind::corner
                                                      : TouchKind::face1);
    }
  }
}

// The compared quantities and the results.
struct ContactTally {
  int pairs = 0, inside = 0, edges = 0, clouds = 0;
  double worst_rotation = 0.0, worst_place = 0.0;
};

void report(const char* what, const ContactTally& t) {
  ::testing::Test::RecordProperty("positions_inside", t.inside);
  std::printf(
      "%s: %d pairs, %d positions inside (TE %.1e rad, place %.1e), %d at edges, %d clouds\n", what,
      t.pairs, t.inside, t.worst_rotation, t.worst_place, t.edges, t.clouds);
}

// No point of the cloud touches before `p`, and `p` is a point of both flanks. The cloud itself may
// find a later contact, because it misses features smaller than its steps and ends before a face
// that crosses flank 1.
void against_cloud(const tca::CloudPair& cloud, const BrutePair& brute, const ContactPoint& p) {
  const auto t = tca::cloud_touch(cloud, p.rotation1.rad());
  if (p.kind == TouchKind::none) {
    EXPECT_FALSE(t.has_value());
    return;
  }
  const auto seen =
      BruteContact(brute).look(p.rotation1.rad(), p.pair, p.diameter[0] / 2, p.height[0]);
  EXPECT_NEAR(seen.te, p.te.rad(), 1e-12);
  EXPECT_LT(seen.outside, 1e-9 * p.diameter[0]);
  if (!t) return;
  const tca::Real ratio = static_cast<tca::Real>(cloud.teeth_1) / cloud.teeth_2;
  EXPECT_LT(static_cast<double>(t->rotation_2 - ratio * p.rotation1.rad()), p.te.rad() + 1e-12);
}

// Circular arcs with all errors at once. If the room returns `interior`, the five equations must
// give the same contact from their own closed form. Otherwise no contact from the five equations
// may be greater, and the cloud must have the same edge.
ContactTally arcs(std::uint64_t seed, int pairs, int clouds) {
  ContactTally tally;
  Random random(seed);
  while (tally.pairs < pairs && !::testing::Test::HasFailure()) {
    const tca::ArcPair pair = random_arcs(random);
    ++tally.pairs;
    const ContactPair contact = contact_set(pair).pair();
    const double size = static_cast<double>(pair.f.rho);
    const std::vector<double> rotations{contact.pitch() * random.uniform(-0.5, 0.5),
                                        contact.pitch() * random.uniform(-0.5, 0.5)};
    const auto r = at_rotations(contact, rotations);
    EXPECT_EQ(r.unfinished, 0);
    for (const ContactPoint& p : r.positions) {
      SCOPED_TRACE(::testing::Message()
                   << "seed " << seed << " pair " << tally.pairs << " rotation "
                   << p.rotation1.rad() << " kind " << to_string(p.kind));
      const auto five = tca::carrying_arc_touch(pair, p.rotation1.rad(), 3);
      if (p.kind == TouchKind::interior) {
        ++tally.inside;
        EXPECT_TRUE(five.has_value());
        if (!five) continue;
        const double off =
            std::abs(p.te.rad() - static_cast<double>(five->touch.transmission_error));
        EXPECT_LT(off, 1e-12);
        tally.worst_rotation = std::max(tally.worst_rotation, off);
        if (five->pair != p.pair) continue;  // two pairs touch at the same rotation
        const double place = (p.point - five->touch.point_f.cast<double>()).norm() / size;
        const double axes_ratio = std::sqrt(static_cast<double>(five->touch.k_2 / five->touch.k_1));
        EXPECT_LT(place, 1e-11 * axes_ratio * axes_ratio);
        tally.worst_place = std::max(tally.worst_place, place);
        EXPECT_NEAR((*p.gap_curvature)[1] / static_cast<double>(five->touch.k_2), 1.0, 1e-9);
        continue;
      }
      if (p.kind != TouchKind::none && five) {
        EXPECT_GE(p.te.rad(), static_cast<double>(five->touch.transmission_error) - 1e-12);
      }
      ++tally.edges;
      if (tally.clouds >= clouds) continue;
      ++tally.clouds;
      tca::CloudPair cloud;
      cloud.flank_1 = cloud_flank(flank_1(pair), pair.f.theta_low, pair.f.theta_high, pair.lead_1,
                                  pair.half_face_1);
      cloud.flank_2 = cloud_flank(flank_2(pair), pair.p.theta_low, pair.p.theta_high, pair.lead_2,
                                  pair.half_face_2);
      cloud.teeth_1 = pair.teeth_1, cloud.teeth_2 = pair.teeth_2;
      cloud.mounting = pair.mounting;
      against_cloud(cloud, brute_arcs(pair), p);
    }
  }
  report("arcs", tally);
  return tally;
}

TEST(ContactEngine, arcs_against_five_equations) {
  const ContactTally t = arcs(1, 50, 4);
  EXPECT_GT(t.inside, 60);
  EXPECT_EQ(t.clouds, 4);
}
TEST(LongContactEngine, arcs_against_five_equations) {
  const ContactTally t = arcs(2, 400, 60);
  EXPECT_GT(t.inside, 400);
}

// Arcs with modified flanks, which the five equations do not support. No point of a dense grid on
// the flanks may touch before the contact of the room, and this contact must be a point of both
// flanks.
TEST(ContactEngine, modified_arcs_against_dense_places) {
  Random random(3);
  for (int i = 0; i < 6; ++i) {
    const tca::ArcPair pair = random_arcs(random);
    ContactSet set = contact_set(pair);
    BrutePair brute = brute_arcs(pair);
    for (int g : {0, 1}) {
      BruteGear& b = g == 0 ? brute.one : brute.two;
      const FlankExtent extent{0.0, b.rho_low, b.rho_high, set.gears[g].spec.face_width};
      const double depth = b.rho_high - b.rho_low;
      FlankModifications m;
      m.profile_crowning = depth * random.logarithmic(1e-5, 3e-3);
      m.lead_crowning = depth * random.logarithmic(1e-5, 1e-2);
      m.tip_relief = {depth * random.logarithmic(1e-5, 5e-3), 2 * (b.rho_low + 0.7 * depth),
                      ReliefShape::parabolic};
      set.removal[g] = std::make_shared<RemovalField>(m, extent);
      b.removed = removed_by(m, extent);
    }
    const ContactPair contact = set.pair();
    const BruteContact places(brute);
    const double size = static_cast<double>(pair.f.rho);
    for (const double rotation : {contact.pitch() * random.uniform(-0.5, 0.5)}) {
      const ContactPoint p = at_rotations(contact, {rotation}).positions[0];
      SCOPED_TRACE(::testing::Message() << "pair " << i << ' ' << to_string(p.kind));
      const auto t = places.touch(rotation, 2, 30, 24);
      ASSERT_EQ(t.has_value(), p.kind != TouchKind::none);
      if (!t) continue;
      const auto seen = places.look(rotation, p.pair, p.diameter[0] / 2, p.height[0]);
      EXPECT_NEAR(seen.te, p.te.rad(), 1e-12);
      EXPECT_LT(seen.outside, 1e-9 * size);
      EXPECT_LT(t->te, p.te.rad() + 1e-12);
    }
  }
}

// Involute screws under every error: crossed, worms, crowned, and crowned on parallel axes. The
// five equations start next to the contact of the room.
ContactTally screws(std::uint64_t seed, ScrewKind kind, int pairs, int clouds) {
  ContactTally tally;
  Random random(seed);
  while (tally.pairs < pairs && !::testing::Test::HasFailure()) {
    const ScrewContact s = random_screws(random, kind);
    ++tally.pairs;
    const ContactPair contact = s.set.pair();
    const std::vector<double> rotations{contact.pitch() * random.uniform(-0.5, 0.5),
                                        contact.pitch() * random.uniform(-0.5, 0.5)};
    const auto r = at_rotations(contact, rotations);
    EXPECT_EQ(r.unfinished, 0);
    for (const ContactPoint& p : r.positions) {
      SCOPED_TRACE(::testing::Message()
                   << "seed " << seed << " pair " << tally.pairs << " rotation "
                   << p.rotation1.rad() << " kind " << to_string(p.kind));
      if (p.kind == TouchKind::interior) {
        ++tally.inside;
        const auto five = five_equations(s, p);
        EXPECT_TRUE(five.solved);
        EXPECT_TRUE(five.opens);
        const double off = std::abs(p.te.rad() - static_cast<double>(five.transmission_error));
        EXPECT_LT(off, 1e-12);
        tally.worst_rotation = std::max(tally.worst_rotation, off);
        const double place = (p.point - five.point_f.cast<double>()).norm();
        // In a direction of low curvature, the error of the position is the rounding error of the
        // slope, κ ε L, divided by the curvature.
        const double soft = static_cast<double>(five.k_1) * s.size;
        EXPECT_LT(place, (1e-11 + 1e-14 / soft) * s.size);
        tally.worst_place = std::max(tally.worst_place, place / s.size);
        EXPECT_NEAR((*p.gap_curvature)[1] / static_cast<double>(five.k_2), 1.0, 1e-9);
      } else {
        ++tally.edges;
      }
      // The cloud checks a few contacts of both kinds, because even an inner contact may be a
      // lesser maximum.
      const bool looked =
          p.kind == TouchKind::interior ? tally.clouds % 2 == 0 : tally.clouds % 2 == 1;
      if (tally.clouds >= clouds || !looked) continue;
      ++tally.clouds;
      against_cloud(s.cloud, brute_screws(s), p);
    }
  }
  report("screws", tally);
  return tally;
}

TEST(ContactEngine, crossed_screws_against_five_equations) {
  EXPECT_GT(screws(11, ScrewKind::crossed, 60, 3).inside, 60);
}
TEST(ContactEngine, worms_against_five_equations) {
  EXPECT_GT(screws(12, ScrewKind::worm, 40, 1).inside, 20);
}
TEST(ContactEngine, crowned_parallel_screws_against_five_equations) {
  EXPECT_GT(screws(13, ScrewKind::crowned_parallel, 60, 3).inside, 30);
}
TEST(LongContactEngine, screws_against_five_equations) {
  EXPECT_GT(screws(14, ScrewKind::crossed, 300, 30).inside, 250);
  EXPECT_GT(screws(15, ScrewKind::worm, 150, 8).inside, 75);
  EXPECT_GT(screws(16, ScrewKind::crowned_parallel, 300, 30).inside, 150);
}

}  // namespace
}  // namespace gearwright::oracle
