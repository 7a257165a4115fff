// Measures whole drives: a set of three meshes compared with a pair, the search for sets without
// teeth, and `run` on a planetary stage. The aims: a set takes at most three times the time of a
// pair, the search processes at least 10⁶ sets per second and core, and `run` takes at most three
// seconds.
//
// Counters: `ratio` is the median over rounds of the time for the set divided by the time for the
// pair. Both are measured one after the other in each round. `per_s` is the number of sets per
// second on one thread.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <string>
#include <vector>

#include "bench/thread_seconds.hpp"
#include "gearwright/design/drive_search.hpp"
#include "gearwright/job/drive_job.hpp"
#include "gearwright/job/verbs.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace {

using namespace gearwright;

// A Wolfrom set with a sun: the meshes sun–planet, planet–ring and planet2–ring2.
constexpr const char* kSet = R"(
[planetary]
sun = 12
planet = 24
planet2 = 21
ring = 60
ring2 = 57
planets = 3
output = "ring2"
normal_module_mm = 1
face_width_mm = 12
profile_shift = { sun = 0.45, planet = 0.1, planet2 = 0.2 }
thickness_allowance_mm = -0.08
)";

// The mesh of sun and planet of this set, as a pair.
constexpr const char* kPair = R"(
[gear1]
teeth = 12
normal_module_mm = 1
face_width_mm = 12
profile_shift = 0.45
thickness_allowance_mm = -0.08
[gear2]
teeth = 24
normal_module_mm = 1
face_width_mm = 12
profile_shift = 0.1
thickness_allowance_mm = -0.08
)";

constexpr const char* kStage = R"(
[planetary]
sun = 21
planet = 33
ring = 87
planets = 4
normal_module_mm = 16
helix_angle_deg = 8
face_width_mm = 340
profile_shift = { sun = 0.3, planet = 0.2 }
thickness_allowance_mm = -0.25
input = "carrier"
output = "sun"
speed_rpm = 14
torque_Nm = 2050000
)";

void set_of_three_meshes_over_a_pair(benchmark::State& state) {
  const JobSpec set = read_spec(kSet, SpecFormat::toml).value();
  const JobSpec pair = read_spec(kPair, SpecFormat::toml).value();
  std::vector<double> ratios;
  for (auto _ : state) {
    const double of_set =
        thread_seconds_of([&] { benchmark::DoNotOptimize(answer_json("drive", set)->size()); });
    const double of_pair =
        thread_seconds_of([&] { benchmark::DoNotOptimize(answer_json("pair", pair)->size()); });
    ratios.push_back(of_set / of_pair);
  }
  state.counters["ratio"] = median(ratios);
}
BENCHMARK(set_of_three_meshes_over_a_pair)->Unit(benchmark::kMillisecond);

// The sets are rejected or found, and ranked by size, by their numbers of teeth only. The
// efficiencies that another objective would need are not computed.
void integer_stage_of_a_search(benchmark::State& state) {
  DriveSearchProblem problem;
  problem.kind = state.range(0) == 0 ? DriveKind::planetary : DriveKind::stepped;
  problem.objectives = {DriveObjective::size};
  problem.ratio = {4.0, 4.5};
  if (problem.kind == DriveKind::stepped) problem.ratio = {9.0, 9.1};
  state.SetLabel(std::string(kDriveKindNames[static_cast<std::size_t>(problem.kind)]));
  double tested = 0.0;
  for (auto _ : state) tested += static_cast<double>(search_drives(problem, 1).value().tested);
  state.counters["per_s"] = benchmark::Counter(tested, benchmark::Counter::kIsRate);
}
BENCHMARK(integer_stage_of_a_search)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

// From the text of the spec to every file on disk.
void run_planetary_stage(benchmark::State& state) {
  const auto folder = std::filesystem::temp_directory_path() / "gearwright_drive_bench";
  for (auto _ : state) {
    const DriveJob job = solve_whole_drive(read_spec(kStage, SpecFormat::toml).value()).value();
    benchmark::DoNotOptimize(write_drive_files(job, folder, {}).value().files.size());
  }
  std::filesystem::remove_all(folder);
}
BENCHMARK(run_planetary_stage)->Unit(benchmark::kMillisecond);

}  // namespace
