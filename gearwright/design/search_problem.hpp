// The input of a design search: the numbers to try, the limits, and the objectives.
//
//   m_n, z1, z2, β   the numbers of a trial
//   x1, x2           profile shifts; for every trial, their exact region is solved
//                    (design/shift_graph.hpp)
//   Σ                x1 + x2, ISO 21771 signs (internal gear: z2 < 0)
//                                              theory: docs/theory/09-design-search.md
//
// Lengths are in mm, and limits of a tooth in normal modules.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/pair/shift.hpp"
#include "gearwright/rating/rating.hpp"
#include "gearwright/tool/straight_rack.hpp"

namespace gearwright {

/// The limits that can reject a trial, in the order of evaluation.
enum class Limit {
  shift_limits,
  center_distance,
  contact_ratio,
  overlap_ratio,
  sliding,
  tip_clearance,
  interference,
  safety_flank,  ///< S_H at the shifts of the design
  safety_root,   ///< S_F at the shifts of the design
  verdict        ///< over the drawing of the design, at all ends of its tolerances
};
inline constexpr int kRegionLimits =
    7;  ///< number of limits of the region, which are the first ones
inline constexpr int kLimits = 10;
/// "shift_limits", "center_distance", …
std::string_view name(Limit limit);

enum class Objective {
  contact_ratio,  ///< of the path clipped to the usable flanks
  ratio,
  size,
  shift,
  area,
  sliding,
  formula_contact_ratio,  ///< of the path between the tips (Eq. 10), independent of the flanks
  mass,
  safety  ///< the least of S_H/S_Hmin, S_F/S_Fmin
};
inline constexpr std::array<std::string_view, 9> kObjectiveNames{
    "contact_ratio",         "ratio", "size",  "shift", "area", "sliding",
    "formula_contact_ratio", "mass",  "safety"};

/// The racks of both gears, and the depths of their straight edges below the datum line, modules.
struct SearchRacks {
  std::array<StraightRack, 2> rack;
  std::array<double, 2> undercut_depth{1.0, 1.0};  ///< from which the undercut limit is computed
  std::array<double, 2> flank_depth{1.0, 1.0};     ///< of the racks, from which flank starts follow
};

struct SearchLimits {
  std::optional<double> min_shift, max_shift;  ///< lower and upper limit of x1 and x2
  double undercut_margin = 0.0;                ///< least distance of x from the undercut limit
  double tip_thickness = 0.2;                  ///< least s_an, modules
  double contact_ratio =
      1.2;  ///< least ε_α, also of the clipped path; least AE/p_bn on crossed axes
  std::optional<double> overlap_ratio;  ///< least ε_β
  std::optional<double> sliding;        ///< greatest |ζ| at both ends of the path; parallel axes
  std::optional<double> tip_clearance;  ///< least c, modules
  bool avoid_interference = false;      ///< no tip may pass the start of the mating gear's flank
  bool clear_fillets = false;   ///< no tip may cut into the root fillet at the point of the design
  double form_clearance = 0.0;  ///< least distance, along the line of action, of a tip from the
                                ///< start of the mating gear's flank, modules
  std::optional<double> safety_flank, safety_root;  ///< S_Hmin, S_Fmin of rated designs
};

class RingCuts;

/// The inputs of the rating of every design, as for the verb `rate`.
struct SearchRating {
  RatingInput input;
  std::optional<double> web, rim;       ///< b_s, s_R  mm, of a gear body with rim and web
  std::optional<double> power_kW;       ///< P, if given in place of the torque
  std::shared_ptr<RingCuts> ring_cuts;  ///< made by the search; if absent, every internal gear is
                                        ///< cut again
};

/// The tolerances of the drawing of every design.
struct SearchAllowances {
  std::string series;                             ///< DIN 3967, "cd25"; if empty, from `backlash`
  std::optional<std::array<double, 2>> backlash;  ///< j_n  mm, least and greatest
  std::optional<std::string> distance_tolerance;  ///< of ISO 286, "JS7"

