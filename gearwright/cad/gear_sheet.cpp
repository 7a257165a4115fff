#include "gearwright/cad/gear_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "gearwright/cad/biarc.hpp"
#include "gearwright/cad/drawing.hpp"
#include "gearwright/cad/sheet_callouts.hpp"
#include "gearwright/cad/sheet_page.hpp"
#include "gearwright/cad/sheet_symbols.hpp"

namespace gearwright {

namespace {

constexpr auto kOutline = SheetLayer::outline;
// Lengths in mm on paper.
//   kAxis           projection of centre lines beyond the part
//   kFirst, kNext   from the view to the first dimension line, and between dimension lines
//   kGap            between the views
//   kShelf          projection of the leader beyond the gear
constexpr double kAxis = 3, kFirst = 10, kNext = 8, kGap = 8, kShelf = 5;
// Distance from the base line of the caption to the transverse view above it, mm.
constexpr double kCaption = 12;
// Lengths in mm for a gear without a bore. The datum symbol is kAxisDatum from the left face, and
// the axis extends by kAxisEnd beyond this face. The axis then ends 2 mm from the axis of the
// transverse view.
constexpr double kAxisDatum = 4.5, kAxisEnd = 6;

std::string with_fit(const std::string& size, const std::string& fit) {
  return fit.empty() ? size : size + " " + fit;
}

// Draws both views at the same scale. The centre of the transverse view is the origin, and the
// axial view is to the right of the transverse view.
class GearViews : public SheetViews {
 public:
  GearViews(const GearSheetInput& input, const BiarcChain& outline, const BodyContour& contour,
            double scale)
      : input_(input), outline_(outline), bore_(contour.bore), k_(scale) {
    const double inner = contour.teeth.inner_radius, outer = contour.teeth.outer_radius;
    const bool ring = input.body.ring();
    tip_ = ring ? inner : outer;
    root_ = ring ? outer : inner;
    body_ = ring ? bore_->radius : outer;
    const double half = text_width(where(), kUsual) / 2;
    left_ = std::max(k_ * body_ + kAxis, half);
    if (keyed()) left_ = std::max(left_, elbow() + text_width(keyway_words(), kUsual));
    axial_ = std::max(k_ * body_ + kAxis, half) + kGap;
    if (!ring && bore_) axial_ += kFirst + (keyed() ? kNext : 0.0);
    right_ = kFirst + kNext * (static_cast<double>(radii_to_the_right().size()) - 0.5);
    width_ = k_ * input.body.face_width;
    callouts_.emplace(section(), input.surfaces);
    axial_ = std::max(axial_, callouts_->distance());
    right_ = std::max(right_, callouts_->right());
  }

  SheetBox box() const override {
    const double up =
        std::max({k_ * body_ + kAxis, keyed() ? shelf() + kUsual + 2 : 0.0, callouts_->top()});
    return {{-left_, -k_ * body_ - kFirst - 4}, {axial_ + width_ + right_, up}};
  }

  void draw() override {
    transverse();
    axial();
  }

 private:
  bool ring() const { return input_.body.ring(); }
  // The gap of a double-helical gear contains no teeth, so the section lies in one half.
  std::string where() const {
    return !input_.body.grooved()    ? "Section in the middle of the face width"
           : input_.body.twist > 0.0 ? "Section in the middle of the right-hand half"
                                     : "Section in the middle of the left-hand half";
  }
  bool keyed() const { return !ring() && bore_ && bore_->keyway; }
  const Bore& bore() const { return *input_.body.bore; }
  std::string length(double mm) const { return length_text(input_.units, mm); }
  // A computed diameter is rounded to µm, because the table already contains the exact diameter.
  std::string diameter(double radius) const {
    return "Ø" + computed_length_text(input_.units, 2 * radius);
  }
  std::string keyway_words() const {
    return "Keyway " + with_fit(length(bore().keyway_width), input_.words.keyway_fit) + " wide";
  }
  double shelf() const { return k_ * body_ + kShelf; }
  // Seen from the centre of the gear, the elbow of the leader lies 60° above the horizontal.
  double elbow() const { return shelf() / std::sqrt(3.0); }

  // Returns the dimensions to the left of the axial section. The left face of the section is at x.
  std::vector<Dimension> dimensions_on_left(double x) const {
    std::vector<Dimension> all;
    if (ring() || !bore_) return all;
    const double r = bore_->radius;
    all.push_back(upward(-r, r, x, x - kFirst, with_fit(diameter(r), input_.words.bore_fit)));
    all.back().datum = true;
    if (!keyed()) return all;
    const double top = r + bore().keyway_depth;
    all.push_back(upward(-r, top, x, x - kFirst - kNext, length(r + top)));
    return all;
  }

