#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/report/gear_figures.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/page_parts.hpp"

namespace gearwright {

namespace {

constexpr double kRootAspect = 1.0;  // width over height of the plot
// Margin on each side, relative to the height and width of the plot.
constexpr double kRootMargin = 0.055;
constexpr int kFewTeeth = 12;  // with more teeth, a root without undercut looks like any other

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
  return center_of(*gear.tooth->root_fillet, kPi / gear.spec.teeth);
}

// True if F, the point of the flank at which undercut begins, lies on this tooth. F does not lie on
// this tooth if it is beyond the middle of the space.
bool shows_limit(const Gear& gear) {
  return gear.reference().base_tooth_thickness / gear.reference().base_diameter <
         kPi / gear.spec.teeth;
}

// Returns points on the part of the tooth that the picture must show, mm. This part is the whole
// tooth if the tip has a fillet, or if a gear with circular fillets has at most 4 teeth. Otherwise,
// it is the root on the right, up to slightly above the start of the flank.
std::vector<Vec2> points_shown(const Gear& gear, const std::optional<Gear>& rack) {
  const bool whole = gear.tooth->tip_fillet || (rack && gear.spec.teeth <= 4);
  const double start = std::max(gear.base_radius(), gear.root_form_radius().value_or(0.0));
  const double top = whole ? 2 * gear.actual_tip_radius() : start + 0.6 * gear.spec.normal_module;
  std::vector<Vec2> points;
  const auto add = [&](const Gear& g) {
    for (const Arc& arc : g.tooth->outline.arcs) {
      for (const Vec2& p : sample(arc, 40)) {
        if (p.norm() > top) continue;
        points.push_back(p);
        if (whole) points.push_back(mirrored(p));
      }
    }
  };
  add(gear);
  if (rack && has_outline(*rack)) add(*rack);
  if (gear.tooth->root_fillet) points.push_back(root_center(gear));
  if (shows_limit(gear)) points.push_back(undercut_limit_point(gear));
  return points;
}

Bounds window(const Gear& gear, const std::optional<Gear>& rack) {
  Bounds box;
  for (const Vec2& p : points_shown(gear, rack)) box.cover(upright(p));
  const double tall =
      std::max(box.size().x() / kRootAspect, box.size().y()) / (1.0 - 2 * kRootMargin);
  const Vec2 middle = (box.lo + box.hi) / 2, half(tall * kRootAspect / 2, tall / 2);
  return {middle - half, middle + half};
}

// Draws the flank that undercut removed, from the base circle to the start of the remaining flank.
void add_lost_flank(Figure& f, const Gear& gear) {
  const Involute flank(gear.base_radius(),
                       gear.reference().base_tooth_thickness / gear.reference().base_diameter);
  const double end = flank.roll_at(gear.root_form_radius().value_or(gear.actual_tip_radius()));
  std::vector<Vec2> right, left;
  for (int k = 0; k <= 32; ++k) {
    const Vec2 p = flank.point(end * k / 32);
    right.push_back(upright(p));
    left.push_back(upright(mirrored(p)));
  }
  f.line(std::move(right), "before");
  f.line(std::move(left), "before");
}

// Draws the circle of a fillet with its centre, and the radius to the point of tangency.
void add_fillet(Figure& f, const FilletArc& arc, const Vec2& center, const Vec2& touch,
                const char* symbol) {
  constexpr double kReadable = 0.085;  // of the width of the plot; a shorter radius has no label
  f.circle(center, arc.radius, "thin dot", -1);
  f.line({center, touch}, "thin");
  f.dot(center, 2.2, "mark hollow");
  if ((touch - center).norm() > kReadable * (f.x.hi - f.x.lo))
    f.text((center + touch) / 2, symbol_svg(symbol), Anchor::middle, "halo", {0.0, -6.0});
}

FigureLeader led(const Vec2& at, std::string markup, double length) {
  FigureLeader leader{at, std::move(markup) + " "};
  leader.length = {length, kLengthDigits};
  return leader;
}

FigureLeader with_l(const Vec2& at, const char* letter, double l) {
  return led(at, fmt::format("<tspan class=\"letter\">{}</tspan> ", letter) + symbol_svg("l"), l);
}

std::vector<FigureLeader> marks_of(const Gear& gear) {
  const InvoluteTeeth& teeth = *gear.involute();
  std::vector<FigureLeader> marks;
  if (gear.tooth->tip_fillet && teeth.point_j_l)
    marks.push_back(with_l(upright(flank_of(gear).end_point), "J", *teeth.point_j_l));
  if (gear.tooth->root_fillet && teeth.point_c_l) {
    marks.push_back(with_l(upright(flank_of(gear).begin_point), "C", *teeth.point_c_l));
  } else if (has_flank(gear)) {
    const Vec2 start = flank_of(gear).begin_point;
    marks.push_back(led(upright(start), symbol_svg("d_Ff"), 2 * start.norm()));
  }
  if (shows_limit(gear) && teeth.undercut_l)
    marks.push_back(with_l(upright(undercut_limit_point(gear)), "F", *teeth.undercut_l));
  return marks;
}

std::string behind_words(const Gear& gear, const std::optional<Gear>& rack) {
  const auto key = [](const char* words) { return caption_key("before", words) + " "; };
  if (rack && has_outline(*rack)) {
    return key(rack->undercut ? "the undercut tooth as cut by the rack alone"
                              : "the tooth as cut by the rack alone");
  }
  if (gear.tooth->root_fillet || gear.tooth->tip_fillet)
    return "The rack alone would leave no tooth. ";
  return gear.undercut ? key("flank removed by undercut") : "";
}

}  // namespace

