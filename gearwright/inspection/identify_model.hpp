// What a gear of given numbers reads under the tools of an unknown gear's readings.
//
// Internal to inspection/: the fits of identify() ask it some ten thousand times, so it is the closed
// forms alone, without making the gear.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/inspection/identify.hpp"

namespace gearwright::detail {

/// A gear by its numbers.
struct GearNumbers {
  int teeth;      ///< z, signed
  double module;  ///< m_n  mm
  double alpha;   ///< α_n  rad
  double beta;    ///< β    rad
  double shift;   ///< x_E
};

/// One reading as a number that every gear has.
struct Observation {
  enum class Kind { span, balls, lead, helix, tip, root, distance };
  Kind kind;
  double tool;   ///< k, D_M, z of the mating gear
  double value;  ///< mm; 1/mm of a lead, sin β/(π z m_n); rad
  double sigma;  ///< standard deviation, in that unit; without what a rough reading adds
  /// Whether it says what the gear is to its own uncertainty.
  bool exact() const { return kind <= Kind::helix; }
};

std::vector<Observation> observations(const IdentifyProblem& problem);

/// What the gear reads; none: this tool finds no flank.
///
/// Formula   [T10.2], [T10.6], [T10.8]; lead π z m_n/sin β
std::optional<double> reading_of(const GearNumbers& gear, const Observation& o);

/// (reading − gear)/σ [T10.24], with the scatter of rough readings: tips wear and racks differ, in modules.
std::optional<double> residual(const GearNumbers& gear, const Observation& o);

}  // namespace gearwright::detail
