#include "gearwright/drive/drive_forces.hpp"

#include <cmath>

#include "gearwright/base/units.hpp"
#include "gearwright/drive/drive_places.hpp"

namespace gearwright {

namespace {

// The working pitch cylinder of the first gear of a mesh, and its angles.
struct PitchCylinder {
  double radius, tan_transverse, tan_helix;
};

std::optional<PitchCylinder> pitch_cylinder(const Drive& drive, std::size_t mesh) {
  if (const auto& rack = drive.geometry.racks[mesh]) {
    const double r = rack->pinion.reference_diameter / 2;
    return PitchCylinder{r, std::tan(rack->pinion.reference().transverse_pressure_angle),
                         std::tan(rack->pinion.spec.helix_angle.rad())};
  }
  const ParallelPair* pair = drive.geometry.involutes(mesh);
  if (!pair) return std::nullopt;
  const auto& side = pair->mesh.rack.sides[0];
  return PitchCylinder{side.pitch_radius, side.tan_transverse, side.tan_helix};
}

// True if the torques of all meshes are known.
bool carries_torque(const Drive& drive) {
  return drive.flow && !drive.flow->self_locking() && drive.graph.torque_Nm;
}

}  // namespace

std::optional<MeshForces> mesh_forces(const Drive& drive, std::size_t mesh) {
  const DriveGraph& graph = drive.graph;
  const DriveMesh& m = graph.meshes[mesh];
  if (!carries_torque(drive)) return std::nullopt;
  const auto cylinder = pitch_cylinder(drive, mesh);
  if (!cylinder) return std::nullopt;
  const double torque = graph.gear(m, 0).factor() * drive.flow->load[mesh] *
                        from_newton_metres(*graph.torque_Nm) / graph.copies(m);
  const double F_t = torque / cylinder->radius;
  const bool halves = graph.gear(m, 0).double_helical.has_value();
  return MeshForces{F_t, std::abs(F_t) * cylinder->tan_transverse,
                    halves ? 0.0 : 0.0 - F_t * cylinder->tan_helix};
}

std::optional<BodyForces> body_forces(const Drive& drive, std::size_t body) {
  if (!carries_torque(drive)) return std::nullopt;
  const DriveGraph& graph = drive.graph;
  const auto places = drive_places(drive);
  if (!places) return std::nullopt;
  Vec2 force = Vec2::Zero(), moment = Vec2::Zero();
  double axial = 0.0;
  bool meshes = false;
  for (std::size_t k = 0; k < graph.meshes.size(); ++k) {
    const DriveMesh& m = graph.meshes[k];
    const std::size_t one = graph.gear(m, 0).body, two = graph.gear(m, 1).body;
    if (one != body && two != body) continue;
    meshes = true;
    const auto forces = mesh_forces(drive, k);
    if (!forces) return std::nullopt;
    const double radius = pitch_cylinder(drive, k)->radius;
    const bool rides = graph.bodies[body].carrier.has_value();
    for (int copy = 0; copy < (rides ? 1 : graph.copies(m)); ++copy) {
      const auto axis = [&](std::size_t b) {
        return places->axis_of(drive, b, graph.bodies[b].count > 1 ? copy : 0);
      };
      // The direction from the axis of the first gear to the pitch point. If the second gear is a
      // ring, this is also the direction from the axis of the ring to the axis of the first gear.
      const Vec2 u = graph.gear(m, 1).side() * (axis(two) - axis(one)).normalized();
      const Vec2 on_first = forces->tangential * Vec2(-u.y(), u.x()) - forces->separating * u;
      const double sign = one == body ? 1.0 : -1.0;
      force += sign * on_first;
      axial += sign * forces->axial;
      // The pitch point relative to the axis of this body.
      const Vec2 at = axis(one) + radius * u - axis(body);
      moment += sign * forces->axial * at;
    }
  }
  if (!meshes) return std::nullopt;
  return BodyForces{force.norm(), axial, moment.norm()};
}

}  // namespace gearwright
