#include "gearwright/rating/life.hpp"

#include <array>
#include <cmath>
#include <span>

namespace gearwright {

namespace {

struct Knot {
  double cycles, value;
};

constexpr double kLast = 1e10;

// The life on the lines through the knots, in log-log scale. The last knot is at the reference number.
Life on_lines(std::span<const Knot> knots, std::optional<double> cycles, double at_last,
              const char* formula) {
  const Knot& first = knots.front();
  const Knot& reference = knots.back();
  if (!cycles)
    return {{1.0, formula, "the reference number of cycles, because no life is given"}, 1.0};
  const double n = *cycles;
  if (n <= first.cycles) return {{first.value, formula, "static stress"}, 0.0};
  const auto between = [n](const Knot& a, const Knot& b) {
    const double share = std::log(n / a.cycles) / std::log(b.cycles / a.cycles);
    return a.value * std::pow(b.value / a.value, share);
  };
  if (n >= kLast) return {{at_last, formula, "10¹⁰ cycles and more"}, 1.0};
  if (n >= reference.cycles)
    return {{between(reference, {kLast, at_last}), formula, "long life, up to 10¹⁰ cycles"}, 1.0};
  std::size_t i = 1;
  while (n > knots[i].cycles) ++i;
  return {{between(knots[i - 1], knots[i]), formula, "limited life"},
          std::log(n / first.cycles) / std::log(reference.cycles / first.cycles)};
}

constexpr std::array kPitting{Knot{1e5, 1.6}, Knot{5e7, 1.0}};
constexpr std::array kSomePitting{Knot{6e5, 1.6}, Knot{1e7, 1.3}, Knot{1e9, 1.0}};
constexpr std::array kNitridedFlank{Knot{1e5, 1.3}, Knot{2e6, 1.0}};
constexpr std::array kNitrocarburizedFlank{Knot{1e5, 1.1}, Knot{2e6, 1.0}};

constexpr std::array kTemperedRoot{Knot{1e4, 2.5}, Knot{3e6, 1.0}};
constexpr std::array kHardenedRoot{Knot{1e3, 2.5}, Knot{3e6, 1.0}};
constexpr std::array kNitridedRoot{Knot{1e3, 1.6}, Knot{3e6, 1.0}};
constexpr std::array kNitrocarburizedRoot{Knot{1e3, 1.1}, Knot{3e6, 1.0}};

}  // namespace

Life flank_life(MaterialKind kind, std::optional<double> cycles, const LifeChoice& choice) {
  using K = MaterialKind;
  constexpr const char* formula = "ISO 6336-2, clause 10";
  const auto life = [&](std::span<const Knot> knots) {
    return on_lines(knots, cycles, choice.at_10_10, formula);
  };
  switch (kind) {
    case K::cast:
    case K::nodular_ferritic:
    case K::nitrided: return life(kNitridedFlank);
    case K::nitrocarburized: return life(kNitrocarburizedFlank);
    default: return choice.limited_pitting ? life(kSomePitting) : life(kPitting);
  }
}

Life root_life(MaterialKind kind, std::optional<double> cycles, const LifeChoice& choice) {
  using K = MaterialKind;
  constexpr const char* formula = "ISO 6336-3, clause 12";
  const auto life = [&](std::span<const Knot> knots) {
    return on_lines(knots, cycles, choice.at_10_10, formula);
  };
  switch (kind) {
    case K::case_hardened:
    case K::induction_hardened: return life(kHardenedRoot);
    case K::cast:
    case K::nodular_ferritic:
    case K::nitrided: return life(kNitridedRoot);
    case K::nitrocarburized: return life(kNitrocarburizedRoot);
    default: return life(kTemperedRoot);
  }
}

}  // namespace gearwright
