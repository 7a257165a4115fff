// Flank tolerances to ISO 1328: the permitted deviations of the teeth for each grade.
//
//   A           flank tolerance class (grade)
//   d, m_n, b   reference diameter, normal module and face width, mm
//                                              theory: docs/theory/10-inspection.md
//
// Tolerances are in µm. The formulas give the tolerances of class 5. From one class to the next,
// the tolerances increase by the factor √2. The formulas of the edition of 2013 use the dimensions
// of the gear. The formulas of the edition of 1995 use the geometric means of the ranges in which
// these dimensions lie. Radial composite tolerances follow ISO 1328-2:1997. Single flank composite
// tolerances exist only in the edition of 1995. Tolerances of axes follow ISO/TR 10064-3.
#pragma once

#include <optional>
#include <string>

namespace gearwright {

enum class FlankTolerances { iso_2013, iso_1995 };

struct ToleranceSubject {
  double reference_diameter;                          ///< d    mm
  double normal_module;                               ///< m_n  mm
  double face_width;                                  ///< b    mm
  int teeth;                                          ///< |z|
  double helix_angle;                                 ///< β    rad
  std::optional<double> transverse_pressure_angle{};  ///< α_t  rad; none if the teeth are not
                                                      ///< involutes
  std::optional<double> contact_ratio{};  ///< ε_γ  of the mounted pair; none without a pair
};

/// All values are in µm. All except f_pb, f_Σβ and f_Σδ are rounded to the rules of the standard.
struct FlankToleranceValues {
  double single_pitch;                           ///< f_ptT
  double cumulative_pitch;                       ///< F_pT, total
  double profile_total;                          ///< F_αT
  double profile_form;                           ///< f_fαT
  double profile_slope;                          ///< f_HαT
  double helix_total;                            ///< F_βT
  double helix_form;                             ///< f_fβT
  double helix_slope;                            ///< f_HβT
  double runout;                                 ///< F_rT
  std::optional<double> radial_composite;        ///< F_i″, total, ISO 1328-2:1997
  std::optional<double> tooth_radial_composite;  ///< f_i″, tooth to tooth
  std::optional<double> base_pitch{};            ///< f_pb, ±
  std::optional<double> sector_pitch{};        ///< F_pk over k = ⌊|z|/8⌋ pitches; none if k < 2
  std::optional<double> single_flank{};        ///< F_i′, total composite with the mating gear
  std::optional<double> tooth_single_flank{};  ///< f_i′, tooth to tooth
  std::optional<double> axis_deviation{};      ///< f_Σβ of the pair, out of the plane of the axes
  std::optional<double> axis_inclination{};    ///< f_Σδ of the pair, in the plane of the axes
  int quality = 0;                             ///< the class and edition of these values
  FlankTolerances edition = FlankTolerances::iso_2013;
};

/// True if the edition has this class. The classes are 1 to 11 in 2013 and 0 to 12 in 1995.
bool has_class(FlankTolerances edition, int quality);
/// Message for a class that the edition does not have.
inline constexpr const char* kClassesOfEditions =
    "is not a grade of this edition; ISO 1328-1:2013 has the grades 1 to 11, and ISO 1328-1:1995 "
    "has 0 to 12";

/// Returns the first dimension to which the formulas of the edition do not apply, with the range of
/// the edition. The text is empty if the formulas apply to all dimensions.
std::string beyond_range(FlankTolerances edition, const ToleranceSubject& gear);
/// Returns all tolerances except the tolerances of the axes.
///
/// Formula   ISO 1328-1:2013, [T10.15]…[T10.17]; ISO 1328-1:1995 and -2:1997, [T10.18]; f_pb and,
///           in the edition of 1995, F_pk, F_i′ and f_i′ to ISO 1328-1:1995, [T10.31], [T10.32];
///           F_pk in the edition of 2013, [T10.37]
/// Units     mm in, µm out
/// Domain    has_class (contract). Radial composite tolerances are absent if the diameter is
///           outside 5 to 1000 mm, or the module outside 0.2 to 10 mm
FlankToleranceValues flank_tolerances(FlankTolerances edition, int quality,
                                      const ToleranceSubject& gear);

/// Sets f_Σβ and f_Σδ for the bearing span L, µm, as ISO/TR 10064-3:1996 recommends.
///
/// Formula   f_Σβ = (L/2b) F_β, f_Σδ = 2 f_Σβ, with the greater F_β of the two gears; [T10.33]
void set_axis_tolerances(FlankToleranceValues& t, double greater_helix_total, double face_width,
                         double bearing_span);
/// Rounds a tolerance: above 10 µm to 1 µm, from 5 to 10 µm to 0.5 µm, and below 5 µm to 0.1 µm.
double rounded_tolerance(double um);

}  // namespace gearwright
