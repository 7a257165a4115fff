// Corrections are compared with the best of a dense scan, with closed forms, and with no
// correction.
#include "gearwright/contact/compensation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>

#include "gearwright/base/testing/violation.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

using testing::SamplePair;

// A pair with the modifications `drawn` of gear 1 and with the errors of each scenario. The
// corrections are the helix slope and the helix crowning of gear 1, µm.
struct Case {
  SamplePair sample;
  FlankModifications drawn{};
  std::vector<ContactErrors> scenarios;

  std::shared_ptr<const ContactPair> pair(const std::vector<double>& um, int s) const {
    struct Held {
      SamplePair sample;
      std::optional<ContactPair> pair;
    };
    const auto held = std::make_shared<Held>(Held{sample, std::nullopt});
    FlankModifications m = drawn;
    m.lead_slope += um[0] * kMmPerUm;
    if (um.size() > 1) m.lead_crowning += um[1] * kMmPerUm;
    held->sample.modify(1, m);
    held->sample.place.errors = scenarios[static_cast<std::size_t>(s)];
    held->pair.emplace(held->sample.pair());
    return {held, &*held->pair};
  }

  CompensationTask task(std::size_t corrections) const {
    CompensationTask t;
    t.corrections = {{-60, 60, 2}, {0, 30, 2}};
    t.corrections.resize(corrections);
    t.scenarios = static_cast<int>(scenarios.size());
    t.positions = t.fine_positions = 12;
    t.pair_at = [this](const std::vector<double>& um, int s) { return pair(um, s); };
    return t;
  }
};

ContactScore score_of(const ContactPair& pair, int positions) {
  return contact_curve(pair, positions, {}).score;
}

// f of [T8.24], computed again from curves only; infinite for corrections that are not allowed.
double value_of(const Case& c, const CompensationTask& t, const std::vector<double>& um, double w,
                double limit) {
  ContactScore worst;
  for (int s = 0; s < t.scenarios; ++s)
    take_worst(worst, score_of(*c.pair(um, s), t.fine_positions));
  if (worst.lost || worst.span->rad() > limit) return std::numeric_limits<double>::infinity();
  return worst.span->rad() + w * worst.pattern_middle * worst.pattern_middle;
}

Case crowned(double helix_deg, double crossing_deg) {
  Case c;
  c.sample = testing::involutes(20, 41, helix_deg);
  c.drawn.lead_crowning = 0.008;
  c.scenarios.emplace_back();
  c.scenarios[0].crossing = Angle::degrees(crossing_deg);
  return c;
}

// A lead error κ turns the section at z by κz. A helix slope C turns it by (C z/b)/(r_b cos β_b),
// where r_b cos β_b is the moment arm of the normal [T8.7]. Only one value of C cancels κ.
TEST(Compensation, a_lead_error_asks_for_its_own_slope) {
  Case c = crowned(15, 0);
  const Gear& g = c.sample.gears[0];
  const double kappa = 0.012 / (g.reference_diameter / 2 * g.spec.face_width);
  c.scenarios[0].helix_twist[0] = kappa;
  const double arm = g.base_radius() / std::sqrt(1 + std::pow(g.base_radius() * g.twist(), 2));
  const double slope_um = kappa * g.spec.face_width * arm * kUmPerMm;
  const Compensation found = compensate(c.task(1));
  EXPECT_NEAR(std::abs(found.value[0]), slope_um, 0.05);
  EXPECT_FALSE(found.nothing_to_correct());
  Case none = crowned(15, 0);
  EXPECT_NEAR(found.after.peak_to_peak.arcsec(),
              score_of(*none.pair({0.0}, 0), 12).peak_to_peak.arcsec(), 0.01);
  EXPECT_GT(std::abs(found.before.along_face), 0.2);
  EXPECT_LT(std::abs(found.after.along_face), 0.02);
}

// For an uncrowned pair, one helix slope has exactly the opposite effect of the error and removes
// it completely. Crowning then has nothing to improve.
TEST(Compensation, uncrowned_flanks_need_no_crowning) {
  for (const double error_um : {-40.0, 10.0}) {
    Case c;
    c.sample = testing::involutes(27, 71, 18);
    c.scenarios.emplace_back();
    const Gear& g = c.sample.gears[0];
    const double kappa = error_um * kMmPerUm / (g.reference_diameter / 2 * g.spec.face_width);
    c.scenarios[0].helix_twist[0] = kappa;
    const double arm = g.base_radius() / std::sqrt(1 + std::pow(g.base_radius() * g.twist(), 2));
    const Compensation found = compensate(c.task(2));
    EXPECT_NEAR(std::abs(found.value[0]), std::abs(kappa) * g.spec.face_width * arm * kUmPerMm,
                0.1);
    EXPECT_EQ(found.value[1], 0.0);
    EXPECT_LT(found.after.span->arcsec(), 0.01);
  }
}

