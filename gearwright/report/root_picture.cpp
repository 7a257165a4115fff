#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/base/contract.hpp"
#include "gearwright/figure/free_labels.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/report/gear_figures.hpp"
#include "gearwright/report/html_text.hpp"

namespace gearwright {

namespace {

constexpr double kWidth = 520.0;
constexpr double kHeight = 400.0;
constexpr double kPlotWidth = 400.0;  // the remaining width is for labels
constexpr double kMargin = 22.0;      // px around the essential part
constexpr int kFewTeeth = 12;  // with more teeth, a root without undercut looks like any other

// Points are marked on the right of the tooth. That is the side y < 0 of the gear frame, so they
// are mirrored.

const Arc& flank_of(const Gear& gear) {
  const Arc* flank = gear.tooth->outline.find(ArcName::flank);
  GW_EXPECTS(flank != nullptr);
  return *flank;
}

bool has_flank(const Gear& gear) { return gear.tooth->outline.find(ArcName::flank) != nullptr; }

Vec2 center_of(const FilletArc& arc, double polar_angle) {
  return arc.distance * Vec2(std::cos(polar_angle), std::sin(polar_angle));
}

Vec2 root_center(const Gear& gear) {
  return center_of(*gear.tooth->root_fillet, -std::numbers::pi / gear.spec.teeth);
}

// Beyond the middle of the space, F lies in the neighbouring tooth.
bool shows_limit(const Gear& gear) {
  return gear.reference().base_tooth_thickness / gear.reference().base_diameter <
         std::numbers::pi / gear.spec.teeth;
}

// The essential part, mm: the whole tooth if its tip matters, otherwise the root on the right, up
// to slightly above the start of the flank.
std::vector<Vec2> points_shown(const Gear& gear, const std::optional<Gear>& rack) {
  const bool whole = gear.tooth->tip_fillet || (rack && gear.spec.teeth <= 4);
  const double start = std::max(gear.base_radius(), gear.root_form_radius().value_or(0.0));
  const double top = whole ? 2 * gear.actual_tip_radius() : start + 0.6 * gear.spec.normal_module;
  std::vector<Vec2> points;
  const auto add = [&](const Gear& g) {
    for (const Arc& arc : g.tooth->outline.arcs) {
      for (const Vec2& p : sample(arc, 40)) {
        if (p.norm() > top) continue;
        points.push_back(mirrored(p));
        if (whole) points.push_back(p);
      }
    }
  };
  add(gear);
  if (rack && has_outline(*rack)) add(*rack);
  if (gear.tooth->root_fillet) points.push_back(root_center(gear));
  if (shows_limit(gear)) points.push_back(mirrored(undercut_limit_point(gear)));
  return points;
}

Viewport window(const Gear& gear, const std::optional<Gear>& rack) {
  Bounds box;
  for (const Vec2& p : points_shown(gear, rack)) box.cover(p);
  // The y axis of the gear points to the left and its x axis up.
  const double scale = std::min((kPlotWidth - 2 * kMargin) / box.size().y(),
                                (kHeight - 2 * kMargin) / box.size().x());
  const double shift = (kWidth - kPlotWidth) / 2 / scale;
  return {kWidth, kHeight, (box.lo + box.hi) / 2 - Vec2(0.0, shift), scale, true};
}

// The flank that undercut removed, from the base circle to the present start of the flank.
void draw_lost_flank(Svg& svg, const Viewport& view, const Gear& gear) {
  const Involute flank(gear.base_radius(),
                       gear.reference().base_tooth_thickness / gear.reference().base_diameter);
  const double end = flank.roll_at(gear.root_form_radius().value_or(gear.actual_tip_radius()));
  for (const double side : {1.0, -1.0}) {
    std::vector<Vec2> points;
    for (int k = 0; k <= 32; ++k) {
      const Vec2 p = flank.point(end * k / 32);
      points.push_back(view.px({p.x(), side * p.y()}));
    }
    svg.polyline(points, "before");
  }
}

// The circle of an arc, with its centre and the radius to the point at which it touches the flank.
void draw_fillet(Svg& svg, const Viewport& view, const FilletArc& arc, const Vec2& center,
                 const Vec2& touch, const char* symbol) {
  const Vec2 c = view.px(center);
  const Vec2 p = view.px(touch);
  svg.circle(c, arc.radius * view.scale, "thin dot");
  svg.line(c, p, "thin");
  svg.dot(c, 2.2, "mark hollow");
  if ((p - c).norm() < 34.0) return;  // there is no room next to such a short line
  svg.text((c + p) / 2, symbol_svg(symbol), Anchor::middle, "halo", {0.0, -6.0});
}

std::string with_l(const char* letter, double l) {
  return fmt::format("<tspan class=\"letter\">{}</tspan> ", letter) + symbol_svg("l") + " " +
         fixed(l, kLengthDigits);
}

struct Mark {
  Vec2 at;  // mm
  std::string markup;
};

std::vector<Mark> marks_of(const Gear& gear) {
  const InvoluteTeeth& teeth = *gear.involute();
  std::vector<Mark> marks;
  if (gear.tooth->tip_fillet && teeth.point_j_l)
    marks.push_back({mirrored(flank_of(gear).end_point), with_l("J", *teeth.point_j_l)});
  if (gear.tooth->root_fillet && teeth.point_c_l) {
    marks.push_back({mirrored(flank_of(gear).begin_point), with_l("C", *teeth.point_c_l)});
  } else if (has_flank(gear)) {
    marks.push_back(
        {mirrored(flank_of(gear).begin_point),
         symbol_svg("d_Ff") + " " + fixed(2 * flank_of(gear).begin_point.norm(), kLengthDigits)});
  }
  if (shows_limit(gear) && teeth.undercut_l)
    marks.push_back({mirrored(undercut_limit_point(gear)), with_l("F", *teeth.undercut_l)});
  return marks;
}

std::string root_svg(const Gear& gear, const std::optional<Gear>& rack, const std::string& shape,
                     const std::string& name) {
  const Viewport view = window(gear, rack);
  const Vec2 axis = view.px(Vec2::Zero());
  Svg svg(
      "root-" + shape, kWidth, kHeight,
      name + ": the actual root and the root that the rack would cut",
      "The tooth in the transverse section with its arcs in colours; dashed behind it the root "
      "that the rack alone would leave, the base circle, and the points F, C and J on the flank.");
  svg.begin_clip(0, 0, kPlotWidth, kHeight);
  svg.use(shape, axis, view.scale * outline_unit_mm(gear), 90.0, "neighbour");
  svg.line({axis.x(), 0}, {axis.x(), kHeight}, "thin dashdot");
  const double space = std::numbers::pi / gear.spec.teeth;
  const double far = 2 * gear.actual_tip_radius();
  svg.line(axis, view.px({far * std::cos(space), -far * std::sin(space)}), "thin dashdot");
  svg.circle(axis, gear.base_radius() * view.scale, "thin dash");
  if (rack && has_outline(*rack))
    draw_upright_arcs(svg, view, *rack, [](ArcName) { return "before"; });
  if (!rack && gear.undercut) draw_lost_flank(svg, view, gear);
  draw_upright_arcs(svg, view, gear, arc_style);
  if (const auto& arc = gear.tooth->root_fillet)
    draw_fillet(svg, view, *arc, root_center(gear), mirrored(flank_of(gear).begin_point), "r_r");
  if (const auto& arc = gear.tooth->tip_fillet)
    draw_fillet(svg, view, *arc, center_of(*arc, -arc->land.rad()),
                mirrored(flank_of(gear).end_point), "r_t");
  svg.end_group();

  std::vector<Leader> leaders;
  for (const Mark& mark : marks_of(gear)) {
    svg.dot(view.px(mark.at), 2.6, "mark");
    leaders.push_back({view.px(mark.at), mark.markup});
  }
  const Vec2 base = leaves_right(axis, gear.base_radius() * view.scale, kPlotWidth);
  if (base.y() > 0.0 && base.y() < kHeight) {
    leaders.push_back(
        {base, symbol_svg("d_b") + " " + fixed(2 * gear.base_radius(), kLengthDigits)});
  }
  draw_leaders(svg, leaders, kPlotWidth + 12, kHeight);
  return svg.str();
}

std::string behind_words(const Gear& gear, const std::optional<Gear>& rack) {
  const auto key = [](const char* words) { return caption_key("before", words) + " "; };
  if (rack && has_outline(*rack)) {
    return key(rack->undercut ? "as the rack alone would cut it: undercut"
                              : "as the rack alone would cut it");
  }
  if (gear.tooth->root_fillet || gear.tooth->tip_fillet)
    return "The rack alone would leave no tooth. ";
  return gear.undercut ? key("flank removed by undercut") : "";
}

}  // namespace

bool root_is_worth_a_picture(const Gear& gear) {
  if (!has_outline(gear) || gear.internal() || gear.cut_by || !has_flank(gear)) return false;
  if (!gear.involute()) return false;
  return gear.spec.root_fillet || gear.undercut || gear.spec.teeth <= kFewTeeth;
}

std::optional<Gear> by_rack_alone(const Gear& gear) {
  if (gear.cut_by || !(gear.spec.root_fillet || gear.spec.tip_fillet)) return std::nullopt;
  CylindricalSpec spec = gear.spec;
  spec.root_fillet.reset();
  spec.tip_fillet.reset();
  auto made = make_gear(spec);
  if (!made) return std::nullopt;
  return std::move(made).take();
}

Vec2 undercut_limit_point(const Gear& gear) {
  const double psi = gear.reference().base_tooth_thickness / gear.reference().base_diameter;
  return gear.base_radius() * Vec2(std::cos(psi), std::sin(psi));
}

std::string root_figure(const Gear& gear, const std::string& shape, const std::string& name) {
  if (!root_is_worth_a_picture(gear)) return {};
  const std::optional<Gear> rack = by_rack_alone(gear);
  std::string words = behind_words(gear, rack);
  words +=
      fmt::format("<b>F</b>: {}.", gear.involute()->undercut_l < 0.0
                                       ? "the flank could begin here at the earliest, but the rack "
                                         "does not reach this point, so there is no undercut"
                                       : "the rack reaches this point and undercuts the flank");
  if (gear.tooth->root_fillet) {
    words += fmt::format(" <b>C</b>: the root fillet, {} = {} mm, touches the flank.",
                         symbol_html("r_r"), fixed(gear.tooth->root_fillet->radius, kLengthDigits));
  }
  if (gear.tooth->tip_fillet) {
    words += fmt::format(" <b>J</b>: the tip fillet, {} = {} mm, touches the flank.",
                         symbol_html("r_t"), fixed(gear.tooth->tip_fillet->radius, kLengthDigits));
  }
  return captioned(root_svg(gear, rack, shape, name),
                   fmt::format("<strong>{}: its root</strong>. {}", name, words));
}

}  // namespace gearwright
