#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/report/contact_contour.hpp"
#include "gearwright/report/flank_frame.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/load_figures.hpp"
#include "gearwright/report/turning.hpp"

namespace gearwright {

namespace {

constexpr std::size_t kRows = 81;
constexpr std::size_t kColumns = 65;
constexpr int kMostLevels = 10;
constexpr double kLow = 276.0;      // px of flank: the key stands between the names of tip and root
constexpr double kStraight = 0.15;  // px: points of a line so near to a chord are left out

// A slice of a flank on its way through the mesh: where it is nearest, and how it presses there.
struct Sample {
  double own;     // the turn of the tooth pair, pitches
  double radius;  // mm
  double pressure;
};

std::vector<Sample> samples_of(const LoadReport& report, std::size_t which, std::size_t slice) {
  std::vector<Sample> all;
  for (const LoadedPosition& p : heaviest(report).positions)
    for (const LoadedPair& k : p.pairs)
      if (const double r = k.radius[slice][which]; r > 0.0)
        all.push_back({own_pitches(report, p, k), r, k.pressure[static_cast<Eigen::Index>(slice)]});
  std::sort(all.begin(), all.end(), [](const Sample& a, const Sample& b) { return a.own < b.own; });
  return all;
}

// The greatest pressure at a radius. A mating edge passes a place twice, out and back: of all ways
// past it the greatest counts.
double greatest_at(const std::vector<Sample>& way, double step, double radius) {
  double most = 0.0;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const Sample& a = way[i];
    const Sample& b = way[i + 1];
    const bool past = (radius - a.radius) * (radius - b.radius) <= 0.0;
    if (!past || b.own - a.own > 1.5 * step) continue;
    const double part = b.radius == a.radius ? 0.0 : (radius - a.radius) / (b.radius - a.radius);
    const double here = b.radius == a.radius ? std::max(a.pressure, b.pressure)
                                             : a.pressure + part * (b.pressure - a.pressure);
    most = std::max(most, here);
  }
  return most;
}

// The places of a tooth pair that press, in one piece or several, px.
std::vector<std::vector<Vec2>> bearing_lines(const LoadReport& report, const LoadedPair& pair,
                                             std::size_t which, const FlankFrame& f) {
  const auto heights = heights_of(report, 0);
  std::vector<std::vector<Vec2>> lines;
  bool open = false;
  for (std::size_t j = 0; j < heights.size(); ++j) {
    if (!(pair.pressure[static_cast<Eigen::Index>(j)] > 0.0)) {
      open = false;
      continue;
    }
    if (!open) lines.emplace_back();
    open = true;
    lines.back().push_back(f({heights[j], pair.radius[j][which]}));
  }
  return lines;
}

// Without the points that lie on the way between their neighbours.
std::vector<Vec2> thinned(const std::vector<Vec2>& line) {
  std::vector<Vec2> kept{line.front()};
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const Vec2 way = (line[i + 1] - kept.back()).normalized();
    const Vec2 from = line[i] - kept.back();
    if (std::abs(way.x() * from.y() - way.y() * from.x()) > kStraight) kept.push_back(line[i]);
  }
  if (line.size() > 1) kept.push_back(line.back());
  return kept;
}

// Draws something for every place of the slider; the first is seen without it.
template <class Draw>
void draw_frames(Svg& svg, const LoadReport& report, const Draw& draw) {
  const auto positions = slider_positions(report);
  for (std::size_t k = 0; k < positions.size(); ++k) {
    svg.begin_group(frame_attributes(k, positions.size()));
    for (const LoadedPair& pair : heaviest(report).positions[positions[k]].pairs) draw(pair);
    svg.end_group();
  }
}

std::string flank_svg(const LoadReport& report, std::size_t which) {
  const LoadedTorque& t = heaviest(report);
  const FlankRaster raster = pressure_raster(report, which);
  const FlankFrame f = frame_of(raster, report.gears[which]->internal(), kLow);
  const std::string name = fmt::format("Gear {}", which + 1);
  Svg svg = flank_picture(
      fmt::format("pressure{}", which + 1), f, which, name + ": pressure on the flank",
      "The usable flank laid flat, shaded by the greatest pressure over a mesh; lines: where the "
      "tooth pairs bear at one position.");
  // Of pressures turned over, to have the regions above a level.
  ContourField field{raster.height.size(), raster.diameter.size(), raster.gap};
  for (double& v : field.value) v = -v;
  const std::vector<double> levels = levels_between(0.0, t.max_pressure, kMostLevels);
  const std::size_t n = levels.size() + 1;
  const auto px = nodes_px(raster, f);
  for (std::size_t i = 0; i < n; ++i) {
    const double level = i == 0 ? 0.0 : levels[i - 1];
    const auto loops = regions_below(field, -level);
    if (!loops.empty()) svg.path(loops_path(loops, px), shade_style(i, n) + (i ? " step" : ""));
  }
  draw_frames(svg, report, [&](const LoadedPair& pair) {
    for (const auto& line : bearing_lines(report, pair, which, f)) {
      if (line.size() > 1)
        svg.polyline(thinned(line), "action");
      else
        svg.dot(line.front(), 3.0, "mark action-dot");
    }
  });
  svg.end_group();
  draw_shades(svg, {f.z.to + 12, f.top() + 36}, levels, "≤ " + fixed(t.max_pressure, 0));
  return svg.str();
}

