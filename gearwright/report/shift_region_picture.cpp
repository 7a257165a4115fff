#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/search_figures.hpp"
#include "gearwright/report/search_words.hpp"
#include "gearwright/report/shift_region_drawing.hpp"

namespace gearwright {

namespace {

constexpr double kWidth = 640.0;
constexpr double kHeight = 540.0;
constexpr PixelBox kPlot{72.0, 36.0, kWidth - 14.0, kHeight - 54.0};
constexpr double kSmallWidth = 200.0;
constexpr double kSmallHeight = 170.0;
constexpr double kFairPart = 0.62;  // of the rectangle: a region at least this long is shown in it
constexpr double kSmallFairPart = 0.12;  // the small ones are side by side, so one scale is
                                         // preferred
constexpr double kMap = 104.0;           // px, the small map of the whole
constexpr double kShortStretch = 14.0;   // px: a shorter stretch is named only if there is no
                                         // longer one

std::vector<Vec2> corners_of(const Bounds& box) {
  return {box.lo, {box.hi.x(), box.lo.y()}, box.hi, {box.lo.x(), box.hi.y()}, box.lo};
}

double length_of(const std::vector<Vec2>& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

// The point of a line at a share of its length, and the direction there.
std::pair<Vec2, Vec2> at_share(const std::vector<Vec2>& line, double share) {
  double left = share * length_of(line);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 d = line[i] - line[i - 1];
    const double length = d.norm();
    if (length > 0.0 && (left <= length || i + 1 == line.size()))
      return {line[i - 1] + d * std::min(1.0, left / length), d / length};
    left -= length;
  }
  return {line.front(), {1.0, 0.0}};
}

bool inside(const std::vector<Vec2>& polygon, const Vec2& p) {
  bool is = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) is = !is;
  }
  return is;
}

// Places next to a stretch, first on the side away from the region, which is its right because the
// boundary runs counter-clockwise. Places on the other side must be within the region, so that the
// edge of a narrow region is not confused with the opposite one.
std::vector<LabelPlace> places_beside(const std::vector<Vec2>& px, const std::vector<Vec2>& loop) {
  std::vector<LabelPlace> places;
  for (const double distance : {11.0, 24.0, -12.0, 38.0, -26.0}) {
    for (const double share : {0.5, 0.35, 0.65, 0.2, 0.8, 0.05, 0.95}) {
      const auto [at, along] = at_share(px, share);
      const Vec2 out = (distance < 0 ? -1.0 : 1.0) * Vec2(-along.y(), along.x());  // y down
      const Anchor anchor = out.x() > 0.3    ? Anchor::start
                            : out.x() < -0.3 ? Anchor::end
                                             : Anchor::middle;
      const LabelPlace place{at, std::abs(distance) * out, anchor};
      if (distance > 0 || inside(loop, place.at + place.offset)) places.push_back(place);
    }
  }
  return places;
}

// The longest stretch of each kind in each piece is named, and all that are not short; at one exact
// centre distance both its edges are one line.
void name_edges(Svg& svg, FreeLabels& labels, const GraphFrame& g, const Loops& loops, bool exact) {
  struct Stretch {
    ShiftEdge edge;
    std::vector<Vec2> px, loop;
    double length;
  };
  std::vector<Stretch> stretches;
  for (const auto& loop : loops) {
    const std::vector<Vec2> outline = g.px(outline_of(loop));
    for (const RegionEdge& e : loop) {
      if (exact && e.edge == ShiftEdge::Cmax) continue;
      const std::vector<Vec2> px = g.px(e.points);
      stretches.push_back({e.edge, px, outline, length_of(px)});
    }
  }
  std::stable_sort(stretches.begin(), stretches.end(),
                   [](const Stretch& a, const Stretch& b) { return a.length > b.length; });
  std::vector<ShiftEdge> named;
  for (const Stretch& s : stretches) {
    const bool again = std::find(named.begin(), named.end(), s.edge) != named.end();
    if (again && s.length < kShortStretch) continue;
    const std::string_view words =
        exact && s.edge == ShiftEdge::Cmin ? "exact centre distance" : words_of(s.edge);
    const std::string style = fmt::format("halo {}", style_of(s.edge));
    if (labels.draw(svg, words, escaped(words), style, places_beside(s.px, s.loop),
                    FreeLabels::If::over_a_line))
      named.push_back(s.edge);
  }
}

