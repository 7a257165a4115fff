// Computes the part of the variance of each quantity that its derivatives at the pair as drawn
// explain.
//
//   f     a quantity of a member       g_i = ∂f/∂x_i at x = 0, the pair as drawn
//   w_i   half width of the range of x_i
//   linear share = Var(g·x)/Var f      theory: docs/theory/14-scatter.md, [T14.28]
//
// Internal to scatter/.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

/// The gradient g of each quantity, in the unit of the quantity per user's unit of x. It is none if
/// the quantity has no value or no derivative at the pair as drawn. The number of waves of a flank
/// and the coordinates of pitches are not continuous about x = 0. If they change a quantity, this
/// quantity has no gradient; otherwise their derivatives are 0.
///
/// `deviation` contains the standard deviation of each quantity. A bend at x = 0 is ignored if it
/// explains at most 0.5 % of the variance.
///
/// Accuracy  relative error of about (1/64)² |f‴| w_i²/(6 |f′|), the error of a central difference
using QuantityGradients = std::array<std::optional<std::vector<double>>, kScatterQuantities>;
QuantityGradients gradients_as_drawn(const ContactSetup& setup, const ScatterTask& task,
                                     const std::array<double, kScatterQuantities>& deviation);

/// The linear share of each quantity over the samples that have a value of it. None without a
/// gradient, and if the quantity does not vary.
///
/// Laws      (1) a quantity that is linear in x has the share 1   (2) a quantity that is even in
///           every input and has a derivative has the share 0
std::array<std::optional<double>, kScatterQuantities> linear_shares(
    const ContactSetup& setup, const ScatterTask& task, const std::vector<ScatterSample>& samples);

}  // namespace gearwright
