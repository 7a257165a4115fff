// Laws: (1) without a change, `value` and `max_pressure` equal the results of loaded_contact()
// (2) `slope` is the derivative of `value`   (3) for a small change, `value` agrees with
// loaded_contact() for the changed pair within a few percent of the effect.
#include "gearwright/load/nearby_load.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "gearwright/base/units.hpp"
#include "gearwright/contact/contact_setup.hpp"
#include "gearwright/contact/corrections.hpp"

namespace gearwright {
namespace {

struct Teeth {
  std::string name;
  ContactSetup setup;
  LoadRequest request;
  PairCompliance compliance;
};

// Crowned teeth with a linear tip relief, on axes that cross slightly.
Teeth teeth(int z1, int z2, double helix_deg, double face_width = 24.0, int slices = 10) {
  std::array<CylindricalSpec, 2> specs;
  std::array<std::optional<Gear>, 2> gears;
  PairModifications modifications{};
  for (const std::size_t i : {0, 1}) {
    specs[i].teeth = i == 0 ? z1 : z2;
    specs[i].normal_module = 3.0;
    specs[i].helix_angle = Angle::degrees(i == 0 || z2 < 0 ? helix_deg : -helix_deg);
    specs[i].face_width = face_width;
    specs[i].thickness_allowance = -0.05;
    gears[i] = make_gear(specs[i]).value();
    const double root = *gears[i]->root_form_radius(), tip = gears[i]->tip_form_radius();
    FlankModifications m;
    m.tip_relief = {0.015, 2 * (root + 0.7 * (tip - root)), ReliefShape::linear};
    m.lead_crowning = 0.004;
    modifications[i] = {m, m};
  }
  ContactErrors errors;
  errors.crossing = Angle::degrees(0.02);
  const auto pair = mount(*gears[0], *gears[1], {});
  EXPECT_TRUE(pair) << pair.error().message();
  Teeth t{std::to_string(z1) + ":" + std::to_string(z2) + " " + std::to_string(helix_deg),
          ContactSetup::of(*pair, errors, modifications).value(),
          {},
          {}};
  t.request.torques = {60e3, 250e3};
  t.request.positions = 6;
  t.request.slices = {slices, slices};
  t.request.accuracy = ComplianceAccuracy::draft;
  t.request.root_stress = false;
  for (const int which : {1, 2})
    t.request.bodies[static_cast<std::size_t>(which - 1)] = {
        (which == 2 && z2 < 0 ? 1.2 : 0.5) * std::abs(t.setup.gear(which).root_diameter), 0.3,
        206000.0};
  t.compliance = pair_compliance(t.setup.gear(1), t.setup.gear(2), t.request).value();
  return t;
}

const std::vector<WorkshopCorrection> kAll{
    {Modification::lead_slope, 1},    {Modification::lead_crowning, 2},
    {Modification::profile_slope, 1}, {Modification::profile_crowning, 2},
    {Modification::tip_relief, 1},    {Modification::tip_relief, 2}};

NearbyLoad nearby(const Teeth& t, const ContactSetup& setup) {
  std::vector<Influence> influences;
  for (const WorkshopCorrection& c : kAll) influences.push_back(*influence_of(c));
  return NearbyLoad(setup.pair(false), setup.gear(1), setup.gear(2), t.compliance, t.request,
                    influences);
}

ContactSetup changed(const Teeth& t, const std::vector<double>& um) {
  return t.setup.changed(change_of(kAll, um, false)).value();
}

// The greatest peak to peak over the torques, rad, and the greatest pressure, MPa.
NearbyLoad::Span exact_span(const Teeth& t, const std::vector<double>& um) {
  const ContactSetup setup = changed(t, um);
  NearbyLoad::Span worst{0.0, {}};
  for (const LoadedTorque& torque :
       loaded_contact(setup.pair(false), setup.gear(1), setup.gear(2), t.compliance, t.request)
           .torques) {
    worst.value = std::max(*worst.value, torque.peak_to_peak.rad());
    worst.max_pressure = std::max(worst.max_pressure, torque.max_pressure);
  }
  return worst;
}
double exact(const Teeth& t, const std::vector<double>& um) { return *exact_span(t, um).value; }

class NearbyLoads : public ::testing::Test {
 protected:
  static const std::vector<Teeth>& all() {
    static const std::vector<Teeth> kTeeth{teeth(25, 43, 0), teeth(25, 43, 16)};
    return kTeeth;
  }
  const std::vector<double> none_ = std::vector<double>(kAll.size(), 0.0);
};

TEST_F(NearbyLoads, WithoutAChangeItIsLoadedContact) {
  for (const Teeth& t : all()) {
    const NearbyLoad::Span found = nearby(t, t.setup).span(none_, false);
    const NearbyLoad::Span expected = exact_span(t, none_);
    EXPECT_NEAR(*found.value, *expected.value, 1e-9 * *expected.value) << t.name;
    EXPECT_NEAR(found.max_pressure, expected.max_pressure, 1e-9 * found.max_pressure) << t.name;
  }
}

// While a wide helical tooth enters the mesh, most of it is far from the other gear, and the matrix
// of all its places is indefinite.
TEST_F(NearbyLoads, SolvesTeethThatAreMostlyFar) {
  const Teeth t = teeth(21, 55, 12, 38.0, 31);
  const double expected = exact(t, none_);
  EXPECT_NEAR(*nearby(t, t.setup).span(none_, false).value, expected, 1e-9 * expected);
}

TEST_F(NearbyLoads, SlopesAreThoseOfDifferences) {
  for (const Teeth& t : all()) {
    const NearbyLoad near = nearby(t, t.setup);
    const auto slope = near.span(none_, true).slope;
    double steepest = 0.0;
    for (const double s : slope) steepest = std::max(steepest, std::abs(s));
    for (std::size_t i = 0; i < kAll.size(); ++i) {
      constexpr double kStep = 1e-6;  // mm
      std::vector<double> above = none_, below = none_;
      above[i] = kStep;
      below[i] = -kStep;
      const double difference =
          (*near.span(above, false).value - *near.span(below, false).value) / (2 * kStep);
      EXPECT_NEAR(slope[i], difference, 1e-5 * steepest) << t.name << ", correction " << i;
    }
  }
}

// Laws of tangents(), without and after a change. The square of the pressure is compared with that
// of span(), whose pressure is not differentiated.
TEST_F(NearbyLoads, TangentsAreThoseOfDifferences) {
  constexpr double kStep = 1e-6;  // mm
  for (const Teeth& t : all()) {
    const NearbyLoad near = nearby(t, t.setup);
    for (const double um : {0.0, 1.5}) {
      const std::vector<double> change(kAll.size(), um * kMmPerUm);
      const auto tangents = near.tangents(change);
      ASSERT_TRUE(tangents);
      const Eigen::VectorXd none = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(kAll.size()));
      const Tangent span = tangents->span(none), square = tangents->pressure_squared(none);
      const NearbyLoad::Span here = near.span(change, false);
      EXPECT_NEAR(span.value, *here.value, 1e-12 * span.value);
      EXPECT_NEAR(square.value, here.max_pressure * here.max_pressure, 1e-12 * square.value);
      for (std::size_t i = 0; i < kAll.size(); ++i) {
        std::vector<double> above = change, below = change;
        above[i] += kStep;
        below[i] -= kStep;
        const NearbyLoad::Span hi = near.span(above, false), lo = near.span(below, false);
        const auto k = static_cast<Eigen::Index>(i);
        EXPECT_NEAR(span.slope[k], (*hi.value - *lo.value) / (2 * kStep),
                    1e-5 * span.slope.cwiseAbs().maxCoeff())
            << t.name << ", correction " << i;
        EXPECT_NEAR(
            square.slope[k],
            (hi.max_pressure * hi.max_pressure - lo.max_pressure * lo.max_pressure) / (2 * kStep),
            1e-5 * square.slope.cwiseAbs().maxCoeff())
            << t.name << ", correction " << i;
        // After a small step, the tangents have the value of the changed contact.
        Eigen::VectorXd step = none;
        step[k] = kStep;
        EXPECT_NEAR(tangents->span(step).value, *hi.value, 1e-7 * span.value);
      }
    }
  }
}

// The places of least gap move, but compliance and curvature keep their values for e = 0.
TEST_F(NearbyLoads, AChangeIsThatOfLoadedContactToAFewPercent) {
  const std::vector<double> um{2, 3, -2, 1.5, 4, -3};
  for (const Teeth& t : all()) {
    std::vector<double> change;
    for (const double v : um) change.push_back(v * kMmPerUm);
    const double before = exact(t, none_);
    const double after = exact(t, um);
    EXPECT_NEAR(*nearby(t, t.setup).span(change, false).value, after,
                0.06 * std::abs(after - before))
        << t.name << " from " << before;
    // If the changed teeth are the start of the estimate (e = 0), the result is exact again.
    EXPECT_NEAR(*nearby(t, changed(t, um)).span(none_, false).value, after, 1e-9 * after) << t.name;
  }
}

}  // namespace
}  // namespace gearwright
