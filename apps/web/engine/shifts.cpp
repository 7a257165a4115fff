// Computes the x1–x2 chart of the pair of a session. The chart is the same as for a search that
// permits only the tooth numbers of this pair.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "apps/web/engine/session.hpp"
#include "gearwright/design/search.hpp"
#include "gearwright/design/shift_region.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/shift_region.hpp"
#include "gearwright/report/search_table.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/read_search.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright::web {

namespace {

// Returns the problem of a search with a single trial. Its limits come from [search] in the spec or
// are defaults. If `swapped` is true, gear 2 has fewer teeth and is gear 1 of the search.
Result<SearchProblem> problem_of(const SolvedJob& job, bool swapped) {
  const Json& tree = job.spec.tree->tables;
  const std::array<const Gear*, 2> g{&job.gears[swapped ? 1 : 0], &job.gears[swapped ? 0 : 1]};
  Json search = tree.contains("search") ? tree["search"] : Json::object();
  for (const char* key :
       {"iso54_series", "helix_angles_deg", "helix_step_deg", "overlap_ratio", "racks", "objective",
        "center_distance_mm", "shift_step", "target_ratio", "coprime"})
    search.erase(key);
  const double ratio = static_cast<double>(g[1]->spec.teeth) / g[0]->spec.teeth;
  search["ratio"] = {ratio, ratio};
  search["modules_mm"] = {g[0]->spec.normal_module};
  search["pinion_teeth"] = {std::abs(g[0]->spec.teeth), std::abs(g[0]->spec.teeth)};
  search["helix_angle_deg"] = g[0]->spec.helix_angle.deg();
  if (job.pair->crossed()) search["shaft_angle_deg"] = job.pair->shaft_angle().deg();
  std::array<Json, 2> blanks{Json::object(), Json::object()};
  for (const std::size_t i : {0, 1}) {
    const char* table = (i == 0) != swapped ? "gear1" : "gear2";
    if (!tree.contains(table)) continue;
    for (const Key& key : blank_keys().keys) {
      const std::string name(key.key);
      if (tree[table].contains(name)) blanks[i][name] = tree[table][name];
    }
    blanks[i].erase("helix_angle_deg");
    blanks[i]["normal_pressure_angle_deg"] = g[i]->spec.normal_pressure_angle.deg();
  }
  try {  // with one face width, the units have no effect
    return read_search(search, &blanks[0], &blanks[1], UnitSystem::mm);
  } catch (const SpecError& e) {
    return e.error;
  }
}

ShiftEdge swapped_edge(ShiftEdge edge) {
  switch (edge) {
    case ShiftEdge::s1min: return ShiftEdge::s2min;
    case ShiftEdge::s1max: return ShiftEdge::s2max;
    case ShiftEdge::s2min: return ShiftEdge::s1min;
    case ShiftEdge::s2max: return ShiftEdge::s1max;
    case ShiftEdge::interference1: return ShiftEdge::interference2;
    case ShiftEdge::interference2: return ShiftEdge::interference1;
    default: return edge;
  }
}

// The border nearest to a point, and its distance in modules.
struct Nearest {
  std::string border;
  double distance = std::numeric_limits<double>::infinity();

  void look_at(const std::string& name, const std::vector<Vec2>& line, const Vec2& p) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vec2 &a = line[i - 1], &b = line[i];
      const double square = (b - a).squaredNorm();
      const double t = square > 0.0 ? std::clamp((p - a).dot(b - a) / square, 0.0, 1.0) : 0.0;
      const double away = (p - a - t * (b - a)).norm();
      if (away < distance) *this = {name, away};
    }
  }
};

// Returns the window given by the view, or `otherwise` if none is given. While the user drags the
// point, the page requests the same window again.
Bounds window_of(const ShiftView& view, bool swapped, const Bounds& otherwise) {
  if (!view.window) return otherwise;
  const auto turned = [&](const Vec2& p) { return swapped ? Vec2(p.y(), p.x()) : p; };
  return {turned(view.window->lo), turned(view.window->hi)};
}

