// Defines the input of a design search: the numbers to try, the limits, and the objectives.
//
//   m_n, z1, z2, β   the numbers of a trial
//   x1, x2           profile shifts; for every trial, the exact region of feasible shifts is
//                    computed (design/shift_graph.hpp)
//   Σ                x1 + x2, ISO 21771 signs (internal gear: z2 < 0)
//                                              theory: docs/theory/09-design-search.md
//
// Lengths are in mm. The limits of a tooth are in normal modules.
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/base/lists.hpp"
#include "gearwright/gear/warning.hpp"
#include "gearwright/pair/shift.hpp"
#include "gearwright/rating/rating.hpp"
#include "gearwright/tool/straight_rack.hpp"

namespace gearwright {

/// The limits that can reject a trial, in the order in which they are evaluated.
enum class Limit {
  shift_limits,
  center_distance,
  contact_ratio,
  overlap_ratio,
  sliding,
  tip_clearance,
  interference,
  safety_flank,  ///< S_H for the shifts of the design
  safety_root,   ///< S_F for the shifts of the design
  verdict        ///< verdict on the drawing of the design, at all limits of the tolerances
};
inline constexpr int kRegionLimits =
    7;  ///< number of limits that define the region; these limits come first
inline constexpr int kLimits = 10;
/// "shift_limits", "center_distance", …
std::string_view name(Limit limit);

enum class Objective {
  contact_ratio,  ///< with the path clipped to the usable flanks
  ratio,
  size,
  shift,
  area,
  sliding,
  formula_contact_ratio,  ///< with the path between the tips (Eq. 10), regardless of the flanks
  mass,
  safety,      ///< smallest of S_H/S_Hmin and S_F/S_Fmin
  efficiency,  ///< η if gear 1 drives
  balance,     ///< greatest load reserve divided by the least one (design/design_objectives.hpp)
  cost,        ///< mass times a factor that grows with the face width
  noise        ///< estimated transmission error under load, peak to peak
};
inline constexpr std::array<std::string_view, 13> kObjectiveNames{
    "contact_ratio", "ratio",  "size",       "shift",   "area", "sliding", "formula_contact_ratio",
    "mass",          "safety", "efficiency", "balance", "cost", "noise"};

inline constexpr bool seeks_greatest(Objective objective) {
  switch (objective) {
    case Objective::contact_ratio:
    case Objective::area:
    case Objective::formula_contact_ratio:
    case Objective::safety:
    case Objective::efficiency: return true;
    default: return false;
  }
}
inline constexpr bool needs_rating(Objective objective) {
  return objective == Objective::safety || objective == Objective::balance ||
         objective == Objective::noise;
}

/// The racks of both gears, and the depths of their straight edges. The depths are in modules and
/// are measured from the datum line.
struct SearchRacks {
  std::array<StraightRack, 2> rack;
  std::array<double, 2> undercut_depth{1.0, 1.0};  ///< for undercut and the clipped path
  std::array<double, 2> flank_depth{1.0, 1.0};     ///< for interference and form clearance
};

struct SearchLimits {
  std::optional<double> min_shift, max_shift;  ///< lower and upper limit of x1 and x2
  double undercut_margin = 0.0;                ///< least difference between x and the undercut
                                               ///< limit
  double tip_thickness = 0.2;                  ///< least s_an, modules
  double contact_ratio =
      1.2;  ///< least ε_α, also of the clipped path; on crossed axes, least AE/p_bn
  std::optional<double> overlap_ratio;  ///< least ε_β
  std::optional<double> sliding;        ///< greatest |ζ| at the ends of the path; parallel axes
                                        ///< only
  std::optional<double> tip_clearance;  ///< least c, modules
  bool avoid_interference = false;      ///< if true, no tip may touch the mating gear beyond the
                                        ///< start of its flank
  bool clear_fillets = false;   ///< if true, no tip may cut into a root fillet at the chosen shifts
  double form_clearance = 0.0;  ///< modules, along the line of action; least distance from the
                                ///< start of a flank to the point that the mating tip touches
  std::optional<double> safety_flank, safety_root;  ///< S_Hmin, S_Fmin for rated designs
};

class RingCuts;

/// The inputs for the rating of every design. They are the inputs of the verb `rate`.
struct SearchRating {
  RatingInput input;
  std::optional<double> web, rim;       ///< b_s, s_R  mm, for a gear body with rim and web
  std::optional<double> power_kW;       ///< P, if given instead of the torque
  std::optional<double> output_torque;  ///< T_2  N m, on gear 2, if given instead of the torque
  std::shared_ptr<RingCuts> ring_cuts;  ///< store for the cuts of internal gears, created by the
                                        ///< search; if absent, internal pairs are cut and mounted