std::string shown_shift(double x) { return fixed(x, 4); }

std::string edge_key(const Loops& loops, bool exact) {
  std::array<bool, kShiftEdges> there{};
  for (const auto& loop : loops)
    for (const RegionEdge& e : loop) there[static_cast<std::size_t>(e.edge)] = true;
  if (exact && there[static_cast<std::size_t>(ShiftEdge::Cmin)])
    there[static_cast<std::size_t>(ShiftEdge::Cmax)] = false;
  std::string key;
  for (std::size_t i = 0; i < kShiftEdges; ++i) {
    if (!there[i]) continue;
    const auto edge = static_cast<ShiftEdge>(i);
    const bool both = exact && edge == ShiftEdge::Cmin;
    key += caption_key(fmt::format("line {}", style_of(edge)),
                       both ? "exact centre distance" : words_of(edge)) +
           " ";
  }
  return key;
}

// The whole rectangle in a free corner, with the window in it.
void draw_map(Svg& svg, FreeLabels& labels, const GraphFrame& g, const Loops& loops,
              const Bounds& limits, const ShiftRegion& region) {
  constexpr double kGap = 8.0;
  const double left = kPlot.left + kGap;
  const double right = kPlot.right - kGap - kMap;
  const double top = kPlot.top + kGap;
  const double bottom = kPlot.bottom - kGap - kMap;
  const std::array<Vec2, 4> corners{Vec2(right, top), Vec2(left, bottom), Vec2(left, top),
                                    Vec2(right, bottom)};
  const auto crowd = [&](const Vec2& corner) {
    int n = 0;
    for (const auto& loop : loops) {
      for (const Vec2& p : g.px(outline_of(loop))) {
        const Vec2 d = p - corner;
        if (d.minCoeff() > -kGap && d.maxCoeff() < kMap + kGap) ++n;
      }
    }
    return n;
  };
  const Vec2 at =
      *std::min_element(corners.begin(), corners.end(),
                        [&](const Vec2& a, const Vec2& b) { return crowd(a) < crowd(b); });
  const PixelBox place{at.x(), at.y(), at.x() + kMap, at.y() + kMap};
  svg.rect(at.x(), at.y(), kMap, kMap, "region-map");
  const double pad = 0.12 * limits.size().maxCoeff();
  const double half = limits.size().maxCoeff() / 2 + pad;
  const Vec2 middle = (limits.lo + limits.hi) / 2;
  const GraphFrame small = frame_on({middle - Vec2(half, half), middle + Vec2(half, half)}, place);
  svg.begin_clip(at.x(), at.y(), kMap, kMap);
  draw_box(svg, small, limits, "limits-box");
  for (const auto& loop : loops) {
    const std::vector<Vec2> outline = small.px(outline_of(loop));
    if (outline.size() > 1) svg.polyline(outline, "region-small");
  }
  svg.dot(small.px((region.lo + region.hi) / 2), 2.0, "region-point");
  draw_box(svg, small, g.box(), "region-frame");
  svg.end_group();
  labels.keep_off({place.left - 3, place.top - 3, place.right + 3, place.bottom + 3});
}

struct Drawn {
  const ShiftGraph& graph;
  const DesignRow& row;
  ShiftRegion region;
  Loops loops;
  Bounds limits, around;  ///< around the region and the design
};

Drawn drawn_of(const ShiftGraph& graph, const DesignRow& row) {
  auto region = shift_region(graph);
  GW_EXPECTS(region.has_value());
  Drawn d{graph, row, *std::move(region), {}, limits_box(graph), {}};
  d.loops = region_boundary(graph, d.region);
  d.around = {{row.shift[0], row.shift[1]}, {row.shift[0], row.shift[1]}};
  d.around.cover(d.region.lo);
  d.around.cover(d.region.hi);
  for (const auto& loop : d.loops)
    for (const Vec2& p : outline_of(loop)) d.around.cover(p);
  return d;
}

