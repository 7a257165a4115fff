#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/figure/contact_figures.hpp"
#include "gearwright/figure/load_figures.hpp"
#include "gearwright/figure/markup.hpp"
#include "gearwright/figure/ticks.hpp"

namespace gearwright {

namespace {

constexpr std::size_t kRows = 81;
constexpr std::size_t kColumns = 65;
constexpr int kMostLevels = 10;
constexpr std::size_t kMostDrawn = 14;  // number of ellipses that can be distinguished
constexpr int kCorners = 48;            // corners of the polygon that represents an ellipse

// A slice of a flank at one rotation of its tooth pair. It has the position of the least gap in the
// slice, and the pressure at this position.
struct Sample {
  double own;     // rotation of the tooth pair, pitches
  double radius;  // mm
  double pressure;
};

std::vector<Sample> samples_of(const LoadScene& scene, std::size_t which, std::size_t slice) {
  std::vector<Sample> all;
  for (const LoadedPosition& p : shown_torque(scene).positions)
    for (const LoadedPair& k : p.pairs)
      if (const double r = k.radius[slice][which]; r > 0.0)
        all.push_back({own_pitches(scene, p, k), r, k.pressure[static_cast<Eigen::Index>(slice)]});
  std::sort(all.begin(), all.end(), [](const Sample& a, const Sample& b) { return a.own < b.own; });
  return all;
}

// Returns the greatest pressure at a radius. The contact can pass this radius several times, for
// example outwards and inwards if a mating edge is in contact.
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

// Returns the line on which a tooth pair carries load. It has one or several pieces. Each point of
// the line belongs to a slice j. Its coordinates are the height of the slice along the face of gear
// `which`, and the value `of(j)`.
template <class Of>
std::vector<Vec2> bearing_places(const LoadScene& scene, std::size_t which, const LoadedPair& pair,
                                 const Of& of) {
  const auto heights = heights_of(scene, which);
  std::vector<Vec2> line;
  for (std::size_t j = 0; j < heights.size(); ++j) {
    const bool bears = pair.pressure[static_cast<Eigen::Index>(j)] > 0.0;
    line.push_back(bears ? Vec2(heights[j], of(j)) : kNewPiece);
  }
  return line;
}

template <class Add>
void add_frames(Figure& f, const LoadScene& scene, const Add& add) {
  const auto positions = frame_positions(scene);
  f.frames = static_cast<int>(positions.size());
  for (std::size_t k = 0; k < positions.size(); ++k)
    for (const LoadedPair& pair : shown_torque(scene).positions[positions[k]].pairs)
      add(pair, static_cast<int>(k));
}

// A tooth at one position of its engagement.
struct Passing {
  double own;  // rotation of the tooth pair, pitches
  const LoadedPoint* point;
};

// Returns one list for each track of contact points. Teeth with double arcs have two tracks.
std::vector<std::vector<Passing>> ways_of(const LoadScene& scene, const LoadedTorque& t) {
  std::map<int, std::vector<Passing>> by_track;
  for (const LoadedPosition& p : t.positions)
    for (const LoadedPair& k : p.pairs)
      by_track[k.point.track].push_back({own_pitches(scene, p, k), &k.point});
  std::vector<std::vector<Passing>> ways;
  for (auto& [track, way] : by_track) {
    std::sort(way.begin(), way.end(),
              [](const Passing& a, const Passing& b) { return a.own < b.own; });
    ways.push_back(std::move(way));
  }
  return ways;
}

Vec2 middle_of(const LoadedPoint& p, std::size_t which) {
  return {p.height[which], p.diameter[which]};
}

}  // namespace

FlankRaster pressure_raster(const LoadScene& scene, std::size_t which) {
  const Gear& gear = *scene.gears[which];
  const FaceSlices& s = scene.contact.slices[which];
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
  const double step = 1.0 / static_cast<double>(shown_torque(scene).positions.size());
  std::vector<std::vector<Sample>> slices;
  for (int j = 0; j < s.count; ++j)
    slices.push_back(samples_of(scene, which, static_cast<std::size_t>(j)));
  for (const double d : raster.diameter) {
    for (const double z : raster.height) {
      // The value of an outermost slice applies from its middle to the end of the face.
      const double place = std::clamp((z - s.middle(0)) / s.width(), 0.0, s.count - 1.0);
      const auto j = std::min(static_cast<std::size_t>(place), slices.size() - 2);
      const double to_next = place - static_cast<double>(j);
      raster.gap.push_back((1 - to_next) * greatest_at(slices[j], step, d / 2) +
                           to_next * greatest_at(slices[j + 1], step, d / 2));
    }
  }
  return raster;
}

Figure pressure_figure(const LoadScene& scene, std::size_t which) {
  GW_EXPECTS(scene.contact.regime == LoadRegime::line);
  const LoadedTorque& t = shown_torque(scene);
  const FlankRaster raster = pressure_raster(scene, which);
  Figure f =
      flank_frame(fmt::format("pressure{}{}", which + 1, scene.part),
                  fmt::format("Gear {}", which + 1), raster, scene.gears[which]->side(), which);
  f.caption = fmt::format(" at {}. The shades show the greatest pressure during a mesh in N/mm². ",
                          torque_words(t)) +
              f.caption;
  f.keys.push_back({"bears", "teeth in contact at this position"});
  const std::vector<double> levels = levels_between(0.0, t.max_pressure, kMostLevels);
  add_map(f, raster, levels, "greatest pressure during a mesh", "N/mm²", 0.0);
  f.shades = {levels, "≤ " + fixed(t.max_pressure, 0), ""};
  remove_diameters(f);
  add_frames(f, scene, [&](const LoadedPair& pair, int frame) {
    f.line(bearing_places(scene, which, pair,
                          [&](std::size_t j) { return 2 * pair.radius[j][which]; }),
           "action bears", {}, frame);
  });
  return f;
}

Figure pressure_along_figure(const LoadScene& scene) {
  GW_EXPECTS(scene.contact.regime == LoadRegime::line);
  const LoadedTorque& t = shown_torque(scene);
  const FaceSlices& s = scene.contact.slices[0];
  Figure f{"pressure-along" + scene.part,
           "Pressure along the face",
           "Greatest pressure over the face during a mesh, and pressure of the tooth pairs that "
           "carry load at one position.",
           " of each loaded tooth pair, in its own colour.",
           {"along the face from its middle", "mm", s.lo, s.hi},
           {"pressure", "N/mm²", 0.0, 1.06 * t.max_pressure}};
  f.keys.push_back({"before", "greatest value during a mesh"});
  const auto heights = heights_of(scene, 0);
  std::vector<Vec2> greatest;
  for (std::size_t j = 0; j < heights.size(); ++j) {
    double most = 0.0;
    for (const LoadedPosition& p : t.positions)
      for (const LoadedPair& k : p.pairs)
        most = std::max(most, k.pressure[static_cast<Eigen::Index>(j)]);
    greatest.push_back({heights[j], most});
  }
  f.line(std::move(greatest), "before", "greatest value during a mesh");
  add_frames(f, scene, [&](const LoadedPair& pair, int frame) {
    f.line(
        bearing_places(scene, 0, pair,
                       [&](std::size_t j) { return pair.pressure[static_cast<Eigen::Index>(j)]; }),
        std::string("curve ") + pair_style(pair.pair), {}, frame);
  });
  return f;
}

Figure ellipse_figure(const LoadScene& scene, std::size_t which) {
  GW_EXPECTS(scene.contact.regime == LoadRegime::point);
  const Gear& gear = *scene.gears[which];
  const auto ways = ways_of(scene, shown_torque(scene));
  double lo = 2 * gear.tip_form_radius();
  double hi = lo;
  for (const auto& way : ways)
    for (const Passing& p : way) {
      lo = std::min(lo, middle_of(*p.point, which).y());
      hi = std::max(hi, middle_of(*p.point, which).y());
    }
  if (const auto form = gear.root_form_radius()) lo = std::min(lo, 2 * *form);
  const double half = gear.spec.face_width / 2;
  Figure f =
      flank_frame(fmt::format("ellipses{}{}", which + 1, scene.part),
                  fmt::format("Gear {}", which + 1), {{lo, hi}, {-half, half}, {}}, 1.0, which);
  f.caption = fmt::format(
                  " at {}. The contact ellipses belong to one tooth during its mesh, and the line "
                  "joins their centres. ",
                  torque_words(shown_torque(scene))) +
              f.caption;
  f.keys = {{"action", "ellipse on the flank"}, {"before", "ellipse beyond an end of the flank"}};
  for (const auto& way : ways) {
    std::vector<Vec2> path;
    for (const Passing& p : way) path.push_back(middle_of(*p.point, which));
    f.line(std::move(path), "thin dashdot");
    const std::size_t step = (way.size() + kMostDrawn - 1) / kMostDrawn;
    for (std::size_t i = step / 2; i < way.size(); i += step) {
      const LoadedPoint& p = *way[i].point;
      std::vector<Vec2> ellipse;
      for (int k = 0; k < kCorners; ++k) {
        const double turn = 2 * kPi * k / kCorners;
        const Vec2 d =
            std::cos(turn) * p.half_axis[which][0] + std::sin(turn) * p.half_axis[which][1];
        ellipse.push_back(middle_of(p, which) + Vec2(d.x(), 2 * d.y()));
      }
      f.area(std::move(ellipse), p.beyond ? "before" : "curve action");
    }
  }
  return f;
}

std::optional<Figure> point_pressure_figure(const LoadScene& scene) {
  Figure f{"point-pressure" + scene.part,
           "Pressure",
           "Greatest pressure during the mesh of one tooth pair.",
           " in the middle of the ellipse, for one tooth pair while it carries load.",
           {"rotation of the tooth pair from the centre line", "pitches"},
           {"pressure", "N/mm²"}};
  f.keys = torque_keys(scene);
  std::size_t shown = 0;
  for (const std::size_t i : shown_torques(scene)) {
    const LoadedTorque& torque = scene.contact.torques[i];
    const std::string style = "curve " + curve_style(shown++);
    for (const auto& way : ways_of(scene, torque)) {
      std::vector<Vec2> points;
      for (const Passing& p : way) points.push_back({p.own, p.point->pressure});
      f.line(std::move(points), style, torque_words(torque));
    }
  }
  return fit_axes(f, 0.06, true) ? std::optional(std::move(f)) : std::nullopt;
}

}  // namespace gearwright
