// Places labels in free places of a picture.
//
// Lines, dots and labels already drawn are recorded. The first of a label's places that touches
// none of them is used. Sizes are those of the letters on a narrow screen, the largest that the
// page's style has.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gearwright/figure/svg.hpp"

namespace gearwright {

/// A rectangle of the picture, px.
struct PixelBox {
  double left, top, right, bottom;
};

struct LabelPlace {
  Vec2 at;  ///< px, what is named
  Vec2
      offset;  ///< px, from there to the middle of the words' near end; of `middle` to their middle
  Anchor anchor;
};

/// The area of the words on a narrow screen. `plain` is their text without markup.
PixelBox label_box(const LabelPlace& place, std::string_view plain);
bool meet(const PixelBox& a, const PixelBox& b);

class FreeLabels {
 public:
  /// `within` contains all labels.
  explicit FreeLabels(const PixelBox& within) : within_(within) {}

  void keep_off(const PixelBox& box) { boxes_.push_back(box); }
  void keep_off(const std::vector<Vec2>& polyline);

  /// What a label may overlap: nothing, one line, or everything.
  enum class If { free, over_a_line, over_two_lines, always };
  /// Draws the label at the best permitted one of `places`. `plain` is the text of the markup, for
  /// its width. Returns true if it is drawn.
  bool draw(Svg& svg, std::string_view plain, std::string_view markup, std::string_view style,
            const std::vector<LabelPlace>& places, If when);

 private:
  int conflicts(const PixelBox& box) const;

  PixelBox within_;
  std::vector<PixelBox> boxes_;
  std::vector<std::vector<Vec2>> lines_;
};

struct Leader {
  Vec2 from;           ///< px, what is named
  std::string markup;  ///< SVG text content
};

/// Draws labels in a column beside a plot, at `x` and to its right, each with a line to its point,
/// one below the other in the order of the points, between the top and `height`.
void draw_leaders(Svg& svg, const std::vector<Leader>& leaders, double x, double height);

/// The point at which a circle about `axis` leaves a plot at its right edge, or ends before if it
/// is small; px.
Vec2 leaves_right(const Vec2& axis, double radius, double edge);

/// The four sides of a dot and the corners between them, `distance` px away; those towards
/// `towards` first.
std::vector<LabelPlace> places_around(const Vec2& at, double distance, const Vec2& towards);

}  // namespace gearwright
