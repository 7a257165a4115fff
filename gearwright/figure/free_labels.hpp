// Places labels at free positions of a picture.
//
// Lines, dots and labels that are already drawn are recorded. A new label gets the first of its
// possible positions at which it touches none of these. If no position is free, the label gets the
// position with the fewest overlaps, provided that the caller permits this number. Sizes are
// computed for the letters on a narrow screen, which are the largest.
#pragma once

#include <string_view>
#include <vector>

#include "gearwright/figure/svg.hpp"

namespace gearwright {

struct PixelBox {
  double left, top, right, bottom;
};

/// Returns the width of a line of words, px. `plain` is text without markup.
double label_width(std::string_view plain);

struct LabelPlace {
  Vec2 at;  ///< px, the labelled point
  /// From the labelled point to the middle of the near end of the words, px. For the anchor
  /// `middle`, the vector ends in the middle of the words.
  Vec2 offset;
  Anchor anchor;
};

/// Returns the area of the words. `plain` is their text without markup.
PixelBox label_box(const LabelPlace& place, std::string_view plain);
bool meet(const PixelBox& a, const PixelBox& b);

class FreeLabels {
 public:
  /// All labels are placed inside `within`, except those that may overlap all objects.
  explicit FreeLabels(const PixelBox& within) : within_(within) {}

  void keep_off(const PixelBox& box) { boxes_.push_back(box); }
  void keep_off(const std::vector<Vec2>& polyline);

  /// The objects that a label may overlap. They are none, one line, two lines, or all objects.
  enum class If { free, over_a_line, over_two_lines, always };
  /// Draws the label at the best permitted position of `places`. The width is computed from
  /// `plain`, which is the text of the markup. Returns true if the label is drawn.
  bool draw(Svg& svg, std::string_view plain, std::string_view markup, std::string_view style,
            const std::vector<LabelPlace>& places, If when);

 private:
  int conflicts(const PixelBox& box) const;

  PixelBox within_;
  std::vector<PixelBox> boxes_;
  std::vector<std::vector<Vec2>> lines_;
};

/// Returns the positions at the four sides of a dot and at the corners between them, `distance` px
/// away. Positions in the direction `towards` come first.
std::vector<LabelPlace> places_around(const Vec2& at, double distance, const Vec2& towards);

}  // namespace gearwright
