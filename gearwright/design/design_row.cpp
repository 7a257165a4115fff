#include "gearwright/design/design_row.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

#include "gearwright/design/design_strength.hpp"
#include "gearwright/design/fillet_gap.hpp"
#include "gearwright/gear/basic.hpp"
#include "gearwright/pair/mesh.hpp"

namespace gearwright {

std::optional<double> DesignRow::max_sliding() const {
  double most = 0.0;
  for (const auto& gear : sliding) {
    for (const auto& zeta : gear) {
      if (!zeta) return std::nullopt;
      most = std::max(most, std::abs(*zeta));
    }
  }
  return most;
}

DesignRow row_at(const ShiftGraph& graph, const Vec2& shifts) {
  const SearchProblem& problem = graph.problem();
  const Trial& t = graph.trial();
  const double m = t.module;
  const double sum = shifts[0] + shifts[1];
  const SumPlace at = graph.place(sum);

  MeshInput<double> in;
  const std::array<int, 2> teeth{t.z1, t.z2};
  for (std::size_t i : {0, 1}) {
    const auto reference = reference_geometry(
        ReferenceInput<double>{teeth[i], m, problem.normal_pressure_angle.rad(), t.helix[i].rad(),
                               shifts[static_cast<int>(i)], 0.0});
    in.gears[i] = base_gear(teeth[i], reference);
    const TrialGear& g = graph.gears()[i];
    in.tip_form_radius[i] =
        m * std::abs(leaf::tip_radius(g.r, g.addendum, shifts[static_cast<int>(i)], at.k));
    in.face_width[i] = problem.face_width_of(m);
  }
  in.center_distance = m * std::abs(at.a);
  if (problem.shaft_angle) in.shaft_angle = problem.shaft_angle->rad();
  const Mesh<double> mesh = mesh_of(in);

  DesignRow row;
  row.trial = t;
  row.shift = {shifts[0], shifts[1]};
  row.center_distance = in.center_distance;
  row.working_angle = Angle::radians(problem.crossed() ? mesh.rack.normal_pressure_angle
                                                       : mesh.rack.sides[0].transverse_angle);
  row.ratio = static_cast<double>(t.z2) / t.z1;
  row.contact_ratio = mesh.path_ratio;
  const auto flank_start = [&](std::size_t i) {
    const TrialGear& g = graph.gears()[i];
    return m * leaf::flank_start(std::abs(g.r), g.sin_transverse, g.edge_depth,
                                 shifts[static_cast<int>(i)]);
  };
  // The path is clipped to the usable flanks. On crossed axes it is not clipped to the faces, which
  // a search does not choose.
  const double from = leaf::usable_begin(mesh.rho1_A, flank_start(0));
  const double end = leaf::rho_1_where(mesh.base_tangent_distance, 1.0,
                                       std::max(0.0, flank_start(1)) / mesh.base_cosine_ratio);
  const double to = t.z2 < 0 ? mesh.rho1_E : leaf::usable_end(mesh.rho1_E, end);
  row.contact_ratio_true = std::max(0.0, leaf::contact_ratio(from, to, mesh.step));
  row.overlap_ratio = mesh.overlap_ratio;
  row.backlash_normal = mesh.backlash.normal_base;
  row.tip_alteration = at.k * m;
  const double lost = at.a - (graph.gears()[0].r + graph.gears()[1].r) - sum;
  for (std::size_t i : {0, 1}) {
    const TrialGear& g = graph.gears()[i];
    const TrialGear& mate = graph.gears()[1 - i];
    row.tip_thickness[i] = m * tip_thickness(g, shifts[static_cast<int>(i)], at.k);
    row.tip_clearance[i] = m * leaf::tip_clearance_of(mate.dedendum, g.addendum, lost, at.k);
  }
  const auto zeta_A = specific_sliding(in, mesh, mesh.rho1_A);
  const auto zeta_E = specific_sliding(in, mesh, mesh.rho1_E);
  row.sliding = {{{zeta_A.zeta_1, zeta_E.zeta_1}, {zeta_A.zeta_2, zeta_E.zeta_2}}};
  const double slack = kTouching * m;
  const std::array<double, 2> ends{mesh.rho1_A, mesh.rho2(mesh.rho1_E)};
  for (std::size_t i : {0, 1}) {
    const TrialGear& g = graph.gears()[i];
    if (g.teeth < 0) continue;
    const double start =
        m * leaf::flank_start(g.r, g.sin_transverse, g.flank_depth, shifts[static_cast<int>(i)]);
    // The weight along the line of action, which on crossed axes rises by the base helix.
    const double weight = problem.crossed() ? 1.0 / g.cos_base_helix : 1.0;
    row.form_clearance[i] = weight * (ends[i] - start);
    row.interference = row.interference || ends[i] < start - slack;
  }
  row.mass = mass_of(graph, row);
  return row;
}

namespace {

DesignRow row_of_region(const ShiftGraph& graph, const ShiftRegion& region, const Vec2& shifts) {
  DesignRow row = rated(graph, row_at(graph, shifts));
  if (region.detail != RegionDetail::whole) return row;
  row.whole = true;
  row.area = region.area;
  row.sums = {region.sums.front().lo, region.sums.back().hi};
  row.lo = region.lo;
  row.hi = region.hi;
  return row;
}

}  // namespace

std::optional<DesignRow> design_row(const ShiftGraph& graph, const ShiftRegion& region) {
  const Vec2 chosen = chosen_point(graph, region);
  if (!fillet_is_cut(graph, chosen)) {
    DesignRow row = row_of_region(graph, region, chosen);
    row.balanced = region.off_walls || region.balanced;
    return row;
  }
  const Vec2 middle = middle_point(graph, region);
  if (fillet_is_cut(graph, middle)) return std::nullopt;
  return row_of_region(graph, region, middle);
}

std::optional<DesignRow> design_row(const ShiftGraph& graph, RegionDetail detail) {
  const bool point = detail == RegionDetail::point;
  if (point) {
    if (const auto place = point_off_walls(graph)) {
      DesignRow row = rated(graph, row_at(graph, *place));
      row.balanced = true;
      return row;
    }
  }
  const auto region = shift_region(graph, detail, point ? OffWalls::none : OffWalls::sought);
  return region ? design_row(graph, *region) : std::nullopt;
}

bool has_design(const ShiftGraph& graph) {
  // Most trials have no region, which is found sooner than that no point is feasible.
  if (!graph.has_feasible_sums()) return false;
  const SearchProblem& problem = graph.problem();
  if (!problem.limits.clear_fillets && !problem.rating) return true;
  const auto row = design_row(graph, RegionDetail::point);
  return row && !short_of(problem, *row);
}

std::optional<double> cost(const SearchProblem& problem, const DesignRow& row,
                           Objective objective) {
  if (!row.balanced) return std::nullopt;
  switch (objective) {
    case Objective::contact_ratio: return -row.contact_ratio_true;
    case Objective::formula_contact_ratio: return -row.contact_ratio;
    case Objective::ratio: return std::abs(row.ratio - problem.target_ratio);
    case Objective::size: {
      const double z1 = row.trial.z1;
      const double z2 = row.trial.z2;
      return row.trial.module * row.trial.module * (z1 * z1 + z2 * z2);
    }
    case Objective::shift: return std::abs(row.shift[0] + row.shift[1]);
    case Objective::sliding: return row.max_sliding();
    case Objective::area: return -row.area;
    case Objective::mass: return row.mass;
    case Objective::safety: {
      const auto least = least_safety(problem, row);
      return least ? std::optional(-*least) : std::nullopt;
    }
  }
  return std::nullopt;
}

namespace {

// Costs that differ by less are equal: the same design in another module rounds differently.
double settled(double cost) {
  constexpr double kSame = 1e-11;
  constexpr double kTooLarge = 1e4;  // from this value on, a step of kSame is less than rounding
  return std::abs(cost) < kTooLarge ? std::round(cost / kSame) * kSame : cost;
}

}  // namespace

RankKey rank_key(const SearchProblem& problem, Objective objective, const DesignRow& row) {
  const auto c = cost(problem, row, objective);
  return {!c,
          settled(c.value_or(0.0)),
          settled(-row.contact_ratio),
          row.trial.module,
          row.trial.z1,
          std::abs(row.trial.z2),
          row.trial.index};
}

bool ranks_before(const SearchProblem& problem, Objective objective, const DesignRow& a,
                  const DesignRow& b) {
  return rank_key(problem, objective, a) < rank_key(problem, objective, b);
}

bool dominates(const SearchProblem& problem, const DesignRow& a, const DesignRow& b) {
  bool better = false;
  for (const Objective objective : problem.objectives) {
    const auto cost_a = cost(problem, a, objective);
    const auto cost_b = cost(problem, b, objective);
    if (!cost_a) return false;
    if (cost_b && settled(*cost_a) > settled(*cost_b)) return false;
    better = better || !cost_b || settled(*cost_a) < settled(*cost_b);
  }
  return better;
}

void ParetoFront::add(const DesignRow& row) {
  for (const Objective objective : problem_->objectives)
    if (!cost(*problem_, row, objective)) return;
  for (const DesignRow& kept : rows_)
    if (dominates(*problem_, kept, row)) return;
  rows_.erase(
      std::remove_if(rows_.begin(), rows_.end(),
                     [&](const DesignRow& kept) { return dominates(*problem_, row, kept); }),
      rows_.end());
  rows_.push_back(row);
}

}  // namespace gearwright
