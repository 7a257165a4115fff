// Measures the design search. It compares the vector code with the scalar code, one thread with
// two, and feasible designs with trials that the filter rejects.
//
// Counters: `ratio` is the median over rounds. In each round, both variants are measured one after
// the other, so that other load on the machine slows both. `per_s` is the number of candidates per
// second. The label of the benchmark is the instruction set of the vector code.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "bench/thread_seconds.hpp"
#include "gearwright/design/candidate.hpp"
#include "gearwright/job/search_job.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace {

using namespace gearwright;
using Clock = std::chrono::steady_clock;

template <class F>
double seconds_of(const F& f) {
  const auto start = Clock::now();
  f();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Reports the time of the scalar code divided by the time of the vector code.
template <class Scalar, class Fast>
void paired(benchmark::State& state, double candidates, const Scalar& slow, const Fast& fast) {
  std::vector<double> ratios;
  double best = 1e300;
  for (auto _ : state) {
    const double a = seconds_of(slow);
    const double b = seconds_of(fast);
    ratios.push_back(a / b);
    best = std::min(best, b);
  }
  state.counters["ratio"] = median(ratios);
  state.counters["per_s"] = candidates / best;
}

// Computes working angle, contact ratios, sliding, tips, clearance and interference of 16 384
// candidates.
void candidates_lanes_over_scalar(benchmark::State& state) {
  CandidateConstants c;
  c.tan_alpha = std::tan(20.0 * std::numbers::pi / 180.0);
  c.addendum = {1.0, 1.0};
  c.dedendum = {1.25, 1.25};
  c.edge_depth = c.flank_depth = {1.0, 1.0};
  c.tight = c.shorten = state.range(0) == 1;
  CandidateBatch batch;
  batch.resize(16384);
  std::mt19937_64 bits(7);
  const auto uniform = [&](double lo, double hi) {
    return lo + (hi - lo) * static_cast<double>(bits() >> 11) * 0x1p-53;
  };
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const double z1 = std::floor(uniform(12, 60));
    const double values[] = {z1, std::floor(z1 * uniform(1, 5)),
                             std::sin(uniform(0, 30) * std::numbers::pi / 180.0),
                             uniform(-0.3, 0.7), uniform(-0.3, 0.7)};
    for (std::size_t k = 0; k < CandidateBatch::kIn; ++k) batch.in[k][i] = values[k];
  }
  state.SetLabel(lanes_name() + (c.tight ? ", tight centres" : ", extended centres"));
  paired(
      state, static_cast<double>(batch.size()), [&] { evaluate_scalar(c, batch); },
      [&] { evaluate(c, batch); });
}
BENCHMARK(candidates_lanes_over_scalar)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

SearchProblem gearboxes() {
  SearchProblem p;
  p.ratio = {1.0, 8.0};
  p.center_distance = {{99.0, 101.0}};
  p.modules = {1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0};
  p.pinion_teeth = {10, 200};
  p.limits.min_shift = -0.6;
  p.limits.max_shift = 1.0;
  p.helix.clear();
  for (int i = 0; i < 8; ++i) p.helix.push_back(Angle::degrees(i));
  return p;
}

// Runs a whole search of 8 million candidates in memory, on one thread and on two.
void search_one_thread_over_two(benchmark::State& state) {
  const Search search(gearboxes());
  JobSpec spec;
  spec.tree = std::make_shared<const SpecTree>(SpecTree{Json::object()});
  const auto run = [&](int threads) {
    SearchOptions options;
    options.threads = threads;
    options.top = 10;
    benchmark::DoNotOptimize(run_search(spec, search, options));
  };
  run(2);
  paired(
      state, static_cast<double>(*search.space().size()), [&] { run(1); }, [&] { run(2); });
}
BENCHMARK(search_one_thread_over_two)->Unit(benchmark::kMillisecond)->Iterations(7);

// Searches for spur pairs at free centre distances, most of which are feasible. If the argument is
// 1, the limits include the interference and clearance that a drawing requires. `ratio` is the time
// for these designs divided by the time for the same number of trials that the filter rejects.
void feasible_designs_over_sieve(benchmark::State& state) {
  SearchProblem p;
  p.ratio = {1.0, 6.0};
  p.modules = {2.0};
  p.pinion_teeth = {20, 200};
  p.limits.avoid_interference = state.range(0) == 1;
  p.limits.clear_fillets = p.limits.avoid_interference;
  if (p.limits.avoid_interference) {
    p.limits.tip_clearance = kRunningTipClearance;
    p.limits.form_clearance = kRunningFormClearance;
  }
  SearchProblem far = p;
  far.center_distance = {{1.0, 2.0}};
  const Search search(p);
  const Search dead(far);
  const std::int64_t size = *search.space().size();
  std::vector<DesignRow> rows;
  std::vector<DesignRow> none;
  std::int64_t feasible = 0;
  paired(
      state, static_cast<double>(size),
      [&] {
        rows.clear();
        feasible = search.range(0, size, rows, {.detail = RegionDetail::point}).feasible;
      },
      [&] { dead.range(0, size, none); });
  state.counters["feasible"] = static_cast<double>(feasible) / static_cast<double>(size);
  state.counters["designs_per_s"] = static_cast<double>(feasible) * state.counters["per_s"] /
                                    static_cast<double>(size) / state.counters["ratio"];
  state.SetLabel(p.limits.avoid_interference ? "without interference" : "interference allowed");
}
BENCHMARK(feasible_designs_over_sieve)
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(7);

