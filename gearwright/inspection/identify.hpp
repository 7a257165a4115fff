// Identifies an unknown gear. The result lists the standard gears that agree with its readings, the
// likeliest first.
//
//   u      uncertainty of a reading at 95 %; σ = u/1.96
//   χ²     sum of squares of (reading − predicted reading)/σ
//   x_E    generating profile shift, including the allowance       p_bn  normal base pitch
//                                              theory: docs/theory/10-inspection.md
//
// A gear of z teeth is described by module, pressure angle, helix angle and x_E. In a
// hypothesis, module and pressure angle are standard values, and the helix angle is 0, a whole
// number of degrees, or fitted. x_E is always fitted. If spans give the base pitch, a fitted
// module is also tried. The evidence of a hypothesis combines the quality of the fit, the
// fraction of the prior range that agrees with the readings, and the prior probability of such
// gears. Readings of tip and root are only rough, because tips may be worn and roots may be cut
// by several racks. These readings select the basic rack of the drawing. The reading of the tip
// also distinguishes a profile shift from a thickness allowance.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/result.hpp"
#include "gearwright/tool/straight_rack.hpp"

namespace gearwright {

struct SpanReading {
  int teeth = 0;       ///< k
  double value = 0.0;  ///< W_k  mm
};

struct DiameterReading {
  double tool = 0.0;   ///< D_M   mm
  double value = 0.0;  ///< M_dK  mm
};

/// An optional reading with its uncertainty. By default, the usual uncertainty is used.
template <class T>
struct MaybeReading {
  std::optional<T> value, uncertainty;
};

struct IdentifyProblem {
  int teeth = 0;                               ///< z, negative if internal
  std::optional<Angle> normal_pressure_angle;  ///< α_n, if known
  std::optional<Angle> helix_angle;            ///< β, if known; 0 for a spur gear
  std::vector<SpanReading> spans;
  std::vector<DiameterReading> balls;
  double span_uncertainty = 0.02;     ///< u of each span, mm
  double balls_uncertainty = 0.02;    ///< u of each dimension over balls, mm
  MaybeReading<double> tip, root;     ///< tip and root diameter, mm
  MaybeReading<double> lead;          ///< mm, > 0 right hand
  MaybeReading<Angle> helix;          ///< measured helix angle
  MaybeReading<double> distance;      ///< centre distance to the mating gear, mm
  std::optional<int> mating_teeth{};  ///< number of teeth of the mating gear
  // Values of the drawing, if they are known.
  std::optional<double> profile_shift{};        ///< x
  std::optional<double> thickness_allowance{};  ///< E_sn  mm
  std::optional<StraightRack> rack{};           ///< the basic rack
  /// The factor that corrects a reading in the wrong unit. It is 25.4 if the user gives inches
  /// instead of mm, and 1/25.4 if the user gives mm instead of inches.
  double other_unit = 25.4;
};
enum class ModuleSeries { iso54_1, iso54_2, diametral_pitch, none };

/// The quantities that are read on an unknown gear, the exact ones first. `all` stands for all
/// lengths that are read, and `span_teeth` for the numbers of teeth in the spans.
enum class Reading {
  span,
  over_balls,
  lead,
  helix_angle,
  tip_diameter,
  root_diameter,
  center_distance,
  teeth,
  all,
  span_teeth
};

/// A reading that disagrees with all other readings, and the value that the other readings predict.
struct Contradiction {
  Reading reading;
  double tool;                     ///< k or D_M; 0 for other readings
  double value;                    ///< the reading, mm or degrees
  std::optional<double> expected;  ///< the value predicted by the other readings; none for the
                                   ///< infinite lead of a spur gear
};

/// Comparison of the measured tip with the tip that follows from the rack and the profile shift.
enum class TipReading { none, as_drawn, worn, shortened, longer };

/// The values with which a drawing describes an identified gear. The teeth have the generating
/// profile shift x_E = x + E_sn/(2 m_n tan α_n).
struct DrawnGear {
  std::string rack;             ///< name of the basic rack; empty if the problem gives the rack
  double profile_shift;         ///< x
  double thickness_allowance;   ///< E_sn  mm
  double tip_diameter;          ///< d_a  mm; the measured one if the tip is longer or much shorter
                                ///< than the rack gives
  double nominal_tip_diameter;  ///< mm, as the rack and the profile shift give
  double root_diameter;         ///< d_f  mm
  TipReading tip;
  std::optional<double> shift_of_tip;          ///< x_a, from the measured tip and the rack
  std::optional<Contradiction> contradiction;  ///< a tip or root that does not fit this gear
};

struct IdentifiedGear : DrawnGear {
  int teeth;
  double normal_module;  ///< m_n  mm
  ModuleSeries series;
  std::optional<double> diametral_pitch;  ///< 1/in, if the series is one of diametral pitches
  Angle normal_pressure_angle;            ///< α_n
  Angle helix_angle;                      ///< β, > 0 for right hand and if the hand is unknown
  double generating_shift;                ///< x_E
  double likelihood;                      ///< the sum over all hypotheses is 1
  double misfit;                          ///< χ² of the exact readings
  // Uncertainties, ± at 95 %; 0 for standard values.
  double module_uncertainty;  ///< mm
  double shift_uncertainty;
  Angle helix_uncertainty;

  /// False if |x_E| > 1.5, because such gears do not occur.
  bool plausible() const { return generating_shift >= -1.5 && generating_shift <= 1.5; }
};

/// The measurement that separates the first candidate from the greatest part of the probability of
/// the other candidates. The rival is the likeliest candidate from which it separates the first.
struct NextMeasurement {
  Reading reading;               ///< a span, a dimension over balls or the helix angle
  double tool;                   ///< k or D_M
  std::array<double, 2> expect;  ///< predicted readings of the first candidate and of the rival
  std::array<double, 2> spread;  ///< ± of `expect` at 95 %, including that of the reading
  int rival;                     ///< index of the rival, from 0
  std::vector<int> separates;    ///< indices of all candidates that it separates from the first
};
/// A gear that agrees with all readings if one input is corrected.
struct Alternative {
  Reading mistake;  ///< `teeth`, `span_teeth`, or the readings that are in the other unit
  IdentifiedGear gear;
  int step = 0;  ///< for `span_teeth`: change of the number of teeth in each span
};
struct Identification {
  std::vector<IdentifiedGear> candidates;      ///< the likeliest first
  std::optional<Contradiction> contradiction;  ///< if present, this reading was not used
  std::optional<NextMeasurement> next;         ///< none if there is only one candidate, or if no
                                               ///< measurement distinguishes the candidates
  std::string reason;                          ///< the reason why no gear agrees with the readings;
                                               ///< empty if one agrees
  std::optional<Alternative> alternative{};    ///< present if the correction of one input gives a
                                               ///< gear that agrees, and if the first candidate
                                               ///< disagrees with the readings, is nonstandard or
                                               ///< is implausible, or has |x_E| > 1 while the
                                               ///< corrected gear has |x_E| ≤ 1
};
inline constexpr int kMostCandidates = 8;
/// Errors    `teeth` if missing or fewer than 3; `measured` if no reading determines the size;
///           `measured.lead` if its sign is not that of the helix angle, or if the helix angle is 0;
///           `measured.root_diameter` if the root is not inside the tip (for an internal gear,
///           outside) and a wrong unit does not explain this
Result<Identification> identify(const IdentifyProblem& problem);

}  // namespace gearwright
