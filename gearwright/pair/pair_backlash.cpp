#include "gearwright/pair/pair_backlash.hpp"

#include <cmath>

namespace gearwright {

namespace {

std::optional<std::array<Angle, 2>> free_play_of(const Pair& pair) {
  const auto& play = pair.mounted().free_play;
  if (!play) return std::nullopt;
  return std::array{std::abs(pair.gear_ratio()) * *play, *play};
}

}  // namespace

std::optional<PairBacklash> backlash_of(const Pair& pair) {
  if (pair.involute()) {
    const Backlash<double>& b = pair.involute()->mesh.backlash;
    return PairBacklash{b.normal_base,
                        b.normal,
                        b.circumferential,
                        {Angle::radians(b.rotation[0]), Angle::radians(b.rotation[1])},
                        free_play_of(pair)};
  }
  const ArcPair& p = *pair.arcs();
  if (!p.backlash_rotation) return std::nullopt;
  const auto& j = *p.backlash_rotation;
  const auto d_w = p.working_pitch_diameter();
  return PairBacklash{p.backlash_normal,
                      p.backlash_normal / std::cos(p.first_contact().at.theta.rad()),
                      {j[0].rad() * d_w[0] / 2, j[1].rad() * d_w[1] / 2},
                      j,
                      free_play_of(pair)};
}

}  // namespace gearwright
