// Signed distance of a point from a toothed outline, given by the curves of half a tooth.
//
//   z_0     tooth number            γ = π/z_0   half a pitch
//   c(u)    a curve of the chain, u in 0 … 1; the chain runs from the middle of a space (polar
//           angle γ) to the middle of tooth 0 (the x axis), on the side y ≥ 0
//   q       the point, in the frame of the outline; its centre is the origin
//
// All other halves are mirror images and turned copies. Therefore q is turned and mirrored into the
// half pitch 0 … γ, and its foot point lies there too. A foot point beyond a mirror line has an
// image on this side that is at least as near.
//
// The curves are evaluated only when the outline is made. The outline stores polynomials of degree
// 8 that agree with the curves except for rounding, in pieces that turn by at most 0.3 rad. The
// curves need only be continuous. They need no derivatives, no constant speed and no decreasing
// polar angle.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

namespace gearwright::oracle {

class ToothedOutline {
 public:
  using Curve = std::function<Eigen::Vector2d(double)>;

  /// The data of a foot point that callers need.
  struct Foot {
    double distance = 0.0;  ///< mm, > 0 outside the outline's material
    std::size_t piece = 0;  ///< piece at which the next search can start
  };

  /// Units     mm
  /// Domain    the curves meet to 1e-9 mm, begin on the ray γ, end on the positive x axis, remain
  ///           between the two and do not cross each other (the last condition is not checked)
  /// Throws    std::invalid_argument if the chain violates these conditions, or if it is too rough
  ///           for polynomials
  ToothedOutline(int teeth, const std::vector<Curve>& half_tooth);

  int teeth() const { return teeth_; }
  double outer_radius() const { return outer_radius_; }  ///< mm, an upper bound
  std::size_t piece_count() const { return pieces_.size(); }

  /// Signed distance. `start` is the piece of a nearby point. It only affects the speed.
  ///
  /// Units     mm
  /// Accuracy  1e-13 mm + 4e-15 (|q| + outer radius). Further from a hollow edge than its radius
  ///           of curvature: never below the true distance, above it by less than 1e-3 of it
  Foot foot(Eigen::Vector2d q, std::size_t start = 0) const;
  double distance(Eigen::Vector2d q) const { return foot(q).distance; }

 private:
  static constexpr int kDegree = 8;
  struct Piece {
    Eigen::Matrix<double, 2, kDegree + 1> c;  ///< Σ c_k t^k, −1 ≤ t ≤ 1
    double reach;                             ///< greatest distance between c_0 and a point of the
                                              ///< piece
    double hollow;                            ///< least radius of curvature, reduced by a tenth
    Eigen::Vector2d ends[2], tangents[2];     ///< at t = −1, 1
    Eigen::Vector2d outside[2];               ///< sum of the two outward normals at each end
  };
  struct Jet {
    Eigen::Vector2d value, slope, half_bend;  ///< c, c′, c″/2
  };
  struct Place {
    double squared;  ///< distance²
    double signed_distance;
  };

  void append(const Curve& curve, double from, double to);
  void close();
  static Jet jet(const Piece& p, double t);
  static Place end_place(const Piece& p, int end, const Eigen::Vector2d& q);
  static Place root_place(const Piece& p, double lo, double hi, const Eigen::Vector2d& q);
  static Place nearest(const Piece& p, const Eigen::Vector2d& q);

  int teeth_;
  double outer_radius_ = 0.0;
  std::vector<Piece> pieces_;
};

}  // namespace gearwright::oracle
