#include "gearwright/compliance/strip_solver.hpp"

#include <Eigen/OrderingMethods>
#include <algorithm>
#include <array>
#include <utility>

#include "gearwright/base/contract.hpp"

namespace gearwright::detail {

namespace {

using Eigen::Index;

// Returns the unconstrained nodes in minimum degree order, which keeps the factors sparse.
std::vector<int> elimination_order(const SectionMesh& mesh) {
  std::vector<int> place(mesh.nodes.size(), 0);
  for (const int i : mesh.bore) place[i] = -1;
  std::vector<int> free;
  for (std::size_t i = 0; i < place.size(); ++i)
    if (place[i] == 0) {
      place[i] = static_cast<int>(free.size());
      free.push_back(static_cast<int>(i));
    }
  std::vector<Eigen::Triplet<double>> beside;
  for (const auto& e : mesh.elements)
    for (const int j : e)
      for (const int i : e)
        if (place[i] >= 0 && place[j] >= 0) beside.emplace_back(place[i], place[j], 1.0);
  const auto n = static_cast<Index>(free.size());
  Sparse graph(n, n);
  graph.setFromTriplets(beside.begin(), beside.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(graph, order);
  std::vector<int> out;
  for (Index i = 0; i < n; ++i) out.push_back(free[order.indices()[i]]);
  return out;
}

// Returns, for each entry of a matrix with a symmetric pattern, the index of its mirror image.
std::vector<int> mirrored_entries(const Sparse& m) {
  std::vector<int> next(m.outerIndexPtr(), m.outerIndexPtr() + m.cols());
  std::vector<int> mirrored(static_cast<std::size_t>(m.nonZeros()));
  for (Index p = 0; p < m.nonZeros(); ++p) mirrored[p] = next[m.innerIndexPtr()[p]]++;
  return mirrored;
}

// Returns an entry of K(k). [T12.6], [T12.18]
double at_wave(double aa, double ab, double ba, double bb, double k, double) {
  return aa + (k * (ab + ba) + k * k * bb);
}
std::complex<double> at_wave(double aa, double ab, double ba, double bb, double k,
                             std::complex<double>) {
  return {aa + k * k * bb, k * (ab - ba)};
}

template <int N>
Eigen::Array<double, N, 1> divided(const Eigen::Array<double, N, 1>& a,
                                   const Eigen::Array<double, N, 1>& b) {
  return a / b;
}
template <int N>
Eigen::Array<std::complex<double>, N, 1> divided(const Eigen::Array<std::complex<double>, N, 1>& a,
                                                 const Eigen::Array<double, N, 1>& b) {
  Eigen::Array<std::complex<double>, N, 1> quotient;
  for (int w = 0; w < N; ++w) quotient[w] = a[w] / b[w];
  return quotient;
}

}  // namespace

StripSolver::StripSolver(const SectionMesh& mesh, const SectionMatrices& pattern) {
  const Sparse& m = pattern.aa;
  const std::vector<int> order = elimination_order(mesh);
  const std::vector<int> mirrored = mirrored_entries(m);
  std::vector<int> place(mesh.nodes.size(), -1);
  for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = static_cast<int>(i);
  upper_begin_.push_back(0);
  std::vector<std::pair<int, int>> above;  // place of each earlier node, and index of its first row
  for (int j = 0; j < static_cast<int>(order.size()); ++j)
    for (int c = 0; c < 3; ++c) {
      const int column = 3 * order[j] + c;
      free_.push_back(column);
      above.clear();
      for (int p = m.outerIndexPtr()[column]; p < m.outerIndexPtr()[column + 1]; p += 3)
        if (const int i = place[m.innerIndexPtr()[p] / 3]; i >= 0 && i <= j)
          above.push_back({i, p});
      std::sort(above.begin(), above.end());
      for (const auto& [i, p] : above)
        for (int r = 0; r < (i < j ? 3 : c + 1); ++r)
          upper_.push_back({3 * i + r, p + r, mirrored[p + r]});
      upper_begin_.push_back(static_cast<int>(upper_.size()));
    }
  find_factor_entries();
}

// Finds the positions of the entries of L. The entries of row k of L are in the columns of the
// nodes on the paths in the elimination tree that lead from the entries of row k of K to node k.
void StripSolver::find_factor_entries() {
  const auto n = static_cast<int>(free_.size());
  std::vector<int> parent(n, -1), reached_by(n, -1), count(n, 0), path, row(n);
  row_begin_.push_back(0);
  for (int k = 0; k < n; ++k) {
    reached_by[k] = k;
    int top = n;
    for (int e = upper_begin_[k]; e < upper_begin_[k + 1]; ++e) {
      path.clear();
      for (int i = upper_[e].row; reached_by[i] != k; i = parent[i]) {
        if (parent[i] < 0) parent[i] = k;
        path.push_back(i);
        reached_by[i] = k;
        ++count[i];
      }
      while (!path.empty()) {
        row[--top] = path.back();
        path.pop_back();
      }
    }
    column_of_.insert(column_of_.end(), row.begin() + top, row.end());
    row_begin_.push_back(static_cast<int>(column_of_.size()));
  }
  lower_begin_.push_back(0);
  for (int i = 0; i < n; ++i) lower_begin_.push_back(lower_begin_.back() + count[i]);
  lower_row_.resize(column_of_.size());
  std::vector<int> next(lower_begin_.begin(), lower_begin_.end() - 1);
  for (int k = 0; k < n; ++k)
    for (int e = row_begin_[k]; e < row_begin_[k + 1]; ++e) lower_row_[next[column_of_[e]]++] = k;
}

// The factors L D Lᴴ of the matrices of N waves.
template <class Scalar, int N>
class StripSolver::Factor {
 public:
  using Lanes = Eigen::Array<Scalar, N, 1>;
  using Diagonal = Eigen::Array<double, N, 1>;

