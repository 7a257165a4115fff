// Estimates the noise of drives from their numbers of teeth, with which a search ranks drives.
#include <cmath>
#include <vector>

#include "gearwright/base/parallel.hpp"
#include "gearwright/design/drive_space.hpp"
#include "gearwright/drive/windup.hpp"

namespace gearwright {

namespace {

// Every stage of a train has its own mesh frequency. The output torque T_o is set to 1. The ratio
// λ_m of the tooth load of a stage to T_o is therefore the torque on the wheel of the stage divided
// by the number of teeth of this wheel.
std::optional<double> noise_of_train(const StandardTeeth& teeth, const DriveCandidate& candidate) {
  std::vector<WindupMesh> meshes;
  double torque = 1.0;
  for (auto stage = candidate.stages.rbegin(); stage != candidate.stages.rend(); ++stage) {
    const auto& [z1, z2] = *stage;
    WindupMesh& mesh = meshes.emplace_back(teeth.mesh(z1, z2));
    mesh.frequency = meshes.size();
    mesh.weight = torque / z2 * (torque / z2);
    torque *= static_cast<double>(z1) / z2;
  }
  return windup_variation(meshes);
}

std::optional<double> noise_of_set(const DriveSearchProblem& problem, const StandardTeeth& teeth,
                                   const DriveCandidate& candidate) {
  PlanetarySpec set = set_of(problem, candidate);
  set.normal_module.reset();  // without a module, only speeds, loads and positions are computed
  auto graph = graph_of(set);
  if (!graph) return std::nullopt;
  const auto drive = make_drive({std::move(graph).take()});
  return drive ? windup_variation(*drive, teeth) : std::nullopt;
}

}  // namespace

void estimate_noise(const DriveSearchProblem& problem, std::vector<DriveCandidate>& candidates,
                    int threads) {
  const PerMember& helix = problem.base.helix_deg;
  StandardTeeth teeth{problem.base.normal_pressure_angle,
                      Angle::degrees(helix.each[0].value_or(helix.all.value_or(0.0)))};
  if (const auto& face = problem.base.face_width.all; face && !problem.modules.empty())
    teeth.face_modules = *face / problem.modules.front();
  parallel_for(
      candidates.size(),
      [&](std::size_t k) {
        DriveCandidate& one = candidates[k];
        one.noise =
            one.stages.empty() ? noise_of_set(problem, teeth, one) : noise_of_train(teeth, one);
      },
      threads);
}

}  // namespace gearwright
