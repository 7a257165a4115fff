#include "gearwright/figure/shift_region.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright {

namespace {

struct EdgeLook {
  std::string_view words, style;
};

// The rows are in the order of ShiftEdge.
constexpr std::array<EdgeLook, kShiftEdges> kEdges{{{"least shift of gear 1", "edge-g1"},
                                                    {"greatest shift of gear 1", "edge-g1 far"},
                                                    {"least shift of gear 2", "edge-g2"},
                                                    {"greatest shift of gear 2", "edge-g2 far"},
                                                    {"least centre distance", "edge-c"},
                                                    {"greatest centre distance", "edge-c far"},
                                                    {"contact ratio", "edge-eps"},
                                                    {"effective contact ratio", "edge-true"},
                                                    {"sliding", "edge-slide"},
                                                    {"clearance", "edge-clear"},
                                                    {"interference at gear 1", "edge-hit"},
                                                    {"interference at gear 2", "edge-hit"},
                                                    {"no working pressure angle", "edge-mesh"}}};

// Margins around all limits, and around a region with its labels. Each margin is a fraction of the
// longer side of the limits or of the region.
constexpr double kPadding = 0.17;
constexpr double kZoomPadding = 0.42;
constexpr double kMinWindow = 1e-3;  // modules; if the longer side is shorter, this length is used
constexpr double kMap = 0.19;        // size of the overview map, relative to the width
constexpr double kMapGap = 0.015;  // from the map to the corner of the plot, relative to the width
// Length of a short stretch, divided by the width of the plot. A shorter stretch of an edge is
// named only if it is the longest stretch of this edge.
constexpr double kShortStretch = 0.025;

// Returns the part of the line x1 + x2 = sum inside the window. The result may be empty.
std::vector<Vec2> line_of_sum(const Bounds& box, double sum) {
  const double from = std::max(box.lo.x(), sum - box.hi.y());
  const double to = std::min(box.hi.x(), sum - box.lo.y());
  if (!(from < to)) return {};
  return {{from, sum - from}, {to, sum - to}};
}

std::vector<Vec2> outline_of(const std::vector<RegionEdge>& loop) {
  std::vector<Vec2> points;
  for (const RegionEdge& e : loop) points.insert(points.end(), e.points.begin(), e.points.end());
  return points;
}

std::vector<Vec2> corners_of(const Bounds& box) {
  return {box.lo, {box.hi.x(), box.lo.y()}, box.hi, {box.lo.x(), box.hi.y()}, box.lo};
}

std::string shown_shift(double x) { return fixed(x, 4); }

void add_region(Figure& f, const ShiftChart& chart) {
  for (const auto& loop : chart.loops) f.area(outline_of(loop), "region");
  const bool exact = exact_distance(chart.graph.problem());
  for (const auto& loop : chart.loops) {
    for (const RegionEdge& e : loop) {
      const bool both = exact && e.edge == ShiftEdge::Cmin;
      f.line(e.points, fmt::format("region-edge {}", style_of(e.edge)),
             both ? "exact centre distance" : std::string(words_of(e.edge)));
    }
    // If the limits touch in a single point, the region is this point.
    if (loop.empty()) f.dot(chart.region.lo, 3.0, "region-point");
  }
}

// Names the longest stretch of each edge and all other stretches that are not short. If the centre
// distance is exact, the edges of its least and its greatest value are the same line.
void name_edges(Figure& f, const ShiftChart& chart) {
  const bool exact = exact_distance(chart.graph.problem());
  const double least = kShortStretch * (f.x.hi - f.x.lo);
  std::vector<FigureMark*> edges;
  for (FigureMark& m : f.marks)
    if (m.style.starts_with("region-edge")) edges.push_back(&m);
  std::stable_sort(edges.begin(), edges.end(), [](const FigureMark* a, const FigureMark* b) {
    return length_of(a->points) > length_of(b->points);
  });
  std::vector<std::string> named;
  for (FigureMark* m : edges) {
    const bool first = add_once(named, m->words);
    if (first) {
      std::string style = m->style.substr(m->style.find(' ') + 1);
      if (!(exact && m->words == words_of(ShiftEdge::Cmax)))
        f.keys.push_back({"line " + style, m->words});
    }
    if (!first && length_of(m->points) < least) continue;
    if (exact && m->words == words_of(ShiftEdge::Cmax)) continue;
    m->label = m->words;
    m->label_style = "halo " + m->style.substr(m->style.find(' ') + 1);
    m->border = true;
  }
}

void add_distances(Figure& f, const ShiftGraph& graph, const Bounds& window, bool named) {
  const auto& band = graph.problem().center_distance;
  if (!band) return;
  const std::size_t n = exact_distance(graph.problem()) ? 1 : 2;
  for (std::size_t i = 0; i < n; ++i) {
    const auto sum = sum_at_distance(graph, (*band)[i], window);
    std::vector<Vec2> line = sum ? line_of_sum(window, *sum) : std::vector<Vec2>();
    if (line.empty()) continue;
    f.line(std::move(line), "distance-line");
    if (!named) continue;
    f.marks.back().label = symbol_svg("a") + " = ";
    f.marks.back().length = {(*band)[i], 4, "mm", false};
    f.marks.back().label_style = "halo edge-c";
  }
}

// Draws the line of balanced shifts [T2.18a] through the window. The line is thick where the shifts
// are feasible.
void add_balanced(Figure& f, const ShiftChart& chart, const Bounds& window) {
  const Trial& t = chart.graph.trial();
  const SearchProblem& problem = chart.graph.problem();
  const auto on = [&](double sum) { return balanced_point(t.z1, t.z2, sum, problem.lambda); };
  f.line({on(window.lo.sum()), on(window.hi.sum())}, "balanced-line");
  f.marks.back().label = problem.internal() ? symbol_svg("x_2") + " = 0" : "balanced";
  f.marks.back().label_style = "halo tick";
  for (const Interval& i : chart.region.balanced_sums) f.line({on(i.lo), on(i.hi)}, "balanced");
}

// Draws a small map of all limits, in which the window is marked. The map is in the corner where it
// covers least of the region.
void add_map(Figure& f, const ShiftChart& chart, const Bounds& window) {
  const Bounds limits = limits_box(chart.graph);
  const double size = kMap * window.size().x(), gap = kMapGap * window.size().x();
  const Vec2 lo = window.lo + Vec2(gap, gap), hi = window.hi - Vec2(gap + size, gap + size);
  std::array<Vec2, 4> corners{hi, lo, Vec2(lo.x(), hi.y()), Vec2(hi.x(), lo.y())};
  const auto crowd = [&](const Vec2& corner) {
    int n = 0;
    for (const auto& loop : chart.loops) {
      for (const Vec2& p : outline_of(loop)) {
        const Vec2 d = p - corner;
        if (d.minCoeff() > -gap && d.maxCoeff() < size + gap) ++n;
      }
    }
    return n;
  };
  const Vec2 at =
      *std::min_element(corners.begin(), corners.end(),
                        [&](const Vec2& a, const Vec2& b) { return crowd(a) < crowd(b); });
  const double scale = size / (1.24 * limits.size().maxCoeff());
  const Vec2 from = (limits.lo + limits.hi) / 2, to = at + Vec2(size, size) / 2;
  const auto on_map = [&](std::vector<Vec2> points) {
    for (Vec2& p : points)
      p = (to + scale * (p - from)).cwiseMax(at).cwiseMin(at + Vec2(size, size));
    return points;
  };
  f.bar(at, at + Vec2(size, size), "region-map");
  f.marks.back().border = true;
  f.line(on_map(corners_of(limits)), "limits-box");
  for (const auto& loop : chart.loops) {
    const std::vector<Vec2> outline = on_map(outline_of(loop));
    if (outline.size() > 1) f.line(outline, "region-small");
  }
  f.dot(on_map({(chart.region.lo + chart.region.hi) / 2})[0], 2.0, "region-point");
  f.line(on_map(corners_of(window)), "region-frame");
}

}  // namespace

