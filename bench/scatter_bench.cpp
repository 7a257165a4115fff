// Measures tolerance scatter and compares it with a loop over contact analyses. Both compute both
// flanks of the same pairs in the same run. The counter `ratio` is the time per pair in the loop
// divided by the time per member of the family. If it is above 1, the scatter is faster.
#include <benchmark/benchmark.h>

#include <vector>

#include "bench/thread_seconds.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/math/sobol.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/scatter/scatter.hpp"
#include "gearwright/scatter/tolerance.hpp"

namespace {

using namespace gearwright;

CylindricalSpec gear(int teeth, double helix_deg, double shift, double allowance) {
  CylindricalSpec s;
  s.teeth = teeth;
  s.normal_module = 2.5;
  s.helix_angle = Angle::degrees(helix_deg);
  s.profile_shift = shift;
  s.thickness_allowance = allowance;
  s.face_width = 25.0;
  return s;
}

enum Flanks { kPlain, kCrowned, kRelieved };

// 17 : 43 helical teeth, with or without crowning, or with linear tip and root relief.
ContactSetup setup(std::int64_t flanks) {
  const auto pair =
      mount(make_gear(gear(17, 15, 0.3, -0.05)).value(),
            make_gear(gear(43, -15, 0.1, -0.07)).value(), {.center_distance = 78.6056});
  PairModifications all{};
  for (const int which : {1, 2}) {
    FlankModifications m;
    if (flanks != kPlain && which == 1) m.lead_crowning = 0.010;
    if (flanks == kCrowned && which == 1) m.profile_crowning = 0.005;
    const Gear& g = pair.value().gear(which);
    if (flanks == kRelieved) m.tip_relief = {0.015, 2 * g.tip_form_radius() - 1.5};
    if (flanks == kRelieved) m.root_relief = {0.005, 2 * *g.root_form_radius() + 1.0};
    all[static_cast<std::size_t>(which - 1)] = {m, m};
  }
  return ContactSetup::of(pair.value(), {}, all).value();
}

std::vector<ScatterTolerance> housing() {
  const auto range = [](double w) { return Distribution::of({{-w, w}}).value(); };
  return {{"distance", 1.0, range(0.015), VaryingError::center_distance},
          {"crossing", kRadPerDeg, range(0.02), VaryingError::crossing},
          {"intersecting", kRadPerDeg, range(0.04), VaryingError::intersecting}};
}

void members(benchmark::State& state) {
  const ContactSetup pair = setup(state.range(1));
  const std::vector<ScatterTolerance> tolerances = housing();
  const int positions = static_cast<int>(state.range(0));
  double own = 0.0, loop = 0.0;
  int k = 0;
  for (auto _ : state) {
    const double u = 0.01 * (++k % 97) - 0.48;
    const std::vector<double> x{0.03 * u, -0.04 * u, 0.08 * u};
    const Deviation d = deviation_at(pair, tolerances, x);
    const double start = thread_seconds();
    benchmark::DoNotOptimize(member_at(pair, d, {positions, false, {}}));
    const double middle = thread_seconds();
    ContactRequest request;
    request.positions = positions;
    for (const bool gear2_drives : {false, true})
      benchmark::DoNotOptimize(analyse_contact(pair.pair(d.errors, gear2_drives), request));
    own += middle - start;
    loop += thread_seconds() - middle;
  }
  state.counters["ratio"] = loop / own;
  state.counters["member_us"] = 1e6 * own / static_cast<double>(k);
}
BENCHMARK(members)
    ->ArgsProduct({{32, 128}, {kPlain, kCrowned, kRelieved}})
    ->Unit(benchmark::kMicrosecond);

// Measures the members of a family of grade 6 with waves of profile and helix, and without them, in
// the same run. The counter `ratio` is the time per member with waves divided by the time per
// member without waves.
void wavy_members(benchmark::State& state) {
  const ContactSetup pair = setup(state.range(0));
  std::vector<ScatterTolerance> smooth = housing();
  std::vector<ScatterTolerance> waves;
  const Distribution share = Distribution::of({{0.0, 1.0}}).value();
  for (const int which : {1, 2}) {
    const GradedFlank f = graded_flank(pair.gear(which), FlankTolerances::iso_2013, 6).value();
    smooth.push_back({"slope", 1.0, Distribution::of({{-f.profile_slope, f.profile_slope}}).value(),
                      VaryingModification{which, Modification::profile_slope}});
    waves.push_back({"profile", 1.0, share, VaryingWave{which, false, {1, 4}, f.profile_form}});
    waves.push_back({"helix", 1.0, share, VaryingWave{which, true, {1, 4}, f.helix_form}});
  }
  waves.insert(waves.begin(), smooth.begin(), smooth.end());
  double with = 0.0, without = 0.0;
  int k = 0;
  for (auto _ : state) {
    ++k;
    for (const auto& tolerances : {smooth, waves}) {
      std::vector<double> x;
      for (const ScatterTolerance& t : tolerances) {
        std::array<double, 3> u{};
        for (double& v : u)
          v = random_unit(static_cast<std::uint64_t>(k), x.size() + (&v - u.data()));
        const auto at = t.at(u);
        x.insert(x.end(), at.begin(), at.begin() + t.coordinates());
      }
      const double start = thread_seconds();
      benchmark::DoNotOptimize(member_at(pair, deviation_at(pair, tolerances, x), {32, false, {}}));
      (tolerances.size() == waves.size() ? with : without) += thread_seconds() - start;
    }
  }
  state.counters["ratio"] = with / without;
  state.counters["smooth_us"] = 1e6 * without / k;
  state.counters["wavy_us"] = 1e6 * with / k;
}
BENCHMARK(wavy_members)->Arg(kPlain)->Arg(kCrowned)->Iterations(300)->Unit(benchmark::kMicrosecond);

}  // namespace
