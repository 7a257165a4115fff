#include "gearwright/cad/rack_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "gearwright/cad/biarc.hpp"
#include "gearwright/cad/drawing.hpp"
#include "gearwright/cad/sheet_page.hpp"
#include "gearwright/cad/sheet_symbols.hpp"

namespace gearwright {

namespace {

// The views have the same scale. The origin is on the datum line, in the middle of the section. A
// point is drawn at (−y, x) in the section, at (−y, −z) in the plan below the section, and at (z,
// x) in the end view to the right of the section.
class RackViews : public SheetViews {
 public:
  // `outline` contains all teeth or, for an interrupted view, the teeth at one end.
  RackViews(const RackSheetInput& input, const BiarcChain& outline, double scale)
      : input_(input), outline_(outline), k_(scale) {
    const RackGeometry& rack = input.rack;
    interrupted_ = rack.teeth > kTeethInFull;
    const double part = k_ * rack.transverse_pitch * (interrupted_ ? kTeethAtEnd : rack.teeth);
    right_ = interrupted_ ? part + kBreak / 2 : part / 2;
    back_ = -k_ * rack.height;
    tip_ = k_ * rack.addendum;
    shelf_ = tip_ + kShelf;
    face_ = k_ * rack.face_width;
    const Dimension length = length_dimension();
    end_ = right_ + kGap + (has_room(length) ? 0.0 : kTail + text_width(length.words, kUsual));
    place_plan();
  }

  SheetBox box() const override {
    double right =
        std::max(end_ + face_ + kFirst + kNext + kPast, -right_ + text_width(kCaption, kUsual));
    double low = width_dimension().begin;
    for (const Dimension& d : {width_dimension(), height_dimension(), whole_dimension()})
      low = std::min(low, reach_of(d).lo);
    if (input_.surfaces.flank_texture)
      right = std::max(right, flank().x() + texture_width(*input_.surfaces.flank_texture));
    if (input_.surfaces.face_texture) right = std::max(right, face_texture_end());
    return {{-right_ - kFirst - kUsual - 2, low - 1}, {right, caption() + kUsual + 1}};
  }

  void draw() override {
    section();
    end_view();
    plan();
  }

 private:
  // Lengths in mm on paper.
  //   kAxis           projection of the datum line beyond the part
  //   kFirst, kNext   from the view to the first dimension line, and between dimension lines
  //   kPast           projection of an extension line beyond its dimension line
  //   kTail           length of a dimension line beyond an outside arrow
  //   kGap, kBreak    between the views, and between the parts of an interrupted view
  //   kShelf          from the tips to the shelf of the flank texture
  //   kClear          distance of symbols and texts from other parts
  //   kZigzag         amplitude of a break line
  //   kLines          distance between two lines that show the direction of the teeth
  static constexpr double kAxis = 3, kFirst = 10, kNext = 8, kPast = 1.5, kTail = 6, kGap = 8;
  static constexpr double kBreak = 6, kShelf = 5, kClear = 2, kZigzag = 1.5, kLines = 2.5;
  static constexpr const char* kCaption = "Section in the middle of the face width";
  static constexpr const char* kBoth = "2×";  // the texture applies to both faces
  static constexpr auto kOutline = SheetLayer::outline, kThin = SheetLayer::dimension;

  static double texture_width(const std::string& words) {
    return texture_left() + texture_right(words);
  }

  // The plan lies below the dimension of the length. If the faces have a texture symbol, it is
  // between this dimension and the plan. If the symbol extends to the right below the end view, the
  // plan also lies below the dimensions of the end view.
  void place_plan() {
    top_ = back_ - kFirst - kPast - 2 * kClear;
    if (!input_.surfaces.face_texture) return;
    top_ = back_ - kFirst - kPast - 1 - kTextureHeight;
    if (face_texture_end() < end_ + face_) return;
    for (const Dimension& d : {height_dimension(), whole_dimension()})
      top_ = std::min(top_, reach_of(d).lo - 1 - kTextureHeight);
  }
  double face_texture_foot() const {
    return -right_ + 1 + text_width(kBoth, kUsual) + 1 + texture_left();
  }
  double face_texture_end() const {
    return face_texture_foot() + texture_right(*input_.surfaces.face_texture);
  }

