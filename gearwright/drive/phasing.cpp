#include "gearwright/drive/phasing.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

/// If a fraction differs from 0 or 1 by less than this, the difference is a rounding error.
constexpr double kNothing = 1e-12;

// Returns |Σ e^{2πit}|/N for N angles t in turns. Whole turns are removed from the exact fractions
// first, and a result that differs from 0 only by rounding is set to 0.
double share_left(const std::vector<Rational>& turns) {
  std::complex<double> sum = 0.0;
  for (const Rational& t : turns) sum += std::polar(1.0, 2 * std::numbers::pi * t.frac().value());
  const double share = std::abs(sum) / static_cast<double>(turns.size());
  return share < kNothing ? 0.0 : share;
}

bool is_one(double share) { return std::abs(share - 1.0) < kNothing; }

PhasingClass class_of(const Resultant& first) {
  if (is_one(first.torque)) return PhasingClass::in_phase;
  if (first.torque != 0.0) return PhasingClass::mixed;
  if (is_one(first.force_forward) || is_one(first.force_backward)) return PhasingClass::sequential;
  return first.force_forward == 0.0 && first.force_backward == 0.0 ? PhasingClass::counter
                                                                   : PhasingClass::mixed;
}

}  // namespace

std::vector<Rational> mesh_phases(int teeth, const std::vector<Rational>& turns) {
  std::vector<Rational> phases;
  for (const Rational& u : turns) phases.push_back((Rational(teeth) * u).frac());
  return phases;
}

Phasing phasing(const std::vector<Rational>& phases, const std::vector<Rational>& turns,
                int harmonics) {
  GW_EXPECTS(!phases.empty() && phases.size() == turns.size() && harmonics >= 1);
  Phasing made;
  for (int k = 1; k <= harmonics; ++k) {
    std::vector<Rational> torque, forward, backward;
    for (std::size_t i = 0; i < phases.size(); ++i) {
      torque.push_back(-(Rational(k) * phases[i]));
      forward.push_back(torque.back() + turns[i]);
      backward.push_back(torque.back() - turns[i]);
    }
    made.resultants.push_back({share_left(torque), share_left(forward), share_left(backward)});
  }
  made.kind = class_of(made.resultants.front());
  return made;
}

double sun_ring_phase(int planet_teeth, double share_1, double share_2, bool sun_drives) {
  const double flanks = (share_1 + share_2) / 2;
  const double phase = (planet_teeth % 2 == 0 ? 0.0 : 0.5) + (sun_drives ? -flanks : flanks);
  const double frac = phase - std::floor(phase);
  // A phase just below 1 is a rounding error of 1 and is set to 0.
  return frac > 1.0 - kNothing ? 0.0 : frac;
}

}  // namespace gearwright
