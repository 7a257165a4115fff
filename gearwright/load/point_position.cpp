#include "gearwright/load/point_position.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>

#include "gearwright/contact/contact_point.hpp"
#include "gearwright/load/loaded_position.hpp"
#include "gearwright/math/decompositions.hpp"

namespace gearwright::detail {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMostTurns = 120;    // greatest number of iterations of footprints and forces
constexpr double kSteady = 1e-11;  // greatest last relative change of forces and approach
constexpr int kWhole = 10;         // iterations that change the ellipses by full steps
// Limits of the step length after kWhole iterations, relative to a full step.
constexpr double kLeastPart = 0.1, kMostPart = 5.0;
constexpr int kHalvings = 40;  // halvings of the interval in which the end of the flank lies
// The footprint is the part of the major axis that lies on the flanks. It gets only one node if its
// half length is less than this fraction of the semi-major axis.
constexpr double kNoLength = 1e-3;
// Least force for which a footprint is computed, relative to the whole force.
constexpr double kIdle = 1e-6;
// Least curvature k1 + c2 of the gap between the bent bodies, as a multiple of k1.
constexpr double kStraightest = 0.25;

using Quadrature = boost::math::quadrature::gauss<double, 9>;

// Visits the Gauss nodes in [−1, 1] and their weights, from the middle outwards. The weights do not
// include the load along the major axis. This load is ¾ (1 − x²), the integral of the Hertz
// pressure across this axis.
template <class Visit>
void along_axis(Visit visit) {
  const auto& x = Quadrature::abscissa();
  const auto& w = Quadrature::weights();
  for (std::size_t i = 0; i < x.size(); ++i) {
    visit(x[i], w[i]);
    if (x[i] > 0.0) visit(-x[i], w[i]);
  }
}

}  // namespace

PointSolver::PointSolver(const ContactPair& pair, const Gear& one, const Gear& two,
                         const PairCompliance& c, const LoadRequest&)
    : pair_(pair),
      compliance_(c),
      transmission_(pair),
      module_{one.spec.normal_module, two.spec.normal_module},
      ratio_(std::abs(double(two.spec.teeth) / one.spec.teeth)),
      reduced_modulus_(1 / (plane_softness(c.bodies[0]) + plane_softness(c.bodies[1]))) {}

PointPosition PointSolver::prepare(double rotation) {
  PointPosition at;
  std::vector<PairTouch> found;
  const int farthest = transmission_.farthest_pair();
  for (int k = farthest; k >= -farthest; --k) {
    for (PairTouch& t : transmission_.every_of_pair_0(rotation - k * pair_.pitch())) {
      if (at_seam(transmission_, t)) continue;
      t.pair = k;
      found.push_back(t);
    }
  }
  at.te = -std::numeric_limits<double>::infinity();
  for (const PairTouch& t : found) at.te = std::max(at.te, t.te());
  for (const PairTouch& t : found) {
    const GapJet j = transmission_.jet_at(t, t.touch.s, t.touch.z);
    const double arm = GapField::arm(j);
    if (!((at.te - t.te()) * arm < kFarGap * module_[0])) continue;
    const Vec3 r_s = space(j.w1_s, 0.0);
    const Vec3 r_z = space(j.w1_z, 1.0);
    const Vec3 e1 = r_s.normalized();
    const Vec3 e2 = r_s.cross(r_z).normalized().cross(e1);
    const GapForm form = gap_form(j, r_s, r_z, e1, e2);
    const double k2 = std::max(form.principal.values[1], kFlattest);
    const double k1 = std::clamp(form.principal.values[0], kFlattest, k2);
    const TouchKind kind = describe(transmission_, t, Angle(), 1.0).kind;
    PointPlace place{t.pair, t.te(), arm, kind, {k1, k2}, t, {}, {}};
    place.along = form.of_distance * form.principal.vectors.col(0);
    for (int i = 0; i < 2; ++i) {
      const Eigen::Vector2d step = form.of_distance * form.principal.vectors.col(i);
      const Complex moved = j.w1_s * step[0] + j.w1_z * step[1];
      place.axis[0][i] = {step[1], (std::conj(j.w1) * moved).real() / std::abs(j.w1)};
      place.axis[1][i] = {j.Z.s * step[0] + j.Z.z * step[1],
                          std::exp(j.u.v) * (j.u.s * step[0] + j.u.z * step[1])};
    }
    at.places.push_back(place);
  }
  return at;
}