// The line of Eq. 11 through the window, thick where it is feasible; returns its dashes in px.
std::vector<Vec2> draw_balanced(Svg& svg, const Drawn& d, const GraphFrame& g) {
  const Trial& t = d.row.trial;
  const double lambda = d.graph.problem().lambda;
  const Bounds box = g.box();
  const auto on = [&](double sum) { return g.px(balanced_point(t.z1, t.z2, sum, lambda)); };
  const double lo = box.lo.sum();
  const double hi = box.hi.sum();
  const std::vector<Vec2> line{on(lo), on(hi)};
  svg.polyline(line, "balanced-line");
  for (const Interval& i : d.region.balanced_sums) svg.polyline({on(i.lo), on(i.hi)}, "balanced");
  return line;
}

std::string description(const Drawn& d) {
  return fmt::format(
      "Profile shift of gear 1 to the right, of gear 2 up, in modules. The feasible region has the "
      "area {:.4g}, from {}, {} at the least sum to {}, {} at the greatest; the design stands at "
      "{}, {}.",
      d.region.area, shown_shift(d.region.lo.x()), shown_shift(d.region.lo.y()),
      shown_shift(d.region.hi.x()), shown_shift(d.region.hi.y()), shown_shift(d.row.shift[0]),
      shown_shift(d.row.shift[1]));
}

std::string big_svg(const Drawn& d) {
  const double aspect = (kPlot.right - kPlot.left) / (kPlot.bottom - kPlot.top);
  const RegionWindow window = region_window(d.limits, d.around, aspect, kFairPart);
  const GraphFrame g = frame_on(window.box, kPlot);
  const bool exact = exact_distance(d.graph.problem());
  Svg svg("region", kWidth, kHeight, "Feasible profile shifts of " + design_name(d.row.trial),
          description(d));
  svg.text({12, 22}, "profile shift of gear 2, " + symbol_svg("x_2"), Anchor::start, "panel");
  draw_rows(svg, g.x, g.y, 7);
  draw_foot(svg, g.x, kPlot.top, kPlot.bottom, 7, "profile shift of gear 1, " + symbol_svg("x_1"));

  FreeLabels labels({kPlot.left + 2, kPlot.top + 2, kPlot.right - 2, kPlot.bottom - 2});
  svg.begin_clip(kPlot.left, kPlot.top, kPlot.right - kPlot.left, kPlot.bottom - kPlot.top);
  draw_box(svg, g, d.limits, "limits-box");
  const std::vector<DistanceLine> distances = draw_distances(svg, d.graph, g);
  draw_region(svg, g, d.loops, d.region);
  const std::vector<Vec2> balanced = draw_balanced(svg, d, g);
  svg.end_group();
  if (window.zoomed) draw_map(svg, labels, g, d.loops, d.limits, d.region);

  for (const auto& loop : d.loops)
    for (const RegionEdge& e : loop) labels.keep_off(g.px(e.points));
  labels.keep_off(balanced);
  labels.keep_off(g.px(corners_of(d.limits)));
  for (const DistanceLine& line : distances) labels.keep_off(line.px);
  const Vec2 lo = g.px(d.region.lo);
  const Vec2 hi = g.px(d.region.hi);
  const Vec2 own = g.px({d.row.shift[0], d.row.shift[1]});
  for (const Vec2& p : {lo, hi, own}) labels.keep_off({p.x() - 6, p.y() - 6, p.x() + 6, p.y() + 6});

  svg.dot(lo, 3.5, "mark");
  svg.dot(hi, 3.5, "mark");
  svg.dot(own, 7.0, "design-ring");
  svg.dot(own, 2.5, "design-dot");
  const Vec2 up_right = Vec2(1, -1).normalized();
  labels.draw(svg, "design", "design", "halo letter here", places_around(own, 12, {1, 0}),
              FreeLabels::If::always);
  name_edges(svg, labels, g, d.loops, exact);
  const std::string sum = symbol_svg("Σx");
  labels.draw(svg, "min Σx", "min " + sum, "halo tick", places_around(lo, 9, -up_right),
              FreeLabels::If::over_a_line);
  labels.draw(svg, "max Σx", "max " + sum, "halo tick", places_around(hi, 9, up_right),
              FreeLabels::If::over_a_line);
  for (const DistanceLine& line : distances) {
    const std::string value = fmt::format(" = {:.10g}", line.distance);
    std::vector<LabelPlace> places;
    for (const double share : {0.02, 0.98, 0.1, 0.9, 0.2, 0.8, 0.3, 0.7}) {
      const Vec2 at = at_share(line.px, share).first;
      places.push_back({at, {7, -9}, Anchor::start});
      places.push_back({at, {-7, 9}, Anchor::end});
    }
    labels.draw(svg, "a" + value, symbol_svg("a") + value, "halo edge-c", places,
                FreeLabels::If::free);
  }
  std::vector<LabelPlace> places;
  for (const double share : {0.94, 0.06, 0.85, 0.15, 0.75, 0.25}) {
    const Vec2 at = at_share(balanced, share).first;
    for (const LabelPlace& p : places_around(at, 9, up_right)) places.push_back(p);
  }
  const bool ring = d.graph.problem().internal();
  const std::string line = ring ? symbol_svg("x_2") + " = 0" : "balanced";
  labels.draw(svg, ring ? "x2 = 0" : line, line, "halo tick", places, FreeLabels::If::free);
  return svg.str();
}

}  // namespace

