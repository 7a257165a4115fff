// Compares the removal field with its formulas, which are evaluated in long double and
// differentiated by differences. Tests borders, the continuation below the base circle, and errors.
#include "gearwright/gear/modifications.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "gearwright/base/testing/violation.hpp"

namespace gearwright {
namespace {

using Long = long double;
using Field = RemovalField;
using P = Modification;

// 17 teeth, m_n 2.5, α_n 20°: base circle 39.935 mm, usable flank from 41 to 47.5 mm diameter.
const FlankExtent kGear{19.9676, 20.5, 23.75, 25.0};
const FlankExtent kArcs{0.0, 20.5, 23.75, 25.0};   // not an involute, so L is the radius
const FlankExtent kRing{60.14, 66.0, 62.0, 30.0};  // the tip has the lesser radius
const FlankExtent kFromBase{20.0, 20.0, 23.0, 25.0};

// The diameter at the fraction x of the way from the root form circle to the tip form circle.
double diameter(const FlankExtent& e, double x) {
  return 2 * (e.rho_root_form + x * (e.rho_tip_form - e.rho_root_form));
}

FlankModifications everything(const FlankExtent& e, ReliefShape shape) {
  FlankModifications m;
  m.tip_relief = {0.020, diameter(e, 0.6), shape};
  m.root_relief = {0.012, diameter(e, 0.3), shape};
  m.profile_crowning = 0.003;
  m.profile_slope = -0.005;
  m.lead_crowning = 0.008;
  m.lead_slope = 0.011;
  m.end_relief = {0.015, 3.0, shape};
  return m;
}

Long roll(const FlankExtent& e, Long rho) { return std::sqrt(rho * rho - Long(e.r0) * e.r0); }

// An independent implementation of the formulas at the head of modifications.hpp.
Long removed(const FlankModifications& m, const FlankExtent& e, Long u, Long z,
             const Field::Piece& p) {
  const Long L = roll(e, std::exp(u));
  const Long tip = roll(e, e.rho_tip_form);
  const Long root = roll(e, e.rho_root_form);
  const Long w = (L - (tip + root) / 2) / (tip - root);
  const Long b = e.face_width;
  const auto shaped = [](const Relief& r, Long q) {
    return r.amount * (r.shape == ReliefShape::parabolic ? q * q : q);
  };
  Long c = 4 * m.profile_crowning * w * w + m.profile_slope * w +
           4 * m.lead_crowning * (z / b) * (z / b) + m.lead_slope * z / b;
  if (p.tip) {
    const Long start = roll(e, Long(*m.tip_relief.reach) / 2);
    c += shaped(m.tip_relief, (L - start) / (tip - start));
  }
  if (p.root) {
    const Long start = roll(e, Long(*m.root_relief.reach) / 2);
    c += shaped(m.root_relief, (L - start) / (root - start));
  }
  if (p.end_hi) c += shaped(m.end_relief, (z - b / 2) / *m.end_relief.reach + 1);
  if (p.end_lo) c += shaped(m.end_relief, (-z - b / 2) / *m.end_relief.reach + 1);
  const auto wave = [](const FormWave& f, Long x) {
    return f.height / 2 * std::sin(2 * std::numbers::pi_v<Long> * f.waves * x + f.phase);
  };
  return c + wave(m.profile_wave, w) + wave(m.helix_wave, z / b);
}

// Central differences with one Richardson step, so that the error is h⁴ times the fifth or sixth
// derivative. Second derivatives need longer steps than first derivatives because of rounding.
template <class F>
Removal differences(const F& f, Long u, Long z) {
  const auto best = [](const auto& d, Long h) {
    return static_cast<double>((4 * d(h) - d(2 * h)) / 3);
  };
  const Long first = 1e-5L;
  const Long second = 3e-5L;
  const Long per_u = 1000;  // steps along z, mm
  const auto d_u = [&](Long h) { return (f(u + h, z) - f(u - h, z)) / (2 * h); };
  const auto d_z = [&](Long h) { return (f(u, z + h) - f(u, z - h)) / (2 * h); };
  const auto d_uu = [&](Long h) { return (f(u + h, z) - 2 * f(u, z) + f(u - h, z)) / (h * h); };
  const auto d_zz = [&](Long h) { return (f(u, z + h) - 2 * f(u, z) + f(u, z - h)) / (h * h); };
  const auto d_uz = [&](Long h) {
    const Long k = h * per_u;
    return (f(u + h, z + k) - f(u + h, z - k) - f(u - h, z + k) + f(u - h, z - k)) / (4 * h * k);
  };
  return {static_cast<double>(f(u, z)), best(d_u, first),   best(d_z, first * per_u),
          best(d_uu, second),           best(d_uz, second), best(d_zz, second * per_u)};
}

struct Tolerance {
  double c, first, second;
};

void expect_near(const Removal& got, const Removal& expected, const Tolerance& t) {
  EXPECT_NEAR(got.c, expected.c, t.c);
  EXPECT_NEAR(got.c_u, expected.c_u, t.first);
  EXPECT_NEAR(got.c_z, expected.c_z, t.first);
  EXPECT_NEAR(got.c_uu, expected.c_uu, t.second);
  EXPECT_NEAR(got.c_uz, expected.c_uz, t.second);
  EXPECT_NEAR(got.c_zz, expected.c_zz, t.second);
}

// On these flanks, c is about 0.05 mm, c_u up to 1 and c_uu up to 70. In double, u ≈ 3 is rounded
// by 2e-16. This error is multiplied by the next derivative of each value, which gives 4e-16, 2e-14
// and 1e-12. In long double, u and its exponential are rounded by 3e-19 in total. The differences
// multiply this error by c_u and by 16/(3 h²) for h = 3e-5, which gives 1.8e-9, or by 5/(3 h) for h
// = 1e-5, which gives 5e-14. The truncation error is less.
constexpr Tolerance kClosedForm{1e-15, 1e-13, 2e-9};

TEST(RemovalField, is_its_formulas_and_their_derivatives) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-0.2, 1.2);  // position in a cell, also beyond its
                                                           // borders
  for (const FlankExtent& e : {kGear, kArcs, kRing}) {
    for (const ReliefShape shape : {ReliefShape::linear, ReliefShape::parabolic}) {
      FlankModifications m = everything(e, shape);
      m.profile_wave = {1, 0.4, 0.008};
      m.helix_wave = {1, 1.1, 0.006};
      const auto field = make_removal_field(m, e);
      ASSERT_TRUE(field) << field.error().message();
      ASSERT_EQ(field->pieces().size(), 9u);
      for (const Field::Cell& cell : field->pieces()) {
        for (int k = 0; k < 40; ++k) {
          const double u = cell.u_lo + unit(random) * (cell.u_hi - cell.u_lo);
          const double z = cell.z_lo + unit(random) * (cell.z_hi - cell.z_lo);
          const auto f = [&](Long a, Long b) { return removed(m, e, a, b, cell.piece); };
          expect_near(field->at(u, z, cell.piece), differences(f, u, z), kClosedForm);
        }
      }
    }
  }
}