  // Returns the point at which the datum line crosses a flank of the first tooth. This flank faces
  // the middle of the rack.
  Vec2 flank() const {
    const RackGeometry& rack = input_.rack;
    const double thickness = rack.thickness / std::cos(rack.helix_angle.rad());
    return {-right_ + k_ * (rack.transverse_pitch + thickness) / 2, 0.0};
  }
  // Returns the height of the base line of the caption.
  double caption() const {
    return input_.surfaces.flank_texture ? shelf_ + kTextureHeight + kClear : tip_ + kClear;
  }

  Dimension length_dimension() const {
    const double length = input_.rack.teeth * input_.rack.transverse_pitch;
    return {Direction::across,
            -right_,
            right_,
            back_,
            back_,
            back_ - kFirst,
            computed_length_text(input_.units, length)};
  }
  // Returns a height from the back as text. If the user gives the height, it is not rounded to µm.
  std::string height_text(double mm) const {
    return input_.rack.bar.height ? length_text(input_.units, mm)
                                  : computed_length_text(input_.units, mm);
  }
  Dimension height_dimension() const {
    const double x = end_ + face_;
    return {Direction::up, back_, 0.0, x, x + kAxis, x + kFirst, height_text(input_.rack.height)};
  }
  Dimension whole_dimension() const {
    const double x = end_ + face_;
    return {Direction::up,
            back_,
            tip_,
            x,
            x,
            x + kFirst + kNext,
            height_text(input_.rack.height + input_.rack.addendum)};
  }
  Dimension width_dimension() const {
    return {Direction::up,
            top_ - face_,
            top_,
            -right_,
            -right_,
            -right_ - kFirst,
            length_text(input_.units, input_.rack.face_width)};
  }

  void path(SheetLayer layer, std::vector<Vec2> points, std::vector<double> bulges, bool closed) {
    for (Vec2& p : points) p += origin_;
    sheet_->paths.push_back({layer, std::move(points), std::move(bulges), closed});
  }

  // Draws two straight lines with a zigzag in the middle.
  void break_lines(double lo, double hi) {
    const double m = (lo + hi) / 2, z = std::min(kZigzag, (hi - lo) / 8);
    for (const double x : {-kBreak / 2, kBreak / 2})
      path(kThin,
           {{x, lo}, {x, m - z}, {x - z, m - z / 3}, {x + z, m + z / 3}, {x, m + z}, {x, hi}},
           std::vector<double>(5, 0.0), false);
  }

  // Draws the outline with its middle at x. The last three points of `outline_` are the corner of
  // the roots at the end y > 0 and the two corners of the back. If the drawn outline is open at one
  // end, its line starts and ends at that end.
  enum class Open { none, right, left };
  void profile(double x, Open open) {
    const std::size_t n = outline_.points.size(), first = open == Open::left ? n - 2 : 0;
    std::vector<Vec2> points;
    std::vector<double> bulges;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2& p = outline_.points[(first + i) % n];
      points.emplace_back(x - k_ * p.y(), k_ * p.x());
      bulges.push_back(outline_.bulges[(first + i) % n]);
    }
    if (open != Open::none) bulges.pop_back();
    path(kOutline, std::move(points), std::move(bulges), open == Open::none);
  }

  void section() {
    if (interrupted_) {
      const double middle = (right_ + kBreak / 2) / 2;
      profile(-middle, Open::right);
      profile(middle, Open::left);
      break_lines(back_ - kClear, -k_ * input_.rack.dedendum + kClear);
      line(SheetLayer::axis, {-right_ - kAxis, 0}, {-kBreak / 2, 0});
      line(SheetLayer::axis, {kBreak / 2, 0}, {right_ + kAxis, 0});
    } else {
      profile(0.0, Open::none);
      line(SheetLayer::axis, {-right_ - kAxis, 0}, {right_ + kAxis, 0});
    }
    add(length_dimension());
    sheet_->text(kThin, origin_ + Vec2(-right_, caption()), kCaption, kUsual);
    if (const auto& texture = input_.surfaces.flank_texture) {
      const Vec2 foot = flank(), corner(foot.x(), shelf_);
      line(kThin, {foot.x() + texture_width(*texture), shelf_}, corner);
      line(kThin, corner, foot);
      sheet_->arrow(kThin, origin_ + foot, foot - corner);
      draw_texture(*sheet_, origin_ + corner + Vec2(texture_left(), 0), *texture);
    }
  }

