// Labels that look for a free place in a picture.
//
// Lines, dots and labels already drawn are remembered; a new label tries its places in their order
// and takes the first that touches none of them. Sizes are those of the letters on a narrow screen,
// the largest that the page's style has.
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

/// What the words cover, on a narrow screen. `plain` is their text without markup.
PixelBox label_box(const LabelPlace& place, std::string_view plain);
bool meet(const PixelBox& a, const PixelBox& b);

class FreeLabels {
 public:
  /// `within`: no label leaves it.
  explicit FreeLabels(const PixelBox& within) : within_(within) {}

  void keep_off(const PixelBox& box) { boxes_.push_back(box); }
  void keep_off(const std::vector<Vec2>& polyline);

  /// What a label may touch: nothing, one line, or whatever is there.
  enum class If { free, over_a_line, always };
  /// Draws the label at the best of `places` if that may be. `plain` is the markup's text, for its
  /// width. True: drawn.
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

/// Draws labels in a column beside a plot, at `x` and to its right, each with a line to what it names,
/// one below the other in the order of that, between the top and `height`.
void draw_leaders(Svg& svg, const std::vector<Leader>& leaders, double x, double height);

/// Where a circle about `axis` leaves a plot at its right edge, or before when it is small; px.
Vec2 leaves_right(const Vec2& axis, double radius, double edge);

/// The four sides of a dot and the corners between them, `distance` px away; those towards
/// `towards` first.
std::vector<LabelPlace> places_around(const Vec2& at, double distance, const Vec2& towards);

}  // namespace gearwright