AxisPlace PointSolver::on_axis(const PointPlace& place, double x) {
  const FlankPatch& a = transmission_.field(place.touch.fields).one();
  const FlankPatch& b = transmission_.field(place.touch.fields).two();
  const double s = place.touch.touch.s + x * place.along[0];
  const double z = place.touch.touch.z + x * place.along[1];
  const double s_on = std::clamp(s, a.s_lo, a.s_hi);
  const double z_on = std::clamp(z, a.z_lo, a.z_hi);
  const GapJet j = transmission_.jet_at(place.touch, s_on, z_on);
  const double u = std::clamp(j.u.v, b.u_lo, b.u_hi);
  const double z2 = std::clamp(j.Z.v, b.z_lo, b.z_hi);
  const bool inside = s == s_on && z == z_on && u == j.u.v && z2 == j.Z.v;
  return {{std::abs(j.w1), std::exp(u)}, {z_on, z2}, inside};
}

double PointSolver::reach(const PointPlace& place, double from, double x) {
  if (on_axis(place, x).inside) return x;
  double in = from;
  double out = x;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (in + out);
    (on_axis(place, middle).inside ? in : out) = middle;
  }
  return in;
}

Laid PointSolver::lay(const PointPlace& place, double force, const Ellipse& bent) {
  const HertzPoint hertz({bent.curvature, place.curvature[1]}, reduced_modulus_);
  const HertzEllipse ellipse = hertz.under(force);
  Laid laid;
  laid.softness = hertz.softness();
  LoadedPoint& point = laid.point;
  point.force = force;
  point.pressure = ellipse.pressure;
  point.semi_major = ellipse.semi_major;
  point.semi_minor = ellipse.semi_minor;
  point.kind = place.kind;
  point.track = place.touch.fields;
  const double turned = pair_.turned();
  const AxisPlace middle = on_axis(place, bent.middle);
  for (int g = 0; g < 2; ++g) {
    point.diameter[g] = 2 * middle.radius[g];
    point.height[g] = turned * middle.z[g];
    for (int i = 0; i < 2; ++i) {
      const Eigen::Vector2d& step = place.axis[g][i];
      point.half_axis[g][i] = (i == 0 ? ellipse.semi_major : ellipse.semi_minor) *
                              Eigen::Vector2d(turned * step[0], step[1]);
    }
  }
  // The part of the axis that lies on the flanks changes with the force. The number of nodes on
  // this part must stay constant for forces and footprints to converge.
  const double a = ellipse.semi_major;
  const double lo = reach(place, bent.middle, bent.middle - a);
  const double hi = reach(place, bent.middle, bent.middle + a);
  point.beyond = lo != bent.middle - a || hi != bent.middle + a;
  const double center = point.beyond ? 0.5 * (lo + hi) : bent.middle;
  const double half = point.beyond ? 0.5 * (hi - lo) : a;
  const auto add = [&](double x, const AxisPlace& at, double share) {
    laid.x.push_back(x);
    laid.share.push_back(share);
    for (int g = 0; g < 2; ++g) {
      const ToothTable& table = *compliance_.table[g];
      const double s = table.section().length_at_radius(at.radius[g] / module_[g]);
      laid.node[g].push_back(table.on_grid(TablePlace{s, at.z[g] / module_[g]}));
    }
  };
  double sum = 0.0;
  if (half > kNoLength * a) {
    along_axis([&](double at, double weight) {
      const double x = center + at * half;
      const double within = (x - bent.middle) / a;
      const double share = 0.75 * (1 - within * within) * weight;
      add(x, on_axis(place, x), share);
      sum += share;
    });
  } else {
    add(bent.middle, middle, 1.0);
    sum = 1.0;
  }
  for (double& share : laid.share) share /= sum;
  for (int g = 0; g < 2; ++g) {
    laid.grid[g] = MatrixXd::Zero(laid.node[g][0].rows(), laid.node[g][0].cols());
    for (std::size_t m = 0; m < laid.x.size(); ++m) laid.grid[g] += laid.share[m] * laid.node[g][m];
  }
  return laid;
}

