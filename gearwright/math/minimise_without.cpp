// The version for builds without NLopt. These builds have no minimiser.
#include "gearwright/base/contract.hpp"
#include "gearwright/math/minimise.hpp"

namespace gearwright {

bool can_minimise() { return false; }

std::vector<double> minimise(Minimiser, const MinimiserTask&, std::vector<double> start) {
  GW_EXPECTS(can_minimise());
  return start;
}

}  // namespace gearwright
