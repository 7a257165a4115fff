#include "gearwright/pair/pair.hpp"

#include <cmath>

namespace gearwright {

namespace {

template <class Kind>
Result<Pair> either(Result<Kind> made, const PairSpec& spec) {
  if (!made) return made.error();
  Kind pair = std::move(made).take();
  pair.speed_rpm = spec.speed_rpm;
  return Pair(std::move(pair));
}

}  // namespace

const char* to_string(PairKind kind) {
  switch (kind) {
    case PairKind::parallel_external: return "parallel_external";
    case PairKind::parallel_internal: return "parallel_internal";
    case PairKind::crossed: return "crossed";
  }
  return "";
}

// These constructors must not be inlined. Otherwise g++ 12 warns about uninitialised members of the
// other kinds of pair.
[[gnu::noinline]] Pair::Pair(ParallelPair pair) : of_(std::move(pair)) {}
[[gnu::noinline]] Pair::Pair(CrossedPair pair) : of_(std::move(pair)) {}
[[gnu::noinline]] Pair::Pair(ArcPair pair) : of_(std::move(pair)) {}

PairKind Pair::kind() const {
  if (as<CrossedPair>()) return PairKind::crossed;
  return gear(2).internal() ? PairKind::parallel_internal : PairKind::parallel_external;
}

double Pair::contact_ratio() const {
  return visit([](const auto& p) { return p.contact_ratio(); });
}

double Pair::contact_ratio_true() const {
  return visit([](const auto& p) { return p.contact_ratio_true(); });
}

Result<Pair> mount(Gear gear_1, Gear gear_2, const PairSpec& spec) {
  if (!gear_1.involute() || !gear_2.involute()) {
    if (spec.shaft_angle && spec.shaft_angle->rad() != 0.0) {
      return refused("pair.shaft_angle", spec.shaft_angle->deg(),
                     "circular-arc gears run on parallel axes only; leave out this key");
    }
    return either(mount_arcs(std::move(gear_1), std::move(gear_2), spec.center_distance), spec);
  }
  const auto place = involute_place(gear_1, gear_2, spec);
  if (!place) return place.error();
  if (place->shaft_angle)
    return either(mount_crossed(std::move(gear_1), std::move(gear_2), *place, spec.friction), spec);
  return either(mount_parallel(std::move(gear_1), std::move(gear_2), *place, spec.friction), spec);
}

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
  return PairBacklash{p.base_backlash,
                      p.normal_backlash(),
                      {j[0].rad() * d_w[0] / 2, j[1].rad() * d_w[1] / 2},
                      j,
                      free_play_of(p)};
}

}  // namespace

std::optional<PairBacklash> backlash_of(const Pair& pair) {
  return pair.visit([](const auto& p) { return backlash_between(p); });
}

StatedBacklash Pair::stated_backlash() const {
  return visit([](const auto& p) { return p.stated_backlash(); });
}

}  // namespace gearwright
