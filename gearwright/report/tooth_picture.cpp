#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "gearwright/report/gear_figures.hpp"
#include "gearwright/report/gear_shape.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/named_circles.hpp"

namespace gearwright {

namespace {

constexpr double kWidth = 520.0;
constexpr double kHeight = 360.0;
constexpr double kPlotWidth = 400.0;  // the rest is for labels

std::vector<NamedCircle> circles_of(const Gear& gear) {
  std::vector<NamedCircle> circles;
  circles.push_back({"d_a", gear.actual_tip_radius(), ""});
  circles.push_back({"d", gear.reference_diameter / 2, " dashdot"});
  if (gear.involute()) circles.push_back({"d_b", gear.base_radius(), " dash"});
  circles.push_back({"d_f", gear.tooth->root_radius, ""});
  if (const auto form = gear.root_form_radius()) circles.push_back({"d_Ff", *form, " dot"});
  if (const auto form = gear.tooth->tip_form_radius; form && *form != gear.tooth->tip_radius) {
    circles.push_back({"d_Fa", *form, " dot"});
  }
  return circles;
}

// One tooth and a quarter pitch on both sides, with some body behind its root. An internal gear's
// hangs down.
Viewport window(const Gear& gear) {
  const double r_f = gear.tooth->root_radius;
  const double r_a = gear.tooth->tip_radius;
  const double m = gear.spec.normal_module;
  const double out = gear.internal() ? -1.0 : 1.0;  // from root to tip
  const double pitch = gear.transverse_module * std::numbers::pi;
  const double body = gear.internal() ? 0.9 * m : std::min(0.9 * m, 0.8 * r_f);
  const double tall = std::abs(r_a - r_f) + body + 0.5 * m;
  const double scale = std::min(kHeight / tall, kPlotWidth / (1.5 * pitch));
  // The window's middle is the plot's middle, left of the picture's.
  const double shift = (kWidth - kPlotWidth) / 2 / scale;
  const double spare = kHeight / scale - tall;
  const double middle = (r_a + out * 0.5 * m + r_f - out * body) / 2 - out * 0.3 * spare;
  return {kWidth, kHeight, Vec2(middle, -shift), scale, true};
}

// As many digits as the room beside the plot holds on a narrow screen; the table has them all.
std::string shown_diameter(double d) {
  const int before = d < 1000.0 ? 3 : static_cast<int>(std::log10(d)) + 1;
  return fixed(d, std::max(0, std::min(kLengthDigits, 7 - before)));
}

void draw_circles(Svg& svg, const Viewport& view, const Gear& gear) {
  const Vec2 axis = view.px(Vec2::Zero());
  std::vector<Leader> leaders;
  svg.begin_clip(0, 0, kPlotWidth, kHeight);
  for (const NamedCircle& c : circles_of(gear)) {
    svg.circle(axis, c.radius * view.scale, std::string("thin") + c.style);
    const Vec2 end = leaves_right(axis, c.radius * view.scale, kPlotWidth);
    if (end.y() > kHeight || end.y() < 0.0) continue;  // outside the window; the table has it
    leaders.push_back({end, symbol_svg(c.symbol) + " " + shown_diameter(2 * c.radius)});
  }
  svg.end_group();
  draw_leaders(svg, leaders, kPlotWidth + 12, kHeight);
}

const char* words_of(const Gear& gear, ArcName name) {
  switch (name) {
    case ArcName::root_land: return "root land";
    case ArcName::root_fillet: return "root fillet";
    case ArcName::flank: return gear.involute() ? "flank (involute)" : "flank";
    case ArcName::tip_fillet: return "tip fillet or chamfer";
    case ArcName::tip_land: return "tip land";
  }
  contract_failed("postcondition", "known arc name", __FILE__, __LINE__);
}

std::string why_no_outline(const Gear& gear) {
  if (gear.internal()) {
    return "An internal gear: its diameters and thicknesses are in the table. Its outline is what "
           "its pinion cutter leaves, and no cutter is given: with cut_by there is a picture of "
           "its "
           "tooth.";
  }
  for (const Warning& w : gear.warnings) {
    if (w.code == WarningCode::severed || w.code == WarningCode::through_axis) return w.message;
  }
  return "The cutter leaves no outline to draw.";
}

}  // namespace

const char* arc_style(ArcName name) {
  switch (name) {
    case ArcName::root_land: return "arc c-root-land";
    case ArcName::root_fillet: return "arc c-root-fillet";
    case ArcName::flank: return "arc c-flank";
    case ArcName::tip_fillet: return "arc c-tip-fillet";
    case ArcName::tip_land: return "arc c-tip-land";
  }
  contract_failed("postcondition", "known arc name", __FILE__, __LINE__);
}

std::string tooth_figure(const Gear& gear, const std::string& shape, const std::string& name) {
  if (!has_outline(gear)) {
    return fmt::format("<p class=\"nopicture\"><strong>{}: no picture.</strong> {}</p>\n", name,
                       escaped(why_no_outline(gear)));
  }
  const Viewport view = window(gear);
  const double unit = view.scale * outline_unit_mm(gear);
  const Vec2 axis = view.px(Vec2::Zero());
  const int z = gear.spec.teeth;
  Svg svg(
      "tooth-" + shape, kWidth, kHeight, fmt::format("{}: tooth in the transverse section", name),
      fmt::format("One tooth of {} teeth with its arcs in colours, neighbouring teeth in grey, and "
                  "reference, {}tip, root and form circles.",
                  z, gear.involute() ? "base, " : ""));
  svg.begin_clip(0, 0, kPlotWidth, kHeight);
  // The gear frame's x axis points up here: a quarter turn. At least three teeth are seen.
  svg.use(shape, axis, unit, 90.0, "neighbour");
  svg.line({axis.x(), 0}, {axis.x(), kHeight}, "thin dashdot");
  svg.end_group();
  draw_circles(svg, view, gear);
  svg.begin_clip(0, 0, kPlotWidth, kHeight);
  draw_upright_arcs(svg, view, gear, arc_style);
  svg.end_group();
  for (const Arc& arc : gear.tooth->outline.arcs) {
    if (&arc == &gear.tooth->outline.arcs.front()) continue;
    for (const double side : {1.0, -1.0}) {
      const Vec2 at = view.px({arc.begin_point.x(), side * arc.begin_point.y()});
      if (at.x() > 0 && at.x() < kPlotWidth) svg.dot(at, 2.2, "mark");
    }
  }

  std::string legend;
  std::vector<ArcName> shown;
  for (const Arc& arc : gear.tooth->outline.arcs) {
    if (std::find(shown.begin(), shown.end(), arc.name) != shown.end()) continue;
    shown.push_back(arc.name);
    legend += caption_key(arc_style(arc.name), words_of(gear, arc.name)) + " ";
  }
  return captioned(svg.str(),
                   fmt::format("<strong>{}</strong>, transverse section, mm. {}", name, legend));
}

}  // namespace gearwright
