// Measures tooth contact and compares it with a solution of the five equations by Newton steps with
// an analytic Jacobian (tests/oracle/five_equation_fast.hpp). Both methods start each position from
// the preceding ones. The counter `ratio` is the time per position of gearwright/contact divided by
// the time per position of the five equations, measured in the same run. If it is below 1,
// gearwright/contact is faster.
//
// In the comparison of curves, a position computed by gearwright/contact includes all tooth pairs
// and all edges. A position computed by the five equations is always one tooth pair without edges.
#include <benchmark/benchmark.h>

#include <numbers>
#include <utility>
#include <vector>

#include "bench/thread_seconds.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/error_map.hpp"
#include "gearwright/contact/pattern.hpp"
#include "gearwright/pair/pair.hpp"
#include "tests/oracle/contact_gears.hpp"
#include "tests/oracle/five_equation_fast.hpp"

namespace {

using namespace gearwright;
using oracle::contact_set;
using oracle::ContactSet;
using oracle::tca::ArcPair;
using oracle::tca::FastArcTouch;
using oracle::tca::Real;

constexpr int kPositions = 64;

// m = 4, 16 : 48 teeth, λ = 70°, contact at 30°, face width 1.3 axial pitches, with shaft errors.
ArcPair arcs() {
  constexpr Real kDegree = std::numbers::pi_v<Real> / 180;
  ArcPair p;
  p.teeth_1 = 16, p.teeth_2 = 48;
  p.lead_angle_f = p.lead_angle_p = 70 * kDegree;
  const Real m = 4, sine = std::sin(p.lead_angle_f);
  p.pitch_radius_1 = p.teeth_1 * m / (2 * sine), p.pitch_radius_2 = p.teeth_2 * m / (2 * sine);
  p.f = {1.4L * m, 0.42L * m, 0.24L * m, 12 * kDegree, 52 * kDegree};
  p.p = {1.55L * m, p.f.a + 0.15L * m * std::cos(30 * kDegree),
         p.f.b + 0.15L * m * std::sin(30 * kDegree), 13 * kDegree, 51 * kDegree};
  p.mounting.center_distance = p.pitch_radius_1 + p.pitch_radius_2;
  p.mounting.d_center = 0.02L, p.mounting.crossing = 2e-4L, p.mounting.intersecting = 1e-4L;
  p.half_face_1 = p.half_face_2 = 24;
  return p;
}

ContactSet involutes(double crossing, double lead_crowning) {
  const auto gear = [](int teeth, double beta) {
    CylindricalSpec s;
    s.teeth = teeth;
    s.normal_module = 2.0;
    s.helix_angle = Angle::degrees(beta);
    s.face_width = 20.0;
    s.rack = *iso53_rack("ISO53-A");
    return std::move(make_gear(s)).take();
  };
  ContactSet set{{gear(20, 15), gear(41, -15)}, {}, {}};
  set.mount.center_distance =
      (set.gears[0].reference_diameter + set.gears[1].reference_diameter) / 2;
  set.mount.errors.crossing = Angle::radians(crossing);
  if (lead_crowning != 0.0) {
    FlankModifications m;
    m.lead_crowning = lead_crowning;
    const Gear& g = set.gears[0];
    set.removal[0] = std::make_shared<RemovalField>(
        m, FlankExtent{g.base_radius(), *g.root_form_radius(), g.tip_form_radius(), 20.0});
  }
  return set;
}

// 64 positions of one tooth pair. The start value of each is extrapolated linearly from the last
// two positions.
struct FiveEquations {
  FastArcTouch fast;
  double step;
  FastArcTouch::Position before, last;

  FiveEquations(const ArcPair& pair, double theta, double first, double pitch_step)
      : fast(pair), step(pitch_step) {
    FastArcTouch::Position start;
    start.theta_1 = start.theta_2 = theta;
    before = fast.solve(first, start);
    last = fast.solve(first + step, before);
  }

  double run(double first, long& iterations) const {
    FastArcTouch::Position p = before, q = last;
    double sum = 0.0;
    for (int i = 2; i < kPositions + 2; ++i) {
      const auto next = fast.solve(first + i * step, FastArcTouch::beyond(p, q));
      p = q;
      q = next;
      sum += next.rotation_2;
      iterations += next.iterations;
    }
    return sum;
  }
};

struct OnePairOfFlanks {
  GapField field;
  TouchSearch search;
  double step;
  Touch before, last;

  OnePairOfFlanks(const ContactPair& pair, double first, double pitch_step)
      : field(pair.field(pair.patches(1)[0], pair.patches(2)[0])),
        search(field, pair.mesh_azimuth(), pair.reach()),
        step(pitch_step) {
    field.set_rotation(first);
    before = search.cold();
    field.set_rotation(first + step);
    last = search.from(before.s, before.z, before.s2, before.active);
  }