  bool thin_teeth() const { return !series.empty() || backlash; }
};

struct DesignRow;
struct SearchProblem;

/// The verdict over the drawing of a design.
struct DrawnDesign {
  bool runs = false;                                ///< true if no finding is worse than green
  std::optional<std::array<double, 2>> backlash{};  ///< j_n  mm, at both ends of its tolerances
  /// The pair at every combination of the ends of its tolerances. It is empty unless safety factors are
  /// the only reason for the verdict, so that a wider face may help.
  std::vector<RatedPair> at_ends{};
};
using DrawDesign = std::function<DrawnDesign(const SearchProblem&, const DesignRow&)>;

inline constexpr double kFaceModules = 10.0;      ///< default b/m_n
inline constexpr double kSteelDensity = 7.83e-6;  ///< kg/mm³

/// Limits in modules that the caller can use as defaults, so that the designs run. SearchLimits does not
/// use them by itself.
inline constexpr double kRunningTipClearance = 0.02;
inline constexpr double kRunningFormClearance = 0.02;

/// Default limits for designs whose drawings are checked: |x|, and the specific sliding |ζ|.
inline constexpr double kDrawnShift = 1.0;
inline constexpr double kDrawnSliding = 3.0;

struct SearchProblem {
  std::array<double, 2> ratio{};  ///< z2/z1, closed; both negative for internal pairs
  std::optional<std::array<double, 2>> center_distance;  ///< mm, closed; both ends may be equal
  std::vector<double> modules;                           ///< m_n  mm
  std::array<int, 2> pinion_teeth{12, 40};               ///< z1, closed
  std::vector<Angle> helix{Angle()};                     ///< β of gear 1
  std::optional<Angle> shaft_angle;                      ///< Σ of crossed axes; β2 = Σ − β1
  Angle normal_pressure_angle = Angle::degrees(20);      ///< α_n
  std::vector<SearchRacks> racks{SearchRacks{}};
  bool coprime = false;  ///< only z1, z2 without a common factor
  // Closed bands of the face width of both gears. Each design gets the least width, within all bands,
  // with the required safety factors and overlap ratio.
  std::optional<std::array<double, 2>> face_width;      ///< b  mm
  std::optional<std::array<double, 2>> face_modules;    ///< b/m_n; 10 if there is no band
  std::optional<std::array<double, 2>> face_diameters;  ///< b/d_1
  double face_step = 1.0;  ///< mm; widths within a band are multiples of this step
  Mounting mounting = Mounting::extended;
  bool shorten_tips = false;  ///< shortens the tips by the clearance lost at tight centres
  SearchLimits limits;
  double lambda = 0.625;      ///< λ of the line of Eq. 11
  double target_ratio = 0.0;  ///< of the objective `ratio`
  std::vector<Objective> objectives{Objective::contact_ratio};
  std::optional<double> shift_step;  ///< step of the grid of shifts, if its points are requested
  std::array<double, 2> density{kSteelDensity, kSteelDensity};  ///< ρ  kg/mm³
  std::optional<SearchRating> rating;                           ///< none if designs are not rated
  bool rating_unused =
      false;  ///< true if a load is given, but neither limits nor objectives depend on it
  SearchAllowances allowances;  ///< empty for nominal teeth
  DrawDesign draw;  ///< makes the drawing of a design and its verdict; empty if not required

  bool internal() const { return ratio[0] < 0.0; }
  bool crossed() const { return shaft_angle.has_value(); }
  /// True if the face width is chosen for each design.
  bool sizes_faces() const {
    const auto open = [](const auto& band) { return band && (*band)[0] < (*band)[1]; };
    return open(face_width) || open(face_modules) || open(face_diameters);
  }
  /// The limits that can reject a design, in the order of evaluation.
  std::vector<Limit> rejecting_limits() const {
    std::vector<Limit> all;
    for (int i = 0; i < kLimits; ++i) {
      const auto limit = static_cast<Limit>(i);
      const bool drawn = limit == Limit::verdict;
      if (drawn ? static_cast<bool>(draw) : i < kRegionLimits || rating) all.push_back(limit);
    }
    return all;
  }
  /// True if masses are required.
  bool weighs() const { return rating || ranks_by(Objective::mass); }
  bool ranks_by(Objective objective) const {
    return std::find(objectives.begin(), objectives.end(), objective) != objectives.end();
  }
};

/// One combination of all numbers except the shifts.
struct Trial {
  std::int64_t index = 0;  ///< number of the trial
  double module = 0.0;     ///< m_n  mm
  int z1 = 0, z2 = 0;
  std::array<Angle, 2> helix{};  ///< β  signed
  int rack = 0;                  ///< of SearchProblem::racks
};

/// The rack of gear i. It is marked as a named rack, so that its fillet radius is reduced to the full
/// radius if it does not fit at this pressure angle.
inline StraightRack rack_of(const SearchProblem& problem, const Trial& trial, std::size_t i) {
  StraightRack rack = problem.racks[static_cast<std::size_t>(trial.rack)].rack[i];
  rack.named = true;
  return rack;
}

}  // namespace gearwright