TEST(RemovalField, is_the_sum_of_amounts_times_derivatives) {
  for (const FlankExtent& e : {kGear, kRing}) {
    const auto field = make_removal_field(everything(e, ReliefShape::parabolic), e);
    ASSERT_TRUE(field);
    for (const Field::Cell& cell : field->pieces()) {
      const double u = (cell.u_lo + cell.u_hi) / 2;
      const double z = (cell.z_lo + cell.z_hi) / 2;
      double c = 0.0, c_uu = 0.0, c_zz = 0.0;
      for (const auto& [p, name, relief, alone] : kModifications) {
        const Removal d = field->derivative(p, u, z, cell.piece);
        c += field->amount(p) * d.c;
        c_uu += field->amount(p) * d.c_uu;
        c_zz += field->amount(p) * d.c_zz;
      }
      const Removal all = field->at(u, z, cell.piece);
      EXPECT_EQ(all.c, c);
      EXPECT_EQ(all.c_uu, c_uu);
      EXPECT_EQ(all.c_zz, c_zz);
    }
  }
}

// Tests signs and positions as a drawing defines them, with explicit numbers.
TEST(RemovalField, has_the_values_of_the_drawing_at_the_ends) {
  for (const FlankExtent& e : {kGear, kArcs, kRing, kFromBase}) {
    const FlankModifications m = everything(e, ReliefShape::linear);
    const auto field = make_removal_field(m, e);
    ASSERT_TRUE(field) << field.error().message();
    const double tip = std::log(e.rho_tip_form);
    const double root = std::log(e.rho_root_form);
    const double b = e.face_width;
    const Long middle_roll = (roll(e, e.rho_tip_form) + roll(e, e.rho_root_form)) / 2;
    const auto middle =
        static_cast<double>(std::log(middle_roll * middle_roll + Long(e.r0) * e.r0) / 2);
    const auto unit = [&](P p, double u, double z) {
      return field->derivative(p, u, z, field->piece_at(u, z)).c;
    };
    // The rounding errors of u, its logarithm, its exponential and the step inside add up to 3e-15.
    // If a flank begins on its base circle, L has an error there of half of 1e-6 of the greatest L.
    // No function here changes by more than 4 over the whole range of L.
    const auto expect = [&](P p, double u, double value) {
      const bool on_base = e.rho_root_form == e.r0 && u < middle;
      const double slope = field->derivative(p, u, 0.0, field->piece_at(u, 0.0)).c_u;
      EXPECT_NEAR(unit(p, u, 0.0), value, on_base ? 2.1e-6 : 3e-15 * std::abs(slope) + 1e-15);
    };
    // The points are slightly inside the ends, so that piece_at() returns the end piece.
    const double at_tip = std::nextafter(tip, root);
    const double at_root = std::nextafter(root, tip);
    expect(P::tip_relief, at_tip, 1);
    EXPECT_EQ(unit(P::tip_relief, at_root, 0), 0);
    expect(P::root_relief, at_root, 1);
    EXPECT_EQ(unit(P::root_relief, at_tip, 0), 0);
    expect(P::profile_crowning, at_tip, 1);
    expect(P::profile_crowning, at_root, 1);
    expect(P::profile_crowning, middle, 0);
    expect(P::profile_slope, at_tip, 0.5);
    expect(P::profile_slope, middle, 0);
    expect(P::profile_slope, at_root, -0.5);
    EXPECT_EQ(unit(P::lead_crowning, middle, b / 2), 1);
    EXPECT_EQ(unit(P::lead_crowning, middle, -b / 2), 1);
    EXPECT_EQ(unit(P::lead_slope, middle, b / 2), 0.5);
    EXPECT_EQ(unit(P::end_relief, middle, b / 2), 1);
    EXPECT_EQ(unit(P::end_relief, middle, -b / 2), 1);
    EXPECT_EQ(unit(P::end_relief, middle, b / 2 - 3.5), 0);
    EXPECT_NEAR(unit(P::end_relief, middle, 1.5 - b / 2), 0.5, 1e-15);
  }
}

