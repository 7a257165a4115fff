// Describes the outline of half a tooth as a function of the radius, and its corners. outline_gap
// uses this description to compute contact with another gear. Internal to pair/.
//
//   ρ, θ   radius and polar angle of a point W of the half tooth, θ from the tooth's centre line
//   τ, k   direction of the outline's tangent and its curvature, from root to tip
//   s, q   components of W along the tangent and the left-hand normal, W e^{−iτ} = s + iq, mm; |s|
//          is the arm of the normal of the outline about the axis, and −q/s is the slope dθ/d ln ρ
#pragma once

#include <vector>

#include "gearwright/generation/outline.hpp"

namespace gearwright::detail {

struct ProfilePlace {
  double rho, theta;
  double s, q;
  double tau, curvature;
};

/// A convex corner of the outline, which the mating gear's outline may touch.
struct ProfileCorner {
  double rho, theta;
  ArcName name;  ///< the arc that begins at the corner; if this arc is a land, the arc that ends at
                 ///< the corner
};

/// An arc that is not a land. Along the arc, the distance from the axis of the gear changes.
struct ProfileArc {
  const Arc* arc;
  double rho_root, rho_tip;  ///< radii of its two ends
  bool closed_form;          ///< true if the parameter of a radius has a closed form
  /// Points at equal steps of u, for a first guess; computed on first use.
  static constexpr int kGuesses = 16;
  mutable std::vector<ProfilePlace> guesses = {};

  ProfilePlace at(double u) const;
  /// Returns the point of the arc at a radius. If the radius lies beyond an end of the arc, the
  /// function returns this end.
  ///
  /// Accuracy  as accurate as the points of the curve, because the last step runs along the circle
  ///           of curvature and is shorter than 2e-6 of the radius of this circle
  ProfilePlace at_radius(double rho) const;
  double u_at_radius(double rho) const;

 private:
  struct Found {
    double u;
    ProfilePlace place;
  };
  Found find(double rho) const;
};

class GapProfile {
 public:
  /// `outline` must outlive this object.   Domain: a tooth with arcs (contract)
  explicit GapProfile(const Outline& outline);

  int teeth() const { return teeth_; }   ///< |z|
  double side() const { return side_; }  ///< σ
  double tip_radius() const { return tip_radius_; }
  double root_radius() const { return root_radius_; }
  const std::vector<ProfileArc>& arcs() const { return arcs_; }
  const std::vector<ProfileCorner>& corners() const { return corners_; }
  /// Returns the arc that has points at this radius, or null beyond root and tip.
  const ProfileArc* arc_at(double rho) const;

 private:
  int teeth_;
  double side_;
  double tip_radius_, root_radius_;
  std::vector<ProfileArc> arcs_;
  std::vector<ProfileCorner> corners_;
};

}  // namespace gearwright::detail
