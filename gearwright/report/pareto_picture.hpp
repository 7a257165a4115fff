// The designs of a search by what they were ranked by: a dot each.
//
//   front   the designs that no other betters in every objective, joined as a staircase
#pragma once

#include <array>
#include <string>
#include <vector>

#include "gearwright/base/vector.hpp"
#include "gearwright/design/search.hpp"

namespace gearwright {

inline constexpr std::size_t kMaxDots = 2000;  ///< of one picture: more are no longer told apart

/// The corners of the staircase through the points that none of them betters in both values: the
/// border between what was found and what nobody reached. `greater` says for each axis whether more
/// is better.
///
/// Laws   (1) no given point lies beyond it   (2) along it one value gets worse as the other gets
///        better
std::vector<Vec2> staircase(const std::vector<Vec2>& points, const std::array<bool, 2>& greater);

/// By the first two objectives; one alone over the centre distance, over the ratio where the
/// distance is given. The first kMaxDots designs and the whole front. Each dot tells its design
/// where the pointer rests on it. Empty without designs.
std::string pareto_figure(const SearchProblem& problem, const SearchAnswer& answer);

}  // namespace gearwright
