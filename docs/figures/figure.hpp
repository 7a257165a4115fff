// One figure of the theory pages, which is an SVG file drawn from the geometry of the engine.
//
// It consists of figures of the room `figure`, as in the report, and of shapes that are drawn here.
// Their colours are those of figure_style.css: light, and dark for readers who prefer that. The
// drawing has its own background, so that it is readable on any page. Words may contain symbols in
// braces, for example "radius {r_b}", which are set with subscripts.
//
//   px    pixels of the picture, y down        mm    the plane of a Viewport, y up
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearwright/figure/figure.hpp"
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

/// Returns words with symbols in braces as the content of an SVG text element.
std::string markup(std::string_view words);

class Drawing {
 public:
  /// `name` is the name of the file without ".svg". A screen reader reads the title aloud.
  Drawing(std::string_view name, double width, double height, std::string_view title,
          std::string_view description);

  Svg& svg() { return svg_; }
  std::string_view name() const { return name_; }
  /// Returns the text of the file.
  std::string str() const;

  /// Draws a figure with its upper left corner at `corner`, px.
  void add(const Figure& figure, const Vec2& corner, double width);
  /// Draws words at `at` + `offset` px. `style` contains names of classes of figure_style.css.
  void label(const Vec2& at, std::string_view words, Anchor anchor = Anchor::start,
             const Vec2& offset = Vec2::Zero(), std::string_view style = "");
  /// Draws a line with an arrowhead at its end, or at both ends.
  void arrow(const Vec2& from, const Vec2& to, std::string_view style, bool both = false);
  /// Draws an arc between the polar angles `from` and `to`, in rad, of the Viewport's plane. It has
  /// no arrowhead, one at its end (1) or one at both ends (2).
  void arc(const Viewport& view, const Vec2& center, double radius, double from, double to,
           std::string_view style, int heads = 0);
  void circle(const Viewport& view, const Vec2& center, double radius, std::string_view style);
  /// line() draws points in mm as an open line, shape() as a filled shape.
  void line(const Viewport& view, const std::vector<Vec2>& mm, std::string_view style);
  void shape(const Viewport& view, const std::vector<Vec2>& mm, std::string_view style);
  void dot(const Viewport& view, const Vec2& mm, std::string_view style, double radius = 3.5);

 private:
  void head(const Vec2& tip, const Vec2& direction, std::string_view style);

  std::string name_;
  Svg svg_;
  std::string figures_;
};

/// Names every second power of ten on a logarithmic axis, "1e4".
void name_decades(FigureAxis& axis);

/// Returns the transverse outline of half a tooth from root to tip, within `tolerance` mm.
std::vector<Vec2> half_tooth(const Gear& gear, double tolerance);

/// Returns the section of the teeth `first` … `last`, turned by `angle` rad about the axis. The
/// teeth 0 … |z| − 1 give the closed polygon of the whole gear.
std::vector<Vec2> teeth(const Gear& gear, int first, int last, double angle, double tolerance);

/// Returns the points, first turned about the origin, then moved.
std::vector<Vec2> placed(std::vector<Vec2> points, double angle, const Vec2& shift);
Vec2 polar(double radius, double angle);

/// Makes a gear. Domain: it exists (contract).
Gear gear_of(const CylindricalSpec& spec);

// ---- the figures, in the order of the pages ----
Drawing notation_figure();
Drawing frames_figure();
Drawing mesh_triangle_figure();
Drawing generation_figure();
Drawing crossed_figure();
Drawing chord_figure();
Drawing few_teeth_figure();
Drawing arcs_figure();
Drawing contact_figure();
Drawing search_figure();
Drawing inspection_figure();
Drawing load_figure();
Drawing rating_figure();
Drawing drive_figure();
Drawing scatter_figure();

}  // namespace gearwright::figures