  void end_view() {
    const double x0 = end_, x1 = end_ + face_, root = -k_ * input_.rack.dedendum;
    sheet_->rectangle(kOutline, {origin_ + Vec2(x0, back_), origin_ + Vec2(x1, tip_)});
    line(kThin, {x0, root}, {x1, root});
    line(SheetLayer::axis, {x0 - kAxis, 0}, {x1 + kAxis, 0});
    draw_datum(*sheet_, origin_ + Vec2((x0 + x1) / 2, back_), DatumSide::below);
    add(height_dimension());
    add(whole_dimension());
  }

  // Draws a line in the direction of the teeth. Its points are (x_0 + s tan β, s), relative to the
  // middle height of the plan. The line ends at the border of the plan, whose left and right edges
  // are at `left` and `right`.
  void tooth_direction(double x_0, double left, double right) {
    const double slope = std::tan(input_.rack.helix_angle.rad()), middle = top_ - face_ / 2;
    const double a = (left - x_0) / slope, b = (right - x_0) / slope;
    const double lo = std::max(std::min(a, b), -face_ / 2),
                 hi = std::min(std::max(a, b), face_ / 2);
    if (lo < hi) line(kThin, {x_0 + slope * lo, middle + lo}, {x_0 + slope * hi, middle + hi});
  }

  void plan() {
    const double low = top_ - face_;
    const std::vector<double> straight(3, 0.0);
    if (interrupted_) {
      for (const double side : {-1.0, 1.0})
        path(kOutline,
             {{side * kBreak / 2, low},
              {side * right_, low},
              {side * right_, top_},
              {side * kBreak / 2, top_}},
             straight, false);
      break_lines(low - kClear, top_);  // the texture of the faces is above the plan
    } else {
      sheet_->rectangle(kOutline, {origin_ + Vec2(-right_, low), origin_ + Vec2(right_, top_)});
    }
    if (const double beta = input_.rack.helix_angle.rad(); beta != 0.0) {
      const double edge = interrupted_ ? -kBreak / 2 : right_;
      for (const double n : {-1.0, 0.0, 1.0})
        tooth_direction((edge - right_) / 2 + n * kLines / std::cos(beta), -right_, edge);
    }
    add(width_dimension());
    if (const auto& texture = input_.surfaces.face_texture) {
      sheet_->text(kThin, origin_ + Vec2(-right_ + 1, top_ + 1), kBoth, kUsual);
      draw_texture(*sheet_, origin_ + Vec2(face_texture_foot(), top_), *texture);
    }
  }

  const RackSheetInput& input_;
  const BiarcChain& outline_;
  double k_;  // mm on paper per mm on the rack
  bool interrupted_ = false;
  // mm on paper, in this order: right end of the section (the left end is at −right_), back, tips,
  // shelf of the flank texture, left end of the end view, face width, upper edge of the plan
  double right_ = 0, back_ = 0, tip_ = 0, shelf_ = 0, end_ = 0, face_ = 0, top_ = 0;
};

}  // namespace

Result<GearSheet> rack_sheet(const RackSheetInput& input, SheetSize size, double tolerance_mm) {
  RackGeometry drawn = input.rack;
  if (drawn.teeth > kTeethInFull) drawn.teeth = kTeethAtEnd;
  const auto body = rack_body(drawn, "rack");
  if (!body) return body.error();
  const auto contour = body_contour(*body);
  if (!contour) return contour.error();
  const auto outline = biarc_contour(body->outline, contour->teeth, tolerance_mm);
  if (!outline) return outline.error();
  return on_page(input, "back of the rack", size, outline->deviation_mm,
                 [&](double scale) { return std::make_unique<RackViews>(input, *outline, scale); });
}

}  // namespace gearwright
