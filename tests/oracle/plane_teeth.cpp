#include "tests/oracle/plane_teeth.hpp"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/oracle/plane_mesh.hpp"

namespace gearwright::oracle {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Slopes = Eigen::Matrix<double, 2, 6>;

Slopes slopes(double a, double b) {
  const double c = 1 - a - b;
  Slopes d;
  d << 1 - 4 * c, 4 * a - 1, 0, 4 * (c - a), 4 * b, -4 * b,  //
      1 - 4 * c, 0, 4 * b - 1, -4 * a, 4 * a, 4 * (c - b);
  return d;
}

constexpr std::array<std::array<double, 2>, 6> kCorners{
    {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}};

class Section {
 public:
  Section(const PlaneGear& gear, const std::vector<PlaneLoad>& loads, double fineness)
      : gear_(gear), loads_(loads), mesh_(plane_mesh(gear, loads, fineness)) {}

  PlaneAnswer solve() const;

 private:
  Eigen::Matrix<double, 3, 12> strains(const std::array<int, 6>& t, double a, double b,
                                       double& area) const;
  Eigen::Matrix3d law() const;
  VectorXd force(std::size_t load) const;
  VectorXd reading(std::size_t load) const;
  MatrixXd root(std::size_t load, const MatrixXd& u) const;

