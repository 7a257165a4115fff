#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "gearwright/base/contract.hpp"
#include "gearwright/figure/free_labels.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/figure/mesh.hpp"
#include "gearwright/figure/svg.hpp"
#include "gearwright/report/gear_figures.hpp"
#include "gearwright/report/html_text.hpp"

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

// One tooth and a quarter pitch on both sides, with a part of the body behind its root. An internal
// gear's tooth points down.
Viewport window(const Gear& gear) {
  const double r_f = gear.tooth->root_radius;
  const double r_a = gear.tooth->tip_radius;
  const double m = gear.spec.normal_module;
  const double out = gear.side();  // from root to tip
  const double pitch = gear.transverse_module * std::numbers::pi;
  const double body = gear.internal() ? 0.9 * m : std::min(0.9 * m, 0.8 * r_f);
  const double tall = std::abs(r_a - r_f) + body + 0.5 * m;
  const double scale = std::min(kHeight / tall, kPlotWidth / (1.5 * pitch));
  // The middle of the window is that of the plot, which is left of the picture's.
  const double shift = (kWidth - kPlotWidth) / 2 / scale;
  const double spare = kHeight / scale - tall;
  const double middle = (r_a + out * 0.5 * m + r_f - out * body) / 2 - out * 0.3 * spare;
  return {kWidth, kHeight, Vec2(middle, -shift), scale, true};
}

// The number of digits fits next to the plot on a narrow screen. The table has all digits.
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
    if (end.y() > kHeight || end.y() < 0.0) continue;  // outside the window, but in the table
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

constexpr int kMaxTeeth = 8;
constexpr std::array<double, 5> kShifts{0.3, 0.5, 0.7, 0.9, 1.0};
constexpr double kSameShift = 1e-6;  // shifts within this difference are equal
constexpr double kSmallWidth = 240.0;
constexpr double kSmallHeight = 230.0;
constexpr double kMargin = 12.0;
constexpr double kChords = 1e-3;  // m_n: a tenth of a pixel of these small pictures

std::vector<Vec2> tooth_points(const Gear& gear) {
  std::vector<Vec2> points;
  for (const Arc& arc : gear.tooth->outline.arcs) {
    const std::vector<Vec2> piece = chords(arc, kChords * gear.spec.normal_module);
    points.insert(points.end(), piece.begin(), piece.end());
  }
  return points;
}

// One window for all, mm: from the lowest root to the highest tip, with the width of the widest.
Viewport window(const std::vector<ShiftedTooth>& teeth) {
  double half = 0.0;
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;
  const auto hold = [&](const Gear& gear) {
    if (!has_outline(gear)) return;
    for (const Vec2& p : tooth_points(gear)) {
      half = std::max(half, std::abs(p.y()));
      low = std::min(low, p.x());
      high = std::max(high, p.x());
    }
  };
  for (const ShiftedTooth& t : teeth) {
    hold(t.rack_cut);
    if (t.rounded) hold(*t.rounded);
  }
  low -= 0.12 * (high - low);
  const double scale =
      std::min((kSmallWidth - 2 * kMargin) / (2 * half), (kSmallHeight - kMargin) / (high - low));
  return {kSmallWidth, kSmallHeight, Vec2((low + high + kMargin / scale) / 2, 0.0), scale, true};
}

// Both flanks of one arc, in the window.
void draw_arc(Svg& svg, const Viewport& view, const Gear& gear, const Arc& arc, const char* style) {
  for (const double side : {1.0, -1.0}) {
    std::vector<Vec2> points;
    for (const Vec2& p : chords(arc, kChords * gear.spec.normal_module))
      points.push_back(view.px({p.x(), side * p.y()}));
    svg.polyline(points, style);
  }
}

// The tooth over its own pitch, filled down to the axis.
void fill_slice(Svg& svg, const Viewport& view, const Gear& gear) {
  const std::vector<Vec2> side = tooth_points(gear);
  std::vector<Vec2> slice{view.px(Vec2::Zero())};
  for (const Vec2& p : side) slice.push_back(view.px(p));
  for (auto p = side.rbegin(); p != side.rend(); ++p) slice.push_back(view.px({p->x(), -p->y()}));
  svg.polygon(slice, "slice");
}

