// Laws of the contact of a pinion and a rack.  theory: docs/theory/08-contact.md, 8.11
#include "gearwright/contact/rack_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gearwright/contact/testing/sample_pairs.hpp"

namespace gearwright {
namespace {

constexpr double kUm = 1e-3;  // mm

RackPair rack_pair(double helix_deg, double allowance = -0.05,
                   std::optional<double> distance = {}) {
  const Gear pinion = testing::involute_gear(17, helix_deg, 20);
  return std::move(
             mount_rack(pinion, {.face_width = 18, .thickness_allowance = allowance}, distance))
      .take();
}

FlankModifications crowned_flank() {
  FlankModifications m;
  m.lead_crowning = 8 * kUm;
  m.profile_crowning = 5 * kUm;
  return m;
}

ContactErrors misaligned() {
  ContactErrors e;
  e.center_distance = 0.1;
  e.crossing = Angle::degrees(0.03);
  e.intersecting = Angle::degrees(-0.05);
  return e;
}

// (1) Without errors, travel and rotation are proportional at every centre distance. The rack lags
// by half of the backlash. If it drives, it leads by half of the backlash.
TEST(RackContact, TransmitsMotionExactlyWithoutErrors) {
  for (const double helix : {0.0, 20.0, -35.0}) {
    for (const double more : {0.0, 0.4}) {
      const RackPair nominal = rack_pair(helix);
      const RackPair pair = rack_pair(helix, -0.05, nominal.center_distance + more);
      for (const bool rack_drives : {false, true}) {
        ContactOptions options;
        options.gear2_drives = rack_drives;
        const auto found = contact(pair, {}, options);
        ASSERT_TRUE(found) << found.error().message();
        EXPECT_FALSE(found->contact_lost);
        const double play = pair.circumferential_backlash();
        for (const ContactPoint& p : found->positions) {
          EXPECT_EQ(p.kind, TouchKind::line);
          EXPECT_NEAR(found->rack.of(p.te), (rack_drives ? 0.5 : -0.5) * play, 1e-12);
        }
        EXPECT_NEAR(found->rack.of(*found->min_play), play, 1e-12);
        EXPECT_NEAR(found->rack.of(*found->continuous_span), 0.0, 1e-12);
      }
    }
  }
}

// (2) With errors and modifications, the difference between the results for a wheel with z2 teeth
// and for the rack decreases like 1/z2.
TEST(RackContact, IsTheLimitOfWheels) {
  for (const double helix : {0.0, 20.0}) {
    const RackPair pair = rack_pair(helix, 0.0);
    ContactOptions options;
    options.modifications[0] = on_both_flanks(crowned_flank());
    const ContactErrors errors = misaligned();
    const auto rack = contact(pair, errors, options);
    ASSERT_TRUE(rack) << rack.error().message();
    const auto difference = [&](int teeth) {
      testing::SamplePair p = testing::involutes(17, teeth, helix);
      p.gears[0] = pair.pinion;
      p.modify(1, crowned_flank());
      p.place.errors = errors;
      const ContactResult wheel = analyse_contact(p.pair(), {});
      const double r_2 = p.gears[1].reference_diameter / 2;
      double most = 0.0;
      for (std::size_t i = 0; i < wheel.positions.size(); ++i) {
        const double travel = wheel.positions[i].te.rad() * r_2;
        most = std::max(most, std::abs(rack->rack.of(rack->positions[i].te) - travel));
      }
      return most;
    };
    const double at_1000 = difference(1000);
    EXPECT_LT(at_1000, 1 * kUm);
    EXPECT_GT(at_1000, 1e-9);
    EXPECT_NEAR(difference(2000) / at_1000, 0.5, 0.02);
  }
}

// An oracle: nested grids find the least travel at which no point of the pinion's flank lies inside
// the rack, in the housing frame with gear 1 driving. No function of contact/ is used.
class Slow {
 public:
  Slow(const RackPair& pair, const ContactErrors& errors) : pair_(pair), e_(errors) {
    for (const Arc& arc : pair.pinion.tooth->outline.arcs)
      if (arc.name == ArcName::flank) flank_ = &arc;
  }
  double travel_error(double phi) const {
    double best = -std::numeric_limits<double>::infinity();
    const double pitch = 2 * std::numbers::pi / pair_.pinion.spec.teeth;
    for (int k = -3; k <= 3; ++k) best = std::max(best, of_tooth(phi - k * pitch));
    return best;
  }

