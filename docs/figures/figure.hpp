// One figure of the theory pages: an SVG file of its own, drawn by the engine's geometry.
//
// The shapes and the colours are those of the report (figure/svg.hpp, figure_style.css): light, and dark
// for readers who prefer that, on a ground of its own, so that it can be read on any page. Words may hold symbols in braces, "radius {r_b}", which get real indices.
//
//   px    pixels of the picture, y down        mm    the plane of a Viewport, y up
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearwright/figure/svg.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright::figures {

/// A window on a plane in millimetres.
struct Viewport {
  double width, height;  ///< px
  Vec2 center;           ///< mm, the point in the middle of the picture
  double scale;          ///< px/mm
  bool x_up = false;     ///< the x axis of the plane points up; otherwise to the right

  Vec2 px(const Vec2& mm) const {
    const Vec2 d = scale * (mm - center);
    return Vec2(width / 2, height / 2) + (x_up ? Vec2(-d.y(), -d.x()) : Vec2(d.x(), -d.y()));
  }
};

/// Words with symbols in braces as SVG text content.
std::string markup(std::string_view words);

class Figure {
 public:
  /// `name` is the file's, without ".svg"; the title is read aloud.
  Figure(std::string_view name, double width, double height, std::string_view title,
         std::string_view description);

  Svg& svg() { return svg_; }
  std::string_view name() const { return name_; }
  /// The file's text.
  std::string str() const;

  /// Words at `at` + `offset` px; `style` names classes of the figures' style.
  void label(const Vec2& at, std::string_view words, Anchor anchor = Anchor::start,
             const Vec2& offset = Vec2::Zero(), std::string_view style = "");
  /// A line with a head at its end, or at both.
  void arrow(const Vec2& from, const Vec2& to, std::string_view style, bool both = false);
  /// Part of a circle, polar angles from … to in rad of the Viewport's plane, with a head at its
  /// end (1) or at both (2).
  void arc(const Viewport& view, const Vec2& center, double radius, double from, double to,
           std::string_view style, int heads = 0);
  void circle(const Viewport& view, const Vec2& center, double radius, std::string_view style);
  /// Points in mm as a line, and as a filled shape.
  void line(const Viewport& view, const std::vector<Vec2>& mm, std::string_view style);
  void shape(const Viewport& view, const std::vector<Vec2>& mm, std::string_view style);
  void dot(const Viewport& view, const Vec2& mm, std::string_view style, double radius = 3.5);

 private:
  void head(const Vec2& tip, const Vec2& direction, std::string_view style);

  std::string name_;
  Svg svg_;
};

/// Values lo … hi at from … to, px.
struct Axis {
  double lo, hi, from, to;
  double operator()(double v) const { return from + (v - lo) / (hi - lo) * (to - from); }
};

/// A plot's frame with ticks on both axes (no columns: none below) and words: under it, and above
/// its left edge.
struct Plot {
  Axis x, y;
  Vec2 px(double a, double b) const { return {x(a), y(b)}; }
};
void draw_frame(Figure& figure, const Plot& plot, std::string_view foot, std::string_view head,
                int columns = 6, int rows = 6);
/// The finite values as one line.
void draw_curve(Figure& figure, const Plot& plot, const std::vector<Vec2>& values,
                std::string_view style);

/// The transverse outline of half a tooth, root to tip, within `tolerance` mm.
std::vector<Vec2> half_tooth(const Gear& gear, double tolerance);

/// The section of teeth `first` … `last` (whole: 0 … |z| − 1), turned by `angle` rad about the
/// axis. A whole gear is a closed polygon.
std::vector<Vec2> teeth(const Gear& gear, int first, int last, double angle, double tolerance);

/// The points turned about the origin, then moved.
std::vector<Vec2> placed(std::vector<Vec2> points, double angle, const Vec2& shift);
Vec2 polar(double radius, double angle);

/// A gear that exists; a figure's numbers are ours, so anything else is a mistake.
Gear gear_of(const CylindricalSpec& spec);

// ---- the figures, in the order of the pages ----
Figure notation_figure();
Figure frames_figure();
Figure mesh_triangle_figure();
Figure generation_figure();
Figure crossed_figure();
Figure chord_figure();
Figure few_teeth_figure();
Figure arcs_figure();
Figure contact_figure();
Figure search_figure();
Figure inspection_figure();
Figure load_figure();
Figure rating_figure();
Figure drive_figure();
Figure scatter_figure();

}  // namespace gearwright::figures
