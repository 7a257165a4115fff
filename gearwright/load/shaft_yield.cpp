#include "gearwright/load/shaft_yield.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gearwright/base/contract.hpp"
#include "gearwright/math/involute.hpp"

namespace gearwright {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

FaceDeflection face_deflection(const VectorXd& approach) {
  const Index n = approach.size();
  GW_EXPECTS(n >= 3);
  // The middles of the slices are symmetric about x = 0, so the linear part of the fit does
  // not depend on the constant and parabolic parts.
  const VectorXd x = (VectorXd::LinSpaced(n, 0.5, double(n) - 0.5) / double(n)).array() - 0.5;
  VectorXd bow = 1 - 4 * x.array().square();
  bow.array() -= bow.mean();
  return {approach.dot(x) / x.squaredNorm(), approach.dot(bow) / bow.squaredNorm()};
}

ShaftYield::ShaftYield(const ContactPair& pair, const Gear& one, const Gear& two,
                       const PairCompliance& compliance, const LoadRequest& request)
    : reversed_(pair.turned() < 0.0), slices_(compliance.slices[0]) {
  const double signed_sin =
      std::sin(one.spec.helix_angle.rad()) * std::cos(one.spec.normal_pressure_angle.rad());
  sin_b_ = std::abs(signed_sin);
  cos_b_ = std::sqrt(1 - sin_b_ * sin_b_);
  const ContactMount& place = pair.place();
  const double cos_w = (two.base_radius() + two.side() * one.base_radius()) /
                       (place.center_distance + place.errors.center_distance);
  const double tan_w = std::sqrt(std::max(0.0, 1 / (cos_w * cos_w) - 1));
  // `sign` is s_i of gear 1. Gear 1 turns clockwise seen from +z, so it pushes gear 2 towards −y if
  // it drives. The teeth of gear 2 have the opposite hand at the mesh, so its s_i is −sign.
  const double sign = (pair.gear2_drives() ? 1.0 : -1.0) * (signed_sin < 0.0 ? -1.0 : 1.0);
  std::array<std::vector<double>, 2> rho;
  for (std::size_t g = 0; g < 2; ++g) {
    OfGear& of = shafts_[g];
    if (request.shafts[g]) of.influence = &compliance.shafts[g].value();
    of.base_radius = (g == 0 ? one : two).base_radius();
    of.sign = g == 0 ? sign : -sign;
    rho[g].assign(static_cast<std::size_t>(slices_.count), of.base_radius * tan_w);
  }
  std::vector<int> slices(static_cast<std::size_t>(slices_.count));
  std::iota(slices.begin(), slices.end(), 0);
  if (any()) at_pitch_point_ = yield(slices, rho);
}

MatrixXd ShaftYield::yield(const std::vector<int>& slices,
                           const std::array<std::vector<double>, 2>& rho) const {
  const auto n = static_cast<Index>(slices.size());
  MatrixXd sum = MatrixXd::Zero(n, n);
  for (std::size_t g = 0; g < 2; ++g) {
    if (!shafts_[g].influence) continue;
    const ShaftInfluence& of = *shafts_[g].influence;
    const double r_b = shafts_[g].base_radius;
    const double mixed = shafts_[g].sign * sin_b_ * cos_b_;
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j < n; ++j) {
        const int a = slices[static_cast<std::size_t>(i)];
        const int b = slices[static_cast<std::size_t>(j)];
        const double rho_i = rho[g][static_cast<std::size_t>(i)];
        const double rho_j = rho[g][static_cast<std::size_t>(j)];
        sum(i, j) += cos_b_ * cos_b_ * (of.force(a, b) + r_b * r_b * of.twist(a, b)) +
                     mixed * (rho_j * of.moment(a, b) + rho_i * of.moment(b, a)) +
                     sin_b_ * sin_b_ * (rho_i * rho_j + r_b * r_b) * of.turn(a, b);
      }
  }
  return sum;
}

MatrixXd ShaftYield::between(const std::vector<Place>& places) const {
  std::vector<int> slices;
  std::array<std::vector<double>, 2> rho;
  for (const Place& p : places) {
    slices.push_back(reversed_ ? slices_.count - 1 - p.slice : p.slice);
    for (std::size_t g = 0; g < 2; ++g) {
      const double r_b = shafts_[g].base_radius;
      rho[g].push_back(roll_length(p.radius[g], r_b));
    }
  }
  return yield(slices, rho);
}

FaceDeflection ShaftYield::under(const VectorXd& line_load) const {
  return any() ? face_deflection(-slices_.width() / cos_b_ * (at_pitch_point_ * line_load))
               : FaceDeflection();
}

}  // namespace gearwright
