// Page 11: the geometry of a strength rating. Left: the critical section of a tooth and its load,
// with the values that the rating uses. Right: the life curves of flank and root.
#include <cmath>

#include "docs/figures/figure.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/rating/material.hpp"
#include "gearwright/rating/root.hpp"

namespace gearwright::figures {

namespace {

Figure section_figure() {
  CylindricalSpec spec;
  spec.teeth = 20;
  spec.normal_module = 10;
  spec.profile_shift = 0.2;
  spec.face_width = 100;
  const Gear gear = gear_of(spec);
  const auto mounted = mount(gear, gear);
  const auto pair = rated_pair(*mounted);
  const CriticalSection s = critical_section(*pair, pair->gears[0]).value();
  Figure f = plane_figure("section", "Critical section",
                          "A tooth with the tangents at 30 degrees and the load on it.",
                          window({0, 102}, {430, 470}, 9.5));
  add_gear(f, gear, "gear", "body outline g1", Vec2::Zero(), kHalfPi);
  // The line of the load intersects the centre line of the tooth at α_Fen, h_F above the section.
  const double r_b = gear.base_radius();
  const double apex = r_b / std::cos(s.alpha_Fen);
  const double chord = apex - s.h_F;
  const double half = s.s_Fn / 2;
  const double r_e = s.d_en / 2;
  const double psi =
      tooth_thickness_transverse(20, 2 * r_b, gear.reference().base_tooth_thickness, s.d_en) /
      s.d_en;
  const Vec2 e = polar(r_e, kHalfPi + psi);
  const Vec2 meets(0, apex);
  f.line({{0, 84}, {0, 124}}, "thin dashdot");
  f.line({{half, chord}, {-half, chord}}, "curve g2");
  for (const double side : {1.0, -1.0}) {
    const Vec2 touch(-side * half, chord);
    const Vec2 up(side * std::sin(kPi / 6), std::cos(kPi / 6));
    f.line({touch - 6 * up, touch + 14 * up}, "thin g2 dash");
    f.dot(touch, 3.5, "mark g2");
  }
  add_arrow(f, {e - 12 * (meets - e).normalized(), e}, "curve action-curve");
  f.line({e, meets}, "action-line");
  f.dot(e, 3.5, "mark action-dot");
  add_arrow(f, {{13, chord}, {13, apex}}, "thin", true);
  f.line({meets, {14.5, apex}}, "thin");
  f.line({{half, chord}, {14.5, chord}}, "thin");
  f.text({13, (chord + apex) / 2}, markup("{h_F}"), Anchor::start, "halo", {8, 4});
  f.text({0, chord}, markup("{s_Fn}"), Anchor::middle, "halo g2", {14, 18});
  f.text({6 - half, chord + 12 * std::cos(kPi / 6)}, "30°", Anchor::end, "halo g2", {-10, 0});
  f.text(e, markup("outer point of single contact, {d_en}"), Anchor::middle, "halo here",
         {-30, -56});
  return f;
}

Figure lives() {
  Figure f{
      "lives",
      "Life factors",
      "The life factors of flank and root over the load cycles.",
      "",
      {.words = "load cycles", .unit = {}, .lo = 1e2, .hi = 3e10, .symbol = "N_L", .log = true},
      {.words = "life factors",
       .unit = {},
       .lo = 0.8,
       .hi = 2.7,
       .symbol = "Z_NT, Y_NT",
       .log = true}};
  f.tall = 1.05;
  name_decades(f.x);
  const auto curve = [&](const auto& life, const char* style) {
    std::vector<Vec2> points;
    for (double lg = 2; lg <= 10.5; lg += 0.05) {
      const double cycles = std::pow(10.0, lg);
      points.push_back({cycles, life(cycles).factor.value});
    }
    f.line(std::move(points), style);
  };
  using K = MaterialKind;
  curve([](double n) { return flank_life(K::case_hardened, n); }, "curve g1");
  curve([](double n) { return root_life(K::case_hardened, n); }, "curve g2");
  curve([](double n) { return root_life(K::through_hardened, n); }, "curve g2 dash");
  curve([](double n) { return flank_life(K::nitrided, n); }, "curve g1 dash");
  f.text({3e10, 2.2}, "root: case-hardened; tempered, dashed", Anchor::end, "halo g2");
  f.text({3e10, 1.55}, "flank: hardened; nitrided, dashed", Anchor::end, "halo g1");
  return f;
}

}  // namespace

Drawing rating_figure() {
  Drawing f("11-rating", 860, 480, "Critical section and life factors",
            "Left, a tooth with the tangents at 30 degrees that determine its critical section, "
            "and the load on it. Right, the life factors of flank and root over the load cycles.");
  f.add(section_figure(), {0, 0}, 430);
  f.add(lives(), {430, 0}, 430);
  return f;
}

}  // namespace gearwright::figures