  double run(double first, long& evaluations) {
    Touch p = before, q = last;
    double sum = 0.0;
    for (int i = 2; i < kPositions + 2; ++i) {
      field.set_rotation(first + i * step);
      const Touch next = search.from(2 * q.s - p.s, 2 * q.z - p.z, q.s2, q.active);
      p = q;
      q = next;
      sum += next.te;
      evaluations += next.evaluations;
    }
    return sum;
  }
};

void race(benchmark::State& state, bool whole_curve) {
  const ArcPair pair = arcs();
  const ContactPair contact = contact_set(pair).pair();
  const double step = contact.pitch() / kPositions, first = -0.5 * contact.pitch();
  const FiveEquations other(pair, std::numbers::pi / 6, first, step);
  OnePairOfFlanks one(contact, first, step);
  double room = 0.0, five = 0.0;
  long iterations = 0, evaluations = 0;
  for (auto _ : state) {
    double start = thread_seconds();
    if (whole_curve) {
      benchmark::DoNotOptimize(transmission_error(contact, kPositions));
    } else {
      benchmark::DoNotOptimize(one.run(first, evaluations));
    }
    room += thread_seconds() - start;
    start = thread_seconds();
    benchmark::DoNotOptimize(other.run(first, iterations));
    five += thread_seconds() - start;
  }
  const double all = static_cast<double>(state.iterations()) * kPositions;
  state.counters["room_ns"] = 1e9 * room / all;
  state.counters["five_ns"] = 1e9 * five / all;
  state.counters["ratio"] = room / five;
  state.counters["five_steps"] = static_cast<double>(iterations) / all;
  if (!whole_curve) state.counters["room_steps"] = static_cast<double>(evaluations) / all;
}

void contact_race_per_position_of_a_curve(benchmark::State& state) { race(state, true); }
BENCHMARK(contact_race_per_position_of_a_curve)->Unit(benchmark::kMicrosecond);

void contact_race_one_tooth_pair(benchmark::State& state) { race(state, false); }
BENCHMARK(contact_race_one_tooth_pair)->Unit(benchmark::kMicrosecond);

// Measures transmission error curves. The counters contain the work for one curve.
void curve(benchmark::State& state, const ContactSet& set) {
  const ContactPair pair = set.pair();
  long evaluations = 0, searches = 0, colds = 0;
  for (auto _ : state) {
    Transmission transmission(pair);
    benchmark::DoNotOptimize(transmission.over_a_pitch(-0.5 * pair.pitch(), kPositions));
    const TouchCount n = transmission.count();
    evaluations = n.evaluations, searches = n.searches, colds = n.cold_starts;
  }
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations()));
  state.counters["evaluations"] = static_cast<double>(evaluations);
  state.counters["searches"] = static_cast<double>(searches);
  state.counters["colds"] = static_cast<double>(colds);
}

void contact_curve_circular_arcs(benchmark::State& state) { curve(state, contact_set(arcs())); }
BENCHMARK(contact_curve_circular_arcs)->Unit(benchmark::kMicrosecond);

void contact_curve_misaligned_involutes(benchmark::State& state) {
  curve(state, involutes(2e-4, 0.0));
}
BENCHMARK(contact_curve_misaligned_involutes)->Unit(benchmark::kMicrosecond);

void contact_curve_crowned_involutes(benchmark::State& state) {
  curve(state, involutes(2e-4, 0.01));
}
BENCHMARK(contact_curve_crowned_involutes)->Unit(benchmark::kMicrosecond);

// Measures an analysis that includes curvatures, contact ellipses and all six derivatives.
void contact_analysis_circular_arcs(benchmark::State& state) {
  const ContactPair pair = contact_set(arcs()).pair();
  ContactRequest request;
  for (const ErrorKind k : kErrorKinds) request.influences.push_back({k});
  for (auto _ : state) benchmark::DoNotOptimize(analyse_contact(pair, request));
}
BENCHMARK(contact_analysis_circular_arcs)->Unit(benchmark::kMicrosecond);

// Computes a map of 100 × 100 pairs of errors. Each node is a transmission error curve with 64
// positions. The argument is the number of threads.
void contact_map_of_two_errors(benchmark::State& state, const ContactSet& set) {
  std::vector<double> x, y;
  for (int i = 0; i < 100; ++i) x.push_back(4e-6 * (i - 50)), y.push_back(1e-3 * (i - 50));
  const auto te_at = [&set](double crossing, double d_center) {
    ContactSet s = set;
    s.mount.errors.crossing = Angle::radians(crossing), s.mount.errors.center_distance = d_center;
    return transmission_error(s.pair(), kPositions);
  };
  for (auto _ : state) {
    benchmark::DoNotOptimize(map_of_errors(x, y, te_at, static_cast<int>(state.range(0))));
  }
}
BENCHMARK_CAPTURE(contact_map_of_two_errors, circular_arcs, contact_set(arcs()))
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(contact_map_of_two_errors, involutes, involutes(0.0, 0.0))
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void contact_pattern_of_both_flanks(benchmark::State& state) {
  const ContactPair pair = contact_set(arcs()).pair();
  for (auto _ : state) benchmark::DoNotOptimize(contact_pattern(pair, kPositions));
}
BENCHMARK(contact_pattern_of_both_flanks)->Unit(benchmark::kMillisecond);

}  // namespace
