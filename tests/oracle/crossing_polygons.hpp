// Tests whether the edges of two toothed polygons that turn against each other cross anywhere.
//
// The frames and the mesh are those of tests/oracle/turned_polygons.hpp, which measures the common
// area and takes a hundred times longer. Polygons whose edges do not cross have no common area,
// because gear 1 contains its own axis, which lies outside gear 2.
//
//   chord    from one point of the polygon to a later one
//   sag      greatest distance of the points between from it
//
// The edges of a pitch form a tree of chords, halved down to single edges. If two chords are
// farther apart than their sags, there is no crossing below them. Near a contact of two flanks, few
// pairs remain on each level, because the sag of a chord decreases with the square of its length,
// as does the gap of the flanks.
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
  /// With gear 1 turned counter-clockwise by φ, gear 2 as it rolls, and gear 2 additionally by
  /// `turn`.
  bool cross(double phi, double turn) const;

 private:
  struct Chord {
    std::size_t first, last;  ///< points of the pitch
    double sag;
    int left, right;  ///< halves; −1: one edge
  };
  struct Gear {
    int teeth;
    bool ring;
    double tip;
    std::vector<Eigen::Vector2d> points;  ///< from the middle of a space to that of the next
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
