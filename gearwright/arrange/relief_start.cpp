#include "gearwright/arrange/relief_start.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "gearwright/gear/gear_field.hpp"

namespace gearwright {

namespace {

// Calls f(gear, at_tip, relief, field) for each relief without a start, until f returns a value.
template <class Given, class F>
auto first_without_start(Given& given, const F& f) {
  using Answer = decltype(f(1, true, given.gear(1).modifications[0].tip_relief, std::string()));
  for (const int which : {1, 2}) {
    if (!given.has(which)) continue;
    for (auto& flank : given.gear(which).modifications) {
      for (const bool tip : {true, false}) {
        auto& relief = tip ? flank.tip_relief : flank.root_relief;
        if (relief.reach || relief.amount == 0.0) continue;
        const char* const name = tip ? "tip_relief" : "root_relief";
        if (auto answer = f(which, tip, relief,
                            gear_field(which, fmt::format("modifications.{}.reach", name))))
          return answer;
      }
    }
  }
  return Answer{};
}

}  // namespace

bool lacks_relief_start(const GivenPair& given) {
  return first_without_start(given,
                             [](int, bool, const Relief&, const std::string&) { return true; });
}

Error missing_relief_start(const GivenPair& given) {
  return *first_without_start(given, [](int, bool, const Relief&, const std::string& field) {
    return std::optional(absent_input(
        field,
        "; give it, because its default follows from the contact ratio with a second gear, which "
        "is absent or a rack"));
  });
}

std::optional<ReliefStarts> relief_starts(const InvolutePair& pair, int which, ReliefLength of) {
  const Mesh<double>& mesh = pair.mesh;
  if (mesh.crossed || !(mesh.true_ratio > 1.0)) return std::nullopt;
  const bool is_long = of == ReliefLength::long_relief;
  if (is_long && !(mesh.true_ratio < 2.0)) return std::nullopt;
  const double beyond = mesh.rho1_true_end - mesh.rho1_true_begin - mesh.step;
  const double length = is_long ? beyond : beyond / 2;
  // The tip of gear 1 is in contact at the end of the path of contact, and the tip of gear 2 at its
  // start.
  const double near_end = mesh.rho1_true_end - length;
  const double near_begin = mesh.rho1_true_begin + length;
  const auto i = static_cast<std::size_t>(which - 1);
  const double base_radius = pair.input.gears[i].radius;
  const auto diameter = [&](double rho1) {
    return 2 * std::hypot(base_radius, which == 1 ? rho1 : mesh.rho2(rho1));
  };
  return which == 1 ? ReliefStarts{diameter(near_end), diameter(near_begin)}
                    : ReliefStarts{diameter(near_begin), diameter(near_end)};
}

std::optional<Error> place_reliefs(GivenPair& given, const Pair& pair) {
  const auto place = [&](int which, bool tip, Relief& relief,
                         const std::string& field) -> std::optional<Error> {
    const InvolutePair* const involutes = pair.involute();
    const auto starts = involutes ? relief_starts(*involutes, which) : std::nullopt;
    if (!starts) {
      return absent_input(field,
                          "; give it, because its default requires involute gears on parallel axes "
                          "with a transverse contact ratio above 1");
    }
    relief.reach = tip ? starts->tip : starts->root;
    return std::nullopt;
  };
  return first_without_start(given, place);
}

}  // namespace gearwright