// Returns the figure for a graph without a region. It shows the rectangle of the limits.
Figure limits_figure(const ShiftGraph& graph, const Vec2& design, bool swapped,
                     const ShiftView& view) {
  Bounds around;
  around.cover(design);
  const Bounds limits = limits_box(graph);
  for (const Vec2& p : {limits.lo, limits.hi}) around.cover(p);
  const double aspect = swapped ? 1.0 / view.aspect : view.aspect;
  const Figure f = shift_limits_figure(
      graph, window_of(view, swapped, region_window(limits, around, aspect, 0.0).box));
  return swapped ? exchanged(f) : f;
}

// Returns the figure without the point of the design. The page draws this point itself, because the
// user can drag it.
Figure chart_figure(const ShiftGraph& graph, const Vec2& design, bool swapped,
                    const ShiftView& view) {
  // If the region extends over at least this fraction of the rectangle of limits, the figure shows
  // the whole rectangle.
  constexpr double kFairPart = 0.62;
  const ShiftChart chart = shift_chart(graph, design);
  const double aspect = swapped ? 1.0 / view.aspect : view.aspect;
  RegionWindow window = region_window(limits_box(graph), chart.around, aspect, kFairPart);
  window.box = window_of(view, swapped, window.box);
  Figure f = shift_region_figure(chart, window);
  f.point(chosen_point(graph, chart.region), 5.0, "mark hollow", "choice of a search",
          {12.0, 12.0});
  f.marks.back().label_style = "halo tick";
  if (swapped) f = exchanged(std::move(f));
  f.caption = ". Edges of the region:";
  return f;
}

}  // namespace

Result<Json> Session::shift_region(const std::optional<ShiftView>& view) const {
  if (auto error = two_gears_error(job_.spec)) return *error;
  if (!job_.pair) return absent_input("gear2", "; the chart shows the profile shifts of two gears");
  if (!job_.pair->involute())
    return Error{"gear1.rack.kind", "", "has circular arcs, which have no profile shifts"};
  const bool swapped = std::abs(job_.gears[1].spec.teeth) < job_.gears[0].spec.teeth;
  const auto problem = problem_of(job_, swapped);
  if (!problem) return problem.error();
  const Search search(*problem);
  if (search.space().size().value_or(0) < 1) {
    return Error{"gear1.teeth", "", "a search needs a gear 2 with more teeth than gear 1"};
  }
  const ShiftGraph graph = search.graph(search.space().trial(0));
  const Vec2 point(job_.gears[0].spec.profile_shift, job_.gears[1].spec.profile_shift);
  const Vec2 asked = swapped ? Vec2(point.y(), point.x()) : point;
  // `room` is the least margin over all limits. The limits have different units, so only two facts
  // are used: the sign of `room`, and whether `room` is nearly 0.
  const auto range = graph.sums();
  const double room = range.lo <= range.hi ? graph.margin(asked.x(), asked.y())
                                           : -std::numeric_limits<double>::infinity();
  const bool inside = room >= 0.0 && std::isfinite(asked.x() + asked.y());
  const auto killed = graph.what_kills();
  Json chart{{"point", {point.x(), point.y()}},
             {"inside", inside},
             {"margin", -std::numeric_limits<double>::infinity()},
             {"stoppedBy", ""},
             {"borders", Json::object()},
             {"figure", nullptr},
             {"whatKills", killed ? words_of(*killed) : ""}};
  const auto region = gearwright::shift_region(graph);
  if (!region) {
    if (view) chart["figure"] = drawn(limits_figure(graph, asked, swapped, *view), view->width);
    return chart;
  }
  std::map<std::string, std::string> borders;
  Nearest nearest;
  for (const auto& loop : region_boundary(graph, *region)) {
    for (const RegionEdge& edge : loop) {
      const ShiftEdge which = swapped ? swapped_edge(edge.edge) : edge.edge;
      const std::string border(name(which));
      nearest.look_at(border, edge.points, asked);
      borders[border] = words_of(which);
    }
  }
  if (view) chart["figure"] = drawn(chart_figure(graph, asked, swapped, *view), view->width);
  constexpr double kAtWall = 1e-6;  // modules; smaller than the accuracy of any profile shift
  chart["margin"] = inside ? nearest.distance : -nearest.distance;
  if (room < kAtWall) chart["stoppedBy"] = nearest.border;
  chart["borders"] = borders;
  return chart;
}

}  // namespace gearwright::web
