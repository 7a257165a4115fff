#include "gearwright/pair/rack_outline.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include "gearwright/curve/straight_curves.hpp"
#include "gearwright/gear/gear_field.hpp"

namespace gearwright {

namespace {

constexpr double kNoArc = 1e-6;  // modules: a shorter arc is below the resolution of any machine

// Appends arcs, each of which begins at the end of the preceding one.
class OutlineOfArcs {
 public:
  OutlineOfArcs(int teeth, const Vec2& begin) : end_(begin) { outline_.teeth = teeth; }
  void line(ArcName name, const Vec2& to) {
    outline_.arcs.push_back({name, std::make_shared<StraightLine>(end_, to), 0.0, 1.0, end_, to});
    end_ = to;
  }
  void curve(ArcName name, CurvePtr curve, double begin, double end) {
    const Vec2 to = curve->point(end);
    outline_.arcs.push_back({name, std::move(curve), begin, end, end_, to});
    end_ = to;
  }
  Outline take() { return std::move(outline_); }

 private:
  Outline outline_;
  Vec2 end_;
};

}  // namespace

Result<Outline> rack_outline(const RackGeometry& rack) {
  using std::numbers::pi;
  const double alpha = rack.normal_pressure_angle.rad();
  const double tan_n = std::tan(alpha), half = rack.thickness / 2;
  const double k = 1 / std::cos(rack.helix_angle.rad());
  // The range in which both lands have a length ≥ 0.
  const double least = 2 * rack.addendum * tan_n - rack.normal_pitch / 2;
  const double greatest = rack.normal_pitch / 2 - 2 * rack.dedendum * tan_n;
  const double none = kNoArc * rack.normal_module;
  if (rack.bar.thickness_allowance < least - none ||
      rack.bar.thickness_allowance > greatest + none) {
    return refused(gear_field(2, "thickness_allowance"), rack.bar.thickness_allowance,
                   {least, greatest},
                   "must lie between {} mm, at which the tooth is pointed, and {} mm, at which the "
                   "tooth space closes at the root");
  }
  const double rho = rack.fillet_radius, middle = rack.normal_pitch / 2;
  const double x_c = rho - rack.dedendum;
  const double n_c = half + (rho - x_c * std::sin(alpha)) / std::cos(alpha);
  const double tip = half - rack.addendum * tan_n;
  OutlineOfArcs arcs(rack.bar.teeth.value_or(1), {-rack.dedendum, k * middle});
  // A full radius leaves no root land, and a pointed tooth has no tip land.
  if (middle - n_c > none) arcs.line(ArcName::root_land, {-rack.dedendum, k * n_c});
  if (rho > none)
    arcs.curve(ArcName::root_fillet, std::make_shared<StretchedCircle>(Vec2(x_c, k * n_c), rho, k),
               pi, 1.5 * pi - alpha);
  arcs.line(ArcName::flank, {rack.addendum, tip > none ? k * tip : 0.0});
  if (tip > none) arcs.line(ArcName::tip_land, {rack.addendum, 0.0});
  return arcs.take();
}

}  // namespace gearwright
