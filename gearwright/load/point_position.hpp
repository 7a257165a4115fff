// One position of a loaded pair whose teeth touch about points, as crossed and circular-arc teeth
// do: the nearest point of each tooth pair, its compliance, and the loads under a torque.
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

// A place at which the gap of a tooth pair has a local minimum, and the growth of the gap around
// it.
struct PointPlace {
  int pair;    // k in N
  double te;   // T  rad
  double arm;  // mm
  TouchKind kind;
  std::array<double, 2> curvature;  // k1 ≤ k2  1/mm
  PairTouch touch;
  Eigen::Vector2d along;  // (ds, dz) on flank 1 of a mm along the major axis
  // Steps along the face and in radius on each gear, per mm along the major and the minor axis.
  std::array<std::array<Eigen::Vector2d, 2>, 2> axis;
};

// The ellipse of a place under the current forces. The bodies bend under it, so the flanks conform
// more closely than without load, and their nearest point moves slightly. [T12.25]
struct Ellipse {
  double middle = 0.0;     // mm along the major axis from the touch
  double curvature = 0.0;  // k1 minus the bending of the bodies  1/mm
  double relief = 0.0;     // mm, deflection of the bodies relative to the mean over the footprint
};

// A place on the major axis of an ellipse, on both gears.
struct AxisPlace {
  std::array<double, 2> radius, z;  // mm
  bool inside;  // true if on both flanks; otherwise the place is the nearest end of the flank
};

// An ellipse on both gears: nodes along its major axis, as far as it lies on the flanks.
struct Laid {
  LoadedPoint point;
  double softness = 0.0;                             // c of [T12.24]  mm/N^(2/3)
  std::vector<double> x, share;                      // mm from the touch, sum 1
  std::array<std::vector<Eigen::MatrixXd>, 2> node;  // a force of 1 at each node, on the grids
  std::array<Eigen::MatrixXd, 2> grid;               // all of them, weighted by their shares
};

struct PointPosition {
  std::vector<PointPlace> places;  // places that may touch, the nearest to its exit last
  double te = 0.0;                 // of the first touch
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
  // mm/N of a table's 1
  double unit(int gear) const {
    return 1 / (compliance_.bodies[gear].youngs_modulus * module_[gear]);
  }
  Eigen::MatrixXd yields(const PointPosition& at, const std::vector<Laid>& laid) const;
  AxisPlace on_axis(const PointPlace& place, double x);
  // x, or the farthest position towards it that is still on the flanks, which contain `from`.
  double reach(const PointPlace& place, double from, double x);
  Laid lay(const PointPlace& place, double force, const Ellipse& ellipse);
  // The bending of the bodies along the major axis of position i.
  Ellipse bent(const PointPosition& at, const std::vector<Laid>& laid, const Eigen::VectorXd& force,
               std::size_t i);

  const ContactPair& pair_;
  const PairCompliance& compliance_;
  Transmission transmission_;
  std::array<double, 2> module_;  // mm
  double ratio_, reduced_modulus_;
};

}  // namespace gearwright::detail
