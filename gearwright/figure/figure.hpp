// Describes a figure as a value, with marks in the units of its axes, without pixels or colours.
//
// A figure is made once from a result of the engine. It is written as SVG for the report and the
// page (figure_svg.hpp), as PDF and DXF for papers and CAD (cad/figure_files.hpp), and as JSON and
// CSV for the user's own plots (figure_data.hpp). The style of a mark is a list of semantic classes
// ("g1", "edge", "limit"), which figure_style.css turns into colours for light and dark screens and
// for paper.
//
//   Points are given in data coordinates. ±∞ is the edge of the plot. NaN begins a new piece of a
//   line or of an area.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/numbers.hpp"
#include "gearwright/figure/svg.hpp"

namespace gearwright {

inline const Vec2 kNewPiece = Vec2::Constant(kNoNumber);
inline bool is_new_piece(const Vec2& p) { return std::isnan(p.x()) || std::isnan(p.y()); }

/// A value of an axis, and the words at this value as SVG markup.
struct AxisName {
  double at;
  std::string markup;
};

struct FigureAxis {
  std::string words;                 ///< name, "rotation of gear 1"; plain text
  std::string unit;                  ///< "°"; empty for a pure number
  double lo = 0.0, hi = 1.0;         ///< the axis is reversed if hi < lo
  bool whole = false;                ///< only whole numbers are possible
  std::string symbol = {};           ///< "ε_α", after the words
  bool log = false;                  ///< logarithmic axis; 0 < lo < hi
  std::vector<AxisName> names = {};  ///< shown instead of round numbers
};

/// A length at the end of a text of a figure. It is stored as a number, so that the figure can be
/// converted to another unit.
struct FigureLength {
  double value;
  int decimals;
  std::string unit = "mm";
  bool zeros = true;  ///< false if trailing zeros are omitted

  std::string text() const;
};

struct FigureMark {
  enum class Kind {
    line,  ///< through the points
    area,  ///< inside closed pieces; holes run opposite to the outer border
    bar,   ///< a rectangle between two opposite corners
    dot,
    text,
    circle,  ///< about a point, `radius` in the units of the axes
    shape,   ///< a gear's section (gear_shape.hpp); `radius` is the length of a path unit, mm.
             ///< If there is a second point, the shape moves to it during one pitch of gear 1
    cross    ///< marks an axis of rotation
  };
  Kind kind = Kind::line;
  std::string style;
  std::vector<Vec2> points;
  /// For a text, its SVG markup. For other marks, plain text that is shown at the pointer, such as
  /// the name of a curve.
  std::string words = {};
  Anchor anchor = Anchor::start;
  Vec2 offset = Vec2::Zero();  ///< px, from the point to its text
  double radius = 3.0;         ///< px, of a dot
  int frame = -1;              ///< position of the slider at which the mark is shown; −1 for all
  /// The name of a line, dot, circle or cross as SVG markup. The name of a line or a circle is
  /// drawn only if there is room. The label of a dot is tried first at `offset` and −`offset`.
  std::string label = {};
  std::string label_style = {};
  /// For a line, true if the line is the border of an area. The label is then on the right side of
  /// the line, or inside the area. For a bar, true if labels must avoid the whole area of the bar,
  /// and false if they must avoid only its outline.
  bool border = false;
  double turned = 0.0;     ///< rotation of a shape, degrees counter-clockwise
  double per_pitch = 0.0;  ///< rotation of a shape, degrees clockwise, per pitch of gear 1
  int gear = -1;           ///< 0 or 1, −1 for none; determines the label positions of a circle
  bool head = false;       ///< true for a line with an arrowhead at its end
  int group = -1;          ///< index of the group with which the mark turns; −1 for none
  std::optional<FigureLength> length = {};  ///< at the end of a text or of a label

  /// Returns the markup of a text, or of the label of another mark, including its length.
  std::string text() const;
};

/// Dots of one style, spaced by a pitch, that slide along a line with the rotation of gear 1.
/// If gear 1 has turned by t pitches, the dot of tooth k is at `at` + (t + k) `step` and is
/// visible if from ≤ t + k ≤ to.
struct FigureSlide {
  Vec2 at, step;
  double from, to;
  std::string style;
};

/// A point of a plane figure whose name is in a column beside the plot. A line joins the name to
/// the point.
struct FigureLeader {
  Vec2 at;
  std::string markup;                       ///< SVG markup
  std::string style = {};                   ///< style of the words
  Anchor anchor = Anchor::start;            ///< start: right column; end: left column
  std::optional<FigureLength> length = {};  ///< after the markup

