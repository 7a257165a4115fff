// Measures one gear, from the spec to the outline and its points.
#include <benchmark/benchmark.h>

#include <optional>

#include "gearwright/gear/pinion_cut.hpp"

namespace {

using namespace gearwright;

CylindricalSpec spec(int teeth) {
  CylindricalSpec s;
  s.teeth = teeth;
  s.normal_module = 2.0;
  s.helix_angle = Angle::degrees(15);
  s.face_width = 20.0;
  s.rack = *iso53_rack("ISO53-A");
  return s;
}

// A gear with 9 teeth is undercut, so the intersection of flank and fillet must be computed. A gear
// with 25 teeth is not.
void make_gear_only(benchmark::State& state) {
  const CylindricalSpec s = spec(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(make_gear(s));
}
BENCHMARK(make_gear_only)->Arg(9)->Arg(25)->Unit(benchmark::kMicrosecond);

void make_gear_and_200_points_per_arc(benchmark::State& state) {
  const CylindricalSpec s = spec(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const auto gear = make_gear(s);
    for (const Arc& arc : gear->tooth->outline.arcs) benchmark::DoNotOptimize(sample(arc, 200));
  }
}
BENCHMARK(make_gear_and_200_points_per_arc)->Arg(9)->Arg(25)->Unit(benchmark::kMicrosecond);

// The gears are cut by a finished pinion: an external gear with 40 teeth and an internal gear with
// 60. Every point is computed from a point on the arc of the cutter, which in turn is computed from
// a point of the rack.
void pinion_cut_and_200_points_per_arc(benchmark::State& state) {
  CylindricalSpec s = spec(18);
  s.straight_rack().addendum = 1.25;
  const auto cutter = make_gear(s);
  const int teeth = static_cast<int>(state.range(0));
  const PinionCutSpec wanted{teeth, *generating_distance(*cutter, teeth, 0.0), 20.0, std::nullopt};
  for (auto _ : state) {
    const auto gear = make_pinion_cut_gear(*cutter, wanted);
    for (const Arc& arc : gear->tooth->outline.arcs) benchmark::DoNotOptimize(sample(arc, 200));
  }
}
BENCHMARK(pinion_cut_and_200_points_per_arc)->Arg(40)->Arg(-60)->Unit(benchmark::kMicrosecond);

// θ(ρ) of the fillet has no closed form, so each call solves an equation in a bracket.
void fillet_half_angle_at_a_radius(benchmark::State& state) {
  const auto gear = make_gear(spec(25));
  const Arc& arc = *gear->tooth->outline.find(ArcName::root_fillet);
  const double rho = 0.5 * (arc.begin_point.norm() + arc.end_point.norm());
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        arc.curve->polar_angle(arc.curve->parameter_at_radius(rho, arc.begin, arc.end)));
  }
}
BENCHMARK(fillet_half_angle_at_a_radius)->Unit(benchmark::kNanosecond);

}  // namespace
