// Fits the unknowns of one hypothesis by least squares: the profile shift, and also helix angle and
// module if they are free.
//
// Internal to inspection/. The evidence is Laplace's approximation: the likelihood of the best fit
// times the fraction of the prior volume that agrees with the readings.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/inspection/identify_model.hpp"

namespace gearwright::detail {

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
/// Fits the unknowns by the Gauss–Newton method from `start`, and computes the evidence [T10.25]. None if
/// a tool does not touch the flanks, or if the readings do not determine the unknowns.
std::optional<RackFit> fit_rack(const GearNumbers& start, const Unknowns& unknowns,
                                const std::vector<Observation>& readings);

}  // namespace gearwright::detail
