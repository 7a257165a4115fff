#include "gearwright/rating/sizing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gearwright {

namespace {

constexpr double kDecades = 1e6;      // greatest factor between input torque and found torque
constexpr double kSameTorque = 1e-9;  // relative accuracy of the torque
constexpr double kSameFace = 1e-7;    // relative accuracy of the face width

bool safe(const RatedPair& pair, const RatingInput& input, const Safeties& wanted) {
  const auto r = rate(pair, input);
  return r && holds(*r, wanted);
}

// Returns the least of the four safety factors, each relative to its required value.
double share_of_wanted(const Rating& r, const Safeties& wanted) {
  double share = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 2; ++i) {
    if (wanted.flank > 0.0) share = std::min(share, r.S_H[i].value / wanted.flank);
    if (wanted.root > 0.0) share = std::min(share, r.S_F[i].value / wanted.root);
  }
  return share;
}

}  // namespace

bool holds(const Rating& rating, const Safeties& wanted) {
  for (std::size_t i = 0; i < 2; ++i)
    if (rating.S_H[i].value < wanted.flank || rating.S_F[i].value < wanted.root) return false;
  return true;
}

std::optional<double> torque_of_safety(const RatedPair& pair, const RatingInput& input,
                                       const Safeties& wanted) {
  RatingInput in = input;
  const auto holds_at = [&](double torque) {
    in.torque = torque;
    return safe(pair, in, wanted);
  };
  double lo = input.torque, hi = input.torque;
  while (!holds_at(lo)) {
    hi = lo;
    lo /= 2;
    if (lo < input.torque / kDecades) return std::nullopt;
  }
  while (hi == lo || holds_at(hi)) {
    lo = hi;
    hi *= 2;
    if (hi > input.torque * kDecades) return std::nullopt;
  }
  while (hi - lo > kSameTorque * hi) {
    const double middle = (lo + hi) / 2;
    (holds_at(middle) ? lo : hi) = middle;
  }
  return lo;
}

RatedPair with_face_width(RatedPair pair, double face_width) {
  pair.face_width = face_width;
  for (RatedGear& g : pair.gears) g.face_width = face_width;
  pair.epsilon_beta = face_width * std::sin(pair.beta) / (std::numbers::pi * pair.normal_module);
  return pair;
}

std::optional<double> face_width_of_safety(const RatedPair& pair, const RatingInput& input,
                                           const Safeties& wanted, double most) {
  const auto holds_at = [&](double b) { return safe(with_face_width(pair, b), input, wanted); };
  // In general, safety factors increase with the width. They drop where a tolerance reaches its
  // next step, so the sufficient widths may form several ranges. If a safety factor at the width b
  // is s < 1 times its required value, every greater sufficient width is at least b s^(−1/kPower),
  // and the search continues at this width. It misses sufficient widths only within a single step
  // of kLeastStep. Safety factors grow at most like b⁴: like b because of the load, and like b³
  // because of overlap and load factors.
  constexpr double kPower = 4.0;
  constexpr double kLeastStep = 1e-4;  // relative; narrower ranges of widths may be missed
  constexpr double kBlind = 1.001;     // relative step if there is no rating at this width
  double lo = std::min(most, pair.normal_module);
  double hi = lo;
  for (;;) {
    const auto rated = rate(with_face_width(pair, hi), input);
    if (rated && holds(*rated, wanted)) break;
    if (hi >= most) return std::nullopt;
    const double growth = rated ? std::pow(share_of_wanted(*rated, wanted), -1 / kPower) : kBlind;
    lo = hi;
    hi = std::min(most, lo * std::max(growth, 1 + kLeastStep));
  }
  while (hi - lo > kSameFace * hi) {
    const double middle = (lo + hi) / 2;
    (holds_at(middle) ? hi : lo) = middle;
  }
  return hi;
}

std::optional<std::string> steel_of_safety(const RatedPair& pair, const RatingInput& input,
                                           const Safeties& wanted) {
  // A steel is no alternative to a plastic.
  if (input.edition == RatingEdition::vdi_2736) return std::nullopt;
  const auto rated = rate(pair, input);
  if (!rated) return std::nullopt;
  for (const std::string_view name : kSteelsByStrength) {
    RatingInput in = input;
    for (std::size_t i = 0; i < 2; ++i) {
      const bool short_of = rated->S_H[i].value < wanted.flank || rated->S_F[i].value < wanted.root;
      if (short_of) in.materials[i] = *material_named(name);
    }
    if (safe(pair, in, wanted)) return std::string(name);
  }
  return std::nullopt;
}

}  // namespace gearwright