TEST(RemovalField, pieces_tile_the_flank) {
  for (const FlankExtent& e : {kGear, kArcs, kRing, kFromBase}) {
    const auto field = make_removal_field(everything(e, ReliefShape::linear), e);
    ASSERT_TRUE(field);
    const auto [inner, outer] = std::minmax({e.rho_root_form, e.rho_tip_form});
    const double u_lo = std::log(inner), u_hi = std::log(outer), half = e.face_width / 2;
    double area = 0.0;
    for (const Field::Cell& c : field->pieces()) {
      EXPECT_LT(c.u_lo, c.u_hi);
      EXPECT_LT(c.z_lo, c.z_hi);
      EXPECT_GE(c.u_lo, u_lo);
      EXPECT_LE(c.u_hi, u_hi);
      area += (c.u_hi - c.u_lo) * (c.z_hi - c.z_lo);
    }
    EXPECT_NEAR(area, (u_hi - u_lo) * 2 * half, 1e-13 * area);
    std::mt19937 random(9);
    std::uniform_real_distribution<double> in_u(u_lo, u_hi), in_z(-half, half);
    for (int k = 0; k < 400; ++k) {
      const double u = in_u(random);
      const double z = in_z(random);
      int owners = 0;
      for (const Field::Cell& c : field->pieces()) {
        if (!(u >= c.u_lo && u < c.u_hi && z >= c.z_lo && z < c.z_hi)) continue;
        ++owners;
        EXPECT_EQ(field->piece_at(u, z), c.piece);
      }
      EXPECT_EQ(owners, 1);
      // The start positions on the drawing determine which reliefs apply.
      const double rho = std::exp(u);
      const double x = (rho - e.rho_root_form) / (e.rho_tip_form - e.rho_root_form);
      const Field::Piece expected{x > 0.6, x < 0.3, z<3.0 - half, z> half - 3.0};
      EXPECT_EQ(field->piece_at(u, z), expected);
    }
    EXPECT_EQ(field->kinks_u().size(), 2u);
    EXPECT_EQ(field->kinks_z().size(), 2u);
  }
}

