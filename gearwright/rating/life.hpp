// Life factors: the increase of strength for fewer load cycles.
//
//   N_L   load cycles           Z_NT, Y_NT   life factors of flank and root, for test conditions
//
// Between the number of cycles for static stress and the reference number, the factors are straight
// lines in log N and log σ. Beyond the reference number, they decrease to 0.85 at 10¹⁰ cycles,
// unless experience permits a factor of 1.
#pragma once

#include <optional>

#include "gearwright/rating/factor.hpp"
#include "gearwright/rating/material.hpp"

namespace gearwright {

struct Life {
  Factor factor;     ///< Z_NT or Y_NT
  double reference;  ///< exponent of the other factors: 0 at static stress, 1 above the reference
                     ///< number of cycles, and linear in log N between them
};

/// The user's choices for long lives.
struct LifeChoice {
  bool limited_pitting = false;  ///< true if some pitting is permitted (longer line of Z_NT)
  double at_10_10 = 0.85;        ///< Z_NT, Y_NT at 10¹⁰ cycles, 0.85 … 1
};

/// The life of the flank. By default, `cycles` is the reference number.
///
/// Formula   [T11.41]; ISO 6336-2, clause 10; confirmed at 10⁹ and 10¹⁰ by printed reports
/// Law       the factor is continuous and does not increase with N
Life flank_life(MaterialKind kind, std::optional<double> cycles, const LifeChoice& choice = {});

/// The life of the root. By default, `cycles` is the reference number.
///
/// Formula   [T11.41]; ISO 6336-3, clause 12
Life root_life(MaterialKind kind, std::optional<double> cycles, const LifeChoice& choice = {});

}  // namespace gearwright