// If several slopes within a range have the same continuous transmission error, the slope with the
// contact nearest to the middle of the face is chosen. A scan over the slopes finds this slope by
// the place of the contact alone.
TEST(Compensation, equal_errors_are_decided_by_the_place) {
  for (const double crossing : {0.02, -0.04}) {
    Case c = crowned(18, crossing);
    c.drawn.profile_crowning = 0.004;
    CompensationTask t = c.task(2);
    t.positions = t.fine_positions = 32;
    const Compensation found = compensate(t);
    double middle = 0.0, least = 1.0;
    for (double um = -40; um <= 40; um += 0.5) {
      const double place = std::abs(score_of(*c.pair({um}, 0), 32).along_face);
      if (place < least) {
        least = place;
        middle = um;
      }
    }
    EXPECT_GT(std::abs(middle), 4);
    EXPECT_NEAR(found.value[0], middle, 0.8) << crossing;
    EXPECT_EQ(found.value[1], 0.0);
    EXPECT_LE(*found.after.span, *found.before.span + kSameError);
    EXPECT_GT(std::abs(found.before.along_face), 0.15);
  }
}

// If the gap grows linearly from one end of the face, the mean place has the closed form
// coth(k) − 1/k, where 2k is the gap at the other end in µm. The common face is 18 mm of 20 mm.
TEST(ContactScore, the_place_of_a_pattern) {
  for (const double um : {0.0, 0.3, 2.0, 20.0}) {
    Case c;
    c.sample = testing::involutes(20, 41, 0);
    c.scenarios.emplace_back();
    const double k = 0.5 * um * 18 / 20;
    EXPECT_NEAR(std::abs(score_of(*c.pair({um}, 0), 12).pattern_middle),
                um == 0.0 ? 0.0 : 1 / std::tanh(k) - 1 / k, 0.01)
        << um;
  }
}

// In 50 seeded cases, f is within 2 % of the least value of a dense scan.
TEST(Compensation, is_the_best_of_a_dense_scan) {
  std::mt19937 random(8);
  const auto between = [&](double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
  };
  for (int k = 0; k < 50; ++k) {
    Case c;
    c.sample = testing::involutes(15 + k % 13, 30 + 7 * k % 40, k % 3 == 0 ? 0 : between(5, 25));
    c.drawn.lead_crowning = between(0.001, 0.01);
    for (int s = 0; s < 1 + k % 2; ++s) {
      ContactErrors e;
      e.crossing = Angle::degrees(between(-0.06, 0.06));
      e.intersecting = Angle::degrees(between(-0.03, 0.03));
      e.center_distance = between(0, 0.05);
      c.scenarios.push_back(e);
    }
    CompensationTask t = c.task(1 + static_cast<std::size_t>(k % 4 == 0));
    if (k % 5 == 0) t.centering = Angle::arcseconds(between(0, 5));
    const Compensation found = compensate(t);
    const double w = found.centering.rad();
    EXPECT_EQ(w, t.centering.value_or(default_centering(found.before.peak_to_peak)).rad());
    const double limit = t.centering
                             ? std::numeric_limits<double>::infinity()
                             : std::max((*found.before.span + kSameError).rad(), kQuiet.rad());
    const std::vector<double> zero(t.corrections.size(), 0.0);
    double least = value_of(c, t, zero, w, limit);
    const double mine = value_of(c, t, found.value, w, limit);
    EXPECT_LE(mine, least) << "case " << k << ": worse than no correction";
    const int n = t.corrections.size() == 1 ? 240 : 30;
    for (int i = 0; i <= n; ++i) {
      std::vector<double> v{-60 + 120.0 * i / n};
      for (int j = 0; j <= (zero.size() == 1 ? 0 : n / 2); ++j) {
        if (zero.size() > 1) {
          v.resize(2);
          v[1] = 60.0 * j / n;
        }
        least = std::min(least, value_of(c, t, v, w, limit));
      }
    }
    EXPECT_LE(mine, 1.02 * least + kSameError.rad()) << "case " << k;
  }
}

// By default, corrections must not increase the transmission error. If the user gives w, a greater
// transmission error is accepted for a more central pattern.
TEST(Compensation, quiet_running_is_traded_on_request_alone) {
  Case c = crowned(12, 0);
  c.drawn.lead_crowning = 0.006;
  for (const double crossing : {-0.01, 0.04}) {
    ContactErrors e;
    e.crossing = Angle::degrees(crossing);
    e.intersecting = Angle::degrees(-0.01);
    c.scenarios.push_back(e);
  }
  CompensationTask t = c.task(2);
  const Compensation kept = compensate(t);
  EXPECT_LE(*kept.after.span, *kept.before.span + kSameError);
  t.centering = Angle::arcseconds(20);
  const Compensation traded = compensate(t);
  EXPECT_GT(*traded.after.span, *kept.after.span);
  EXPECT_LT(std::abs(traded.after.along_face), std::abs(kept.after.along_face));
  EXPECT_EQ(traded.centering, *t.centering);
}

TEST(Compensation, a_perfect_pair_needs_none) {
  Case c = crowned(15, 0);
  c.drawn.lead_crowning = 0.0;
  const Compensation found = compensate(c.task(2));
  EXPECT_TRUE(found.nothing_to_correct());
  for (const double v : found.value) EXPECT_TRUE(v == 0.0 && !std::signbit(v));
  EXPECT_EQ(found.after.peak_to_peak, Angle());
  EXPECT_EQ(found.after.along_face, 0.0);
}

