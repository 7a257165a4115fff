// The predicted readings of a gear for the tools that measured an unknown gear.
//
// Internal to inspection/: the fits of identify() call it about ten thousand times, so it uses
// closed forms only and does not make the gear.
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

/// One reading as a number defined for every gear.
struct Observation {
  enum class Kind { span, balls, lead, helix, tip, root, distance };
  Kind kind;
  double tool;   ///< k, D_M, z of the mating gear
  double value;  ///< mm; 1/mm of a lead, sin β/(π z m_n); rad
  double sigma;  ///< standard deviation, in that unit, without that of a rough reading
  /// True if it determines the gear within its own uncertainty.
  bool exact() const { return kind <= Kind::helix; }
};

std::vector<Observation> observations(const IdentifyProblem& problem);

/// The predicted reading; none if this tool finds no flank.
///
/// Formula   [T10.2], [T10.6], [T10.8]; lead π z m_n/sin β
std::optional<double> reading_of(const GearNumbers& gear, const Observation& o);

/// (reading − gear)/σ [T10.24]. The σ of a rough reading includes its scatter in modules, because
/// tips wear and racks differ.
std::optional<double> residual(const GearNumbers& gear, const Observation& o);

}  // namespace gearwright::detail
