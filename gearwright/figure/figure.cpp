#include "gearwright/figure/figure.hpp"

#include <algorithm>

#include "gearwright/base/number_text.hpp"
#include "gearwright/figure/ticks.hpp"

namespace gearwright {

using Kind = FigureMark::Kind;

std::string FigureLength::text() const {
  return zeros ? fixed_decimals(value, decimals) : short_decimals(value, decimals);
}

std::string FigureMark::text() const {
  return (kind == Kind::text ? words : label) + (length ? length->text() : "");
}

std::string FigureLeader::text() const { return markup + (length ? length->text() : ""); }

void Figure::line(std::vector<Vec2> points, std::string style, std::string words, int frame) {
  marks.push_back({Kind::line, std::move(style), std::move(points), std::move(words)});
  marks.back().frame = frame;
}

void Figure::area(std::vector<Vec2> points, std::string style, std::string words) {
  if (points.empty()) return;
  marks.push_back({Kind::area, std::move(style), std::move(points), std::move(words)});
}

void Figure::bar(const Vec2& a, const Vec2& b, std::string style, std::string words) {
  marks.push_back({Kind::bar, std::move(style), {a, b}, std::move(words)});
}

void Figure::dot(const Vec2& at, double radius, std::string style, std::string words, int frame) {
  marks.push_back({Kind::dot, std::move(style), {at}, std::move(words)});
  marks.back().radius = radius;
  marks.back().frame = frame;
}

void Figure::text(const Vec2& at, std::string markup, Anchor anchor, std::string style,
                  const Vec2& offset) {
  marks.push_back({Kind::text, std::move(style), {at}, std::move(markup), anchor, offset});
}

void Figure::point(const Vec2& at, double radius, std::string style, std::string label,
                   const Vec2& offset) {
  dot(at, radius, std::move(style));
  marks.back().label = std::move(label);
  marks.back().offset = offset;
}

void Figure::circle(const Vec2& center, double radius, std::string style, int gear,
                    std::string label, std::string words) {
  marks.push_back({Kind::circle, std::move(style), {center}, std::move(words)});
  marks.back().radius = radius;
  marks.back().gear = gear;
  marks.back().label = std::move(label);
}

void Figure::cross(const Vec2& at, std::string label) {
  marks.push_back({Kind::cross, "cross", {at}});
  marks.back().label = std::move(label);
}

Figure plane_figure(std::string id, std::string title, std::string description,
                    const Bounds& window) {
  Figure f{std::move(id), std::move(title), std::move(description), "", {"x", "mm"}, {"y", "mm"}};
  f.x.lo = window.lo.x();
  f.x.hi = window.hi.x();
  f.y.lo = window.lo.y();
  f.y.hi = window.hi.y();
  f.bare = f.plane = true;
  f.tall = window.size().y() / window.size().x();
  return f;
}

double length_of(const std::vector<Vec2>& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

std::vector<Vec2> pieces_of(const std::vector<std::vector<Vec2>>& loops) {
  std::vector<Vec2> points;
  for (const auto& loop : loops) {
    if (!points.empty()) points.push_back(kNewPiece);
    points.insert(points.end(), loop.begin(), loop.end());
  }
  return points;
}

bool fit_axes(Figure& figure, double share, bool from_zero) {
  Vec2 lo = Vec2::Constant(kInfinity);
  Vec2 hi = -lo;
  for (const FigureMark& mark : figure.marks) {
    if (mark.kind != Kind::line || mark.words.empty()) continue;
    for (const Vec2& p : mark.points) {
      if (!std::isfinite(p.x())) continue;
      lo.x() = std::min(lo.x(), p.x());
      hi.x() = std::max(hi.x(), p.x());
      if (!std::isfinite(p.y())) continue;
      lo.y() = std::min(lo.y(), p.y());
      hi.y() = std::max(hi.y(), p.y());
    }
  }
  if (!(lo.x() < hi.x() && lo.y() <= hi.y())) return false;
  const std::vector<double> range = widened(from_zero ? 0.0 : lo.y(), hi.y(), share);
  figure.x.lo = lo.x();
  figure.x.hi = hi.x();
  figure.y.lo = from_zero ? 0.0 : range[0];
  figure.y.hi = range[1];
  return true;
}

}  // namespace gearwright
