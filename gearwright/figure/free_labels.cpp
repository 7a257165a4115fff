#include "gearwright/figure/free_labels.hpp"

#include <algorithm>
#include <limits>

#include "gearwright/base/printable.hpp"

namespace gearwright {

namespace {

constexpr double kNarrowLetter = 8.1;  // px, the mean width of a letter on a narrow screen
constexpr double kLineHeight = 19.0;   // px, height of a line of words on a narrow screen
constexpr double kBaseline = 5.0;      // px from the middle of the letters down to the base line
constexpr int kBoxWeight = 8;          // weight of an overlap with a box; a crossed line has 1
constexpr int kOutside = 1000;
// A label that must be drawn in any case may be far from its point, so that a reader could assign
// it to another point. Each distance of kNear px between the label and its point therefore counts
// as one crossed line.
constexpr double kNear = 18.0;

PixelBox box_of(const LabelPlace& place, double width) {
  const double x = place.at.x() + place.offset.x();
  const double y = place.at.y() + place.offset.y();
  const double left = place.anchor == Anchor::start ? x
                      : place.anchor == Anchor::end ? x - width
                                                    : x - width / 2;
  return {left, y - kLineHeight / 2, left + width, y + kLineHeight / 2};
}

// Returns true if the segment touches the box. The segment is clipped at the four sides of the
// box (Liang, Barsky).
bool meets(const PixelBox& box, const Vec2& a, const Vec2& b) {
  double from = 0.0;
  double to = 1.0;
  const Vec2 d = b - a;
  const auto clip = [&](double speed, double room) {  // speed·t ≤ room
    if (speed == 0.0) return room >= 0.0;
    const double t = room / speed;
    if (speed > 0.0) to = std::min(to, t);
    if (speed < 0.0) from = std::max(from, t);
    return from <= to;
  };
  return clip(-d.x(), a.x() - box.left) && clip(d.x(), box.right - a.x()) &&
         clip(-d.y(), a.y() - box.top) && clip(d.y(), box.bottom - a.y());
}

}  // namespace

double label_width(std::string_view plain) {
  return kNarrowLetter * static_cast<double>(character_count(plain));
}

PixelBox label_box(const LabelPlace& place, std::string_view plain) {
  return box_of(place, label_width(plain));
}

bool meet(const PixelBox& a, const PixelBox& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

void FreeLabels::keep_off(const std::vector<Vec2>& polyline) { lines_.push_back(polyline); }

int FreeLabels::conflicts(const PixelBox& box) const {
  int found = 0;
  if (box.left < within_.left || box.right > within_.right || box.top < within_.top ||
      box.bottom > within_.bottom)
    found += kOutside;
  for (const PixelBox& other : boxes_)
    if (meet(box, other)) found += kBoxWeight;
  for (const auto& line : lines_) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      if (!meets(box, line[i - 1], line[i])) continue;
      ++found;
      break;
    }
  }
  return found;
}

bool FreeLabels::draw(Svg& svg, std::string_view plain, std::string_view markup,
                      std::string_view style, const std::vector<LabelPlace>& places, If when) {
  const double width = label_width(plain);
  const LabelPlace* best = nullptr;
  int least = std::numeric_limits<int>::max();
  for (const LabelPlace& place : places) {
    const int away = when == If::always ? static_cast<int>(place.offset.norm() / kNear) : 0;
    const int found = conflicts(box_of(place, width)) + away;
    if (found < least) {
      least = found;
      best = &place;
    }
    if (found == 0) break;
  }
  const int most = when == If::free             ? 0
                   : when == If::over_a_line    ? 1
                   : when == If::over_two_lines ? 2
                                                : least;
  if (best == nullptr || least > most) return false;
  boxes_.push_back(box_of(*best, width));
  svg.text(best->at, markup, best->anchor, style, {best->offset.x(), best->offset.y() + kBaseline});
  return true;
}

std::vector<LabelPlace> places_around(const Vec2& at, double distance, const Vec2& towards) {
  const double d = distance;
  const double near = 0.75 * d;
  std::vector<LabelPlace> places{
      {at, {d, 0}, Anchor::start},        {at, {-d, 0}, Anchor::end},
      {at, {0, -d - 4}, Anchor::middle},  {at, {0, d + 4}, Anchor::middle},
      {at, {near, -near}, Anchor::start}, {at, {near, near}, Anchor::start},
      {at, {-near, -near}, Anchor::end},  {at, {-near, near}, Anchor::end}};
  std::stable_sort(places.begin(), places.end(), [&](const LabelPlace& a, const LabelPlace& b) {
    return a.offset.normalized().dot(towards) > b.offset.normalized().dot(towards) + 1e-9;
  });
  return places;
}

}  // namespace gearwright
