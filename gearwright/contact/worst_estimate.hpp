// Combines the estimates of an aim for several scenarios. Internal to contact/.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "gearwright/base/contract.hpp"
#include "gearwright/contact/compensation.hpp"

namespace gearwright::detail {

/// Returns the estimate of the greatest of several aims. The arguments remain changes.
///
/// Domain    at least one estimate; all tangents are those of the same increasing function of their
///           aims (contract)
inline CompensationAim::Estimate worst_estimate(std::vector<CompensationAim::Estimate> all) {
  GW_EXPECTS(!all.empty());
  const auto value = [all](const std::vector<double>& change) {
    double worst = 0.0;
    for (const auto& estimate : all) worst = std::max(worst, estimate.value(change));
    return worst;
  };
  const auto tangents = [all = std::move(all)](const std::vector<double>& change) {
    std::vector<Tangents> each;
    for (const auto& estimate : all) each.push_back(estimate.tangents(change));
    const auto by_value = [](const auto& a, const auto& b) { return a.value < b.value; };
    const double worst = std::max_element(each.begin(), each.end(), by_value)->value;
    return Tangents{worst, [each = std::move(each), by_value](const Eigen::VectorXd& step) {
                      std::vector<Tangent> at;
                      for (const Tangents& t : each) at.push_back(t.greatest(step));
                      return *std::max_element(at.begin(), at.end(), by_value);
                    }};
  };
  return {value, tangents};
}

}  // namespace gearwright::detail
