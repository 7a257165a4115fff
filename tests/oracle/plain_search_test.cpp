// Compares the plain search with spur_searches.json, which was computed with 40 digits: pairs,
// shift limits, regions of the shift graph, and three complete searches.
#include "tests/oracle/plain_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/testing/source_file.hpp"
#include "tests/oracle/numbers.hpp"
#include "tests/oracle/plain_pair.hpp"

namespace gearwright::oracle {
namespace {

using Real = long double;
using nlohmann::json;
using enum PlainVerdict;

constexpr double kPrinted = 1e-12;  // modules, degrees or ratio: the source prints 22 to 25 digits

const json& source() {
  static const json file =
      json::parse(std::ifstream(testing::source_file("tests/oracle/spur_searches.json")));
  return file;
}

Real number(const json& value) {
  return value.is_string() ? std::stold(value.get<std::string>()) : Real(value.get<double>());
}

Real number(const json& of, const char* key) { return number(of.at(key)); }

std::optional<Real> optional_number(const json& value) {
  return value.is_null() ? std::nullopt : std::optional<Real>(number(value));
}

void expect_near(Real value, Real expected, const std::string& what, Real within = kPrinted) {
  EXPECT_LE(std::abs(value - expected), within)
      << what << ": " << double(value) << " " << double(expected);
}

/// The limits of a region or a search of the source.
PlainProblem problem_of(const json& input) {
  PlainProblem p;
  p.contact_ratio_min = number(input, "eps_min");
  p.floor = optional_number(input.at("limits").at("floor"));
  p.ceil = optional_number(input.at("limits").at("ceil"));
  p.tip_thickness_min = number(input.at("limits"), "sa_min");
  return p;
}

const std::vector<double> kSeriesI{1, 1.25, 1.5, 2,  2.5, 3,  4,  5,  6,
                                   8, 10,   12,  16, 20,  25, 32, 40, 50};

TEST(PlainSearch, pairs_of_the_source) {
  for (const json& pair : source().at("pairs")) {
    const int z1 = pair.at("z1"), z2 = pair.at("z2");
    const Real x1 = number(pair, "s1"), x2 = number(pair, "s2");
    PlainProblem p;
    p.alpha_n = number(pair, "alpha_deg") * kLongDegree;
    p.clearance_min = 0;
    const PlainPoint o = look(p, z1, z2, x1, x2);
    const std::string name = std::to_string(z1) + ":" + std::to_string(z2) + " ";
    expect_near(o.centre_distance, number(pair, "C_extended"), name + "C");
    expect_near(o.alpha_wt / kLongDegree, number(pair, "alpha_operating_deg"), name + "alpha_wt");
    expect_near(o.eps, number(pair, "contact_ratio"), name + "eps");
    // The source clips at the starts of the flanks. An undercut flank has no start above the base
    // circle.
    expect_near(o.eps_usable, number(pair, "contact_ratio_clipped"), name + "clipped");
    if (o.margins.s1min < 0 && o.margins.s2min > 0)
      expect_near(o.eps_true, o.eps_usable, name + "undercut pinion");
    const Real to_pitch_point = number(pair.at("r_base")[0]) * std::tan(o.alpha_wt);
    const json& path = pair.at("path");
    expect_near(-to_pitch_point, number(path, "T1"), name + "T1");
    expect_near(o.rho_1A - to_pitch_point, number(path, "Q2"), name + "Q2");
    expect_near(o.rho_1E - to_pitch_point, number(path, "Q1"), name + "Q1");
    for (int i : {0, 1}) {
      expect_near(o.tip_thickness[i], number(pair.at("tip_thickness")[i]), name + "thickness");
      expect_near(o.tip_clearance[i], number(pair.at("clearance")[i]), name + "clearance");
    }
    expect_near(x1 - o.margins.s1min, number(pair.at("s_min_undercut")[0]), name + "undercut 1");
    expect_near(x2 - o.margins.s2min, number(pair.at("s_min_undercut")[1]), name + "undercut 2");

    p.tight = true;
    const PlainPoint tight = look(p, z1, z2, x1, x2);
    expect_near(tight.centre_distance, number(pair, "C_tight"), name + "tight C");
    expect_near(tight.alpha_wt / kLongDegree, number(pair, "alpha_tight_deg"),
                name + "tight alpha");
    expect_near(tight.eps, number(pair, "contact_ratio_tight"), name + "tight eps");
    for (int i : {0, 1})
      expect_near(tight.tip_clearance[i], number(pair.at("clearance_tight")[i]), name + "tight c");
    expect_near(tight.margins.clearance, number(pair.at("clearance_tight")[0]), name + "margin");
  }
}

TEST(PlainSearch, contact_ratios_of_the_source) {
  for (const json& e : source().at("eq10"))
    expect_near(look({}, e.at("z1"), e.at("z2"), number(e, "s1"), number(e, "s2")).eps,
                number(e, "eps"), e.dump());
}

// The lower limit in the source includes only undercut. With many teeth it is so low that tips lie
// below the base circle, or are thin because the tooth is far below them.
TEST(PlainSearch, shift_limits_of_the_source) {
  int crossed = 0, above = 0;
  for (const json& row : source().at("shift_limits"))
    for (const auto& [depth, low_key] : {std::pair{1.0L, "s_min_hF1"}, {1.25L, "s_min_hF1.25"}})
      for (const auto& [thickness, high_key] : {std::pair{0.0L, "s_max_sa0"},
                                                {0.2L, "s_max_sa0.2"},
                                                {0.25L, "s_max_sa0.25"},
                                                {0.4L, "s_max_sa0.4"}}) {
        PlainProblem p;
        p.undercut_depth = depth;
        p.tip_thickness_min = thickness;
        const Real low = number(row, low_key), high = number(row, high_key);
        const plain::Pair pair(p, row.at("z"), 20);
        const auto pieces = plain::shifts_1(pair);
        EXPECT_FALSE(pieces.close_call);
        ASSERT_EQ(pieces.held.size(), low < high ? 1u : 0u) << row.dump();
        if (low > high) ++crossed;
        if (low > high) continue;
        expect_near(pieces.held[0].high, high, row.dump());
        if (pair.tip_thickness(1, low) >= thickness) {
          expect_near(pieces.held[0].low, low, row.dump());
          continue;
        }
        ++above;
        EXPECT_GT(pieces.held[0].low, low);
        if (pair.tip_curvature(1, pieces.held[0].low) > 1e-9L)
          expect_near(pair.tip_thickness(1, pieces.held[0].low), thickness, row.dump());
      }
  EXPECT_GT(crossed, 0);
  EXPECT_GT(above, 0);
}

// Backlash-free helical pairs, and an internal pair. The source gives mm, and modules are used
// here.
TEST(PlainSearch, mounted_pairs_of_the_source) {
  for (const json& pair : source().at("mounted")) {
    const json& in = pair.at("input");
    const Real m = number(in, "mn"), x1 = number(in, "x1"), x2 = number(in, "x2");
    const int z1 = in.at("z1"), z2 = in.at("z2");
    const Real sigma = z2 < 0 ? -1 : 1;
    PlainProblem p;
    p.beta = number(in, "beta_deg") * kLongDegree;
    p.tight = true;
    p.sliding_max = 10;
    p.avoid_interference = true;
    // The depth at which the rounding of the ISO 53 rack begins: 0.38 in profile A, 0.30 in B.
    const Real rounding = in.at("profile") == "A" ? 0.38L : 0.30L;
    p.undercut_depth = p.hf - rounding * (1 - std::sin(p.alpha_n));
    const PlainPoint o = look(p, z1, z2, x1, x2);
    const std::string name = in.dump() + " ";
    expect_near(o.centre_distance, sigma * number(pair, "a") / m, name + "a");
    expect_near(o.alpha_wt / kLongDegree, number(pair, "alpha_wt_deg"), name + "alpha_wt");
    expect_near(o.eps, number(pair, "eps_alpha"), name + "eps");
    expect_near(o.rho_1A, number(pair.at("rho1"), "A") / m, name + "rho_1A");
    expect_near(o.rho_1E, number(pair.at("rho1"), "E") / m, name + "rho_1E");
    expect_near(o.rho_2A, sigma * number(pair.at("rho2"), "A") / m, name + "rho_2A");
    expect_near(o.rho_2E, sigma * number(pair.at("rho2"), "E") / m, name + "rho_2E");
    Real greatest = 0;
    for (int i : {0, 1}) {
      expect_near(o.zeta_A[i], number(pair.at("zeta_A")[i]), name + "zeta_A");
      expect_near(o.zeta_E[i], number(pair.at("zeta_E")[i]), name + "zeta_E");
      expect_near(o.tip_thickness[i], number(pair.at("tip_thickness_n")[i]) / m, name + "s_an");
      if (z2 > 0) expect_near(o.tip_clearance[i], number(pair.at("c")[i]) / m, name + "c");
      greatest = std::max({greatest, std::abs(o.zeta_A[i]), std::abs(o.zeta_E[i])});
    }
    expect_near(o.margins.sliding, 10 - greatest, name + "sliding");
    if (z2 < 0) {
      expect_near(o.margins.interference1, number(pair, "involute_margin") / m, name + "margin");
      EXPECT_EQ(o.margins.interference2, PlainMargins::kFree);
    } else {
      const auto form_rho = [&](int i) {
        const Real teeth = i == 0 ? z1 : z2;
        const Real r_b = teeth / (2 * std::cos(p.beta)) *
                         std::cos(std::atan(std::tan(p.alpha_n) / std::cos(p.beta)));
        return std::sqrt(std::pow(number(pair.at("dFf")[i]) / m / 2, 2.0L) - r_b * r_b);
      };
      expect_near(o.margins.interference1, o.rho_1A - form_rho(0), name + "interference 1");
      expect_near(o.margins.interference2, o.rho_2E - form_rho(1), name + "interference 2");
    }
  }
}

TEST(PlainSearch, vertices_of_the_source_lie_on_their_limits) {
  int vertices = 0;
  for (const json& region : source().at("regions")) {
    if (!region.at("feasible")) continue;
    const json& in = region.at("input");
    const PlainProblem p = problem_of(in);
    const auto at = [&](const json& point) {
      return look(p, in.at("z1"), in.at("z2"), number(point[0]), number(point[1]));
    };
    for (const json& vertex : region.at("vertices")) {
      const PlainPoint o = at(vertex);
      EXPECT_GE(o.margins.min(), -kPrinted) << vertex.dump();
      for (const std::string name : vertex[2]) {
        ++vertices;
        if (name == "Cmin" || name == "Cmax")
          expect_near(o.centre_distance * number(in, "m"), number(in.at(name)), vertex.dump());
        else
          expect_near(o.margins.by_name().at(name), 0, vertex.dump());
      }
    }
    for (const json& point : region.at("curve"))
      expect_near(at(point).margins.eps, 0, point.dump());
  }
  EXPECT_EQ(vertices, 36);
}

TEST(PlainSearch, regions_of_the_source_by_slices) {
  for (const json& region : source().at("regions")) {
    const json& in = region.at("input");
    const PlainProblem p = problem_of(in);
    const Real m = number(in, "m"), c_min = number(in, "Cmin"), c_max = number(in, "Cmax");
    const PlainAnswer answer = region_not_empty(p, m, in.at("z1"), in.at("z2"), c_min, c_max);
    EXPECT_EQ(answer.verdict, region.at("feasible") ? not_empty : empty);
    const auto measured = measure_region(p, m, in.at("z1"), in.at("z2"), c_min, c_max);
    ASSERT_EQ(measured.has_value(), region.at("feasible").get<bool>());
    if (!measured) {
      EXPECT_EQ(answer.killed_by, "center_distance");
      continue;
    }
    expect_near(measured->area, number(region, "area"), "area", 1e-4L * number(region, "area"));
    expect_near(measured->s_lo, number(region, "S_lo"), "S_lo");
    expect_near(measured->s_hi, number(region, "S_hi"), "S_hi");
    // A slice that is a single point appears to be 1e-9 wide, the square root of the error of the
    // bisection of S.
    for (int i : {0, 1}) {
      expect_near(measured->lo[i], number(region.at("lo")[i]), "lo", 1e-8L);
      expect_near(measured->hi[i], number(region.at("hi")[i]), "hi", 1e-8L);
      for (int end : {0, 1}) {
        expect_near(measured->lo_edge[end][i], number(region.at("lo_edge")[end][i]), "lo", 1e-8L);
        expect_near(measured->hi_edge[end][i], number(region.at("hi_edge")[end][i]), "hi", 1e-8L);
      }
    }
  }
}

TEST(PlainSearch, complete_searches_of_the_source) {
  for (const json& search : source().at("searches")) {
    const json &in = search.at("input"), &ratio = in.at("ratio"), &c = in.at("C");
    const PlainSearch found = plain_search(
        problem_of(in), kSeriesI, {number(ratio[0]), number(ratio[1])},
        {in.at("z1")[0], in.at("z1")[1]}, {number(c[0]), number(c[1])}, in.at("coprime"));
    EXPECT_EQ(found.tested, search.at("tested").get<long>());
    EXPECT_TRUE(found.ambiguous.empty());
    std::vector<PlainSearch::Design> expected;
    for (const json& d : search.at("feasible")) expected.emplace_back(d[0], d[1], d[2]);
    EXPECT_EQ(found.designs, expected);
    std::map<std::string, long> rejected;
    const std::map<std::string, std::string> our_name{{"centre distance", "center_distance"},
                                                      {"contact ratio", "contact_ratio"}};
    for (const auto& [name, count] : search.at("rejected").items())
      rejected[our_name.at(name)] = count;
    EXPECT_EQ(found.rejected, rejected);
  }
}

TEST(PlainSearch, LongRegionsOfTheSearches) {
  int regions = 0;
  for (const json& search : source().at("searches"))
    for (const json& d : search.at("some_regions")) {
      const json& c = search.at("input").at("C");
      const auto measured = measure_region(problem_of(search.at("input")), number(d, "m"),
                                           d.at("z1"), d.at("z2"), number(c[0]), number(c[1]));
      ASSERT_TRUE(measured) << d.dump();
      const Real area = number(d, "area");  // printed from doubles
      expect_near(measured->area, area, "area " + d.dump(), 1e-4L * area + 1e-12L);
      expect_near(measured->s_lo, number(d, "S_lo"), "S_lo " + d.dump());
      expect_near(measured->s_hi, number(d, "S_hi"), "S_hi " + d.dump());
      ++regions;
    }
  EXPECT_GT(regions, 30);
}

}  // namespace
}  // namespace gearwright::oracle
