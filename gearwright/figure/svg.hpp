// Builds inline SVG pictures and arranges labels without overlap, in pixels.
//
// Positions are pixels of the picture, with y down. Colours and widths are classes of
// figure_style.css, so one picture suits light and dark screens and paper. Strokes, marks and
// labels keep their size when the user zooms. For this purpose, marks and labels are groups of
// class "lb", and the script of the page scales these groups back.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/curve/curve.hpp"

namespace gearwright {

inline constexpr std::array<const char*, 2> kInk{"g1", "g2"};

/// The smallest rectangle that contains some points. It is initially empty.
struct Bounds {
  Vec2 lo{1e300, 1e300};
  Vec2 hi{-1e300, -1e300};
  void cover(const Vec2& p) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  Vec2 size() const { return hi - lo; }
};

enum class Anchor { start, middle, end };

class Svg {
 public:
  /// `id` is unique in the page. Title and description are plain text for screen readers.
  Svg(std::string_view id, double width, double height, std::string_view title,
      std::string_view description);

  /// Begins a group. Marks of this group are visible only inside the rectangle.
  void begin_clip(double x, double y, double width, double height);
  void begin_group(std::string_view attributes);
  void end_group();

  void line(const Vec2& a, const Vec2& b, std::string_view style);
  void polyline(const std::vector<Vec2>& points, std::string_view style);
  void polygon(const std::vector<Vec2>& points, std::string_view style);
  void circle(const Vec2& center, double radius, std::string_view style);
  /// The title is shown at the pointer. It is SVG markup, which the caller has escaped.
  void rect(double x, double y, double width, double height, std::string_view style,
            std::string_view title = "");
  /// `attributes` are inserted unchanged.
  void path(std::string_view d, std::string_view style, std::string_view attributes = "");
  /// Defines a rectangle to which attributes refer as clip-path="url(#id)".
  void define_clip(std::string_view id, double x, double y, double width, double height);
  /// Adds definitions of shapes for use(), as SVG markup.
  void define(std::string_view shapes);
  /// Draws a vertical and a horizontal line that cross at `at`. They extend `half` px to each side,
  /// at every zoom.
  void cross(const Vec2& at, double half, std::string_view style);
  /// Draws a shape that the page defines, turned counter-clockwise by `degrees`. `center` is in px,
  /// and `scale` is px per unit of the shape. `attributes` are inserted unchanged.
  void use(std::string_view shape, const Vec2& center, double scale, double degrees,
           std::string_view style, std::string_view attributes = "");
  /// `markup` is SVG text content, which the caller has escaped or which comes from symbol_svg().
  /// The text is `offset` px from `at`, at every zoom.
  void text(const Vec2& at, std::string_view markup, Anchor anchor = Anchor::start,
            std::string_view style = "", const Vec2& offset = Vec2::Zero());
  /// Draws a dot of constant size. Its title, plain text, is shown at the pointer.
  void dot(const Vec2& at, double radius, std::string_view style, std::string_view title = "");

  std::string str() const;  ///< the element; every group is closed (contract)

 private:
  std::string id_;
  std::string head_;
  std::string body_;
  int open_groups_ = 0;
  int clips_ = 0;
};

/// Places labels as near to `wanted` as possible (least sum of squares), at least `gap` apart and
/// within [lo, hi]. Their order is preserved.
///
/// Domain    gap ≥ 0; if (n − 1) gap > hi − lo, the labels share [lo, hi] evenly
std::vector<double> spread(const std::vector<double>& wanted, double gap, double lo, double hi);

/// Returns a pixel coordinate with two decimals and no trailing zeros. An error of 0.01 px is
/// invisible.
std::string pixel(double value);

}  // namespace gearwright
