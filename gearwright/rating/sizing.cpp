#include "gearwright/rating/sizing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gearwright {

namespace {

constexpr double kDecades = 1e6;      // of the input's torque, to either side
constexpr double kSameTorque = 1e-9;  // relative
constexpr double kSameFace = 0.01;    // mm

bool safe(const RatedPair& pair, const RatingInput& input, const WantedSafety& wanted) {
  const auto r = rate(pair, input);
  return r && holds(*r, wanted);
}

}  // namespace

bool holds(const Rating& rating, const WantedSafety& wanted) {
  for (std::size_t i = 0; i < 2; ++i)
    if (rating.S_H[i].value < wanted.flank || rating.S_F[i].value < wanted.root) return false;
  return true;
}

std::optional<double> torque_of_safety(const RatedPair& pair, const RatingInput& input,
                                       const WantedSafety& wanted) {
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
                                           const WantedSafety& wanted, double most) {
  const auto holds_at = [&](double b) { return safe(with_face_width(pair, b), input, wanted); };
  // Upward in small steps: tolerances grow with the face in steps of their own, so the least width
  // may lie below a gap.
  constexpr double kGrowth = 1.05;
  double lo = std::min(most, pair.normal_module);
  if (holds_at(lo)) return lo;
  double hi = lo;
  do {
    lo = hi;
    if (lo >= most) return std::nullopt;
    hi = std::min(most, lo * kGrowth);
  } while (!holds_at(hi));
  while (hi - lo > kSameFace) {
    const double middle = (lo + hi) / 2;
    (holds_at(middle) ? hi : lo) = middle;
  }
  return hi;
}

std::optional<std::string> steel_of_safety(const RatedPair& pair, const RatingInput& input,
                                           const WantedSafety& wanted) {
  if (input.edition == RatingEdition::vdi_2736) return std::nullopt;  // steel for a plastic
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
