// Seeded random numbers that are the same with every compiler and library. The distributions of the
// standard library differ between implementations.
#pragma once

#include <cstdint>
#include <random>

namespace gearwright::testing {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : bits_(seed) {}
  double uniform(double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
  }
  int whole(int lo, int hi) {
    return lo + static_cast<int>(bits_() % static_cast<unsigned>(hi - lo + 1));
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace gearwright::testing
