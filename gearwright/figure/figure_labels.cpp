#include "gearwright/figure/figure_labels.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {

namespace {

using Kind = FigureMark::Kind;
using Places = std::vector<LabelPlace>;

constexpr double kDot = 5.0;     // px, half the side of the box around a dot, which labels avoid
constexpr double kMiddle = 5.0;  // px from the middle of the letters down to the base line
// Neighbouring candidate positions on a circle are kTurn (rad) or kStep (px along the circle)
// apart, whichever distance is smaller.
constexpr double kTurn = 0.035, kStep = 24.0;
constexpr int kMostSteps = 4000;
constexpr std::size_t kEnough = 60;

// Returns the point at a given fraction of the length of a line, px, and the direction of the line
// at this point.
std::pair<Vec2, Vec2> at_share(const std::vector<Vec2>& line, double share) {
  double left = share * length_of(line);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 d = line[i] - line[i - 1];
    const double part = d.norm();
    if (part > 0.0 && (left <= part || i + 1 == line.size()))
      return {line[i - 1] + d * std::min(1.0, left / part), d / part};
    left -= part;
  }
  return {line.front(), {1.0, 0.0}};
}

bool labelled(const FigureMark& m) { return m.kind != Kind::text && !m.text().empty(); }

bool inside(const std::vector<Vec2>& polygon, const Vec2& p) {
  bool is = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) is = !is;
  }
  return is;
}

class Labels {
 public:
  Labels(Svg& svg, const Figure& figure, const FigurePlace& place)
      : svg_(svg),
        f_(figure),
        at_(place),
        free_({place.plot.left + 4, place.plot.top + 4, place.plot.right - 4,
               place.plot.bottom - 4}) {}

  void write() {
    keep_off_marks();
    for (const FigureMark& m : f_.marks) {
      if (labelled(m) && (m.kind == Kind::dot || m.kind == Kind::cross))
        write(m, "letter halo", about_dot(m), FreeLabels::If::always);
    }
    // Borders are labelled before other lines.
    for (const bool border : {true, false}) {
      for (const FigureMark& m : f_.marks) {
        if (!labelled(m) || m.kind != Kind::line || m.border != border) continue;
        write(m, "halo", border ? beside_border(m) : beside_line(m),
              border ? FreeLabels::If::over_two_lines : FreeLabels::If::free);
      }
    }
    for (const FigureMark& m : f_.marks) {
      if (labelled(m) && m.kind == Kind::circle)
        write(m, std::string("halo circle-name ") + kInk[static_cast<std::size_t>(m.gear)],
              on_circle(m), FreeLabels::If::free);
    }
  }

 private:
  void write(const FigureMark& m, const std::string& style, const Places& places,
             FreeLabels::If when) {
    free_.draw(svg_, without_tags(m.text()), m.text(),
               m.label_style.empty() ? style : m.label_style, places, when);
  }

  std::vector<Vec2> px(const std::vector<Vec2>& points) const {
    std::vector<Vec2> found;
    for (const Vec2& p : points)
      if (p.allFinite()) found.push_back(at_.px(p));
    return found;
  }

  void keep_off_marks() {
    for (const FigureMark& m : f_.marks) {
      if (m.kind == Kind::line) free_.keep_off(px(m.points));
      if (m.kind == Kind::text)
        free_.keep_off(label_box({at_.px(m.points[0]), m.offset - Vec2(0.0, kMiddle), m.anchor},
                                 without_tags(m.text())));
      if (m.kind == Kind::dot || m.kind == Kind::cross) {
        const Vec2 p = at_.px(m.points[0]);
        free_.keep_off(PixelBox{p.x() - kDot, p.y() - kDot, p.x() + kDot, p.y() + kDot});
      }
      if (m.kind == Kind::bar) {
        const Vec2 a = at_.px(m.points[0]), b = at_.px(m.points[1]);
        const Vec2 lo = a.cwiseMin(b), hi = a.cwiseMax(b);
        if (m.border)
          free_.keep_off(PixelBox{lo.x(), lo.y(), hi.x(), hi.y()});
        else
          free_.keep_off(std::vector<Vec2>{lo, {hi.x(), lo.y()}, hi, {lo.x(), hi.y()}, lo});
      }
    }
  }

