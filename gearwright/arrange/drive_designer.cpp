#include <algorithm>
#include <cmath>

#include "gearwright/arrange/drive_designs.hpp"
#include "gearwright/arrange/judge.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/design/design_strength.hpp"
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

// Returns the least overlap ratio of the meshes, or infinity if no mesh has involute teeth.
double least_overlap(const DriveGeometry& geometry) {
  double least = kInfinity;
  for (std::size_t m = 0; m < geometry.pairs.size(); ++m)
    if (const ParallelPair* pair = geometry.involutes(m))
      least = std::min(least, pair->mesh.overlap_ratio);
  return least;
}

// Returns the mass of all gears with all copies of the planets, kg.
double mass_of(const DriveSearchProblem& problem, const Drive& drive) {
  const std::vector<std::string> members = set_member_names();
  double sum = 0.0;
  for (std::size_t g = 0; g < drive.graph.gears.size(); ++g) {
    const DriveGear& named = drive.graph.gears[g];
    const Gear& gear = *drive.geometry.gears[g];
    const auto member = std::find(members.begin(), members.end(), named.name);
    const double density =
        problem
            .density[member == members.end() ? 0
                                             : static_cast<std::size_t>(member - members.begin())];
    sum += drive.graph.body(named).count *
           GearBody{density,           gear.spec.face_width, gear.spec.teeth,
                    gear.tip_diameter, gear.root_diameter,   gear.spec.normal_module}
               .mass();
  }
  return sum;
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
                      c.face_widths.empty() ? base.face_width.all : c.face_widths[k],
                      {base.allowance.all, base.allowance.all}});
    pair.set_allowances(base.series);
    pair.efficiency = base.efficiency.all;
    pair.backlash = base.backlash.all;
    stages[k].friction = base.friction;
  }
  // Without shifts, the centre distances of the stages differ, so coaxial axes are required only if
  // there are shifts.
  stages.back().pair.coaxial = is_coaxial(problem, c) && !c.shifts.empty();
  stages.front().speeds_rpm = base.speeds_rpm;
  stages.front().torque_Nm = base.torque_Nm;
  return train_of(stages);
}

}  // namespace

