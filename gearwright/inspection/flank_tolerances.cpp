#include "gearwright/inspection/flank_tolerances.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include <fmt/format.h>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/error.hpp"
#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

constexpr int kOwnClass = 5;  // the class for which the formulas give the tolerances
// √2 per class
double step_factor(int quality) {
  const int steps = quality - kOwnClass;
  const int odd = steps & 1;
  return std::ldexp(odd == 1 ? std::numbers::sqrt2 : 1.0, (steps - odd) / 2);
}
// Borders of the ranges of ISO 1328-1:1995, mm. A value on a border belongs to the lower range.
constexpr std::array kDiameters{5.,    20.,   50.,   125.,  280.,  560.,  1000.,
                                1600., 2500., 4000., 6000., 8000., 10000.};
constexpr std::array kModules{0.5, 2., 3.5, 6., 10., 16., 25., 40., 70.};
constexpr std::array kFaces{4., 10., 20., 40., 80., 160., 250., 400., 650., 1000.};
// Borders of the ranges of ISO 1328-2:1997, mm.
constexpr std::array kRadialDiameters{5., 20., 50., 125., 280., 560., 1000.};
constexpr std::array kRadialModules{0.2, 0.5, 0.8, 1.0, 1.5, 2.5, 4.0, 6.0, 10.0};

// Returns the geometric mean of the range that contains the value, or of the nearest range if no
// range contains the value.
double mean_of_range(std::span<const double> borders, double value) {
  std::size_t i = 1;
  while (i + 1 < borders.size() && value > borders[i]) ++i;
  return std::sqrt(borders[i - 1] * borders[i]);
}

void add_radial(FlankToleranceValues& t, int quality, const ToleranceSubject& gear) {
  const double d_own = gear.reference_diameter, m_own = gear.normal_module;
  const bool held = d_own >= kRadialDiameters.front() && d_own <= kRadialDiameters.back() &&
                    m_own >= kRadialModules.front() && m_own <= kRadialModules.back();
  if (!held) return;
  const double d = mean_of_range(kRadialDiameters, d_own);
  const double m = mean_of_range(kRadialModules, m_own);
  const double f = step_factor(quality);
  t.radial_composite = rounded_tolerance(f * (3.2 * m + 1.01 * std::sqrt(d) + 6.4));
  t.tooth_radial_composite = rounded_tolerance(f * (2.96 * m + 0.01 * std::sqrt(d) + 0.8));
}

constexpr int kSectors = 8;

// Returns the factor K of f_i′. [T10.32]
double overlap_factor(double contact_ratio) {
  return contact_ratio < 4.0 ? 0.2 * (contact_ratio + 4.0) / contact_ratio : 0.4;
}

// Adds the tolerances of sector pitch and single flank composite, by the formulas of 1995.
// [T10.31], [T10.32]
void add_single_flank(FlankToleranceValues& t, int quality, const ToleranceSubject& gear) {
  const double root_d = std::sqrt(mean_of_range(kDiameters, gear.reference_diameter));
  const double m = mean_of_range(kModules, gear.normal_module);
  const double f = step_factor(quality);
  const double f_pt = 0.3 * (m + 0.4 * root_d) + 4;
  if (const int k = gear.teeth / kSectors; k >= 2)
    t.sector_pitch = rounded_tolerance(f * (f_pt + 1.6 * std::sqrt((k - 1) * m)));
  if (!gear.contact_ratio || !(*gear.contact_ratio > 0.0)) return;
  const double F_p = 0.3 * m + 1.25 * root_d + 7;
  const double F_alpha = 3.2 * std::sqrt(m) + 0.22 * root_d + 0.7;
  const double tooth = overlap_factor(*gear.contact_ratio) * (4.3 + f_pt + F_alpha);
  t.tooth_single_flank = rounded_tolerance(f * tooth);
  t.single_flank = rounded_tolerance(f * (F_p + tooth));
}

