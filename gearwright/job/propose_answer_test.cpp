// Laws of the proposals: (1) their effects are the results of `load` for their specs; (2) the
// transmission error of a recommended proposal exceeds that of the spec as given by at most 0.5 µm.
#include "gearwright/job/propose_answer.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "gearwright/base/units.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/load_answer.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {
namespace {

constexpr const char* kDraft = "[load]\npositions = 12\nslices = 8\naccuracy = \"draft\"\n";

std::string spur_spec(const std::string& gear1 = "", const std::string& gear2 = "", int z2 = 25) {
  return "[gear1]\nteeth = 25\nnormal_module_mm = 3\nface_width_mm = 20\n" + gear1 +
         "[gear2]\nteeth = " + std::to_string(z2) + "\n" + gear2 + kDraft;
}

const std::string kHelical =
    "[gear1]\nteeth = 23\nnormal_module_mm = 3\nhelix_angle_deg = 15\nface_width_mm = 30\n"
    "quality = 6\n[gear1.shaft]\nbearings_mm = [-40, 90]\ndiameter_mm = 30\n"
    "[gear2]\nteeth = 41\nface_width_mm = 26\n";

Result<ProposeAnswer> try_propose(const std::string& text) {
  const auto spec = read_spec(text, SpecFormat::toml);
  if (!spec) return spec.error();
  auto solved = solve(*spec, Scope::pair);
  if (!solved) return solved.error();
  SolvedJob job = std::move(solved).take();
  return answer_propose(job);
}

ProposeAnswer propose_for(const std::string& text) {
  auto answer = try_propose(text);
  EXPECT_TRUE(answer) << answer.error().message();
  return std::move(answer).take();
}

Error propose_error(const std::string& text) {
  const auto answer = try_propose(text);
  EXPECT_FALSE(answer);
  return answer ? Error{} : answer.error();
}

LoadedContact load_of_spec(const Json& tree) {
  const auto spec = read_spec_tree(tree);
  EXPECT_TRUE(spec) << spec.error().message();
  auto solved = solve(*spec, Scope::everything);
  EXPECT_TRUE(solved) << solved.error().message();
  SolvedJob job = std::move(solved).take();
  auto load = answer_load(job);
  EXPECT_TRUE(load) << load.error().message();
  return *load->contact;
}

void expect_effects_of_load(const ProposeAnswer& a, const std::vector<std::size_t>& which) {
  for (const std::size_t i : which) {
    const LoadedContact load = load_of_spec(a.specs[i]);
    ASSERT_EQ(a.proposals[i].loads.size(), load.torques.size());
    for (std::size_t k = 0; k < load.torques.size(); ++k) {
      const LoadedScore& s = a.proposals[i].loads[k].score;
      const LoadedTorque& t = load.torques[k];
      EXPECT_EQ(s.peak_to_peak.rad(), t.peak_to_peak.rad()) << i;
      EXPECT_EQ(s.max_pressure, t.max_pressure) << i;
      EXPECT_EQ(*s.face_load_factor, t.face_load_factor) << i;
      EXPECT_EQ(s.edge_carries, t.edge_carries) << i;
    }
  }
}

TEST(Propose, EffectsAreThoseOfLoadForTheSpec) {
  const ProposeAnswer a = propose_for(kHelical + kDraft + "torque_Nm = [60, 200]\n");
  ASSERT_EQ(a.proposals.size(), 10u);
  ASSERT_TRUE(a.deflection);
  EXPECT_NE(a.deflection->slope, 0.0);
  expect_effects_of_load(a, {0, 9});
  expect_effects_of_load(propose_for(spur_spec("[gear1.modifications]\nlead_crowning_um = 6\n") +
                                     "driver = 2\ndeflection_slope_um = 12\ntorque_Nm = 100\n"),
                         {0, 1, 4, 7});
}

// The value without load is that of `contact` for the spec. Reliefs raise it.
TEST(Propose, ErrorWithoutLoadIsThatOfContactForTheSpec) {
  const ProposeAnswer a = propose_for(spur_spec() + "torque_Nm = 100\n");
  EXPECT_NEAR(a.proposals[0].without_load->rad(), 0.0, 1e-14);  // rounding
  for (std::size_t i = 1; i < a.proposals.size(); ++i) {
    auto solved = solve(*read_spec_tree(a.specs[i]), Scope::everything);
    SolvedJob job = std::move(solved).take();
    const auto contact = answer_contact(job);
    ASSERT_TRUE(contact && contact->continuous_span);
    EXPECT_EQ(a.proposals[i].without_load->rad(), contact->continuous_span->rad());
  }
  EXPECT_GT(a.proposals[2].without_load->arcsec(), a.proposals[2].worst.peak_to_peak.arcsec());
}

TEST(Propose, NeverRecommendsMoreTransmissionErrorThanAsGiven) {
  std::mt19937 random(35);
  const auto between = [&](double lo, double hi) {
    return std::uniform_real_distribution<double>(lo, hi)(random);
  };
  for (int trial = 0; trial < 5; ++trial) {
    const std::string relief =
        "[gear1.modifications]\ntip_relief_um = " + std::to_string(between(1, 25)) +
        "\nlead_crowning_um = " + std::to_string(between(-4, 12)) + "\n";
    const ProposeAnswer a = propose_for(
        spur_spec(trial % 2 ? relief : "", "", 25 + 5 * trial) +
        (trial % 3 ? "deflection_slope_um = " + std::to_string(between(-20, 20)) + "\n" : "") +
        "torque_Nm = " + std::to_string(between(5, 300)) + "\n");
    const Proposal& best = a.proposals[a.recommended];
    const double r_b2 = 1.5 * (25 + 5 * trial) * std::cos(20 * kRadPerDeg);
    EXPECT_LE(best.worst.peak_to_peak.rad(),
              a.proposals[0].worst.peak_to_peak.rad() + 0.5e-3 / r_b2)
        << trial;
    EXPECT_FALSE(best.worst.edge_carries && !a.proposals[0].worst.edge_carries) << trial;
    EXPECT_FALSE(a.reason.empty());
  }
}

Proposal with_score(double te, double pressure, bool edge = false) {
  Proposal p;
  p.worst = {Angle::arcseconds(te), pressure, 1.0, edge};
  return p;
}

TEST(Propose, ReasonNamesCompensateAndLossesAtTheLimits) {
  for (const char* errors : {"", "[errors]\ncrossing_deg = 0.05\n"}) {
    const ProposeAnswer a = propose_for(kHelical + kDraft + "torque_Nm = 150\n" + errors);
    const auto has = [&](const char* words) { return a.reason.find(words) != a.reason.npos; };
    EXPECT_EQ(has("gearwright compensate"), *errors != '\0') << a.reason;
    const auto& best = *a.proposals[a.recommended].at_limits;
    const auto& given = *a.proposals.front().at_limits;
    EXPECT_EQ(has("limits of the helix slopes, its transmission error is greater"),
              best.peak_to_peak.rad() > given.peak_to_peak.rad())
        << a.reason;
  }
}

constexpr double kRadius = 100.0;  // r_b2  mm; 1″ is 0.485 µm on the line of action

std::size_t best_of(const std::vector<Proposal>& list) { return recommended(list, kRadius); }

// The transmission error may exceed the least one by 0.5 µm (1.03″). Within this range, the least
// pressure decides. [T12.33]
TEST(Propose, RecommendsByEdgesThenByErrorThenByPressure) {
  EXPECT_EQ(best_of({with_score(10, 900)}), 0u);
  EXPECT_EQ(best_of({with_score(10, 900), with_score(11.1, 100)}), 0u);
  EXPECT_EQ(best_of({with_score(10, 900), with_score(11, 850)}), 1u);
  EXPECT_EQ(best_of({with_score(10, 900), with_score(5, 900), with_score(6, 850)}), 2u);
  EXPECT_EQ(best_of({with_score(10, 900), with_score(5, 900), with_score(6.1, 850)}), 1u);
  EXPECT_EQ(best_of({with_score(10, 900, true), with_score(5, 400, true), with_score(9, 900)}), 2u);
  EXPECT_EQ(best_of({with_score(10, 900), with_score(5, 400, true)}), 0u);
  // A pressure that is lower by less than 1 % is not worth another modification.
  EXPECT_EQ(best_of({with_score(10, 900), with_score(5, 900), with_score(4.95, 892)}), 1u);
  Proposal lost;
  EXPECT_EQ(best_of({lost, with_score(5, 900)}), 1u);
  EXPECT_EQ(best_of({lost, with_score(9, 900), with_score(5, 900)}), 2u);
  EXPECT_EQ(best_of({with_score(10, 900), lost}), 0u);
  // With tolerances, the pressure and the loaded edges at the limits of the tolerances decide.
  Proposal crowned = with_score(10, 950);
  crowned.at_limits = crowned.worst;
  Proposal plain = with_score(10, 900);
  plain.at_limits = with_score(12, 1400, true).worst;
  EXPECT_EQ(best_of({plain, crowned}), 1u);
}

// The long relief is quieter by 0.24 µm (0.5″), but its pressure is greater.
TEST(Propose, DoesNotPayForAQuarterOfAMicrometreWithPressure) {
  const Proposal given = with_score(2.0, 1000, true);
  EXPECT_EQ(best_of({given, with_score(1.5, 960), with_score(1.0, 1000)}), 1u);
  // An edge carries load at the limits of both. The pressures there are lower bounds.
  Proposal short_relief = with_score(1.5, 870), long_relief = with_score(1.0, 1040);
  short_relief.at_limits = with_score(2.5, 1100, true).worst;
  long_relief.at_limits = with_score(2.0, 1050, true).worst;
  EXPECT_EQ(best_of({given, short_relief, long_relief}), 1u);
}

// A proposal is preferred because no edge carries load at the limits, but only if its pressure
// without deviations is at most 1.1 times the least pressure. [T12.33]
TEST(Propose, DoesNotPayForFreeEdgesWithMuchPressure) {
  for (const double pressure : {900.0, 960.0}) {
    Proposal quiet = with_score(4, 860);
    quiet.at_limits = with_score(9, 1030, true).worst;
    Proposal free = with_score(4.5, pressure);
    free.at_limits = with_score(8, 1100).worst;
    Proposal given = with_score(10, 870, true);
    given.at_limits = with_score(12, 1110, true).worst;
    EXPECT_EQ(best_of({given, quiet, free}), pressure > 1.1 * 860 ? 1u : 2u) << pressure;
  }
}

// A spec that has the modifications of a proposal has the same effects, and the report recommends
// no other proposal.
TEST(Propose, ATakenProposalIsFoundAgain) {
  const ProposeAnswer a = propose_for(kHelical + kDraft + "torque_Nm = 150\n");
  constexpr std::size_t kTaken = 5;  // long tip relief with helix modifications
  ASSERT_EQ(same_proposals(a.proposals, kTaken), std::vector<std::size_t>{kTaken});
  const auto spec = read_spec_tree(a.specs[kTaken]);
  ASSERT_TRUE(spec);
  auto solved = solve(*spec, Scope::pair);
  ASSERT_TRUE(solved);
  SolvedJob job = std::move(solved).take();
  const auto again = answer_propose(job);
  ASSERT_TRUE(again);
  const auto same = same_proposals(again->proposals, 0);
  EXPECT_EQ(same, (std::vector<std::size_t>{0, 2, 3, kTaken}));
  for (const std::size_t i : same) {
    EXPECT_EQ(nlohmann::json(again->specs[i]), nlohmann::json(again->specs[0])) << i;
    EXPECT_TRUE(i == 0 || same_proposals(again->proposals, i).empty()) << i;
  }
  EXPECT_EQ(words_of_same(again->proposals, same).rfind("3, 4, 6: long tip relief; helix", 0), 0u)
      << words_of_same(again->proposals, same);
}

TEST(Propose, AmountsAreZeroAtZeroTorque) {
  const ProposeAnswer a = propose_for(spur_spec() + "torque_Nm = 1e-6\n");
  for (const Proposal& p : a.proposals)
    for (const ProposedGear& g : p.gears) {
      EXPECT_EQ(g.tip_relief.value_or(0.0), 0.0);
      EXPECT_EQ(g.root_relief.value_or(0.0), 0.0);
    }
  EXPECT_EQ(a.recommended, 0u);
}

TEST(Propose, EqualGearsGetEqualReliefs) {
  const ProposeAnswer a = propose_for(spur_spec() + "torque_Nm = 150\n");
  ASSERT_EQ(a.proposals.size(), 5u);
  for (const std::size_t i : {1, 2}) {
    const auto& [one, two] = a.proposals[i].gears;
    EXPECT_EQ(*one.tip_relief, *two.tip_relief);
    EXPECT_EQ(*one.tip_start, *two.tip_start);
    EXPECT_GT(*one.tip_relief, 0.004);
  }
  // A long relief starts nearer to the root than a short one. It makes this pair much quieter.
  EXPECT_LT(*a.proposals[2].gears[0].tip_start, *a.proposals[1].gears[0].tip_start);
  EXPECT_LT(a.proposals[2].worst.peak_to_peak.rad(), 0.5 * a.proposals[0].worst.peak_to_peak.rad());
  EXPECT_TRUE(a.proposals[0].worst.edge_carries);
  EXPECT_FALSE(a.proposals[a.recommended].worst.edge_carries);
}

// ISO 1328-1:2013: f_pt = (0.001 d + 0.4 m_n + 5) √2^(A − 5) µm, rounded to 0.5 µm below 10 µm and
// otherwise to 1 µm. It is 9 µm for 25 teeth of class 6, and 13 µm for 60 teeth of class 7.
// [T12.28]
TEST(Propose, AmountsAreDeflectionAndPitchDeviationOfTheirGear) {
  const ProposeAnswer a =
      propose_for(spur_spec("quality = 6\n", "quality = 7\n", 60) + "torque_Nm = 72\n");
  const double pitch = std::hypot(0.009, 0.013) * std::cos(20 * std::acos(-1.0) / 180);
  ASSERT_TRUE(a.pitch_deviation && a.short_deflection);
  EXPECT_NEAR(*a.pitch_deviation, pitch, 1e-12);
  ASSERT_NE(std::ceil(1000 * (*a.short_deflection)[0]), std::ceil(1000 * (*a.short_deflection)[1]));
  const auto amounts = [&](bool with_lead, bool with_pitch) {
    for (const Proposal& p : a.proposals)
      if (p.profile == ProposedProfile::short_tips && p.lead == with_lead && p.pitch == with_pitch)
        return std::array{1000 * *p.gears[0].tip_relief, 1000 * *p.gears[1].tip_relief};
    ADD_FAILURE() << with_lead << with_pitch;
    return std::array{0.0, 0.0};
  };
  for (const std::size_t g : {0, 1}) {
    EXPECT_NEAR(amounts(false, false)[g], std::ceil(1000 * (*a.short_deflection)[g]), 1e-9);
    // Both amounts are rounded up. They follow from the same deflection, with and without the pitch
    // deviation.
    const double more = amounts(true, true)[g] - amounts(true, false)[g];
    EXPECT_GE(more, std::floor(1000 * pitch) - 1e-9);
    EXPECT_LE(more, std::ceil(1000 * pitch) + 1e-9);
  }
}

// A helix slope that is equal to the deflection restores the aligned contact.
TEST(Propose, SlopeCancelsTheDeflection) {
  for (const char* driver : {"driver = 1\n", "driver = 2\n"}) {
    const ProposeAnswer aligned = propose_for(spur_spec() + driver + "torque_Nm = 100\n");
    const ProposeAnswer askew =
        propose_for(spur_spec() + driver + "torque_Nm = 100\ndeflection_slope_um = 14\n");
    const LoadedScore& as_given = aligned.proposals[0].worst;
    EXPECT_GT(*askew.proposals[0].worst.face_load_factor, 1.2 * *as_given.face_load_factor);
    bool tried = false;
    for (const Proposal& p : askew.proposals) {
      if (!p.lead || p.profile != ProposedProfile::as_given) continue;
      tried = true;
      EXPECT_EQ(*p.gears[0].lead_slope, 0.014);
      EXPECT_NEAR(*p.worst.face_load_factor, *as_given.face_load_factor, 1e-3);
      EXPECT_NEAR(p.worst.max_pressure, as_given.max_pressure, 1e-3 * as_given.max_pressure);
    }
    EXPECT_TRUE(tried);
  }
}

// If shafts bend, the proposed slope makes the load as even as a slope can make it, for both hands
// and both drivers. The opposite slope makes the load less even. The spec as given is unchanged.
TEST(Propose, SlopeCancelsTheDeflectionOfTheShafts) {
  for (const char* helix : {"15", "-15", "0"})
    for (const char* driver : {"driver = 1\n", "driver = 2\n"}) {
      const std::string text =
          "[gear1]\nteeth = 23\nnormal_module_mm = 3\nface_width_mm = 30\nhelix_angle_deg = " +
          std::string(helix) +
          "\n[gear1.shaft]\nbearings_mm = [-25, 70]\ndiameter_mm = 30\n[gear2]\nteeth = 41\n" +
          kDraft + driver + "torque_Nm = 300\n";
      const ProposeAnswer a = propose_for(text);
      EXPECT_FALSE(a.specs[0]["load"].contains("deflection_slope_um"));
      const double before = *a.proposals[0].worst.face_load_factor;
      EXPECT_GT(before, 1.1);
      bool tried = false;
      for (std::size_t i = 1; i < a.proposals.size(); ++i) {
        const Proposal& p = a.proposals[i];
        if (!p.lead || p.profile != ProposedProfile::as_given) continue;
        tried = true;
        EXPECT_LT(*p.worst.face_load_factor - 1, 0.5 * (before - 1)) << helix << driver;
        Json opposite = a.specs[i];
        for (auto& [key, value] : opposite["gear1"]["modifications"].items())
          if (key.ends_with("lead_slope_um")) value = -value.get<double>();
        EXPECT_GT(load_of_spec(opposite).torques[0].face_load_factor, before) << helix << driver;
      }
      EXPECT_TRUE(tried);
    }
}

TEST(Propose, ReplacesModificationsOfTheSameDirection) {
  const std::string given =
      "[gear1.modifications]\nright_tip_relief_um = 10\nleft_tip_relief_um = 4\n"
      "profile_slope_um = 3\nlead_crowning_um = 5\n";
  const ProposeAnswer a = propose_for(spur_spec(given) + "torque_Nm = 100\n");
  const Json& table = a.specs[1]["gear1"]["modifications"];
  EXPECT_EQ(table.size(), 3u) << table.dump();
  EXPECT_EQ(table["lead_crowning_um"], 5);
  EXPECT_TRUE(table.contains("tip_relief_start_mm"));
  const ProposeAnswer askew =
      propose_for(spur_spec(given) + "torque_Nm = 100\ndriver = 2\ndeflection_slope_um = -7\n");
  const Json& lead = askew.specs[3]["gear1"]["modifications"];
  EXPECT_EQ(lead["left_lead_slope_um"], -7) << lead.dump();
  EXPECT_FALSE(lead.contains("lead_crowning_um"));
  EXPECT_EQ(lead["profile_slope_um"], 3);
}

TEST(Propose, TakesTheTorqueOfTheRating) {
  const std::string rating =
      "[rating]\npower_kW = 10\nspeed_rpm = 1500\n[rating.material]\nname = \"16MnCr5\"\n";
  const ProposeAnswer a = propose_for(spur_spec() + rating);
  EXPECT_NEAR(a.torque, 63662, 1);
  EXPECT_EQ(a.specs[1]["load"]["torque_Nm"], 63.662);
}

TEST(Propose, StatesWhyThereAreNoReliefs) {
  // Short teeth touch over less than one base pitch, long teeth over more than two.
  const ProposeAnswer low = propose_for(
      "[gear1]\nteeth = 25\nnormal_module_mm = 3\nhelix_angle_deg "
      "= 25\nface_width_mm = 30\ntip_diameter_mm = 85.5\n[gear2]\n"
      "teeth = 31\ntip_diameter_mm = 105.5\n" +
      std::string(kDraft) + "torque_Nm = 50\n");
  EXPECT_EQ(low.proposals.size(), 1u);
  EXPECT_FALSE(low.short_deflection);
  EXPECT_NE(low.reason.find("no short reliefs"), std::string::npos) << low.reason;
  const std::string rack = "rack = { addendum = 1.3, dedendum = 1.5, root_fillet_radius = 0.2 }\n";
  const ProposeAnswer high =
      propose_for("[gear1]\nteeth = 40\nnormal_module_mm = 3\nface_width_mm = 20\n" + rack +
                  "[gear2]\nteeth = 60\n" + kDraft + "torque_Nm = 100\n");
  EXPECT_EQ(high.proposals.size(), 3u);
  EXPECT_NE(high.reason.find("no long reliefs"), std::string::npos) << high.reason;
}

TEST(Propose, InternalPairsHaveReliefsToo) {
  const ProposeAnswer a = propose_for(
      "[gear1]\nteeth = 20\nnormal_module_mm = 3\nface_width_mm = 20\nprofile_shift = "
      "0.3\n[gear2]\n"
      "teeth = -70\n" +
      std::string(kDraft) + "torque_Nm = 100\n");
  EXPECT_GE(a.proposals.size(), 3u);
  EXPECT_GT(*a.proposals[1].gears[0].tip_relief, 0.0);
  EXPECT_GT(*a.proposals[1].gears[1].tip_relief, 0.0);
  EXPECT_FALSE(a.proposals[1].worst.edge_carries);
}

// Single rotations say nothing about a whole pitch, over which the proposals are compared.
TEST(Propose, ComparesWholePitchesInPlaceOfRotations) {
  const std::string spec = spur_spec() + "torque_Nm = 100\n";
  const ProposeAnswer of_rotation = propose_for(spec + "rotation1_deg = [0.5]\n");
  const ProposeAnswer of_pitch = propose_for(spec);
  ASSERT_EQ(of_rotation.proposals.size(), of_pitch.proposals.size());
  EXPECT_GT(of_rotation.proposals[0].worst.peak_to_peak.rad(), 0.0);
  for (std::size_t i = 0; i < of_pitch.proposals.size(); ++i)
    EXPECT_EQ(of_rotation.proposals[i].worst.peak_to_peak.rad(),
              of_pitch.proposals[i].worst.peak_to_peak.rad());
  EXPECT_EQ(of_rotation.recommended, of_pitch.recommended);
}

TEST(Propose, StatesWhyThereAreNoProposals) {
  EXPECT_EQ(propose_error(spur_spec()).field, "load.torque_Nm");
  const std::string torque = "torque_Nm = 50\n";
  EXPECT_EQ(propose_error(
                "[gear1]\nteeth = 20\nnormal_module_mm = 2\nhelix_angle_deg = 30\n[gear2]\nteeth "
                "= 30\nhelix_angle_deg = 20\n[pair]\nshaft_angle_deg = 50\n" +
                std::string(kDraft) + torque)
                .field,
            "pair.shaft_angle");
  const Error halves = propose_error(
      "[gear1]\nteeth = 25\nnormal_module_mm = 3\nhelix_angle_deg = 20\n"
      "[gear1.double_helical]\ngap_mm = 8\n[gear2]\nteeth = 30\n" +
      std::string(kDraft) + torque);
  EXPECT_NE(halves.message().find("double"), std::string::npos) << halves.message();
}

}  // namespace
}  // namespace gearwright
