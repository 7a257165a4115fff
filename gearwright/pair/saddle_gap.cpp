#include "gearwright/pair/saddle_gap.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

struct Saddle {
  double L;                                      // mm, between the base tangent points
  double sin2, cos2;                             // sin² η and cos² η
  double begin, end;                             // λ_1 at both ends of the path
  std::array<double, 2> curvature_per_crowning;  // K_i/C_βi  1/mm²
};

Saddle saddle_of(const MeshInput<double>& in, const Mesh<double>& mesh) {
  GW_EXPECTS(in.shaft_angle && mesh.sigma < 0.0 && mesh.base_tangent_distance > 0.0);
  const auto& sides = mesh.rack.sides;
  const double sin_a = mesh.rack.angles.sin_alpha;
  const double eta = std::atan(sides[0].tan_helix * sin_a) - std::atan(sides[1].tan_helix * sin_a);
  const bool any = mesh.rho1_true_begin < mesh.rho1_true_end;
  Saddle s{};
  s.L = mesh.base_tangent_distance / mesh.line_cosine;
  s.sin2 = std::sin(eta) * std::sin(eta);
  s.cos2 = std::cos(eta) * std::cos(eta);
  s.begin = std::max(0.0, any ? mesh.rho1_true_begin : mesh.rho1_A) / mesh.line_cosine;
  s.end = std::max(s.begin, (any ? mesh.rho1_true_end : mesh.rho1_E) / mesh.line_cosine);
  for (int i : {0, 1}) {
    const double along = std::cos(in.gears[i].helix_angle) / in.face_width[i];
    s.curvature_per_crowning[i] = 8 * along * along;
  }
  return s;
}

}  // namespace

std::array<std::optional<double>, 2> needed_crowning(const MeshInput<double>& in,
                                                     const Mesh<double>& mesh) {
  const Saddle s = saddle_of(in, mesh);
  const std::array<double, 2> stretch{s.L + s.begin * s.sin2, s.L * s.cos2 - s.end * s.sin2};
  std::array<std::optional<double>, 2> needed;
  for (int i : {0, 1})
    if (stretch[i] > 0.0) needed[i] = s.sin2 / stretch[i] / s.curvature_per_crowning[i];
  return needed;
}

bool clears_beside_line(const MeshInput<double>& in, const Mesh<double>& mesh,
                        const std::array<double, 2>& crowning) {
  const Saddle s = saddle_of(in, mesh);
  const double K_1 = s.curvature_per_crowning[0] * crowning[0];
  const double K_2 = s.curvature_per_crowning[1] * crowning[1];
  const double both = K_1 * K_2 * s.sin2;
  const auto clear_at = [&](double lambda) {
    return K_1 * (s.L + lambda * s.sin2) + K_2 * (s.L * s.cos2 - lambda * s.sin2) +
               both * lambda * (lambda + s.L) >
           s.sin2;
  };
  // The left-hand side of the inequality in clear_at is a parabola in λ. Its least value is at the
  // vertex. If the vertex lies beyond the path, the least value is at an end of the path.
  const double vertex = both > 0.0 ? -s.L / 2 - (K_1 - K_2) * s.sin2 / (2 * both) : s.begin;
  return clear_at(s.begin) && clear_at(s.end) && clear_at(std::clamp(vertex, s.begin, s.end));
}

}  // namespace gearwright
