// Amplitudes along the face, compared with one dense system of the same finite elements, which has
// other shape functions (monomials) and eliminates nothing.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <random>

#include "gearwright/compliance/face_reading.hpp"

namespace gearwright::detail {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kWidth = 5.0;
constexpr int kElements = 4, kModes = 3, kLoads = 2;

MatrixXd random_matrix(Index rows, Index columns, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  return MatrixXd::NullaryExpr(rows, columns, [&] { return any(random); });
}

// The energy of f and f′ is positive definite.
ModeMatrices modes() {
  const MatrixXd m = random_matrix(2 * kModes, 2 * kModes, 1);
  const MatrixXd energy = m.transpose() * m + MatrixXd::Identity(2 * kModes, 2 * kModes);
  return {energy.topLeftCorner(kModes, kModes), energy.topRightCorner(kModes, kModes),
          energy.bottomRightCorner(kModes, kModes)};
}

// Each element has the polynomial Σ c_k x^k, k = 0 … 3, with x from 0 to 1 and c ∈ R^modes. At the
// borders, the polynomials are equal, which multipliers enforce.
class Dense {
 public:
  Dense() {
    const auto [aa, ab, bb] = modes();
    MatrixXd all = MatrixXd::Zero(kAll + kBorders, kAll + kBorders);
    for (int e = 0; e < kElements; ++e)
      for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b) {
          const auto integral = [&](auto f) {
            return boost::math::quadrature::gauss<double, 7>::integrate(f, 0.0, 1.0);
          };
          const auto s = [](int k, double x) { return k == 0 ? 0.0 : k * std::pow(x, k - 1); };
          const auto v = [](int k, double x) { return std::pow(x, k); };
          const double m00 = kLength * integral([&](double x) { return v(a, x) * v(b, x); });
          const double m01 = integral([&](double x) { return v(a, x) * s(b, x); });
          const double m10 = integral([&](double x) { return s(a, x) * v(b, x); });
          const double m11 = integral([&](double x) { return s(a, x) * s(b, x); }) / kLength;
          all.block(row(e, a), row(e, b), kModes, kModes) =
              m00 * aa + m01 * ab + m10 * ab.transpose() + m11 * bb;
        }
    for (int e = 0; e + 1 < kElements; ++e)
      for (int i = 0; i < kModes; ++i) {
        const Index border = kAll + e * kModes + i;
        for (int k = 0; k < 4; ++k) all(border, row(e, k) + i) = 1.0;
        all(border, row(e + 1, 0) + i) = -1.0;
      }
    all.topRightCorner(kAll, kBorders) = all.bottomLeftCorner(kBorders, kAll).transpose();
    all_ = all;
  }
  // The coefficients under a load that is distributed evenly over [lo, hi] and has the sum 1.
  VectorXd solve(const VectorXd& load, double lo, double hi) const {
    VectorXd f = VectorXd::Zero(kAll + kBorders);
    for (int e = 0; e < kElements; ++e)
      for (int k = 0; k < 4; ++k) f.segment(row(e, k), kModes) = mean_power(e, k, lo, hi) * load;
    return all_.fullPivLu().solve(f);
  }
  static VectorXd value(const VectorXd& c, double z) {
    VectorXd f = VectorXd::Zero(kModes);
    for (int k = 0; k < 4; ++k) f += std::pow(place(z), k) * c.segment(row(element(z), k), kModes);
    return f;
  }
  static VectorXd slope(const VectorXd& c, double z) {
    VectorXd f = VectorXd::Zero(kModes);
    for (int k = 1; k < 4; ++k)
      f += k * std::pow(place(z), k - 1) / kLength * c.segment(row(element(z), k), kModes);
    return f;
  }
  static VectorXd mean(const VectorXd& c, double lo, double hi) {
    VectorXd f = VectorXd::Zero(kModes);
    for (int e = 0; e < kElements; ++e)
      for (int k = 0; k < 4; ++k) f += mean_power(e, k, lo, hi) * c.segment(row(e, k), kModes);
    return f;
  }

