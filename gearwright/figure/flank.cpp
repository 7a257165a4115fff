#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/figure/contact_figures.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {

namespace {

constexpr int kEllipses = 7;                           // approximate number of drawn ellipses
constexpr double kLowFlank = 0.36, kHighFlank = 0.72;  // limits of the ratio of height to width
constexpr double kBeyond = 0.09;  // height drawn beyond root and tip, relative to the flank
const std::vector<double> kGapLevels{1, 2, 5, 10, 20, 50};  // µm, greatest gaps of the drawn bands

Vec2 on_flank(const FlankPlace& place) { return {place.height, 2 * place.radius}; }
Vec2 touch_of(const ContactPoint& p, std::size_t which) {
  return {p.height[which], p.diameter[which]};
}

// A contact line is straight in space but curved on a developed flank.
std::vector<Vec2> contact_line(const ContactScene& scene, const ContactPoint& p,
                               std::size_t which) {
  constexpr int kSteps = 12;
  std::vector<Vec2> points;
  for (int k = 0; k <= kSteps; ++k) {
    const Vec3 at =
        (*p.line)[0] + (static_cast<double>(k) / kSteps) * ((*p.line)[1] - (*p.line)[0]);
    points.push_back(on_flank(place_on(scene.axes[which], at)));
  }
  return points;
}

void add_instants(Figure& f, const ContactScene& scene, const std::vector<PathPiece>& pieces,
                  std::size_t which) {
  std::size_t count = 0;
  for (const PathPiece& piece : pieces) count += piece.edge ? 0 : piece.points.size();
  const std::size_t step = std::max<std::size_t>(1, count / kEllipses);
  std::size_t i = step / 2;
  for (const PathPiece& piece : pieces) {
    if (piece.edge) continue;
    for (const ContactPoint* p : piece.points) {
      if (i++ % step != 0) continue;
      std::vector<Vec2> line;
      if (p->line) line = contact_line(scene, *p, which);
      if (!p->line)
        for (const FlankPlace& at : ellipse_on(scene, *p, which)) line.push_back(on_flank(at));
      if (line.empty()) continue;
      if (p->line)
        f.line(std::move(line), "instant");
      else
        f.area(std::move(line), "instant");
    }
  }
}

void add_way(Figure& f, const std::vector<PathPiece>& pieces, std::size_t which) {
  bool edge = false, inside = false, line = false, ellipse = false;
  for (const PathPiece& piece : pieces) {
    std::vector<Vec2> way;
    for (const ContactPoint* p : piece.points) {
      way.push_back(touch_of(*p, which));
      line = line || p->line;
      ellipse = ellipse || (!p->line && p->ellipse && p->ellipse->semi_major);
    }
    (piece.edge ? edge : inside) = true;
    if (way.size() > 1)
      f.line(std::move(way), piece.edge ? "edge-way" : "action");
    else
      f.dot(way.front(), 2.2, piece.edge ? "edge-dot" : "mark action-dot");
  }
  if (inside) f.keys.push_back({"action", "path of contact"});
  if (edge) f.keys.push_back({"edge-way", "edge contact"});
  if (ellipse) f.keys.push_back({"instant", "contact ellipse"});
  if (line) f.keys.push_back({"instant-line", "contact line"});
  if (pieces.empty()) return;
  f.dot(touch_of(*pieces.front().points.front(), which), 5.0, "way-begin", "start of the mesh");
  f.dot(touch_of(*pieces.back().points.back(), which), 4.5, "mark", "end of the mesh");
}

std::string side_words(const ContactScene& scene, std::size_t which) {
  const Gear& gear = *scene.gears[which];
  return fmt::format(
      "{} flank{}", gear.left_flank_works(scene.gear2_drives) ? "left" : "right",
      gear.internal() ? " of the internal gear (whose tip is at the smaller diameter)" : "");
}

// Draws the gap in bands. If `named`, the value of each band is written on it.
void add_gap(Figure& f, const FlankRaster& raster, bool named, const Vec2& touch) {
  const ContourField field = field_of(raster);
  // The written values keep a distance from each other, from the contact and from the edges of the
  // plot. Distances are fractions of the plot.
  const auto share = [&](const Vec2& p) -> Vec2 {
    return {(p.x() - f.x.lo) / (f.x.hi - f.x.lo), (p.y() - f.y.lo) / (f.y.hi - f.y.lo)};
  };
  std::vector<Vec2> taken{share(touch)};
  std::vector<std::pair<double, std::vector<Vec2>>> bands;
  for (std::size_t i = kGapLevels.size(); i-- > 0;) {
    bands.emplace_back(kGapLevels[i], region_below(raster, field, kGapLevels[i] * kMmPerUm));
    f.area(bands.back().second, "gap-band", step_words(kGapLevels, i, "µm"));
  }
  f.grid = FigureGrid{"gap", "µm", raster.height, raster.diameter, raster.gap};
  for (double& gap : f.grid->values) gap *= kUmPerMm;
  for (auto band = bands.rbegin(); named && band != bands.rend(); ++band) {
    std::optional<Vec2> best;
    double score = 0.0;
    for (const Vec2& p : band->second) {
      const Vec2 at = share(p);
      if (!(at.x() > 0.06 && at.x() < 0.94 && at.y() > 0.14 && at.y() < 0.86)) continue;
      const auto near = [&](const Vec2& o) {
        return std::abs(o.x() - at.x()) < 0.07 && std::abs(o.y() - at.y()) < 0.11;
      };
      if (std::any_of(taken.begin(), taken.end(), near)) continue;
      const double s = 0.5 * std::abs(at.y() - 0.5) - 0.2 * at.x();
      if (best && s >= score) continue;
      best = p;
      score = s;
    }
    if (!best) continue;
    taken.push_back(share(*best));
    f.text(*best, "", Anchor::middle, "inzone halo", {0.0, 4.0});
    f.marks.back().length = {band->first, 0, "µm"};
  }
}

// Returns the distance, mm, between the contacts at successive positions on the flank of gear 1.
double way_between(const ContactPoint& a, const ContactPoint& b) {
  return std::hypot(b.height[0] - a.height[0], (b.diameter[0] - a.diameter[0]) / 2);
}

// Returns the least distance that counts as a jump, for example from one arc of a flank to the
// other. The result is six times the median distance between successive positions, but at least a
// tenth of the face width.
double jump_of(const std::vector<const ContactPoint*>& points, double face) {
  constexpr double kTimes = 6.0, kPart = 0.1;
  std::vector<double> ways;
  for (std::size_t i = 1; i < points.size(); ++i)
    ways.push_back(way_between(*points[i - 1], *points[i]));
  if (ways.empty()) return kInfinity;
  const auto middle = ways.begin() + static_cast<std::ptrdiff_t>(ways.size() / 2);
  std::nth_element(ways.begin(), middle, ways.end());
  return std::max(kTimes * *middle, kPart * face);
}

}  // namespace