std::string_view words_of(ShiftEdge edge) { return kEdges[static_cast<std::size_t>(edge)].words; }

std::string_view style_of(ShiftEdge edge) { return kEdges[static_cast<std::size_t>(edge)].style; }

Bounds limits_box(const ShiftGraph& graph) {
  const auto& [g_1, g_2] = graph.gears();
  return {{g_1.x_min, g_2.x_min}, {g_1.x_max, g_2.x_max}};
}

RegionWindow region_window(const Bounds& limits, const Bounds& region, double aspect,
                           double fair_part) {
  const bool zoomed = region.size().maxCoeff() < fair_part * limits.size().maxCoeff();
  Bounds box = region;
  double pad = kZoomPadding * std::max(region.size().maxCoeff(), kMinWindow);
  if (!zoomed) {
    box.cover(limits.lo);
    box.cover(limits.hi);
    pad = kPadding * std::max(box.size().maxCoeff(), kMinWindow);
  }
  const Vec2 size = box.size() + 2 * Vec2(pad, pad);
  const double height = std::max(size.y(), size.x() / aspect);
  const Vec2 half(aspect * height / 2, height / 2);
  const Vec2 middle = (box.lo + box.hi) / 2;
  return {{middle - half, middle + half}, zoomed};
}

std::optional<double> sum_at_distance(const ShiftGraph& graph, double a, const Bounds& window) {
  const double module = graph.trial().module;
  const double lo = window.lo.sum();
  const double hi = window.hi.sum();
  if (!(lo < hi)) return std::nullopt;
  const auto more = [&](double sum) { return module * std::abs(graph.place(sum).a) - a; };
  const Root root = find_root(more, lo, hi);
  return root.found() ? std::optional(root.x) : std::nullopt;
}

