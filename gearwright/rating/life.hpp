// Life factors: the increase of strength for fewer load cycles.
//
//   N_L   load cycles           Z_NT, Y_NT   life factors of flank and root, for test conditions
//
// The factors are straight lines in log N and log σ between a static and a reference number of
// cycles. Beyond the reference number the limit decreases further, to 0.85 at 10¹⁰, unless
// experience permits 1.
#pragma once

#include <optional>

#include "gearwright/rating/factor.hpp"
#include "gearwright/rating/material.hpp"

namespace gearwright {

struct Life {
  Factor factor;     ///< Z_NT or Y_NT
  double reference;  ///< exponent of the other factors: 0 at static stress, 1 from the reference
                     ///< number on, linear in log N between
};

/// The user's choices for long lives.
struct LifeChoice {
  bool limited_pitting = false;  ///< true if some pitting is permitted (longer line of Z_NT)
  double at_10_10 = 0.85;        ///< Z_NT, Y_NT at 10¹⁰ cycles, 0.85 … 1
};

/// If `cycles` is absent, the reference number applies.
///
/// Formula   [T11.41]; ISO 6336-2, clause 10; at 10⁹ and 10¹⁰ confirmed by printed reports
/// Law       continuous and falling in N
Life flank_life(MaterialKind kind, std::optional<double> cycles, const LifeChoice& choice = {});

/// Formula   [T11.41]; ISO 6336-3, clause 12
Life root_life(MaterialKind kind, std::optional<double> cycles, const LifeChoice& choice = {});

}  // namespace gearwright
