#include "gearwright/design/ring_cuts.hpp"

#include "gearwright/gear/ring_cutter.hpp"

namespace gearwright {

namespace {

// Chooses the cutter for module 1. Every length is proportional to the module.
std::optional<RingCut> cut_of(const SearchProblem& problem, const Trial& trial, double shift) {
  CylindricalSpec spec;
  spec.teeth = trial.z2;
  spec.normal_module = 1.0;
  spec.normal_pressure_angle = problem.normal_pressure_angle;
  spec.helix_angle = trial.helix[1];
  spec.profile_shift = shift;
  spec.face_width = kFaceModules;  // has no effect on the tooth
  spec.rack = rack_of(problem, trial, 1);
  const auto ring = make_gear(spec);
  if (!ring) return std::nullopt;
  const auto cut = cut_by_default(*ring);
  if (!cut) return RingCut{};
  return RingCut{cut->cut_by->cutter_teeth, *cut->tooth->form_radius};
}

}  // namespace

std::optional<RingCut> RingCuts::of(const SearchProblem& problem, const Trial& trial,
                                    double shift) {
  const StraightRack rack = rack_of(problem, trial, 1);
  const Key key{trial.z2,      shift,         trial.helix[1],         problem.normal_pressure_angle,
                rack.addendum, rack.dedendum, rack.root_fillet_radius};
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = cuts_.find(key); found != cuts_.end()) return found->second;
  }
  const auto cut = cut_of(problem, trial, shift);
  const std::lock_guard lock(mutex_);
  constexpr std::size_t kMost = 1 << 16;  // limits the memory for stored cuts to a few megabytes
  if (cuts_.size() >= kMost) cuts_.clear();
  cuts_.emplace(key, cut);
  return cut;
}

std::size_t RingCuts::size() const {
  const std::lock_guard lock(mutex_);
  return cuts_.size();
}

}  // namespace gearwright