std::string tooth_svg(const ShiftedTooth& t, const Viewport& view, const std::string& id,
                      const std::string& words) {
  Svg svg(id, kSmallWidth, kSmallHeight, fmt::format("The tooth at x = {:.4g}", t.shift), words);
  const Vec2 axis = view.px(Vec2::Zero());
  const bool cut = has_outline(t.rack_cut);
  const bool rounded = t.rounded && has_outline(*t.rounded);
  if (rounded || cut) fill_slice(svg, view, rounded ? *t.rounded : t.rack_cut);
  svg.circle(axis, t.rack_cut.base_radius() * view.scale, "thin dash");
  svg.line({axis.x(), 0}, {axis.x(), kSmallHeight}, "thin dashdot");
  // Their common part covers the dashes.
  if (cut) {
    for (const Arc& arc : t.rack_cut.tooth->outline.arcs)
      draw_arc(svg, view, t.rack_cut, arc, "before");
  }
  if (rounded) {
    for (const Arc& arc : t.rounded->tooth->outline.arcs) {
      draw_arc(svg, view, *t.rounded, arc,
               arc.name == ArcName::root_fillet ? arc_style(arc.name) : "kept");
    }
  }
  return svg.str();
}

std::string words_of(const ShiftedTooth& t) {
  const Gear& g = t.rack_cut;
  std::string words;
  if (!g.exists()) {
    words = g.tooth->through_axis ? "the rack passes the axis" : "the rack cuts the tooth off";
  } else {
    words = g.undercut ? "rack-cut: undercut" : "rack-cut: no undercut";
    if (g.pointed()) words += ", pointed";
  }
  if (!t.rounded) words += "; no circle fits";
  return words;
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
  // The gear frame's x axis points up here, a quarter turn. At least three teeth are visible.
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

bool shift_is_worth_a_picture(const Gear& gear) {
  if (gear.internal() || gear.cut_by || !has_outline(gear) || gear.spec.teeth > kMaxTeeth)
    return false;
  if (!gear.involute()) return false;
  return gear.spec.root_fillet || gear.undercut;
}

std::vector<ShiftedTooth> shifted_teeth(const Gear& gear) {
  GW_EXPECTS(shift_is_worth_a_picture(gear));
  std::vector<double> shifts(kShifts.begin(), kShifts.end());
  const double own = gear.spec.profile_shift;
  std::erase_if(shifts, [&](double x) { return std::abs(x - own) < kSameShift; });
  shifts.push_back(own);
  std::sort(shifts.begin(), shifts.end());

  std::vector<ShiftedTooth> teeth;
  for (const double x : shifts) {
    CylindricalSpec spec = gear.spec;
    spec.profile_shift = x;
    spec.tip_diameter.reset();
    spec.root_fillet.reset();
    spec.tip_fillet.reset();
    auto cut = make_gear(spec);
    if (!cut) continue;  // beyond the limits of a spec
    ShiftedTooth t{x, x == own, std::move(cut).take(), std::nullopt};
    spec.root_fillet = gear.spec.root_fillet.value_or(RootFilletSpec{});
    // The tooth has its own tip fillet if that fits, otherwise the tip of the rack.
    spec.tip_fillet = gear.spec.tip_fillet;
    auto rounded = make_gear(spec);
    if (!rounded && spec.tip_fillet) {
      spec.tip_fillet.reset();
      rounded = make_gear(spec);
    }
    if (rounded) t.rounded = std::move(rounded).take();
    teeth.push_back(std::move(t));
  }
  return teeth;
}

std::string shift_figures(const Gear& gear, const std::string& shape, const std::string& name) {
  if (!shift_is_worth_a_picture(gear)) return {};
  const std::vector<ShiftedTooth> teeth = shifted_teeth(gear);
  if (teeth.empty()) return {};
  const Viewport view = window(teeth);
  std::string text = fmt::format(
      "<h3>{}: profile shift and root</h3>\n<p>The same tooth cut at other profile shifts, to one "
      "scale. {} {} from {}the undercut limit on. Dashed circle: the base circle.</p>\n<div "
      "class=\"multiples\">\n",
      name, caption_key("before", "as the rack cuts it"),
      caption_key("c-root-fillet", "circular root fillet"),
      gear.spec.root_fillet ? fmt::format("{:.4g} mm beyond ", gear.spec.root_fillet->offset) : "");
  for (std::size_t i = 0; i < teeth.size(); ++i) {
    const ShiftedTooth& t = teeth[i];
    const std::string words = words_of(t);
    text += captioned(tooth_svg(t, view, fmt::format("shift{}-{}", i + 1, shape), words),
                      fmt::format("<strong>{} = {:.4g}</strong>{}<br>{}", symbol_html("x"), t.shift,
                                  t.own ? ", this gear" : "", words),
                      t.own ? " class=\"own\"" : "");
  }
  return text + "</div>\n";
}

}  // namespace gearwright
