#include "gearwright/compliance/section_modes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <complex>
#include <iterator>
#include <span>
#include <utility>

#include "gearwright/base/parallel.hpp"
#include "gearwright/compliance/strip_solver.hpp"

namespace gearwright::detail {

namespace {

// Wave numbers along the face, per module, without k = 0. The wave number 0.15 means a wavelength
// of 42 modules, and 13 means half a module.
constexpr std::array kWaves{0.15, 0.3, 0.6, 1.0, 1.6, 2.5, 4.0, 6.0, 9.0, 13.0};
// Wave numbers of the waves that follow the helix. Without such waves, the root stress of a 17:43
// pair with β = 20° is 6 % too high.
constexpr std::array kHelixWaves{0.5, 2.0, 6.0};
constexpr double kNoEnergy = 1e-20;  // snapshots with less energy are ignored

Eigen::MatrixXd columns(const std::vector<Functional>& list, Eigen::Index n) {
  Eigen::MatrixXd m(n, static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) m.col(i) = list[i].vector(n);
  return m;
}

// Returns the rows with the displacements in the plane of the section (u, v) if `in_plane`,
// otherwise the rows with the displacements along the axis (w). The energy of a wave does not
// couple these two groups.
RowMajor part(const RowMajor& fields, bool in_plane) {
  const Eigen::Index nodes = fields.rows() / 3;
  RowMajor out(in_plane ? 2 * nodes : nodes, fields.cols());
  for (Eigen::Index i = 0; i < nodes; ++i) {
    if (in_plane)
      out.middleRows(2 * i, 2) = fields.middleRows(3 * i, 2);
    else
      out.row(i) = fields.row(3 * i + 2);
  }
  return out;
}

// Returns linear combinations of the displacement fields `snapshots` that are orthonormal with
// respect to their strain energy. `loaded` is the matrix of the energy times the snapshots.
// Combinations with small singular values are dropped.
Eigen::MatrixXd principal(const RowMajor& snapshots, const RowMajor& loaded, double tolerance) {
  Eigen::MatrixXd energy(snapshots.cols(), snapshots.cols());
  energy.triangularView<Eigen::Lower>() = snapshots.transpose() * loaded;
  energy.triangularView<Eigen::StrictlyUpper>() = energy.transpose();
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < energy.cols(); ++i)
    if (energy(i, i) > kNoEnergy) kept.push_back(i);
  const Eigen::MatrixXd some = energy(kept, kept);
  const Eigen::VectorXd unit = some.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd gram = unit.asDiagonal() * some * unit.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
  const Eigen::VectorXd& w = eigen.eigenvalues();
  const auto count = static_cast<Eigen::Index>(kept.size());
  const double least = tolerance * tolerance * w[count - 1];
  Eigen::Index first = 0;
  while (w[first] <= least) ++first;
  Eigen::MatrixXd v = Eigen::MatrixXd::Zero(energy.cols(), count - first);
  v(kept, Eigen::all) = unit.asDiagonal() * eigen.eigenvectors().rightCols(count - first) *
                        w.tail(count - first).cwiseSqrt().cwiseInverse().asDiagonal();
  return snapshots * v;
}

void append(std::vector<Eigen::MatrixXd>& all, std::vector<Eigen::MatrixXd> more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

RowMajor side_by_side(const std::vector<Eigen::MatrixXd>& fields) {
  Eigen::Index count = 0;
  for (const auto& f : fields) count += f.cols();
  RowMajor all(fields.front().rows(), count);
  Eigen::Index at = 0;
  for (const auto& f : fields) {
    all.middleCols(at, f.cols()) = f;
    at += f.cols();
  }
  return all;
}

// Returns the displacements of all waves. The result does not depend on the number of threads.
template <class Scalar>
std::vector<StripSolver::Fields<Scalar>> solved(const StripSolver& strip,
                                                const std::vector<StripWave>& waves,
                                                Progress* progress) {
  constexpr std::size_t kTogether = StripSolver::kTogether<Scalar>;
  std::vector<StripSolver::Fields<Scalar>> fields(waves.size());
  parallel_for((waves.size() + kTogether - 1) / kTogether, [&](std::size_t group) {
    const std::size_t first = group * kTogether;
    const std::size_t count = std::min(kTogether, waves.size() - first);
    auto some = strip.solve<Scalar>(std::span(waves).subspan(first, count));
    for (std::size_t i = 0; i < count; ++i) {
      count_step(progress);
      fields[first + i] = std::move(some[i]);
    }
  });
  return fields;
}

// Returns the displacement fields of a spur section. They are waves, plane strain, plane stress,
// and the warping due to plane strain and to plane stress, which accounts for the unloaded end
// faces. If τ ≠ 0, waves under axial loads are added.
std::vector<Eigen::MatrixXd> fields_of_a_spur(const StripSolver& strip, const SectionMesh& mesh,
                                              const SectionMatrices& wave, double nu,
                                              const std::vector<BumpPlace>& places, double tau,
                                              Progress* progress) {
  std::vector<Functional> loads;
  for (const auto& [s, c] : places) loads.push_back(bump(mesh, s, c, 0.0));
  const Eigen::Index n = wave.aa.rows();
  const Eigen::MatrixXd in_plane = columns(loads, n);
  if (tau != 0.0)
    for (const auto& [s, c] : places) loads.push_back(axial_bump(mesh, s, c));
  const Eigen::MatrixXd every = columns(loads, n);
  const Matrix6 plane_stress = hooke((1 + 2 * nu) / ((1 + nu) * (1 + nu)), nu / (1 + nu));
  const SectionMatrices thin = section_matrices(mesh, plane_stress, 0.0, true);
  std::vector<StripWave> waves;
  for (const double k : kWaves) waves.push_back({&wave, k, &every});
  constexpr std::size_t kPlaneStrain = kWaves.size();
  constexpr std::size_t kPlaneStress = kPlaneStrain + 1;
  waves.push_back({&wave, 0.0, &in_plane});
  waves.push_back({&thin, 0.0, &in_plane});
  std::vector<Eigen::MatrixXd> fields = solved<double>(strip, waves, progress);
  fields.push_back(trace_fields(mesh, fields[kPlaneStrain]));
  fields.push_back(trace_fields(mesh, fields[kPlaneStress]));
  return fields;
}

// Returns the real and imaginary parts of waves that follow the helix, under loads along the normal
// of the screw surface. [T12.18]
std::vector<Eigen::MatrixXd> fields_along_helix(const StripSolver& strip, const SectionMesh& mesh,
                                                const SectionMatrices& own,
                                                const std::vector<BumpPlace>& places, double tau,
                                                Progress* progress) {
  std::vector<Functional> screw;
  for (const auto& [s, c] : places) screw.push_back(bump(mesh, s, c, tau));
  const Eigen::MatrixXd loads = columns(screw, own.aa.rows());
  std::vector<StripWave> waves;
  for (const double k : kHelixWaves) waves.push_back({&own, k, &loads});
  std::vector<Eigen::MatrixXd> fields;
  for (const Eigen::MatrixXcd& x : solved<std::complex<double>>(strip, waves, progress)) {
    Eigen::MatrixXd& parts = fields.emplace_back(x.rows(), 2 * x.cols());
    parts << x.real(), x.imag();
  }
  return fields;
}

// Returns the matrices of arbitrary functions of z, from the matrices of waves and without a helix.
// B has the opposite sign in the columns of u and v.
SectionMatrices not_of_waves(SectionMatrices wave) {
  for (Eigen::Index j = 0; j < wave.ab.cols(); ++j)
    if (j % 3 < 2) wave.ab.col(j) *= -1.0;
  return wave;
}

// Returns the product of a matrix and the modes. The first part contains the rows of the degrees of
// freedom u and v, and the second part the rows of w. The columns of `across` are the modes with
// displacements in the plane of the section, and the columns of `along` are the modes with
// displacements along the axis.
std::array<RowMajor, 2> product(const Sparse& matrix, const RowMajor& across,
                                const RowMajor& along) {
  const Eigen::Index modes = across.cols() + along.cols();
  std::array<RowMajor, 2> out{RowMajor::Zero(across.rows(), modes),
                              RowMajor::Zero(along.rows(), modes)};
  for (Eigen::Index j = 0; j < matrix.outerSize(); ++j) {
    const bool in_plane = j % 3 < 2;
    const auto mode = in_plane ? across.row(j / 3 * 2 + j % 3) : along.row(j / 3);
    for (Sparse::InnerIterator it(matrix, j); it; ++it) {
      if (it.value() == 0.0) continue;
      const Eigen::Index i = it.row();
      auto row = i % 3 < 2 ? out[0].row(i / 3 * 2 + i % 3) : out[1].row(i / 3);
      row.segment(in_plane ? 0 : across.cols(), mode.size()) += it.value() * mode;
    }
  }
  return out;
}

ModeMatrices projected(const SectionMatrices& own, const RowMajor& across, const RowMajor& along,
                       Progress* progress) {
  const std::array<const Sparse*, 3> from{&own.aa, &own.ab, &own.bb};
  const Eigen::Index n = across.cols(), m = along.cols();
  std::array<Eigen::MatrixXd, 3> to;
  parallel_for(from.size(), [&](std::size_t i) {
    count_step(progress);
    const auto [in_plane, axial] = product(*from[i], across, along);
    to[i].resize(n + m, n + m);
    if (from[i] == &own.ab) {
      to[i].topRows(n).noalias() = across.transpose() * in_plane;
      to[i].bottomRows(m).noalias() = along.transpose() * axial;
      return;
    }
    to[i].topLeftCorner(n, n).triangularView<Eigen::Lower>() =
        across.transpose() * in_plane.leftCols(n);
    to[i].bottomLeftCorner(m, n).noalias() = along.transpose() * axial.leftCols(n);
    to[i].bottomRightCorner(m, m).triangularView<Eigen::Lower>() =
        along.transpose() * axial.rightCols(m);
    to[i].triangularView<Eigen::StrictlyUpper>() = to[i].transpose();
  });
  return {to[0], to[1], to[2]};
}

}  // namespace

Eigen::MatrixXd plane_strain(const SectionMesh& mesh, double poisson_ratio,
                             const std::vector<Functional>& loads) {
  const SectionMatrices wave = section_matrices(mesh, hooke(1.0, poisson_ratio), 0.0, true);
  const Eigen::MatrixXd right = columns(loads, wave.aa.rows());
  const StripWave constant{&wave, 0.0, &right};
  return StripSolver(mesh, wave).solve<double>({&constant, 1}).front();
}

SectionModes section_modes(const SectionMesh& mesh, double poisson_ratio,
                           const std::vector<BumpPlace>& places, double tau, double tolerance,
                           Progress* progress) {
  const Matrix6 law = hooke(1.0, poisson_ratio);
  SectionMatrices wave = section_matrices(mesh, law, 0.0, true);
  SectionMatrices own;
  const StripSolver strip(mesh, wave);
  std::vector<Eigen::MatrixXd> fields =
      fields_of_a_spur(strip, mesh, wave, poisson_ratio, places, tau, progress);
  if (tau != 0.0) {
    own = section_matrices(mesh, law, tau, false);
    append(fields, fields_along_helix(strip, mesh, own, places, tau, progress));
  }
  const RowMajor snapshots = side_by_side(fields);

  const Sparse energy = (wave.aa + wave.bb).pruned();
  const RowMajor loaded = energy * snapshots;
  std::array<RowMajor, 2> of_part;
  parallel_for(2, [&](std::size_t i) {
    count_step(progress);
    of_part[i] = principal(part(snapshots, i == 0), part(loaded, i == 0), tolerance);
  });
  const auto& [across, along] = of_part;
  SectionModes modes;
  modes.fields = Eigen::MatrixXd::Zero(snapshots.rows(), across.cols() + along.cols());
  for (Eigen::Index i = 0; i < snapshots.rows() / 3; ++i) {
    modes.fields.block(3 * i, 0, 2, across.cols()) = across.middleRows(2 * i, 2);
    modes.fields.row(3 * i + 2).tail(along.cols()) = along.row(i);
  }
  if (tau == 0.0) own = not_of_waves(std::move(wave));
  modes.matrices = projected(own, across, along, progress);
  return modes;
}

}  // namespace gearwright::detail
