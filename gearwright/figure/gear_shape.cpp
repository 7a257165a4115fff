#include "gearwright/figure/gear_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "gearwright/figure/markup.hpp"

namespace gearwright {

namespace {

constexpr int kMaxHalvings = 12;  // at most 4096 chords per arc; a curve with a cusp needs many

double distance_to_chord(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 ab = b - a;
  const double square = ab.squaredNorm();
  const double t = square > 0.0 ? std::clamp((p - a).dot(ab) / square, 0.0, 1.0) : 0.0;
  return (p - a - t * ab).norm();
}

void halve(const Arc& arc, double u0, double u1, const Vec2& p0, const Vec2& p1, double tolerance,
           int depth, std::vector<Vec2>& out) {
  const double um = 0.5 * (u0 + u1);
  const Vec2 pm = arc.point(um);
  double deviation = distance_to_chord(pm, p0, p1);
  for (const double u : {0.5 * (u0 + um), 0.5 * (um + u1)}) {
    deviation = std::max(deviation, distance_to_chord(arc.point(u), p0, p1));
  }
  if (deviation > tolerance && depth < kMaxHalvings) {
    halve(arc, u0, um, p0, pm, tolerance, depth + 1, out);
    halve(arc, um, u1, pm, p1, tolerance, depth + 1, out);
    return;
  }
  out.push_back(p1);
}

bool about_the_axis(const Arc& arc) {
  return arc.name == ArcName::root_land || arc.name == ArcName::tip_land;
}

// Writes integer path commands. A point that rounds to the previous one is omitted.
class Pen {
 public:
  explicit Pen(double unit_mm) : unit_(unit_mm) {}

  void move(const Vec2& p) {
    set(p);
    text_ += fmt::format("M{} {}", x_, y_);
    last_ = 'M';
  }
  void line(const Vec2& p) {
    const auto [dx, dy] = step(p);
    if (dx == 0 && dy == 0) return;
    number(last_ == 'l' ? 0 : 'l', dx);
    number(' ', dy);
    last_ = 'l';
  }
  // Draws an arc about the axis, `clockwise` on the screen.
  void arc(double radius_mm, bool clockwise, const Vec2& p) {
    const auto [dx, dy] = step(p);
    if (dx == 0 && dy == 0) return;
    text_ += fmt::format("a{0} {0} 0 0 {1} {2} {3}", std::lround(radius_mm / unit_),
                         clockwise ? 1 : 0, dx, dy);
    last_ = 'a';
  }
  std::string take() { return std::move(text_); }

 private:
  void set(const Vec2& p) {
    x_ = std::lround(p.x() / unit_);
    y_ = std::lround(-p.y() / unit_);
  }
  std::pair<long, long> step(const Vec2& p) {
    const long x = x_;
    const long y = y_;
    set(p);
    return {x_ - x, y_ - y};
  }
  // Appends a number. A negative number needs no space before it, because its minus sign
  // separates it from the preceding number.
  void number(char before, long value) {
    if (before == 'l') {
      text_ += 'l';
    } else if (value >= 0) {
      text_ += ' ';
    }
    text_ += fmt::format("{}", value);
  }

