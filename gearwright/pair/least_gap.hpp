// Searches for the least value of a smooth function between two parameters. A part is skipped if
// its values cannot be less than the least value known so far. Internal to pair/, for one family of
// touches of outline_gap.
//
//   g   gap at the parameter t        H   function that is zero where g is stationary
//
// g is evaluated at even steps. A cell is the interval between two neighbouring samples. The search
// assumes that g lies below the chord of a cell by at most half of the second difference. For
// comparison, a parabola lies below its chord by an eighth of the second difference. If a cell may
// contain a value below the least known value, the cell is halved. If H changes its sign in the
// cell, the cell is divided at H = 0 instead.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace gearwright::detail {

struct GapSample {
  double gap = 0.0;
  double slope = 0.0;  ///< H, zero where g is stationary; only its sign matters
  double noise = 0.0;  ///< rounding error of the gap, rad
};

/// A Sampler has two members. GapSample sample(double t) evaluates the gap and records the least
/// value. double known() returns the limit above which gaps need not be exact.
template <class Sampler>
class LeastGap {
 public:
  LeastGap(Sampler& sampler, double from, double to) : sampler_(sampler) {
    std::array<GapSample, kCells + 1> at;
    const auto t = [&](int i) { return from + (to - from) * i / kCells; };
    for (int i = 0; i <= kCells; ++i) at[index(i)] = ask(t(i));
    std::array<double, kCells + 1> bend{};
    for (int i = 1; i < kCells; ++i)
      bend[index(i)] = std::abs(at[index(i - 1)].gap - 2 * at[index(i)].gap + at[index(i + 1)].gap);
    bend[0] = bend[1];
    bend[index(kCells)] = bend[index(kCells - 1)];
    for (int i = 0; i < kCells; ++i)
      search(t(i), at[index(i)], t(i + 1), at[index(i + 1)],
             std::max(bend[index(i)], bend[index(i + 1)]), 0);
  }

 private:
  static constexpr int kCells = 8;
  static constexpr int kDeepest = 40;           // halvings, after which only rounding error remains
  static constexpr double kResolution = 1e-12;  // rad; smaller improvements are not needed
  static constexpr double kNoises = 8;          // greatest rounding error, in units of the noise
  static constexpr int kMost = 400;  // greatest number of evaluations; a smooth gap needs about 30
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  bool worth(double least) const {
    return asked_ < kMost && least < sampler_.known() - kResolution;
  }
  GapSample ask(double t) {
    ++asked_;
    return sampler_.sample(t);
  }

  void search(double t_1, const GapSample& one, double t_2, const GapSample& two, double bend,
              int depth) {
    const double ends = std::min(one.gap + kNoises * one.noise, two.gap + kNoises * two.noise);
    if (depth >= kDeepest || !worth(ends - 0.5 * bend)) return;
    const bool turns = (one.slope < 0.0) != (two.slope < 0.0);
    const auto [t, middle] = turns ? solved(t_1, one, t_2, two) : halved(t_1, t_2);
    const double inner = bend_of(t_1, one, t, middle, t_2, two);
    GapSample before = middle;
    GapSample after = middle;
    if (turns) {
      before.slope = one.slope;
      after.slope = two.slope;
    }
    search(t_1, one, t, before, inner, depth + 1);
    search(t, after, t_2, two, inner, depth + 1);
  }

  struct Asked {
    double t;
    GapSample sample;
  };
  Asked halved(double t_1, double t_2) {
    const double t = 0.5 * (t_1 + t_2);
    return {t, ask(t)};
  }

  // The second difference, scaled to a point in the middle of the cell.
  static double bend_of(double t_1, const GapSample& one, double t, const GapSample& middle,
                        double t_2, const GapSample& two) {
    const double part = (t - t_1) / (t_2 - t_1);
    const double over = middle.gap - (one.gap + part * (two.gap - one.gap));
    const double weight = 4 * part * (1.0 - part);
    return weight > 0.0 ? 2 * std::abs(over) / weight : 0.0;
  }

  // Solves H = 0 by the Illinois method of false position, with halving if convergence is slow. g
  // is stationary at the solution, so half of the digits of t are sufficient. If H jumps across 0,
  // the search ends at the jump.
  Asked solved(double t_1, const GapSample& one, double t_2, const GapSample& two) {
    constexpr double kEnough = 1e-8;  // relative to the whole cell
    constexpr int kSteps = 60;
    const double width = std::abs(t_2 - t_1);
    double f_1 = one.slope;
    double f_2 = two.slope;
    int stays = 0;
    Asked best{t_1, one};
    for (int i = 0; i < kSteps && std::abs(t_2 - t_1) > kEnough * width; ++i) {
      double t = t_1 - f_1 * (t_2 - t_1) / (f_2 - f_1);
      const double lo = std::min(t_1, t_2);
      const double hi = std::max(t_1, t_2);
      if (!(t > lo && t < hi) || std::abs(stays) > 3) t = 0.5 * (t_1 + t_2);
      best = {t, ask(t)};
      const double f = best.sample.slope;
      if (std::abs(f) < 1e-12 * std::max(std::abs(one.slope), std::abs(two.slope))) break;
      const int way = (f < 0.0) == (f_1 < 0.0) ? 1 : -1;
      const bool again = way * stays > 0;
      if (way > 0) {
        t_1 = t;
        f_1 = f;
        if (again) f_2 *= 0.5;
      } else {
        t_2 = t;
        f_2 = f;
        if (again) f_1 *= 0.5;
      }
      stays = again ? stays + way : way;
    }
    return best;
  }

  Sampler& sampler_;
  int asked_ = 0;
};

}  // namespace gearwright::detail
