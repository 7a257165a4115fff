#include "gearwright/arrange/backlash_thinning.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "gearwright/gear/gear_field.hpp"
#include "gearwright/pair/pair_backlash.hpp"

namespace gearwright {

namespace {

constexpr double kNear = 1e-12;  // mm or degrees; within this tolerance, the printed backlash
                                 // equals the requested one
constexpr double kSame = 1e-9;   // if the final difference is larger, no tooth thickness gives this
                                 // backlash
constexpr int kMostSteps = 12;   // greatest number of secant steps; involute teeth need one step

struct Wanted {
  const char* field;
  double value;  // mm or degrees
};

Wanted wanted_of(const PairInput& p) {
  if (p.backlash) return {"pair.backlash", *p.backlash};
  if (p.backlash_circumferential)
    return {"pair.backlash_circumferential", *p.backlash_circumferential};
  return {"pair.backlash_angle", p.backlash_angle->deg()};
}

// Splits the total thinning, mm in the normal section, between the two gears.
void thin(GivenPair& given, double thinning) {
  const double share = given.pair.backlash_split;
  const std::array<double, 2> shares{share, 1.0 - share};
  for (std::size_t i = 0; i < 2; ++i)
    given.gears[i]->cylindrical.thickness_allowance = thinning == 0.0 ? 0.0 : -shares[i] * thinning;
}

// The backlash of the pair if its teeth are thinned by `thinning` mm in total. Fillets and tips
// have no influence on the backlash.
Result<double> backlash_at(GivenPair given, const std::optional<PairPlace>& place,
                           double thinning) {
  thin(given, thinning);
  std::vector<Gear> gears;
  for (auto& gear : given.gears) {
    gear->cylindrical.root_fillet.reset();
    gear->cylindrical.tip_fillet.reset();
    auto made = make_gear(gear->cylindrical);
    if (!made) return of_gear(static_cast<int>(gears.size()) + 1, made.error());
    gears.push_back(std::move(made).take());
  }
  const PairSpec at{place ? place->center_distance : given.pair.center_distance,
                    place ? place->shaft_angle : std::nullopt};
  const auto pair = mount(gears[0], gears[1], at);
  if (!pair) return pair.error();
  const auto backlash = backlash_of(*pair);
  if (!backlash) return Error{"pair", "", "has no contact, so its backlash cannot be set"};
  if (given.pair.backlash) return backlash->normal;
  return given.pair.backlash_circumferential ? backlash->circumferential[0]
                                             : backlash->rotation[0].deg();
}

}  // namespace

std::optional<Error> thin_for_backlash(GivenPair& given, const std::optional<PairPlace>& place,
                                       std::vector<Warning>& warnings) {
  GW_EXPECTS(given.pair.wants_backlash() && given.gears[0] && given.gears[1]);
  const Wanted wanted = wanted_of(given.pair);
  const auto asked = [&](const Error& error) {
    return following_from(wanted.field, format_number(wanted.value), "this value requires", error);
  };
  double before = 0.0;
  auto at_before = backlash_at(given, place, before);
  if (!at_before) return at_before.error();
  double off_before = *at_before - wanted.value;
  double now = 0.05 * given.gears[0]->cylindrical.normal_module;
  for (int step = 0; step < kMostSteps; ++step) {
    const auto at_now = backlash_at(given, place, now);
    if (!at_now) return asked(at_now.error());
    const double off = *at_now - wanted.value;
    const double slope = (off - off_before) / (now - before);
    if (std::abs(off) <= kNear * std::max(1.0, wanted.value) || !(slope > 0.0)) break;
    before = now;
    off_before = off;
    now -= off / slope;
  }
  thin(given, now);
  const auto made = backlash_at(given, place, now);
  if (!made || std::abs(*made - wanted.value) > kSame * std::max(1.0, wanted.value))
    return refused(wanted.field, wanted.value,
                   "no tooth thickness of these gears gives this backlash");
  if (now < -kSame) {
    warnings.push_back(
        {WarningCode::thickened_for_backlash,
         fmt::format("The centre distance leaves more backlash than `{}` = {}. The teeth are "
                     "therefore made thicker than their profile shifts require, by {} mm in total.",
                     wanted.field, format_number(wanted.value), format_number(-now)),
         0});
  }
  return std::nullopt;
}

}  // namespace gearwright
