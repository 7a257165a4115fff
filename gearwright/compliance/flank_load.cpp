#include "gearwright/compliance/flank_load.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "gearwright/compliance/q9.hpp"

namespace gearwright::detail {

namespace {

constexpr int kBumpPoints = 24;

using Complex = std::complex<double>;

// Adds to `f` the shape functions at t on the outline, times `weight` and `direction`.
void add_point(const SectionMesh& mesh, double t, const Eigen::Vector3d& direction, double weight,
               Functional& f) {
  const auto last = static_cast<double>(mesh.edges.size());
  const double at = std::clamp(t, 0.0, last);
  const auto e = std::min(static_cast<std::size_t>(at), mesh.edges.size() - 1);
  const SectionMesh::Edge& edge = mesh.edges[e];
  const double x = 2 * (at - double(e)) - 1;
  const Shape9 s = shape9(edge.forward ? x : -x, -1.0);
  const auto& nodes = mesh.elements[edge.element];
  for (int k = 0; k < 9; ++k) {
    if (s.value[k] == 0.0) continue;
    for (int c = 0; c < 3; ++c) {
      if (direction[c] == 0.0) continue;
      f.dof.push_back(3 * nodes[k] + c);
      f.weight.push_back(weight * s.value[k] * direction[c]);
    }
  }
}

Functional spread(const SectionMesh& mesh, double s, double c, const Eigen::Vector3d& direction) {
  static const GaussRule rule = gauss_rule(kBumpPoints);
  Functional f;
  for (int i = 0; i < kBumpPoints; ++i) {
    const double x = rule.x[i];
    const double q = 15.0 / 16.0 * (1 - x * x) * (1 - x * x) * rule.weight[i];
    add_point(mesh, mesh.parameter_at(s + c * x), direction, q, f);
  }
  return f;
}

}  // namespace

Eigen::VectorXd Functional::vector(Eigen::Index n) const {
  Eigen::VectorXd v = Eigen::VectorXd::Zero(n);
  for (std::size_t i = 0; i < dof.size(); ++i) v[dof[i]] += weight[i];
  return v;
}

FlankPlace flank_place(const SectionMesh& mesh, double s) {
  const double t = mesh.parameter_at(s);
  const auto [arc, u] = mesh.arc_at(t);
  Complex tangent = std::polar(1.0, arc->at(u).tangent_angle);
  if (arc->end < arc->begin) tangent = -tangent;
  // On the side y > 0, the outline runs from the tooth space to the tip. The material of an
  // external gear lies to the right of the outline, and that of an internal gear to the left.
  return {mesh.outline(t), tangent * Complex(0, -mesh.outward), tangent};
}

double length_at_radius(const SectionMesh& mesh, double radius) {
  double lo = mesh.flank_begin;
  double hi = static_cast<double>(mesh.edges.size());
  for (int i = 0; i < 60; ++i) {
    const double mid = 0.5 * (lo + hi);
    (mesh.outward * (radius - std::abs(mesh.outline(mid))) > 0.0 ? lo : hi) = mid;
  }
  return mesh.length_at(0.5 * (lo + hi));
}

Functional bump(const SectionMesh& mesh, double s, double c, double tau) {
  const FlankPlace p = flank_place(mesh, s);
  // The normal of the screw surface is perpendicular to the outline and to ∂x/∂z = e_z + τ e_z × w.
  const Complex along = tau * Complex(0, 1) * p.point;
  const double axial = -(p.normal * std::conj(along)).real();
  const double length = std::hypot(1.0, axial);
  return spread(mesh, s, c, Eigen::Vector3d(p.normal.real(), p.normal.imag(), axial) / length);
}

Functional axial_bump(const SectionMesh& mesh, double s, double c) {
  return spread(mesh, s, c, Eigen::Vector3d(0, 0, 1));
}

Functional on_tooth(const SectionMesh& mesh, const Functional& f, int k) {
  const auto& from = mesh.teeth[mesh.side_teeth];
  const auto& to = mesh.teeth[mesh.side_teeth + k];
  std::map<int, int> moved;
  for (std::size_t i = 0; i < from.size(); ++i) moved[from[i]] = to[i];
  const double angle = 2 * std::numbers::pi * k / mesh.tooth_count;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Functional g;
  const auto add = [&](int dof, double weight) {
    g.dof.push_back(dof);
    g.weight.push_back(weight);
  };
  for (std::size_t i = 0; i < f.dof.size(); ++i) {
    const int node = 3 * moved.at(f.dof[i] / 3);
    const double w = f.weight[i];
    switch (f.dof[i] % 3) {
      case 0: add(node, w * c), add(node + 1, w * s); break;
      case 1: add(node, -w * s), add(node + 1, w * c); break;
      default: add(node + 2, w);
    }
  }
  return g;
}

}  // namespace gearwright::detail
