#include "gearwright/pair/pair.hpp"

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

// These constructors are not inlined, because g++ 12 would warn about uninitialised members of the
// other kinds.
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

double Pair::normal_backlash() const {
  return visit([](const auto& p) { return p.normal_backlash(); });
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

}  // namespace gearwright