MatrixXd PointSolver::yields(const PointPosition& at, const std::vector<Laid>& laid) const {
  const auto n = static_cast<Index>(at.places.size());
  MatrixXd yield = MatrixXd::Zero(n, n);
  for (int g = 0; g < 2; ++g) {
    const ToothTable& table = *compliance_.table[g];
    for (Index a = 0; a < n; ++a)
      for (Index b = 0; b <= a; ++b) {
        const int k = teeth_between(g, at.places[a].pair, at.places[b].pair);
        yield(a, b) += unit(g) * table.yield(k, laid[a].grid[g], laid[b].grid[g]);
      }
  }
  return yield.selfadjointView<Eigen::Lower>();
}

// Fits w ≈ c0 + c1 x + ½ c2 x² to the displacement over the footprint, weighted by the load shares.
// With this displacement, the gap is least at x0 = −c1/(k1 + c2). If x0 lies beyond an end of a
// flank, the gap is least at this end.
Ellipse PointSolver::bent(const PointPosition& at, const std::vector<Laid>& laid,
                          const VectorXd& force, std::size_t i) {
  const Laid& here = laid[i];
  const PointPlace& place = at.places[i];
  if (is_sharp(place.kind) || here.x.size() == 1) return {0.0, place.curvature[0], 0.0};
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double mean = 0.0;
  // x is measured from the middle of the footprint, which is the first node, and divided by the
  // distance of the last node from the middle. Otherwise the fit would be inaccurate for a
  // short footprint that is far from the point of contact without load.
  const double center = here.x.front();
  const double length = std::abs(here.x.back() - center);
  for (std::size_t m = 0; m < here.x.size(); ++m) {
    double w = 0.0;
    for (int g = 0; g < 2; ++g) {
      const ToothTable& table = *compliance_.table[g];
      for (std::size_t j = 0; j < laid.size(); ++j) {
        const double f = force[static_cast<Index>(j)];
        if (f == 0.0) continue;
        const int k = teeth_between(g, at.places[i].pair, at.places[j].pair);
        w += f * unit(g) * table.yield(k, here.node[g][m], laid[j].grid[g]);
      }
    }
    const double x = (here.x[m] - center) / length;
    const Eigen::Vector3d basis(1.0, x, 0.5 * x * x);
    normal += here.share[m] * basis * basis.transpose();
    right += here.share[m] * w * basis;
    mean += here.share[m] * w;
  }
  const Eigen::Vector3d c = solve_linear(normal, right);
  const double k1 = place.curvature[0];
  const double from = center / length;
  Ellipse e;
  e.curvature = std::clamp(k1 + c[2] / (length * length), kStraightest * k1, place.curvature[1]);
  // The slope of w at the point of contact without load.
  const double tilt = (c[1] - c[2] * from) / length;
  e.middle = reach(place, 0.0, -tilt / e.curvature);
  e.relief = c[0] - (c[1] - 0.5 * c[2] * from) * from +
             (tilt + 0.5 * e.curvature * e.middle) * e.middle - mean;
  return e;
}

