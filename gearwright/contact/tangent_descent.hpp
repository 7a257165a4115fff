// Descends to a local minimum of a function that is slow to compute and has creases. Tangents
// replace the function within a trust radius.
//
//   v   corrections      f(v)   the function      m_v(w)   its model: f linearised in parts at v
//                                    theory: docs/theory/14-scatter.md, [T14.18]
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "gearwright/contact/compensation.hpp"

namespace gearwright::detail {

/// A function with a model. The model is exact at its center and quick to evaluate everywhere.
struct DescentTask {
  using Function = std::function<double(const std::vector<double>&)>;
  std::vector<Correction> box;
  double gain = 0.0;  ///< smallest gain worth another step
  Function f{};       ///< finite everywhere in the box
  std::function<Function(const std::vector<double>& center)> model_at{};
};

/// The best corrections of a descent from `start`. Each step goes to the minimum of the model
/// within a radius, which grows after a success and shrinks after a failure.
///
/// Formula   [T14.18]
/// Domain    lo ≤ start ≤ hi of the box; can_minimise() (contract)
/// Laws      f is not greater at the result than at `start`
std::vector<double> descend(const DescentTask& task, std::vector<double> start);

}  // namespace gearwright::detail
