// Computes the values of a feasible design at a point of its region, and ranks designs.
//
// All values are computed with the formulas for a mounted pair (pair/mesh.hpp). A mounted design
// therefore has the same values.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "gearwright/base/vector.hpp"
#include "gearwright/design/shift_region.hpp"

namespace gearwright {

/// Lengths are in mm. Shifts and the region are in normal modules.
struct DesignRow {
  Trial trial;
  std::array<double, 2> shift{};          ///< x1, x2
  std::array<double, 2> allowance{};      ///< E_sn, the mean of upper and lower allowance
  double face_width = 0.0;                ///< b, common to both gears
  bool balanced = false;                  ///< true if (x1, x2) lies on the line of balanced
                                          ///< strength (Eq. 11, design/shift_region.hpp)
  double center_distance = 0.0;           ///< a
  Angle working_angle;                    ///< α_wt; α_n of the rack on crossed axes
  double ratio = 0.0;                     ///< z2/z1
  double contact_ratio = 0.0;             ///< ε_α, Eq. 10; on crossed axes, AE/p_bn, where AE is
                                          ///< the length of the path of contact
  double contact_ratio_true = 0.0;        ///< ε_α of the path clipped to the usable flanks
  double overlap_ratio = 0.0;             ///< ε_β
  double backlash_normal = 0.0;           ///< j_bn, along the common normal
  std::array<double, 2> tip_thickness{};  ///< s_an
  std::array<double, 2> tip_clearance{};  ///< tip 1 to root 2, tip 2 to root 1
  double tip_alteration = 0.0;            ///< k m_n, ≤ 0
  std::array<std::array<std::optional<double>, 2>, 2> sliding;  ///< ζ of gear 1, 2 at A, E
  bool interference = false;  ///< true if a tip touches the mating flank beyond the start of the
                              ///< involute
  /// Distance, along the line of action, from the start of the involute to the point that the
  /// mating tip touches, on the flanks of gear 1 and gear 2. Absent for an internal gear, because
  /// the start of its involute depends on its cutter.
  std::array<std::optional<double>, 2> form_clearance{};
  double mass = 0.0;  ///< kg, of both gears: design/design_strength.hpp
  /// η if gear 1 drives. Absent if it was not requested, if the contact ratio is below 1, or if
  /// gear 1 cannot drive.
  std::optional<double> efficiency{};
  std::optional<double> noise{};  ///< µm: design/design_objectives.hpp; absent if not rated, or if
                                  ///< the teeth lose contact
  std::optional<double> loaded_noise{};  ///< µm: job/loaded_designs.hpp; absent if not computed
  /// S_H and S_F of each gear. Absent if they were not requested, or if the standard has no form
  /// factor for the root.
  std::array<std::optional<double>, 2> flank_safety{}, root_safety{};
  bool runs = true;  ///< false if the verdict on the drawing has a finding worse than green
  std::optional<WarningCode> finding{};  ///< code of this finding: DrawnDesign::finding
  std::array<std::optional<double>, 2> backlash_ends{};  ///< j_n, least and greatest value within
                                                         ///< the tolerances of the drawing
  /// True if the members below, which describe the region, have been computed.
  bool whole = false;
  double area = 0.0;
  std::array<double, 2> sums{};  ///< least and greatest Σ
  Vec2 lo{0.0, 0.0}, hi{0.0, 0.0};

  /// x_E of gear i, the generating profile shift.
  double cut_shift(std::size_t i, const SearchProblem& problem) const;
  /// Greatest |ζ|; absent if a flank reaches a base tangent point.
  std::optional<double> max_sliding() const;
};

/// Returns the row of a trial, or none if its region has no usable point. A row whose safety
/// factors are too low, or whose drawing is rejected, is also returned; see short_of(). If `detail`
/// is RegionDetail::point, the values of the region are omitted, because their computation takes a
/// hundred times as long as that of all other values. The shifts are the same for both values of
/// `detail`.
std::optional<DesignRow> design_row(const ShiftGraph& graph,
                                    RegionDetail detail = RegionDetail::whole);
std::optional<DesignRow> design_row(const ShiftGraph& graph, const ShiftRegion& region);

/// True if a design exists. A design requires a region. If fillets are checked, it requires a point
/// of the region at which no tip cuts into a fillet. If designs are rated, it must also meet the
/// limits of the safety factors. If designs are drawn, the verdict must accept it.
bool has_design(const ShiftGraph& graph);
/// Returns the row at any point of the graph. A working angle must exist there (contract).
DesignRow row_at(const ShiftGraph& graph, const Vec2& shifts);
/// Returns the cost of a design for one objective. Smaller costs are better. A row that is not on
/// the line of balanced strength, or lacks the value of the objective, has no cost. Rows without a
/// cost are ranked last.
std::optional<double> cost(const SearchProblem& problem, const DesignRow& row, Objective objective);
/// The key by which rows are sorted. Rows without a cost come last. The other rows are compared by
/// cost first, then by contact ratio (the greater one first), module, z1, |z2| and trial number. No
/// two rows have equal keys.
struct RankKey {
  bool without_cost;
  double cost, contact_ratio, module;
  int z1, z2;
  std::int64_t trial;
  auto operator<=>(const RankKey&) const = default;
};
RankKey rank_key(const SearchProblem& problem, Objective objective, const DesignRow& row);

bool ranks_before(const SearchProblem& problem, Objective objective, const DesignRow& a,
                  const DesignRow& b);

/// True if a is at least as good as b in all objectives and better in at least one. A row without a
/// cost never dominates another row.
bool dominates(const SearchProblem& problem, const DesignRow& a, const DesignRow& b);

/// The rows that no other row dominates. Rows can be added in any order. A row without a cost for
/// one of the objectives is left out.
class ParetoFront {
 public:
  explicit ParetoFront(const SearchProblem& problem) : problem_(&problem) {}
  void add(const DesignRow& row);
  /// The rows in the order in which they were added.
  const std::vector<DesignRow>& rows() const { return rows_; }

 private:
  const SearchProblem* problem_;
  std::vector<DesignRow> rows_;
};

}  // namespace gearwright