bool root_is_worth_a_picture(const Gear& gear) {
  if (!has_outline(gear) || !gear.straight_cutter() || !has_flank(gear)) return false;
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

Figure root_plot(const Gear& gear, const std::string& shape, const std::string& name) {
  GW_EXPECTS(root_is_worth_a_picture(gear));
  const std::optional<Gear> rack = by_rack_alone(gear);
  Figure f = plane_figure("root-" + shape, name + ": root of the tooth",
                          "The tooth in the transverse section with its arcs in colours. Behind "
                          "the tooth, dashed lines show the base circle and the root that the rack "
                          "alone would leave. F, C and J are points on the flank.",
                          window(gear, rack));
  add_upright_gear(f, gear, shape, "neighbour");
  f.line({{0.0, f.y.lo}, {0.0, f.y.hi}}, "thin dashdot");
  const double space = kPi / gear.spec.teeth, far = 2 * gear.actual_tip_radius();
  f.line({Vec2::Zero(), far * Vec2(std::sin(space), std::cos(space))}, "thin dashdot");
  f.circle(Vec2::Zero(), gear.base_radius(), "thin dash", -1, "", "base circle");
  if (rack && has_outline(*rack)) add_upright_arcs(f, *rack, [](ArcName) { return "before"; });
  if (!rack && gear.undercut) add_lost_flank(f, gear);
  add_upright_arcs(f, gear, arc_style);
  if (const auto& arc = gear.tooth->root_fillet)
    add_fillet(f, *arc, upright(root_center(gear)), upright(flank_of(gear).begin_point), "r_r");
  if (const auto& arc = gear.tooth->tip_fillet)
    add_fillet(f, *arc, upright(center_of(*arc, arc->land.rad())),
               upright(flank_of(gear).end_point), "r_t");
  f.leaders = marks_of(gear);
  for (const FigureLeader& mark : f.leaders) f.dot(mark.at, 2.6, "mark");
  lead_circle(f, gear.base_radius(), "d_b", kLengthDigits);
  return f;
}

std::string root_figure(const Gear& gear, const std::string& shape, const std::string& name,
                        UnitSystem units) {
  if (!root_is_worth_a_picture(gear)) return {};
  const std::optional<Gear> rack = by_rack_alone(gear);
  std::string words = behind_words(gear, rack);
  words += fmt::format("<b>F</b> is the lowest possible start of the flank. {}.",
                       gear.involute()->undercut_l < 0.0
                           ? "The rack does not reach this point, so there is no undercut"
                           : "The rack reaches this point and undercuts the flank");
  if (gear.tooth->root_fillet) {
    words += fmt::format(" At <b>C</b>, the root fillet with {} = {} mm touches the flank.",
                         symbol_html("r_r"), fixed(gear.tooth->root_fillet->radius, kLengthDigits));
  }
  if (gear.tooth->tip_fillet) {
    words += fmt::format(" At <b>J</b>, the tip fillet with {} = {} mm touches the flank.",
                         symbol_html("r_t"), fixed(gear.tooth->tip_fillet->radius, kLengthDigits));
  }
  Figure f = root_plot(gear, shape, name);
  f.caption = ". " + words;
  return figure_html(in_units(units, f), kPlaneFigure);
}

}  // namespace gearwright
