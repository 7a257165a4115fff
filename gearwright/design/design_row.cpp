#include "gearwright/design/design_row.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "gearwright/design/design_objectives.hpp"
#include "gearwright/design/design_strength.hpp"
#include "gearwright/design/face_width.hpp"
#include "gearwright/design/fillet_gap.hpp"
#include "gearwright/gear/basic.hpp"
#include "gearwright/inspection/thickness_series.hpp"
#include "gearwright/pair/efficiency.hpp"
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

double DesignRow::cut_shift(std::size_t i, const SearchProblem& problem) const {
  return shift[i] +
         allowance[i] / (2 * trial.module * std::tan(problem.normal_pressure_angle.rad()));
}

namespace {

// Returns the mean E_sn of each gear. If a backlash is required, it determines the sum of both
// allowances, and each gear gets half of this sum. Otherwise, E_sn comes from the table of the
// series. A gear outside the table gets no allowance here, and its drawing is rejected later.
std::array<double, 2> allowances_of(const SearchAllowances& wanted, const Mesh<double>& nominal,
                                    const std::array<double, 2>& diameters, double alpha_n) {
  if (wanted.backlash) {
    // [T9.13]: j_bn = −(E_sn1 + E_sn2) cos α_n plus the backlash of the teeth without allowances.
    const double j_n = ((*wanted.backlash)[0] + (*wanted.backlash)[1]) / 2;
    const double j_bn = j_n * std::cos(nominal.rack.normal_pressure_angle);
    const double each = -(j_bn - nominal.backlash.normal_base) / std::cos(alpha_n) / 2;
    return {each, each};
  }
  std::array<double, 2> mean{};
  for (const std::size_t i : {0, 1})
    if (const auto ends = thickness_allowances(wanted.series, diameters[i]))
      mean[i] = ((*ends)[0] + (*ends)[1]) / 2;
  return mean;
}

}  // namespace

