#include "gearwright/compliance/probe.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/compliance/face_reading.hpp"

namespace gearwright {

namespace {

constexpr double kElement = 0.5;     // modules: length of an element along the face
constexpr double kHalfWidth = 0.05;  // modules: default half width of the Hertz strip
// Tolerance for rounded positions beyond an end of the face, relative to half the face width.
constexpr double kOnFace = 1e-9;
constexpr double kNearestToTip = 0.02;  // modules: least distance of the load from the tip

using detail::FlankMetric;

// The indentation of a half space under a Hertz strip minus the indentation under a bump. This
// difference is computed at a position on the face, or as the mean over the loaded part of the
// face. The mirror images of the load at both ends of the face are included.
class Local {
 public:
  Local(const FlankMetric& metric, double c, double a, double nu)
      : metric_(metric),
        bump_(detail::bump_offsets(0.0, c, c)),
        hertz_(detail::hertz_offsets(a)),
        scale_((1 - nu * nu) / std::numbers::pi) {}

  double to_point(double z, double lo, double hi, double half_face) const {
    const auto from = [&](double at) {
      return sum([&](double x) { return detail::slice_to_point(metric_, x, at, lo, hi); });
    };
    return from(z) + from(2 * half_face - z) + from(-2 * half_face - z);
  }
  double to_itself(double lo, double hi, double half_face) const {
    const auto at = [&](double d) {
      return sum([&](double x) { return detail::slices_inverse(metric_, x, d, hi - lo); });
    };
    return at(0.0) + at(2 * half_face - lo - hi) + at(-2 * half_face - lo - hi);
  }

 private:
  template <class F>
  double sum(F f) const {
    double total = 0.0;
    for (std::size_t i = 0; i < hertz_.x.size(); ++i) total += hertz_.weight[i] * f(hertz_.x[i]);
    for (std::size_t i = 0; i < bump_.x.size(); ++i) total -= bump_.weight[i] * f(bump_.x[i]);
    return scale_ * total;
  }
  FlankMetric metric_;
  detail::Offsets bump_, hertz_;
  double scale_;
};

}  // namespace

double body_twist(double base_radius, double bore_radius, double root_radius,
                  double poisson_ratio) {
  return base_radius * base_radius * 2 * (1 + poisson_ratio) *
         std::abs(1 / (bore_radius * bore_radius) - 1 / (root_radius * root_radius)) /
         (4 * std::numbers::pi);
}

Result<ProbeAnswer> probe_compliance(const Gear& gear, const ElasticBody& body,
                                     const ComplianceProbe& probe, ComplianceAccuracy accuracy) {
  return probe_compliance(gear, gear.twist(), body, probe, accuracy);
}

Result<ProbeAnswer> probe_compliance(const Gear& gear, double twist, const ElasticBody& body,
                                     const ComplianceProbe& probe, ComplianceAccuracy accuracy) {
  using namespace detail;
  const double m = gear.spec.normal_module;
  const double nu = body.poisson_ratio;
  auto made = make_section_mesh(gear.tooth->outline, m, body.bore_diameter / 2,
                                mesh_options(gear, twist, accuracy));
  if (!made) return made.error();
  const SectionMesh& mesh = *made;
  const double hi = mesh.length_at(mesh.flank_end);
  const double root = 2 * m * std::abs(mesh.outline(mesh.flank_begin));
  const double tip =
      2 * m * (std::abs(mesh.outline(mesh.flank_end)) - mesh.outward * kNearestToTip);
  const auto [d_lo, d_hi] = std::minmax(root, tip);
  if (!(probe.diameter >= d_lo && probe.diameter <= d_hi)) {
    return refused("diameter", probe.diameter, {d_lo, d_hi},
                   "must lie on the flank, between {} mm and {} mm");
  }
  const double s = length_at_radius(mesh, probe.diameter / 2 / m);
  const double c = bump_width(s, hi);
  const double a = probe.half_width ? *probe.half_width / m : kHalfWidth;
  ProbeAnswer answer;
  const double tau = twist * m;
  const Eigen::Index n = 3 * static_cast<Eigen::Index>(mesh.nodes.size());
  if (!probe.loaded) {
    answer.wide = true;
    const Functional f = bump(mesh, s, c, 0.0);
    const Eigen::MatrixXd u = plane_strain(mesh, nu, {f});
    answer.own =
        (f.vector(n).dot(u.col(0)) - plane_bump(c, nu) + plane_hertz(a, nu)) / body.youngs_modulus;
    return answer;
  }
  const double half_face = gear.spec.face_width / 2 / m;
  const auto on_face = [&](double z) { return std::abs(z) <= half_face * m * (1 + kOnFace); };
  const std::array<double, 2>& part = *probe.loaded;
  if (!(on_face(part[0]) && on_face(part[1]) && part[0] < part[1])) {
    return refused("z", on_face(part[0]) ? part[1] : part[0], {-half_face * m, half_face * m},
                   "must be two positions on the face in rising order, between {} mm and {} mm");
  }
  for (const double z : probe.read)
    if (!on_face(z))
      return refused("read_z", z, {-half_face * m, half_face * m},
                     "must lie on the face, between {} mm and {} mm");
  const auto [from, to] = std::pair((*probe.loaded)[0] / m, (*probe.loaded)[1] / m);
  auto section = make_tooth_section(gear, twist, body, accuracy, s);
  if (!section) return section.error();
  const ToothSection& t = **section;
  const Face face(t.modes.matrices, 2 * half_face, kElement);
  const Functional f = bump(mesh, s, c, tau);
  const Eigen::VectorXd q = t.modes.fields.transpose() * f.vector(n);
  const Eigen::VectorXd z = face.mean(from, to);
  const Face::Loads loads = face.loads(q);
  const Eigen::MatrixXd ends = face.solve(loads, 0, z);
  const FaceReading reading(face, loads, q.transpose());
  const auto read = [&](const Eigen::VectorXd& weights) {
    return reading.at(weights, {}, z, ends).value();
  };
  const Local local(t.metric(s), c, a, nu);
  const double unit = 1 / (body.youngs_modulus * m);
  answer.own = unit * (read(z) + local.to_itself(from, to, half_face));
  for (const double at : probe.read) {
    answer.profile.push_back(unit *
                             (read(face.at(at / m)) + local.to_point(at / m, from, to, half_face)));
  }
  return answer;
}

}  // namespace gearwright