  std::string text() const;  ///< the markup with its length
};

/// Marks of a plane figure that turn together.
struct FigureGroup {
  Vec2 about;
  double per_pitch;  ///< degrees clockwise while gear 1 turns by one pitch
};

/// A row of blocks below the plot, aligned with its x axis, such as "tooth pair" and "tip edge
/// of gear 1".
struct FigureLane {
  struct Block {
    double from, to;
    std::string style, words;
  };
  std::string words;
  std::vector<Block> blocks;
};

/// The key that explains the shades of a map, starting with the lowest step.
struct FigureShades {
  std::vector<double> levels;  ///< values at which the shade changes
  std::string most;            ///< words at the upper end of the key
  std::string nothing;         ///< words for points without a value; empty if there are none
};

/// The values that a map shows in shaded steps.
struct FigureGrid {
  std::string words, unit;     ///< name and unit of the values
  std::vector<double> x, y;    ///< data coordinates of the columns and rows
  std::vector<double> values;  ///< row by row; infinite where there is no value
};

/// The meaning of a line or a colour.
struct FigureKey {
  std::string style, words;
};

struct Figure {
  std::string id;           ///< unique in a page
  std::string title;        ///< plain text: the beginning of the caption
  std::string description;  ///< the content in words, for users who cannot see the picture
  std::string caption;      ///< HTML, after the title
  FigureAxis x, y;
  std::string note = {};  ///< the decisive value, at the upper right; plain text
  double tall = 0.45;     ///< height of the plot divided by its width
  double pitch = 0.0;     ///< one pitch of gear 1 along x; 0 if x is not a rotation
  bool bare = false;      ///< a small picture without axes
  bool plane = false;     ///< a region of a plane, with the same scale on both axes
  int frames = 0;         ///< number of positions of the slider; 0 if there is none
  std::vector<FigureMark> marks = {};
  std::vector<FigureLane> lanes = {};
  std::vector<FigureKey> keys = {};
  std::optional<FigureShades> shades = {};
  std::optional<FigureGrid> grid = {};
  std::optional<FigureSlide> slide = {};
  std::vector<FigureLeader> leaders = {};  ///< names beside the plot; if the figure has leaders,
                                           ///< marks are clipped to the plot
  std::vector<FigureGroup> groups = {};
  std::string definitions = {};  ///< SVG definitions of shapes; empty if the page contains them

  void line(std::vector<Vec2> points, std::string style, std::string words = {}, int frame = -1);
  void area(std::vector<Vec2> points, std::string style, std::string words = {});
  void bar(const Vec2& a, const Vec2& b, std::string style, std::string words = {});
  void dot(const Vec2& at, double radius, std::string style, std::string words = {},
           int frame = -1);
  void text(const Vec2& at, std::string markup, Anchor anchor = Anchor::start,
            std::string style = {}, const Vec2& offset = Vec2::Zero());
  /// Adds a dot with a label. `offset`, px, is the preferred position of the label.
  void point(const Vec2& at, double radius, std::string style, std::string label,
             const Vec2& offset);
  void circle(const Vec2& center, double radius, std::string style, int gear,
              std::string label = {}, std::string words = {});
  void cross(const Vec2& at, std::string label = {});
};

/// Makes an empty figure of a plane with this window, mm.
Figure plane_figure(std::string id, std::string title, std::string description,
                    const Bounds& window);

/// Returns the length of a line through these points.
double length_of(const std::vector<Vec2>& line);

/// Joins loops to the points of one area, with kNewPiece between them.
std::vector<Vec2> pieces_of(const std::vector<std::vector<Vec2>>& loops);

/// Fits the axes to all lines that have words. The y axis gets a margin of `share` times its length
/// above and below. If `from_zero` is true, the y axis begins at 0 and has a margin only above.
/// Returns false and changes nothing if no such line extends along x.
bool fit_axes(Figure& figure, double share = 0.06, bool from_zero = false);

}  // namespace gearwright