 private:
  static constexpr double kLength = kWidth / kElements;
  static constexpr Index kAll = 4 * kElements * kModes, kBorders = (kElements - 1) * kModes;
  static Index row(int e, int k) { return (4 * e + k) * kModes; }
  static int element(double z) {
    return std::clamp(static_cast<int>((z + kWidth / 2) / kLength), 0, kElements - 1);
  }
  static double place(double z) { return (z + kWidth / 2) / kLength - element(z); }
  // ∫ x^k dz/(hi − lo) over the part of [lo, hi] in element e.
  static double mean_power(int e, int k, double lo, double hi) {
    const auto x = [&](double z) { return std::clamp((z + kWidth / 2) / kLength - e, 0.0, 1.0); };
    return kLength / (hi - lo) * (std::pow(x(hi), k + 1) - std::pow(x(lo), k + 1)) / (k + 1);
  }
  MatrixXd all_;
};

struct Part {
  double lo, hi;
};
// In one element, over the whole face, over one border, over several elements, a whole element.
constexpr std::array kParts{Part{-2.4, -1.7}, Part{-2.5, 2.5}, Part{-1.5, -0.9}, Part{-1.0, 2.0},
                            Part{0.0, 1.25}};

struct Solved {
  Face face{modes(), kWidth, kWidth / kElements};
  MatrixXd forces = random_matrix(kModes, kLoads, 2);
  MatrixXd v = random_matrix(2, kModes, 3), s = random_matrix(2, kModes, 4);
  Face::Loads loads = face.loads(forces);
  MatrixXd along{face.node_count(), kParts.size()}, ends;
  Solved() {
    for (std::size_t j = 0; j < kParts.size(); ++j)
      along.col(static_cast<Index>(j)) = face.mean(kParts[j].lo, kParts[j].hi);
    ends.resize((face.element_count() + 1) * kModes, kLoads * along.cols());
    for (int i = 0; i < kLoads; ++i)
      ends.middleCols(i * along.cols(), along.cols()) = face.solve(loads, i, along);
  }
  Part part(Index j) const { return kParts[static_cast<std::size_t>(j)]; }
};

TEST(Face, AgreesWithADenseSystem) {
  const Solved x;
  const Dense dense;
  const FaceReading reading(x.face, x.loads, x.v, x.s);
  // In elements, at a border, and at both ends of the face.
  for (const double z : {-2.5, -2.1, -1.25, -1.0, 0.3, 1.25, 2.0, 2.5}) {
    const MatrixXd read = reading.at(x.face.at(z), x.face.slope_at(z), x.along, x.ends);
    for (int i = 0; i < kLoads; ++i)
      for (Index j = 0; j < x.along.cols(); ++j) {
        const VectorXd c = dense.solve(x.forces.col(i), x.part(j).lo, x.part(j).hi);
        const VectorXd wanted = x.v * Dense::value(c, z) + x.s * Dense::slope(c, z);
        EXPECT_LT((read.col(i * x.along.cols() + j) - wanted).norm(), 1e-12)
            << "z " << z << ", load " << i << ", part " << j;
      }
  }
}

TEST(Face, MeansAgreeWithADenseSystemAndAreReciprocal) {
  const Solved x;
  const Dense dense;
  const FaceReading reading(x.face, x.loads, x.forces.transpose());
  const Index columns = x.along.cols();
  for (Index l = 0; l < columns; ++l) {
    const MatrixXd read = reading.at(x.along.col(l), {}, x.along, x.ends);
    for (int i = 0; i < kLoads; ++i)
      for (Index j = 0; j < columns; ++j) {
        const VectorXd c = dense.solve(x.forces.col(i), x.part(j).lo, x.part(j).hi);
        const VectorXd wanted = x.forces.transpose() * Dense::mean(c, x.part(l).lo, x.part(l).hi);
        EXPECT_LT((read.col(i * columns + j) - wanted).norm(), 1e-12);
        const MatrixXd back = reading.at(x.along.col(j), {}, x.along, x.ends);
        for (int k = 0; k < kLoads; ++k)
          EXPECT_NEAR(read(k, i * columns + j), back(i, k * columns + l), 1e-13);
      }
  }
}

}  // namespace
}  // namespace gearwright::detail
