// Measures triangle meshes and drawings. The time per gear is proportional to the number of teeth.
#include <benchmark/benchmark.h>

#include "gearwright/cad/dxf.hpp"
#include "gearwright/cad/mesh_files.hpp"
#include "gearwright/gear/gear.hpp"

namespace {

using namespace gearwright;

ToothedBody helical(int teeth) {
  CylindricalSpec spec;
  spec.teeth = teeth;
  spec.normal_module = 2.0;
  spec.helix_angle = Angle::degrees(15);
  spec.face_width = 20.0;
  const Gear gear = make_gear(spec).value();
  return {"gear", gear.tooth->outline, gear.twist(), spec.face_width, std::nullopt, {}};
}

void mesh(benchmark::State& state) {
  const ToothedBody body = helical(static_cast<int>(state.range(0)));
  std::size_t triangles = 0;
  for (auto _ : state) triangles = tessellate(body)->triangles.size();
  state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK(mesh)->Arg(20)->Arg(60)->Arg(200)->Unit(benchmark::kMillisecond);

template <std::string (*Write)(const std::vector<MeshPart>&)>
void mesh_file(benchmark::State& state) {
  const std::vector<MeshPart> parts{{"gear", tessellate(helical(60)).value(), {}}};
  std::size_t bytes = 0;
  for (auto _ : state) bytes = Write(parts).size();
  state.counters["MB"] = static_cast<double>(bytes) / 1e6;
}
BENCHMARK(mesh_file<stl_bytes>)->Name("stl_file/60")->Unit(benchmark::kMillisecond);
BENCHMARK(mesh_file<glb_bytes>)->Name("glb_file/60")->Unit(benchmark::kMillisecond);
BENCHMARK(mesh_file<threemf_bytes>)->Name("3mf_file/60")->Unit(benchmark::kMillisecond);

void dxf_arcs(benchmark::State& state) {
  const ToothedBody body = helical(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(dxf_drawing(body)->segments);
}
BENCHMARK(dxf_arcs)->Arg(20)->Arg(60)->Arg(200)->Unit(benchmark::kMillisecond);

}  // namespace