  // Returns the axial section with its lengths on paper, and with the space that the dimensions and
  // the datum occupy to its left.
  AxialSection section() const {
    const bool grooved = input_.body.grooved();
    const double gap = grooved ? k_ * input_.body.two_helices->gap : 0.0;
    AxialSection s{ring(),      width_,    grooved ? (width_ - gap) / 2 : width_,
                   k_ * body_,  k_ * tip_, k_ * input_.reference_diameter / 2,
                   std::nullopt};
    if (ring()) return s;
    if (!bore_) {
      s.on_left.push_back({-kAxisEnd - kDatumHalf, -kDatumHeight, 0.0});
      return s;
    }
    s.bore = k_ * bore_->radius;
    for (const Dimension& d : dimensions_on_left(0.0)) {
      const auto [lo, hi] = reach_of(d);
      s.on_left.push_back({d.line - kUsual - 2, lo, hi});  // a text is to the left of its line
    }
    return s;
  }

  std::vector<double> radii_to_the_right() const {
    std::vector<double> radii{input_.reference_diameter / 2, tip_};
    if (ring()) radii.push_back(body_);
    std::sort(radii.begin(), radii.end());
    return radii;
  }

  void path(const std::vector<Vec2>& points, const std::vector<double>& bulges) {
    SheetPath path{kOutline, {}, bulges, true};
    for (const Vec2& p : points) path.points.emplace_back(origin_ + k_ * p);
    sheet_->paths.push_back(std::move(path));
  }

  void transverse() {
    // The last band is the half at z > 0. If there is no gap, the section is in the middle plane.
    const Band band = input_.body.bands().back();
    const Eigen::Rotation2Dd turn(input_.body.grooved() ? band.angle(band.middle) : 0.0);
    std::vector<Vec2> points;
    for (const Vec2& p : outline_.points) points.push_back(turn * p);
    path(points, outline_.bulges);
    if (bore_ && bore_->keyway)
      path(bore_->points, bore_->bulges);
    else if (bore_)
      sheet_->circle(kOutline, origin_, k_ * bore_->radius);
    sheet_->circle(SheetLayer::axis, origin_, k_ * input_.reference_diameter / 2);
    const double r = k_ * body_ + kAxis;
    line(SheetLayer::axis, {-r, 0}, {r, 0});
    line(SheetLayer::axis, {0, -r}, {0, r});
    sheet_->text(SheetLayer::dimension, origin_ + Vec2(0, -k_ * body_ - kCaption), where(), kUsual,
                 Along::middle);
    if (!keyed()) return;
    // The arrow touches the left wall of the keyway from the material side.
    const double half = bore().keyway_width / 2;
    const double low = std::sqrt(bore_->radius * bore_->radius - half * half);
    const double high = bore_->radius + bore().keyway_depth;
    const Vec2 wall = k_ * Vec2(-half, (low + high) / 2), at(-elbow(), shelf());
    const double far = at.x() - text_width(keyway_words(), kUsual);
    sheet_->arrow(SheetLayer::dimension, origin_ + wall, wall - at);
    line(SheetLayer::dimension, wall, at);
    line(SheetLayer::dimension, at, {far, at.y()});
    sheet_->text(SheetLayer::dimension, origin_ + Vec2(far, at.y() + 1), keyway_words(), kUsual);
  }

