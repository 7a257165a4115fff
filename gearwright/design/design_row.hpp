// One feasible design: its numbers at a point of the region, and what decides its rank.
//
// The numbers come from the formulas of a mounted pair (pair/mesh.hpp): what the search prints is
// what mounting the design gives.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "gearwright/base/vector.hpp"
#include "gearwright/design/shift_region.hpp"

namespace gearwright {

/// Lengths mm; shifts and region in normal modules.
struct DesignRow {
  Trial trial;
  std::array<double, 2> shift{};          ///< x1, x2
  bool balanced = false;                  ///< the point of Eq. 11; else as chosen_point() says
  double center_distance = 0.0;           ///< a
  Angle working_angle;                    ///< α_wt, crossed: α_n
  double ratio = 0.0;                     ///< z2/z1
  double contact_ratio = 0.0;             ///< ε_α, Eq. 10; crossed: of AE
  double contact_ratio_true = 0.0;        ///< the same with the path clipped to the usable flanks
  double overlap_ratio = 0.0;             ///< ε_β
  double backlash_normal = 0.0;           ///< j_bn, along the common normal
  std::array<double, 2> tip_thickness{};  ///< s_an
  std::array<double, 2> tip_clearance{};  ///< tip 1 to root 2, tip 2 to root 1
  double tip_alteration = 0.0;            ///< k m_n, ≤ 0
  std::array<std::array<std::optional<double>, 2>, 2> sliding;  ///< ζ of gear 1, 2 at A, E
  bool interference = false;  ///< a tip passes the start of the mating gear's straight-cut flank
  double area = 0.0;
  std::array<double, 2> sums{};  ///< least and greatest Σ
  Vec2 lo{0.0, 0.0}, hi{0.0, 0.0};

  /// Greatest |ζ|; none where a flank reaches a base tangent point.
  std::optional<double> max_sliding() const;
};

/// The row of a trial; none: nothing of it is feasible.
std::optional<DesignRow> design_row(const ShiftGraph& graph);
DesignRow design_row(const ShiftGraph& graph, const ShiftRegion& region);

/// The numbers at any point of the graph.   Domain: a working angle exists there (contract)
DesignRow row_at(const ShiftGraph& graph, const Vec2& shifts);

/// How good a design is by one objective: smaller is better. Objectives are taken at the point of
/// Eq. 11; rows without one have none and come last.
std::optional<double> cost(const SearchProblem& problem, const DesignRow& row, Objective objective);

/// A comes before B: by the objective, then contact ratio, module, z1, z2, trial. A total order.
bool ranks_before(const SearchProblem& problem, Objective objective, const DesignRow& a,
                  const DesignRow& b);

/// A is at least as good in every objective and better in one. Rows without a cost never dominate.
bool dominates(const SearchProblem& problem, const DesignRow& a, const DesignRow& b);

/// The rows that no other row dominates, kept as rows arrive in any order.
class ParetoFront {
 public:
  explicit ParetoFront(const SearchProblem& problem) : problem_(&problem) {}
  void add(const DesignRow& row);
  const std::vector<DesignRow>& rows() const { return rows_; }  ///< in order of arrival

 private:
  const SearchProblem* problem_;
  std::vector<DesignRow> rows_;
};

}  // namespace gearwright