// Measures designs whose shifts do not lie on the line of balanced shifts [T2.18a], because λ moves
// the line out of every region. `ratio` is the time for them divided by the time for designs on the
// line. If the argument is 1, the designs are on the line, without backlash and with shortened
// tips.
void designs_off_the_line_over_those_on_it(benchmark::State& state) {
  SearchProblem p;
  p.ratio = {1.0, 6.0};
  p.modules = {2.0};
  p.pinion_teeth = {20, 120};
  p.limits.avoid_interference = p.limits.clear_fillets = true;
  p.limits.tip_clearance = kRunningTipClearance;
  p.limits.form_clearance = kRunningFormClearance;
  SearchProblem q = p;
  if (state.range(0) == 0) q.lambda = 2.5;
  q.shorten_tips = state.range(0) == 1;
  if (q.shorten_tips) q.mounting = Mounting::tight;
  const Search on(p);
  const Search off(q);
  std::vector<DesignRow> rows;
  const auto run = [&](const Search& search) {
    rows.clear();
    return search.range(0, *search.space().size(), rows, {.detail = RegionDetail::point}).feasible;
  };
  const auto feasible = static_cast<double>(run(off));
  double best = 1e300;
  std::vector<double> ratios;
  for (auto _ : state) {
    const double a = seconds_of([&] { run(off); });
    const double b = seconds_of([&] { run(on); });
    ratios.push_back(a / b);
    best = std::min(best, a);
  }
  state.counters["ratio"] = median(ratios);
  state.counters["designs_per_s"] = feasible / best;
  state.SetLabel(q.shorten_tips ? "tight, tips shortened" : "off the balanced line");
}
BENCHMARK(designs_off_the_line_over_those_on_it)
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(7);

// Searches for the same designs with and without rating to ISO 6336. `us_per_rating` is the
// additional time per design, and `ratio` is the time with rating divided by the time without it.
void rated_designs_over_unrated(benchmark::State& state) {
  SearchProblem p;
  p.ratio = {1.0, 6.0};
  p.modules = {2.0};
  p.pinion_teeth = {20, 200};
  p.helix = {Angle::degrees(state.range(0) == 1 ? 12 : 0)};
  if (state.range(0) == 2) {
    p.ratio = {-6.0, -2.0};
    p.modules = {1.0, 1.25, 1.5, 2.0, 2.5, 3.0};
    p.pinion_teeth = {17, 60};
    p.mounting = Mounting::tight;
  }
  p.limits.avoid_interference = p.limits.clear_fillets = true;
  p.limits.tip_clearance = kRunningTipClearance;
  p.limits.form_clearance = kRunningFormClearance;
  SearchProblem rated = p;
  SearchRating rating;
  rating.input.torque = 300;
  rating.input.speed = 1480;
  rating.input.life_h = 20000;
  rating.input.viscosity = 220;
  rating.input.quality = {6, 6};
  rating.input.flank_roughness = {4, 4};
  rating.input.root_roughness = {16, 16};
  PinionMounting mounting;
  mounting.bearing_span = 180;
  mounting.shaft_diameter = 30;
  rating.input.mounting = mounting;
  const Material steel = *material_named("18CrNiMo7-6");
  rating.input.materials = {steel, steel};
  rated.rating = rating;
  const Search plain(p);
  const Search holding(rated);
  const std::int64_t size = *plain.space().size();
  std::vector<DesignRow> rows;
  std::int64_t feasible = 0;
  double with = 1e300;
  const auto run = [&](const Search& search) {
    rows.clear();
    feasible = search.range(0, size, rows, {.detail = RegionDetail::point}).feasible;
  };
  std::vector<double> ratios, added;
  run(holding);
  for (auto _ : state) {
    const double a = seconds_of([&] { run(holding); });
    const double b = seconds_of([&] { run(plain); });
    ratios.push_back(a / b);
    added.push_back((a - b) / static_cast<double>(feasible) * 1e6);
    with = std::min(with, a);
  }
  state.counters["ratio"] = median(ratios);
  state.counters["us_per_rating"] = median(added);
  state.counters["designs_per_s"] = static_cast<double>(feasible) / with;
  constexpr std::array kKinds{"spur", "helical", "internal, wheels cut in advance"};
  state.SetLabel(kKinds[static_cast<std::size_t>(state.range(0))]);
}
BENCHMARK(rated_designs_over_unrated)
    ->DenseRange(0, 2)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(7);

// Computes one region: its ends, corners and area, and the line of balanced shifts [T2.18a].
void region_of_one_trial(benchmark::State& state) {
  const Search search(gearboxes());
  const ShiftGraph graph = search.graph({0, 2.0, 33, 66, {}, 0});
  for (auto _ : state) benchmark::DoNotOptimize(shift_region(graph));
}
BENCHMARK(region_of_one_trial)->Unit(benchmark::kMicrosecond);

}  // namespace
