#include "gearwright/figure/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {

namespace {

std::string point(const Vec2& p) { return pixel(p.x()) + " " + pixel(p.y()); }

std::string point_list(const std::vector<Vec2>& points) {
  std::string list;
  for (const Vec2& p : points) {
    if (!list.empty()) list += ' ';
    list += pixel(p.x()) + "," + pixel(p.y());
  }
  return list;
}

}  // namespace

std::string pixel(double value) { return short_decimals(value, 2); }

Svg::Svg(std::string_view id, double width, double height, std::string_view title,
         std::string_view description)
    : id_(id) {
  head_ = fmt::format(
      "<svg class=\"zoom\" id=\"{0}\" viewBox=\"0 0 {1} {2}\" width=\"{1}\" height=\"{2}\" "
      "role=\"img\" tabindex=\"0\" aria-labelledby=\"{0}-t {0}-d\">\n"
      "<title id=\"{0}-t\">{3}</title><desc id=\"{0}-d\">{4}</desc>\n",
      id_, pixel(width), pixel(height), escaped(title), with_minus(escaped(description)));
}

void Svg::define_clip(std::string_view id, double x, double y, double width, double height) {
  body_ += fmt::format(
      "<clipPath id=\"{}\"><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/></clipPath>\n", id,
      pixel(x), pixel(y), pixel(width), pixel(height));
}

void Svg::begin_clip(double x, double y, double width, double height) {
  ++clips_;
  const std::string name = fmt::format("{}-c{}", id_, clips_);
  define_clip(name, x, y, width, height);
  begin_group(fmt::format("clip-path=\"url(#{})\"", name));
}

void Svg::begin_group(std::string_view attributes) {
  ++open_groups_;
  body_ += fmt::format("<g {}>\n", attributes);
}

void Svg::end_group() {
  GW_EXPECTS(open_groups_ > 0);
  --open_groups_;
  body_ += "</g>\n";
}

void Svg::line(const Vec2& a, const Vec2& b, std::string_view style) {
  path(fmt::format("M{}L{}", point(a), point(b)), style);
}

void Svg::polyline(const std::vector<Vec2>& points, std::string_view style) {
  body_ += fmt::format("<polyline class=\"{}\" points=\"{}\"/>\n", style, point_list(points));
}

void Svg::polygon(const std::vector<Vec2>& points, std::string_view style) {
  body_ += fmt::format("<polygon class=\"{}\" points=\"{}\"/>\n", style, point_list(points));
}

void Svg::circle(const Vec2& center, double radius, std::string_view style) {
  body_ += fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", style,
                       pixel(center.x()), pixel(center.y()), pixel(radius));
}

void Svg::rect(double x, double y, double width, double height, std::string_view style,
               std::string_view title) {
  body_ += fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"", style,
                       pixel(x), pixel(y), pixel(width), pixel(height));
  body_ += title.empty() ? "/>\n" : fmt::format("><title>{}</title></rect>\n", with_minus(title));
}

void Svg::path(std::string_view d, std::string_view style, std::string_view attributes) {
  body_ += fmt::format("<path class=\"{}\" d=\"{}\"{}{}/>\n", style, d,
                       attributes.empty() ? "" : " ", attributes);
}

void Svg::define(std::string_view shapes) {
  body_ += fmt::format("<defs class=\"definitions\">\n{}</defs>\n", shapes);
}

void Svg::cross(const Vec2& at, double half, std::string_view style) {
  body_ += fmt::format(
      "<g class=\"lb\" transform=\"translate({0})\"><path class=\"{1}\" "
      "d=\"M-{2} 0H{2}M0 -{2}V{2}\"/></g>\n",
      point(at), style, pixel(half));
}

void Svg::use(std::string_view shape, const Vec2& center, double scale, double degrees,
              std::string_view style, std::string_view attributes) {
  // The unit of a shape is very small, and a gear extends over up to 10^6 units, so the scale needs
  // nine digits.
  body_ += fmt::format(
      "<use class=\"{}\" href=\"#{}\" transform=\"translate({}) scale({:.9g}) rotate({})\"{}{}/>\n",
      style, shape, point(center), scale, fixed(-degrees, 6), attributes.empty() ? "" : " ",
      attributes);
}

void Svg::text(const Vec2& at, std::string_view markup, Anchor anchor, std::string_view style,
               const Vec2& offset) {
  std::string attributes(style);
  if (anchor != Anchor::start) attributes += anchor == Anchor::middle ? " m" : " e";
  if (!attributes.empty()) attributes = fmt::format(" class=\"{}\"", attributes);
  if (offset.x() != 0.0) attributes += fmt::format(" x=\"{}\"", pixel(offset.x()));
  if (offset.y() != 0.0) attributes += fmt::format(" y=\"{}\"", pixel(offset.y()));
  body_ += fmt::format("<g class=\"lb\" transform=\"translate({})\"><text{}>{}</text></g>\n",
                       point(at), attributes, with_minus(markup));
}

void Svg::dot(const Vec2& at, double radius, std::string_view style, std::string_view title) {
  const std::string words =
      title.empty() ? std::string() : fmt::format("<title>{}</title>", with_minus(escaped(title)));
  body_ += fmt::format(
      "<g class=\"lb\" transform=\"translate({})\">{}<circle class=\"{}\" r=\"{}\"/></g>\n",
      point(at), words, style, pixel(radius));
}

std::string Svg::str() const {
  GW_EXPECTS(open_groups_ == 0);
  return head_ + body_ + "</svg>\n";
}

std::vector<double> spread(const std::vector<double>& wanted, double gap, double lo, double hi) {
  const std::size_t n = wanted.size();
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return wanted[i] < wanted[j]; });
  if (n > 1) gap = std::min(gap, (hi - lo) / static_cast<double>(n - 1));

  // The position of label k minus k gaps must not decrease with k. Neighbours that violate this
  // condition are pooled (isotonic regression).
  struct Block {
    double mean;
    std::size_t count;
  };
  std::vector<Block> blocks;
  for (std::size_t k = 0; k < n; ++k) {
    blocks.push_back({wanted[order[k]] - gap * static_cast<double>(k), 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].mean > blocks.back().mean) {
      const Block top = blocks.back();
      blocks.pop_back();
      Block& below = blocks.back();
      const auto weight = [](const Block& b) { return static_cast<double>(b.count); };
      below.mean =
          (below.mean * weight(below) + top.mean * weight(top)) / (weight(below) + weight(top));
      below.count += top.count;
    }
  }
  std::vector<double> placed(n);
  std::size_t k = 0;
  const double room = hi - lo - (n > 0 ? gap * static_cast<double>(n - 1) : 0.0);
  for (const Block& block : blocks) {
    const double base = std::clamp(block.mean, lo, lo + std::max(0.0, room));
    for (std::size_t i = 0; i < block.count; ++i, ++k) {
      placed[order[k]] = base + gap * static_cast<double>(k);
    }
  }
  return placed;
}

}  // namespace gearwright
