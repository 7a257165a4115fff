// Compares spans, balls and pins with distances in space that are computed without their formulas,
// and with laws.
//
// The oracle describes the flank by points (u, z) of the unwound involute, which is screwed along
// the axis. The ball is pushed into the tooth space until the nearest point of the flank is at the
// distance of the ball radius. The span is the stationary distance of two flanks, where the line is
// normal to both. Free pins have the least distance of two helices.
#include <gtest/gtest.h>

#include <cmath>

#include "gearwright/base/testing/draw.hpp"
#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/inspection/balls.hpp"
#include "gearwright/inspection/chord_series.hpp"
#include "gearwright/inspection/chordal_thickness.hpp"
#include "gearwright/inspection/evaluation_ranges.hpp"
#include "gearwright/inspection/span.hpp"

namespace gearwright {
namespace {

using Real = long double;
using testing::kLongPi;

struct LongPoint {
  Real x, y, z;
};
LongPoint operator-(const LongPoint& a, const LongPoint& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
LongPoint cross(const LongPoint& a, const LongPoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Real norm(const LongPoint& a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }

// The data of the drawing, computed independently of the library.
struct Drawing {
  int z;
  Real m, alpha, beta, x, allowance;

  Real alpha_t() const { return std::atan(std::tan(alpha) / std::cos(beta)); }
  Real r() const { return std::abs(z) * m / std::cos(beta) / 2; }
  Real r_b() const { return r() * std::cos(alpha_t()); }
  Real twist() const { return std::tan(beta) / r(); }
  Real side() const { return z > 0 ? 1 : -1; }
  // Half angle of the tooth at the base circle.
  Real half() const {
    const Real s_n = m * (kLongPi / 2 + 2 * x * std::tan(alpha)) + allowance;
    return s_n / std::cos(beta) / (2 * r()) + side() * (std::tan(alpha_t()) - alpha_t());
  }
};

// The flank on one side (+1: counter-clockwise) of the tooth about the x axis.
struct Flank {
  Drawing d;
  int hand;
  Real turned;  // rotation of the tooth's centre line

  LongPoint at(Real u, Real z) const {
    const Real theta = hand * (d.half() - d.side() * (u - std::atan(u))) + turned + d.twist() * z;
    const Real rho = d.r_b() * std::sqrt(1 + u * u);
    return {rho * std::cos(theta), rho * std::sin(theta), z};
  }
};

template <class F>
Real golden(const F& f, Real a, Real b) {
  const Real ratio = (std::sqrt(Real(5)) - 1) / 2;
  Real p = b - ratio * (b - a), q = a + ratio * (b - a);
  Real fp = f(p), fq = f(q);
  for (int i = 0; i < 52; ++i) {
    if (fp < fq) {
      b = q, q = p, fq = fp;
      fp = f(p = b - ratio * (b - a));
    } else {
      a = p, p = q, fp = fq;
      fq = f(q = a + ratio * (b - a));
    }
  }
  return (a + b) / 2;
}

struct Touch {
  Real distance, u, z;
};

Touch nearest(const Flank& flank, const LongPoint& center, Real reach) {
  const auto best_z = [&](Real u) {
    return golden([&](Real z) { return norm(flank.at(u, z) - center); }, -reach, reach);
  };
  const Real u =
      golden([&](Real v) { return norm(flank.at(v, best_z(v)) - center); }, Real(0), Real(3));
  const Real z = best_z(u);
  return {norm(flank.at(u, z) - center), u, z};
}

struct BallByPushing {
  Real center_radius, contact_radius, contact_offset;
};

BallByPushing pushed(const Drawing& d, Real ball, Real near) {
  // The flank of the tooth next to the space on the x axis. The tooth is turned back by half a
  // pitch.
  const Flank flank{d, 1, -kLongPi / std::abs(d.z)};
  const auto touch = [&](Real rho) { return nearest(flank, {rho, 0, 0}, ball); };
  // Secant method from two points near the seat.
  Real before = near * 1.002L, now = near * 0.998L;
  Real f_before = touch(before).distance - ball / 2, f = touch(now).distance - ball / 2;
  for (int i = 0; i < 12 && std::abs(now - before) > 1e-17L * near; ++i) {
    const Real next = now - f * (now - before) / (f - f_before);
    before = now, f_before = f, now = next;
    f = touch(now).distance - ball / 2;
    if (f == f_before) break;
  }
  const Touch t = touch(now);
  return {now, d.r_b() * std::sqrt(1 + t.u * t.u), std::abs(t.z)};
}

// The stationary distance of two flanks that are k − 1 pitches apart and symmetric to the x axis.
struct SpanByDistance {
  Real length, contact_radius, off_normal;
};

SpanByDistance stationary(const Drawing& d, int k, Real u, Real z) {
  const Real pitches = (d.z > 0 ? k - 1 : k) * kLongPi / std::abs(d.z);
  const int outer = d.z > 0 ? 1 : -1;  // for an internal gear, the flanks that bound k spaces
  const Flank a{d, outer, pitches}, b{d, -outer, -pitches};
  const auto f = [&](Real v, Real w) { return norm(a.at(v, w) - b.at(v, -w)); };
  const Real hu = 1e-4L, hz = 1e-4L * d.m;
  for (int i = 0; i < 60; ++i) {
    const Real fu = (f(u + hu, z) - f(u - hu, z)) / (2 * hu);
    const Real fz = (f(u, z + hz) - f(u, z - hz)) / (2 * hz);
    const Real uu = (f(u + hu, z) - 2 * f(u, z) + f(u - hu, z)) / (hu * hu);
    const Real zz = (f(u, z + hz) - 2 * f(u, z) + f(u, z - hz)) / (hz * hz);
    const Real uz =
        (f(u + hu, z + hz) - f(u + hu, z - hz) - f(u - hu, z + hz) + f(u - hu, z - hz)) /
        (4 * hu * hz);
    const Real det = uu * zz - uz * uz;
    const Real du = (zz * fu - uz * fz) / det, dz = (uu * fz - uz * fu) / det;
    u -= du;
    z -= dz;
    if (std::abs(du) + std::abs(dz) / d.m < 1e-15L) break;
  }
  const LongPoint line = a.at(u, z) - b.at(u, -z);
  const LongPoint along_u = a.at(u + hu, z) - a.at(u - hu, z),
                  along_z = a.at(u, z + hz) - a.at(u, z - hz);
  const LongPoint normal = cross(along_u, along_z);
  return {norm(line), d.r_b() * std::sqrt(1 + u * u),
          norm(cross(line, normal)) / norm(line) / norm(normal)};
}

Drawing drawn(testing::Draw& random, bool internal) {
  const Real deg = kLongPi / 180;
  Drawing d{};
  d.z = internal ? -random.whole(30, 120) : random.whole(8, 120);
  d.m = random.uniform(0.5, 8);
  d.alpha = random.uniform(15, 25) * deg;
  d.beta = (random.whole(0, 2) == 0 ? 0.0 : random.uniform(-40, 40)) * deg;
  d.x = random.uniform(-0.2, 0.6);
  d.allowance = random.uniform(-0.05, 0) * d.m;
  return d;
}

Gear made(const Drawing& d) {
  CylindricalSpec s;
  s.teeth = d.z;
  s.normal_module = static_cast<double>(d.m);
  s.normal_pressure_angle = Angle::radians(static_cast<double>(d.alpha));
  s.helix_angle = Angle::radians(static_cast<double>(d.beta));
  s.profile_shift = static_cast<double>(d.x);
  s.thickness_allowance = static_cast<double>(d.allowance);
  s.face_width = 40 * s.normal_module;
  s.straight_rack().root_fillet_radius = 0.2;  // fits at any of these pressure angles
  return testing::taken(make_gear(s));
}

TEST(Balls, rest_where_a_ball_pushed_into_the_space_does) {
  testing::Draw random(20260118);
  int seated = 0, rings = 0;
  double worst = 0.0;
  for (int i = 0; i < 60; ++i) {
    const Drawing d = drawn(random, i % 3 == 2);
    const Gear gear = made(d);
    const auto sizes = ball_sizes(gear);
    if (!sizes) continue;
    const double ball = sizes->ideal * random.uniform(0.98, 1.04);
    const auto seat = ball_in_space(gear, ball);
    if (!seat) continue;
    const BallByPushing found = pushed(d, ball, seat->center_diameter / 2);
    const double scale = static_cast<double>(d.r());
    worst =
        std::max(worst, std::abs(seat->center_diameter / 2 - double(found.center_radius)) / scale);
    EXPECT_NEAR(seat->center_diameter / 2, double(found.center_radius), 1e-13 * scale) << i;
    // The nearest point of a smooth surface is found to the square root of the rounding error.
    EXPECT_NEAR(seat->contact_diameter / 2, double(found.contact_radius), 1e-7 * scale) << i;
    EXPECT_NEAR(seat->contact_offset, double(found.contact_offset), 1e-7 * scale) << i;
    ++seated;
    rings += d.z < 0;
  }
  EXPECT_GE(seated, 40);
  EXPECT_GE(rings, 8);
  RecordProperty("worst", std::to_string(worst));
}

TEST(Span, is_the_stationary_distance_of_two_flanks) {
  testing::Draw random(20260118);
  int measured = 0, rings = 0;
  for (int i = 0; i < 90; ++i) {
    Drawing d = drawn(random, i % 3 == 2);
    if (d.z < 0) d.beta = 0;
    const Gear gear = made(d);
    const auto span = usual_span(gear);
    if (!span) continue;
    // The search starts at a point whose coordinates are 1 % greater than those of the contact.
    const Real ratio = span->contact_diameter / 2 / d.r_b();
    const Real u = std::sqrt(ratio * ratio - 1) * 1.01L;
    const Real z = -span->min_face_width / 2 * (d.beta > 0 ? 1 : -1) * 1.01L;
    const SpanByDistance found = stationary(d, span->teeth, u, z);
    const double scale = static_cast<double>(d.r());
    EXPECT_NEAR(span->length, double(found.length), 1e-12 * scale) << i << " " << d.z;
    EXPECT_NEAR(span->contact_diameter / 2, double(found.contact_radius), 1e-6 * scale) << i;
    EXPECT_LT(double(found.off_normal), 1e-6) << i;
    ++measured;
    rings += d.z < 0;
  }
  EXPECT_GE(measured, 70);
  EXPECT_GE(rings, 20);
}

TEST(Pins, that_tilt_freely_find_the_least_distance_of_two_helices) {
  testing::Draw random(20260118);
  int odd = 0, steep = 0;
  for (int i = 0; i < 200; ++i) {
    Drawing d = drawn(random, false);
    d.z = random.whole(3, 60);
    const bool worm = i % 4 == 0;
    d.beta = random.uniform(worm ? 50 : 5, worm ? 80 : 45) * kLongPi / 180;
    const Gear gear = made(d);
    const auto sizes = ball_sizes(gear);
    if (!sizes) continue;
    const auto seat = ball_in_space(gear, sizes->ideal);
    if (!seat) continue;
    const PinReading pins = over_pins(gear, *seat);
    const Real r_K = seat->center_diameter / 2;
    const Real offset = d.z % 2 ? kLongPi / d.z : 0;
    // A dense search, followed by golden section around the best point.
    const auto distance = [&](Real h) {
      const Real half = (kLongPi - offset + d.twist() * h) / 2;
      return std::hypot(2 * r_K * std::sin(half), h);
    };
    const Real reach = 2 * r_K;
    Real best = 0;
    for (int n = -4000; n <= 4000; ++n)
      if (distance(reach * n / 4000) < distance(best)) best = reach * n / 4000;
    best = golden(distance, best - reach / 2000, best + reach / 2000);
    EXPECT_NEAR(*pins.two_free, double(distance(best)) + seat->ball_diameter, 1e-12 * double(r_K))
        << i;
    // The contacts of each pin lie on both sides of its nearest point.
    EXPECT_NEAR(*pins.two_free_face, std::abs(double(best)) + 2 * seat->contact_offset,
                1e-6 * double(r_K))
        << i;
    EXPECT_GE(*pins.three, over_two_balls(gear, *seat));
    EXPECT_LE(*pins.two_free, over_two_balls(gear, *seat) * (1 + 1e-15));
    odd += d.z % 2;
    steep += worm;
  }
  EXPECT_GE(odd, 40);
  EXPECT_GE(steep, 10);
}

// The example of the theory page for three valid readings.
TEST(Pins, have_three_readings_on_a_helical_gear_of_odd_teeth) {
  const Gear gear = made({17, 3, 20 * kLongPi / 180, 20 * kLongPi / 180, 0.3L, 0});
  const auto seat = ball_in_space(gear, 5);
  ASSERT_TRUE(seat) << seat.error().message();
  const PinReading pins = over_pins(gear, *seat);
  EXPECT_NEAR(over_two_balls(gear, *seat), 62.02615, 5e-6);
  EXPECT_NEAR(*pins.two_free, 61.98427, 5e-6);
  EXPECT_NEAR(*pins.three, 62.27046, 5e-6);
}

// (1) the ball for a given contact diameter touches at this diameter
// (2) the tooth thickness follows from the reading
// (3) the hand of the helix changes nothing
// (4) doubled lengths double the readings
TEST(Balls, laws) {
  testing::Draw random(20260118);
  int seated = 0;
  for (int i = 0; i < 300; ++i) {
    Drawing d = drawn(random, i % 3 == 2);
    const Gear gear = made(d);
    const auto flank = usable_flank(gear);
    if (!flank) continue;
    const double at = flank->least() + (flank->greatest() - flank->least()) * random.uniform(0, 1);
    const auto ball = ball_touching_at(gear, at);
    if (!ball) continue;
    const auto seat = ball_in_space(gear, *ball);
    if (!seat) continue;
    EXPECT_NEAR(seat->contact_diameter, at, 1e-13 * at) << i;  // (1)
    const double M = over_two_balls(gear, *seat);
    const auto s_bt = base_thickness_from_balls(gear, *ball, M);
    ASSERT_TRUE(s_bt);
    EXPECT_NEAR(*s_bt, gear.reference().base_tooth_thickness,
                1e-13 * gear.reference_diameter);  // (2)
    Drawing other = d;
    other.beta = -d.beta;
    const Gear mirrored = made(other);
    EXPECT_EQ(over_two_balls(mirrored, testing::taken(ball_in_space(mirrored, *ball))), M);  // (3)
    other = d;
    other.m *= 2;
    other.allowance *= 2;
    const Gear doubled = made(other);
    const auto twice = ball_in_space(doubled, 2 * *ball);
    ASSERT_TRUE(twice);
    EXPECT_DOUBLE_EQ(over_two_balls(doubled, *twice), 2 * M);  // (4)
    ++seated;
  }
  EXPECT_GE(seated, 150);  // other balls do not project beyond the tip
}

TEST(Balls, that_cannot_be_measured_are_refused_with_those_that_can) {
  const Gear gear = made({20, 2, 20 * kLongPi / 180, 0, 0, 0});
  const auto refused_for = [&](const Gear& g, double ball, const std::string& word) {
    const auto seat = ball_in_space(g, ball);
    ASSERT_FALSE(seat) << ball;
    EXPECT_EQ(seat.error().field, "ball_diameter");
    EXPECT_NE(seat.error().message().find(word), std::string::npos) << seat.error().message();
  };
  refused_for(gear, 1.0, "too small to touch both flanks");
  refused_for(gear, 2.6, "does not project");
  refused_for(gear, 9.0, "rests on the tips");
  EXPECT_TRUE(ball_in_space(gear, 3.5));
  auto tall = gear.spec;
  tall.tip_diameter = 45.5;
  const auto low = made({20, 2, 20 * kLongPi / 180, 0, 0.4L, 0});
  refused_for(low, 2.5, "");
  const Gear proud = testing::taken(make_gear(tall));
  refused_for(proud, 3.0, "does not project");
  const Gear ring = made({-60, 2, 20 * kLongPi / 180, 0, 0, 0});
  refused_for(ring, 8.0, "");
  refused_for(ring, 1.0, "");
}

TEST(Span, that_no_anvils_reach_is_refused_with_those_that_they_do) {
  const Gear gear = made({20, 2, 20 * kLongPi / 180, 0, 0, 0});
  const auto far = span_over(gear, 7);
  ASSERT_FALSE(far);
  EXPECT_EQ(far.error().field, "span_teeth");
  EXPECT_NE(far.error().message().find("1 to 4 teeth can be measured"), std::string::npos)
      << far.error().message();
  EXPECT_FALSE(span_over(gear, 0));
  EXPECT_FALSE(span_over(gear, 21));
  EXPECT_FALSE(span_over(made({-60, 2, 20 * kLongPi / 180, 0.2L, 0, 0}), 6));
  EXPECT_EQ(usual_span(gear)->teeth, 3);
  EXPECT_EQ(usable_spans(gear, 31).size(), 4u);
  // On a face narrower than W sin β_b one anvil does not touch the flank.
  auto narrow = made({40, 2, 20 * kLongPi / 180, 30 * kLongPi / 180, 0, 0}).spec;
  narrow.face_width = 5;
  const Gear thin = testing::taken(make_gear(narrow));
  EXPECT_FALSE(usual_span(thin));
  EXPECT_FALSE(testing::taken(span_over(thin, 6)).usable());
}

// The chords of helical gears in the case file (inspection.json) are chords of the spur gear with
// z/cos³ β teeth, for which the library has a function. `measure` prints the exact minimum.
TEST(Chord, of_the_virtual_gear_is_that_of_the_case_file) {
  struct Case {
    int z;
    double m, beta, x, chord, height;
  };
  for (const Case& c :
       {Case{24, 3, 15, 0.3, 5.363498268103879433824, 3.990120857144599608938},
        Case{33, 1.5, 30, -0.1, 2.246677872337183887103, 1.366561615953651527592}}) {
    const Gear gear =
        made({c.z, Real(c.m), 20 * kLongPi / 180, Real(c.beta) * kLongPi / 180, Real(c.x), 0});
    const auto arc = tooth_arc(gear, gear.reference_diameter);
    const auto virtual_chord = virtual_spur(arc.half_angle, arc.helix_angle, arc.radius).chord();
    EXPECT_NEAR(virtual_chord.chord, c.chord, 1e-12 * c.chord);
    EXPECT_NEAR((gear.tip_diameter - gear.reference_diameter) / 2 + virtual_chord.height, c.height,
                1e-12 * c.height);
  }
}

// The constant chord touches the flank, so the thickness of the tooth there equals the length of
// the chord.
TEST(ConstantChord, ends_on_both_flanks) {
  testing::Draw random(20260118);
  for (int i = 0; i < 100; ++i) {
    const Drawing d = drawn(random, i % 3 == 2);
    const Gear gear = made(d);
    const auto c = constant_chord(gear);
    if (!c || c->contact_diameter < gear.reference().base_diameter) continue;
    const ToothArc<double> arc = tooth_arc(gear, c->contact_diameter);
    // The end of the chord lies at z = chord/2 · sin β, where the flank is rotated according to the
    // lead. In this section, it lies chord/2 · cos β from the middle plane of the tooth.
    const double across = c->chord / 2 * std::cos(double(d.beta));
    const double z = c->chord / 2 * std::sin(double(d.beta));
    const double turned = std::asin(across / (c->contact_diameter / 2)) + z * gear.twist();
    EXPECT_NEAR(turned, arc.half_angle, 1e-13) << i << " " << double(d.beta);
  }
}

// d_b is 37.588. At d = 40, the roll length is 40 sin 20°/2 = 6.8404, and the roll angle is tan
// 20°.
TEST(EvaluationRanges, of_a_spur_gear_by_hand) {
  const Gear gear = made({20, 2, 20 * kLongPi / 180, 0, 0, 0});
  const auto ranges = evaluation_ranges(gear);
  ASSERT_TRUE(ranges);
  EXPECT_NEAR(ranges->reference.length, 6.840402866513375, 1e-14);
  EXPECT_NEAR(ranges->reference.angle, std::tan(0.3490658503988659), 1e-15);
  EXPECT_EQ(ranges->profile[0], ranges->root_form.length);
  EXPECT_NEAR(ranges->profile[1] - ranges->profile[0],
              0.95 * (ranges->tip_form.length - ranges->root_form.length), 1e-14);
  // For a face width of 80, the evaluation ends one module before each end, not 4 mm.
  EXPECT_EQ(ranges->helix[1], 38.0);
}

}  // namespace
}  // namespace gearwright
