// Page 4: two gears on a common rack. The centre distance is least if the pitch planes coincide
// (X = 0). The teeth are in contact on one interval of the pressure angle of the rack.
#include <array>

#include "docs/figures/figure.hpp"
#include "gearwright/pair/pair.hpp"
#include "gearwright/report/crossed_range.hpp"

namespace gearwright::figures {

Drawing crossed_figure() {
  Drawing f("04-conjugate-action", 860, 790,
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
  const double least_angle = transverse_angle_at_min_distance(gears).value();
  const CrossedPlace least = crossed_place(gears, least_angle);
  const auto pair = mount_as<CrossedPair>(
      one, two, {.center_distance = least.center_distance, .shaft_angle = least.shaft_angle});
  const CrossedPlaces& range = pair->contact_ratio_range.value();

  const std::vector<CrossedSample> samples = crossed_samples(*pair);
  const double low = range.lo.normal_pressure_angle.deg();
  const double high = range.hi.normal_pressure_angle.deg();
  const double at_least = least.normal_pressure_angle.deg();
  const auto panel = [&](const FigureAxis& y, const char* style, double tall, const auto& value) {
    Figure p{y.symbol, y.words, y.words + " over the pressure angle of the rack.", "", {}, y};
    p.bar({low, -kInfinity}, {high, kInfinity}, "band");
    p.line({{at_least, -kInfinity}, {at_least, kInfinity}}, "least");
    p.line(over_angle(samples, value), style, y.words);
    fit_axes(p, 0.1);
    p.x = angle_axis(p.x.lo, p.x.hi);
    p.tall = tall;
    return p;
  };
  Figure distance = panel({.words = "centre distance", .unit = "mm", .symbol = "a"}, "curve g1",
                          0.17, [](const CrossedSample& s) { return s.place.center_distance; });
  distance.dot({at_least, least.center_distance}, 4.0, "mark g1");
  distance.text({at_least, kInfinity}, markup("least distance: {X} = 0, {da}/{dα_n} = 0 [T4.10]"),
                Anchor::start, "halo", {8, 18});
  const Figure planes =
      panel({.words = "distance of the pitch planes", .unit = "mm", .symbol = "X"},
            "curve action-curve", 0.1, [&](const CrossedSample& s) {
              const double alpha = s.place.normal_pressure_angle.rad();
              return common_rack(gears, angles_at(gears, alpha)).tight_plane_distance();
            });
  const Figure shaft = panel({.words = "shaft angle", .unit = "°", .symbol = "Σ"}, "curve g2", 0.1,
                             [](const CrossedSample& s) { return s.place.shaft_angle.deg(); });
  Figure ratio =
      panel({.words = "contact ratio", .unit = {}, .symbol = "ε"}, "curve trailing-curve", 0.1,
            [](const CrossedSample& s) { return s.contact_ratio; });
  ratio.text({high, -kInfinity}, markup("{ε} ≥ 1 [T4.23]"), Anchor::end, "halo", {-6.0, -8.0});
  double top = 0.0;
  for (const auto* p : std::array<const Figure*, 4>{&distance, &planes, &shaft, &ratio}) {
    f.add(*p, {0, top}, 860);
    top += p == &distance ? 216 : 188;
  }
  return f;
}

}  // namespace gearwright::figures
