#include "gearwright/load/point_position.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>

#include "gearwright/contact/contact_point.hpp"
#include "gearwright/contact/gap_form.hpp"
#include "gearwright/load/loaded_position.hpp"
#include "gearwright/math/decompositions.hpp"

namespace gearwright::detail {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMostTurns = 60;    // of footprints that follow the forces
constexpr double kStill = 1e-11;  // of force and approach: footprints do not change any more
constexpr int kWhole = 10;        // turns after which ellipses go half the way only
constexpr int kHalvings = 40;
constexpr std::size_t kNodesToBend = 5;  // of a parabola with room to be a fit
constexpr double kIdle = 1e-6;           // of the whole force
constexpr double kStraightest = 0.25;  // of k1: bodies bend no closer than that to a straight line

using Nodes = boost::math::quadrature::gauss<double, 9>;

// The load of half an ellipsoid of pressure, projected onto its major axis: ¾ (1 − x²), x in [−1, 1].
template <class Visit>
void along_major_axis(Visit visit) {
  const auto& x = Nodes::abscissa();
  const auto& w = Nodes::weights();
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double share = 0.75 * (1 - x[i] * x[i]) * w[i];
    visit(x[i], share);
    if (x[i] > 0.0) visit(-x[i], share);
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

double PointSolver::reach(const PointPlace& place, double x) {
  if (on_axis(place, x).inside) return x;
  double in = 0.0;
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
  for (const double end : {-ellipse.semi_major, ellipse.semi_major})
    point.beyond = point.beyond || !on_axis(place, bent.middle + end).inside;
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
  along_major_axis([&](double at, double share) {
    const double x = bent.middle + at * ellipse.semi_major;
    const AxisPlace on = on_axis(place, x);
    if (!on.inside) return;
    add(x, on, share);
    sum += share;
  });
  if (laid.x.empty()) {
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

// w ≈ c0 + c1 x + ½ c2 x² over the footprint, by its shares: the gap is then least at
// x0 = −c1/(k1 + c2), or at the end of the flank on the way there.
Ellipse PointSolver::bent(const PointPosition& at, const std::vector<Laid>& laid,
                          const VectorXd& force, std::size_t i) {
  const Laid& here = laid[i];
  const PointPlace& place = at.places[i];
  if (is_sharp(place.kind) || here.x.size() < kNodesToBend) return {0.0, place.curvature[0], 0.0};
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double mean = 0.0;
  const double length = here.point.semi_major;  // of no consequence but for rounding
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
    const double x = here.x[m] / length;
    const Eigen::Vector3d basis(1.0, x, 0.5 * x * x);
    normal += here.share[m] * basis * basis.transpose();
    right += here.share[m] * w * basis;
    mean += here.share[m] * w;
  }
  const Eigen::Vector3d c = solve_linear(normal, right);
  const double k1 = place.curvature[0];
  Ellipse e;
  e.curvature = std::clamp(k1 + c[2] / (length * length), kStraightest * k1, place.curvature[1]);
  const double tilt = c[1] / length;
  e.middle = reach(place, -tilt / e.curvature);
  e.relief = c[0] + (tilt + 0.5 * e.curvature * e.middle) * e.middle - mean;
  return e;
}

// The larger a force, the longer its footprint, and the more its bodies bend under it: forces and
// footprints in turns.
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
  bool still = false;
  for (int turn = 0; turn < kMostTurns && !still; ++turn) {
    for (Index i = 0; i < n; ++i) {
      const PointPlace& p = at.places[i];
      // A place that does not bear has the footprint of a small force, so that it is somewhere.
      const double least = kIdle * q.moment / q.arm[i];
      all.laid[i] = lay(p, std::max(force[i], least), ellipse[i]);
      q.gap[i] = (at.te - p.te) * p.arm + ellipse[i].relief;
      q.softness[i] = all.laid[i].softness;
    }
    q.yield = yields(at, all.laid);
    all.sharing = share_points(q);
    still = (all.sharing.force - force).cwiseAbs().maxCoeff() <=
                kStill * all.sharing.force.maxCoeff() &&
            std::abs(all.sharing.approach - approach) <= kStill * approach;
    force = all.sharing.force;
    approach = all.sharing.approach;
    const double part = turn < kWhole ? 1.0 : 0.5;
    for (Index i = 0; i < n; ++i) {
      const Ellipse next = bent(at, all.laid, force, i);
      ellipse[i].middle += part * (next.middle - ellipse[i].middle);
      ellipse[i].curvature += part * (next.curvature - ellipse[i].curvature);
      ellipse[i].relief += part * (next.relief - ellipse[i].relief);
    }
  }
  all.sharing.found = all.sharing.found && still;
  for (Index i = 0; i < n; ++i) all.laid[i].point.force = force[i];
  return all;
}

LoadedPosition PointSolver::solve(PointPosition& at, double torque, Angle rotation1, bool&,
                                  long& unfinished, std::array<RootSwing, 2>& swing) {
  LoadedPosition out;
  out.rotation1 = rotation1;
  const double sign = pair_.turned();
  out.unloaded_te = Angle::radians(sign * at.te);
  out.te = out.unloaded_te;
  if (at.places.empty()) {
    out.kind = TouchKind::none;
    out.te = out.unloaded_te = Angle();
    return out;
  }
  const Shared x = share(at, torque);
  if (!x.sharing.found) ++unfinished;
  out.iterations = x.sharing.iterations;
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
