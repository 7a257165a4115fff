// Points that fill the unit cube evenly: Sobol's sequence with random access, and Owen's scrambling
// by a hash. Any thread can compute any point, and every machine computes the same bits.
//
//   x_n   point n, in the order of the Gray code
//   v_k   direction numbers of a coordinate, 32 bits
//   u     a coordinate of the scrambled point, 0 < u < 1
//                                                     theory: docs/theory/14-scatter.md
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace gearwright {

/// The function splitmix64 of Steele, Lea and Flood, which converts 64 bits to 64 well-mixed bits.
std::uint64_t hash64(std::uint64_t x);

/// Points of Sobol's sequence, with each coordinate as 32 bits. The direction numbers are those of
/// Joe and Kuo (2008, file new-joe-kuo-6), and are taken from the table of Boost.Random.
///
/// Formula   [T14.3], [T14.4]
class SobolPoints {
 public:
  static constexpr int kMaxDimensions = 3667;  ///< size of Boost's table

  /// Domain    1 ≤ dimensions ≤ kMaxDimensions (contract)
  explicit SobolPoints(int dimensions);

  int dimensions() const { return static_cast<int>(directions_.size()); }
  /// Coordinate j of point n.   Domain  0 ≤ j < dimensions() (contract)
  std::uint32_t bits(std::uint32_t n, int j) const;

 private:
  std::vector<std::array<std::uint32_t, 32>> directions_;
};

/// The key with which coordinate j is scrambled. It is a hash of the seed, the replicate and j.
std::uint64_t scramble_key(std::uint64_t seed, int replicate, int j);

/// Owen's nested uniform scrambling of the bits of one coordinate.   Formula [T14.5]
std::uint32_t owen_scrambled(std::uint32_t bits, std::uint64_t key);

/// (bits + ½)/2³², which is neither 0 nor 1.   Formula [T14.6]
double unit_interval(std::uint32_t bits);

/// Value n of a random sequence with this key, which is neither 0 nor 1.   Formula [T14.6]
double random_unit(std::uint64_t key, std::uint64_t n);

}  // namespace gearwright