  /// Returns the input for a pair with these numbers of teeth.
  RatingInput input_of(int z1, int z2) const {
    RatingInput own = input;
    if (output_torque) own.torque = balancing_torque(*output_torque, z1, z2);
    return own;
  }
};

/// Drawing tolerances, which are the same for all designs.
struct SearchAllowances {
  std::string series;                             ///< series of DIN 3967, for example "cd25"; if
                                                  ///< empty, `backlash` is used
  std::optional<std::array<double, 2>> backlash;  ///< j_n  mm, least and greatest
  std::optional<std::string> distance_tolerance;  ///< tolerance of the centre distance to ISO 286,
                                                  ///< for example "JS7"

  bool thin_teeth() const { return !series.empty() || backlash; }
};

struct DesignRow;
struct SearchProblem;

/// The verdict on the drawing of a design.
struct DrawnDesign {
  bool runs = false;                     ///< true if no finding is worse than green
  std::optional<WarningCode> finding{};  ///< code of the worst finding; none if the design runs, or
                                         ///< if it cannot be drawn
  std::optional<std::array<double, 2>> backlash{};  ///< j_n  mm, at both limits of the tolerances
  /// The pair at every combination of the limits of the tolerances. The list is filled only if
  /// insufficient safety factors are the only reason why the design does not run, because a wider
  /// face may help only then.
  std::vector<RatedPair> at_ends{};
};
using DrawDesign = std::function<DrawnDesign(const SearchProblem&, const DesignRow&)>;

inline constexpr double kFaceModules = 10.0;      ///< default b/m_n
inline constexpr double kSteelDensity = 7.83e-6;  ///< kg/mm³
inline constexpr double kUsualFriction = 0.05;    ///< μ for the objective `efficiency`

/// Limits for designs that run, modules. The defaults of SearchLimits are weaker, so callers that
/// require such designs set these limits.
inline constexpr double kRunningTipClearance = 0.02;
inline constexpr double kRunningFormClearance = 0.02;

/// Default limits of |x| and of the specific sliding |ζ|, for designs with checked drawings.
inline constexpr double kDrawnShift = 1.0;
inline constexpr double kDrawnSliding = 3.0;

/// A module and a helix angle that are tried together, with the face width for which the helix
/// angle was chosen (design/whole_overlap.hpp).
struct HelixChoice {
  double module = 0.0;                 ///< m_n  mm
  Angle helix{};                       ///< β of gear 1
  std::optional<double> face_width{};  ///< b  mm
};

struct SearchProblem {
  std::array<double, 2> ratio{};  ///< z2/z1, both ends included; both negative for internal pairs
  std::optional<std::array<double, 2>> center_distance;  ///< least and greatest a  mm; both ends
                                                         ///< are included and may be equal
  std::vector<double> modules;                           ///< m_n  mm
  bool by_pitch = false;  ///< true if the caller gives diametral pitches instead of modules
  std::array<int, 2> pinion_teeth{12, 40};  ///< z1, both ends included
  std::vector<Angle> helix{Angle()};        ///< β of gear 1
  /// The combinations to try. If empty, every module is tried with every helix angle. Otherwise,
  /// `helix` contains the helix angles of these combinations.
  std::vector<HelixChoice> choices;
  /// The overlap ratios and the band of helix angles, degrees, from which the choices follow
  /// (design/whole_overlap.hpp); empty if the choices do not follow from overlap ratios.
  std::vector<double> overlap_ratios;
  std::array<double, 2> overlap_helix_deg{};
  bool default_overlap_helix = false;  ///< true if this band is the default of the caller
  std::optional<Angle> shaft_angle;    ///< Σ of crossed axes; β2 = Σ − β1
  Angle normal_pressure_angle = Angle::degrees(20);  ///< α_n
  std::vector<SearchRacks> racks{SearchRacks{}};
  bool coprime = false;  ///< if true, z1 and z2 must have no common factor
  // Bands of the face width of both gears, both ends included. Each design gets the smallest width
  // within all bands that gives the required safety factors and the required overlap ratio.
  std::optional<std::array<double, 2>> face_width;      ///< b  mm
  std::optional<std::array<double, 2>> face_modules;    ///< b/m_n; 10 if there is no band
  std::optional<std::array<double, 2>> face_diameters;  ///< b/d_1
  double face_step = 1.0;  ///< mm; widths within a band are multiples of this step
  Mounting mounting = Mounting::extended;
  bool shorten_tips = false;  ///< if true, tips are shortened to restore the clearance that is lost
                              ///< at tight centres
  SearchLimits limits;
  double lambda = 0.625;           ///< λ of the line of balanced strength (Eq. 11)
  double target_ratio = 0.0;       ///< for the objective `ratio`
  std::optional<double> friction;  ///< μ of the flanks, for the efficiency of every design
  double cost_exponent = 0.5;      ///< exponent of b/d_1 for the objective `cost`
  std::vector<Objective> objectives{Objective::contact_ratio};
  int loaded_designs = 10;  ///< number of the best designs whose transmission error under load is
                            ///< computed (job/loaded_designs.hpp), if a search ranks by noise
  std::optional<double> shift_step;  ///< step of the grid of shifts, if its points are requested
  std::array<double, 2> density{kSteelDensity, kSteelDensity};  ///< ρ  kg/mm³
  std::optional<SearchRating> rating;                           ///< absent if designs are not rated
  bool rating_unused =
      false;  ///< true if a load is given but affects neither limits nor objectives
  SearchAllowances allowances;  ///< empty if the teeth have no allowances
  DrawDesign draw;  ///< makes the drawing of a design and its verdict; empty if no drawing is
                    ///< required

