// Implements pair/closed_forms.hpp with plain doubles, without Google Highway.
#include "gearwright/pair/closed_forms.hpp"

namespace gearwright {

void inverse_involutes(const double* y, double* alpha, std::size_t n) {
  inverse_involutes_scalar(y, alpha, n);
}
void normal_backlashes(const BacklashConstants& constants, const BacklashColumns& columns,
                       double* backlash, std::size_t n) {
  normal_backlashes_scalar(constants, columns, backlash, n);
}

}  // namespace gearwright