  // If there are fewer than N waves, the last one is repeated.
  Factor(const StripSolver& of, std::span<const StripWave> waves)
      : of_(of), lower_(of.lower_row_.size()), diagonal_(of.free_.size()) {
    struct Values {
      const double *aa, *ab, *bb;
      double k;
    };
    std::array<Values, N> lane;
    for (int w = 0; w < N; ++w) {
      const StripWave& wave = waves[std::min<std::size_t>(w, waves.size() - 1)];
      const SectionMatrices& m = *wave.matrices;
      lane[w] = {m.aa.valuePtr(), m.ab.valuePtr(), m.bb.valuePtr(), wave.k};
    }
    const auto n = static_cast<int>(of.free_.size());
    std::vector<Lanes> y(n, Lanes::Zero());
    std::vector<int> end(of.lower_begin_.begin(), of.lower_begin_.end() - 1);
    for (int k = 0; k < n; ++k) {
      for (int e = of.upper_begin_[k]; e < of.upper_begin_[k + 1]; ++e) {
        const auto [row, at, mirrored] = of.upper_[e];
        for (int w = 0; w < N; ++w) {
          const auto& [aa, ab, bb, wave] = lane[w];
          y[row][w] =
              Eigen::numext::conj(at_wave(aa[at], ab[at], ab[mirrored], bb[at], wave, Scalar()));
        }
      }
      Diagonal d = y[k].real();
      y[k].setZero();
      for (int e = of.row_begin_[k]; e < of.row_begin_[k + 1]; ++e) {
        const int i = of.column_of_[e];
        const Lanes yi = y[i];
        y[i].setZero();
        const Lanes entry = divided(yi, diagonal_[i]);
        for (int p = of.lower_begin_[i]; p < end[i]; ++p)
          y[of.lower_row_[p]] -= lower_[p].conjugate() * yi;
        d -= (entry * yi.conjugate()).real();
        lower_[end[i]++] = entry;
      }
      GW_ENSURES((d != 0.0).all());
      diagonal_[k] = d;
    }
  }

