#include "gearwright/report/named_circles.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/report/html_text.hpp"

namespace gearwright {

namespace {

constexpr double kEdge = 30.0;  // px from the edge at which a circle's line to its symbol begins
constexpr double kAway = 0.80;  // cosine of the angle at which the line to a whole circle's symbol
                                // begins

struct Named {
  std::string symbol;
  Vec2 from;  // px
};

// A symbol's letters: "d_w1" shows "dw1".
std::size_t letters(const std::string& symbol) {
  return symbol.size() - static_cast<std::size_t>(std::count(symbol.begin(), symbol.end(), '_'));
}

void name_in_row(Svg& svg, const Viewport& view, std::size_t gear, const std::vector<Named>& named,
                 std::vector<PixelBox>& taken) {
  std::vector<double> wanted;
  for (const Named& n : named) wanted.push_back(n.from.x());
  const std::vector<double> placed = spread(wanted, 36.0, 20.0, view.width - 20.0);
  for (std::size_t k = 0; k < named.size(); ++k) {
    const double y = gear == 0 ? 18.0 : view.height - 11.0;
    svg.line(named[k].from, {placed[k], gear == 0 ? y + 4 : y - 12}, "leader");
    svg.text({placed[k], y}, symbol_svg(named[k].symbol), Anchor::middle,
             std::string("halo ") + kInk[gear]);
    taken.push_back(label_box({{placed[k], y}, {0.0, -5.0}, Anchor::middle},
                              std::string(letters(named[k].symbol), 'd')));
  }
}

void name_in_column(Svg& svg, const Viewport& view, double side, std::size_t gear,
                    const std::vector<Named>& named, std::vector<PixelBox>& taken) {
  std::vector<double> wanted;
  for (const Named& n : named) wanted.push_back(n.from.y());
  const std::vector<double> placed = spread(wanted, 20.0, 14.0, view.height - 14.0);
  for (std::size_t k = 0; k < named.size(); ++k) {
    const double x = side > 0.0 ? 34.0 : view.width - 34.0;
    svg.line(named[k].from, {x + side * 4.0, placed[k]}, "leader");
    const Anchor anchor = side > 0.0 ? Anchor::end : Anchor::start;
    svg.text({x, placed[k]}, symbol_svg(named[k].symbol), anchor, std::string("halo ") + kInk[gear],
             {0.0, 4.0});
    taken.push_back(label_box({{x, placed[k]}, Vec2::Zero(), anchor},
                              std::string(letters(named[k].symbol), 'd')));
  }
}

}  // namespace

std::vector<NamedCircle> mesh_circles(const InvolutePair& pair, std::size_t i) {
  const std::string n = std::to_string(i + 1);
  return {{"d_a" + n, pair.gears[i].actual_tip_radius(), ""},
          {"d_w" + n, pair.mesh.rack.sides[i].pitch_radius, " dashdot"},
          {"d_b" + n, pair.gears[i].base_radius(), " dash"}};
}

std::vector<PixelBox> draw_named_circles(Svg& svg, const Viewport& view, const Vec2& axis_mm,
                                         double side, std::size_t gear,
                                         const std::vector<NamedCircle>& circles) {
  const Vec2 axis = view.px(axis_mm);
  const double edge = gear == 0 ? kEdge : view.height - kEdge;
  std::vector<Named> row;
  std::vector<Named> column;
  for (const NamedCircle& c : circles) {
    const double r = c.radius * view.scale;
    svg.circle(axis, r, std::string("thin ") + kInk[gear] + c.style);
    const double dy = edge - axis.y();
    if (r < std::abs(dy)) {
      const double up = std::sqrt(1.0 - kAway * kAway);
      const Vec2 from(axis.x() - side * kAway * r, axis.y() + (gear == 0 ? -up : up) * r);
      if (from.x() > 40.0 && from.x() < view.width - 40.0) column.push_back({c.symbol, from});
      continue;
    }
    const double x = axis.x() + side * std::sqrt((r - dy) * (r + dy));
    if (x < 0.0 || x > view.width) continue;  // leaves the window elsewhere
    row.push_back({c.symbol, {x, edge}});
  }
  std::vector<PixelBox> taken;
  name_in_row(svg, view, gear, row, taken);
  name_in_column(svg, view, side, gear, column, taken);
  return taken;
}

}  // namespace gearwright