  void axial() {
    const double x0 = axial_, x1 = axial_ + width_;
    const auto across = [&](SheetLayer layer, double y, double past = 0.0) {
      line(layer, {x0 - past, y}, {x1 + past, y});
    };
    const auto metal = [&](double lo, double hi) {
      hatch(*sheet_, {origin_ + Vec2(x0, lo), origin_ + Vec2(x1, hi)});
    };
    // There are no teeth between this radius and the bore or the rim.
    const double limit = input_.body.limit_within(root_);
    if (input_.body.grooved())
      grooved(x0, x1, limit);
    else
      sheet_->rectangle(kOutline,
                        {origin_ + Vec2(x0, -k_ * body_), origin_ + Vec2(x1, k_ * body_)});
    for (const double side : {-1.0, 1.0}) {
      if (input_.body.grooved()) break;
      across(kOutline, side * k_ * root_);
      if (ring()) across(kOutline, side * k_ * tip_);
      across(SheetLayer::axis, side * k_ * input_.reference_diameter / 2, kAxis);
    }
    const bool solid = !ring() && !bore_;
    line(SheetLayer::axis, {x0 - (solid ? kAxisEnd : kAxis), 0}, {x1 + kAxis, 0});
    if (solid) draw_datum(*sheet_, origin_ + Vec2(x0 - kAxisDatum, 0), DatumSide::below);
    if (ring()) {
      metal(k_ * limit, k_ * body_);
      metal(-k_ * body_, -k_ * limit);
    } else if (!bore_) {
      metal(-k_ * limit, k_ * limit);
    } else {
      const double r = bore_->radius, half = bore().keyway_width / 2;
      const double top = keyed() ? r + bore().keyway_depth : r;
      across(kOutline, -k_ * r);
      across(kOutline, k_ * top);
      if (keyed()) across(kOutline, k_ * std::sqrt(r * r - half * half));
      metal(-k_ * limit, -k_ * r);
      metal(k_ * top, k_ * limit);
      for (const Dimension& d : dimensions_on_left(x0)) add(d);
    }
    double place = x1 + kFirst;
    for (const double r : radii_to_the_right()) {
      const bool reference = r == input_.reference_diameter / 2;
      const std::string fit = r == tip_ ? input_.tip_fit : "";
      Dimension d = upward(-r, r, reference ? x1 + kAxis : x1, place, with_fit(diameter(r), fit));
      d.datum = ring() && r == body_;
      add(d);
      place += kNext;
    }
    const double y = -k_ * body_;
    add({Direction::across, x0, x1, y, y, y - kFirst, length(input_.body.face_width)});
    callouts_->draw(*sheet_, origin_ + Vec2(x0, 0));
  }

  // Draws the axial outline of a double-helical gear with its groove, and the roots and reference
  // lines of both halves.
  void grooved(double x0, double x1, double groove) {
    const double half = (width_ - k_ * input_.body.two_helices->gap) / 2;
    for (const double x : {x0, x1}) line(kOutline, {x, -k_ * body_}, {x, k_ * body_});
    for (const double side : {-1.0, 1.0}) {
      if (ring()) line(kOutline, {x0, side * k_ * body_}, {x1, side * k_ * body_});
      for (const double x : {x0, x1 - half}) {
        for (const double r : {tip_, root_})
          line(kOutline, {x, side * k_ * r}, {x + half, side * k_ * r});
        const double edge = x == x0 ? x + half : x;
        line(kOutline, {edge, side * k_ * tip_}, {edge, side * k_ * groove});
      }
      line(kOutline, {x0 + half, side * k_ * groove}, {x1 - half, side * k_ * groove});
      const double reference = side * k_ * input_.reference_diameter / 2;
      line(SheetLayer::axis, {x0 - kAxis, reference}, {x0 + half + kAxis, reference});
      line(SheetLayer::axis, {x1 - half - kAxis, reference}, {x1 + kAxis, reference});
    }
  }

  Dimension upward(double lo, double hi, double edge, double place, std::string words) const {
    return {Direction::up, k_ * lo, k_ * hi, edge, edge, place, std::move(words)};
  }

  const GearSheetInput& input_;
  const BiarcChain& outline_;
  const std::optional<BoreContour>& bore_;
  double k_;                              // mm on paper per mm on the gear
  double tip_ = 0, root_ = 0, body_ = 0;  // radii of tip, root and outermost circle, mm
  // mm on paper, in this order: room to the left of the origin, then left end, width and right
  // margin of the axial view
  double left_ = 0, axial_ = 0, width_ = 0, right_ = 0;
  std::optional<Callouts> callouts_;
};

}  // namespace

Result<GearSheet> gear_sheet(const GearSheetInput& input, SheetSize size, double tolerance_mm) {
  const ToothedBody& body = input.body;
  const auto contour = body_contour(body);
  if (!contour) return contour.error();
  const auto outline = biarc_contour(body.outline, contour->teeth, tolerance_mm);
  if (!outline) return outline.error();

  const std::string datum = body.ring() ? "axis of the rim"
                            : body.bore ? "axis of the bore"
                                        : "axis of the gear";
  return on_page(input, datum, size, outline->deviation_mm, [&](double scale) {
    return std::make_unique<GearViews>(input, *outline, *contour, scale);
  });
}

}  // namespace gearwright
