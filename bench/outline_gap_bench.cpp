// Measures the gap between two outlines and, for comparison, the fillet clearance of the same pair.
#include <benchmark/benchmark.h>

#include <utility>

#include "gearwright/pair/outline_gap.hpp"
#include "gearwright/pair/pair.hpp"

namespace {

using namespace gearwright;

ParallelPair plain_pair(double a) {
  CylindricalSpec s;
  s.normal_module = 2.0;
  s.face_width = 20.0;
  s.rack = *iso53_rack("ISO53-A");
  s.teeth = 20;
  const Gear one = std::move(make_gear(s)).take();
  s.teeth = 40;
  const Gear two = std::move(make_gear(s)).take();
  return std::move(mount_as<ParallelPair>(one, two, {a})).take();
}

void outline_gap_of_a_plain_pair(benchmark::State& state) {
  const ParallelPair p = plain_pair(60.1);
  const double limit = p.mesh.backlash.rotation[1] / 2;
  for (auto _ : state) {
    benchmark::DoNotOptimize(outline_gap(p.gears[0].tooth->outline, p.gears[1].tooth->outline,
                                         p.center_distance, limit));
  }
}
BENCHMARK(outline_gap_of_a_plain_pair)->Unit(benchmark::kMicrosecond);

void both_fillet_clearances_of_a_plain_pair(benchmark::State& state) {
  const ParallelPair p = plain_pair(60.1);
  for (auto _ : state) {
    benchmark::DoNotOptimize(fillet_clearance(p, 1));
    benchmark::DoNotOptimize(fillet_clearance(p, 2));
  }
}
BENCHMARK(both_fillet_clearances_of_a_plain_pair)->Unit(benchmark::kMicrosecond);

}  // namespace
