// Times of one pair: the closed-form mesh, and the whole mounting with its clearances.
#include <benchmark/benchmark.h>

#include <utility>

#include "gearwright/pair/pair.hpp"

namespace {

using namespace gearwright;

Gear gear(int teeth, double beta_deg) {
  CylindricalSpec s;
  s.teeth = teeth;
  s.normal_module = 2.0;
  s.helix_angle = Angle::degrees(beta_deg);
  s.face_width = 20.0;
  s.rack = *iso53_rack("ISO53-A");
  return std::move(make_gear(s)).take();
}

Pair some_pair() {
  const Gear g1 = gear(20, 15), g2 = gear(41, -15);
  const double a = (g1.reference.reference_diameter + g2.reference.reference_diameter) / 2 + 0.05;
  return std::move(mount_parallel(g1, g2, {a})).take();
}

void parallel_mesh_closed_form(benchmark::State& state) {
  const ParallelMeshInput<double> in = some_pair().input;
  for (auto _ : state) benchmark::DoNotOptimize(parallel_mesh(in));
}
BENCHMARK(parallel_mesh_closed_form)->Unit(benchmark::kNanosecond);

void mount_parallel_whole(benchmark::State& state) {
  const Pair p = some_pair();
  for (auto _ : state) {
    benchmark::DoNotOptimize(mount_parallel(p.gears[0], p.gears[1], {p.center_distance}));
  }
}
BENCHMARK(mount_parallel_whole)->Unit(benchmark::kMicrosecond);

void fillet_clearance_of_one_gear(benchmark::State& state) {
  const Pair p = some_pair();
  for (auto _ : state) benchmark::DoNotOptimize(fillet_clearance(p, 1));
}
BENCHMARK(fillet_clearance_of_one_gear)->Unit(benchmark::kMicrosecond);

void shifts_from_a_centre_distance(benchmark::State& state) {
  ShiftProblem p;
  p.z1 = 20;
  p.z2 = 41;
  p.normal_module = 2.0;
  p.normal_pressure_angle = p.transverse_pressure_angle = 0.349;
  p.center_distance = 61.7;
  for (auto _ : state) benchmark::DoNotOptimize(complete_shifts(p));
}
BENCHMARK(shifts_from_a_centre_distance)->Unit(benchmark::kNanosecond);

}  // namespace