// c is continuous across every border. At a linear relief, the slope jumps. At a parabolic relief,
// only the second derivative jumps.
TEST(RemovalField, borders_are_where_the_kinks_are) {
  for (const ReliefShape shape : {ReliefShape::linear, ReliefShape::parabolic}) {
    const auto field = make_removal_field(everything(kGear, shape), kGear);
    ASSERT_TRUE(field);
    const bool linear = shape == ReliefShape::linear;
    for (const double u : field->kinks_u()) {
      const Removal a = field->at(u, 1.0, field->piece_at(std::nextafter(u, 0.0), 1.0));
      const Removal b = field->at(u, 1.0, field->piece_at(u, 1.0));
      EXPECT_NEAR(a.c, b.c, 1e-16);
      EXPECT_EQ(std::abs(a.c_u - b.c_u) > 1e-3, linear);
      EXPECT_EQ(std::abs(a.c_u - b.c_u) < 1e-13, !linear);
      EXPECT_GT(std::abs(a.c_uu - b.c_uu), 1e-2);
    }
    for (const double z : field->kinks_z()) {
      const Removal a = field->at(3.1, z, field->piece_at(3.1, std::nextafter(z, -100.0)));
      const Removal b = field->at(3.1, z, field->piece_at(3.1, z));
      EXPECT_NEAR(a.c, b.c, 1e-16);
      EXPECT_EQ(std::abs(a.c_z - b.c_z) > 1e-3, linear);
      EXPECT_EQ(std::abs(a.c_zz - b.c_zz) > 1e-3, !linear);
    }
  }
}

// Near and below the base circle, the returned derivatives remain the derivatives of c, and c
// remains bounded.
TEST(RemovalField, goes_on_below_an_involute) {
  FlankModifications m;
  m.profile_crowning = 0.01;
  m.profile_slope = 0.01;
  for (const double begin : {20.0, 20.0001, 20.2}) {
    const FlankExtent e{20.0, begin, 23.0, 25.0};
    const auto field = make_removal_field(m, e);
    ASSERT_TRUE(field) << field.error().message();
    const Field::Piece piece{};
    const double end = std::log(begin);
    for (const double beyond : {1e-2, 1e-3, 1e-4, 1e-5}) {
      const double u = end - beyond;
      const Removal r = field->at(u, 0.0, piece);
      // Here, L is about −0.9 √(L0² + 2 r0² beyond). Its magnitude is at most one length of the
      // flank.
      EXPECT_LT(std::abs(r.c), 0.01 * 4 * 4 + 0.01);
      // The step is small compared with the distance to L0/2, where the formulas change.
      const double h = 1e-4 * beyond;
      const Removal hi = field->at(u + h, 0.0, piece);
      const Removal lo = field->at(u - h, 0.0, piece);
      EXPECT_NEAR((hi.c - lo.c) / (2 * h), r.c_u, 1e-5 * std::abs(r.c_u) + 1e-9);
      EXPECT_NEAR((hi.c_u - lo.c_u) / (2 * h), r.c_uu, 1e-5 * std::abs(r.c_uu) + 1e-6);
    }
  }
  // At L = L0/2, where the formulas change, the function is continuous up to the second derivative.
  const FlankExtent e{20.0, 20.2, 23.0, 25.0};
  const auto field = make_removal_field(m, e);
  ASSERT_TRUE(field);
  const double L2 = (20.2 * 20.2 - 400.0) / 4;
  const double seam = std::log(400.0 + L2) / 2;
  const Removal above = field->at(seam + 1e-12, 0.0, {});
  const Removal below = field->at(seam - 1e-12, 0.0, {});
  EXPECT_NEAR(above.c - below.c, 2e-12 * above.c_u, 1e-15);
  EXPECT_NEAR(above.c_u, below.c_u, 1e-9 * std::abs(above.c_u));
  EXPECT_NEAR(above.c_uu, below.c_uu, 1e-8 * std::abs(above.c_uu));
}

