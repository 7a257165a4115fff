// The inputs of ISO 6336, computed from a pair of involute gears on parallel axes. In every list,
// the pinion is the first gear.
//
//   z, m_n, α_n, β     as on the drawing; z < 0 for an internal gear, β ≥ 0 for both hands
//   α_t, α_wt, β_b     transverse and working pressure angle, base helix angle, rad
//   d, d_b, d_a, d_f   diameters, positive, mm
//   x, x_E             profile shift and generating profile shift
//   ε_α, ε_β           transverse contact ratio and overlap ratio       u = z2/z1, |u| ≥ 1
//   ε_αn, z_n          contact ratio and tooth number of the virtual spur gear (normal section)
//                                              theory: docs/theory/11-rating.md
#pragma once

#include <array>
#include <cstddef>

#include "gearwright/base/result.hpp"
#include "gearwright/inspection/flank_tolerances.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/rating/factor.hpp"

namespace gearwright {

/// The dimensions of the tool that determine the root, in normal modules.
struct RootTool {
  double addendum = 1.0;      ///< h_aP*   addendum of the gear
  double dedendum = 1.25;     ///< h_fP*
  double fillet = 0.38;       ///< ρ_fP*
  double protuberance = 0.0;  ///< s_pr*   residual undercut at the root due to protuberance
  int cutter_teeth = 0;       ///< z_0     of a pinion cutter; 0 for a rack
  double cutter_shift = 0.0;  ///< x_0
};

struct RatedGear {
  int teeth = 0;                    ///< z, negative if internal
  double reference_diameter = 0.0;  ///< d    mm
  double base_diameter = 0.0;       ///< d_b  mm
  double tip_form_diameter = 0.0;   ///< d_Fa mm, where the flank ends at the tip
  double tip_diameter = 0.0;        ///< d_Na mm, where contact ends at the tip: d_Fa, or the end of
                                    ///< the usable flank of the mating gear
  double root_diameter = 0.0;       ///< d_f  mm
  double tooth_height = 0.0;        ///< h    mm, from root to tip
  double profile_shift = 0.0;       ///< x
  double generating_shift = 0.0;    ///< x_E
  double virtual_teeth = 0.0;       ///< z_n, signed
  double face_width = 0.0;          ///< b    mm
  double bore = 0.0;                ///< d_i  mm; outside diameter of an internal gear; 0 if none
  RootTool tool;

  bool internal() const { return teeth < 0; }
  double side() const { return side_of(teeth); }  ///< σ
};

struct RatedPair {
  RatedPair() = default;           ///< empty; prevents aggregate initialisation
  std::array<RatedGear, 2> gears;  ///< pinion, wheel
  bool exchanged = false;          ///< true if the pinion is gear 2 of the spec
  double normal_module = 0.0;      ///< m_n   mm
  double alpha_n = 0.0;            ///< rad, like all angles of this struct
  double beta = 0.0;               ///< ≥ 0
  double alpha_t = 0.0;
  double alpha_wt = 0.0;
  double beta_b = 0.0;
  double center_distance = 0.0;  ///< a     mm
  double u = 0.0;                ///< z2/z1, negative for an internal pair
  double face_width = 0.0;       ///< b     mm, the lesser of both; b_B for double-helical gears
  int halves = 1;  ///< 2 for double-helical gears, whose halves share the load equally
  double epsilon_alpha = 0.0;
  double epsilon_beta = 0.0;

  bool spur() const { return beta == 0.0; }
  double epsilon_gamma() const { return epsilon_alpha + epsilon_beta; }
  /// Returns the width that carries the load, 2 b_B for double-helical gears. [ISO 6336-1, 4.2]
  double carrying_width() const { return halves * face_width; }
  double epsilon_alpha_n() const;
  /// Returns the index in `gears` of gear 1 or 2 of the spec.
  std::size_t place(int which) const { return static_cast<std::size_t>((which == 1) == exchanged); }
};

/// Converts a list from the order gear 1, gear 2 to the order pinion, wheel, or vice versa.
template <class T>
std::array<T, 2> turned(const RatedPair& pair, const std::array<T, 2>& list) {
  return pair.exchanged ? std::array<T, 2>{list[1], list[0]} : list;
}

/// Returns the virtual number of teeth z_n = z/(cos² β_b cos β) of both editions.
///
/// Formula   ISO 6336-3, 6.2; confirmed to six digits by ISO/TR 6336-30, example 1
double virtual_teeth(int teeth, double beta, double beta_b);
/// Returns the inputs of a mounted pair.
///
/// Errors    `pair.shaft_angle` on crossed axes, `pair.center_distance` if the usable flanks do not
///           meet, `gear1.rack` for circular-arc teeth
Result<RatedPair> rated_pair(const Pair& pair);

// The tolerances of ISO 1328-1 that a rating requires, computed from the accuracy grade.
//
//   f_pt, f_pb    single pitch deviation and base pitch deviation, µm; f_pb = f_pt cos α_t
//   f_fα, f_Hβ    profile form and helix slope deviation, µm
//
// ISO 6336:2006 refers to ISO 1328-1:1995, and ISO 6336:2019 refers to ISO 1328-1:2013.

constexpr int kBestGrade = 0, kWorstGrade = 12;

struct Tolerances {
  double f_pt, f_pb, f_falpha, f_Hbeta;  ///< µm
};

/// Returns the edition of ISO 1328-1 that an edition of ISO 6336 uses.
FlankTolerances tolerance_edition(RatingEdition edition);

/// Formula   flank_tolerances() for tolerance_edition()
/// Domain    has_class() (contract)
Tolerances tolerances(RatingEdition edition, int grade, const RatedGear& gear, double normal_module,
                      double alpha_t);

}  // namespace gearwright