  double unit_;
  std::string text_;
  long x_ = 0;
  long y_ = 0;
  char last_ = 0;
};

double chord_tolerance(const Gear& gear) {
  // Rounding both ends of a chord moves the chord by at most half a unit in each coordinate.
  static_assert(kOutlineTolerance > 0.75 * kOutlineUnit);
  return (kOutlineTolerance - 0.75 * kOutlineUnit) * gear.spec.normal_module;
}

Vec2 on_side(const Vec2& p, int side) { return {p.x(), side * p.y()}; }

// Draws the arc from the current point, either from root to tip or in reverse.
void draw(Pen& pen, const Gear& gear, const Arc& arc, int side, bool to_tip) {
  const Vec2 target = on_side(to_tip ? arc.end_point : arc.begin_point, side);
  if (about_the_axis(arc)) {
    // Towards the tip, the polar angle decreases on the generated side. This direction is clockwise
    // if y points up.
    pen.arc(arc.begin_point.norm(), to_tip == (side > 0), target);
    return;
  }
  std::vector<Vec2> points = chords(arc, chord_tolerance(gear));
  if (!to_tip) std::reverse(points.begin(), points.end());
  for (std::size_t i = 1; i < points.size(); ++i) pen.line(on_side(points[i], side));
}

std::string circle_path(long r) {
  return fmt::format("M{0} 0A{0} {0} 0 1 1 -{0} 0A{0} {0} 0 1 1 {0} 0", r);
}

// Returns the path of the bore and its keyway. The keyway points along +y of the gear frame.
std::string bore_path(const Bore& bore, double unit_mm) {
  const auto units = [&](double mm) { return std::lround(mm / unit_mm); };
  const double r = bore.diameter / 2;
  const double half = bore.keyway_width / 2;
  if (!(half > 0.0)) return circle_path(units(r));
  const long w = units(half), shoulder = units(std::sqrt((r - half) * (r + half)));
  return fmt::format("M{0} -{1}V-{2}H-{0}V-{1}A{3} {3} 0 1 0 {0} -{1}Z", w, shoulder,
                     units(r + bore.keyway_depth), units(r));
}

// Returns true if the line between the ends of a tooth's outline crosses the bore or its keyway.
bool chord_crosses_bore(const Gear& gear) {
  if (!gear.bore || gear.tooth->outline.arcs.empty()) return false;
  const double reach = gear.bore->diameter / 2 + gear.bore->keyway_depth;
  return gear.tooth->outline.arcs.front().begin_point.x() < reach;
}

}  // namespace

bool has_outline(const Gear& gear) {
  return gear.tooth && gear.exists() && !gear.tooth->outline.arcs.empty();
}

double outline_unit_mm(const Gear& gear) { return kOutlineUnit * gear.spec.normal_module; }

std::vector<Vec2> chords(const Arc& arc, double tolerance) {
  GW_EXPECTS(tolerance > 0.0);
  std::vector<Vec2> points{arc.begin_point};
  // The arc is halved at least once, because a curve that crosses its chord in the middle could
  // otherwise count as straight.
  const Vec2 middle = arc.point(0.5);
  halve(arc, 0.0, 0.5, arc.begin_point, middle, tolerance, 1, points);
  halve(arc, 0.5, 1.0, middle, arc.end_point, tolerance, 1, points);
  return points;
}

std::string outline_path(const std::vector<Vec2>& points, double unit_mm) {
  GW_EXPECTS(!points.empty());
  Pen pen(unit_mm);
  pen.move(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) pen.line(points[i]);
  return pen.take();
}

std::string tooth_path(const Gear& gear) {
  GW_EXPECTS(has_outline(gear));
  const std::vector<Arc>& arcs = gear.tooth->outline.arcs;
  Pen pen(outline_unit_mm(gear));
  pen.move(arcs.front().begin_point);
  for (const Arc& arc : arcs) draw(pen, gear, arc, +1, true);
  for (auto arc = arcs.rbegin(); arc != arcs.rend(); ++arc) draw(pen, gear, *arc, -1, false);
  return pen.take();
}

double drawn_radius(const Gear& gear) {
  if (!gear.internal()) return gear.actual_tip_radius();
  const double r_f = gear.root_diameter / 2;
  if (gear.bore && gear.bore->diameter / 2 > r_f) return gear.bore->diameter / 2;
  return has_outline(gear) ? r_f + kRim * gear.spec.normal_module : r_f;
}

std::string gear_definition(const Gear& gear, const std::string& name) {
  if (!has_outline(gear)) return {};
  const auto units = [&](double mm) { return std::lround(mm / outline_unit_mm(gear)); };
  const std::string tooth = tooth_path(gear);
  const long r_f = units(gear.tooth->root_radius);
  // The fill of a tooth is closed by a chord inside the root circle. The chord is invisible,
  // because a disc fills the root circle. If the chord would cross a bore, the fill is closed by an
  // arc of the root circle instead. The shape inherits its colours from the element that uses it.
  // The attribute vector-effect must be set here, because style sheets do not apply inside the
  // shape.
  std::string text;
  if (!gear.internal()) {
    if (chord_crosses_bore(gear)) {
      const Vec2 begin = gear.tooth->outline.arcs.front().begin_point;
      text = fmt::format(
          "<g id=\"{0}-tooth\"><path stroke=\"none\" d=\"{1}A{2} {2} 0 0 0 {3} {4}Z\"/><path "
          "style=\"fill:none\" vector-effect=\"non-scaling-stroke\" d=\"{1}\"/></g>\n<g "
          "id=\"{0}\">",
          name, tooth, r_f, units(begin.x()), units(-begin.y()));
    } else {
      text = fmt::format(
          "<path id=\"{0}-tooth\" vector-effect=\"non-scaling-stroke\" d=\"{1}\"/>\n<g "
          "id=\"{0}\">",
          name, tooth);
    }
    if (gear.bore) {
      const std::string hole = bore_path(*gear.bore, outline_unit_mm(gear));
      text += fmt::format(
          "<path stroke=\"none\" fill-rule=\"evenodd\" d=\"{}{}\"/><path style=\"fill:none\" "
          "vector-effect=\"non-scaling-stroke\" d=\"{}\"/>",
          circle_path(r_f), r_f > units(gear.bore->diameter / 2) ? hole : std::string(), hole);
    } else {
      text += fmt::format("<circle stroke=\"none\" r=\"{}\"/>", r_f);
    }
  } else {
    // The tooth of an internal gear is attached to the rim. The fill of the tooth is closed within
    // the rim, but the stroke stays open.
    const long rim = units(drawn_radius(gear));
    const double inside = 0.5 * (gear.tooth->root_radius + drawn_radius(gear));
    const Vec2 end =
        gear.tooth->outline.arcs.front().begin_point * (inside / gear.tooth->root_radius);
    text = fmt::format(
        "<g id=\"{0}-tooth\"><path stroke=\"none\" d=\"{1}L{3} {5}A{2} {2} 0 0 0 {3} {4}Z\"/><path "
        "style=\"fill:none\" vector-effect=\"non-scaling-stroke\" d=\"{1}\"/></g>\n<g "
        "id=\"{0}\"><path stroke=\"none\" fill-rule=\"evenodd\" d=\"{6}{7}\"/><circle "
        "style=\"fill:none\" vector-effect=\"non-scaling-stroke\" r=\"{8}\"/>",
        name, tooth, units(inside), units(end.x()), units(-end.y()), units(end.y()),
        circle_path(rim), circle_path(r_f), rim);
  }
  const int z = std::abs(gear.spec.teeth);
  for (int k = 0; k < z; ++k) {
    text += fmt::format("<use href=\"#{}-tooth\" transform=\"rotate({})\"/>", name,
                        fixed(360.0 * k / z, 6));
  }
  return text + "</g>\n";
}

}  // namespace gearwright
