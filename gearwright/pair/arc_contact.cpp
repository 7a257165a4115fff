#include "gearwright/pair/arc_contact.hpp"

#include <cmath>
#include <numbers>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/math/decompositions.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright {

namespace {

// Returns w, the distance between a point of the convex rack and a point of the concave rack with
// the same normal angle θ. The distance is measured along the centre line. [T7.15]
double height_gap(const ArcMeshInput& in, double theta) {
  return (in.convex.radius - in.concave.radius) * std::sin(theta) - (in.convex.b - in.concave.b);
}

// Returns the height of a point of the arc above the pitch plane, away from the convex gear.
double height(const WorkingArc& arc, double theta) { return arc.radius * std::sin(theta) - arc.b; }

// Returns the axial position of a point on a gear, without the part r φ tan λ. This part depends on
// the rotation φ at which the rack with the lead angle λ cut the point. [T7.13]
double axial(const WorkingArc& arc, double theta, double lambda) {
  const double s = std::sin(lambda), c = std::cos(lambda);
  return arc.radius * std::cos(theta) * c - arc.a / c + arc.b / std::tan(theta) * s * s / c;
}

// Returns the radius of curvature of the transverse profile, from the curvature K of the surface.
// The radius is > 0 if the normal points away from the centre of curvature.
double transverse_radius(const Mat2& k, double theta, double lambda) {
  // The tangent u_z t − t_z u of the transverse section. The length of this vector equals the
  // length of the component of n in this section.
  const Vec2 d(std::sin(lambda), std::sin(theta) * std::cos(lambda));
  const double n_t = d.norm();
  return -n_t * n_t * n_t / d.dot(k * d);
}

// Returns ρ_2 − ρ_1, the difference of the radii of two transverse profiles in line contact. l is
// the distance of the contact from the pitch point, and ψ is the angle between the normal and the
// pitch tangent. All arguments refer to the transverse section. [T7.10]
double line_contact_radius_difference(double rho_1, double l, double r_1, double r_2,
                                      double sin_psi) {
  // Δρ/((ρ_1 − l)(ρ_1 + Δρ − l)) = (r_1 + r_2)/(r_1 r_2 sin ψ)
  const double q = (r_1 + r_2) / (r_1 * r_2 * sin_psi);
  const double to_pitch = rho_1 - l;
  return q * to_pitch * to_pitch / (1.0 - q * to_pitch);
}

}  // namespace

Mat2 cut_curvature(double rho, double b, double theta, double lambda, double r, double turn) {
  const double s_psi = std::sin(theta);
  const double s = std::sin(lambda), c = std::cos(lambda);
  const double l = rho - b / s_psi;
  const double k = 1.0 - l / rho;
  const double d = turn * r * s_psi + l * (s * s * k + s_psi * s_psi * c * c);
  Mat2 m;
  m(0, 0) = -1.0 / rho - s * s * k * k / d;
  m(0, 1) = m(1, 0) = -s * k * s_psi * c / d;
  m(1, 1) = -s_psi * s_psi * c * c / d;
  return m;
}

std::optional<Angle> contact_angle(const ArcMeshInput& in) {
  const double c0 = in.pitch_radius_convex + in.pitch_radius_concave;
  const double change = in.center_distance - c0;
  const double difference = in.concave.radius - in.convex.radius;
  GW_EXPECTS(difference > 0.0);
  // The sine of the contact angle to first order, by [T7.17]. If the change is 0, this formula is
  // [T7.9].
  const double s = (in.concave.b - in.convex.b - change) / difference;
  if (!(s > 0.0 && s < 1.0)) return std::nullopt;
  const double first = std::asin(s);
  const double sin_lambda = std::sin(in.lead_angle.rad());
  // The left side of [T7.16] minus the square of the centre distance. The difference of two squares
  // is written as a product, so that no digits cancel.
  const auto excess = [&](double theta) {
    const double w = height_gap(in, theta);
    const double across = w / std::tan(theta) * sin_lambda;
    return (w - change) * (c0 + w + in.center_distance) + across * across;
  };
  // If the excess at the first-order angle is not positive, the first-order angle is the result.
  // Otherwise the exact angle is slightly greater.
  if (!(excess(first) > 0.0)) return Angle::radians(first);
  // If the centre distance changes very little, both angles are very close to each other. The first
  // step is therefore very short, and each further step is four times as long as the previous one.
  constexpr double kFirstStep = 1e-9;  // rad
  double hi = first;
  for (double step = kFirstStep; hi < kHalfPi; step *= 4) {
    hi = std::min(kHalfPi, first + step);
    if (excess(hi) <= 0.0) {
      const Root root = find_root(excess, first, hi);
      if (root.found()) return Angle::radians(root.x);
      return std::nullopt;
    }
  }
  return std::nullopt;
}