 private:
  double of_tooth(double phi) const {
    constexpr int kCells = 40;
    const double b = pair_.pinion.spec.face_width / 2;
    double t_lo = flank_->begin, t_hi = flank_->end, z_lo = -b, z_hi = b;
    double best = -std::numeric_limits<double>::infinity();
    double t_at = 0.5 * (t_lo + t_hi), z_at = 0.5 * (z_lo + z_hi);
    for (int round = 0; round < 30; ++round) {
      for (int i = 0; i <= kCells; ++i) {
        for (int j = 0; j <= kCells; ++j) {
          const double t = t_lo + (t_hi - t_lo) * i / kCells, z = z_lo + (z_hi - z_lo) * j / kCells;
          if (const double x = travel_of(t, z, phi); x > best) best = x, t_at = t, z_at = z;
        }
      }
      if (!std::isfinite(best)) return best;
      const auto closer = [](double& lo, double& hi, double at) {
        const double half = 0.3 * (hi - lo);
        lo = std::max(lo, at - half);
        hi = std::min(hi, at + half);
      };
      t_lo > t_hi ? closer(t_hi, t_lo, t_at) : closer(t_lo, t_hi, t_at);
      closer(z_lo, z_hi, z_at);
    }
    return best;
  }
  double travel_of(double t, double z, double phi) const {
    const Gear& g = pair_.pinion;
    const RackGeometry& rack = pair_.rack;
    const double r = g.reference_diameter / 2;
    const Vec2 w = flank_->curve->point(t);
    const Complex turned =
        Complex(w.x(), -w.y()) * std::polar(1.0, g.twist() * z - phi);  // the right flank
    Vec3 p(turned.real(), turned.imag(), z);
    const double c = std::cos(e_.intersecting.rad()), s = std::sin(e_.intersecting.rad());
    p = Vec3(p.x() * c + p.z() * s, p.y(), -p.x() * s + p.z() * c);
    const double cc = std::cos(e_.crossing.rad()), sc = std::sin(e_.crossing.rad());
    p = Vec3(p.x(), p.y() * cc + p.z() * sc, -p.y() * sc + p.z() * cc);
    const double h = pair_.center_distance + e_.center_distance - p.x();
    if (h > rack.addendum || h < -rack.form_depth() || std::abs(p.z()) > rack.face_width / 2)
      return -std::numeric_limits<double>::infinity();
    const double s_t = rack.thickness / std::cos(rack.helix_angle.rad());
    const double tan_t = std::tan(g.reference().transverse_pressure_angle);
    const double flank =
        (s_t - rack.transverse_pitch) / 2 - h * tan_t + p.z() * std::tan(-rack.helix_angle.rad());
    return flank - p.y() - r * phi;
  }

  const RackPair& pair_;
  ContactErrors e_;
  const Arc* flank_ = nullptr;
};

TEST(RackContact, AgreesWithNestedGrids) {
  for (const double helix : {0.0, 20.0, -12.0}) {
    const RackPair pair = rack_pair(helix);
    const Slow slow(pair, misaligned());
    ContactOptions options;
    options.request.positions = 8;
    const auto found = contact(pair, misaligned(), options);
    ASSERT_TRUE(found) << found.error().message();
    for (const ContactPoint& p : found->positions)
      EXPECT_NEAR(found->rack.of(p.te), slow.travel_error(p.rotation1.rad()), 1e-7)
          << helix << " " << p.rotation1.deg() << " " << to_string(p.kind);
  }
}

// The mirror image of a pair in the plane z = 0 under mirrored errors has the same transmission
// error.
TEST(RackContact, BothHandsAreMirrorImages) {
  ContactOptions options;
  options.modifications[0] = on_both_flanks(crowned_flank());
  ContactErrors errors = misaligned();
  const auto right = contact(rack_pair(25), errors, options);
  errors.crossing = -errors.crossing;
  errors.intersecting = -errors.intersecting;
  const auto left = contact(rack_pair(-25), errors, options);
  ASSERT_TRUE(right && left);
  for (std::size_t i = 0; i < right->positions.size(); ++i)
    EXPECT_NEAR(right->rack.of(right->positions[i].te), left->rack.of(left->positions[i].te),
                1e-11);
}

// If the rack drives, it touches the other flanks. The mirror image in the plane y = 0 exchanges
// the flanks and reverses both motions.
TEST(RackContact, TheRackDrivesAsTheMirrorImageIsDriven) {
  ContactOptions options;
  options.modifications[0] = on_both_flanks(crowned_flank());
  ContactErrors errors = misaligned();
  const auto driven = contact(rack_pair(25), errors, options);
  errors.crossing = -errors.crossing;
  options.gear2_drives = true;
  const auto driving = contact(rack_pair(-25), errors, options);
  ASSERT_TRUE(driven && driving);
  const std::size_t n = driven->positions.size();
  for (std::size_t i = 1; i < n; ++i)
    EXPECT_NEAR(driving->rack.of(driving->positions[i].te),
                -driven->rack.of(driven->positions[n - i].te), 1e-11);
}

TEST(RackContact, ErrorsOfTheRacksTeethAreRejected) {
  ContactErrors errors;
  errors.helix_twist[1] = 1e-4;
  const auto found = contact(rack_pair(20), errors);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().field, "errors.helix_twist[1]");
}

}  // namespace
}  // namespace gearwright