  const PlaneGear& gear_;
  const std::vector<PlaneLoad>& loads_;
  PlaneMesh mesh_;
};

Eigen::Matrix<double, 3, 12> Section::strains(const std::array<int, 6>& t, double a, double b,
                                              double& area) const {
  Eigen::Matrix<double, 6, 2> at;
  for (int n = 0; n < 6; ++n) at.row(n) << mesh_.nodes[t[n]].real(), mesh_.nodes[t[n]].imag();
  const Slopes local = slopes(a, b);
  const Eigen::Matrix2d jacobian = local * at;
  area = jacobian.determinant();
  const Slopes d = jacobian.inverse() * local;
  Eigen::Matrix<double, 3, 12> e = Eigen::Matrix<double, 3, 12>::Zero();
  for (int n = 0; n < 6; ++n) {
    e(0, 2 * n) = e(2, 2 * n + 1) = d(0, n);
    e(1, 2 * n + 1) = e(2, 2 * n) = d(1, n);
  }
  return e;
}

Eigen::Matrix3d Section::law() const {
  const double nu = gear_.poisson;
  Eigen::Matrix3d d;
  d << 1 - nu, nu, 0, nu, 1 - nu, 0, 0, 0, 0.5 - nu;
  return d / ((1 + nu) * (1 - 2 * nu));
}

// The displacement due to a unit force that is distributed by Hertz's law, x = a sin φ.
VectorXd Section::force(std::size_t load) const {
  constexpr int kSteps = 400;
  VectorXd f = VectorXd::Zero(2 * static_cast<Eigen::Index>(mesh_.nodes.size()));
  const PlaneTooth& tooth = mesh_.teeth.at(loads_[load].tooth);
  const VectorXd at = reading(load);
  const int node = tooth.middle();
  for (int i = 0; i < kSteps; ++i) {
    const double phi = std::numbers::pi * ((i + 0.5) / kSteps - 0.5);
    const double part = 2 * std::cos(phi) * std::cos(phi) / kSteps;
    const double l = tooth.loaded + loads_[load].half_width * std::sin(phi);
    std::size_t e = 0;
    while (e + 4 < tooth.place.size() && tooth.place[e + 2] < l) e += 2;
    const double x = 2 * (l - tooth.place[e]) / (tooth.place[e + 2] - tooth.place[e]) - 1;
    const double n[3] = {0.5 * x * (x - 1), 1 - x * x, 0.5 * x * (x + 1)};
    for (int k = 0; k < 3; ++k)
      f.segment<2>(2 * tooth.node[e + k]) += part * n[k] * at.segment<2>(2 * node);
  }
  return f;
}

// The inward normal at the middle of a load.
VectorXd Section::reading(std::size_t load) const {
  VectorXd f = VectorXd::Zero(2 * static_cast<Eigen::Index>(mesh_.nodes.size()));
  const PlaneTooth& tooth = mesh_.teeth.at(loads_[load].tooth);
  const int node = tooth.middle();
  f.segment<2>(2 * node) << tooth.normal.real(), tooth.normal.imag();
  return f;
}

MatrixXd Section::root(std::size_t load, const MatrixXd& u) const {
  const PlaneTooth& tooth = mesh_.teeth.at(loads_[load].tooth);
  std::map<int, int> row;
  for (std::size_t i = 0; i < tooth.root_nodes; ++i)
    row.emplace(tooth.node[i], static_cast<int>(i));
  MatrixXd stress = MatrixXd::Zero(3 * static_cast<Eigen::Index>(row.size()), u.cols());
  std::vector<int> count(row.size());
  for (const auto& t : mesh_.triangles) {
    MatrixXd of(12, u.cols());
    for (int n = 0; n < 6; ++n) of.middleRows<2>(2 * n) = u.middleRows<2>(2 * t[n]);
    for (int n = 0; n < 6; ++n) {
      const auto found = row.find(t[n]);
      if (found == row.end()) continue;
      double area = 0.0;
      stress.middleRows<3>(3 * found->second) +=
          law() * strains(t, kCorners[n][0], kCorners[n][1], area) * of;
      ++count[found->second];
    }
  }
  for (std::size_t i = 0; i < count.size(); ++i)
    stress.middleRows<3>(3 * static_cast<Eigen::Index>(i)) /= count[i];
  return stress;
}

PlaneAnswer Section::solve() const {
  // A quadrature rule of degree four on a triangle.
  constexpr double kA = 0.445948490915965, kB = 0.091576213509771;
  constexpr double kWeightA = 0.223381589678011 / 2, kWeightB = 0.109951743655322 / 2;
  const std::array<std::array<double, 3>, 6> rule{{{kA, kA, kWeightA},
                                                   {1 - 2 * kA, kA, kWeightA},
                                                   {kA, 1 - 2 * kA, kWeightA},
                                                   {kB, kB, kWeightB},
                                                   {1 - 2 * kB, kB, kWeightB},
                                                   {kB, 1 - 2 * kB, kWeightB}}};
  std::vector<int> dof(2 * mesh_.nodes.size(), 0);
  for (const int n : mesh_.held) dof[2 * n] = dof[2 * n + 1] = -1;
  int free = 0;
  for (int& d : dof)
    if (d == 0) d = free++;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(144 * mesh_.triangles.size());
  for (const auto& t : mesh_.triangles) {
    Eigen::Matrix<double, 12, 12> k = Eigen::Matrix<double, 12, 12>::Zero();
    for (const auto& [a, b, weight] : rule) {
      double area = 0.0;
      const auto e = strains(t, a, b, area);
      if (!(area > 0.0)) throw std::runtime_error("a triangle folds");
      k += weight * area * e.transpose() * law() * e;
    }
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j < 12; ++j) {
        const int p = dof[2 * t[i / 2] + i % 2];
        const int q = dof[2 * t[j / 2] + j % 2];
        if (p >= 0 && q >= 0) entries.emplace_back(p, q, k(i, j));
      }
  }
  Eigen::SparseMatrix<double> stiffness(free, free);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(stiffness);
  const auto n = static_cast<Eigen::Index>(loads_.size());
  MatrixXd u = MatrixXd::Zero(static_cast<Eigen::Index>(dof.size()), n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const VectorXd f = force(static_cast<std::size_t>(j));
    VectorXd some(free);
    for (std::size_t i = 0; i < dof.size(); ++i)
      if (dof[i] >= 0) some[dof[i]] = f[static_cast<Eigen::Index>(i)];
    const VectorXd x = solver.solve(some);
    for (std::size_t i = 0; i < dof.size(); ++i)
      if (dof[i] >= 0) u(static_cast<Eigen::Index>(i), j) = x[dof[i]];
  }
  PlaneAnswer answer;
  answer.unknowns = free;
  answer.yield.resize(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    answer.yield.row(i) = reading(static_cast<std::size_t>(i)).transpose() * u;
    answer.root.push_back(root(static_cast<std::size_t>(i), u));
  }
  return answer;
}

}  // namespace

double PlaneAnswer::root_stress(std::size_t i, const VectorXd& forces) const {
  const VectorXd s = root[i] * forces;
  double most = 0.0;
  for (Eigen::Index k = 0; k < s.size(); k += 3)
    most = std::max(most, 0.5 * (s[k] + s[k + 1]) + std::hypot(0.5 * (s[k] - s[k + 1]), s[k + 2]));
  return most;
}

PlaneAnswer plane_teeth(const PlaneGear& gear, const std::vector<PlaneLoad>& loads,
                        double fineness) {
  return Section(gear, loads, fineness).solve();
}

}  // namespace gearwright::oracle
