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

// Safety factors of both gears.
using GearSafeties = std::array<Safeties, 2>;

bool holds(const GearSafeties& found, const Safeties& wanted) {
  return holds(found[0], wanted) && holds(found[1], wanted);
}

GearSafeties safeties_of(const Rating& r) {
  return {{{r.S_H[0].value, r.S_F[0].value}, {r.S_H[1].value, r.S_F[1].value}}};
}

// Returns the safety factors under the spectrum or, if it is empty, under the load of the input.
// Returns none if the pair cannot be rated.
std::optional<GearSafeties> safeties(const RatedPair& pair, const RatingInput& input,
                                     const std::vector<LoadBin>& spectrum) {
  if (spectrum.empty()) {
    const auto r = rate(pair, input);
    return r ? std::optional(safeties_of(*r)) : std::nullopt;
  }
  const auto r = rate_spectrum(pair, input, spectrum);
  if (!r) return std::nullopt;
  return GearSafeties{{{r->S_H[0], r->S_F[0]}, {r->S_H[1], r->S_F[1]}}};
}

bool safe(const RatedPair& pair, const RatingInput& input, const Safeties& wanted,
          const std::vector<LoadBin>& spectrum) {
  const auto found = safeties(pair, input, spectrum);
  return found && holds(*found, wanted);
}

// Returns the least of the four safety factors, each relative to its required value.
double share_of_wanted(const GearSafeties& found, const Safeties& wanted) {
  double share = std::numeric_limits<double>::infinity();
  for (const Safeties& s : found) {
    if (wanted.flank > 0.0) share = std::min(share, s.flank / wanted.flank);
    if (wanted.root > 0.0) share = std::min(share, s.root / wanted.root);
  }
  return share;
}

}  // namespace

bool holds(const Safeties& found, const Safeties& wanted) {
  return found.flank >= wanted.flank && found.root >= wanted.root;
}

bool holds(const Rating& rating, const Safeties& wanted) {
  return holds(safeties_of(rating), wanted);
}

std::optional<double> torque_of_safety(const RatedPair& pair, const RatingInput& input,
                                       const Safeties& wanted,
                                       const std::vector<LoadBin>& spectrum) {
  double given = input.torque;
  if (!spectrum.empty()) {
    given = 0.0;
    for (const LoadBin& step : spectrum) given = std::max(given, step.torque);
  }
  RatingInput in = input;
  std::vector<LoadBin> steps = spectrum;
  const auto holds_at = [&](double torque) {
    in.torque = torque;
    for (std::size_t i = 0; i < steps.size(); ++i)
      steps[i].torque = spectrum[i].torque * (torque / given);
    return safe(pair, in, wanted, steps);
  };
  double lo = given, hi = given;
  while (!holds_at(lo)) {
    hi = lo;
    lo /= 2;
    if (lo < given / kDecades) return std::nullopt;
  }
  while (hi == lo || holds_at(hi)) {
    lo = hi;
    hi *= 2;
    if (hi > given * kDecades) return std::nullopt;
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
                                           const Safeties& wanted, double most,
                                           const std::vector<LoadBin>& spectrum) {
  const auto holds_at = [&](double b) {
    return safe(with_face_width(pair, b), input, wanted, spectrum);
  };
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
    const auto found = safeties(with_face_width(pair, hi), input, spectrum);
    if (found && holds(*found, wanted)) break;
    if (hi >= most) return std::nullopt;
    const double growth = found ? std::pow(share_of_wanted(*found, wanted), -1 / kPower) : kBlind;
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
                                           const Safeties& wanted,
                                           const std::vector<LoadBin>& spectrum) {
  // A steel is no alternative to a plastic.
  if (input.edition == RatingEdition::vdi_2736) return std::nullopt;
  const auto found = safeties(pair, input, spectrum);
  if (!found) return std::nullopt;
  for (const std::string_view name : kSteelsByStrength) {
    RatingInput in = input;
    for (std::size_t i = 0; i < 2; ++i) {
      if (!holds((*found)[i], wanted)) in.materials[i] = *material_named(name);
    }
    if (safe(pair, in, wanted, spectrum)) return std::string(name);
  }
  return std::nullopt;
}

}  // namespace gearwright