// Each value is the double nearest to its decimal number: 0.29, not 0.29000000000000004.
TEST(Compensation, values_are_decimals) {
  for (const double crossing : {-0.03, 0.011, 0.05}) {
    for (const double v : compensate(crowned(15, crossing).task(2)).value) {
      EXPECT_EQ(v, std::round(v * 50) / 50) << v;
      EXPECT_FALSE(v == 0.0 && std::signbit(v));
    }
  }
}

TEST(Compensation, bounds_hold) {
  Case c = crowned(15, 0.05);
  CompensationTask t = c.task(1);
  const double free = compensate(t).value[0];
  ASSERT_GT(std::abs(free), 4);
  t.corrections[0] = {free > 0 ? -1.0 : -3.33, free > 0 ? 3.33 : 1.0, 2};
  t.centering = Angle::arcseconds(1);
  const Compensation bound = compensate(t);
  EXPECT_LE(std::abs(bound.value[0]), 3.33);
  EXPECT_EQ(free > 0, bound.value[0] > 0);
  const double at_bound = value_of(c, t, {free > 0 ? 3.33 : -3.33}, t.centering->rad(), 1.0);
  EXPECT_LE(value_of(c, t, bound.value, t.centering->rad(), 1.0), at_bound + kSameError.rad());
}

TEST(Compensation, what_cannot_be_is_never_chosen) {
  Case c = crowned(15, 0.03);
  CompensationTask t = c.task(1);
  t.pair_at = [&](const std::vector<double>& um, int s) {
    return um[0] == 0.0 ? c.pair(um, s) : nullptr;
  };
  EXPECT_TRUE(compensate(t).nothing_to_correct());
}

TEST(Compensation, contracts) {
  Case c = crowned(15, 0.03);
  const CompensationTask good = c.task(1);
  const auto dies = [&](auto change) {
    CompensationTask bad = good;
    change(bad);
    GW_EXPECT_VIOLATION(compensate(bad));
  };
  dies([](CompensationTask& t) { t.corrections.clear(); });
  dies([](CompensationTask& t) { t.scenarios = 0; });
  dies([](CompensationTask& t) { t.positions = 1; });
  dies([](CompensationTask& t) { t.fine_positions = 1; });
  dies([](CompensationTask& t) { t.corrections[0].lo = 1; });
  dies([](CompensationTask& t) { t.corrections[0].hi = -1; });
  dies([](CompensationTask& t) { t.corrections[0].lo = t.corrections[0].hi = 0; });
  dies([](CompensationTask& t) { t.corrections[0].step = 0; });
}

TEST(ContactScore, tips_that_pass_have_none) {
  SamplePair p = testing::involutes(20, 41, 0);
  p.place.errors.center_distance = 5.0;
  const ContactScore lost = score_of(p.pair(), 8);
  EXPECT_TRUE(lost.nothing_touches() && lost.lost);
  p.place.errors.center_distance = 3.7;
  const ContactScore some = score_of(p.pair(), 32);
  EXPECT_TRUE(!some.nothing_touches() && some.lost);
  EXPECT_TRUE(std::isfinite(some.peak_to_peak.rad()));
}

TEST(ContactScore, the_worst_of_two) {
  ContactScore a{Angle::arcseconds(2), -0.5, 0.1, 0.25, false};
  const ContactScore b{Angle::arcseconds(1), 0.4, -0.2, 0.5, true};
  take_worst(a, b);
  EXPECT_EQ(a.peak_to_peak, Angle::arcseconds(2));
  EXPECT_EQ(a.along_face, -0.5);
  EXPECT_EQ(a.along_profile, -0.2);
  EXPECT_EQ(a.edge_share, 0.5);
  EXPECT_TRUE(a.lost);
  const ContactScore none{Angle::radians(std::nan("")), 0, 0, 0, true};
  for (const bool first : {true, false}) {
    ContactScore worst = first ? none : b;
    take_worst(worst, first ? b : none);
    EXPECT_TRUE(worst.nothing_touches());
  }
}

// A spur pair without crowning on crossed axes touches at the end of a face at all positions.
TEST(ContactScore, edges_are_counted) {
  SamplePair p = testing::involutes(20, 41, 0);
  p.place.errors.crossing = Angle::degrees(0.05);
  const ContactScore s = score_of(p.pair(), 16);
  EXPECT_EQ(s.edge_share, 1.0);
  EXPECT_GT(std::abs(s.along_face), 0.85);
  FlankModifications m;
  m.lead_crowning = 0.02;
  p.modify(1, m);
  EXPECT_LT(score_of(p.pair(), 16).edge_share, 0.5);
}

TEST(ContactScore, default_centering) {
  EXPECT_EQ(default_centering(Angle()), Angle::arcseconds(0.1));
  EXPECT_EQ(default_centering(Angle::radians(std::nan(""))), Angle::arcseconds(0.1));
  EXPECT_NEAR(default_centering(Angle::arcseconds(30)).arcsec(), 3, 1e-12);
}

}  // namespace
}  // namespace gearwright
