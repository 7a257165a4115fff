#include "gearwright/cad/sheet_callouts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gearwright/cad/sheet_parts.hpp"
#include "gearwright/cad/sheet_symbols.hpp"

namespace gearwright {

namespace {

constexpr auto kLeaders = SheetLayer::dimension;
constexpr const char* kBoth = "2×";  // the requirement applies to both faces

// Lengths in mm. The upper callouts end at kEnd. The vertical leaders are at kFlankLeader and
// kBoreLeader from the left face, and the horizontal leader of the faces has the length
// kLeaderLength. Callouts are kApart from each other and kClear from the lines of the views. A
// leader with an arrow has at least the length kLeast.
constexpr double kEnd = -8, kFlankLeader = -2, kBoreLeader = -5, kLeaderLength = 6;
constexpr double kApart = 1.5, kClear = 2, kLeast = 4;
// Lengths in mm, measured from the outermost circle. The centre lines extend by kCentreLine beyond
// the circle. On the right-hand side, the dimensions end at the height kDimensionTop above the
// circle, and the datum ends at kDatumTop.
constexpr double kCentreLine = 3, kDimensionTop = 8, kDatumTop = 12;
// Least height of the tolerance frame for the tip-circle runout above the outermost circle.
constexpr double kTipFrame = 0.8;
constexpr double kFaceLeader = -4;  // leader of the faces relative to the lower end of the section

double texture_width(const std::string& words) { return texture_left() + texture_right(words); }

// Returns the box of a symbol of surface texture. Its lower edge is at the height `shelf`, and its
// right edge is at kEnd.
SheetBox texture_box(const std::string& words, double shelf) {
  return {{kEnd - texture_width(words), shelf}, {kEnd, shelf + kTextureHeight}};
}

// Returns the greatest horizontal distance from the centre of a circle to a point of the circle
// between two heights. If the horizontal centre line lies between these heights, the function
// returns the distance to the end of the centre line, which lies beyond the circle.
double half_chord(double radius, double lo, double hi) {
  if (lo <= 1 && hi >= -1) return radius + kCentreLine;
  const double y = std::min(std::abs(lo), std::abs(hi));
  return y < radius ? std::sqrt(radius * radius - y * y) : 0.0;
}

}  // namespace

Callouts::Callouts(AxialSection section, SurfaceRequirements required)
    : section_(std::move(section)), required_(std::move(required)) {
  place_faces();
  place_above();
}

// If a horizontal leader below the section passes below all dimensions, the callout of the faces is
// at the lower left with this leader. Otherwise, the callout is at the upper right.
void Callouts::place_faces() {
  const double number = text_width(kBoth, kUsual) + 1;
  double width = runout_width(required_.face_runout), height = kFrameHeight + kUsual + 1;
  if (required_.face_texture) {
    width = std::max(width, number + texture_width(*required_.face_texture));
    height = kFrameHeight + kTextureHeight;
  }
  const double leader = -section_.body + kFaceLeader, lo = leader - kFrameHeight / 2;
  double right = -kLeaderLength;
  bool below = true;
  for (const OccupiedSpace& s : section_.on_left) {
    below = below && leader < s.lo - 1;
    if (lo + height > s.lo - 1) right = std::min(right, s.left - 1);
  }
  faces_ = {{right - width, lo}, {right, lo + height}};
  if (below) return;
  const double x = section_.width + kLeaderLength;
  const double y = section_.body + (section_.ring ? kDatumTop : kDimensionTop);
  faces_ = {{x, y}, {x + width, y + height}};
}

// The other callouts are stacked at the upper left, above the dimensions. The leader of the flank
// must be long enough for its arrow.
void Callouts::place_above() {
  const double row = kTextureHeight + kApart, anchor = section_.reference;
  const auto long_enough = [](double y, double from) { return std::abs(y - from) >= kLeast; };
  double floor = faces_on_left() ? faces_.hi.y() + kApart : kClear;
  for (const OccupiedSpace& s : section_.on_left) floor = std::max(floor, s.hi + kClear);

  if (section_.ring) {
    // The leader of the tip circle comes from the inside. If the ring is small, it comes from
    // above.
    double frame = section_.tip - kLeast - kFrameHeight / 2;
    if (frame < floor) frame = std::max(floor, section_.tip + kLeast - kFrameHeight / 2);
    double shelf = frame + kFrameHeight + kApart;
    if (!long_enough(shelf, anchor)) shelf = anchor + kLeast;
    tip_ = {{kEnd - runout_width(required_.tip_runout), frame}, {kEnd, frame + kFrameHeight}};
    if (required_.flank_texture) flank_ = texture_box(*required_.flank_texture, shelf);
    return;
  }
  const bool flank = required_.flank_texture.has_value();
  const bool bore = required_.bore_texture && section_.bore;
  double frame = std::max(section_.body + kTipFrame, floor);
  double shelf = frame - row;  // shelf of the upper symbol
  if (flank && !long_enough(shelf, anchor)) shelf = anchor - kLeast;
  const double below = flank && bore ? row : 0.0;
  if (shelf - below < floor && (flank || bore)) {
    shelf = floor + below;
    if (flank && !long_enough(shelf, anchor)) shelf = anchor + kLeast;
    frame = std::max(frame, shelf + row);
  }
  tip_ = {{kEnd - runout_width(required_.tip_runout), frame}, {kEnd, frame + kFrameHeight}};
  if (flank) flank_ = texture_box(*required_.flank_texture, shelf);
  if (bore) bore_ = texture_box(*required_.bore_texture, shelf - below);
}

std::vector<SheetBox> Callouts::boxes() const {
  std::vector<SheetBox> all{tip_, faces_};
  for (const auto& symbol : {flank_, bore_})
    if (symbol) all.push_back(*symbol);
  return all;
}

double Callouts::distance() const {
  double distance = 0.0;
  for (const SheetBox& box : boxes()) {
    if (box.hi.x() > 0) continue;  // the callout of the faces, at the upper right
    const double chord = half_chord(section_.body, box.lo.y(), box.hi.y());
    distance = std::max(distance, chord + kClear - box.lo.x());
  }
  return distance;
}

double Callouts::top() const {
  double top = 0.0;
  for (const SheetBox& box : boxes()) top = std::max(top, box.hi.y());
  return top;
}

double Callouts::right() const { return faces_on_left() ? 0.0 : faces_.hi.x() - section_.width; }

void Callouts::draw(Sheet& sheet, const Vec2& origin) const {
  const auto line = [&](const Vec2& a, const Vec2& b) {
    sheet.line(kLeaders, origin + a, origin + b);
  };
  // Draws a leader from `from` horizontally to the x of `tip`, and then vertically to `tip`.
  const auto leader = [&](const Vec2& from, const Vec2& tip) {
    const Vec2 corner(tip.x(), from.y());
    line(from, corner);
    line(corner, tip);
    sheet.arrow(kLeaders, origin + tip, tip - corner);
  };
  const auto texture = [&](const SheetBox& box, const std::string& words, const Vec2& tip) {
    draw_texture(sheet, origin + box.lo + Vec2(texture_left(), 0), words);
    leader(box.lo, tip);
  };
  const auto runout = [&](const SheetBox& box, const std::string& value) {
    draw_runout(sheet, origin + box.lo, box.hi.x() - box.lo.x(), value);
    return Vec2(box.hi.x(), box.lo.y() + kFrameHeight / 2);
  };
  const AxialSection& s = section_;
  if (flank_) texture(*flank_, *required_.flank_texture, {kFlankLeader, s.reference});
  if (bore_) texture(*bore_, *required_.bore_texture, {kBoreLeader, -*s.bore});
  const Vec2 tip_end = runout(tip_, required_.tip_runout);
  if (s.ring) {
    line({-1, s.tip}, {kBoreLeader - 1.5, s.tip});
    leader(tip_end, {kBoreLeader, s.tip});
  } else {
    leader(tip_end, {std::min(8.0, s.half / 2), s.tip});
  }

  const Vec2 face_end = runout(faces_, required_.face_runout);
  const double above = faces_.lo.y() + kFrameHeight, x = faces_.lo.x();
  sheet.text(kLeaders, origin + Vec2(x, above + 1), kBoth, kUsual);
  if (required_.face_texture) {
    const double foot = x + text_width(kBoth, kUsual) + 1 + texture_left();
    draw_texture(sheet, origin + Vec2(foot, above), *required_.face_texture);
  }
  // The arrow touches the extension of the face.
  const double y = face_end.y(), end = faces_on_left() ? 0.0 : s.width;
  const Vec2 start(faces_on_left() ? face_end.x() : x, y);
  line(start, {end, y});
  sheet.arrow(kLeaders, origin + Vec2(end, y), {end - start.x(), 0});
  if (!faces_on_left()) line({end, s.body + 1}, {end, y + kApart});
}

}  // namespace gearwright
