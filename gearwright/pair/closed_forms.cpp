#include "gearwright/pair/closed_forms.hpp"

#include <cstdint>
#include <cstring>
#include <numbers>

#include "gearwright/pair/leaf_formulas.hpp"

namespace gearwright {

namespace {

constexpr double kHalfTurn = std::numbers::pi;

using namespace leaf;

// Divides the bits of x by three. The function uses the same shifts as closed_forms_simd.cpp, which
// needs them because vector instructions have no integer division.
double third_of_bits(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  std::uint64_t third = (bits >> 2) + (bits >> 4);
  third += third >> 4;
  third += third >> 8;
  third += third >> 16;
  std::memcpy(&x, &third, sizeof x);
  return x;
}

#define GW_LEAF_INLINE inline
#include "gearwright/pair/closed_forms.inc"
#undef GW_LEAF_INLINE

}  // namespace

void inverse_involutes_scalar(const double* y, double* alpha, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) alpha[i] = inverse_involute_of(y[i]);
}

void normal_backlashes_scalar(const BacklashConstants& constants, const BacklashColumns& columns,
                              double* backlash, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    std::array<double, BacklashColumns::kIn> row{};
    for (std::size_t k = 0; k < row.size(); ++k) row[k] = columns.in[k][i];
    backlash[i] = normal_backlash_of(constants, row);
  }
}

}  // namespace gearwright