// Computes forces and footprints alternately, because a larger force causes a longer footprint and
// more bending of the bodies.
PointSolver::Shared PointSolver::share(const PointPosition& at, double torque) {
  const auto n = static_cast<Index>(at.places.size());
  PointProblem q;
  q.gap.resize(n);
  q.arm.resize(n);
  q.softness.resize(n);
  for (Index i = 0; i < n; ++i) q.arm[i] = at.places[i].arm;
  q.moment = torque * ratio_;
  std::vector<Ellipse> ellipse;
  for (const PointPlace& p : at.places) ellipse.push_back({0.0, p.curvature[0], 0.0});
  Shared all;
  all.laid.resize(at.places.size());
  VectorXd force = VectorXd::Constant(n, q.moment / q.arm.sum());
  double approach = 0.0;
  // Full steps are used first. If they do not converge, the step length is computed from the last
  // two steps. It exceeds a full step if convergence is slow, and is less than a full step if the
  // steps oscillate.
  double part = 1.0;
  VectorXd last;
  bool still = false;
  for (int turn = 0; turn < kMostTurns && !still; ++turn) {
    for (Index i = 0; i < n; ++i) {
      const PointPlace& p = at.places[i];
      // For an unloaded place, the footprint is computed with a small force, because the
      // contact ellipse is not defined without a force.
      const double least = kIdle * q.moment / q.arm[i];
      all.laid[i] = lay(p, std::max(force[i], least), ellipse[i]);
      q.gap[i] = (at.te - p.te) * p.arm + ellipse[i].relief;
      q.softness[i] = all.laid[i].softness;
    }
    q.yield = yields(at, all.laid);
    all.sharing = share_points(q);
    if (!all.sharing.force.allFinite()) {
      all.sharing.found = false;
      return all;
    }
    still = (all.sharing.force - force).cwiseAbs().maxCoeff() <=
                kSteady * all.sharing.force.maxCoeff() &&
            std::abs(all.sharing.approach - approach) <= kSteady * approach;
    force = all.sharing.force;
    approach = all.sharing.approach;
    std::vector<Ellipse> step;
    VectorXd change(3 * n);
    for (Index i = 0; i < n; ++i) {
      const Ellipse next = bent(at, all.laid, force, i);
      const Ellipse& now = ellipse[i];
      step.push_back(
          {next.middle - now.middle, next.curvature - now.curvature, next.relief - now.relief});
      change.segment<3>(3 * i) << step[i].middle / all.laid[i].point.semi_major,
          step[i].curvature / at.places[i].curvature[0], step[i].relief / (approach * q.arm[i]);
    }
    const VectorXd bend = turn > kWhole ? VectorXd(change - last) : VectorXd();
    if (turn < kWhole)
      part = 1.0;
    else if (turn == kWhole)
      part = 0.5;
    else if (bend.squaredNorm() > 0.0)
      part = std::clamp(-part * last.dot(bend) / bend.squaredNorm(), kLeastPart, kMostPart);
    last = change;
    for (Index i = 0; i < n; ++i) {
      ellipse[i].middle += part * step[i].middle;
      ellipse[i].curvature =
          std::clamp(ellipse[i].curvature + part * step[i].curvature,
                     kStraightest * at.places[i].curvature[0], at.places[i].curvature[1]);
      ellipse[i].relief += part * step[i].relief;
    }
  }
  all.sharing.found = all.sharing.found && still;
  for (Index i = 0; i < n; ++i) all.laid[i].point.force = force[i];
  return all;
}

LoadedPosition PointSolver::solve(PointPosition& at, double torque, Angle rotation1, bool&,
                                  std::array<RootSwing, 2>& swing) {
  LoadedPosition out;
  out.rotation1 = rotation1;
  if (at.places.empty()) return out;
  const double sign = pair_.turned();
  out.unloaded_te = Angle::radians(sign * at.te);
  const Shared x = share(at, torque);
  out.iterations = x.sharing.iterations;
  out.unfinished = !x.sharing.found;
  if (out.unfinished) return out;
  out.max_pressure = out.max_width_ratio = 0.0;
  out.te = Angle::radians(sign * (at.te - x.sharing.approach));
  out.force = x.sharing.force.sum();
  const double arm = torque * ratio_ / out.force;
  out.approach = x.sharing.approach * arm;
  out.tangent = x.sharing.yield_per_moment * arm * arm;
  std::array<std::vector<ToothForces>, 2> forces;
  for (std::size_t i = 0; i < at.places.size(); ++i) {
    const LoadedPoint& point = x.laid[i].point;
    if (!(point.force > 0.0)) continue;
    const PointPlace& place = at.places[i];
    LoadedPair pair;
    pair.pair = place.pair;
    pair.share = point.force / out.force;
    pair.point = point;
    out.pairs.push_back(pair);
    out.max_width_ratio = std::max(out.max_width_ratio, point.semi_minor * place.curvature[1]);
    if (is_sharp(place.kind)) out.edge_carries = true;
    if (point.pressure > out.max_pressure) {
      out.max_pressure = point.pressure;
      out.kind = place.kind;
    }
    for (int g = 0; g < 2; ++g) forces[g].push_back({place.pair, point.force * x.laid[i].grid[g]});
  }
  for (int g = 0; g < 2; ++g)
    out.root_stress[g] =
        greatest_root_stress(*compliance_.table[g], g, module_[g], forces[g], swing[g]);
  return out;
}

double PointSolver::greatest_share(PointPosition& at, double torque) {
  if (at.places.empty()) return 0.0;
  const Shared x = share(at, torque);
  if (!x.sharing.found) return kNoNumber;
  double most = 0.0;
  for (std::size_t i = 0; i < at.places.size(); ++i) {
    double of_pair = 0.0;
    for (std::size_t j = 0; j < at.places.size(); ++j)
      if (at.places[j].pair == at.places[i].pair) of_pair += x.sharing.force[static_cast<Index>(j)];
    most = std::max(most, of_pair);
  }
  return most / x.sharing.force.sum();
}

}  // namespace gearwright::detail
