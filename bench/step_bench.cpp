// Measures the STEP output of a helical gear with a 25 mm face, a bore and a keyway. The aims on
// one core are less than 30 ms for the text of a file with 60 teeth, and less than 100 ms with 200
// teeth. step_walls() measures only the walls, without the text.
//
// Counters: faces of the solid, megabytes of the file.

#include <benchmark/benchmark.h>

#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/step.hpp"
#include "gearwright/cad/testing/sample_outlines.hpp"
#include "gearwright/cad/walls.hpp"

namespace gearwright {
namespace {

ToothedBody helical(int teeth) {
  auto body = testing::sample_body({.teeth = teeth, .beta = 15 * kPi / 180, .face_width = 25});
  body.bore = Bore{20.0, 6.0, 2.8};
  return body;
}

void step_walls(benchmark::State& state) {
  const ToothedBody body = helical(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    auto walls = make_walls(body);
    benchmark::DoNotOptimize(walls);
  }
}
BENCHMARK(step_walls)->Arg(20)->Arg(60)->Unit(benchmark::kMillisecond);

void step_file(benchmark::State& state) {
  const ToothedBody body = helical(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    const auto document = step_document({body}, "gear.step");
    state.counters["MB"] = 1e-6 * static_cast<double>(document->text.size());
    state.counters["faces"] = static_cast<double>(document->report.face_count);
  }
}
BENCHMARK(step_file)->Arg(20)->Arg(60)->Arg(200)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gearwright
