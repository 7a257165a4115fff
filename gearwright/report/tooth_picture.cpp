#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/figure/mesh.hpp"
#include "gearwright/report/gear_figures.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/page_parts.hpp"

namespace gearwright {

namespace {

constexpr double kToothAspect = 400.0 / 360.0;  // width over height of the plot

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

// Returns the window of the figure, mm. It shows one tooth, a quarter of a pitch on either side,
// and a part of the body behind the root. The tooth of an internal gear points down.
Bounds window(const Gear& gear) {
  const double r_f = gear.tooth->root_radius;
  const double r_a = gear.tooth->tip_radius;
  const double m = gear.spec.normal_module;
  const double out = gear.side();  // direction from root to tip
  const double pitch = gear.transverse_module * kPi;
  const double body = std::min(0.9 * m, 0.8 * r_f);
  const double tall = std::abs(r_a - r_f) + body + 0.5 * m;
  const double height = std::max(tall, 1.5 * pitch / kToothAspect);
  const double middle = (r_a + out * 0.5 * m + r_f - out * body) / 2 - out * 0.3 * (height - tall);
  const Vec2 half(height * kToothAspect / 2, height / 2);
  return {Vec2(0.0, middle) - half, Vec2(0.0, middle) + half};
}

// Returns the number of decimals of a diameter. It is limited so that the text fits next to the
// plot on a narrow screen. The table shows all digits.
int decimals_of(double d) {
  const int before = d < 1000.0 ? 3 : static_cast<int>(std::log10(d)) + 1;
  return std::max(0, std::min(kLengthDigits, 7 - before));
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
    return "The table contains the diameters and thicknesses of the internal gear. There is no "
           "picture of its tooth, because the outline depends on the pinion cutter, which is not "
           "given. To get the picture, give cut_by.";
  }
  for (const Warning& w : gear.warnings) {
    if (w.code == WarningCode::severed || w.code == WarningCode::through_axis) return w.message;
  }
  return "The cutter leaves no outline to draw.";
}

constexpr int kMaxTeeth = 8;
constexpr std::array<double, 5> kShifts{0.3, 0.5, 0.7, 0.9, 1.0};
constexpr double kSameShift = 1e-6;  // greatest difference of shifts that count as equal
constexpr double kSmallAspect = 240.0 / 230.0;
// Margin at the sides and at the top, as a fraction of width and height.
constexpr double kToothMargin = 0.05;
constexpr double kChords = 1e-3;  // m_n, tolerance of chords: a tenth of a pixel in small pictures

std::vector<Vec2> tooth_points(const Gear& gear) {
  std::vector<Vec2> points;
  for (const Arc& arc : gear.tooth->outline.arcs) {
    const std::vector<Vec2> piece = chords(arc, kChords * gear.spec.normal_module);
    points.insert(points.end(), piece.begin(), piece.end());
  }
  return points;
}

// Returns one window for all teeth, mm. It extends from the lowest root to the highest tip and is
// as wide as the widest tooth.
Bounds window(const std::vector<ShiftedTooth>& teeth) {
  Bounds box;
  const auto contain = [&](const Gear& gear) {
    if (!has_outline(gear)) return;
    for (const Vec2& p : tooth_points(gear)) {
      box.cover(upright(p));
      box.cover(upright(mirrored(p)));
    }
  };
  for (const ShiftedTooth& t : teeth) {
    contain(t.rack_cut);
    if (t.rounded) contain(*t.rounded);
  }
  const double low = box.lo.y() - 0.12 * box.size().y();
  const double tall = std::max((box.hi.y() - low) / (1.0 - kToothMargin),
                               box.size().x() / (1.0 - 2 * kToothMargin) / kSmallAspect);
  const double middle = (low + box.hi.y() + kToothMargin * tall) / 2;
  const Vec2 half(tall * kSmallAspect / 2, tall / 2);
  return {Vec2(0.0, middle) - half, Vec2(0.0, middle) + half};
}

// Returns the outline of one tooth over one pitch, closed by lines to the axis of the gear.
std::vector<Vec2> slice_of(const Gear& gear) {
  const std::vector<Vec2> side = tooth_points(gear);
  std::vector<Vec2> slice{Vec2::Zero()};
  for (const Vec2& p : side) slice.push_back(upright(p));
  for (auto p = side.rbegin(); p != side.rend(); ++p) slice.push_back(upright(mirrored(*p)));
  return slice;
}

Figure tooth_of(const ShiftedTooth& t, const Bounds& window, const std::string& id,
                const std::string& words) {
  Figure f = plane_figure(id, fmt::format("The tooth at x = {:.4g}", t.shift), words, window);
  const bool cut = has_outline(t.rack_cut);
  const bool rounded = t.rounded && has_outline(*t.rounded);
  if (rounded || cut) f.area(slice_of(rounded ? *t.rounded : t.rack_cut), "slice");
  f.circle(Vec2::Zero(), t.rack_cut.base_radius(), "thin dash", -1, "", "base circle");
  f.line({{0.0, window.lo.y()}, {0.0, window.hi.y()}}, "thin dashdot");
  // The tooth with the circular fillet is drawn last and covers the dashed lines of the common
  // part.
  if (cut) add_upright_arcs(f, t.rack_cut, [](ArcName) { return "before"; });
  if (rounded)
    add_upright_arcs(f, *t.rounded, [](ArcName name) {
      return name == ArcName::root_fillet ? arc_style(name) : "kept";
    });
  return f;
}

std::string words_of(const ShiftedTooth& t) {
  const Gear& g = t.rack_cut;
  std::string words;
  if (!g.exists()) {
    words =
        g.tooth->through_axis ? "the rack passes through the axis" : "the rack cuts off the tooth";
  } else {
    words = g.undercut ? "undercut if cut by the rack" : "no undercut if cut by the rack";
    if (g.pointed()) words += ", pointed";
  }
  if (!t.rounded) words += "; no circular root fillet fits";
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

void add_upright_gear(Figure& f, const Gear& gear, const std::string& shape, std::string style) {
  FigureMark mark{FigureMark::Kind::shape, std::move(style), {Vec2::Zero()}, shape};
  mark.radius = outline_unit_mm(gear);
  mark.turned = 90.0;
  f.marks.push_back(std::move(mark));
}

void add_upright_arcs(Figure& f, const Gear& gear,
                      const std::function<const char*(ArcName)>& style) {
  for (const Arc& arc : gear.tooth->outline.arcs) {
    std::vector<Vec2> right, left;
    for (const Vec2& p : chords(arc, kOutlineTolerance * gear.spec.normal_module)) {
      right.push_back(upright(p));
      left.push_back(upright(mirrored(p)));
    }
    f.line(std::move(right), style(arc.name));
    f.line(std::move(left), style(arc.name));
  }
}

void lead_circle(Figure& f, double radius, std::string_view symbol, int decimals) {
  constexpr double kSteepest = 0.94;  // greatest ratio of x to the radius for the named point
  const double x = std::min(f.x.hi, kSteepest * radius);
  const double y = std::sqrt(std::max(0.0, (radius - x) * (radius + x)));
  if (!(y > f.y.lo && y < f.y.hi)) return;
  f.leaders.push_back({{x, y}, symbol_svg(symbol) + " "});
  f.leaders.back().length = {2 * radius, decimals};
}

std::string tooth_part(const Gear& gear, const std::string& shape, const std::string& name,
                       UnitSystem units) {
  if (has_outline(gear))
    return figure_html(in_units(units, tooth_figure(gear, shape, name)), kPlaneFigure);
  return fmt::format("<p class=\"nopicture\"><strong>{}: there is no picture.</strong> {}</p>\n",
                     name, escaped(why_no_outline(gear)));
}

Figure tooth_figure(const Gear& gear, const std::string& shape, const std::string& name) {
  GW_EXPECTS(has_outline(gear));
  Figure f = plane_figure(
      "tooth-" + shape, name,
      fmt::format(
          "One of {} teeth with its arcs in colours, the neighbouring teeth in grey, and the "
          "reference, {}tip, root and form circles.",
          gear.spec.teeth, gear.involute() ? "base, " : ""),
      window(gear));
  f.caption = ", transverse section.";
  add_upright_gear(f, gear, shape, "neighbour");
  f.line({{0.0, f.y.lo}, {0.0, f.y.hi}}, "thin dashdot");
  for (const NamedCircle& c : circles_of(gear)) {
    f.circle(Vec2::Zero(), c.radius, std::string("thin") + c.style, -1, "", c.symbol);
    lead_circle(f, c.radius, c.symbol, decimals_of(2 * c.radius));
  }
  add_upright_arcs(f, gear, arc_style);
  std::vector<ArcName> shown;
  for (const Arc& arc : gear.tooth->outline.arcs) {
    if (&arc != &gear.tooth->outline.arcs.front())
      for (const Vec2& p : {arc.begin_point, mirrored(arc.begin_point)})
        f.dot(upright(p), 2.2, "mark");
    if (add_once(shown, arc.name))
      f.keys.push_back({arc_style(arc.name), words_of(gear, arc.name)});
  }
  return f;
}

bool shift_is_worth_a_picture(const Gear& gear) {
  if (!has_outline(gear) || !gear.straight_cutter()) return false;
  if (gear.spec.teeth > kMaxTeeth) return false;
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
    if (!cut) continue;  // this shift is outside the limits of a spec
    ShiftedTooth t{x, x == own, std::move(cut).take(), std::nullopt};
    spec.root_fillet = gear.spec.root_fillet.value_or(RootFilletSpec{});
    // The tooth gets the given tip fillet if this fits. Otherwise it gets the tip without fillet.
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
  const Bounds view = window(teeth);
  std::string text = fmt::format(
      "<h3>{}: profile shift and root</h3>\n<p>The pictures show the tooth, cut with different "
      "profile shifts, to the same scale. {} {} that begins {}the undercut limit. The dashed "
      "circle is the base circle.</p>\n<div class=\"multiples\">\n",
      name, caption_key("before", "as the rack cuts it"),
      caption_key("c-root-fillet", "circular root fillet"),
      gear.spec.root_fillet ? fmt::format("{:.4g} mm beyond ", gear.spec.root_fillet->offset)
                            : "at ");
  for (std::size_t i = 0; i < teeth.size(); ++i) {
    const ShiftedTooth& t = teeth[i];
    const std::string words = words_of(t);
    const Figure f = tooth_of(t, view, fmt::format("shift{}-{}", i + 1, shape), words);
    text += captioned(figure_svg(f, kSmallFigure),
                      fmt::format("<strong>{} = {:.4g}</strong>{}<br>{}", symbol_html("x"), t.shift,
                                  t.own ? ", this gear" : "", words),
                      t.own ? " class=\"own\"" : "");
  }
  return text + "</div>\n";
}

}  // namespace gearwright
