// Finds spur or helical pairs for a ratio and a centre distance by plain loops in long double, over
// modules, numbers of teeth and, for each pair of gears, all profile shifts.
//
//   lengths in normal modules m = 1, angles in rad; shifts x as in ISO 21771
//   z_2 < 0    an internal gear; its diameters and centre distances are positive here
//   σ          +1 external, −1 internal
//   S          x_1 + x_2
//   ρ_1, ρ_2   radii of curvature of the flanks in contact; A: tip of gear 2, E: tip of gear 1
//   N          distance of the base tangent points T_1, T_2;  ρ_2 = N − σρ_1
//
// All values are nominal. Tips are not shortened, and there are no allowances. Path and contact
// ratio refer to the transverse section.
#pragma once

#include <array>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace gearwright::oracle {

/// The part of the path of contact for which the clipped contact ratio is computed.
enum class PlainClip {
  none,            ///< the whole path: only Eq. 10 is limited
  tangent_points,  ///< the part between T_1 and T_2
  usable_flanks  ///< the same, but not below ρ_F1, ρ_F2, the starts of the flanks that the straight
                 ///< edge of the cutter generates
};

/// Limits that every pair must satisfy. If a limit is absent, it does not apply. Values equal to a
/// limit are permitted.
struct PlainProblem {
  long double alpha_n = std::numbers::pi_v<long double> / 9;
  long double beta = 0;             ///< |β|
  long double ha = 1, hf = 1.25L;   ///< addendum, dedendum
  long double undercut_depth = 1;   ///< depth of the cutter's straight edge
  long double undercut_margin = 0;  ///< least distance of a shift from the undercut limit
  std::optional<long double> floor = {}, ceil = {};  ///< of either shift
  long double tip_thickness_min = 0.2L;              ///< s_an ≥, must be ≥ 0
  long double contact_ratio_min = 1.2L;              ///< limit for Eq. 10 and for the clipped
                                                     ///< contact ratio
  PlainClip clip = PlainClip::tangent_points;
  bool tight = false;  ///< backlash-free centre distances; otherwise extended ones
  std::optional<long double> sliding_max = {}, clearance_min = {};
  bool avoid_interference = false;  ///< ρ_1A ≥ ρ_F1, ρ_2E ≥ ρ_F2; not for an internal gear
};

/// The margins to the limits; a value ≥ 0 is inside. It is +∞ if there is no such limit, and −∞ if
/// the limited quantity does not exist.
struct PlainMargins {
  static constexpr long double kFree = std::numeric_limits<long double>::infinity();

  long double s1min = kFree, s2min = kFree;  ///< x − (undercut limit + margin, or floor)
  long double s1max = kFree, s2max = kFree;  ///< ceil − x or s_an − tip_thickness_min, whichever is
                                             ///< smaller
  long double eps = kFree, eps_true = kFree;
  long double sliding = kFree;    ///< sliding_max − the greatest of |ζ_1|, |ζ_2| at A and E
  long double clearance = kFree;  ///< the smaller one
  long double interference1 = kFree, interference2 = kFree;  ///< ρ_1A − ρ_F1, ρ_2E − ρ_F2

  std::map<std::string, long double> by_name() const;
  long double min() const;
};

/// One pair (m = 1, z_1, z_2, x_1, x_2) at its centre distance. NaN if a quantity does not exist.
struct PlainPoint {
  long double centre_distance, alpha_wt;  ///< a, α_wt
  long double rho_1A, rho_2A, rho_1E, rho_2E;
  long double eps;         ///< Eq. 10; NaN below the sum of the base radii or with a tip below base
  long double eps_true;    ///< clipped at T_1 and T_2; < 0: no path remains
  long double eps_usable;  ///< clipped at ρ_F1 and ρ_F2 too
  std::array<long double, 2> tip_thickness;   ///< s_an, normal section
  std::array<long double, 2> zeta_A, zeta_E;  ///< ζ_1, ζ_2; NaN at or beyond a base tangent point
  std::array<long double, 2> tip_clearance;   ///< tip of gear 1 to root of gear 2, and the other
  PlainMargins margins;
};

/// Domain    z1 ≥ 1; z2 ≥ 1, or z2 < −z1
/// Throws    std::invalid_argument with the reason if the problem or the pair is invalid
PlainPoint look(const PlainProblem& problem, int z1, int z2, long double x1, long double x2);

enum class PlainVerdict { empty, not_empty, ambiguous };

struct PlainAnswer {
  PlainVerdict verdict;
  std::string killed_by;   ///< the first of `shift_limits`, `center_distance`, `contact_ratio`,
                           ///< `other` that leaves no design; empty if there is a design
  long double min_margin;  ///< smallest margin of the contact and clearance limits at the best
                           ///< point found; −∞ if there is none
  long double x1, x2;      ///< the best point; NaN if there is none
};

/// Searches for a pair of shifts that satisfies all limits, at a centre distance in the range.
///
/// `not_empty` means that such a point was found. All its margins except those of the shifts exceed
/// 1e-9, or limits that meet exactly restrict the shifts to one point. `empty` is proven: no cell
/// of the shifts can contain such a point (plain_cells.hpp). `ambiguous` means that the result is
/// within 1e-9 of the opposite one, or that 200 000 cells were not sufficient.
///
/// Units     m, c_min, c_max in mm, c_min ≤ c_max; if they are equal, the distance must be exact
/// Throws    std::invalid_argument as `look`
PlainAnswer region_not_empty(const PlainProblem& problem, long double m, int z1, int z2,
                             long double c_min, long double c_max);

/// Measures of the region of the shifts, computed from its slices S = constant.
struct PlainRegion {
  long double area = 0;                                            ///< ∫ dx_1 dx_2
  long double s_lo = 0, s_hi = 0;                                  ///< least and greatest S
  std::array<std::array<long double, 2>, 2> lo_edge{}, hi_edge{};  ///< (x_1, x_2), x_1 growing
  std::array<long double, 2> lo{}, hi{};                           ///< middles of these slices
};

/// Domain    a region that is not empty, by `region_not_empty`; otherwise nothing is returned
/// Accuracy  area 1e-4 of itself with 600 slices (measured: 3.1e-5); s_lo, s_hi 1e-12; the edges
///           1e-8 if a slice is only a point. A second interval of a slice is missed if it lies
///           between two of the 49 samples of the slice
std::optional<PlainRegion> measure_region(const PlainProblem& problem, long double m, int z1,
                                          int z2, long double c_min, long double c_max,
                                          int slices = 600);

/// Both ends are included.
struct PlainBand {
  long double low, high;
};

struct PlainSearch {
  using Design = std::tuple<double, int, int>;  ///< module, z_1, z_2
  std::vector<Design> designs;                  ///< in the order of the loops
  std::vector<Design> ambiguous;                ///< not among `designs`
  long tested = 0;
  std::map<std::string, long> rejected;  ///< counted by `killed_by`
};

/// Loops over modules, z_1 and z_2 ≥ z_1 for which z_2/z_1 lies in the band, widened by 1e-12. A
/// band of negative ratios means internal gears, −z_2 > z_1. If `coprime` is true, pairs with a
/// common factor are omitted.
///
/// Units     modules and centre distances in mm
/// Throws    std::invalid_argument as `look`; a ratio band that contains 0
PlainSearch plain_search(const PlainProblem& problem, const std::vector<double>& modules,
                         PlainBand ratio, std::array<int, 2> z1, PlainBand center_distance,
                         bool coprime);

}  // namespace gearwright::oracle
