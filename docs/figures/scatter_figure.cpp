// Page 14: positions of a bore in its circle of tolerance, at random and by a scrambled Sobol
// sequence.
#include "docs/figures/figure.hpp"
#include "gearwright/math/sobol.hpp"
#include "gearwright/scatter/distribution.hpp"

namespace gearwright::figures {

Drawing scatter_figure() {
  Drawing f("14-scatter", 860, 470, "Samples of a tolerance",
            "256 positions of a bore in its circle of tolerance, at random and by scrambled Sobol "
            "points. The Sobol points are evenly distributed.");
  constexpr std::uint32_t kPoints = 256;
  const SobolPoints sobol(2);
  const auto draw = [&](double x, bool random, const char* words) {
    const Viewport view{2 * x, 420, {0, 0}, 180};
    f.circle(view, Vec2::Zero(), 1.0, "ink");
    for (std::uint32_t n = 0; n < kPoints; ++n) {
      const auto u = [&](int j) {
        const std::uint64_t key = scramble_key(1, 0, j);
        return random ? random_unit(key, n) : unit_interval(owen_scrambled(sobol.bits(n, j), key));
      };
      const auto [a, b] = in_disc(1.0, u(0), u(1));
      f.dot(view, {a, b}, random ? "g1" : "g2", 2.5);
    }
    f.label({x, 440}, words, Anchor::middle);
  };
  draw(220, true, "256 random points");
  draw(640, false, "256 scrambled Sobol points");
  return f;
}

}  // namespace gearwright::figures
