// Tests whether the edges of two toothed polygons cross when the polygons turn against each other.
//
// Frames and mesh are the same as in tests/oracle/turned_polygons.hpp, which measures the common
// area and takes a hundred times longer. If the edges do not cross, the polygons have no common
// area, because gear 1 contains its own axis, which lies outside gear 2.
//
//   chord    line from one point of the polygon to a later one
//   sag      greatest distance from the chord to the points between its ends
//
// The edges of a pitch form a tree of chords, which are halved down to single edges. If the
// distance of two chords exceeds the sum of their sags, no edges below them cross. Near a contact
// of two flanks, few pairs remain on each level, because the sag of a chord decreases with the
// square of its length, and so does the gap of the flanks.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "tests/oracle/turned_polygons.hpp"

namespace gearwright::oracle {

class CrossingPolygons {
 public:
  /// Units     mm
  /// Domain    gear 1 external
  CrossingPolygons(const ToothedPolygon& gear_1, const ToothedPolygon& gear_2, double a);

  bool in_reach() const { return reach_[0] > 0.0; }
  /// Gear 1 is turned counter-clockwise by φ. Gear 2 rolls with it and is turned additionally by
  /// `turn`.
  bool cross(double phi, double turn) const;

 private:
  struct Chord {
    std::size_t first, last;  ///< points of the pitch
    double sag;
    int left, right;  ///< halves; −1 for a single edge
  };
  struct Gear {
    int teeth;
    bool ring;
    double tip;
    std::vector<Eigen::Vector2d> points;  ///< from the middle of a space to the middle of the next
                                          ///< one
    std::vector<Chord> chords;
  };
  /// The tooth of gear 2 as seen from the tooth of gear 1.
  struct Place {
    double c, s;
    Eigen::Vector2d shift;
    Eigen::Vector2d operator()(const Eigen::Vector2d& p) const {
      return {c * p.x() - s * p.y() + shift.x(), s * p.x() + c * p.y() + shift.y()};
    }
  };
  static Gear gear_of(const ToothedPolygon& polygon);
  static int add_chord(Gear& gear, std::size_t first, std::size_t last);
  bool cross(std::size_t chord_1, std::size_t chord_2, const Place& place) const;

  Gear one_, two_;
  double a_;
  double reach_[2] = {0.0, 0.0};  ///< polar angle of the farthest common point of both tip circles
};

}  // namespace gearwright::oracle