// Returns the tolerances by the formulas of 2013. [T10.15]…[T10.17], [T10.37]
FlankToleranceValues of_2013(int quality, const ToleranceSubject& gear) {
  const double d = gear.reference_diameter, m = gear.normal_module, b = gear.face_width;
  const double f = step_factor(quality);
  const auto rounded = rounded_tolerance;
  const double f_pt = f * (0.001 * d + 0.4 * m + 5);
  const double F_p = f * (0.002 * d + 0.55 * std::sqrt(d) + 0.7 * m + 12);
  const double f_Halpha = f * (0.4 * m + 0.001 * d + 4);
  const double f_falpha = f * (0.55 * m + 5);
  const double f_Hbeta = f * (0.05 * std::sqrt(d) + 0.35 * std::sqrt(b) + 4);
  const double f_fbeta = f * (0.07 * std::sqrt(d) + 0.45 * std::sqrt(b) + 4);
  // The total tolerances are computed from the unrounded tolerances of form and slope.
  FlankToleranceValues t{rounded(f_pt),
                         rounded(F_p),
                         rounded(std::hypot(f_Halpha, f_falpha)),
                         rounded(f_falpha),
                         rounded(f_Halpha),
                         rounded(std::hypot(f_Hbeta, f_fbeta)),
                         rounded(f_fbeta),
                         rounded(f_Hbeta),
                         rounded(0.9 * F_p),
                         {},
                         {}};
  // The second term is proportional to k, so that a sector of z/4 pitches has the tolerance F_pT.
  if (const int k = gear.teeth / kSectors; k >= 2)
    t.sector_pitch =
        rounded(f_pt + 4.0 * k / gear.teeth * f * (0.001 * d + 0.55 * std::sqrt(d) + 0.3 * m + 7));
  return t;
}

// Returns the tolerances by the formulas of 1995, which use the geometric means of ranges. [T10.18]
FlankToleranceValues of_1995(int quality, const ToleranceSubject& gear) {
  const double d = mean_of_range(kDiameters, gear.reference_diameter);
  const double m = mean_of_range(kModules, gear.normal_module);
  const double b = mean_of_range(kFaces, gear.face_width);
  const double f = step_factor(quality), root_d = std::sqrt(d), root_m = std::sqrt(m);
  const auto rounded = [f](double um) { return rounded_tolerance(f * um); };
  const double F_p = 0.3 * m + 1.25 * root_d + 7;
  const double half_helix = 0.07 * root_d + 0.45 * std::sqrt(b) + 3;
  return {rounded(0.3 * (m + 0.4 * root_d) + 4),
          rounded(F_p),
          rounded(3.2 * root_m + 0.22 * root_d + 0.7),
          rounded(2.5 * root_m + 0.17 * root_d + 0.5),
          rounded(2.0 * root_m + 0.14 * root_d + 0.5),
          rounded(0.1 * root_d + 0.63 * std::sqrt(b) + 4.2),
          rounded(half_helix),
          rounded(half_helix),
          rounded(0.8 * F_p),
          {},
          {}};
}

}  // namespace

double rounded_tolerance(double um) {
  const double step = um > 10.0 ? 1.0 : um >= 5.0 ? 2.0 : 10.0;  // per µm
  return std::round(um * step) / step;
}

bool has_class(FlankTolerances edition, int quality) {
  return edition == FlankTolerances::iso_2013 ? quality >= 1 && quality <= 11
                                              : quality >= 0 && quality <= 12;
}

std::string beyond_range(FlankTolerances edition, const ToleranceSubject& g) {
  struct Range {
    const char* name;
    double value, lo, hi;
    const char* unit;
  };
  const bool newer = edition == FlankTolerances::iso_2013;
  const double helix = newer ? std::abs(g.helix_angle) * kDegPerRad : 0.0;
  for (const Range& r :
       {Range{"number of teeth", double(g.teeth), newer ? 5.0 : 1.0, newer ? 1000.0 : HUGE_VAL, ""},
        {"reference diameter", g.reference_diameter, 5, newer ? 15e3 : 1e4, " mm"},
        {"normal module", g.normal_module, 0.5, 70, " mm"},
        {"face width", g.face_width, 4, newer ? 1200.0 : 1000.0, " mm"},
        {"helix angle", helix, 0, 45, "°"}}) {
    if (r.value < r.lo || r.value > r.hi)
      return fmt::format("{} of {}{u} is outside its range of {}{u} to {}{u}", r.name,
                         format_number(r.value), format_number(r.lo), format_number(r.hi),
                         fmt::arg("u", r.unit));
  }
  return "";
}

FlankToleranceValues flank_tolerances(FlankTolerances edition, int quality,
                                      const ToleranceSubject& gear) {
  GW_EXPECTS(has_class(edition, quality));
  FlankToleranceValues t =
      edition == FlankTolerances::iso_2013 ? of_2013(quality, gear) : of_1995(quality, gear);
  t.quality = quality;
  t.edition = edition;
  add_radial(t, quality, gear);
  if (gear.transverse_pressure_angle)
    t.base_pitch = t.single_pitch * std::cos(*gear.transverse_pressure_angle);
  if (edition == FlankTolerances::iso_1995) add_single_flank(t, quality, gear);
  return t;
}

void set_axis_tolerances(FlankToleranceValues& t, double greater_helix_total, double face_width,
                         double bearing_span) {
  GW_EXPECTS(face_width > 0.0 && bearing_span > 0.0);
  t.axis_deviation = 0.5 * bearing_span / face_width * greater_helix_total;
  t.axis_inclination = 2 * *t.axis_deviation;
}

}  // namespace gearwright
