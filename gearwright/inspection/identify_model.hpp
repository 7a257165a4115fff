// The predicted readings of a gear for the tools with which an unknown gear was measured.
//
// Internal to inspection/. identify() calls these functions about ten thousand times, so they use closed
// forms and do not make the gear.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/inspection/identify.hpp"

namespace gearwright::detail {

/// The numbers that describe a gear.
struct GearNumbers {
  int teeth;      ///< z, signed
  double module;  ///< m_n  mm
  double alpha;   ///< α_n  rad
  double beta;    ///< β    rad
  double shift;   ///< x_E
};

/// One reading, as a number that is defined for every gear.
struct Observation {
  enum class Kind { span, balls, lead, helix, tip, root, distance };
  Kind kind;
  double tool;   ///< k, D_M, z of the mating gear
  double value;  ///< mm; for a lead its reciprocal sin β/(π z m_n), 1/mm; for a helix angle rad
  double sigma;  ///< standard deviation of the reading, in the same unit
  /// False for rough readings, which depend on wear, on the rack or on the mating gear.
  bool exact() const { return kind <= Kind::helix; }
};

std::vector<Observation> observations(const IdentifyProblem& problem);

/// The predicted reading; none if the tool does not touch the flanks.
///
/// Formula   [T10.2], [T10.6], [T10.8]; lead π z m_n/sin β
std::optional<double> reading_of(const GearNumbers& gear, const Observation& o);

/// (reading − predicted reading)/σ [T10.24]. For a rough reading, σ includes the scatter in modules that
/// is due to wear and different racks.
std::optional<double> residual(const GearNumbers& gear, const Observation& o);

}  // namespace gearwright::detail