std::shared_ptr<const Topography> tilted(double d_lo, double d_hi, double half) {
  auto t = std::make_shared<Topography>();
  t->diameters = {d_lo, 43.0, 45.0, 46.5, d_hi};
  t->heights = {-half, -4.0, 1.0, 5.0, half};
  for (const double d : t->diameters) {
    for (const double z : t->heights)
      t->removed.push_back(1e-4 * (d - 44) * (d - 44) * (z + 3) + 1e-5 * z * z);
  }
  return t;
}

TEST(RemovalField, adds_the_topography) {
  FlankModifications m;
  m.lead_slope = 0.002;
  m.topography = tilted(40.9, 47.6, 12.5);
  const auto field = make_removal_field(m, kGear);
  ASSERT_TRUE(field) << field.error().message();
  EXPECT_FALSE(field->none());
  const auto f = [&](Long u, Long z) {
    const Long d = 2 * std::exp(u);
    return 1e-4 * (d - 44) * (d - 44) * (z + 3) + 1e-5 * z * z + 0.002 * z / 25;
  };
  std::mt19937 random(13);
  std::uniform_real_distribution<double> in_u(std::log(20.5), std::log(23.75)), in_z(-12.5, 12.5);
  for (int k = 0; k < 100; ++k) {
    const double u = in_u(random);
    const double z = in_z(random);
    // The rounding error of the spline's second derivative, 1e-16 of its values over squared steps,
    // is multiplied by d², which is about 2000.
    expect_near(field->at(u, z), differences(f, u, z), {1e-15, 1e-13, 1e-9});
  }
}

TEST(RemovalField, without_modifications_is_one_piece_of_nothing) {
  const auto field = make_removal_field({}, kGear);
  ASSERT_TRUE(field);
  EXPECT_TRUE(field->none());
  EXPECT_EQ(field->pieces().size(), 1u);
  EXPECT_EQ(field->at(3.1, 2.0).c, 0.0);
  EXPECT_EQ(field->derivative(P::tip_relief, 3.1, 2.0, {}).c, 0.0);
  FlankModifications placed;  // no amount, but derivative() needs the start of the relief
  placed.tip_relief.reach = 46.0;
  const auto ready = make_removal_field(placed, kGear);
  ASSERT_TRUE(ready);
  EXPECT_TRUE(ready->none());
  EXPECT_EQ(ready->pieces().size(), 2u);
  EXPECT_GT(ready->derivative(P::tip_relief, std::log(23.5), 0, ready->pieces()[1].piece).c, 0.5);
}

// A relief that starts at an end of the flank, or where the other relief starts, adds no border.
TEST(RemovalField, has_no_slivers) {
  FlankModifications m;
  m.tip_relief = {0.01, 2 * kGear.rho_root_form, ReliefShape::parabolic};
  m.end_relief = {0.01, kGear.face_width / 2, ReliefShape::linear};
  const auto whole = make_removal_field(m, kGear);
  ASSERT_TRUE(whole) << whole.error().message();
  ASSERT_EQ(whole->pieces().size(), 2u);
  EXPECT_EQ(whole->pieces()[0].piece, (Field::Piece{true, false, true, false}));
  EXPECT_EQ(whole->pieces()[1].piece, (Field::Piece{true, false, false, true}));
  m.tip_relief.reach = 44.0;
  m.root_relief = {0.01, 44.0 + 1e-13, ReliefShape::linear};
  const auto shared = make_removal_field(m, kGear);
  ASSERT_TRUE(shared);
  EXPECT_EQ(shared->kinks_u().size(), 1u);
  m.root_relief.reach = 46.0;  // both apply between 44 and 46
  const auto overlapping = make_removal_field(m, kGear);
  ASSERT_TRUE(overlapping);
  EXPECT_EQ(overlapping->pieces()[2].piece, (Field::Piece{true, true, true, false}));
}

std::string refusal_of(const FlankModifications& m, const FlankExtent& e = kGear) {
  const auto field = make_removal_field(m, e);
  if (field) return "";
  const Error& error = field.error();
  EXPECT_EQ(error.message().rfind(error.field, 0), 0u) << error.message();
  return error.field;
}

