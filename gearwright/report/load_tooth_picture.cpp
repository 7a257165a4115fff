#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/load_figures.hpp"
#include "gearwright/report/gear_figures.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/report_sections.hpp"

namespace gearwright {

namespace {

using Eigen::Index;

constexpr double kLoadToothAspect = 520.0 / 360.0;
constexpr double kLongest = 0.7;  // normal modules, length of the bar of the greatest stress

struct Fillet {
  std::vector<Vec2> at, in;    // points in mm, and directions into the material
  std::vector<double> stress;  // MPa, in the slice with the greatest stress
  std::size_t worst = 0;
  Index slice = 0;
};

Fillet fillet_of(const LoadScene& report, std::size_t which) {
  // The outline runs to the tip. The material is on its right, or on its left for an internal gear.
  const double side = report.gears[which]->side();
  const Eigen::MatrixXd& stress = shown_torque(report).root_stress[which];
  Fillet f;
  Index row = 0;
  stress.maxCoeff(&row, &f.slice);
  f.worst = static_cast<std::size_t>(row);
  for (const auto& p : report.contact.root_points[which]) f.at.push_back({p.real(), p.imag()});
  const std::size_t n = f.at.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 along = (f.at[std::min(i + 1, n - 1)] - f.at[i == 0 ? 0 : i - 1]).normalized();
    f.in.push_back({side * along.y(), -side * along.x()});
    f.stress.push_back(stress(static_cast<Index>(i), f.slice));
  }
  return f;
}

std::string fillet_figure(const LoadScene& report, std::size_t which, const std::string& shape,
                          UnitSystem units) {
  const Gear& gear = *report.gears[which];
  const Fillet f = fillet_of(report, which);
  const double module = gear.spec.normal_module;
  const double most = f.stress[f.worst];
  const std::string name = fmt::format("Gear {}", which + 1);
  // The window extends radially from one module behind the root to almost one module beyond the
  // fillet. The point of the greatest stress on the side in tension is in the middle.
  const double out = gear.side();
  const double root = f.at.front().norm() - out * 1.0 * module;
  const double flank = f.at.back().norm() + out * 0.9 * module;
  const auto [lo, hi] = std::minmax(root, flank);
  // The side in tension is the side y > 0 of the gear frame. It is drawn on the right.
  const Vec2 worst = f.at[f.worst];
  const double half = 0.5 * kLoadToothAspect * (hi - lo);
  Figure figure = plane_figure(fmt::format("root-stress{}{}", which + 1, report.part),
                               fmt::format("{}: {} N/mm²", name, fixed(most, 1)),
                               "The tooth in the transverse section. Bars on the fillet in tension "
                               "show the greatest principal stress during a mesh.",
                               {{worst.y() - half, lo}, {worst.y() + half, hi}});
  figure.caption = fmt::format(
      " at the dot, on a diameter of {} mm and at z = {} mm from the middle of the face. The bars "
      "show the greatest principal stress at each point of the fillet during a mesh.",
      fixed(2 * worst.norm(), 2),
      fixed(report.contact.slices[which].middle(static_cast<int>(f.slice)), 2));
  add_upright_gear(figure, gear, shape, fmt::format("body g{}", which + 1));
  figure.line({{0.0, 0.0}, {0.0, 2 * hi}}, "thin dashdot");
  std::vector<Vec2> ends, bars;
  for (std::size_t i = 0; i < f.at.size(); ++i) {
    ends.push_back(upright(f.at[i] + (kLongest * module * f.stress[i] / most) * f.in[i]));
    bars.insert(bars.end(), {upright(f.at[i]), ends.back(), kNewPiece});
  }
  figure.line(std::move(bars), "thin");
  figure.line(ends, "curve c-root-fillet");
  figure.dot(upright(worst), 3.0, "mark");
  figure.text(ends[f.worst], fixed(most, 0) + " N/mm²", Anchor::end, "halo", {-6.0, 4.0});
  return figure_html(in_units(units, figure), kPlaneFigure);
}

}  // namespace

std::string root_stress_figures(const LoadScene& report, const std::array<std::string, 2>& shapes,
                                UnitSystem units) {
  std::string figures;
  for (std::size_t g = 0; g < 2; ++g)
    if (shown_torque(report).root_stress[g].size() > 0 &&
        shown_torque(report).root_stress[g].maxCoeff() > 0.0)
      figures += fillet_figure(report, g, shapes[g], units);
  if (figures.empty()) return {};
  figures += html_of(in_units(units, root_face_figure(report)));
  return side_by_side(figures + html_of(root_turn_figure(report)));
}

}  // namespace gearwright
