// Computes the loads of a pair with point contact at one rotation. The three steps find the point
// of least gap of each tooth pair, the compliance, and the loads under a torque. Crossed and
// circular-arc gears have point contact.
//
// Internal to load/.                       theory: docs/theory/12-loaded-contact.md, 12.6
#pragma once

#include <array>
#include <vector>

#include "gearwright/contact/transmission.hpp"
#include "gearwright/load/loaded_contact.hpp"
#include "gearwright/load/point_hertz.hpp"
#include "gearwright/load/point_sharing.hpp"
#include "gearwright/load/root_forces.hpp"

namespace gearwright::detail {

// A place at which the gap of a tooth pair has a local minimum, with the curvatures of the gap.
struct PointPlace {
  int pair;    // k, number of the tooth pair in the frame N
  double te;   // T  rad
  double arm;  // normal gap per gap angle, mm/rad
  TouchKind kind;
  std::array<double, 2> curvature;  // k1 ≤ k2  1/mm
  PairTouch touch;
  Eigen::Vector2d along;  // (ds, dz) on flank 1 per mm along the major axis
  // The steps along the face and in radius per mm along an axis of the ellipse, [gear][axis], with
  // the major axis first.
  std::array<std::array<Eigen::Vector2d, 2>, 2> axis;
};

// The ellipse of a place under the current forces. The bodies bend under the load, so the flanks
// conform more closely than without load, and the point of least gap moves slightly. [T12.25]
struct Ellipse {
  double middle = 0.0;     // mm, place of the middle on the major axis
  double curvature = 0.0;  // 1/mm, k1 + c2; c2 is due to the bending
  double relief = 0.0;     // mm, change of the gap g_i due to the bending
};
// A place on the major axis of an ellipse, on both gears.
struct AxisPlace {
  std::array<double, 2> radius, z;  // mm
  bool inside;  // true if the place is on both flanks; otherwise radius and z are clamped to them
};
// The nodes of an ellipse, which lie on that part of its major axis that is on both flanks.
struct Laid {
  LoadedPoint point;
  double softness = 0.0;         // c of [T12.24]  mm/N^(2/3)
  std::vector<double> x, share;  // for each node, mm from the first touch, and load share with the
                                 // sum 1
  // For each gear and node, a unit force at the node, distributed over the grid of the table.
  std::array<std::vector<Eigen::MatrixXd>, 2> node;
  std::array<Eigen::MatrixXd, 2> grid;  // for each gear, the sum of `node`, weighted by `share`
};
struct PointPosition {
  std::vector<PointPlace> places;  // places that may touch, from the start to the end of contact
  double te = 0.0;                 // rad, TE without load, at which the first tooth pair touches
};

class PointSolver {
 public:
  PointSolver(const ContactPair& pair, const Gear& one, const Gear& two, const PairCompliance& c,
              const LoadRequest& request);

  PointPosition prepare(double rotation);
  LoadedPosition solve(PointPosition& at, double torque, Angle rotation1, bool& too_fine,
                       std::array<RootSwing, 2>& swing);
  double greatest_share(PointPosition& at, double torque);

 private:
  struct Shared {
    PointSharing sharing;
    std::vector<Laid> laid;
  };
  Shared share(const PointPosition& at, double torque);
  // Returns the compliance in mm/N that corresponds to the value 1 in the table of a gear.
  double unit(int gear) const {
    return 1 / (compliance_.bodies[gear].youngs_modulus * module_[gear]);
  }
  Eigen::MatrixXd yields(const PointPosition& at, const std::vector<Laid>& laid) const;
  AxisPlace on_axis(const PointPlace& place, double x);
  // `from` and x are points on the major axis, mm, and `from` lies on both flanks. If x lies on
  // both flanks, the result is x. Otherwise, the result is the last point on the way from `from` to
  // x that lies on both flanks.
  double reach(const PointPlace& place, double from, double x);
  Laid lay(const PointPlace& place, double force, const Ellipse& ellipse);
  // Returns the next ellipse of place i, computed from the displacement of the bodies that `force`
  // causes along the major axis of the present ellipse.
  Ellipse bent(const PointPosition& at, const std::vector<Laid>& laid, const Eigen::VectorXd& force,
               std::size_t i);

  const ContactPair& pair_;
  const PairCompliance& compliance_;
  Transmission transmission_;
  std::array<double, 2> module_;  // mm
  double ratio_, reduced_modulus_;
};

}  // namespace gearwright::detail