std::string along_svg(const LoadReport& report) {
  const LoadedTorque& t = heaviest(report);
  const FaceSlices& s = report.contact.slices[0];
  constexpr PlotArea kArea{640, 74, 104, 44, 200, 54};
  const Axis x = kArea.across(s.lo, s.hi);
  const Axis y = kArea.up(0.0, 1.06 * t.max_pressure);
  Svg svg(
      "pressure-along", kArea.width, kArea.height(), "Pressure along the face",
      "Over the face: the greatest pressure of a mesh, and that of the tooth pairs that bear at "
      "one position.");
  svg.text({12, 20}, "pressure, N/mm²", Anchor::start, "panel");
  draw_foot(svg, x, kArea.top, kArea.bottom(), 8, "along the face from its middle, mm");
  draw_rows(svg, x, y, 5);
  const auto heights = heights_of(report, 0);
  const auto curve = [&](auto of) {
    std::vector<Vec2> points;
    for (std::size_t j = 0; j < heights.size(); ++j) points.push_back({heights[j], of(j)});
    return points;
  };
  const auto at = [](const LoadedPair& k, std::size_t j) {
    return k.pressure[static_cast<Eigen::Index>(j)];
  };
  draw_curve(svg, x, y, curve([&](std::size_t j) {
               double most = 0.0;
               for (const LoadedPosition& p : t.positions)
                 for (const LoadedPair& k : p.pairs) most = std::max(most, at(k, j));
               return most;
             }),
             "before");
  draw_frames(svg, report, [&](const LoadedPair& pair) {
    draw_curve(svg, x, y, curve([&](std::size_t j) { return at(pair, j); }),
               fmt::format("curve tp{}", ((pair.pair % 3) + 3) % 3));
  });
  return svg.str();
}

}  // namespace

FlankRaster pressure_raster(const LoadReport& report, std::size_t which) {
  const Gear& gear = *report.gears[which];
  const FaceSlices& s = report.contact.slices[0];
  const double root = gear.root_form_radius().value_or(gear.base_radius());
  const double tip = gear.tip_form_radius();
  const auto [lo, hi] = std::minmax(root, tip);
  FlankRaster raster;
  const auto part = [](std::size_t i, std::size_t n) {
    return static_cast<double>(i) / static_cast<double>(n - 1);
  };
  for (std::size_t i = 0; i < kRows; ++i)
    raster.diameter.push_back(2 * (lo + part(i, kRows) * (hi - lo)));
  for (std::size_t i = 0; i < kColumns; ++i)
    raster.height.push_back(s.lo + part(i, kColumns) * (s.hi - s.lo));
  const double step = 1.0 / static_cast<double>(heaviest(report).positions.size());
  std::vector<std::vector<Sample>> slices;
  for (int j = 0; j < s.count; ++j)
    slices.push_back(samples_of(report, which, static_cast<std::size_t>(j)));
  for (const double d : raster.diameter) {
    for (const double z : raster.height) {
      // Beyond the middles of the last slices it is theirs.
      const double place = std::clamp((z - s.middle(0)) / s.width(), 0.0, s.count - 1.0);
      const auto j = std::min(static_cast<std::size_t>(place), slices.size() - 2);
      const double to_next = place - static_cast<double>(j);
      raster.gap.push_back((1 - to_next) * greatest_at(slices[j], step, d / 2) +
                           to_next * greatest_at(slices[j + 1], step, d / 2));
    }
  }
  return raster;
}

std::string pressure_figures(const LoadReport& report) {
  return side_by_side(
      captioned(
          flank_svg(report, 0) + turn_control(*report.pair),
          fmt::format("<strong>Gear 1</strong> at {}: the greatest pressure over a mesh, N/mm². {}",
                      torque_words(heaviest(report)),
                      caption_key("action", "where teeth bear at the slider’s position"))) +
      captioned(flank_svg(report, 1), "<strong>Gear 2</strong>, the same.") +
      captioned(along_svg(report),
                "<strong>Pressure along the face</strong> of each tooth pair that bears there, a "
                "colour for each. " +
                    caption_key("before", "the greatest over a mesh")));
}

}  // namespace gearwright
