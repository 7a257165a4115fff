#include "gearwright/load/loaded_halves.hpp"

#include <algorithm>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

void reverse(Eigen::VectorXd& along_face) { along_face.reverseInPlace(); }

void mirror(LoadedPair& p) {
  reverse(p.line_load);
  reverse(p.pressure);
  reverse(p.half_width);
  std::reverse(p.radius.begin(), p.radius.end());
  for (double& z : p.point.height) z = -z;
  for (auto& of_gear : p.point.half_axis)
    for (Eigen::Vector2d& axis : of_gear) axis[0] = -axis[0];
}

LoadedPosition whole(const LoadedPosition& a, const LoadedPosition& b) {
  LoadedPosition p;
  p.rotation1 = a.rotation1;
  p.unfinished = a.unfinished || b.unfinished;
  if (!a.solved() || !b.solved()) return p;
  const LoadedPosition& harder = b.max_pressure > a.max_pressure ? b : a;
  p.te = (a.te + b.te) / 2;
  p.unloaded_te = (a.unloaded_te + b.unloaded_te) / 2;
  p.approach = (a.approach + b.approach) / 2;
  p.force = a.force + b.force;
  // The mean of both halves is divided by 2, because each half carries half of the force.
  p.tangent = (a.tangent + b.tangent) / 4;
  p.max_pressure = harder.max_pressure;
  p.max_width_ratio = std::max(a.max_width_ratio, b.max_width_ratio);
  p.kind = harder.kind;
  p.edge_carries = a.edge_carries || b.edge_carries;
  for (std::size_t g = 0; g < 2; ++g)
    p.root_stress[g] = std::max(a.root_stress[g], b.root_stress[g]);
  p.iterations = a.iterations + b.iterations;
  return p;
}

}  // namespace

LoadedContact second_half(LoadedContact image, Angle behind, bool whole_pitch) {
  for (FaceSlices& slices : image.slices) slices = slices.reflected();
  for (LoadedTorque& t : image.torques) {
    bool all = true;
    for (LoadedPosition& p : t.positions) {
      p.rotation1 = p.rotation1 - behind;
      all = all && p.solved();
      for (LoadedPair& pair : p.pairs) mirror(pair);
    }
    if (whole_pitch && all) t.harmonics = harmonics(t.positions);
    reverse(t.face_load);
    for (auto* field : {&t.root_stress, &t.least_root_stress})
      for (Eigen::MatrixXd& of_gear : *field) of_gear.rowwise().reverseInPlace();
  }
  return image;
}

LoadedContact whole_load(const std::array<const LoadedContact*, 2>& half, const Gear& gear_1,
                         bool whole_pitch) {
  const auto& [a, b] = half;
  GW_EXPECTS(a->torques.size() == b->torques.size());
  LoadedContact found;
  found.regime = a->regime;
  found.slices = a->slices;
  found.body_twist = a->body_twist;
  found.unfinished = a->unfinished + b->unfinished;
  found.slices_too_fine = a->slices_too_fine || b->slices_too_fine;
  const SummaryBasis basis{2 * (a->slices[0].hi - a->slices[0].lo),
                           a->regime == LoadRegime::line ? gear_1.base_radius() : 0.0,
                           a->body_twist[0] + a->body_twist[1], whole_pitch, a->regime};
  for (std::size_t k = 0; k < a->torques.size(); ++k) {
    const LoadedTorque& s = a->torques[k];
    const LoadedTorque& t = b->torques[k];
    GW_EXPECTS(s.torque == t.torque && s.positions.size() == t.positions.size());
    LoadedTorque both;
    both.torque = 2 * s.torque;
    for (std::size_t i = 0; i < s.positions.size(); ++i)
      both.positions.push_back(whole(s.positions[i], t.positions[i]));
    summarise(both, basis);
    both.max_share = std::max(s.max_share, t.max_share);
    both.face_load_factor = std::max(s.face_load_factor, t.face_load_factor);
    both.transverse_load_factor = std::max(s.transverse_load_factor, t.transverse_load_factor);
    both.beyond_flank = s.beyond_flank || t.beyond_flank;
    for (std::size_t g = 0; g < 2; ++g)
      both.least_at_max[g] = (t.max_root_stress[g] > s.max_root_stress[g] ? t : s).least_at_max[g];
    found.torques.push_back(std::move(both));
  }
  return found;
}

}  // namespace gearwright
