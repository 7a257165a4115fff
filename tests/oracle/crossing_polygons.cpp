#include "tests/oracle/crossing_polygons.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "tests/oracle/numbers.hpp"

namespace gearwright::oracle {

using Eigen::Vector2d;

namespace {

double cross_product(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double squared_distance(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d d = b - a;
  const double t = std::clamp((p - a).dot(d) / std::max(d.squaredNorm(), 1e-300), 0.0, 1.0);
  return (p - a - t * d).squaredNorm();
}

// Returns 0 if the segments a … b and p … q cross.
double squared_distance(const Vector2d& a, const Vector2d& b, const Vector2d& p,
                        const Vector2d& q) {
  const Vector2d d = b - a;
  const Vector2d e = q - p;
  const bool apart_1 = cross_product(d, p - a) * cross_product(d, q - a) > 0.0;
  const bool apart_2 = cross_product(e, a - p) * cross_product(e, b - p) > 0.0;
  if (!apart_1 && !apart_2) return 0.0;
  return std::min({squared_distance(p, a, b), squared_distance(q, a, b), squared_distance(a, p, q),
                   squared_distance(b, p, q)});
}

}  // namespace

int CrossingPolygons::add_chord(Gear& gear, std::size_t first, std::size_t last) {
  const auto at = static_cast<int>(gear.chords.size());
  double sag = 0.0;
  for (std::size_t i = first + 1; i < last; ++i)
    sag = std::max(sag, squared_distance(gear.points[i], gear.points[first], gear.points[last]));
  gear.chords.push_back({first, last, std::sqrt(sag), -1, -1});
  if (last - first > 1) {
    const std::size_t middle = (first + last) / 2;
    const int left = add_chord(gear, first, middle);
    const int right = add_chord(gear, middle, last);
    gear.chords[static_cast<std::size_t>(at)].left = left;
    gear.chords[static_cast<std::size_t>(at)].right = right;
  }
  return at;
}

CrossingPolygons::Gear CrossingPolygons::gear_of(const ToothedPolygon& polygon) {
  const auto& half = polygon.half_tooth;
  Gear gear{std::abs(polygon.teeth), polygon.teeth < 0, half.back().norm(), half, {}};
  for (std::size_t i = half.size() - 1; i-- > 0;)
    gear.points.push_back({half[i].x(), -half[i].y()});
  gear.chords.reserve(2 * gear.points.size());
  add_chord(gear, 0, gear.points.size() - 1);
  return gear;
}

CrossingPolygons::CrossingPolygons(const ToothedPolygon& gear_1, const ToothedPolygon& gear_2,
                                   double a)
    : one_(gear_of(gear_1)), two_(gear_of(gear_2)), a_(a) {
  // The tip circles about both axes meet in two points. The intersection of both polygons lies
  // between them.
  const double place_2 = two_.ring ? -a : a;
  const double x = (one_.tip * one_.tip - two_.tip * two_.tip + a * a) / (2.0 * place_2);
  const bool meet = std::abs(x) < one_.tip;
  const bool within = two_.ring ? one_.tip + a > two_.tip : one_.tip + two_.tip > a;
  if (!within) return;
  const double y = meet ? std::sqrt((one_.tip - x) * (one_.tip + x)) : 0.0;
  reach_[0] = meet ? std::atan2(y, x) : kPi;
  reach_[1] = meet ? std::atan2(y, two_.ring ? x - place_2 : place_2 - x) : kPi;
}

bool CrossingPolygons::cross(std::size_t chord_1, std::size_t chord_2, const Place& place) const {
  const Chord& one = one_.chords[chord_1];
  const Chord& two = two_.chords[chord_2];
  const double sags = one.sag + two.sag;
  const double d = squared_distance(one_.points[one.first], one_.points[one.last],
                                    place(two_.points[two.first]), place(two_.points[two.last]));
  if (d > sags * sags) return false;
  if (one.left < 0 && two.left < 0) return d == 0.0;
  const auto index = [](int i) { return static_cast<std::size_t>(i); };
  if (two.left < 0 || (one.left >= 0 && one.sag >= two.sag))
    return cross(index(one.left), chord_2, place) || cross(index(one.right), chord_2, place);
  return cross(chord_1, index(two.left), place) || cross(chord_1, index(two.right), place);
}

bool CrossingPolygons::cross(double phi, double turn) const {
  const double pitch_1 = 2 * kPi / one_.teeth;
  const double pitch_2 = 2 * kPi / two_.teeth;
  const double ratio = static_cast<double>(one_.teeth) / two_.teeth;
  // Gear 2 has a space on the x axis. For an external gear, this is half a turn away.
  const double rest = kPi / two_.teeth + (two_.ring ? 0.0 : kPi);
  const double turned_2 = rest + (two_.ring ? ratio : -ratio) * phi + turn;
  const double middle_2 = two_.ring ? 0.0 : kPi;  // direction of the mesh from axis 2
  // The teeth whose middles lie within reach, or at most half a pitch beyond it.
  const auto first = [](double turned, double middle, double reach, double pitch) {
    return static_cast<int>(std::ceil((middle - reach - turned) / pitch - 0.5 - 1e-9));
  };
  const auto count = [](int teeth, double reach, double pitch) {
    return std::min(teeth, static_cast<int>(2.0 * reach / pitch + 1.0 + 2e-9) + 1);
  };
  const int from_1 = first(phi, 0.0, reach_[0], pitch_1);
  const int from_2 = first(turned_2, middle_2, reach_[1], pitch_2);
  for (int i = 0; i < count(one_.teeth, reach_[0], pitch_1); ++i) {
    const double angle_1 = phi + (from_1 + i) * pitch_1;
    for (int k = 0; k < count(two_.teeth, reach_[1], pitch_2); ++k) {
      const double between = turned_2 + (from_2 + k) * pitch_2 - angle_1;
      const double place_2 = two_.ring ? -a_ : a_;
      const Place place{std::cos(between), std::sin(between),
                        Vector2d(place_2 * std::cos(angle_1), -place_2 * std::sin(angle_1))};
      if (cross(0, 0, place)) return true;
    }
  }
  return false;
}

}  // namespace gearwright::oracle
