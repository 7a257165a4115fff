// Tests the shortest chord with golden values, with a search that does not use the equation, with
// laws, and on gears.
#include "gearwright/inspection/chordal_thickness.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/testing/draw.hpp"
#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/gear/pinion_cut.hpp"
#include "gearwright/gear/testing/made.hpp"

namespace gearwright {
namespace {

using testing::kDegree;
using testing::made;

// These values were computed with 40 digits from the equations of the theory page and confirmed by
// a direct search. They cover worm threads, left hands, a spur gear and an internal gear.
struct Golden {
  const char* tooth;
  double psi_deg, diameter, theta_t, theta, chord, height, caliper_deg;
};
const Golden kGolden[] = {
    {"crossed 9, 51.6°, at d", 51.576509202864735, 43.44544689997543, 0.13788404781676722,
     0.0533160750150144, 3.7221882761818854, 0.030867235727118, 51.536834882484406},
    {"crossed 9, 51.6°, between", 52.58245501472798, 45.047723449987714, 0.11520053609566809,
     0.042564564322738016, 3.1529010238543025, 0.020400634339693587, 52.557396891486775},
    {"crossed 9, 51.6°, at the tip", 53.544260003360996, 46.65, 0.0906085350495124,
     0.03200579935074679, 2.5114725079152476, 0.011945709238703412, 53.530231302943776},
    {"crossed 15, 39.4°, at d", 39.376587488576405, 58.215284251077776, 0.11384506112065411,
     0.06810916886962325, 5.1206619999341285, 0.06748702751618513, 39.31138113613715},
    {"45°", 45.0, 56.568542494923804, 0.07853981633974483, 0.03929011949125462, 3.1411885675947953,
     0.02182859722620615, 44.97788224380482},
    {"left hand 45°", -45.0, 27.577164466275352, 0.14882819700469993, 0.07455206543520297,
     2.900806347524234, 0.03830079752762424, -44.92031360982091},
    {"left hand 15°", -15.0, 82.82209443280665, 0.03381035465587938, 0.03154689214440167,
     2.704409805302855, 0.020604560791506105, -14.992872712748648},
    {"two-thread worm at d", 80.0, 23.035081932574535, 0.7853981633974483, 0.023691249038247434,
     3.141583792583107, 0.003232104341831019, 79.99724964886828},
    {"two-thread worm at the tip", 81.4558782000464, 27.035081932574535, 0.4153638263136973,
     0.009168967798920444, 1.6683617079638835, 0.0005682056543487556, 81.45552433678817},
    {"its wheel", 10.0, 81.2341289508596, 0.04290961051253444, 0.04161717592957879,
     3.431807888454988, 0.035169084711904566, 9.99151585287921},
    {"helical 43", -25.414877484074257, 96.69050103077429, 0.026795155304877753,
     0.021861129125475814, 2.339953794976338, 0.011551854285675588, -25.409570300892437},
    {"spur 17", 0.0, 51.0, 0.10952779495340344, 0.10952779495340344, 5.574755814030794,
     0.15280046230979652, 0.0},
    {"internal gear 60", 0.0, 120.0, 0.02011376820881157, 0.02011376820881157, 2.4134894423511044,
     0.012136500972841042, 0.0},
    {"7 teeth", 15.0, 14.493866525741163, 0.20360117615548795, 0.19026787191090935,
     2.8344023289696807, 0.1307809847429546, 14.741193395081035},
};

// ψ and θ_t are given to ½ ulp, which is a relative error of about 1e-16. In k and Δh, this error
// is multiplied by at most dln Δh/dln ψ = 2 · 2 ψ/sin 2ψ = 17, at 81.5°. With the rounding errors
// of the functions, a tolerance of 2e-14 is sufficient.
TEST(ShortestChord, golden_values) {
  for (const Golden& g : kGolden) {
    const auto c = shortest_chord(
        ToothArc<double>{g.theta_t, g.psi_deg * kDegree, g.diameter / 2, g.diameter / 2 + 1});
    EXPECT_NEAR(c.half_angle_used, g.theta, 2e-14 * g.theta) << g.tooth;
    EXPECT_NEAR(c.chord, g.chord, 2e-14 * g.chord) << g.tooth;
    EXPECT_NEAR(c.height, g.height, 2e-14 * g.height) << g.tooth;
    EXPECT_NEAR(c.caliper_angle / kDegree, g.caliper_deg, 1e-13 * 90) << g.tooth;
    EXPECT_NEAR(c.tip_to_chord, 1 + g.height, 1e-14 * g.diameter) << g.tooth;
  }
}

// Two helices of the same hand and lead, 2θ_t apart. One point is fixed, and the other point moves
// along its helix by z. Only points in space and their distance are used.
struct TwoHelices {
  long double theta_t, tan_psi, r;
  struct Seen {
    long double distance, rise, slope;
  };
  Seen at(long double z) const {
    const long double a = theta_t + z * tan_psi / r;
    const long double b = -theta_t;
    const long double x1 = r * std::cos(a), y1 = r * std::sin(a);
    const long double x2 = r * std::cos(b), y2 = r * std::sin(b);
    const long double dx = x1 - x2, dy = y1 - y2;
    return {std::sqrt(dx * dx + dy * dy + z * z), r - std::hypot((x1 + x2) / 2, (y1 + y2) / 2),
            std::atan2(-z, std::hypot(dx, dy))};
  }
};

struct Found {
  long double z, distance;
};

// All minima of the distance in lo < z < hi, found on a dense grid and refined by golden section.
std::vector<Found> dips(const TwoHelices& h, long double lo, long double hi) {
  constexpr int kGrid = 4000;
  std::vector<long double> d(kGrid + 1);
  const auto z_of = [&](int i) { return lo + (hi - lo) * i / kGrid; };
  for (int i = 0; i <= kGrid; ++i) d[static_cast<std::size_t>(i)] = h.at(z_of(i)).distance;
  std::vector<Found> found;
  for (int i = 1; i < kGrid; ++i) {
    const auto u = static_cast<std::size_t>(i);
    if (!(d[u] < d[u - 1] && d[u] <= d[u + 1])) continue;
    const long double ratio = (std::sqrt(5.0L) - 1) / 2;
    long double a = z_of(i - 1), b = z_of(i + 1);
    for (int step = 0; step < 90; ++step) {
      const long double p = b - ratio * (b - a), q = a + ratio * (b - a);
      (h.at(p).distance < h.at(q).distance ? b : a) = h.at(p).distance < h.at(q).distance ? q : p;
    }
    found.push_back({(a + b) / 2, h.at((a + b) / 2).distance});
  }
  return found;
}

// Near its minimum the chord is nearly constant. Golden section finds k to 1e-17, but the position
// only to √1e-19 times the width of the valley. The tolerances are therefore 1e-8 for the height
// and 1e-7 for the angle.
void expect_same(const ChordalThickness<double>& c, const TwoHelices& h, const Found& best,
                 const std::string& what) {
  const auto r = static_cast<double>(h.r);
  EXPECT_NEAR(c.chord, static_cast<double>(best.distance), 1e-14 * r) << what;
  EXPECT_NEAR(c.height, static_cast<double>(h.at(best.z).rise), 1e-8 * r) << what;
  EXPECT_NEAR(c.caliper_angle, static_cast<double>(h.at(best.z).slope), 1e-7) << what;
}

TEST(ShortestChord, is_what_a_search_over_inclinations_finds) {
  testing::Draw random(20250201);
  int steep = 0, thick = 0;
  for (int i = 0; i < 200; ++i) {
    // Every third gear is a worm, whose thread takes nearly half of the circumference.
    const bool worm = i % 3 == 0;
    const double psi = (i % 2 == 0 ? 1 : -1) *
                       (worm ? random.uniform(50, 88.5) : random.uniform(0.5, 50)) * kDegree;
    const double theta_t = worm ? random.uniform(0.3, 1.55) : random.uniform(0.005, 0.6);
    const double r = std::exp(random.uniform(-2, 5));
    steep += std::abs(std::tan(psi)) > 1;
    thick += theta_t > 1;
    const TwoHelices h{theta_t, std::tan(static_cast<long double>(psi)), r};
    // The range extends from the axial chord past the transverse chord to the axial chord on the
    // other side.
    const long double reach = std::min(2 * h.theta_t * h.r / std::abs(h.tan_psi), 2.5L * h.r);
    const auto found = dips(h, -reach * 1.001L, reach * 1.001L);
    ASSERT_FALSE(found.empty());
    const Found best = *std::min_element(found.begin(), found.end(),
                                         [](auto& a, auto& b) { return a.distance < b.distance; });
    const auto c = shortest_chord(ToothArc<double>{theta_t, psi, r, r});
    expect_same(c, h, best, ::testing::PrintToString(std::pair{psi / kDegree, theta_t}));
  }
  EXPECT_GE(steep, 50);
  EXPECT_GE(thick, 20);
}

// If a tooth covers more than half of the circumference, it is the thread of a worm that is thicker
// than its space. The chord is the first minimum from the axial direction. If there is no minimum
// on the side of the tooth, θ* is greater than π/2.
TEST(ShortestChord, of_a_thread_over_half_the_circumference) {
  testing::Draw random(20250201);
  int on_the_tooth = 0, behind = 0;
  for (int i = 0; i < 200; ++i) {
    const double psi = random.uniform(1, 85) * kDegree;
    const double theta_t = random.uniform(1.58, 3.1);
    const TwoHelices h{theta_t, std::tan(static_cast<long double>(psi)), 1.0L};
    // z < 0 reaches from the axial chord (equal angles) to points that are half a turn apart.
    const long double axial = -2 * h.theta_t / h.tan_psi;
    const long double half_turn = (kPi - 2 * h.theta_t) / h.tan_psi;
    const auto found = dips(h, axial, half_turn);
    const auto c = shortest_chord(ToothArc<double>{theta_t, psi, 1.0, 1.0});
    const std::string what = ::testing::PrintToString(std::pair{psi / kDegree, theta_t});
    if (c.half_angle_used > kPi / 2) {
      EXPECT_TRUE(found.empty()) << what;
      EXPECT_LT(c.half_angle_used, kPi) << what;
      ++behind;
    } else {
      ASSERT_EQ(found.size(), 1u) << what;
      expect_same(c, h, found.front(), what);
      ++on_the_tooth;
    }
  }
  EXPECT_GE(on_the_tooth, 50);
  EXPECT_GE(behind, 50);
}

// Up to half of the circumference, T sin 2θ + 2θ = 2θ_t has one root in (0, θ_t) for every T.
TEST(ShortestChord, equation_has_one_root_on_the_tooth) {
  testing::Draw random(20250201);
  for (int i = 0; i < 200; ++i) {
    const double T = std::exp(random.uniform(-6, 9));
    const double theta_t = random.uniform(0.01, kPi / 2 - 0.01);
    const auto f = [&](double x) { return T * std::sin(2 * x) + 2 * (x - theta_t); };
    int changes = 0;
    for (int k = 0; k < 20000; ++k)
      changes += std::signbit(f(theta_t * k / 20000)) != std::signbit(f(theta_t * (k + 1) / 20000));
    EXPECT_EQ(changes, 1) << T << " " << theta_t;
    const double root = shortest_chord_half_angle(theta_t, T);
    EXPECT_NEAR(f(root), 0.0, 8 * std::numeric_limits<double>::epsilon() * (theta_t + root));
  }
}

// (1) the hand of the helix changes the sign of the calliper angle and nothing else
// (2) doubling all lengths doubles the results, exactly
// (3) the chord is shorter than the transverse chord and than the arc along the normal helix
TEST(ShortestChord, laws) {
  testing::Draw random(20250201);
  for (int i = 0; i < 500; ++i) {
    const ToothArc<double> arc{random.uniform(0.001, 1.5), random.uniform(0, 89) * kDegree,
                               random.uniform(1, 100), random.uniform(1, 120)};
    const auto c = shortest_chord(arc);
    auto mirrored = arc;
    mirrored.helix_angle = -arc.helix_angle;
    const auto m = shortest_chord(mirrored);
    EXPECT_EQ(m.chord, c.chord);  // (1)
    EXPECT_EQ(m.height, c.height);
    EXPECT_EQ(m.tip_to_chord, c.tip_to_chord);
    EXPECT_EQ(m.caliper_angle, -c.caliper_angle);
    auto doubled = arc;
    doubled.radius *= 2;
    doubled.tip_radius *= 2;
    const auto d = shortest_chord(doubled);
    EXPECT_EQ(d.chord, 2 * c.chord);  // (2)
    EXPECT_EQ(d.height, 2 * c.height);
    EXPECT_EQ(d.tip_to_chord, 2 * c.tip_to_chord);
    EXPECT_EQ(d.caliper_angle, c.caliper_angle);
    const double transverse = 2 * arc.radius * std::sin(arc.half_angle);
    const double arc_normal = 2 * arc.radius * arc.half_angle * std::cos(arc.helix_angle);
    EXPECT_LE(c.chord, transverse * (1 + 1e-15));  // (3)
    EXPECT_LE(c.chord, arc_normal * (1 + 1e-15));
  }
}

TEST(ShortestChord, of_a_spur_gear_is_the_transverse_one_exactly) {
  for (const double theta : {1e-9, 0.01, 0.2, 1.0, 1.57, 2.0, 3.0}) {
    const auto c = shortest_chord(ToothArc<double>{theta, 0.0, 17.3, 20.0});
    EXPECT_EQ(c.half_angle_used, theta);
    EXPECT_EQ(c.chord, 2 * 17.3 * std::sin(theta));
    EXPECT_EQ(c.caliper_angle, 0.0);
    EXPECT_NEAR(c.height, 17.3 * (1 - std::cos(theta)), 1e-15 * 17.3);
  }
  // A gear that is nearly a spur gear has nearly the same chord, because no formula divides by
  // tan ψ.
  const auto a = shortest_chord(ToothArc<double>{0.2, 1e-160, 17.3, 20.0});
  EXPECT_DOUBLE_EQ(a.chord, 2 * 17.3 * std::sin(0.2));
  // At the other end, a helix runs nearly along the circumference. The shortest chord then differs
  // from the axial thickness 2 r θ_t/tan ψ by less than cos² ψ.
  const auto b = shortest_chord(ToothArc<double>{1.5, 89.999 * kDegree, 17.3, 20.0});
  EXPECT_NEAR(b.chord, 2 * 17.3 * 1.5 * std::cos(89.999 * kDegree), 1e-9);
}

// θ* remains in its range at the limits between the branches of the equation, and far beyond real
// gears.
TEST(ShortestChord, half_angle_at_the_edges_of_its_domain) {
  const double half = kPi / 2;
  for (const double theta_t : {kMinHalfAngle, 1e-20, 0.5, std::nextafter(half, 0.0), half,
                               std::nextafter(half, 4.0), 2.0, std::nextafter(kPi, 0.0)}) {
    for (const double T : {0.0, 5e-324, 1e-300, 1e-16, std::nextafter(1.0, 0.0), 1.0,
                           std::nextafter(1.0, 2.0), 2.0, 4.6, 100.0, 1e10, 2.7e32}) {
      const double theta = shortest_chord_half_angle(theta_t, T);
      EXPECT_GT(theta, 0.0) << theta_t << " " << T;
      EXPECT_LE(theta, theta_t <= half ? std::nextafter(theta_t, 4.0) : kPi) << theta_t << " " << T;
      EXPECT_GE(theta, theta_t / (1 + T) * (1 - 1e-15)) << theta_t << " " << T;
    }
  }
}

// For small teeth, 1 − cos θ* would lose all digits.
TEST(ShortestChord, height_does_not_cancel) {
  const auto c = shortest_chord(ToothArc<double>{1e-7, 0.0, 100.0, 101.0});
  EXPECT_NEAR(c.height, 100.0 * (0.5e-14 - 1e-28 / 24), 2e-28);  // θ²/2 − θ⁴/24, to 2 ulp
}

CylindricalSpec spec_of(int z, double m, double beta_deg, double x) {
  return testing::plain_spec(
      {.teeth = z, .module = m, .beta_deg = beta_deg, .x = x, .face_width = 10 * m});
}

// KHK, Elements of metric gear technology: m 10, z 12, x 0.3, chord 17.8256, distance from the tip
// 13.9431. KHK computes the distance by h_a + s² cos β/(4 d), which is of first order, so only the
// chord is compared. For z 18, x 0.4, both values are exact.
TEST(ChordalThickness, of_spur_gears) {
  const auto khk = chordal_thickness(made(spec_of(12, 10, 0, 0.3)), 120);
  ASSERT_TRUE(khk) << khk.error().message();
  EXPECT_NEAR(khk->chord, 17.8256, 5e-5);
  const auto small = chordal_thickness(made(spec_of(18, 1, 0, 0.4)), 18);
  ASSERT_TRUE(small);
  EXPECT_NEAR(small->chord, 1.858653637060082364367, 1e-15 * 10);
  EXPECT_NEAR(small->tip_to_chord, 1.448109045326745497085, 1e-15 * 20);
  EXPECT_EQ(small->caliper_angle, 0.0);
}

TEST(ChordalThickness, of_helical_gears_and_rings) {
  auto s = spec_of(9, 3, 51.576509202864735, -0.4531138337575591);
  s.tip_diameter = 46.65;
  const Gear pinion = made(s);
  for (const Golden& g : {kGolden[0], kGolden[1], kGolden[2]}) {
    const auto c = chordal_thickness(pinion, g.diameter);
    ASSERT_TRUE(c) << c.error().message();
    // The profile shift is printed to 1e-16, and the base helix angle is computed from the helix
    // angle.
    EXPECT_NEAR(c->chord, g.chord, 1e-12) << g.tooth;
    EXPECT_NEAR(c->height, g.height, 1e-13) << g.tooth;
    EXPECT_NEAR(c->tip_to_chord, (46.65 - g.diameter) / 2 + g.height, 1e-13) << g.tooth;
    EXPECT_NEAR(c->caliper_angle / kDegree, g.caliper_deg, 1e-11) << g.tooth;
  }
  const Gear ring = made(spec_of(-60, 2, 0, -0.5));
  ASSERT_EQ(ring.tip_diameter, 118.0);
  const auto c = chordal_thickness(ring, 120);
  ASSERT_TRUE(c) << c.error().message();
  EXPECT_NEAR(c->chord, 2.4134894423511044, 1e-12);
  EXPECT_NEAR(c->height, 0.012136500972841042, 1e-13);
  // The middle of the chord lies 60 cos θ* from the axis, and the tip lies at 59.
  EXPECT_NEAR(c->tip_to_chord, 60 * std::cos(0.02011376820881157) - 59, 1e-13);
}

// A thickness allowance changes the chord of a spur gear by the allowance times cos θ_t, here
// 0.999.
TEST(ChordalThickness, sees_the_allowance) {
  auto s = spec_of(40, 2, 0, 0);
  const auto full = chordal_thickness(made(s), 80);
  s.thickness_allowance = -0.05;
  const auto thin = chordal_thickness(made(s), 80);
  ASSERT_TRUE(full && thin);
  EXPECT_NEAR(full->chord - thin->chord, 0.05, 0.05 * 0.001);
}

TEST(ChordalThickness, holds_to_both_ends_of_the_flank) {
  for (const double beta : {0.0, 25.0}) {
    const Gear gear = made(spec_of(24, 3, beta, 0.1));
    EXPECT_TRUE(chordal_thickness(gear, gear.tip_diameter));
    EXPECT_TRUE(chordal_thickness(gear, 2 * *gear.root_form_radius()));
    EXPECT_FALSE(chordal_thickness(gear, std::nextafter(gear.tip_diameter, 1e9)));
    EXPECT_FALSE(chordal_thickness(gear, std::nextafter(2 * *gear.root_form_radius(), 0.0)));
  }
  const Gear ring = made(spec_of(-60, 2, 10, 0.2));
  EXPECT_TRUE(chordal_thickness(ring, ring.tip_diameter));
  EXPECT_TRUE(chordal_thickness(ring, ring.root_diameter));
  EXPECT_FALSE(chordal_thickness(ring, std::nextafter(ring.tip_diameter, 0.0)));
  EXPECT_FALSE(chordal_thickness(ring, std::nextafter(ring.root_diameter, 1e9)));
}

// Half the angle of the tooth at this radius, from its outline.
double outline_half_angle(const Gear& gear, double radius) {
  for (const Arc& arc : gear.tooth->outline.arcs) {
    double lo = 0.0, hi = 1.0;
    const auto above = [&](double u) { return gear.side() * (arc.point(u).norm() - radius) > 0.0; };
    if (above(0.0) || !above(1.0)) continue;
    while (hi - lo > 1e-14) (above((lo + hi) / 2) ? hi : lo) = (lo + hi) / 2;
    const Vec2 p = arc.point(lo);
    return std::atan2(p.y(), p.x());
  }
  return std::numeric_limits<double>::quiet_NaN();
}

// The tooth is an involute only between the ends of the usable flank. This also holds for an
// internal gear that was cut by a pinion cutter.
TEST(ChordalThickness, ends_where_the_fillet_begins) {
  const Gear ring = *cut_by_default(made(spec_of(-60, 2, 0, 0)));
  for (const Gear& gear : {made(spec_of(24, 3, 0, 0.1)), ring}) {
    const double form = 2 * *gear.root_form_radius();
    for (const double d : {form + gear.side() * 1e-9, 0.5 * (form + gear.tip_diameter)})
      EXPECT_NEAR(tooth_arc(gear, d).half_angle, outline_half_angle(gear, d / 2), 1e-10);
    EXPECT_TRUE(chordal_thickness(gear, form));
    const double fillet = form - gear.side() * 0.2;
    EXPECT_GT(std::abs(outline_half_angle(gear, fillet / 2) - tooth_arc(gear, fillet).half_angle),
              1e-5);
    EXPECT_FALSE(chordal_thickness(gear, fillet)) << gear.spec.teeth;
  }
}

void expect_refused(const Gear& gear, double diameter, const std::string& word) {
  const auto c = chordal_thickness(gear, diameter);
  ASSERT_FALSE(c) << diameter;
  EXPECT_EQ(c.error().field, "chord_diameter");
  EXPECT_NE(c.error().message().find(word), std::string::npos) << c.error().message();
  EXPECT_NE(c.error().message().find("chord_diameter = "), std::string::npos);
}

TEST(ChordalThickness, says_what_is_allowed) {
  const Gear gear = made(spec_of(24, 3, 0, 0.1));
  for (const double d : {10.0, 67.0, 90.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    expect_refused(gear, d, "base diameter");
    expect_refused(gear, d, "d_Ff");
    expect_refused(gear, d, "d_Fa");
  }
  expect_refused(made(spec_of(-60, 2, 0, 0)), 130, "root diameter");
  // On a pointed tooth, the flank ends where the flanks meet, and the chord is 0 there.
  auto pointed = spec_of(12, 2, 0, 0.9);
  pointed.tip_diameter = 40;
  const Gear sharp = made(pointed);
  ASSERT_TRUE(sharp.pointed());
  expect_refused(sharp, *sharp.pointed_diameter + 1e-9, "d_Fa");
  const auto near_point = chordal_thickness(sharp, *sharp.pointed_diameter - 1e-6);
  ASSERT_TRUE(near_point);
  EXPECT_LT(near_point->chord, 1e-5);
  // An internal gear whose teeth meet before its tip.
  auto thin_ring = spec_of(-60, 2, 0, -1.2);
  thin_ring.tip_diameter = 115;
  const Gear ring = made(thin_ring);
  ASSERT_TRUE(ring.pointed());
  expect_refused(ring, *ring.pointed_diameter - 0.01, "flanks meet");
  // A tooth that the cutter has removed has no flank.
  const Gear severed = made(spec_of(4, 2, 0, -0.9));
  ASSERT_TRUE(!severed.exists() || !severed.root_form_radius());
  expect_refused(severed, 8, "no usable flank");
}

// One tooth that covers more than half of the circumference of a spur gear.
TEST(ChordalThickness, of_a_tooth_too_wide_for_any_calliper) {
  auto s = spec_of(1, 2, 0, 0.3);
  s.straight_rack().addendum = 0.1;
  s.straight_rack().dedendum = 0.3;
  s.straight_rack().root_fillet_radius = 0.0;
  const Gear gear = made(s);
  ASSERT_TRUE(gear.exists() && gear.root_form_radius());
  const double d = 2 * *gear.root_form_radius() * 1.0001;
  ASSERT_GT(tooth_arc(gear, d).half_angle, kPi / 2);
  expect_refused(gear, d, "too much for a calliper");
  // A calliper can measure the thread of a worm that has the same width.
  auto worm = spec_of(1, 2, 84, 0.3);
  const Gear thread = made(worm);
  const auto c = chordal_thickness(thread, thread.reference_diameter);
  ASSERT_TRUE(c) << c.error().message();
  EXPECT_NEAR(c->chord, thread.reference().reference_tooth_thickness_normal, 0.01);
}

}  // namespace
}  // namespace gearwright
