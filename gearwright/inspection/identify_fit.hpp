// Least squares of one hypothesis: the shift, and the helix and the module where they are any.
//
// Internal to inspection/. Evidence is that of Laplace: the best fit's likelihood times the share of
// what was possible before that the readings leave.
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
  double sigma_shift, sigma_helix, sigma_module;  ///< 0: not fitted
  int free;                                       ///< numbers fitted
  double log_evidence;
};

/// Gauss-Newton from `start`; the evidence is [T10.25]. None: a tool finds no flank there, or the readings do not say the unknowns.
std::optional<RackFit> fit_rack(const GearNumbers& start, const Unknowns& unknowns,
                                const std::vector<Observation>& readings);

}  // namespace gearwright::detail