  bool internal() const { return ratio[0] < 0.0; }
  bool crossed() const { return shaft_angle.has_value(); }
  PairKind kind() const {
    if (shaft_angle) return PairKind::crossed;
    return ratio[0] < 0.0 ? PairKind::parallel_internal : PairKind::parallel_external;
  }
  /// True if the designs are mounted at tight centres. On crossed axes, `mounting` has no effect
  /// and the result is false.
  bool tight() const { return mounting == Mounting::tight && !crossed(); }
  /// True if a band contains several face widths.
  bool has_face_band() const {
    const auto open = [](const auto& band) { return band && (*band)[0] < (*band)[1]; };
    return open(face_width) || open(face_modules) || open(face_diameters);
  }
  /// True if the face width is chosen for each design. If a helix angle was chosen for a face
  /// width, the width is not changed.
  bool sizes_faces() const { return has_face_band() && choices.empty(); }
  /// Returns the limits that can reject a design, in the order of evaluation.
  std::vector<Limit> rejecting_limits() const {
    std::vector<Limit> all;
    for (int i = 0; i < kLimits; ++i) {
      const auto limit = static_cast<Limit>(i);
      const bool drawn = limit == Limit::verdict;
      if (drawn ? static_cast<bool>(draw) : i < kRegionLimits || rating) all.push_back(limit);
    }
    return all;
  }
  /// True if masses must be computed.
  bool weighs() const { return rating || ranks_by(Objective::mass) || ranks_by(Objective::cost); }
  /// Returns μ if efficiencies must be computed, and otherwise none.
  std::optional<double> flank_friction() const {
    return friction || !ranks_by(Objective::efficiency) ? friction : kUsualFriction;
  }
  /// True if the transmission error under load of the best designs must be computed.
  bool loads_designs() const { return loaded_designs > 0 && ranks_by(Objective::noise); }
  bool ranks_by(Objective objective) const { return is_in(objective, objectives); }
};

/// One combination of rack, helix angles, module and numbers of teeth, without shifts.
struct Trial {
  std::int64_t index = 0;  ///< number of the trial
  double module = 0.0;     ///< m_n  mm
  int z1 = 0, z2 = 0;
  std::array<Angle, 2> helix{};        ///< β  signed
  int rack = 0;                        ///< index in SearchProblem::racks
  std::optional<double> face_width{};  ///< b  mm, if the helix angle was chosen for this width
};

/// Returns the rack of gear i, marked as a named rack. If the fillet radius of a named rack is too
/// great for the pressure angle, the full fillet radius is used instead.
inline StraightRack rack_of(const SearchProblem& problem, const Trial& trial, std::size_t i) {
  StraightRack rack = problem.racks[static_cast<std::size_t>(trial.rack)].rack[i];
  rack.named = true;
  return rack;
}

}  // namespace gearwright
