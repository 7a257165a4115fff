// Tolerances of the flanks by ISO 1328: how far teeth of a grade may be from their drawing.
//
//   A      flank tolerance class (grade), 5 is the formulas' own; a step is a factor of √2
//   d, m_n, b   reference diameter, normal module, face width, mm       tolerances in µm
//                                              theory: docs/theory/10-inspection.md
//
// The edition of 2013 takes the gear's own numbers, that of 1995 the geometric means of the ranges
// they lie in. Radial composite tolerances are those of ISO 1328-2:1997.
#pragma once

#include <optional>

namespace gearwright {

enum class FlankTolerances { iso_2013, iso_1995 };

struct ToleranceSubject {
  double reference_diameter;  ///< d    mm
  double normal_module;       ///< m_n  mm
  double face_width;          ///< b    mm
  int teeth;                  ///< |z|
  double helix_angle;         ///< β    rad
};

/// All µm, rounded as the standard says.
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
};

/// The classes that the edition has: 1 to 11, or 0 to 12.
bool has_class(FlankTolerances edition, int quality);

/// Whether the gear lies in the range for which the edition says its formulas.
bool in_range(FlankTolerances edition, const ToleranceSubject& gear);

/// Formula   ISO 1328-1:2013, [T10.15]…[T10.17]; ISO 1328-1:1995 and -2:1997, [T10.18]
/// Units     mm in, µm out
/// Domain    has_class (contract). Radial composites are none beyond 1000 mm or 10 mm of module
FlankToleranceValues flank_tolerances(FlankTolerances edition, int quality,
                                      const ToleranceSubject& gear);

/// To 1 µm above 10 µm, to 0.5 µm from 5 µm on, to 0.1 µm below.
double rounded_tolerance(double um);

}  // namespace gearwright
