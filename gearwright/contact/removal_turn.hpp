// The effect of material removed from a flank on the gap field T (gap_field.hpp), in the frame N of
// contact_pair.hpp.
//                                    theory: docs/theory/08-contact.md, [T8.7], [T8.10]
#pragma once

#include "gearwright/contact/contact_pair.hpp"

namespace gearwright {

struct RemovalTurn {
  double te;                    ///< ∂T*  rad in N, per mm removed
  double u, z;                  ///< the point, as arguments of the gear's RemovalField
  RemovalField::Piece piece{};  ///< piece of the patch; empty without a field
};

/// The effect of material removed from `gear` on T*, the greatest T over the profile at a fixed
/// height z of flank 1. T* lies at the parameter s.
///
/// Units     rad, mm
/// Domain    gear 1 or 2; patches of this pair (contract)
/// Accuracy  rounding
/// Laws      `te`, multiplied by the removal per unit of a modification, is equal to row_slope()
///           for this modification
RemovalTurn row_turn(const ContactPair& pair, const GapField& field, double s, double z, int gear);

}  // namespace gearwright
