// Life factors: how much more a material bears that is loaded less often.
//
//   N_L   load cycles           Z_NT, Y_NT   life factors of flank and root, for test conditions
//
// Straight lines in log N and log σ between a static and a reference number of cycles; beyond the
// reference the limit sinks once more, to 0.85 at 10¹⁰, unless experience allows 1.
#pragma once

#include <optional>

#include "gearwright/rating/factor.hpp"
#include "gearwright/rating/material.hpp"

namespace gearwright {

struct Life {
  Factor factor;     ///< Z_NT or Y_NT
  double reference;  ///< 0 for static stress, 1 from the reference number on, by log N between:
                     ///< the exponent with which the other factors count
};

/// What the engineer says of the far end of the lines.
struct LifeChoice {
  bool limited_pitting = false;  ///< some pitting is permitted: the flank's longer line
  double at_10_10 = 0.85;        ///< Z_NT, Y_NT at 10¹⁰ cycles, 0.85 … 1
};

/// `cycles` absent: no life is asked for, the reference number holds.
///
/// Formula   [T11.41]; ISO 6336-2, clause 10; at 10⁹ and 10¹⁰ confirmed by printed reports
/// Law       continuous and falling in N
Life flank_life(MaterialKind kind, std::optional<double> cycles, const LifeChoice& choice = {});

/// Formula   [T11.41]; ISO 6336-3, clause 12
Life root_life(MaterialKind kind, std::optional<double> cycles, const LifeChoice& choice = {});

}  // namespace gearwright
