// Corrections under load are compared with a dense scan of all permitted values, and their laws are
// tested.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/job/compensate_answer.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {
namespace {

// Returns a misaligned helical pair with coarse tables.
std::string spec_of(const std::string& compensate, const std::string& torque = "250") {
  return R"(
[gear1]
teeth = 23
normal_module_mm = 3
helix_angle_deg = 12
face_width_mm = 30
[gear2]
teeth = 41
helix_angle_deg = -12
face_width_mm = 30
[pair]
backlash_mm = 0.1
[errors]
crossing_deg = 0.035
[load]
positions = 12
slices = 8
accuracy = "draft"
torque_Nm = )" +
         torque + "\n[compensate]\n" + compensate;
}

SolvedJob job_of(const std::string& text) {
  const auto spec = read_spec(text, SpecFormat::toml);
  EXPECT_TRUE(spec) << spec.error().message();
  return testing::taken(solve(*spec, Scope::pair));
}

double aimed(const LoadedScore& s, const std::string& aim) {
  return aim == "pressure" ? s.max_pressure : s.peak_to_peak.arcsec();
}

// Returns the results of a grid over helix slope and crowning of gear 1.
std::vector<LoadedScore> scanned(const std::string& text) {
  SolvedJob job = job_of(text);
  const auto load = LoadedAim::of(job, nullptr);
  EXPECT_TRUE(load) << load.error().message();
  const auto setup = setup_of(job);
  std::vector<LoadedScore> all;
  for (double slope = -40; slope <= 40; slope += 5) {
    for (double crowning = 0; crowning <= 24; crowning += 4) {
      SetupChange change;
      change.flank[0][Modification::lead_slope] = slope * kMmPerUm;
      change.flank[0][Modification::lead_crowning] = crowning * kMmPerUm;
      const auto changed = setup->changed(change);
      if (!changed) continue;  // the teeth cannot have this correction
      all.push_back(load->scores(changed->pair(false), load->positions()).front());
    }
  }
  return all;
}

// Returns a pair with a small module and a large error. Some of the corrections in their ranges are
// impossible for its teeth.
std::string small_spec_of(const std::string& compensate) {
  return R"(
[gear1]
teeth = 24
normal_module_mm = 0.3
face_width_mm = 5
[gear2]
teeth = 55
face_width_mm = 5
[errors]
crossing_deg = 0.7
[load]
positions = 12
slices = 8
accuracy = "draft"
torque_Nm = 0.1
[compensate]
)" + compensate;
}

void expect_the_best_of_a_scan(const std::function<std::string(const std::string&)>& spec_with) {
  const std::vector<LoadedScore> scan = scanned(spec_with("aim = \"pressure\"\n"));
  for (const std::string aim : {"loaded_transmission_error", "pressure"}) {
    const std::string text = spec_with("aim = \"" + aim + "\"\n");
    SolvedJob job = job_of(text);
    const auto answer = answer_compensate(job);
    ASSERT_TRUE(answer) << answer.error().message();
    ASSERT_EQ(answer->loads.size(), 1u);
    const double before = aimed(answer->loads[0].before, aim);
    const double after = aimed(answer->loads[0].after, aim);
    double least = before;
    for (const LoadedScore& s : scan) least = std::min(least, aimed(s, aim));
    EXPECT_LT(after, 1.02 * least) << aim << " from " << before;
    EXPECT_LT(after, 0.9 * before) << aim;
    // The reported numbers equal the results for the corrected spec.
    const auto again = read_spec_tree(answer->corrected->tables);
    ASSERT_TRUE(again) << again.error().message();
    auto solved = solve(*again, Scope::pair);
    ASSERT_TRUE(solved);
    SolvedJob with = std::move(solved).take();
    const auto load = answer_load(with);
    ASSERT_TRUE(load) << load.error().message();
    const LoadedTorque& t = load->contact->torques[0];
    EXPECT_NEAR(aimed({t.peak_to_peak, t.max_pressure}, aim), after, 1e-9 * after);
  }
}

TEST(CompensateLoad, FindsWhatADenseScanFinds) {
  expect_the_best_of_a_scan([](const std::string& compensate) { return spec_of(compensate); });
}

TEST(CompensateLoad, FindsWhatADenseScanFindsForSmallTeeth) {
  expect_the_best_of_a_scan(small_spec_of);
}

// The estimate of the aim around a pair equals the aim for the change 0, for both aims and at
// several corrections. A cutter lead has no estimate.
TEST(CompensateLoad, EstimatesAreExactAtTheirCenter) {
  const std::vector<WorkshopCorrection> which{{Modification::lead_slope, 1},
                                              {Modification::profile_crowning, 2}};
  for (const std::string aim : {"loaded_transmission_error", "pressure"}) {
    SolvedJob job = job_of(spec_of("aim = \"" + aim + "\"\n", "[40, 250]"));
    const auto load = LoadedAim::of(job, nullptr);
    ASSERT_TRUE(load) << load.error().message();
    const ContactSetup setup = with_fields_for(setup_of(job).value(), which);
    const CompensationTask task = compensation_task(setup, which, {setup.place().errors});
    const CompensationAim aimed = load->aim(task, load->scores_of(task), which);
    ASSERT_TRUE(aimed.near);
    for (const std::vector<double>& v : {std::vector{0.0, 0.0}, {15.0, 6.0}, {-30.0, 2.0}}) {
      const double exact = aimed.of(v, 0, 12);
      const CompensationAim::Estimate estimate = aimed.near(v, 0, 12);
      EXPECT_NEAR(estimate.value({0.0, 0.0}), exact, 1e-9 * exact) << aim;
      const double tangent = estimate.tangents({0.0, 0.0}).value;
      EXPECT_NEAR(aim == "pressure" ? std::sqrt(tangent) : tangent, exact, 1e-9 * exact) << aim;
    }
    EXPECT_FALSE(load->aim(task, load->scores_of(task), {{CutterSetting::cutter_lead, 1}}).near);
  }
}