std::string shift_region_figure(const ShiftGraph& graph, const DesignRow& row) {
  const Drawn d = drawn_of(graph, row);
  const bool distance = graph.problem().center_distance.has_value();
  const std::string area = d.region.area >= 0.01 ? "area " + fixed(d.region.area, 4)
                           : d.region.area > 0.0
                               ? fmt::format("area {:.3g}", d.region.area)
                               : std::string("without area: the limits leave a line or a point");
  const std::string key = edge_key(d.loops, exact_distance(graph.problem()));
  const std::string line =
      graph.problem().internal()
          ? std::string("the pinion takes all of the shift")
          : fmt::format("balanced, the teeth of both gears are about equally strong ({} = {:g})",
                        symbol_html("λ"), graph.problem().lambda);
  return captioned(
      big_svg(d),
      fmt::format(
          "<strong>Where {} is feasible</strong>: the filled region, in normal modules, {}; "
          "faint: the rectangle of the shift limits. {}{}{}Thin dashed: {}; thick where that "
          "is feasible. Dots: the middles at the least and the greatest {}. Ringed: the "
          "design.",
          design_name(row.trial), area, key.empty() ? "" : "Its edges: ", key,
          distance ? "Thin: the centre distances, mm. " : "", line, symbol_html("Σx")));
}

std::string shift_region_thumbnail(const ShiftGraph& graph, const DesignRow& row,
                                   std::string_view id, std::string_view row_link) {
  const Drawn d = drawn_of(graph, row);
  constexpr PixelBox kAll{0.0, 0.0, kSmallWidth, kSmallHeight};
  const RegionWindow window =
      region_window(d.limits, d.around, kSmallWidth / kSmallHeight, kSmallFairPart);
  const GraphFrame g = frame_on(window.box, kAll);
  const std::string name = design_name(row.trial);
  Svg svg(id, kSmallWidth, kSmallHeight, "Feasible profile shifts of " + name, description(d));
  draw_box(svg, g, d.limits, "limits-box");
  draw_distances(svg, graph, g);
  draw_region(svg, g, d.loops, d.region);
  svg.dot(g.px({row.shift[0], row.shift[1]}), 4.0, "design-small");
  return captioned(svg.str(),
                   fmt::format("<strong><a href=\"{}\">{}</a></strong><br>{} {}", row_link, name,
                               symbol_html("ε_α"), fixed(row.contact_ratio, 3)));
}

}  // namespace gearwright
