#include "tests/oracle/plane_pair.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace gearwright::oracle {

PlaneShare plane_share(const PlanePair& pair, double rho, double load, double fineness) {
  constexpr double kWidth = 0.05;  // modules, width of the strips through which plane_teeth applies
                                   // loads
  constexpr int kSteps = 30;
  const double pi = std::numbers::pi;
  const double pitch = 2 * pi * pair.base_1 / pair.one.teeth;
  const double soft = 1 / pair.modulus[0] + 1 / pair.modulus[1];
  const double plane = (1 - pair.one.poisson * pair.one.poisson) * soft;
  std::array<std::vector<PlaneLoad>, 2> loads;
  std::vector<double> radius;  // radii of relative curvature
  // Gear 1 drives with its side y > 0 and turns counter-clockwise. A tooth that entered contact
  // earlier is therefore ahead. Gear 2 is driven on the same side and turns clockwise.
  for (int k = 0; rho + k * pitch <= pair.last; ++k) {
    const double rho_1 = rho + k * pitch;
    const double rho_2 = pair.two.ring ? pair.line + rho_1 : pair.line - rho_1;
    loads[0].push_back({k, std::hypot(pair.base_1, rho_1), kWidth});
    loads[1].push_back({-k, std::hypot(pair.base_2, rho_2), kWidth});
    radius.push_back(1 / (1 / rho_1 + (pair.two.ring ? -1 : 1) / rho_2));
  }
  const PlaneAnswer one = plane_teeth(pair.one, loads[0], fineness);
  const PlaneAnswer two = plane_teeth(pair.two, loads[1], fineness);
  // Newton's method on w_i = u, Σ share = 1.
  const auto n = static_cast<Eigen::Index>(radius.size());
  const Eigen::MatrixXd bulk = one.yield / pair.modulus[0] + two.yield / pair.modulus[1];
  const double local = 2 * plane / pi;
  Eigen::VectorXd x(n + 1);
  x << Eigen::VectorXd::Constant(n, 1.0 / double(n)), bulk.mean();
  for (int step = 0; step < kSteps; ++step) {
    Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(n + 1, n + 1);
    Eigen::VectorXd rest(n + 1);
    slope.topLeftCorner(n, n) = bulk;
    rest.head(n) = bulk * x.head(n) - Eigen::VectorXd::Constant(n, x[n]);
    rest[n] = x.head(n).sum() - 1;
    for (Eigen::Index i = 0; i < n; ++i) {
      const double width = std::sqrt(4 * plane / pi * x[i] * load * radius[i]);
      rest[i] += local * std::log(kWidth / width) * x[i];
      slope(i, i) += local * (std::log(kWidth / width) - 0.5);
      slope(i, n) = -1;
      slope(n, i) = 1;
    }
    x -= slope.partialPivLu().solve(rest);
  }
  PlaneShare answer;
  answer.approach = x[n];
  answer.share.assign(x.data(), x.data() + n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    answer.root[0] = std::max(answer.root[0], one.root_stress(k, x.head(n)));
    answer.root[1] = std::max(answer.root[1], two.root_stress(k, x.head(n)));
  }
  return answer;
}

}  // namespace gearwright::oracle
