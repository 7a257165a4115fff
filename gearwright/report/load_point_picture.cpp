#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "gearwright/base/contract.hpp"
#include "gearwright/report/flank_frame.hpp"
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

}  // namespace gearwright
