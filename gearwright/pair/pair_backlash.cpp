#include "gearwright/pair/pair_backlash.hpp"

#include <cmath>

namespace gearwright {

namespace {

std::optional<std::array<Angle, 2>> free_play_of(const MountedGears& pair) {
  if (!pair.free_play) return std::nullopt;
  return std::array{std::abs(pair.gear_ratio()) * *pair.free_play, *pair.free_play};
}

std::optional<PairBacklash> backlash_between(const InvolutePair& p) {
  const Backlash<double>& b = p.mesh.backlash;
  return PairBacklash{b.normal_base,
                      b.normal,
                      b.circumferential,
                      {Angle::radians(b.rotation[0]), Angle::radians(b.rotation[1])},
                      free_play_of(p)};
}

std::optional<PairBacklash> backlash_between(const ArcPair& p) {
  if (!p.backlash_rotation) return std::nullopt;
  const auto& j = *p.backlash_rotation;
  const auto d_w = p.working_pitch_diameter();
  return PairBacklash{p.backlash_normal,
                      p.backlash_normal / std::cos(p.first_contact().at.theta.rad()),
                      {j[0].rad() * d_w[0] / 2, j[1].rad() * d_w[1] / 2},
                      j,
                      free_play_of(p)};
}

}  // namespace

std::optional<PairBacklash> backlash_of(const Pair& pair) {
  return pair.visit([](const auto& p) { return backlash_between(p); });
}

}  // namespace gearwright
