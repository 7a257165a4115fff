// Computes the common area of two toothed polygons that are turned against each other.
//
//   half tooth   points from the middle of the space (polar angle π/z) to the middle of the tooth
//                (the x axis), on the side y ≥ 0; an internal gear's material lies beyond it
//   mesh         at +x of axis 1; axis 2 at (a, 0), for an internal gear at (−a, 0); at rest, a
//                tooth of gear 1 is in the middle of a space of gear 2, both on the x axis
//
// Lines x = const are evenly spaced where the tip circles overlap. They are intersected with both
// polygons. Along a line, the polar angle about either axis increases with y, so the intersections
// follow each other in the order of the polygon. The common area is the length within both
// materials times the spacing.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace gearwright::oracle {

struct ToothedPolygon {
  int teeth;  ///< z, negative for an internal gear
  std::vector<Eigen::Vector2d> half_tooth;
};

class TurnedPolygons {
 public:
  /// Units     mm
  /// Domain    gear 1 is external; the half teeth are star-shaped
  TurnedPolygons(ToothedPolygon gear_1, ToothedPolygon gear_2, double a, int lines);

  bool in_reach() const { return step_ > 0.0; }
  /// The common area, mm², after gear 1 has turned counter-clockwise by φ. Gear 2 rolls with it and
  /// is turned additionally by `turn`.
  double shared_area(double phi, double turn) const;

 private:
  using Cuts = std::vector<std::vector<double>>;
  struct Gear {
    int teeth;
    bool ring;
    double tip;
    std::vector<Eigen::Vector2d> pitch;  ///< from the middle of tooth 0 to that of tooth 1
  };
  static Gear gear_of(const ToothedPolygon& polygon);
  double line(std::size_t i) const { return from_ + step_ * (static_cast<double>(i) + 0.5); }
  /// Half the length of the line x within the tip circles of external teeth.
  double half_length(double x) const;
  /// Intersections of the lines offset + line(i), in the order of y, with the gear turned by
  /// `turn`. If `starts[i]` is true, the first part is material.
  void cut(const Gear& gear, double turn, double sign, double offset, Cuts& cuts,
           std::vector<char>& starts) const;

  Gear one_, two_;
  double a_, from_ = 0.0, step_ = 0.0;
  std::size_t lines_;
  mutable Cuts cuts_1_, cuts_2_;
  mutable std::vector<char> starts_1_, starts_2_;
};

}  // namespace gearwright::oracle