ContourField field_of(const FlankRaster& raster) {
  return {raster.height.size(), raster.diameter.size(), raster.gap};
}

std::vector<Vec2> region_below(const FlankRaster& raster, const ContourField& field, double level) {
  auto loops = regions_below(field, level);
  const Vec2 nodes(static_cast<double>(raster.height.size() - 1),
                   static_cast<double>(raster.diameter.size() - 1));
  const Vec2 from(raster.height.front(), raster.diameter.front());
  const Vec2 to(raster.height.back(), raster.diameter.back());
  for (auto& loop : loops)
    for (Vec2& node : loop) node = from + node.cwiseQuotient(nodes).cwiseProduct(to - from);
  return pieces_of(loops);
}

double pattern_share(const FlankRaster& raster, double marking) {
  const double all = static_cast<double>((raster.height.size() - 1) * (raster.diameter.size() - 1));
  return area_of(regions_below(field_of(raster), marking)) / all;
}

std::vector<PathPiece> path_on_tooth(const ContactScene& scene) {
  const double pitch = pitch_of(scene);
  std::vector<const ContactPoint*> points;
  for (const ContactPoint& p : scene.driving.positions)
    if (p.kind != TouchKind::none) points.push_back(&p);
  // At a given position, pair k has the contact that pair 0 had k pitches earlier.
  const auto own = [&](const ContactPoint* p) { return p->rotation1.rad() - p->pair * pitch; };
  std::sort(points.begin(), points.end(),
            [&](const auto* a, const auto* b) { return own(a) < own(b); });
  const double step = 1.5 * pitch / std::max(1, scene.positions);
  const double jump = jump_of(points, scene.gears[0]->spec.face_width);
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

void remove_diameters(Figure& figure) {
  std::erase_if(figure.marks, [](const FigureMark& m) {
    return m.kind == FigureMark::Kind::text && std::isinf(m.points[0].x());
  });
}

Figure flank_frame(std::string id, std::string title, const FlankRaster& extent, double side,
                   std::size_t which) {
  const double z0 = extent.height.front(), z1 = extent.height.back();
  const double d0 = extent.diameter.front(), d1 = extent.diameter.back();
  const double root = side > 0.0 ? d0 : d1, tip = side > 0.0 ? d1 : d0;
  const double beyond = side * kBeyond * (d1 - d0);
  const double real = (d1 - d0) / 2 / (z1 - z0);
  const double tall = std::clamp(real, kLowFlank, kHighFlank);
  Figure f{std::move(id),
           std::move(title),
           "The developed usable flank, with the face from left to right, the root below and the "
           "tip above.",
           {},
           {"along the face from its middle", "mm", z0, z1},
           {"diameter", "mm", root - beyond, tip + beyond}};
  f.tall = tall * (1 + 2 * kBeyond);
  f.caption = std::abs(tall / real - 1) < 0.02
                  ? "The picture has true proportions."
                  : fmt::format("The scale of heights is {} times the scale of widths.",
                                fixed(tall / real, 1));
  f.bar({z0, -kInfinity}, {z1, kInfinity}, "slice");
  f.bar({z0, d0}, {z1, d1}, "flank-ground");
  f.bar({z0, d0}, {z1, d1}, "limit");
  const std::string n = std::to_string(which + 1);
  for (const auto& [d, symbol, word, up] :
       {std::tuple(tip, "d_Fa" + n, "tip", true), std::tuple(root, "d_Ff" + n, "root", false)}) {
    f.text({kInfinity, d}, symbol_svg(symbol), Anchor::start, "", {10.0, up ? 4.0 : 0.0});
    f.text({kInfinity, d}, "", Anchor::start, "tick", {10.0, up ? 23.0 : -19.0});
    f.marks.back().length = {d, 2};
    f.text({z0, d}, word, Anchor::start, "inzone", {6.0, up ? -4.0 : 13.0});
  }
  return f;
}

Figure flank_figure(const ContactScene& scene, std::size_t which, const FlankLayers& layers) {
  GW_EXPECTS(layers.pattern || layers.gap);
  const FlankRaster& extent = layers.pattern ? *layers.pattern : *layers.gap;
  const bool gap_alone = layers.gap && !layers.pattern && !layers.way;
  Figure f = flank_frame((gap_alone ? "gap" : fmt::format("bearing{}", which + 1)) + scene.part,
                         gap_alone ? "Gap between the flanks" : fmt::format("Gear {}", which + 1),
                         extent, scene.gears[which]->side(), which);
  const std::string proportions = std::move(f.caption);
  f.caption = gap_alone ? " on gear 1" : ", " + side_words(scene, which);
  if (layers.pattern) {
    f.caption += fmt::format("; the marking covers {} % of the flank",
                             percent(pattern_share(*layers.pattern, scene.marking)));
    f.area(region_below(*layers.pattern, field_of(*layers.pattern), scene.marking), "marked");
    f.keys.push_back({"marked", "marking pattern"});
  }
  const std::vector<PathPiece> pieces =
      layers.way ? path_on_tooth(scene) : std::vector<PathPiece>();
  // If a single position is shown, only the ellipse or contact line of this position is drawn.
  if (layers.now && !gap_alone)
    add_instants(f, scene, {{false, {layers.now}}}, which);
  else
    add_instants(f, scene, pieces, which);
  const Vec2 touch = layers.now ? touch_of(*layers.now, which) : Vec2::Zero();
  if (layers.gap) add_gap(f, *layers.gap, gap_alone, touch);
  add_way(f, pieces, which);
  if (layers.now) {
    if (layers.gap)
      f.caption += fmt::format(
          "{} of tooth pair {} at rotation {}°. The contour lines are at 1 µm, 2 µm, 5 µm, 10 µm, "
          "20 µm and 50 µm, on the part that the mating gear reaches",
          gap_alone ? "," : "; the darker bands show the gap", pair_words(layers.now->pair),
          fixed(layers.now->rotation1.deg(), 3));
    if (layers.now->line)
      f.line(contact_line(scene, *layers.now, which), "action");
    else
      f.dot(touch, 4.5, "mark action-dot", "contact point");
    if (gap_alone)
      f.keys.push_back({"action", layers.now->line ? "contact line" : "contact point"});
  }
  f.caption +=
      (layers.way ? ". The path of contact runs from the hollow dot to the filled dot. " : ". ") +
      proportions;
  return f;
}

Figure small_pattern(std::string id, std::string title, const FlankRaster& pattern,
                     double marking) {
  Figure f = flank_frame(std::move(id), std::move(title), pattern, 1.0, 0);
  f.bare = true;
  std::erase_if(f.marks, [](const FigureMark& m) { return m.kind == FigureMark::Kind::text; });
  f.area(region_below(pattern, field_of(pattern), marking), "marked");
  f.caption.clear();
  return f;
}

}  // namespace gearwright
