// Measures `run` on a helical pair, from the text of the spec to every file on disk. The aim is
// less than one second.
#include <benchmark/benchmark.h>

#include <filesystem>

#include "gearwright/job/files.hpp"

namespace {

using namespace gearwright;

constexpr const char* kSpec = R"(
[gear1]
teeth = 17
normal_module_mm = 2.5
helix_angle_deg = 15
profile_shift = 0.3
face_width_mm = 25
[gear2]
teeth = 43
normal_module_mm = 2.5
helix_angle_deg = -15
profile_shift = 0.1
face_width_mm = 25
)";

void spec_to_pair(benchmark::State& state) {
  for (auto _ : state) {
    const auto job = solve(read_spec(kSpec, SpecFormat::toml).value(), Scope::pair);
    benchmark::DoNotOptimize(job->pair->center_distance());
  }
}
BENCHMARK(spec_to_pair)->Unit(benchmark::kMicrosecond);

void run_everything(benchmark::State& state) {
  const auto folder = std::filesystem::temp_directory_path() / "gearwright_run_bench";
  const FileOptions options;
  for (auto _ : state) {
    SolvedJob job = solve(read_spec(kSpec, SpecFormat::toml).value(), Scope::everything).value();
    benchmark::DoNotOptimize(write_everything(job, folder, options)->files.size());
  }
  std::filesystem::remove_all(folder);
}
BENCHMARK(run_everything)->Unit(benchmark::kMillisecond);

}  // namespace
