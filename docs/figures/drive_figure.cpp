// Page 13: a planetary set with planets at unequal pitch, each at an angle where it meshes with
// both gears. All such angles of a turn are marked on the circle of the carrier.
#include <array>

#include "docs/figures/figure.hpp"
#include "gearwright/drive/short_forms.hpp"

namespace gearwright::figures {

Drawing drive_figure() {
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

  Figure f = plane_figure("13-drives", "A planetary set and the places of its planets",
                          "A sun with 20, planets with 19 and a ring with 58 teeth. A planet "
                          "meshes with both gears at 78 places per turn. Four planets are at the "
                          "places nearest to equal pitch.",
                          window({18, 0}, {860, 560}, 8.4));
  add_gear(f, gear(2), "ring", "body outline g2", Vec2::Zero(), kPi / 58);
  add_gear(f, gear(0), "sun", "body outline g1", Vec2::Zero(), 0);
  for (const Rational& turn : assembly.turns) {
    // A planet that rolls on the sun has turned by θ (1 + z_s/z_p) when the carrier is at θ.
    const double theta = 2 * kPi * turn.value();
    const double turned = kPi + kPi / 19 + theta * (1 + 20.0 / 19);
    add_gear(f, gear(1), "planet", "part b2", polar(a, theta), turned);
    f.dot(polar(a, theta), 4.5, "mark");
  }
  f.circle(Vec2::Zero(), a, "thin dash", -1);
  for (long long n = 0; n < assembly.places; ++n) {
    const double angle = 2 * kPi * static_cast<double>(n) / static_cast<double>(assembly.places);
    f.line({polar(a - 0.5, angle), polar(a + 0.5, angle)}, "one");
  }
  constexpr std::array words{
      "{z_s} = 20, {z_p} = 19, {z_r} = −58", "N* = 78 places per turn, marked by ticks",
      "four planets as near to 90° as possible:", "0°, 92.308°, 180°, 272.308°",
      "180° apart in pairs, so the forces cancel"};
  double y = 60;
  for (const char* line : words)
    f.text({34, kInfinity}, markup(line), Anchor::start, "", {0, y += 26});
  return {f, 860};
}

}  // namespace gearwright::figures
