// Identification of an unknown gear: the standard gears that agree with its readings, the likeliest
// first.
//
//   u      uncertainty of a reading, 95 %; σ = u/1.96        χ²   sum of squares of (reading − gear)/σ
//   x_E    generating profile shift, allowance included       p_bn  normal base pitch
//                                              theory: docs/theory/10-inspection.md
//
// A gear of z teeth is described by module, pressure angle, helix angle and x_E. The first two come
// from the standards. The helix angle is 0, a whole number of degrees, or free. x_E and a free
// helix angle are fitted. A hypothesis is judged by its evidence, which combines its fit, the
// fraction of its prior range that the readings leave, and how common such gears are. Tips may be
// worn and roots may come from several racks, so these two readings locate the gear only roughly.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/result.hpp"

namespace gearwright {

struct SpanReading {
  int teeth = 0;       ///< k
  double value = 0.0;  ///< W_k  mm
};

/// A dimension over two balls.
struct DiameterReading {
  double tool = 0.0;   ///< D_M   mm
  double value = 0.0;  ///< M_dK  mm
};

/// An optional reading with its own uncertainty or the usual one.
template <class T>
struct MaybeReading {
  std::optional<T> value, uncertainty;
};

struct IdentifyProblem {
  int teeth = 0;                               ///< z, negative if internal
  std::optional<Angle> normal_pressure_angle;  ///< α_n, where it is known
  std::optional<Angle> helix_angle;            ///< β, where it is known; 0 for a spur gear
  std::vector<SpanReading> spans;
  std::vector<DiameterReading> balls;
  double span_uncertainty = 0.02;     ///< mm
  double balls_uncertainty = 0.02;    ///< mm
  MaybeReading<double> tip, root;     ///< mm
  MaybeReading<double> lead;          ///< mm, > 0 right hand
  MaybeReading<Angle> helix;          ///< of a measurement
  MaybeReading<double> distance;      ///< mm, to the mating gear
  std::optional<int> mating_teeth{};  ///< of that one
};

/// The kind of standard of a candidate.
enum class ModuleSeries { iso54_1, iso54_2, diametral_pitch, none };

struct IdentifiedGear {
  int teeth;
  double normal_module;  ///< m_n  mm
  ModuleSeries series;
  std::optional<double> diametral_pitch;  ///< 1/in, of that series
  Angle normal_pressure_angle;            ///< α_n
  Angle helix_angle;                      ///< β, > 0 right hand; also > 0 if the hand is unknown
  double generating_shift;                ///< x_E
  double tip_diameter;                    ///< mm, measured, or as the shift determines it
  std::optional<double> shift_of_tip;     ///< x that follows from an unworn tip
  double likelihood;                      ///< the sum over all candidates is 1
  double misfit;                          ///< χ² of the exact readings
  // Uncertainties, ± of 95 %; 0 for the number of a standard.
  double module_uncertainty;  ///< mm
  double shift_uncertainty;
  Angle helix_uncertainty;
};

/// A reading that disagrees with all others, and the value that they predict.
struct Contradiction {
  std::string reading;  ///< "span", "over_balls", "lead", "helix_angle"
  double tool;          ///< k, D_M; 0 if it has none
  double value;         ///< as read, mm or degrees
  double expected;      ///< predicted by the others
};

struct NextMeasurement {
  std::string reading;           ///< "span", "over_balls", "lead"
  double tool;                   ///< k, D_M
  std::array<double, 2> expect;  ///< readings expected of the first candidate and of its rival
  int rival;                     ///< index of that candidate, from 0
};

struct Identification {
  std::vector<IdentifiedGear> candidates;      ///< likeliest first
  std::optional<Contradiction> contradiction;  ///< the candidates are those of the other readings
  std::optional<NextMeasurement> next;         ///< none if one is left or no reading decides
  std::string reason;                          ///< the reason if there is no candidate
};

/// The relevant candidates, at most this number.
inline constexpr int kMostCandidates = 8;

/// Errors    `teeth`: missing; `measured`: too few readings; a reading that no gear of so many teeth has
Result<Identification> identify(const IdentifyProblem& problem);

}  // namespace gearwright
