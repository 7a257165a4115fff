#include "gearwright/report/tooth_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "gearwright/report/gear_shape.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/svg.hpp"

namespace gearwright {

namespace {

constexpr double kWidth = 520.0;
constexpr double kHeight = 360.0;
constexpr double kPlotWidth = 400.0;  // the rest is for labels
constexpr double kLabelGap = 19.0;

struct LabelledCircle {
  std::string symbol;
  double radius;  // mm
  const char* style;
};

std::vector<LabelledCircle> circles_of(const Gear& gear) {
  std::vector<LabelledCircle> circles;
  circles.push_back({"d_a", gear.actual_tip_radius(), "thin"});
  circles.push_back({"d", gear.reference.reference_diameter / 2, "thin dashdot"});
  circles.push_back({"d_b", gear.base_radius(), "thin dash"});
  circles.push_back({"d_f", gear.tooth->root_radius, "thin"});
  if (const auto form = gear.root_form_radius()) circles.push_back({"d_Ff", *form, "thin dot"});
  if (const auto form = gear.tooth->tip_form_radius; form && *form < gear.tooth->tip_radius) {
    circles.push_back({"d_Fa", *form, "thin dot"});
  }
  return circles;
}

// One tooth and a quarter pitch on both sides, root to tip with some body below.
Viewport window(const Gear& gear) {
  const double r_f = gear.tooth->root_radius;
  const double r_a = gear.tooth->tip_radius;
  const double m = gear.spec.normal_module;
  const double pitch = gear.reference.transverse_module * std::numbers::pi;
  const double below = std::min(0.9 * m, 0.8 * r_f);
  const double tall = r_a - r_f + below + 0.5 * m;
  const double scale = std::min(kHeight / tall, kPlotWidth / (1.5 * pitch));
  // The window's middle is the plot's middle, left of the picture's.
  const double shift = (kWidth - kPlotWidth) / 2 / scale;
  const double spare = kHeight / scale - tall;
  const double middle = (r_a + 0.5 * m + r_f - below) / 2 - 0.3 * spare;
  return {kWidth, kHeight, Vec2(middle, -shift), scale, true};
}

void draw_circles(Svg& svg, const Viewport& view, const Gear& gear) {
  const Vec2 axis = view.px(Vec2::Zero());
  const std::vector<LabelledCircle> circles = circles_of(gear);
  // A circle leaves the plot at its right edge, or before when it is small.
  std::vector<Vec2> ends;
  std::vector<double> wanted;
  std::vector<std::string> labels;
  svg.begin_clip(0, 0, kPlotWidth, kHeight);
  for (const LabelledCircle& c : circles) {
    svg.circle(axis, c.radius * view.scale, c.style);
    const double r = c.radius * view.scale;
    const double dx = std::min(kPlotWidth - axis.x(), 0.94 * r);
    const double dy = std::sqrt(std::max(0.0, (r - dx) * (r + dx)));
    const Vec2 end(axis.x() + dx, axis.y() - dy);
    if (end.y() > kHeight) continue;  // below the window, so is its label; the table has it
    ends.push_back(end);
    wanted.push_back(end.y());
    labels.push_back(symbol_svg(c.symbol) + " " + fixed(2 * c.radius, kLengthDigits));
  }
  svg.end_group();
  const std::vector<double> placed = spread(wanted, kLabelGap, 12.0, kHeight - 10.0);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double x = kPlotWidth + 12;
    svg.polyline({ends[i], {x - 8 > ends[i].x() ? x - 8 : ends[i].x(), placed[i]}, {x, placed[i]}},
                 "leader");
    svg.text({x, placed[i]}, labels[i], Anchor::start, "", {3.0, 4.0});
  }
}

const char* style_of(ArcName name) {
  switch (name) {
    case ArcName::root_land: return "arc c-root-land";
    case ArcName::root_fillet: return "arc c-root-fillet";
    case ArcName::flank: return "arc c-flank";
    case ArcName::tip_fillet: return "arc c-tip-fillet";
    case ArcName::tip_land: return "arc c-tip-land";
  }
  contract_failed("postcondition", "known arc name", __FILE__, __LINE__);
}

const char* words_of(ArcName name) {
  switch (name) {
    case ArcName::root_land: return "root land";
    case ArcName::root_fillet: return "root fillet";
    case ArcName::flank: return "flank (involute)";
    case ArcName::tip_fillet: return "tip fillet or chamfer";
    case ArcName::tip_land: return "tip land";
  }
  contract_failed("postcondition", "known arc name", __FILE__, __LINE__);
}

std::string why_no_outline(const Gear& gear) {
  if (gear.internal()) {
    return "A ring: its diameters and thicknesses are in the table. Its outline is that of the "
           "pinion "
           "cutter that makes it, which is not part of this version, so there is no picture of its "
           "tooth.";
  }
  for (const Warning& w : gear.warnings) {
    if (w.code == "severed" || w.code == "through_axis") return w.message;
  }
  return "The cutter leaves no outline to draw.";
}

}  // namespace

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
                  "reference, base, tip, root and form circles.",
                  z));
  svg.begin_clip(0, 0, kPlotWidth, kHeight);
  // The gear frame's x axis points up here: a quarter turn. At least three teeth are seen.
  svg.use(shape, axis, unit, 90.0, "neighbour");
  svg.line({axis.x(), 0}, {axis.x(), kHeight}, "thin dashdot");
  svg.end_group();
  draw_circles(svg, view, gear);
  svg.begin_clip(0, 0, kPlotWidth, kHeight);
  svg.begin_group(fmt::format("transform=\"translate({} {}) scale({:.9g}) rotate(-90)\"",
                              pixel(axis.x()), pixel(axis.y()), unit));
  for (const Arc& arc : gear.tooth->outline.arcs) {
    for (const int side : {+1, -1}) svg.path(arc_path(gear, arc, side), style_of(arc.name));
  }
  svg.end_group();
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
    legend += fmt::format("<span class=\"key\"><i class=\"swatch {}\"></i>{}</span> ",
                          style_of(arc.name), words_of(arc.name));
  }
  return fmt::format(
      "<figure>{}<figcaption><strong>{}</strong>, transverse section, mm. "
      "{}</figcaption></figure>\n",
      svg.str(), name, legend);
}

}  // namespace gearwright
