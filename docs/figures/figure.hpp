// One figure of the theory pages, which is an SVG file drawn from the geometry of the engine.
//
// It consists of figures of the room `figure`, as in the report, with the same style: light, and dark
// for readers who prefer that. The drawing has its own background, so that it is readable on any
// page. Words may contain symbols in braces, for example "radius {r_b}", which are set with
// subscripts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearwright/figure/figure.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright::figures {

/// Returns words with symbols in braces as the content of an SVG text element.
std::string markup(std::string_view words);

class Drawing {
 public:
  /// `name` is the name of the file without ".svg". A screen reader reads the title aloud.
  Drawing(std::string_view name, double width, double height, std::string_view title,
          std::string_view description);

  /// A drawing of one figure, whose id is the name of the file.
  Drawing(const Figure& figure, double width);

  std::string_view name() const { return name_; }
  /// Returns the text of the file.
  std::string str() const;
  /// Draws a figure with its upper left corner at `corner`, px.
  void add(const Figure& figure, const Vec2& corner, double width);

 private:
  std::string name_;
  Svg svg_;
  std::string figures_;
};

/// Names every second power of ten on a logarithmic axis, "1e4".
void name_decades(FigureAxis& axis);

/// The window around `middle`, mm, of a figure of `size` px with `scale` px/mm.
Bounds window(const Vec2& middle, const Vec2& size, double scale);

/// Draws the section of a gear about `at`, turned by `angle` rad. The name of its shape is unique in
/// the file; "NAME-tooth" is tooth 0 of the shape "NAME".
void add_gear(Figure& figure, const Gear& gear, const std::string& name, const std::string& style,
              const Vec2& at, double angle);
/// Draws a line with an arrowhead at its end, or at both ends.
void add_arrow(Figure& figure, std::vector<Vec2> points, const std::string& style,
               bool both = false);

/// Returns points of an arc between the polar angles `from` and `to`, rad.
std::vector<Vec2> arc_points(const Vec2& center, double radius, double from, double to);
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