  Places about_dot(const FigureMark& m) const {
    const Vec2 p = at_.px(m.points[0]);
    const auto beside = [&](const Vec2& offset) {
      // A label of four or more bytes begins or ends at the offset. A shorter label is centred on
      // the offset.
      const bool letter = without_tags(m.text()).size() < 4;
      return LabelPlace{p, offset,
                        letter             ? Anchor::middle
                        : offset.x() > 0.0 ? Anchor::start
                                           : Anchor::end};
    };
    Places places;
    if (m.kind == Kind::dot) places = {beside(m.offset), beside(-m.offset)};
    for (const double away : {14.0, 24.0, 36.0})
      for (const LabelPlace& one : places_around(p, away, {0.0, 1.0})) places.push_back(one);
    return places;
  }

  // Borders run counter-clockwise, so a position on the right of a border is outside the area. Most
  // labels have such a position. A position on the left is used only if it lies inside an area. In
  // a narrow region, it could otherwise lie beyond the opposite border.
  Places beside_border(const FigureMark& m) const {
    const std::vector<Vec2> line = px(m.points);
    Places places;
    if (line.size() < 2) return places;
    for (const double distance : {11.0, 24.0, -12.0, 38.0, -26.0, 52.0}) {
      for (const double share : {0.5, 0.35, 0.65, 0.2, 0.8, 0.05, 0.95, 0.12, 0.88, 0.27, 0.73}) {
        const auto [at, along] = at_share(line, share);
        // y points down
        const Vec2 out = (distance < 0 ? -1.0 : 1.0) * Vec2(-along.y(), along.x());
        const Anchor anchor = out.x() > 0.3    ? Anchor::start
                              : out.x() < -0.3 ? Anchor::end
                                               : Anchor::middle;
        const LabelPlace place{at, std::abs(distance) * out, anchor};
        if (distance > 0 || in_an_area(place.at + place.offset)) places.push_back(place);
      }
    }
    return places;
  }

  bool in_an_area(const Vec2& p) const {
    return std::any_of(f_.marks.begin(), f_.marks.end(), [&](const FigureMark& m) {
      return m.kind == Kind::area && inside(px(m.points), p);
    });
  }

  Places beside_line(const FigureMark& m) const {
    const std::vector<Vec2> line = px(m.points);
    Places places;
    if (line.size() < 2) return places;
    for (const double away : {9.0, 13.0}) {
      for (const double share : {0.02, 0.98, 0.06, 0.94, 0.1, 0.9, 0.2, 0.8, 0.3, 0.7, 0.4, 0.6}) {
        const Vec2 at = at_share(line, share).first;
        places.push_back({at, {7, -away}, Anchor::start});
        places.push_back({at, {-7, away}, Anchor::end});
        places.push_back({at, {7, away}, Anchor::start});
        places.push_back({at, {-7, -away}, Anchor::end});
      }
    }
    return places;
  }

  // Returns visible positions on the circle, beginning near the mesh. For gear 1, the positions
  // above the mesh come first. For gear 2, the positions below the mesh come first.
  Places on_circle(const FigureMark& m) const {
    const PixelBox& plot = at_.plot;
    const Vec2 c = at_.px(m.points[0]);
    const double r = m.radius * at_.per_unit, step = std::min(kTurn, kStep / r);
    const double facing = c.x() < (plot.left + plot.right) / 2 ? 0.0 : kPi;
    Places places;
    for (const double up : {m.gear == 0 ? 1.0 : -1.0, m.gear == 0 ? -1.0 : 1.0}) {
      for (int k = 4; k < kMostSteps && k * step < 3.0 && places.size() < kEnough; ++k) {
        const double a = facing + (facing == 0.0 ? up : -up) * k * step;
        const Vec2 p = c + r * Vec2(std::cos(a), -std::sin(a));
        if (p.x() > plot.left && p.x() < plot.right && p.y() > plot.top && p.y() < plot.bottom)
          places.push_back({p, Vec2::Zero(), Anchor::middle});
      }
    }
    return places;
  }

  Svg& svg_;
  const Figure& f_;
  const FigurePlace& at_;
  FreeLabels free_;
};

}  // namespace

void write_labels(Svg& svg, const Figure& figure, const FigurePlace& place) {
  const bool any = std::any_of(figure.marks.begin(), figure.marks.end(), labelled);
  if (any) Labels(svg, figure, place).write();
}

}  // namespace gearwright
