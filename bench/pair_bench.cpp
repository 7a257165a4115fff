// Measures one pair: the closed-form mesh, and the complete mounting with its clearances.
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

ParallelPair some_pair() {
  const Gear g1 = gear(20, 15), g2 = gear(41, -15);
  const double a = (g1.reference_diameter + g2.reference_diameter) / 2 + 0.05;
  return std::move(mount_as<ParallelPair>(g1, g2, {a})).take();
}

void mesh_of_parallel_axes(benchmark::State& state) {
  const MeshInput<double> in = some_pair().input;
  for (auto _ : state) benchmark::DoNotOptimize(mesh_of(in));
}
BENCHMARK(mesh_of_parallel_axes)->Unit(benchmark::kNanosecond);

void mount_on_parallel_axes(benchmark::State& state) {
  const ParallelPair p = some_pair();
  for (auto _ : state) {
    benchmark::DoNotOptimize(mount_as<ParallelPair>(p.gears[0], p.gears[1], {p.center_distance}));
  }
}
BENCHMARK(mount_on_parallel_axes)->Unit(benchmark::kMicrosecond);

void fillet_clearance_of_one_gear(benchmark::State& state) {
  const ParallelPair p = some_pair();
  for (auto _ : state) benchmark::DoNotOptimize(fillet_clearance(p, 1));
}
BENCHMARK(fillet_clearance_of_one_gear)->Unit(benchmark::kMicrosecond);

void shifts_from_a_centre_distance(benchmark::State& state) {
  ShiftProblem p;
  p.z1 = 20;
  p.z2 = 41;
  p.normal_module = 2.0;
  p.normal_pressure_angle = Angle::radians(0.349);
  p.center_distance = 61.7;
  for (auto _ : state) benchmark::DoNotOptimize(complete_shifts(p));
}
BENCHMARK(shifts_from_a_centre_distance)->Unit(benchmark::kNanosecond);

// The pair of screw gears in the paper by Mägi: 9 and 15 teeth, axes at 90°.
MeshInput<double> screws() {
  MeshInput<double> in;
  constexpr double kDegree = 0.017453292519943295;
  in.gears = {BaseGear<double>{9, 37.4892228898867 / 2, 7.263, 47.408 * kDegree},
              BaseGear<double>{15, 52.6687933717901 / 2, 7.618, 36.595 * kDegree}};
  in.tip_form_radius = {46.65 / 2, 65.27 / 2};
  in.face_width = {30.0, 30.0};
  in.shaft_angle = 90 * kDegree;
  in.center_distance = 50.05;
  return in;
}

// Computes all quantities of a crossed pair: the mesh, backlash, line of action, face widths,
// sliding at both ends, efficiency, and the backlash-free and the minimum centre distance.
double all_of(const MeshInput<double>& in) {
  const Mesh<double> m = mesh_of(in);
  const FaceWidths<double> f = face_widths(m);
  const auto a = specific_sliding(in, m, m.rho1_A);
  const auto e = specific_sliding(in, m, m.rho1_E);
  const auto eta = efficiency(sliding_shares(in, m), 0.05);
  const CrossedPlace least = crossed_place(in.gears, *transverse_angle_at_min_distance(in.gears));
  return m.path_ratio + f.both_flanks[0] + *a.zeta_1 + *e.zeta_2 + *eta.gear1_drives +
         conjugate_center_distance(in.gears, m.rack) + least.center_distance;
}

void crossed_pair_all_data(benchmark::State& state) {
  const MeshInput<double> in = screws();
  for (auto _ : state) benchmark::DoNotOptimize(all_of(in));
}
BENCHMARK(crossed_pair_all_data)->Unit(benchmark::kNanosecond);

void crossed_pair_with_its_range(benchmark::State& state) {
  const MeshInput<double> in = screws();
  for (auto _ : state) {
    benchmark::DoNotOptimize(all_of(in));
    benchmark::DoNotOptimize(contact_ratio_range(in));
  }
}
BENCHMARK(crossed_pair_with_its_range)->Unit(benchmark::kNanosecond);

void crossed_pair_over_1000_shaft_angles(benchmark::State& state) {
  MeshInput<double> in = screws();
  for (auto _ : state) {
    for (int i = 0; i < 1000; ++i) {
      in.shaft_angle = 1.52 + 1e-4 * i;
      benchmark::DoNotOptimize(all_of(in));
    }
  }
}
BENCHMARK(crossed_pair_over_1000_shaft_angles)->Unit(benchmark::kMillisecond);

void mount_on_crossed_axes(benchmark::State& state) {
  const Gear g1 = gear(20, 45), g2 = gear(30, 45);
  const PairSpec place{71.0, Angle::radians(1.5707963267948966), 0.05};
  for (auto _ : state) benchmark::DoNotOptimize(mount_as<CrossedPair>(g1, g2, place));
}
BENCHMARK(mount_on_crossed_axes)->Unit(benchmark::kMicrosecond);

}  // namespace
