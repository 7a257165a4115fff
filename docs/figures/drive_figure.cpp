// Page 13: a planetary set with planets at unequal pitch, each at an angle where it meshes with
// both gears. All such angles of a turn are marked on the circle of the carrier.
#include <array>
#include <cmath>
#include <numbers>

#include "docs/figures/figure.hpp"
#include "gearwright/drive/short_forms.hpp"

namespace gearwright::figures {

Drawing drive_figure() {
  Drawing f("13-drives", 860, 560, "A planetary set and the places of its planets",
            "A sun with 20, planets with 19 and a ring with 58 teeth. A planet meshes with both "
            "gears at 78 places per turn. Four planets are at the places nearest to equal pitch.");
  PlanetarySpec set;
  set.z(SetMember::sun) = 20;
  set.z(SetMember::planet) = 19;
  set.z(SetMember::ring) = 58;
  set.planets = 4;
  set.normal_module = 1.0;
  const auto graph = graph_of(set);
  const auto drive = make_drive({*graph, {}});
  const auto gear = [&](std::size_t g) -> const Gear& { return *drive->geometry.gears[g]; };
  const Assembly& assembly = drive->sets.front().assembly;
  const double a = *drive->geometry.distance.front();
  constexpr double kTolerance = 0.01, pi = std::numbers::pi;

  const Viewport view{560, 560, {0, 0}, 8.8};
  f.line(view, teeth(gear(2), 0, 57, pi / 58, kTolerance), "g2");
  f.shape(view, teeth(gear(0), 0, 19, 0, kTolerance), "g1 body1");
  f.circle(view, Vec2::Zero(), a, "soft dash");
  for (long long n = 0; n < assembly.places; ++n) {
    const double angle = 2 * pi * static_cast<double>(n) / static_cast<double>(assembly.places);
    f.line(view, {polar(a - 0.5, angle), polar(a + 0.5, angle)}, "ink");
  }
  for (std::size_t i = 0; i < assembly.turns.size(); ++i) {
    // A planet that rolls on the sun has turned by θ (1 + z_s/z_p) when the carrier is at θ.
    const double theta = 2 * pi * assembly.turns[i].value();
    const double turned = pi + pi / 19 + theta * (1 + 20.0 / 19);
    f.line(view, placed(teeth(gear(1), 0, 18, 0, kTolerance), turned, polar(a, theta)), "green");
    f.dot(view, polar(a, theta), "green");
  }
  const std::array<const char*, 5> words{
      "{z_s} = 20, {z_p} = 19, {z_r} = −58", "N* = 78 places per turn, marked by ticks",
      "four planets as near to 90° as possible:", "0°, 92.308°, 180°, 272.308°",
      "180° apart in pairs, so the forces cancel"};
  double y = 60;
  for (const char* line : words) f.label({560, y += 26}, line);
  return f;
}

}  // namespace gearwright::figures