ArcContact arc_contact(const ArcMeshInput& in, Angle normal_angle) {
  ArcContact at{};
  const double theta = normal_angle.rad();
  const double lambda = in.lead_angle.rad();
  const double s = std::sin(lambda), c = std::cos(lambda);
  const double cot = 1.0 / std::tan(theta);
  const double r_v = in.pitch_radius_convex, r_c = in.pitch_radius_concave;
  const double c0 = r_v + r_c;
  const double w = height_gap(in, theta);
  at.theta = normal_angle;
  const double mu = std::atan2(w * cot * s, c0 + w);
  at.mu = Angle::radians(mu);

  // The point and the normal are computed at the position at which the rack cuts them, and are then
  // turned by μ.
  const double x = height(in.convex, theta);
  const double A = r_v + x, B = x * cot * s;
  const double cos_mu = std::cos(mu), sin_mu = std::sin(mu);
  at.advance = r_v * s / c;
  at.point = {A * cos_mu + B * sin_mu, A * sin_mu - B * cos_mu,
              axial(in.convex, theta, lambda) + at.advance * mu};
  const double n_x = std::sin(theta), n_y = -std::cos(theta) * s;
  at.normal = {n_x * cos_mu - n_y * sin_mu, n_x * sin_mu + n_y * cos_mu, std::cos(theta) * c};
  at.radius_convex = std::hypot(A, B);
  const double x_c = height(in.concave, theta);
  at.radius_concave = std::hypot(r_c - x_c, x_c * cot * s);
  // Both gears must touch at the same z, so r_c φ_c tan λ = r_v φ_v tan λ + `ahead`, with φ_v = μ.
  // The concave gear is ahead by φ_c + μ. [T7.18], [T8.23]
  const double ahead = axial(in.convex, theta, lambda) - axial(in.concave, theta, lambda);
  at.rotation_offset = Angle::radians((r_v * mu + ahead * c / s) / r_c + mu);

  at.curvature_convex = cut_curvature(in.convex.radius, in.convex.b, theta, lambda, r_v, 1.0);
  at.curvature_concave = cut_curvature(in.concave.radius, in.concave.b, theta, lambda, r_c, -1.0);
  const SymmetricEigen gap = symmetric_eigen(at.curvature_concave - at.curvature_convex);
  at.gap = {gap.values[0], gap.values[1]};
  // The projection of the axis on the tangent plane, in (t, u).
  const Vec2 axis(-std::sin(theta) * c, s);
  const Vec2 e = gap.vectors.col(0);
  const double cross = axis.x() * e.y() - axis.y() * e.x();
  const double dot = axis.dot(e);
  at.angle = Angle::radians(std::atan(cross / dot));

  at.transverse_radius_convex = transverse_radius(at.curvature_convex, theta, lambda);
  at.transverse_radius_concave = transverse_radius(at.curvature_concave, theta, lambda);
  const double sin_t = n_x / std::hypot(n_x, n_y);
  at.line_contact_difference =
      line_contact_radius_difference(at.transverse_radius_convex, x / sin_t, r_v, r_c, sin_t);
  return at;
}

double tool_setting_change(const ArcMeshInput& in, Angle normal_angle, double delta_distance) {
  const double theta = normal_angle.rad();
  GW_EXPECTS(theta > 0.0 && theta < std::numbers::pi / 2);
  const double c0 = in.pitch_radius_convex + in.pitch_radius_concave;
  const double c = in.center_distance + delta_distance;
  // Solves (C0 + w)² + (w cot θ sin λ)² = C² for w.
  const double t = std::sin(in.lead_angle.rad()) / std::tan(theta);
  const double k = 1.0 + t * t;
  const double rest = (c - c0) * (c + c0);
  const double w = rest / (c0 + std::sqrt(c0 * c0 + k * rest));
  const double b = (in.convex.radius - in.concave.radius) * std::sin(theta) + in.concave.b - w;
  return b - in.convex.b;
}

double thickness_change(const WorkingArc& convex, Angle normal_angle, double delta_b) {
  const double theta = normal_angle.rad();
  const double rho = convex.radius;
  const double up = rho * std::sin(theta) + delta_b;  // x + b at the height of the original point
  GW_EXPECTS(std::abs(up) < rho);
  return 2.0 * (std::sqrt((rho - up) * (rho + up)) - rho * std::cos(theta));
}

}  // namespace gearwright
