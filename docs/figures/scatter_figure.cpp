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
  const auto draw = [&](double x, bool random, const char* id, const char* words) {
    Figure disc = plane_figure(id, words, words, window({0, -0.1}, {400, 460}, 180));
    disc.circle(Vec2::Zero(), 1.0, "one", -1);
    for (std::uint32_t n = 0; n < kPoints; ++n) {
      const auto u = [&](int j) {
        const std::uint64_t key = scramble_key(1, 0, j);
        return random ? random_unit(key, n) : unit_interval(owen_scrambled(sobol.bits(n, j), key));
      };
      const auto [a, b] = in_disc(1.0, u(0), u(1));
      disc.dot({a, b}, 2.5, random ? "mark g1" : "mark g2");
    }
    disc.text({0, -kInfinity}, words, Anchor::middle, "", {0, -16});
    f.add(disc, {x, 5}, 400);
  };
  draw(20, true, "random", "256 random points");
  draw(440, false, "sobol", "256 scrambled Sobol points");
  return f;
}

}  // namespace gearwright::figures
