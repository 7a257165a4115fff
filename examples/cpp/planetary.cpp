// A planetary set: its ratio, efficiency, speeds and play, each mesh as a pair of gears, and its solids.
#include <cstdio>

#include <gearwright/gearwright.hpp>

using namespace gearwright;

int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.message().c_str());
  return 1;
}

int main() {
  PlanetarySpec set;
  set.z(SetMember::sun) = 21;
  set.z(SetMember::planet) = 24;
  set.z(SetMember::ring) = 69;
  set.planets = 3;
  set.normal_module = 2.0;
  set.face_width.all = 20.0;
  set.allowance.all = -0.05;
  set.speeds_rpm = {1500.0};
  set.torque_Nm = 40.0;

  const Result<DriveGraph> graph = graph_of(set);  // the ring is fixed, the sun drives
  if (!graph) return fail(graph.error());
  const Result<Drive> drive = make_drive({*graph});
  if (!drive) return fail(drive.error());
  std::printf("ratio        %lld/%lld\n", *drive->motion.ratio->numerator(),
              *drive->motion.ratio->denominator());
  std::printf("efficiency   %.4f\n", drive->flow->efficiency);
  for (std::size_t b = 0; b < drive->graph.bodies.size(); ++b)
    std::printf("%-12s %9.3f 1/min\n", drive->graph.bodies[b].name.c_str(), *drive->speed_rpm(b));
  const PlanetSet& planets = drive->sets.front();
  std::printf("places       %lld, clearance %.3f mm\n", planets.assembly.places,
              planets.neighbours->clearance);
  for (std::size_t m = 0; m < drive->graph.meshes.size(); ++m)
    std::printf("%-12s contact ratio %.4f\n", drive->graph.meshes[m].name.c_str(),
                drive->geometry.pairs[m]->contact_ratio());
  const Result<DriveLayout> layout = drive_layout(*drive);
  if (!layout) return fail(layout.error());
  const auto solids = drive_solids(*drive, *layout);
  if (!solids) return fail(solids.error());
  std::printf("solids       %zu, for STEP, GLB and 3MF\n", solids->size());
  std::printf("play of the carrier  %.4f degrees\n", Angle::radians(drive->backlash->output).deg());
}

/* prints
ratio        30/7
efficiency   0.9902
sun           1500.000 1/min
ring             0.000 1/min
carrier        350.000 1/min
planet        -656.250 1/min
places       90, clearance 25.942 mm
sun_planet   contact ratio 1.5855
planet_ring  contact ratio 1.7600
solids       5, for STEP, GLB and 3MF
play of the carrier  0.1273 degrees
*/
