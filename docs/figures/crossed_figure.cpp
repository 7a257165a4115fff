// Page 4: two gears on a common rack. The centre distance is least if the pitch planes coincide
// (X = 0). The teeth are in contact on one interval of the pressure angle of the rack.
#include <cmath>
#include <stdexcept>

#include "docs/figures/figure.hpp"
#include "gearwright/pair/pair.hpp"

namespace gearwright::figures {

Figure crossed_figure() {
  Figure f("04-conjugate-action", 860, 640,
           "Centre distance, shaft angle and contact ratio over one rack",
           "Centre distance, distance of the pitch planes, shaft angle and contact ratio of a "
           "crossed pair of 9 "
           "and 15 teeth, free of backlash, over the pressure angle of the common rack.");
  // The gears of Tab. 1 of the paper by Mägi. They can be cut by different racks.
  CylindricalSpec spec;
  spec.teeth = 9;
  spec.normal_module = 3;
  spec.helix_angle = Angle::degrees(51.5765);
  spec.profile_shift = -0.1325385;
  spec.face_width = 30;
  const Gear one = gear_of(spec);
  spec.teeth = 15;
  spec.helix_angle = Angle::degrees(39.3766);
  const Gear two = gear_of(spec);
  const BasePair<double> gears = base_pair(one, two);
  const auto least_angle = transverse_angle_at_min_distance(gears);
  if (!least_angle) throw std::logic_error("the figure's teeth are too thin");
  const CrossedPlace least = crossed_place(gears, *least_angle);
  const auto mounted = mount_as<CrossedPair>(
      one, two, {.center_distance = least.center_distance, .shaft_angle = least.shaft_angle});
  if (!mounted) throw std::logic_error(mounted.error().message());
  const auto range = contact_ratio_range(mounted->input);
  if (!range) throw std::logic_error("the figure's teeth do not meet");

  // Samples over α_n. Each common rack gives the position of the pair and its contact ratio.
  std::vector<Vec2> distance, planes, shaft, ratio;
  const double to_deg = Angle::radians(1).deg();
  const double low = range->lo.normal_pressure_angle.deg();
  const double high = range->hi.normal_pressure_angle.deg();
  const double from = low - 0.07 * (high - low);
  const double to = high + 0.07 * (high - low);
  for (int i = 0; i <= 160; ++i) {
    const double deg = from + (to - from) * i / 160;
    const double alpha = Angle::degrees(deg).rad();
    const CommonRack<double> rack = common_rack(gears, angles_at(gears, alpha));
    const double a = conjugate_center_distance(gears, rack);
    distance.push_back({deg, a});
    planes.push_back({deg, rack.tight_plane_distance()});
    shaft.push_back({deg, rack.shaft_angle * to_deg});
    MeshInput<double> input = mounted->input;
    input.center_distance = a;
    input.shaft_angle = rack.shaft_angle;
    ratio.push_back({deg, mesh_of(input).path_ratio});
  }

  const auto in = [&](const std::vector<Vec2>& points) {
    double lo = points[0].y(), hi = lo;
    for (const Vec2& p : points) lo = std::min(lo, p.y()), hi = std::max(hi, p.y());
    return std::vector{lo - 0.06 * (hi - lo), hi + 0.12 * (hi - lo)};
  };
  struct Panel {
    const std::vector<Vec2>& points;
    const char *head, *style;
    double height;
  };
  const std::array panels{Panel{distance, "centre distance {a}, mm", "g1 thick", 170},
                          Panel{planes, "distance {X} of the pitch planes, mm", "action thick", 95},
                          Panel{shaft, "shaft angle {Σ}, °", "g2 thick", 95},
                          Panel{ratio, "contact ratio {ε}", "green thick", 95}};
  const double alpha_least = least.normal_pressure_angle.deg();
  const Axis x{from, to, 70, 836};
  double top = 34;
  const double first = top;
  f.svg().rect(x(low), first, x(high) - x(low), 555, "band");
  for (const Panel& panel : panels) {
    const auto ends = in(panel.points);
    const Plot plot{x, {ends[0], ends[1], top + panel.height, top}};
    const bool foot = &panel == &panels.back();
    draw_frame(f, plot, foot ? "normal pressure angle {α_n} of the rack, °" : "", panel.head,
               foot ? 8 : 0, 4);
    if (panel.points[0].y() > 0 && ends[0] < 0)
      f.svg().line(plot.px(x.lo, 0), plot.px(x.hi, 0), "ink thin");
    draw_curve(f, plot, panel.points, panel.style);
    top += panel.height + 33;
  }
  const Axis y{in(distance)[0], in(distance)[1], first + 170, first};
  f.svg().line({x(alpha_least), first}, {x(alpha_least), first + 555}, "ink dash");
  f.svg().circle({x(alpha_least), y(least.center_distance)}, 5, "fill-g1");
  f.label({x(alpha_least), y(least.center_distance)},
          "least distance: {X} = 0, {da}/{dα_n} = 0 [T4.10]", Anchor::middle, {0, -90}, "halo");
  f.label({x(high) - 6, first + 162}, "{ε} ≥ 1 [T4.23]", Anchor::end, Vec2::Zero(), "green small");
  return f;
}

}  // namespace gearwright::figures