Result<DriveInput> drive_of(const DriveSearchProblem& problem, const DriveCandidate& candidate) {
  if (!candidate.stages.empty()) return train(problem, candidate);
  PlanetarySpec set = set_of(problem, candidate);
  if (!candidate.face_widths.empty()) set.face_width = member_face_widths(candidate);
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
                         !problem_.asks(DriveObjective::noise) &&
                         !problem_.asks(DriveObjective::mass);
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
  if (candidate.face_widths.empty()) candidate = widest(problem_, std::move(candidate));
  RatedTrain best{candidate, std::vector<Safeties>(candidate.stages.size(), {0.0, 0.0})};
  bool any = false;
  for (GearShifts& shifts : trials(candidate)) {
    candidate.shifts = std::move(shifts);
    const auto safeties = mesh_safeties(candidate);
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

// Returns the profile shifts to be tried. If [search] gives shifts, only the shifts of the
// candidate are tried. Otherwise, the shifts are computed with the greatest face widths, so they do
// not depend on the face widths of the candidate. The list is empty if the teeth of the candidate
// are impossible or have no centre distance within the limits.
std::vector<GearShifts> DriveDesigner::trials(DriveCandidate candidate) const {
  const PerMember& given = problem_.base.profile_shift;
  if (given.all || given.any()) return {candidate.shifts};
  const bool coaxial = is_coaxial(problem_, candidate);
  candidate.shifts.clear();
  const auto own = drive_of(problem_, widest(problem_, std::move(candidate)));
  if (!own) return {};
  std::vector<GearShifts> all = shift_trials(own->graph, problem_.center_distance);
  if (!coaxial) return all;
  // Every stage gets the centre distance of the first stage. The profile shift of the wheel of each
  // later stage is computed from this distance.
  for (GearShifts& shifts : all) {
    DriveGraph graph = own->graph;
    for (std::size_t g = 0; g < shifts.size(); ++g) graph.gears[g].shift = shifts[g];
    const auto distance = drive_geometry(graph).distance.front();
    for (std::size_t m = 1; m < graph.meshes.size(); ++m) {
      graph.meshes[m].center_distance = distance;
      graph.gears[graph.meshes[m].gears[1]].shift.reset();
    }
    shifts = drive_geometry(graph).shift;
  }
  return all;
}

// Returns the safeties of the meshes. The safety of a mesh is the smaller value of its two gears.
// It is infinite for a mesh without load. Returns none if the drive cannot be made or rated.
std::optional<std::vector<Safeties>> DriveDesigner::mesh_safeties(
    const DriveCandidate& candidate) const {
  auto made = made_from(candidate);
  if (!made || task_.rate(*made)) return std::nullopt;
  std::vector<Safeties> list;
  for (const auto& mesh : made->ratings) {
    list.push_back({kInfinity, kInfinity});
    if (!mesh) continue;
    const Rating& r = mesh->rating;
    list.back() = {std::min(r.S_H[0].value, r.S_H[1].value),
                   std::min(r.S_F[0].value, r.S_F[1].value)};
  }
  return list;
}

// Raises the modules until every stage has the required safeties at its greatest face width.
DriveOutcome DriveDesigner::with_stage_modules(DriveCandidate candidate) const {
  candidate = with_modules(problem_, candidate, candidate.stage_modules);
  for (bool grows = true; grows;) {
    const auto safeties = mesh_safeties(widest(problem_, candidate));
    if (!safeties) break;
    std::vector<double> modules = candidate.stage_modules;
    grows = false;
    for (std::size_t k = 0; k < modules.size(); ++k) {
      if (holds((*safeties)[k], task_.required)) continue;
      const auto greater =
          std::upper_bound(problem_.modules.begin(), problem_.modules.end(), modules[k]);
      if (greater == problem_.modules.end()) return DriveFault::safety;
      modules[k] = *greater;
      grows = true;
    }
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

// Returns the least widths of the meshes, in steps, with which all meshes have the required
// safeties. If any width above the lower limit is reduced by one more step, at least one mesh no
// longer has them. `below` is one step less than the lower limit.
std::vector<double> DriveDesigner::least_steps(DriveCandidate candidate, double below,
                                               const std::vector<double>& greatest) const {
  const std::size_t meshes = greatest.size();
  const auto are_held = [&](const std::vector<double>& steps) {
    set_steps(candidate, steps);
    const auto safeties = mesh_safeties(candidate);
    std::vector<char> held(meshes, 0);
    for (std::size_t m = 0; safeties && m < meshes; ++m)
      held[m] = holds((*safeties)[m], task_.required);
    return held;
  };
  // The safeties of a mesh depend mainly on its own width. A single bisection can therefore find
  // the widths of all meshes at the same time.
  std::vector<double> low(meshes, below), least = greatest, middle(meshes);
  for (bool open = true; open;) {
    open = false;
    for (std::size_t m = 0; m < meshes; ++m) {
      middle[m] = std::ceil((low[m] + least[m]) / 2);
      open = open || least[m] - low[m] > 1.0;
    }
    if (!open) break;
    const auto held = are_held(middle);
    for (std::size_t m = 0; m < meshes; ++m)
      if (least[m] - low[m] > 1.0) (held[m] ? least[m] : low[m]) = middle[m];
  }
  // A tooth that is wider than the mating tooth has a greater root safety, so the widths of the
  // meshes of a planet depend slightly on each other. Widths that are too small after the bisection
  // are therefore raised.
  for (bool grows = true; grows;) {
    grows = false;
    const auto held = are_held(least);
    for (std::size_t m = 0; m < meshes; ++m) {
      if (held[m] || least[m] == greatest[m]) continue;
      least[m] += 1.0;
      grows = true;
    }
  }
  for (std::size_t m = 0; m < meshes; ++m)
    while (least[m] - 1.0 > below) {
      least[m] -= 1.0;
      const auto held = are_held(least);
      if (!is_in(0, held)) continue;
      least[m] += 1.0;
      break;
    }
  return least;
}

// Sets the widths of the meshes to whole steps.
void DriveDesigner::set_steps(DriveCandidate& candidate, const std::vector<double>& steps) const {
  // Removes the rounding error of the product, so that 33 steps of 1.27 mm are 41.91 mm.
  constexpr double kPlaces = 1e6;
  candidate.face_widths.clear();
  for (const double n : steps)
    candidate.face_widths.push_back(std::round(n * task_.face_step * kPlaces) / kPlaces);
}

// Gives each mesh the least width with which it has the required safeties. If the verdict requires
// wider faces, the least common lower limit of all widths is found by bisection.
DriveOutcome DriveDesigner::sized(DriveCandidate candidate) const {
  if (!problem_.face_width) return with_widths(std::move(candidate));
  // If a limit is a whole number of steps, the quotient may have a rounding error. kRounding is
  // greater than this error.
  constexpr double kRounding = 1e-9;
  const double below = std::ceil((*problem_.face_width)[0] / task_.face_step - kRounding) - 1.0;
  std::vector<double> greatest;  // in steps
  for (const double width : widest(problem_, candidate).face_widths)
    greatest.push_back(std::floor(width / task_.face_step + kRounding));
  if (*std::min_element(greatest.begin(), greatest.end()) <= below) return DriveFault::safety;
  set_steps(candidate, greatest);
  DriveOutcome best = with_widths(candidate);
  if (!std::holds_alternative<FoundDrive>(best)) return best;
  const std::vector<double> least = least_steps(candidate, below, greatest);
  const auto at_least = [&](double limit) {
    std::vector<double> steps = least;
    for (std::size_t m = 0; m < steps.size(); ++m)
      steps[m] = std::min(greatest[m], std::max(least[m], limit));
    set_steps(candidate, steps);
    return with_widths(candidate);
  };
  DriveOutcome narrowest = at_least(below);
  if (std::holds_alternative<FoundDrive>(narrowest)) return narrowest;
  double wanting = below, enough = *std::max_element(greatest.begin(), greatest.end());
  while (enough - wanting > 1.0) {
    const double limit = std::floor((wanting + enough) / 2);
    DriveOutcome narrower = at_least(limit);
    if (std::holds_alternative<FoundDrive>(narrower)) {
      best = std::move(narrower);
      enough = limit;
    } else {
      wanting = limit;
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

DriveOutcome DriveDesigner::with_widths(DriveCandidate candidate) const {
  auto made = made_from(candidate);
  if (!made || !has_gears(*made)) return DriveFault::no_teeth;
  Drive& drive = *made;
  if (!drive.sets.empty() && drive.sets.front().neighbours) {
    candidate.clearance = drive.sets.front().neighbours->clearance / candidate.module;
    if (candidate.clearance < problem_.neighbour_clearance) return DriveFault::neighbours;
  }
  if (greatest_sliding(drive.geometry).value_or(0.0) > problem_.sliding) return DriveFault::sliding;
  if (least_overlap(drive.geometry) < problem_.overlap) return DriveFault::overlap;
  if (task_.rate) {
    if (!drive.flow) return DriveFault::no_teeth;  // teeth that do not mesh have no efficiency
    if (drive.flow->self_locking()) return DriveFault::safety;
    if (auto error = task_.rate(drive)) return *error;
    if (!is_safe(drive, task_.required)) return DriveFault::safety;
  }
  const bool any_spacing = problem_.base.spacing == Spacing::nearest;
  if (drive_level(drive, task_.required, !any_spacing) != Level::green) return DriveFault::verdict;
  if (drive.flow) candidate.efficiency = drive.flow->efficiency;
  if (drive.backward) candidate.efficiency_backward = drive.backward->efficiency;
  if (problem_.asks(DriveObjective::noise) && !problem_.modules.empty())
    candidate.noise = windup_variation(drive);
  if (candidate.mass) candidate.mass = mass_of(problem_, drive);
  return FoundDrive{std::move(candidate), std::move(drive)};
}

}  // namespace gearwright
