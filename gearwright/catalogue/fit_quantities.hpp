// The quantities of the verbs `fit` and `identify`. Both verbs complete a spec whose gears are not
// fully described. A result of `fit` contains its quantities under `fit`.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/design/fit.hpp"
#include "gearwright/inspection/identify.hpp"

namespace gearwright {

struct BranchView {
  FitBranch branch;
  Value spec;                                        ///< the whole spec with the values of this
                                                     ///< solution
  std::optional<double> transverse_contact_ratio{};  ///< only for a design with few teeth
  /// The reason why the verb `pair` rejects `spec`; none if `pair` accepts it. Teeth may be
  /// impossible to make even if a correct mesh of the two gears would exist.
  std::optional<std::string> refused{};
};
const Quantities<BranchView>& branch_quantities();

struct FitView {
  Fit fit;
  std::vector<BranchView> branches{};
};
const Quantities<FitView>& fit_quantities();

// The quantities of `identify`: the gears that agree with the readings of an unknown gear.

struct CandidateView : IdentifiedGear {
  Value spec{};  ///< the whole spec with the data of this gear; none for an alternative
};
const Quantities<CandidateView>& candidate_quantities();

struct IdentifyView {
  Identification found;
  std::vector<CandidateView> candidates{};
};
const Quantities<IdentifyView>& identify_quantities();

}  // namespace gearwright