DesignRow row_at(const ShiftGraph& graph, const Vec2& shifts) {
  const SearchProblem& problem = graph.problem();
  const Trial& t = graph.trial();
  const double m = t.module;
  const double alpha_n = problem.normal_pressure_angle.rad();
  const double sum = shifts[0] + shifts[1];
  const SumPlace at = graph.place(sum);

  DesignRow row;
  row.trial = t;
  row.shift = {shifts[0], shifts[1]};
  row.face_width = first_face_width(graph);
  MeshInput<double> in;
  const std::array<int, 2> teeth{t.z1, t.z2};
  std::array<double, 2> diameters{};
  for (std::size_t i : {0, 1}) {
    const TrialGear& g = graph.gears()[i];
    in.tip_form_radius[i] = m * std::abs(leaf::tip_radius(g.r, g.addendum, row.shift[i], at.k));
    in.face_width[i] = row.face_width;
  }
  in.center_distance = m * std::abs(at.a);
  if (problem.shaft_angle) in.shaft_angle = problem.shaft_angle->rad();
  const auto mesh_of_teeth = [&] {
    for (std::size_t i : {0, 1}) {
      const auto reference = reference_geometry(ReferenceInput<double>{
          teeth[i], m, alpha_n, t.helix[i].rad(), row.shift[i], row.allowance[i]});
      diameters[i] = reference.reference_diameter;
      in.gears[i] = base_gear(teeth[i], reference);
    }
    return mesh_of(in);
  };
  Mesh<double> mesh = mesh_of_teeth();
  if (problem.allowances.thin_teeth()) {
    row.allowance = allowances_of(problem.allowances, mesh, diameters, alpha_n);
    mesh = mesh_of_teeth();
  }
  const std::array<double, 2> cut{row.cut_shift(0, problem), row.cut_shift(1, problem)};

  row.center_distance = in.center_distance;
  row.working_angle = Angle::radians(problem.crossed() ? mesh.rack.normal_pressure_angle
                                                       : mesh.rack.sides[0].transverse_angle);
  row.ratio = static_cast<double>(t.z2) / t.z1;
  row.contact_ratio = mesh.path_ratio;
  const auto flank_start = [&](std::size_t i) {
    const TrialGear& g = graph.gears()[i];
    return m * leaf::flank_start(std::abs(g.r), g.sin_transverse, g.edge_depth, cut[i]);
  };
  // The path is clipped to the usable flanks. On crossed axes, clipping to the faces is omitted,
  // because the search does not choose face widths for crossed axes.
  const double from = leaf::usable_begin(mesh.rho1_A, flank_start(0));
  const double end = leaf::rho_1_where(mesh.base_tangent_distance, 1.0,
                                       std::max(0.0, flank_start(1)) / mesh.base_cosine_ratio);
  const double to = t.z2 < 0 ? mesh.rho1_E : leaf::usable_end(mesh.rho1_E, end);
  row.contact_ratio_true = std::max(0.0, leaf::contact_ratio(from, to, mesh.step));
  mesh.rho1_true_begin = from;
  mesh.rho1_true_end = to;
  if (const auto friction = problem.flank_friction(); friction && row.contact_ratio_true >= 1.0)
    row.efficiency = efficiency(sliding_shares(in, mesh), *friction).gear1_drives;
  row.overlap_ratio = mesh.overlap_ratio;
  row.backlash_normal = mesh.backlash.normal_base;
  row.tip_alteration = at.k * m;
  const double lost = at.a - (graph.gears()[0].r + graph.gears()[1].r) - sum;
  for (std::size_t i : {0, 1}) {
    const TrialGear& g = graph.gears()[i];
    const TrialGear& mate = graph.gears()[1 - i];
    // A negative allowance makes the cut deeper. It does not change the tips.
    const double deeper = row.shift[i] - cut[i];
    const double mate_deeper = row.shift[1 - i] - cut[1 - i];
    row.tip_thickness[i] = m * tip_thickness(g, cut[i], at.k + deeper);
    row.tip_clearance[i] =
        m * (leaf::tip_clearance_of(mate.dedendum, g.addendum, lost, at.k) + mate_deeper);
  }
  const auto zeta_A = specific_sliding(in, mesh, mesh.rho1_A);
  const auto zeta_E = specific_sliding(in, mesh, mesh.rho1_E);
  row.sliding = {{{zeta_A.zeta_1, zeta_E.zeta_1}, {zeta_A.zeta_2, zeta_E.zeta_2}}};
  const double slack = kTouching * m;
  const std::array<double, 2> ends{mesh.rho1_A, mesh.rho2(mesh.rho1_E)};
  for (std::size_t i : {0, 1}) {
    const TrialGear& g = graph.gears()[i];
    if (g.teeth < 0) continue;
    const double start = m * leaf::flank_start(g.r, g.sin_transverse, g.flank_depth, cut[i]);
    row.form_clearance[i] = graph.weight(i) * (ends[i] - start);
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
  std::optional<DesignRow> found;
  if (!fillet_is_cut(graph, chosen)) {
    found = row_of_region(graph, region, chosen);
    found->balanced = region.off_walls || region.balanced;
    if (found->runs) return found;
  }
  // If the design at the chosen point is rejected, the middle of the region is tried.
  const Vec2 middle = middle_point(graph, region);
  if (fillet_is_cut(graph, middle)) return found;
  const DesignRow row = row_of_region(graph, region, middle);
  return found && !row.runs ? found : row;
}

std::optional<DesignRow> design_row(const ShiftGraph& graph, RegionDetail detail) {
  const bool point = detail == RegionDetail::point;
  if (point) {
    if (const auto place = point_off_walls(graph)) {
      DesignRow row = rated(graph, row_at(graph, *place));
      row.balanced = true;
      if (row.runs) return row;
    }
  }
  // OffWalls::none means that no point away from the borders exists. If designs are drawn, this
  // value is not used, because such a point may exist and its drawing may have been rejected above.
  const bool none = point && !graph.problem().draw;
  const auto region = shift_region(graph, detail, none ? OffWalls::none : OffWalls::sought);
  return region ? design_row(graph, *region) : std::nullopt;
}

bool has_design(const ShiftGraph& graph) {
  // Most trials have no region. has_feasible_sums() detects this faster than the search for a
  // feasible point.
  if (!graph.has_feasible_sums()) return false;
  const SearchProblem& problem = graph.problem();
  if (!problem.limits.clear_fillets && !problem.rating && !problem.draw) return true;
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
    case Objective::efficiency:
      return row.efficiency ? std::optional(-*row.efficiency) : std::nullopt;
    case Objective::balance: return load_balance(problem, row);
    case Objective::cost: return relative_cost(problem, row);
    case Objective::noise: return row.noise;
  }
  return std::nullopt;
}

namespace {

// Rounds a cost to multiples of kSame. Without this rounding, rounding errors that depend on the
// module would determine the order of designs with equal costs.
double settled(double cost) {
  constexpr double kSame = 1e-11;
  constexpr double kTooLarge = 1e4;  // from this value on, rounding errors exceed a step of kSame
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
