// Page 11: the geometry of a strength rating. Left: the critical section of a tooth and its load,
// with the values that the rating uses. Right: the life curves of flank and root.
#include <cmath>
#include <numbers>

#include "docs/figures/figure.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/rating/material.hpp"
#include "gearwright/rating/root.hpp"

namespace gearwright::figures {

namespace {

void draw_section(Drawing& f) {
  CylindricalSpec spec;
  spec.teeth = 20;
  spec.normal_module = 10;
  spec.profile_shift = 0.2;
  spec.face_width = 100;
  const Gear gear = gear_of(spec);
  const auto mounted = mount(gear, gear);
  const auto pair = rated_pair(*mounted);
  const CriticalSection s = critical_section(*pair, pair->gears[0]).value();
  const Viewport view{430, 470, {102, 0}, 9.5, true};
  f.shape(view, teeth(gear, 0, 0, 0, 0.01), "body1 g1");
  // The line of the load intersects the centre line of the tooth at α_Fen, h_F above the section.
  const double r_b = gear.base_radius();
  const double apex = r_b / std::cos(s.alpha_Fen);
  const double chord = apex - s.h_F;
  const double half = s.s_Fn / 2;
  const double r_e = s.d_en / 2;
  const double psi =
      tooth_thickness_transverse(20, 2 * r_b, gear.reference().base_tooth_thickness, s.d_en) /
      s.d_en;
  const Vec2 e = polar(r_e, psi);
  const Vec2 meets(apex, 0);
  const Vec2 along = (meets - e).normalized();
  f.line(view, {Vec2(84, 0), Vec2(124, 0)}, "soft dashdot thin");
  f.line(view, {Vec2(chord, -half), Vec2(chord, half)}, "g2 thick");
  for (const double side : {1.0, -1.0}) {
    const Vec2 touch(chord, side * half);
    const Vec2 up(std::cos(std::numbers::pi / 6), -side * std::sin(std::numbers::pi / 6));
    f.line(view, {touch - 6 * up, touch + 14 * up}, "g2 dash");
    f.dot(view, touch, "fill-g2");
  }
  f.arrow(view.px(e - 12 * along), view.px(e), "action thick");
  f.line(view, {e, meets}, "action dash");
  f.dot(view, e, "fill-action");
  f.arrow(view.px({chord, -13}), view.px({apex, -13}), "soft", true);
  f.line(view, {meets, Vec2(apex, -14.5)}, "soft thin");
  f.line(view, {Vec2(chord, -half), Vec2(chord, -14.5)}, "soft thin");
  f.label(view.px({(chord + apex) / 2, -13}), "{h_F}", Anchor::start, {8, 4}, "halo");
  f.label(view.px({chord, 0}), "{s_Fn}", Anchor::middle, {14, 18}, "g2 halo");
  f.label(view.px({chord + 12 * std::cos(std::numbers::pi / 6), half - 6}), "30°", Anchor::end,
          {-10, 0}, "g2 small halo");
  f.label(view.px(e), "outer point of single contact, {d_en}", Anchor::middle, {-30, -56},
          "action small halo");
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
  draw_section(f);
  f.add(lives(), {430, 0}, 430);
  return f;
}

}  // namespace gearwright::figures
