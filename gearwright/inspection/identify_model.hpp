// Predicts the readings that a gear gives with the tools that were used on the unknown gear.
//
// Internal to inspection/. identify() calls these functions about ten thousand times, so they use
// closed forms and do not make the gear.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/inspection/identify.hpp"

namespace gearwright::detail {

inline constexpr double kSigmas = 1.96;  ///< standard deviations for 95 %

struct GearNumbers {
  int teeth;      ///< z, signed
  double module;  ///< m_n  mm
  double alpha;   ///< α_n  rad
  double beta;    ///< β    rad
  double shift;   ///< x_E
};

/// One reading, as a number that is defined for every gear.
struct Observation {
  Reading kind;
  double tool;  ///< k, D_M, z of the mating gear
  /// The reading, mm. For a lead, its reciprocal sin β/(π z m_n), 1/mm. For a helix angle, rad.
  double value;
  double sigma;  ///< standard deviation of the reading, in the same unit
  /// False for rough readings, which depend on wear, on the rack or on the mating gear.
  bool exact() const { return kind <= Reading::helix_angle; }
};

std::vector<Observation> observations(const IdentifyProblem& problem);

/// Returns the predicted reading, or none if the tool does not touch the flanks.
///
/// Formula   [T10.2], [T10.6], [T10.8]; lead π z m_n/sin β
std::optional<double> reading_of(const GearNumbers& gear, const Observation& o);

/// Returns (reading − predicted reading)/σ [T10.24]. For a rough reading, σ includes a scatter that
/// is proportional to the module and is caused by wear and by different racks.
std::optional<double> residual(const GearNumbers& gear, const Observation& o);

constexpr double kLength =
    0.02;  ///< mm, usual uncertainty of a measured tip, root or centre distance

// Fits the unknowns of one hypothesis by least squares. The unknowns are the profile shift, and
// also helix angle and module if the hypothesis does not fix them. The evidence of the hypothesis
// is the probability of the readings if the hypothesis is true, times the prior probability of the
// fitted values.

struct Unknowns {
  bool shift = true, helix = false, module = false;
};

struct RackFit {
  GearNumbers gear;
  double misfit;                                  ///< χ² of the exact readings
  double sigma_shift, sigma_helix, sigma_module;  ///< 0 if not fitted
  int free;                                       ///< number of fitted values
  double log_evidence;
};
/// Fits the unknowns by the Gauss–Newton method from `start`, and computes the evidence [T10.25].
/// Returns none if a tool does not touch the flanks, or if the readings do not determine the
/// unknowns.
std::optional<RackFit> fit_rack(const GearNumbers& start, const Unknowns& unknowns,
                                const std::vector<Observation>& readings);

// The standard racks that identify() tries, with their prior probabilities.

struct StandardRack {
  double module;  ///< m_n  mm
  double alpha;   ///< α_n  rad
  ModuleSeries series;
  std::optional<double> diametral_pitch;  ///< 1/in
  double log_prior;                       ///< logarithm of its prior probability
};

/// Modules of ISO 54, extended to smaller modules, and diametral pitches, each with the usual
/// pressure angles.
const std::vector<StandardRack>& standard_racks();
/// Returns the values with which a drawing describes a fitted gear [T10.34]. `shift_uncertainty` is
/// the uncertainty of x_E.
DrawnGear drawn_gear(const IdentifyProblem& problem, const GearNumbers& gear, ModuleSeries series,
                     double shift_uncertainty);

/// The number of readings that may be left out if no gear agrees with all of them.
enum class LeaveOut { none, one };

/// Returns the candidates for a problem whose readings determine the size of the gear. All readings
/// of tip and root are used, and the result has no alternative.
Identification identify_readings(const IdentifyProblem& problem, LeaveOut leave_out);

/// Returns the measurement that separates the likeliest gear from the greatest part of the
/// probability of the other gears [T10.42]. Returns none if there is only one gear, or if no
/// measurement distinguishes the gears.
std::optional<NextMeasurement> next_measurement(const IdentifyProblem& problem,
                                                const std::vector<IdentifiedGear>& candidates);

}  // namespace gearwright::detail
