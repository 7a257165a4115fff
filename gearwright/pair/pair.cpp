#include "gearwright/pair/pair.hpp"

#include "gearwright/base/overloaded.hpp"

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

// If inlined, g++ 12 warns that members of the other kind are uninitialised.
[[gnu::noinline]] Pair::Pair(InvolutePair pair) : of_(std::move(pair)) {}
[[gnu::noinline]] Pair::Pair(ArcPair pair) : of_(std::move(pair)) {}

double Pair::contact_ratio() const {
  return visit(Overloaded{[](const InvolutePair& p) { return p.contact_ratio(); },
                          [](const ArcPair& p) { return p.contact_ratio; }});
}

Result<Pair> mount(Gear gear_1, Gear gear_2, const PairSpec& spec) {
  if (gear_1.involute() && gear_2.involute())
    return either(mount_involutes(std::move(gear_1), std::move(gear_2), spec), spec);
  if (spec.shaft_angle && spec.shaft_angle->rad() != 0.0) {
    return refused("pair.shaft_angle", spec.shaft_angle->deg(),
                   "circular-arc gears run on parallel axes; leave it out");
  }
  return either(mount_arcs(std::move(gear_1), std::move(gear_2), spec.center_distance), spec);
}

}  // namespace gearwright
