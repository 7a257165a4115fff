// Measures tolerance scatter and compares it with a loop over contact analyses. Both compute both
// flanks of the same pairs in the same run. The counter `ratio` is the time per pair in the loop
// divided by the time per member of the family. If it is above 1, the scatter is faster.
#include <benchmark/benchmark.h>

#include <ctime>
#include <vector>

#include "gearwright/base/units.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/scatter/scatter.hpp"

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

// 17 : 43 helical teeth, with or without crowning.
ContactSetup setup(bool crowned) {
  const auto pair =
      mount(make_gear(gear(17, 15, 0.3, -0.05)).value(),
            make_gear(gear(43, -15, 0.1, -0.07)).value(), {.center_distance = 78.6056});
  FlankModifications m;
  if (crowned) m.lead_crowning = 0.010;
  if (crowned) m.profile_crowning = 0.005;
  PairModifications all{};
  all[0] = {m, m};
  return ContactSetup::of(pair.value(), {}, all).value();
}

std::vector<ScatterTolerance> housing() {
  const auto range = [](double w) { return Distribution::of({{-w, w}}).value(); };
  return {{"distance", 1.0, range(0.015), VaryingError::center_distance},
          {"crossing", kRadPerDeg, range(0.02), VaryingError::crossing},
          {"intersecting", kRadPerDeg, range(0.04), VaryingError::intersecting}};
}

double seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void members(benchmark::State& state) {
  const ContactSetup pair = setup(state.range(1) != 0);
  const std::vector<ScatterTolerance> tolerances = housing();
  const int positions = static_cast<int>(state.range(0));
  double own = 0.0, loop = 0.0;
  int k = 0;
  for (auto _ : state) {
    const double u = 0.01 * (++k % 97) - 0.48;
    const std::vector<double> x{0.03 * u, -0.04 * u, 0.08 * u};
    const Deviation d = deviation_at(pair, tolerances, x);
    const double start = seconds();
    benchmark::DoNotOptimize(member_at(pair, d, {positions, false, {}}));
    const double middle = seconds();
    ContactRequest request;
    request.positions = positions;
    for (const bool gear2_drives : {false, true})
      benchmark::DoNotOptimize(analyse_contact(pair.pair(d.errors, gear2_drives), request));
    own += middle - start;
    loop += seconds() - middle;
  }
  state.counters["ratio"] = loop / own;
  state.counters["member_us"] = 1e6 * own / static_cast<double>(k);
}
BENCHMARK(members)->ArgsProduct({{32, 128}, {0, 1}})->Unit(benchmark::kMicrosecond);

}  // namespace
