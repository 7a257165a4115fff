#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "gearwright/base/contract.hpp"
#include "gearwright/report/flank_frame.hpp"
#include "gearwright/report/gear_shape.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/load_figures.hpp"

namespace gearwright {

namespace {

constexpr double kLow = 200.0;          // px of flank
constexpr std::size_t kMostDrawn = 14;  // ellipses that can be told apart
constexpr int kCorners = 48;            // of an ellipse

// A tooth at one place of its way.
struct Passing {
  double own;  // its turn, pitches
  const LoadedPoint* point;
};

// A way for each track: the teeth of double arcs have two.
std::vector<std::vector<Passing>> ways_of(const LoadReport& report, const LoadedTorque& t) {
  std::map<int, std::vector<Passing>> by_track;
  for (const LoadedPosition& p : t.positions)
    for (const LoadedPair& k : p.pairs)
      by_track[k.point.track].push_back({own_pitches(report, p, k), &k.point});
  std::vector<std::vector<Passing>> ways;
  for (auto& [track, way] : by_track) {
    std::sort(way.begin(), way.end(),
              [](const Passing& a, const Passing& b) { return a.own < b.own; });
    ways.push_back(std::move(way));
  }
  return ways;
}

Vec2 middle_of(const LoadedPoint& p, std::size_t which) {
  return {p.height[which], p.diameter[which] / 2};
}

std::vector<Vec2> outline_of(const LoadedPoint& p, std::size_t which, const FlankFrame& f) {
  std::vector<Vec2> line;
  for (int i = 0; i <= kCorners; ++i) {
    const double turn = 2 * std::numbers::pi * i / kCorners;
    const Vec2 at = middle_of(p, which) + std::cos(turn) * p.half_axis[which][0] +
                    std::sin(turn) * p.half_axis[which][1];
    line.push_back(f({at.x(), at.y()}));
  }
  return line;
}

std::string flank_svg(const LoadReport& report, std::size_t which) {
  const Gear& gear = *report.gears[which];
  const auto ways = ways_of(report, heaviest(report));
  double lo = gear.tip_form_radius();
  double hi = lo;
  for (const auto& way : ways)
    for (const Passing& p : way) {
      lo = std::min(lo, middle_of(*p.point, which).y());
      hi = std::max(hi, middle_of(*p.point, which).y());
    }
  if (const auto form = gear.root_form_radius()) lo = std::min(lo, *form);
  const double half = gear.spec.face_width / 2;
  const FlankRaster extent{{2 * lo, 2 * hi}, {-half, half}, {}};
  const FlankFrame f = frame_of(extent, false, kLow);
  const std::string name = fmt::format("Gear {}", which + 1);
  Svg svg =
      flank_picture(fmt::format("ellipses{}", which + 1), f, which, name + ": ellipses of contact",
                    "The usable flank laid flat; ellipses: where a tooth presses at places of its "
                    "way through the "
                    "mesh; the line joins their middles.");
  for (const auto& way : ways) {
    std::vector<Vec2> path;
    for (const Passing& p : way) {
      const Vec2 at = middle_of(*p.point, which);
      path.push_back(f({at.x(), at.y()}));
    }
    if (path.size() > 1) svg.polyline(path, "thin dashdot");
    const std::size_t step = (way.size() + kMostDrawn - 1) / kMostDrawn;
    for (std::size_t i = step / 2; i < way.size(); i += step)
      svg.polyline(outline_of(*way[i].point, which, f),
                   way[i].point->beyond ? "before" : "curve action");
  }
  svg.end_group();
  return svg.str();
}

std::string pressure_figure(const LoadReport& report) {
  std::vector<PlotCurve> curves;
  std::size_t shown = 0;
  for (const std::size_t i : shown_torques(report)) {
    const std::string style = "curve " + curve_style(shown++);
    for (const auto& way : ways_of(report, report.contact.torques[i])) {
      PlotCurve c{{}, style};
      for (const Passing& p : way) c.values.push_back({p.own, p.point->pressure});
      curves.push_back(std::move(c));
    }
  }
  return captioned(
      curves_svg({"point-pressure", "Pressure of a tooth pair",
                  "Over the way of one tooth pair through its mesh: the greatest pressure.",
                  "N/mm²", "turn of the tooth pair from the centre line, pitches"},
                 curves, true),
      "<strong>Pressure</strong> in the middle of the ellipse, of one tooth pair from where it "
      "begins to bear to where it ceases. " +
          torque_keys(report));
}

using Eigen::Index;

constexpr double kWidth = 520.0, kHeight = 360.0;
constexpr double kLongest = 0.7;  // normal modules: the greatest stress as it is drawn

struct Fillet {
  std::vector<Vec2> at, in;    // mm, and the direction into the material
  std::vector<double> stress;  // MPa, where along the face it is greatest
  std::size_t worst = 0;
  Index slice = 0;
};

Fillet fillet_of(const LoadReport& report, std::size_t which) {
  // The outline runs to the tip with the material on its right, of an internal gear on its left.
  const double side = report.gears[which]->internal() ? -1.0 : 1.0;
  const Eigen::MatrixXd& stress = heaviest(report).root_stress[which];
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

std::string fillet_figure(const LoadReport& report, std::size_t which, const std::string& shape) {
  const Gear& gear = *report.gears[which];
  const Fillet f = fillet_of(report, which);
  const double module = gear.spec.normal_module;
  const double most = f.stress[f.worst];
  const std::string name = fmt::format("Gear {}", which + 1);
  // From a module behind the root to almost one beyond the fillet, the pulled side in the middle.
  const double out = gear.internal() ? -1.0 : 1.0;
  const double root = f.at.front().norm() - out * 1.0 * module;
  const double flank = f.at.back().norm() + out * 0.9 * module;
  const auto [lo, hi] = std::minmax(root, flank);
  const double scale = kHeight / (hi - lo);
  const Vec2 middle = f.at[f.worst];
  // The pulled side is drawn on the right, which is y < 0 of the gear frame.
  const Viewport view{kWidth, kHeight, mirrored({0.5 * (lo + hi), middle.y()}), scale, true};
  Svg svg(fmt::format("root-stress{}", which + 1), kWidth, kHeight,
          name + ": stress along the fillet",
          "The tooth in the transverse section; bars on the fillet that is pulled: the greatest "
          "principal stress over a mesh.");
  const Vec2 axis = view.px(Vec2::Zero());
  svg.begin_clip(0, 0, kWidth, kHeight);
  svg.use(shape, axis, view.scale * outline_unit_mm(gear), 90.0,
          fmt::format("body g{}", which + 1));
  svg.line(axis, view.px({2 * hi, 0.0}), "thin dashdot");
  std::vector<Vec2> ends;
  for (std::size_t i = 0; i < f.at.size(); ++i) {
    const Vec2 end = f.at[i] + (kLongest * module * f.stress[i] / most) * f.in[i];
    ends.push_back(view.px(mirrored(end)));
    svg.line(view.px(mirrored(f.at[i])), ends.back(), "thin");
  }
  svg.polyline(ends, "curve c-root-fillet");
  svg.end_group();
  svg.dot(view.px(mirrored(f.at[f.worst])), 3.0, "mark");
  svg.text(ends[f.worst], fixed(most, 0) + " N/mm²", Anchor::end, "halo", {-6.0, 4.0});
  return captioned(
      svg.str(),
      fmt::format(
          "<strong>{}: {} N/mm²</strong> at the dot, on a diameter of {} mm, {} mm along the face "
          "from its middle. Bars: the greatest principal stress at each point of the fillet over a "
          "mesh.",
          name, fixed(most, 1), fixed(2 * middle.norm(), 2),
          fixed(report.contact.slices[which].middle(static_cast<int>(f.slice)), 2)));
}

std::string face_figure(const LoadReport& report) {
  std::vector<PlotCurve> curves;
  for (std::size_t g = 0; g < 2; ++g) {
    const auto heights = heights_of(report, g);
    const Eigen::RowVectorXd most = heaviest(report).root_stress[g].colwise().maxCoeff();
    PlotCurve c{{}, fmt::format("curve g{}", g + 1)};
    for (std::size_t j = 0; j < heights.size(); ++j)
      c.values.push_back({heights[j], most[static_cast<Index>(j)]});
    curves.push_back(std::move(c));
  }
  return captioned(
      curves_svg({"root-stress-face", "Root stress over the face",
                  "Over the face: the greatest stress along the fillet, of both gears.",
                  "root stress, N/mm²", "along the face from its middle, mm"},
                 curves, true),
      "<strong>Over the face</strong>: the greatest along the fillet. " + caption_of_gears());
}

}  // namespace

std::string ellipse_figures(const LoadReport& report) {
  GW_EXPECTS(report.contact.regime == LoadRegime::point);
  const std::string caption = fmt::format(
      "<strong>Gear 1</strong> at {}: the ellipses of contact of a tooth on its way through the "
      "mesh. {} {}",
      torque_words(heaviest(report)), caption_key("action", "on the flank"),
      caption_key("before", "hanging over an end of it"));
  return side_by_side(captioned(flank_svg(report, 0), caption) +
                      captioned(flank_svg(report, 1), "<strong>Gear 2</strong>, the same.") +
                      pressure_figure(report));
}

std::string root_stress_figures(const LoadReport& report,
                                const std::array<std::string, 2>& shapes) {
  std::string figures;
  for (std::size_t g = 0; g < 2; ++g)
    if (heaviest(report).root_stress[g].size() > 0 &&
        heaviest(report).root_stress[g].maxCoeff() > 0.0)
      figures += fillet_figure(report, g, shapes[g]);
  if (figures.empty()) return {};
  return side_by_side(figures + face_figure(report));
}

}  // namespace gearwright
