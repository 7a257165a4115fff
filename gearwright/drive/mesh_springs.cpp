#include "gearwright/drive/mesh_springs.hpp"

#include <fmt/format.h>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/parallel.hpp"
#include "gearwright/load/loaded_contact.hpp"

namespace gearwright::detail {

Error not_loaded(const std::string& rule, const std::string& mesh) {
  return {"load", "", mesh.empty() ? rule : fmt::format("{} (mesh {})", rule, mesh)};
}

std::vector<double> load_levels(int copies) {
  if (copies < 2) return {1.0};
  // An additional load level costs little time, because the compliance tables and the gaps take
  // most of it. The test LoadedDriveTest.SpringsAgreeWithDirectSolutions measures the errors
  // between the levels.
  std::vector<double> levels{0.06, 0.15, 0.3, 0.5, 0.75, 1.0, 1.35, 1.8, 2.0};
  if (copies > 2) levels.insert(levels.end(), {2.5, 3.0});
  return levels;
}

Result<MeshSprings> mesh_springs(const ContactSetup& setup, bool gear2_drives, LoadRequest request,
                                 const std::vector<double>& levels, double nominal,
                                 const std::vector<double>& rotations) {
  request.root_stress = false;
  request.torques.clear();
  for (const double level : levels)
    request.torques.push_back(level * nominal * setup.gear(1).base_radius());
  request.rotations.clear();
  for (const double rotation : rotations) request.rotations.push_back(Angle::radians(rotation));
  const auto compliance = pair_compliance(setup.gear(1), setup.gear(2), request);
  if (!compliance) return compliance.error();
  const ContactPair pair = setup.pair(gear2_drives);
  LoadedTurn turn(pair, setup.gear(1), setup.gear(2), *compliance, request);
  parallel_for(rotations.size(), [&](std::size_t i) { turn.solve(i, i + 1); });
  const LoadedContact contact = turn.result();
  // A missing result at or below an equal share of the load is an error. A missing result above an
  // equal share is allowed, because the curve F(δ) of the spring continues along its last tangent.
  for (std::size_t k = 0; k < levels.size(); ++k)
    for (const LoadedPosition& p : contact.torques[k].positions) {
      if (levels[k] > 1.0 || !p.unfinished) continue;
      if (contact.slices_too_fine)
        return Error{"load.slices", std::to_string(request.slices[0]),
                     "makes the slices narrower than the contact of a planet that carries an equal "
                     "share of the load; reduce the torque or the number of slices"};
      return Error{"load", "",
                   "has no result, because the forces of this mesh do not converge even under an "
                   "equal share of the load; reduce the torque or change load.slices"};
    }
  MeshSprings made;
  const double lead = setup.gear(2).base_radius() * pair.turned();
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    std::vector<SpringNode> nodes;
    for (std::size_t k = 0; k < levels.size(); ++k) {
      const LoadedPosition& p = contact.torques[k].positions[i];
      if (p.solved() && p.tangent > 0.0)
        nodes.push_back({p.approach, levels[k] * nominal, 1 / p.tangent});
    }
    if (nodes.empty())
      return Error{"load", "",
                   fmt::format("has no result at rotation1 = {}° of this mesh, because the teeth "
                               "do not touch or their forces do not converge",
                               format_number(request.rotations[i].deg()))};
    made.springs.emplace_back(std::move(nodes));
    made.leads.push_back(lead * contact.torques.front().positions[i].unloaded_te.rad());
  }
  return made;
}

}  // namespace gearwright::detail