  // Replaces the loads, with `columns` entries for each degree of freedom, by the displacements.
  void solve(std::vector<Lanes>& x, int columns) const {
    const auto n = static_cast<int>(of_.free_.size());
    for (int i = 0; i < n; ++i) {
      const Lanes* const xi = &x[static_cast<std::size_t>(i) * columns];
      if (std::all_of(xi, xi + columns, [](const Lanes& v) { return (v == Scalar(0)).all(); }))
        continue;
      for (int p = of_.lower_begin_[i]; p < of_.lower_begin_[i + 1]; ++p) {
        Lanes* const to = &x[static_cast<std::size_t>(of_.lower_row_[p]) * columns];
        for (int c = 0; c < columns; ++c) to[c] -= xi[c] * lower_[p];
      }
    }
    for (int i = n - 1; i >= 0; --i) {
      Lanes* const xi = &x[static_cast<std::size_t>(i) * columns];
      const Lanes diagonal = diagonal_[i].template cast<Scalar>();
      const Lanes inverse = diagonal.inverse();
      for (int c = 0; c < columns; ++c) xi[c] *= inverse;
      for (int p = of_.lower_begin_[i]; p < of_.lower_begin_[i + 1]; ++p) {
        const Lanes* const from = &x[static_cast<std::size_t>(of_.lower_row_[p]) * columns];
        const Lanes l = lower_[p].conjugate();
        for (int c = 0; c < columns; ++c) xi[c] -= l * from[c];
      }
    }
  }

 private:
  const StripSolver& of_;
  std::vector<Lanes> lower_;  // in the order of lower_row_
  std::vector<Diagonal> diagonal_;
};

template <class Scalar, int N>
std::vector<StripSolver::Fields<Scalar>> StripSolver::solve_together(
    std::span<const StripWave> waves) const {
  const Factor<Scalar, N> factor(*this, waves);
  using Lanes = typename Factor<Scalar, N>::Lanes;
  Index columns = 0;
  for (const StripWave& w : waves) columns = std::max(columns, w.loads->cols());
  std::vector<Lanes> x(free_.size() * static_cast<std::size_t>(columns), Lanes::Zero());
  for (std::size_t w = 0; w < waves.size(); ++w)
    for (Index c = 0; c < waves[w].loads->cols(); ++c)
      for (std::size_t i = 0; i < free_.size(); ++i)
        x[i * columns + c][w] = (*waves[w].loads)(free_[i], c);
  factor.solve(x, static_cast<int>(columns));
  std::vector<Fields<Scalar>> out;
  for (std::size_t w = 0; w < waves.size(); ++w) {
    const Eigen::MatrixXd& loads = *waves[w].loads;
    Fields<Scalar>& to = out.emplace_back(Fields<Scalar>::Zero(loads.rows(), loads.cols()));
    for (Index c = 0; c < loads.cols(); ++c)
      for (std::size_t i = 0; i < free_.size(); ++i) to(free_[i], c) = x[i * columns + c][w];
  }
  return out;
}

template <class Scalar>
std::vector<StripSolver::Fields<Scalar>> StripSolver::solve(
    std::span<const StripWave> waves) const {
  GW_EXPECTS(!waves.empty() && waves.size() <= kTogether<Scalar>);
  if (waves.size() == 1) return solve_together<Scalar, 1>(waves);
  return solve_together<Scalar, kTogether<Scalar>>(waves);
}

template std::vector<StripSolver::Fields<double>> StripSolver::solve<double>(
    std::span<const StripWave>) const;
template std::vector<StripSolver::Fields<std::complex<double>>>
    StripSolver::solve<std::complex<double>>(std::span<const StripWave>) const;

}  // namespace gearwright::detail
