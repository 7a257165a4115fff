#include "gearwright/drive/windup.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "gearwright/base/numbers.hpp"
#include "gearwright/drive/drive_phases.hpp"
#include "gearwright/math/lowest.hpp"
#include "gearwright/pair/contact_lines.hpp"

namespace gearwright {

namespace {

using detail::MeshPhase;

double path_of(const WindupMesh& mesh) { return mesh.approach + mesh.recess; }

// Returns the rotation that meshes of one frequency cause at the time t.
double rotation_at(const std::vector<const WindupMesh*>& meshes, double t) {
  double sum = 0.0;
  for (const WindupMesh* mesh : meshes) {
    const double path = path_of(*mesh);
    double copies = 0.0;
    for (const double delay : mesh->delays)
      copies +=
          path / contact_lines(path, mesh->overlap, t - delay + mesh->approach + mesh->overlap / 2);
    sum += mesh->weight * copies / static_cast<double>(mesh->delays.size());
  }
  return sum;
}

// Returns the times within a period at which the length of a contact line, or its rate of change,
// jumps. These times are called kinks.
std::vector<double> kinks_of(const std::vector<const WindupMesh*>& meshes) {
  std::vector<double> times{0.0, 1.0};
  for (const WindupMesh* mesh : meshes)
    for (const double delay : mesh->delays)
      for (const double turn :
           {0.0, path_of(*mesh), mesh->overlap, path_of(*mesh) + mesh->overlap}) {
        const double t = turn + delay - mesh->approach - mesh->overlap / 2;
        times.push_back(t - std::floor(t));
      }
  std::sort(times.begin(), times.end());
  return times;
}

double spread_of(const std::vector<const WindupMesh*>& meshes) {
  // Between two kinks, each λ is linear and positive, so the sum of all 1/λ is convex. For spur
  // gears, the sum jumps at a kink. It is therefore evaluated at the distance kNear before and
  // after the kink.
  constexpr double kNear = 1e-10;
  constexpr int kSteps = 30;  // the error of the value is then below 1e-12 times its curvature
  const auto rotation = [&](double t) { return rotation_at(meshes, t); };
  double least = 1e300, greatest = 0.0;
  const std::vector<double> times = kinks_of(meshes);
  for (std::size_t k = 1; k < times.size(); ++k) {
    const double lo = times[k - 1] + kNear, hi = times[k] - kNear;
    if (!(hi > lo + kNear)) continue;
    const double first = rotation(lo), last = rotation(hi);
    greatest = std::max({greatest, first, last});
    least = std::min({least, first, last, rotation(golden_section(rotation, lo, hi, kSteps))});
  }
  return greatest - least;
}

}  // namespace

std::optional<double> windup_variation(const std::vector<WindupMesh>& meshes) {
  std::map<std::size_t, std::vector<const WindupMesh*>> frequencies;
  double whole = 0.0;
  for (const WindupMesh& mesh : meshes) {
    if (!deflection_variation(std::max(0.0, path_of(mesh)), mesh.overlap)) return std::nullopt;
    frequencies[mesh.frequency].push_back(&mesh);
    whole += mesh.weight;
  }
  if (!(whole > 0.0)) return std::nullopt;
  double sum = 0.0;
  for (const auto& [frequency, list] : frequencies) sum += spread_of(list);
  return sum / whole;
}

namespace {

void place_in_time(WindupMesh& mesh, const MeshPhase& phase) {
  if (!phase.first_drives) std::swap(mesh.approach, mesh.recess);
  mesh.frequency = phase.first;
  mesh.delays = {phase.time};
  if (phase.phases.empty()) return;
  mesh.delays.clear();
  for (const Rational& delay : phase.phases)
    mesh.delays.push_back(phase.time + phase.sense * delay.value());
}

bool has_one_motion(const Drive& drive) {
  return drive.graph.inputs.size() == 1 && drive.motion.redundant.empty();
}

}  // namespace

std::optional<double> windup_variation(const Drive& drive) {
  if (!has_one_motion(drive)) return std::nullopt;
  const auto phases = detail::phases_of(drive);
  if (!phases) return std::nullopt;
  std::vector<WindupMesh> meshes;
  for (std::size_t m = 0; m < phases->size(); ++m) {
    const MeshPhase& phase = (*phases)[m];
    if (phase.idle()) continue;
    const ParallelPair* pair = drive.geometry.involutes(m);
    if (!pair || !(pair->mesh.true_ratio > 0.0)) return std::nullopt;
    const Mesh<double>& teeth = pair->mesh;
    WindupMesh& mesh = meshes.emplace_back();
    mesh.approach = (teeth.rho1_C - teeth.rho1_true_begin) / teeth.step;
    mesh.recess = (teeth.rho1_true_end - teeth.rho1_C) / teeth.step;
    mesh.overlap = teeth.overlap_ratio;
    place_in_time(mesh, phase);
    const double face = std::min(pair->input.face_width[0], pair->input.face_width[1]);
    mesh.weight = phase.weight * phase.weight / (static_cast<double>(mesh.delays.size()) * face);
  }
  return windup_variation(meshes);
}

WindupMesh StandardTeeth::mesh(int z1, int z2) const {
  const double cosine = std::cos(helix_angle.rad());
  const double alpha = std::atan(std::tan(normal_pressure_angle.rad()) / cosine);
  const double pitch = std::numbers::pi * std::cos(alpha) / cosine;
  // Returns the length of the path from the pitch point to the tip of a gear, in pitches.
  const auto part = [&](int z) {
    const double r = std::abs(z) / (2 * cosine);
    const double r_b = r * std::cos(alpha);
    const double r_a = std::max(r + side_of(z), r_b);
    return std::abs(std::sqrt(r_a * r_a - r_b * r_b) - r * std::sin(alpha)) / pitch;
  };
  const double overlap = face_modules * std::abs(std::sin(helix_angle.rad())) / std::numbers::pi;
  return {.approach = part(z2), .recess = part(z1), .overlap = overlap};
}

std::optional<double> windup_variation(const Drive& set, const StandardTeeth& teeth) {
  if (!has_one_motion(set) || set.sets.empty()) return std::nullopt;
  const DriveGraph& graph = set.graph;
  const auto to_output = lossless_loads(graph, set.motion, graph.output, graph.inputs.front());
  const auto to_input = lossless_loads(graph, set.motion, graph.inputs.front(), graph.output);
  std::vector<WindupMesh> meshes;
  std::map<int, double> first_passing;  // by the number of teeth of the planet gear
  for (std::size_t m = 0; m < graph.meshes.size(); ++m) {
    if (to_output[m].zero()) continue;
    if (!to_output[m].fits() || !to_input[m].fits()) return std::nullopt;
    const DriveGear& a = graph.gear(graph.meshes[m], 0);
    const DriveGear& b = graph.gear(graph.meshes[m], 1);
    const bool a_rides = graph.body(a).carrier.has_value();
    if (a_rides == graph.body(b).carrier.has_value()) return std::nullopt;
    const DriveGear& planet = a_rides ? a : b;
    MeshPhase phase;
    phase.first_drives = detail::first_drives(set, m, to_input[m].value());
    detail::find_delays(set, m, phase);
    // The tooth thickness is half a pitch. The sun and the ring are on opposite sides of the
    // planet.
    const double theta = (a_rides ? b : a).is_ring() ? 0.0 : 0.5;
    const double time = detail::passing_time(detail::turning(set, planet.body, m), planet.teeth,
                                             theta, phase.first_drives == a_rides, 0.25);
    phase.time = time - first_passing.emplace(planet.teeth, time).first->second;
    phase.first = static_cast<std::size_t>(planet.teeth);
    WindupMesh& mesh = meshes.emplace_back(teeth.mesh(a.teeth, b.teeth));
    place_in_time(mesh, phase);
    const double load = to_output[m].value();
    mesh.weight = load * load / static_cast<double>(mesh.delays.size());
  }
  return windup_variation(meshes);
}

}  // namespace gearwright