bool exact_distance(const SearchProblem& problem) {
  const auto& band = problem.center_distance;
  return band && (*band)[0] == (*band)[1];
}

ShiftChart shift_chart(const ShiftGraph& graph, const Vec2& design) {
  auto region = shift_region(graph);
  GW_EXPECTS(region.has_value());
  ShiftChart chart{graph, *std::move(region), {}, {}};
  chart.loops = region_boundary(graph, chart.region);
  for (const Vec2& p : {design, chart.region.lo, chart.region.hi}) chart.around.cover(p);
  for (const auto& loop : chart.loops)
    for (const Vec2& p : outline_of(loop)) chart.around.cover(p);
  return chart;
}

Figure shift_limits_figure(const ShiftGraph& graph, const Bounds& window) {
  Figure f{"region",
           "Profile shifts within the limits",
           "The profile shift of gear 1 increases to the right, and the profile shift of gear 2 "
           "increases upwards, in modules. No shifts are feasible.",
           "",
           {"profile shift of gear 1", ""},
           {"profile shift of gear 2", ""}};
  f.x.symbol = "x_1";
  f.y.symbol = "x_2";
  f.x.lo = window.lo.x();
  f.x.hi = window.hi.x();
  f.y.lo = window.lo.y();
  f.y.hi = window.hi.y();
  f.tall = window.size().y() / window.size().x();
  f.line(corners_of(limits_box(graph)), "limits-box");
  add_distances(f, graph, window, true);
  return f;
}

std::string region_words(const ShiftRegion& region) {
  return fmt::format(
      "The profile shift of gear 1 increases to the right, and the profile shift of gear 2 "
      "increases upwards, in modules. The feasible region has the area {:.4g}. It extends from "
      "({}, {}) at the least sum of the profile shifts to ({}, {}) at the greatest sum.",
      region.area, shown_shift(region.lo.x()), shown_shift(region.lo.y()),
      shown_shift(region.hi.x()), shown_shift(region.hi.y()));
}

Figure shift_region_figure(const ShiftChart& chart, const RegionWindow& window) {
  const ShiftRegion& region = chart.region;
  Figure f = shift_limits_figure(chart.graph, window.box);
  f.description = region_words(region);
  add_region(f, chart);
  name_edges(f, chart);
  add_balanced(f, chart, window.box);
  if (window.zoomed) add_map(f, chart, window.box);
  f.point(region.lo, 3.5, "mark", "min " + symbol_svg("Σx"), {-12.0, 12.0});
  f.marks.back().label_style = "halo tick";
  f.point(region.hi, 3.5, "mark", "max " + symbol_svg("Σx"), {12.0, -12.0});
  f.marks.back().label_style = "halo tick";
  return f;
}

Figure small_shift_region(const ShiftChart& chart, const Bounds& window) {
  Figure f = plane_figure("region-small", "", "", window);
  f.line(corners_of(limits_box(chart.graph)), "limits-box");
  add_distances(f, chart.graph, window, false);
  add_region(f, chart);
  for (FigureMark& m : f.marks) m.words.clear();
  return f;
}

Figure exchanged(Figure f) {
  const auto swap_words = [](std::string& words) {
    for (const auto& [one, two] :
         {std::pair(words_of(ShiftEdge::s1min), words_of(ShiftEdge::s2min)),
          std::pair(words_of(ShiftEdge::s1max), words_of(ShiftEdge::s2max)),
          std::pair(words_of(ShiftEdge::interference1), words_of(ShiftEdge::interference2))}) {
      if (words == one)
        words = two;
      else if (words == two)
        words = one;
    }
  };
  const auto swap_style = [](std::string& style) {
    const std::size_t at = style.find("edge-g");
    if (at != style.npos && (style[at + 6] == '1' || style[at + 6] == '2'))
      style[at + 6] = style[at + 6] == '1' ? '2' : '1';
  };
  std::swap(f.x.lo, f.y.lo);
  std::swap(f.x.hi, f.y.hi);
  f.tall = 1.0 / f.tall;
  for (FigureMark& m : f.marks) {
    for (Vec2& p : m.points) p = Vec2(p.y(), p.x());
    // The outside of a border is on its right, so the mirrored borders are reversed.
    if (m.border && m.kind == FigureMark::Kind::line)
      std::reverse(m.points.begin(), m.points.end());
    for (std::string* words : {&m.words, &m.label}) swap_words(*words);
    for (std::string* style : {&m.style, &m.label_style}) swap_style(*style);
  }
  for (FigureKey& key : f.keys) {
    swap_words(key.words);
    swap_style(key.style);
  }
  return f;
}

}  // namespace gearwright
