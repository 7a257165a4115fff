#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>

#include "gearwright/inspection/chordal_thickness.hpp"
#include "tests/accuracy/ledger.hpp"

namespace gearwright::ledger {

// Chord and height from the same formulas in double and in 50 digits, for teeth of every size up to
// θ_t = 1.2. Greater teeth are omitted: at θ_t = π/2 and ψ = 45°, the solution is a triple root, so
// Δh is arbitrarily ill-conditioned, and no calliper fits such a tooth.
std::vector<Row> chord_rows() {
  constexpr int kInputs = 4000;
  const std::string where = fmt::format("ψ 0…80°, θ_t 1e-4…1.2, {} inputs", kInputs);
  Row chord{"chord.chord", where, "relative", 2e-15, 0.0, ""};
  Row height{"chord.height", where, "relative", 4e-15, 0.0, ""};
  Row angle{"chord.caliper_angle", where, "relative", 2e-15, 0.0, ""};
  std::mt19937_64 random(20250301);
  const auto uniform = [&](double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(random() >> 11) * 0x1p-53);
  };
  for (int i = 0; i < kInputs; ++i) {
    const double psi = i % 20 == 0 ? 0.0 : uniform(0.0, 80.0) * std::numbers::pi / 180;
    const double theta = std::exp(uniform(std::log(1e-4), std::log(1.2)));
    const double r = uniform(1.0, 1000.0);
    const auto got = shortest_chord(ToothArc<double>{theta, psi, r, r});
    const auto exact =
        shortest_chord(ToothArc<Exact>{Exact(theta), Exact(psi), Exact(r), Exact(r)});
    const std::string w =
        fmt::format("ψ {:.4f}°, θ_t {:.6g}, r {:.6g}", psi * 180 / std::numbers::pi, theta, r);
    chord.see(relative_error(got.chord, exact.chord), w);
    height.see(relative_error(got.height, exact.height), w);
    angle.see(relative_error(got.caliper_angle, exact.caliper_angle), w);
  }
  return {chord, height, angle};
}

}  // namespace gearwright::ledger
