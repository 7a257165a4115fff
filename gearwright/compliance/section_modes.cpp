#include "gearwright/compliance/section_modes.hpp"

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>

namespace gearwright::detail {

namespace {

// Wave numbers along the face, per module, k = 0 apart: 0.3 is a wave of 21 modules, 13 one of half
// a module, shorter than any bump.
constexpr std::array kWaves{0.15, 0.3, 0.6, 1.0, 1.6, 2.5, 4.0, 6.0, 9.0, 13.0};
constexpr double kNoEnergy = 1e-20;

Eigen::MatrixXd columns(const std::vector<Functional>& list, Eigen::Index n) {
  Eigen::MatrixXd m(n, static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) m.col(i) = list[i].vector(n);
  return m;
}

// Orthonormal in the energy, small ones dropped.
Eigen::MatrixXd principal(const Eigen::MatrixXd& snapshots, const Sparse& energy,
                          double tolerance) {
  Eigen::MatrixXd a(snapshots.rows(), snapshots.cols());
  Eigen::Index kept = 0;
  const Eigen::MatrixXd loaded = energy * snapshots;
  for (Eigen::Index i = 0; i < snapshots.cols(); ++i) {
    const double e = snapshots.col(i).dot(loaded.col(i));
    if (e > kNoEnergy) a.col(kept++) = snapshots.col(i) / std::sqrt(e);
  }
  a.conservativeResize(Eigen::NoChange, kept);
  const Eigen::MatrixXd ka = energy * a;
  const Eigen::MatrixXd gram = a.transpose() * ka;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
  const Eigen::VectorXd& w = eigen.eigenvalues();
  const double least = tolerance * tolerance * w[kept - 1];
  Eigen::Index first = 0;
  while (w[first] <= least) ++first;
  const Eigen::MatrixXd v = eigen.eigenvectors().rightCols(kept - first) *
                            w.tail(kept - first).cwiseSqrt().cwiseInverse().asDiagonal();
  return a * v;
}

// Only the rows of u and v, or only those of w.
Eigen::MatrixXd part(const Eigen::MatrixXd& fields, bool in_plane) {
  Eigen::MatrixXd out = fields;
  for (Eigen::Index i = 0; i < fields.rows(); ++i)
    if ((i % 3 == 2) == in_plane) out.row(i).setZero();
  return out;
}

void append(Eigen::MatrixXd& all, const Eigen::MatrixXd& more) {
  const Eigen::Index at = all.cols();
  all.conservativeResize(more.rows(), at + more.cols());
  all.rightCols(more.cols()) = more;
}

}  // namespace

Eigen::MatrixXd plane_strain(const SectionMesh& mesh, double poisson_ratio,
                             const std::vector<Functional>& loads) {
  const SectionMatrices wave = section_matrices(mesh, hooke(1.0, poisson_ratio), 0.0, true);
  StripSolver strip(mesh, wave);
  return strip.solve(0.0, columns(loads, wave.aa.rows()));
}

SectionModes section_modes(const SectionMesh& mesh, double poisson_ratio,
                           const std::vector<Functional>& loads,
                           const std::vector<Functional>& axial, double tolerance) {
  const double nu = poisson_ratio;
  const SectionMatrices wave = section_matrices(mesh, hooke(1.0, nu), 0.0, true);
  StripSolver strip(mesh, wave);
  const Eigen::Index n = wave.aa.rows();
  const Eigen::MatrixXd right = columns(loads, n);
  Eigen::MatrixXd both(n, right.cols() + static_cast<Eigen::Index>(axial.size()));
  both << right, columns(axial, n);

  SectionModes modes;
  modes.plane = strip.solve(0.0, right);
  Eigen::MatrixXd snapshots = modes.plane;
  for (const double k : kWaves) append(snapshots, strip.solve(k, both));
  // Free ends: plane stress, and the warping by which a section in plane strain becomes one.
  const SectionMatrices thin =
      section_matrices(mesh, hooke((1 + 2 * nu) / ((1 + nu) * (1 + nu)), nu / (1 + nu)), 0.0, true);
  const Eigen::MatrixXd free = StripSolver(mesh, thin).solve(0.0, right);
  append(snapshots, free);
  append(snapshots, trace_fields(mesh, modes.plane));
  append(snapshots, trace_fields(mesh, free));

  const Sparse energy = wave.aa + wave.bb;
  const Eigen::MatrixXd across = principal(part(snapshots, true), energy, tolerance);
  const Eigen::MatrixXd along = principal(part(snapshots, false), energy, tolerance);
  modes.in_plane = static_cast<int>(across.cols());
  modes.fields.resize(n, across.cols() + along.cols());
  modes.fields << across, along;
  return modes;
}

ModeMatrices mode_matrices(const SectionMesh& mesh, const SectionModes& modes, double poisson_ratio,
                           double tau) {
  const SectionMatrices s = section_matrices(mesh, hooke(1.0, poisson_ratio), tau, false);
  const Eigen::MatrixXd& phi = modes.fields;
  const auto projected = [&](const Sparse& m) -> Eigen::MatrixXd {
    const Eigen::MatrixXd right = m * phi;
    return phi.transpose() * right;
  };
  return {projected(s.aa), projected(s.ab), projected(s.bb)};
}

}  // namespace gearwright::detail
