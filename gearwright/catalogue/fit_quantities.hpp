// The quantities of inverse design. A result contains them under `fit`.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/design/fit.hpp"

namespace gearwright {

struct BranchView {
  FitBranch branch;
  Value spec;                                        ///< the whole spec of this branch
  std::optional<double> transverse_contact_ratio{};  ///< only for a design with few teeth
  std::optional<std::string> refused{};              ///< reason why the verb `pair` rejects `spec`
};

struct FitView {
  const Fit* fit;
  std::vector<BranchView> branches;
};

const Quantities<FitView>& fit_quantities();

}  // namespace gearwright
