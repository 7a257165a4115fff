// Measures teeth under load: the compliance tables of a gear pair, and one position of the pair.
// The pair has 17:43 teeth and m_n = 2.5 mm. One position is solved on one thread. The tables are
// made on all available threads, so the CPU time of the process is measured for them.
#include <benchmark/benchmark.h>

#include <utility>

#include "bench/thread_seconds.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/corrections.hpp"
#include "gearwright/load/loaded_contact.hpp"
#include "gearwright/load/nearby_load.hpp"
#include "gearwright/pair/pair.hpp"

namespace {

using namespace gearwright;

struct Loaded {
  Gear one, two;
  ContactMount mount;
  LoadRequest request;

  Loaded(double helix_deg, ComplianceAccuracy accuracy)
      : one(gear(17, helix_deg)), two(gear(43, -helix_deg)) {
    mount.center_distance = 0.5 * (one.reference_diameter + two.reference_diameter);
    request.bodies = {ElasticBody{0.5 * one.root_diameter}, ElasticBody{0.5 * two.root_diameter}};
    request.torques = {100e3};
    request.accuracy = accuracy;
  }
  static Gear gear(int teeth, double helix_deg) {
    CylindricalSpec s;
    s.teeth = teeth;
    s.normal_module = 2.5;
    s.face_width = 35.0;
    s.helix_angle = Angle::degrees(helix_deg);
    s.rack = *iso53_rack("ISO53-A");
    return std::move(make_gear(s)).take();
  }
};

void tables_of_a_pair(benchmark::State& state) {
  const Loaded l(static_cast<double>(state.range(0)),
                 state.range(1) ? ComplianceAccuracy::full : ComplianceAccuracy::draft);
  for (auto _ : state) benchmark::DoNotOptimize(pair_compliance(l.one, l.two, l.request));
}
BENCHMARK(tables_of_a_pair)
    ->ArgNames({"helix", "full"})
    ->ArgsProduct({{0, 15}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

void a_position_under_load(benchmark::State& state) {
  const Loaded l(static_cast<double>(state.range(0)), ComplianceAccuracy::full);
  const auto compliance = pair_compliance(l.one, l.two, l.request);
  const ContactPair pair({&l.one, {}}, {&l.two, {}}, l.mount);
  LoadedTurn turn(pair, l.one, l.two, *compliance, l.request);
  std::size_t i = 0;
  for (auto _ : state) {
    turn.solve(i, i + 1);
    i = (i + 1) % turn.positions();
  }
}
BENCHMARK(a_position_under_load)->ArgName("helix")->Arg(0)->Arg(15)->Unit(benchmark::kMillisecond);

// Measures a trial of corrections under load near a pair whose contact is known, and compares it
// with the whole contact of the corrected pair in the same run. The counter `ratio` is the time of
// the contact divided by the time of the trial.
void a_trial_of_corrections(benchmark::State& state) {
  const Loaded l(15, ComplianceAccuracy::full);
  LoadRequest request = l.request;
  request.positions = 16;
  request.root_stress = false;
  const auto compliance = pair_compliance(l.one, l.two, request).value();
  ContactErrors errors;
  errors.crossing = Angle::degrees(0.02);
  const ContactSetup setup =
      ContactSetup::of(mount(l.one, l.two, {}).value(), errors, {}, {true, false}).value();
  const std::vector<WorkshopCorrection> which{{Modification::lead_slope, 1},
                                              {Modification::lead_crowning, 1}};
  const NearbyLoad near(setup.pair(false), setup.gear(1), setup.gear(2), compliance, request,
                        *influences_of(which));
  double own = 0.0, whole = 0.0;
  int k = 0;
  for (auto _ : state) {
    const std::vector<double> um{0.1 * (++k % 97), 0.05 * (k % 41)};
    const double start = thread_seconds();
    benchmark::DoNotOptimize(near.span(std::vector{um[0] * kMmPerUm, um[1] * kMmPerUm}, false));
    const double middle = thread_seconds();
    const ContactSetup changed = setup.changed(change_of(which, um, false)).value();
    const ContactPair pair = changed.pair(false);
    LoadedTurn turn(pair, l.one, l.two, compliance, request);
    turn.solve(0, turn.positions());
    benchmark::DoNotOptimize(turn.result());
    own += middle - start;
    whole += thread_seconds() - middle;
  }
  state.counters["ratio"] = whole / own;
  state.counters["trial_us"] = 1e6 * own / k;
}
BENCHMARK(a_trial_of_corrections)->Iterations(100)->Unit(benchmark::kMillisecond);

}  // namespace
