#include "gearwright/design/train_strength.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/math/decompositions.hpp"

namespace gearwright {

namespace {

// The variables of the fit, and ln κ.
struct StageShape {
  double log_teeth, log_ratio, log_load, log_intensity;
};

std::vector<StageShape> shapes_of(const DriveCandidate& candidate) {
  std::vector<StageShape> shapes;
  double log_torque = 0.0;
  for (std::size_t k = 0; k < candidate.stages.size(); ++k) {
    const auto& [z1, z2] = candidate.stages[k];
    const double log_width =
        candidate.face_widths.empty() ? 0.0 : std::log(candidate.face_widths[k]);
    const double log_z = std::log(z1), u = static_cast<double>(z2) / z1;
    const double log_u = std::log(u);
    const double log_w = log_torque - log_width - log_z;
    shapes.push_back({log_z, log_u, log_w, log_w + std::log1p(1.0 / u) - log_z});
    log_torque += log_u;
  }
  return shapes;
}

}  // namespace

TrainStrength::TrainStrength(const std::vector<RatedTrain>& rated) {
  std::size_t longest = 0;
  for (const RatedTrain& train : rated) {
    GW_EXPECTS(train.stages.size() == train.candidate.stages.size());
    longest = std::max(longest, train.stages.size());
  }
  std::vector<StageFit> fits;
  for (std::size_t k = 0; k < longest; ++k) {
    std::vector<StageShape> shapes;
    std::vector<Safeties> safeties;
    for (const RatedTrain& train : rated) {
      if (train.stages.size() <= k) continue;
      shapes.push_back(shapes_of(train.candidate)[k]);
      safeties.push_back(train.stages[k]);
    }
    if (shapes.size() < kLeastRatedTrains) return;
    const auto rows = static_cast<Eigen::Index>(shapes.size());
    Eigen::MatrixXd terms(rows, 4), logs(rows, 2);
    for (Eigen::Index i = 0; i < rows; ++i) {
      const StageShape& shape = shapes[static_cast<std::size_t>(i)];
      const Safeties& safety = safeties[static_cast<std::size_t>(i)];
      terms.row(i) << 1.0, shape.log_teeth, shape.log_ratio, shape.log_load;
      logs.row(i) << std::log(safety.flank) + shape.log_intensity / 2,
          std::log(safety.root) + shape.log_load;
    }
    const auto bound = [&](Eigen::Index column, double margin) {
      // The columns of `terms` may be linearly dependent. For example, if only one z_1 is tried,
      // its logarithm is always the same. least_squares() then returns the solution of least norm.
      const Eigen::VectorXd fit = least_squares(terms, logs.col(column));
      const double above = (logs.col(column) - terms * fit).maxCoeff();
      return Fit{fit[0], fit[1], fit[2], fit[3], above + margin};
    };
    fits.push_back({bound(0, kFlankMargin), bound(1, kRootMargin)});
  }
  stages_ = std::move(fits);
}

bool TrainStrength::may_hold(const DriveCandidate& candidate, std::size_t stage,
                             const Safeties& required) const {
  if (!estimates(candidate.stages.size())) return true;
  const StageShape s = shapes_of(candidate)[stage];
  const auto log_of = [&](const Fit& fit) {
    return fit.without_load(s.log_teeth, s.log_ratio) + fit.above + fit.per_load * s.log_load;
  };
  const StageFit& fit = stages_[stage];
  return log_of(fit.flank) - s.log_intensity / 2 >= std::log(required.flank) &&
         log_of(fit.root) - s.log_load >= std::log(required.root);
}

double TrainStrength::least_width(const DriveCandidate& candidate, std::size_t stage,
                                  const Safeties& required) const {
  GW_EXPECTS(estimates(candidate.stages.size()));
  DriveCandidate unit = candidate;
  unit.face_widths.assign(candidate.stages.size(), 1.0);
  const StageShape s = shapes_of(unit)[stage];
  const StageFit& fit = stages_[stage];
  // ln κ differs from ln w by a term that does not depend on the width.
  const double intensity = s.log_intensity - s.log_load;
  const auto log_width = [&](const Fit& own, double power, double rest, double safety) {
    const double slope = power - own.per_load;  // decrease of ln S for each unit of ln w
    if (!(slope > 0.0)) return -kInfinity;
    return s.log_load -
           (own.without_load(s.log_teeth, s.log_ratio) - rest - std::log(safety)) / slope;
  };
  return std::exp(std::max(log_width(fit.flank, 0.5, intensity / 2, required.flank),
                           log_width(fit.root, 1.0, 0.0, required.root)));
}

bool TrainStrength::is_hopeless(const DriveCandidate& candidate, const Safeties& required) const {
  for (std::size_t k = 0; k < candidate.stages.size(); ++k)
    if (!may_hold(candidate, k, required)) return true;
  return false;
}

}  // namespace gearwright
