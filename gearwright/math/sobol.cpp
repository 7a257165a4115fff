#include "gearwright/math/sobol.hpp"

#include <boost/random/sobol.hpp>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

using Table = boost::random::default_sobol_table;
static_assert(SobolPoints::kMaxDimensions == Table::max_dimension);

// Returns the direction numbers v_k = m_k 2^(31 − k), k = 0 … 31. The bits of `polynomial` are the
// coefficients a_0 … a_degree of a primitive polynomial. The first and the last coefficient are 1.
std::array<std::uint32_t, 32> directions(unsigned polynomial, unsigned degree, std::size_t j) {
  std::array<std::uint32_t, 32> m{};
  for (unsigned k = 0; k < 32; ++k) {
    if (k < degree) {
      m[k] = Table::minit(j, k);
      continue;
    }
    m[k] = m[k - degree];
    for (unsigned i = 1; i <= degree; ++i)
      if ((polynomial >> (degree - i)) & 1U) m[k] ^= m[k - i] << i;
  }
  for (unsigned k = 0; k < 32; ++k) m[k] <<= 31 - k;
  return m;
}

}  // namespace

std::uint64_t hash64(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15U;
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31U);
}

SobolPoints::SobolPoints(int dimensions) {
  GW_EXPECTS(dimensions >= 1 && dimensions <= kMaxDimensions);
  directions_.emplace_back();
  for (unsigned k = 0; k < 32; ++k) directions_[0][k] = 1U << (31 - k);
  for (int j = 1; j < dimensions; ++j) {
    const auto row = static_cast<std::size_t>(j - 1);
    const unsigned polynomial = Table::polynomial(row);
    unsigned degree = 0;
    while (polynomial >> (degree + 1)) ++degree;
    directions_.push_back(gearwright::directions(polynomial, degree, row));
  }
}

std::uint32_t SobolPoints::bits(std::uint32_t n, int j) const {
  GW_EXPECTS(j >= 0 && j < dimensions());
  const auto& v = directions_[static_cast<std::size_t>(j)];
  std::uint32_t x = 0;
  std::uint32_t gray = n ^ (n >> 1U);
  for (std::size_t k = 0; gray != 0; ++k, gray >>= 1U)
    if (gray & 1U) x ^= v[k];
  return x;
}

std::uint64_t scramble_key(std::uint64_t seed, int replicate, int j) {
  return hash64(
      seed ^ hash64(static_cast<std::uint64_t>(replicate) ^ hash64(static_cast<std::uint64_t>(j))));
}

std::uint32_t owen_scrambled(std::uint32_t bits, std::uint64_t key) {
  std::uint32_t scrambled = 0;
  for (unsigned k = 0; k < 32; ++k) {
    const std::uint64_t prefix = k == 0 ? 0 : bits >> (32 - k);
    const std::uint64_t node = hash64((std::uint64_t{k} << 32U) + prefix);
    const auto flip = static_cast<std::uint32_t>(hash64(key ^ node) >> 63U);
    scrambled |= (((bits >> (31 - k)) & 1U) ^ flip) << (31 - k);
  }
  return scrambled;
}

double unit_interval(std::uint32_t bits) { return (bits + 0.5) / 4294967296.0; }

double random_unit(std::uint64_t key, std::uint64_t n) {
  // The 52 bits and the ½ fit into the 53 bits of a double, so the result is not rounded to 0 or 1.
  return (static_cast<double>(hash64(key ^ n) >> 12U) + 0.5) * 0x1p-52;
}

}  // namespace gearwright
