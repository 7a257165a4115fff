#include <algorithm>
#include <cmath>
#include <set>

#include "gearwright/arrange/drive_designs.hpp"
#include "gearwright/arrange/judge.hpp"
#include "gearwright/drive/drive_rating.hpp"
#include "gearwright/drive/windup.hpp"

namespace gearwright {

namespace {

bool has_gears(const Drive& drive) {
  return std::none_of(
      drive.geometry.faults.begin(), drive.geometry.faults.end(),
      [](const GeometryFault& f) { return f.kind == GeometryFault::Kind::not_coaxial; });
}

bool is_safe(const Drive& drive, const Safeties& required) {
  const auto holds = [&](FactorPair Rating::*safety, double least) {
    const auto own = least_safety(drive, safety);
    return !own || *own >= least;
  };
  return holds(&Rating::S_H, required.flank) && holds(&Rating::S_F, required.root);
}

Result<DriveInput> train(const DriveSearchProblem& problem, const DriveCandidate& c) {
  const PlanetarySpec& base = problem.base;
  std::vector<StageSpec> stages(c.stages.size());
  for (std::size_t k = 0; k < stages.size(); ++k) {
    PairStage& pair = stages[k].pair;
    pair.teeth = c.stages[k];
    pair.shifts = {base.profile_shift.all, base.profile_shift.all};
    if (const auto x = c.stage_shifts(k)) pair.shifts = {(*x)[0], (*x)[1]};
    if (!problem.modules.empty())
      pair.set_teeth({c.stage_module(k),
                      base.normal_pressure_angle,
                      stage_helix_deg(problem, k),
                      c.face_width ? c.face_width : base.face_width.all,
                      {base.allowance.all, base.allowance.all}});
    pair.set_allowances(base.series);
    pair.efficiency = base.efficiency.all;
    pair.backlash = base.backlash.all;
    stages[k].friction = base.friction;
  }
  stages.front().speeds_rpm = base.speeds_rpm;
  stages.front().torque_Nm = base.torque_Nm;
  return train_of(stages);
}

}  // namespace

Result<DriveInput> drive_of(const DriveSearchProblem& problem, const DriveCandidate& candidate) {
  if (!candidate.stages.empty()) return train(problem, candidate);
  PlanetarySpec set = set_of(problem, candidate);
  if (candidate.face_width) set.face_width = {candidate.face_width};
  for (std::size_t m = 0, g = 0; m < kSetMembers && g < candidate.shifts.size(); ++m) {
    if (candidate.teeth[m] == 0) continue;
    if (const auto& x = candidate.shifts[g++]) set.profile_shift.each[m] = x;
  }
  auto graph = graph_of(set);
  if (!graph) return graph.error();
  return DriveInput{std::move(graph).take()};
}

DriveOutcome DriveDesigner::operator()(DriveCandidate candidate) const {
  const bool same_cost = !problem_.module_per_stage && !problem_.asks(DriveObjective::efficiency) &&
                         !problem_.asks(DriveObjective::efficiency_backward) &&
                         !problem_.asks(DriveObjective::clearance) &&
                         !problem_.asks(DriveObjective::noise);
  std::optional<DriveOutcome> best;
  for (GearShifts& shifts : trials(candidate)) {
    if (best && same_cost && std::holds_alternative<FoundDrive>(*best)) break;
    candidate.shifts = std::move(shifts);
    DriveOutcome other =
        problem_.module_per_stage ? with_stage_modules(candidate) : sized(candidate);
    if (!best || is_better(other, *best)) best = std::move(other);
  }
  return best ? std::move(*best) : DriveFault::no_teeth;
}

std::optional<RatedTrain> DriveDesigner::rated(DriveCandidate candidate) const {
  if (problem_.face_width) candidate.face_width = greatest_face_width(problem_, candidate);
  RatedTrain best{candidate, std::vector<Safeties>(candidate.stages.size(), {0.0, 0.0})};
  bool any = false;
  for (GearShifts& shifts : trials(candidate)) {
    candidate.shifts = std::move(shifts);
    const auto safeties = stage_safeties(candidate);
    if (!safeties) continue;
    any = true;
    for (std::size_t k = 0; k < best.stages.size(); ++k) {
      best.stages[k].flank = std::max(best.stages[k].flank, (*safeties)[k].flank);
      best.stages[k].root = std::max(best.stages[k].root, (*safeties)[k].root);
    }
  }
  return any ? std::optional(std::move(best)) : std::nullopt;
}

double DriveDesigner::least_sliding(DriveCandidate candidate) const {
  std::vector<GearShifts> all = trials(candidate);
  double least = all.empty() ? 0.0 : kInfinity;
  for (GearShifts& shifts : all) {
    candidate.shifts = std::move(shifts);
    const auto made = made_from(candidate);
    const auto sliding = made ? greatest_sliding(made->geometry) : std::nullopt;
    least = std::min(least, sliding.value_or(0.0));
  }
  return least;
}

// The profile shifts to be tried. If the search gives shifts, only they are tried. The list is
// empty if the teeth of the candidate are impossible. The shifts do not depend on the face
// width.
std::vector<GearShifts> DriveDesigner::trials(DriveCandidate candidate) const {
  const PerMember& given = problem_.base.profile_shift;
  if (given.all || given.any()) return {candidate.shifts};
  if (problem_.face_width) candidate.face_width = greatest_face_width(problem_, candidate);
  const auto own = drive_of(problem_, candidate);
  return own ? shift_trials(own->graph) : std::vector<GearShifts>();
}

// The safeties of the stages of a train, each the smaller value of its two gears. None if the
// train cannot be made or rated.
std::optional<std::vector<Safeties>> DriveDesigner::stage_safeties(
    const DriveCandidate& candidate) const {
  auto made = made_from(candidate);
  if (!made || task_.rate(*made)) return std::nullopt;
  std::vector<Safeties> list;
  for (const auto& mesh : made->ratings) {
    if (!mesh) return std::nullopt;
    const Rating& r = mesh->rating;
    list.push_back(
        {std::min(r.S_H[0].value, r.S_H[1].value), std::min(r.S_F[0].value, r.S_F[1].value)});
  }
  return list;
}

// Raises the modules of the stages until every stage has the required safeties at the greatest
// face width. The smallest gear limits this width. If a stage with the greatest module is still
// too weak, the stage with the smallest pinion gets a greater module.
DriveOutcome DriveDesigner::with_stage_modules(DriveCandidate candidate) const {
  const Safeties& least = task_.required;
  candidate = with_modules(problem_, candidate, candidate.stage_modules);
  for (bool grows = true; grows;) {
    if (problem_.face_width) candidate.face_width = greatest_face_width(problem_, candidate);
    const auto safeties = stage_safeties(candidate);
    if (!safeties) break;
    std::vector<double> modules = candidate.stage_modules;
    std::set<std::size_t> raised;
    for (std::size_t k = 0; k < modules.size(); ++k) {
      if ((*safeties)[k].flank >= least.flank && (*safeties)[k].root >= least.root) continue;
      std::size_t stage = k;
      if (modules[k] == problem_.modules.back())
        for (std::size_t j = 0; j < modules.size(); ++j)
          if (modules[j] * candidate.stages[j][0] < modules[stage] * candidate.stages[stage][0])
            stage = j;
      raised.insert(stage);
    }
    for (const std::size_t k : raised) {
      const auto greater =
          std::upper_bound(problem_.modules.begin(), problem_.modules.end(), modules[k]);
      if (greater == problem_.modules.end()) return DriveFault::safety;
      modules[k] = *greater;
    }
    grows = !raised.empty();
    candidate = with_modules(problem_, std::move(candidate), modules);
    if (candidate.size > problem_.size_max) return DriveFault::safety;
  }
  return sized(std::move(candidate));
}

bool DriveDesigner::is_better(const DriveOutcome& a, const DriveOutcome& b) const {
  const auto costs = [&](const DriveOutcome& outcome) {
    const auto* found = std::get_if<FoundDrive>(&outcome);
    std::vector<double> list;
    for (const DriveObjective o : problem_.objectives)
      list.push_back(found ? cost_of(problem_, found->candidate, o) : kInfinity);
    return list;
  };
  return costs(a) < costs(b);
}

DriveOutcome DriveDesigner::sized(DriveCandidate candidate) const {
  if (!problem_.face_width) return with_width(std::move(candidate));
  // The least sufficient width in whole steps is found by bisection, because the safeties grow
  // with the width. Limits that are whole numbers of steps may have a rounding error, which
  // kRounding compensates.
  constexpr double kRounding = 1e-9;
  const double step = task_.face_step;
  // 33 steps of 1.27 mm are 41.91 mm, without the rounding error of the product.
  constexpr double kPlaces = 1e6;
  const auto whole_steps = [&](double steps) {
    return std::round(steps * step * kPlaces) / kPlaces;
  };
  double low = std::ceil((*problem_.face_width)[0] / step - kRounding) - 1.0;
  double high = std::floor(greatest_face_width(problem_, candidate) / step + kRounding);
  if (high <= low) return DriveFault::safety;
  candidate.face_width = whole_steps(high);
  DriveOutcome best = with_width(candidate);
  if (!std::holds_alternative<FoundDrive>(best)) return best;
  while (high - low > 1.0) {
    const double middle = std::floor((low + high) / 2);
    candidate.face_width = whole_steps(middle);
    DriveOutcome narrower = with_width(candidate);
    if (std::holds_alternative<FoundDrive>(narrower)) {
      best = std::move(narrower);
      high = middle;
    } else {
      low = middle;
    }
  }
  return best;
}

std::optional<Drive> DriveDesigner::made_from(const DriveCandidate& candidate) const {
  const auto own = drive_of(problem_, candidate);
  if (!own) return std::nullopt;
  auto made = make_drive(*own);
  return made ? std::optional(std::move(made).take()) : std::nullopt;
}

DriveOutcome DriveDesigner::with_width(DriveCandidate candidate) const {
  auto made = made_from(candidate);
  if (!made || !has_gears(*made)) return DriveFault::no_teeth;
  Drive& drive = *made;
  if (!drive.sets.empty() && drive.sets.front().neighbours) {
    candidate.clearance = drive.sets.front().neighbours->clearance / candidate.module;
    if (candidate.clearance < problem_.neighbour_clearance) return DriveFault::neighbours;
  }
  if (greatest_sliding(drive.geometry).value_or(0.0) > problem_.sliding) return DriveFault::sliding;
  if (task_.rate) {
    if (drive.flow && drive.flow->self_locking()) return DriveFault::safety;
    if (auto error = task_.rate(drive)) return *error;
    if (!is_safe(drive, task_.required)) return DriveFault::safety;
  }
  const bool any_spacing = problem_.base.spacing == Spacing::nearest;
  if (drive_level(drive, task_.required, !any_spacing) != Level::green) return DriveFault::verdict;
  if (drive.flow) candidate.efficiency = drive.flow->efficiency;
  if (drive.backward) candidate.efficiency_backward = drive.backward->efficiency;
  if (problem_.asks(DriveObjective::noise) && !problem_.modules.empty())
    candidate.noise = windup_variation(drive);
  return FoundDrive{std::move(candidate), std::move(drive)};
}

}  // namespace gearwright