TEST(RemovalField, refuses_what_does_not_fit_and_names_it) {
  const auto tip = [](double amount, std::optional<double> start) {
    return FlankModifications{.tip_relief = {amount, start, ReliefShape::linear}};
  };
  EXPECT_EQ(refusal_of(tip(0.02, 46.0)), "");
  EXPECT_EQ(refusal_of(tip(0.02, std::nullopt)), "tip_relief.reach");
  EXPECT_EQ(refusal_of(tip(0.02, 40.9)), "tip_relief.reach");
  EXPECT_EQ(refusal_of(tip(0.02, 47.5)), "tip_relief.reach");
  EXPECT_EQ(refusal_of(tip(0.02, 48.0)), "tip_relief.reach");
  EXPECT_EQ(refusal_of(tip(-0.02, 46.0)), "tip_relief.amount");
  EXPECT_EQ(refusal_of(tip(NAN, 46.0)), "tip_relief.amount");
  EXPECT_EQ(refusal_of(tip(0.4, 41.0)), "tip_relief.amount");  // a tenth of the flank is 0.325 mm
  EXPECT_EQ(refusal_of(tip(0.3, 41.0)), "");
  EXPECT_EQ(refusal_of(tip(0.0999, 46.5)), "");  // 0.5 mm deep, at most 1 in 5
  EXPECT_EQ(refusal_of(tip(0.1001, 46.5)), "tip_relief.amount");
  FlankModifications m = tip(0.0501, 46.5);
  m.tip_relief.shape = ReliefShape::parabolic;  // the slope at the end doubles
  EXPECT_EQ(refusal_of(m), "tip_relief.amount");
  // The tip relief of an internal gear starts outside its tip circle.
  EXPECT_EQ(refusal_of(tip(0.02, 126.0), kRing), "");
  EXPECT_EQ(refusal_of(tip(0.02, 124.0), kRing), "tip_relief.reach");
  EXPECT_EQ(refusal_of(tip(0.02, 123.0), kRing), "tip_relief.reach");
  m = {};
  m.root_relief = {0.02, 41.0, ReliefShape::linear};
  EXPECT_EQ(refusal_of(m), "root_relief.reach");
  m = {.end_relief = {0.02, 12.6, ReliefShape::linear}};
  EXPECT_EQ(refusal_of(m), "end_relief.reach");
  m.end_relief.reach = 0.09;
  EXPECT_EQ(refusal_of(m), "end_relief.amount");
  m = {};
  m.profile_crowning = -0.3;  // hollow
  m.lead_slope = -0.3;
  EXPECT_EQ(refusal_of(m), "");
  m.lead_slope = -0.33;
  EXPECT_EQ(refusal_of(m), "lead_slope");
  EXPECT_EQ(make_removal_field(m, kGear).error().value, "-330");
  m.lead_slope = NAN;
  EXPECT_EQ(refusal_of(m), "lead_slope");
  for (const FormWave& wave : {FormWave{2, 0.0, -0.008}, {-1, 0.0, 0.008}, {1, 0.0, NAN}})
    EXPECT_EQ(refusal_of({.helix_wave = wave}).substr(0, 11), "helix_wave.");
}

TEST(RemovalField, refuses_a_topography_that_does_not_cover_the_flank) {
  const auto with = [](std::shared_ptr<const Topography> t) {
    return FlankModifications{.topography = std::move(t)};
  };
  EXPECT_EQ(refusal_of(with(tilted(41.0, 47.5, 12.5))), "");
  EXPECT_EQ(refusal_of(with(tilted(41.001, 47.5, 12.5))), "topography");
  EXPECT_EQ(refusal_of(with(tilted(41.0, 47.5, 12.4))), "topography");
  EXPECT_EQ(make_removal_field(with(tilted(41.0, 47.499, 12.5)), kGear).error().value, "");
  auto high = std::make_shared<Topography>(*tilted(41.0, 47.5, 12.5));
  high->removed[7] = 0.4;
  EXPECT_EQ(refusal_of(with(high)), "topography");
}

TEST(RemovalFieldDeathTest, a_piece_that_is_not_there_is_a_mistake) {
  const auto field = make_removal_field({}, kGear);
  ASSERT_TRUE(field);
  GW_EXPECT_VIOLATION((void)field->derivative(P::tip_relief, 3.1, 0.0, {.tip = true}));
}

}  // namespace
}  // namespace gearwright
