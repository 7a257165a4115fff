#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "gearwright/base/units.hpp"
#include "gearwright/report/contact_figures.hpp"
#include "gearwright/report/flank_frame.hpp"
#include "gearwright/report/html_text.hpp"

namespace gearwright {

namespace {

constexpr int kEllipses = 7;  // drawn, or a few more

// A contact line is straight in space and a curve on a flank laid flat.
std::vector<Vec2> line_px(const ContactReport& report, const ContactPoint& p, std::size_t which,
                          const FlankFrame& f) {
  constexpr int kSteps = 12;
  std::vector<Vec2> points;
  for (int k = 0; k <= kSteps; ++k) {
    const Vec3 at =
        (*p.line)[0] + (static_cast<double>(k) / kSteps) * ((*p.line)[1] - (*p.line)[0]);
    points.push_back(f(place_on(report.axes[which], at)));
  }
  return points;
}

void draw_instants(Svg& svg, const ContactReport& report, const std::vector<PathPiece>& pieces,
                   std::size_t which, const FlankFrame& f) {
  std::size_t count = 0;
  for (const PathPiece& piece : pieces) count += piece.edge ? 0 : piece.points.size();
  const std::size_t step = std::max<std::size_t>(1, count / kEllipses);
  std::size_t i = step / 2;
  for (const PathPiece& piece : pieces) {
    if (piece.edge) continue;
    for (const ContactPoint* p : piece.points) {
      if (i++ % step != 0) continue;
      if (p->line) {
        svg.polyline(line_px(report, *p, which, f), "instant");
        continue;
      }
      std::vector<Vec2> ellipse;
      for (const FlankPlace& at : ellipse_on(report, *p, which)) ellipse.push_back(f(at));
      if (!ellipse.empty()) svg.polygon(ellipse, "instant");
    }
  }
}

Vec2 point_px(const ContactPoint& p, std::size_t which, const FlankFrame& f) {
  return f({p.height[which], p.diameter[which] / 2});
}

void draw_path(Svg& svg, const std::vector<PathPiece>& pieces, std::size_t which,
               const FlankFrame& f) {
  for (const PathPiece& piece : pieces) {
    std::vector<Vec2> way;
    for (const ContactPoint* p : piece.points) way.push_back(point_px(*p, which, f));
    if (way.size() > 1) {
      svg.polyline(way, piece.edge ? "edge-way" : "action");
    } else {
      svg.dot(way.front(), 2.2, piece.edge ? "edge-dot" : "mark action-dot");
    }
  }
  if (pieces.empty()) return;
  svg.dot(point_px(*pieces.front().points.front(), which, f), 5.0, "way-begin");
  svg.dot(point_px(*pieces.back().points.back(), which, f), 4.5, "mark");
}

struct Seen {
  bool ellipse = false, line = false, edge = false, inside = false;
};

Seen seen_in(const std::vector<PathPiece>& pieces) {
  Seen seen;
  for (const PathPiece& piece : pieces) {
    (piece.edge ? seen.edge : seen.inside) = true;
    for (const ContactPoint* p : piece.points) {
      seen.line = seen.line || p->line.has_value();
      seen.ellipse = seen.ellipse || (!p->line && p->ellipse && p->ellipse->semi_major);
    }
  }
  return seen;
}

std::string side_words(const ContactReport& report, std::size_t which) {
  const bool ring = report.gears[which]->internal();
  const bool right =
      which == 0 ? !report.gear2_drives : report.gear2_drives == report.gears[1]->internal();
  return fmt::format("{} flank{}", right ? "right" : "left",
                     ring ? " of the internal gear (its tip is the smaller diameter)" : "");
}

std::string pattern_figure(const ContactReport& report, const std::vector<PathPiece>& pieces,
                           std::size_t which) {
  const Gear& gear = *report.gears[which];
  const FlankRaster& raster = report.patterns[which];
  const FlankFrame f = frame_of(raster, gear.internal());
  const std::string name = fmt::format("Gear {}", which + 1);
  Svg svg = flank_picture(fmt::format("bearing{}", which + 1), f, which,
                          name + ": bearing contact on the flank",
                          "The usable flank laid flat with the marking pattern, the path of the "
                          "contact point and contact "
                          "ellipses or lines at equal steps of rotation.");
  svg.path(loops_path(regions_below(field_of(raster), report.marking), nodes_px(raster, f)),
           "marked");
  draw_instants(svg, report, pieces, which, f);
  svg.end_group();
  draw_path(svg, pieces, which, f);
  const Seen seen = seen_in(pieces);
  std::string keys = caption_key("marked", "marking rubbed off") + " ";
  if (seen.inside) keys += caption_key("action", "path of contact") + " ";
  if (seen.edge) keys += caption_key("edge-way", "touched by an edge") + " ";
  if (seen.ellipse) keys += caption_key("instant", "contact ellipse") + " ";
  if (seen.line) keys += caption_key("instant-line", "contact line") + " ";
  return captioned(
      svg.str(), fmt::format("<strong>{}, {}</strong>; the marking covers {} % of it. {}From the "
                             "hollow dot to the full one. {}",
                             name, side_words(report, which),
                             percent(pattern_share(raster, report.marking)), keys, proportions(f)));
}

constexpr std::array<double, 6> kGapLevels{50, 20, 10, 5, 2, 1};  // µm

struct Box {
  Vec2 at;
  bool near(const Vec2& p) const {
    return std::abs(p.x() - at.x()) < 30 && std::abs(p.y() - at.y()) < 19;
  }
};

// A place on a loop for its value: inside the plot, away from the names that stand already; the
// lowest place first, so that the names form a column where they can.
std::optional<Vec2> label_place(const std::vector<std::vector<Vec2>>& loops,
                                const std::function<Vec2(const Vec2&)>& px, const FlankFrame& f,
                                const std::vector<Box>& taken) {
  std::optional<Vec2> best;
  double score = 0.0;
  const double middle = (f.top() + f.bottom()) / 2;
  for (const auto& loop : loops) {
    for (const Vec2& node : loop) {
      const Vec2 p = px(node);
      if (p.x() < f.z.from + 26 || p.x() > f.z.to - 26) continue;
      if (p.y() < f.top() + 10 || p.y() > f.bottom() - 10) continue;
      if (std::any_of(taken.begin(), taken.end(), [&](const Box& b) { return b.near(p); }))
        continue;
      const double s = std::abs(p.y() - middle) - 0.2 * p.x();
      if (best && s >= score) continue;
      best = p;
      score = s;
    }
  }
  return best;
}

}  // namespace

ContourField field_of(const FlankRaster& raster) {
  return {raster.height.size(), raster.diameter.size(), raster.gap};
}

double pattern_share(const FlankRaster& raster, double marking) {
  const double all = static_cast<double>((raster.height.size() - 1) * (raster.diameter.size() - 1));
  return area_of(regions_below(field_of(raster), marking)) / all;
}

namespace {

// How far the contact goes over the flank of gear 1 from one position to the next, mm.
double way_between(const ContactPoint& a, const ContactPoint& b) {
  return std::hypot(b.height[0] - a.height[0], (b.diameter[0] - a.diameter[0]) / 2);
}

// Beyond this it has jumped, as between the two arcs of a flank: many times the usual way between
// positions, and a good part of the face.
double jump_of(const std::vector<const ContactPoint*>& points, const FlankRaster& raster) {
  constexpr double kTimes = 6.0, kPart = 0.1;
  std::vector<double> ways;
  for (std::size_t i = 1; i < points.size(); ++i)
    ways.push_back(way_between(*points[i - 1], *points[i]));
  if (ways.empty() || raster.height.empty()) return std::numeric_limits<double>::infinity();
  const auto middle = ways.begin() + static_cast<std::ptrdiff_t>(ways.size() / 2);
  std::nth_element(ways.begin(), middle, ways.end());
  return std::max(kTimes * *middle, kPart * (raster.height.back() - raster.height.front()));
}

}  // namespace

std::vector<PathPiece> path_on_tooth(const ContactReport& report) {
  const double pitch = pitch_of(report);
  std::vector<const ContactPoint*> points;
  for (const ContactPoint& p : report.driving.positions)
    if (p.kind != TouchKind::none) points.push_back(&p);
  // Pair k does at a rotation what pair 0 did k pitches before.
  const auto own = [&](const ContactPoint* p) { return p->rotation1.rad() - p->pair * pitch; };
  std::sort(points.begin(), points.end(),
            [&](const auto* a, const auto* b) { return own(a) < own(b); });
  const double step = 1.5 * pitch / std::max(1, report.positions);
  const double jump = jump_of(points, report.patterns[0]);
  std::vector<PathPiece> pieces;
  for (const ContactPoint* p : points) {
    const bool edge = is_edge(p->kind);
    const ContactPoint* last = pieces.empty() ? nullptr : pieces.back().points.back();
    const bool on = last && own(p) - own(last) < step && way_between(*last, *p) < jump;
    if (!on || pieces.back().edge != edge) pieces.push_back({edge, {}});
    pieces.back().points.push_back(p);
  }
  return pieces;
}

std::string pattern_figures(const ContactReport& report) {
  const std::vector<PathPiece> pieces = path_on_tooth(report);
  return side_by_side(pattern_figure(report, pieces, 0) + pattern_figure(report, pieces, 1));
}

std::string gap_figure(const ContactReport& report) {
  if (!report.middle) return {};
  const FlankRaster& raster = report.middle_gap;
  const FlankFrame f = frame_of(raster, false, 230.0);
  Svg svg = flank_picture(
      "gap", f, 0, "Gap between the flanks",
      "Contour lines of the gap between both flanks at one position, on the flank of gear 1.");
  const ContourField field = field_of(raster);
  const auto px = nodes_px(raster, f);
  std::vector<std::pair<double, std::vector<std::vector<Vec2>>>> levels;
  for (const double um : kGapLevels) {
    levels.emplace_back(um, regions_below(field, um * kMmPerUm));
    if (!levels.back().second.empty()) svg.path(loops_path(levels.back().second, px), "gap-band");
  }
  if (report.middle->line) svg.polyline(line_px(report, *report.middle, 0, f), "action");
  svg.end_group();
  const Vec2 touch = point_px(*report.middle, 0, f);
  if (!report.middle->line) svg.dot(touch, 4.5, "mark action-dot");
  std::vector<Box> taken{{touch}};
  for (auto it = levels.rbegin(); it != levels.rend(); ++it) {
    const auto place = label_place(it->second, px, f, taken);
    if (!place) continue;
    taken.push_back({*place});
    svg.text(*place, fmt::format("{:g}", it->first), Anchor::middle, "inzone halo", {0.0, 4.0});
  }
  return captioned(
      svg.str(),
      fmt::format(
          "<strong>Gap between the flanks</strong> on gear 1, tooth pair {}, at rotation {}°: "
          "lines where it is 1, 2, 5, 10, 20 and 50 µm, as far as the mating gear reaches. {}",
          pair_words(report.middle->pair), fixed(report.middle->rotation1.deg(), 3),
          caption_key("action", report.middle->line ? "contact line" : "contact point")));
}

std::string pattern_multiples(const ContactReport& report) {
  std::string text;
  constexpr double kSmall = 240.0;
  for (std::size_t i = 0; i < report.under.size(); ++i) {
    const PatternUnder& u = report.under[i];
    const FlankFrame f = frame_of(u.pattern, false, 12, kSmall - 12, 12, 84, 130);
    Svg svg(fmt::format("under{}", i), kSmall, f.bottom() + 12, "Marking pattern: " + u.name,
            "The flank of gear 1 laid flat, the marking pattern on it.");
    svg.rect(f.z.from, f.top(), f.z.to - f.z.from, f.bottom() - f.top(), "flank-ground");
    svg.path(loops_path(regions_below(field_of(u.pattern), report.marking), nodes_px(u.pattern, f)),
             "marked");
    svg.rect(f.z.from, f.top(), f.z.to - f.z.from, f.bottom() - f.top(), "limit");
    const double peak = u.peak_to_peak.arcsec();
    const std::string name = escaped(u.name);
    text += captioned(
        svg.str(),
        (u.as_specified ? "<strong>" + name + "</strong>" : name) + "<br>" +
            (std::isnan(peak) ? "nothing touches" : "peak to peak " + shown_arcsec(peak) + "″"),
        u.as_specified ? " class=\"own\"" : "");
  }
  return text.empty() ? text : "<div class=\"multiples contact\">\n" + text + "</div>\n";
}

}  // namespace gearwright
