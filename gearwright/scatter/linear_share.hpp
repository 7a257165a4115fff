// Computes, for each quantity, the part of the variance that the derivatives of the quantity at the
// nominal pair explain.
//
//   f     a quantity of a member       g_i = ∂f/∂x_i at x = 0, which is the nominal pair
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

/// The gradient g of each quantity, in the unit of the quantity per user's unit of x. A quantity
/// without a value or a derivative at the nominal pair has no gradient. If teeth near the nominal
/// pair do not exist, no quantity has a gradient. At x = 0, the members are not continuous in the
/// coordinates of waves and pitches. A quantity that varies with such a coordinate has no gradient.
/// For any other quantity, the derivative with respect to such a coordinate is 0.
///
/// `deviation` contains the standard deviation of each quantity. A kink of a quantity at x = 0
/// is ignored if it explains at most 0.5 % of the variance.
///
/// Accuracy  relative error of a central difference, about (1/64)² |f‴| w_i²/(6 |f′|)
using QuantityGradients = std::array<std::optional<std::vector<double>>, kScatterQuantities>;
QuantityGradients gradients_as_drawn(const ContactSetup& setup, const ScatterTask& task,
                                     const std::array<double, kScatterQuantities>& deviation);

/// Returns the linear share of each quantity, over the samples in which the quantity has a value.
/// Returns none if the quantity has no gradient or does not vary.
///
/// Laws      (1) a quantity that is linear in x has the share 1   (2) a quantity that is even in
///           every input and has a derivative has the share 0
std::array<std::optional<double>, kScatterQuantities> linear_shares(
    const ContactSetup& setup, const ScatterTask& task, const std::vector<ScatterSample>& samples);

}  // namespace gearwright