// Law: the result is never worse than the spec without corrections, also for few positions and for
// the worst of several torques.
TEST(CompensateLoad, IsNeverWorseThanNothing) {
  for (const int curves : {1, 20}) {
    for (const std::string aim : {"loaded_transmission_error", "pressure"}) {
      SolvedJob job = job_of(spec_of(
          "aim = \"" + aim + "\"\ncorrections = [\"gear2.profile_crowning_um\"]\n", "[40, 250]"));
      const auto answer = answer_compensate(job, nullptr, curves);
      ASSERT_TRUE(answer) << answer.error().message();
      double before = 0.0;
      double after = 0.0;
      for (const AimedLoad& l : answer->loads) {
        before = std::max(before, aimed(l.before, aim));
        after = std::max(after, aimed(l.after, aim));
      }
      EXPECT_LE(after, before) << aim << " " << curves;
    }
  }
}

// Law: on these pairs, the aim is not greater than the aim that the former search (subplex) found,
// by more than the smallest improvement that justifies a correction (0.1 MPa, 0.001″). The limits
// of the steps of progress are a tenth above the numbers of steps that were counted.
TEST(CompensateLoad, FindsWhatTheSearchWithoutDerivativesFound) {
  const std::string four =
      "corrections = [\"gear1.lead_slope_um\", \"gear1.lead_crowning_um\", "
      "\"gear1.profile_crowning_um\", \"gear2.profile_slope_um\"]\n";
  const std::string te = "aim = \"loaded_transmission_error\"\n", pressure = "aim = \"pressure\"\n";
  const auto spur_or_ring = [](int z1, int z2, double m, double error, const std::string& torque,
                               const std::string& compensate) {
    return fmt::format(
        "[gear1]\nteeth = {}\nnormal_module_mm = {}\nface_width_mm = 25\n[gear2]\nteeth = {}\n"
        "face_width_mm = 25\n[pair]\nbacklash_mm = 0.1\n[errors]\ncrossing_deg = {}\n[load]\n"
        "positions = 12\nslices = 8\naccuracy = \"draft\"\ntorque_Nm = {}\n[compensate]\n{}",
        z1, m, z2, error, torque, compensate);
  };
  struct Case {
    std::string spec, aim;
    double former;
    std::int64_t steps;
  };
  const std::vector<Case> cases{
      {spec_of(te + four, "[40, 250]"), "loaded_transmission_error", 3.23754, 250},
      {spec_of(pressure + "[compensate.range]\ncrossing_deg = [-0.02, 0.05]\n"), "pressure",
       1320.61847, 95},
      {spur_or_ring(25, 43, 3.0, 0.01, "[80, 250]",
                    te + "corrections = [\"gear1.profile_crowning_um\", "
                         "\"gear2.profile_crowning_um\", \"gear1.profile_slope_um\"]\n"),
       "loaded_transmission_error", 7.70514, 200},
      {spur_or_ring(21, -60, 2.0, 0.03, "80", te + four), "loaded_transmission_error", 0.54324,
       270}};
  for (const Case& c : cases) {
    SolvedJob job = job_of(c.spec);
    Progress progress;
    const auto answer = answer_compensate(job, &progress);
    ASSERT_TRUE(answer) << answer.error().message();
    double after = 0.0;
    for (const AimedLoad& l : answer->loads) after = std::max(after, aimed(l.after, c.aim));
    EXPECT_LE(after, c.former + (c.aim == "pressure" ? 0.1 : 0.001)) << c.spec;
    EXPECT_LE(progress.state().done, c.steps) << c.spec;
  }
}

// If an edge carries load even after the corrections, the verdict must not be green.
TEST(CompensateLoad, AnEdgeThatStillCarriesIsAFinding) {
  SolvedJob job = job_of(spec_of("aim = \"pressure\"\n", "[60, 250]"));
  const auto answer = answer_compensate(job, nullptr, 20);
  ASSERT_TRUE(answer) << answer.error().message();
  ASSERT_TRUE(answer->loads[1].after.edge_carries);
  EXPECT_NE(answer->verdict.level, Level::green);
  const auto& findings = answer->verdict.findings;
  const auto found = std::count_if(findings.begin(), findings.end(), [](const Finding& f) {
    return f.code == WarningCode::edge_carries;
  });
  EXPECT_GT(found, 0);
}

TEST(CompensateLoad, WantsTheTorque) {
  std::string text = spec_of("aim = \"pressure\"\n");
  text.erase(text.find("torque_Nm"), std::string("torque_Nm = 250\n").size());
  SolvedJob job = job_of(text);
  const auto answer = answer_compensate(job);
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().field, "load.torque_Nm");
}

}  // namespace
}  // namespace gearwright
