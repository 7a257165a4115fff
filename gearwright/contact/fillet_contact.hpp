// Tips in root fillets under errors of mounting and cutting.
//
// The flanks alone say a transmission error TE that the teeth cannot have where a tip meets the
// mating gear's fillet first. With the fillets as patches beside the flanks the same search [T8.2]
// gives TE_f ≥ TE; what lies between is how far the fillet holds gear 2 off the flanks:
//
//   early = (TE_f − TE) h,   h the arm of the touch's normal about axis 2, mm
#pragma once

#include <optional>
#include <span>

#include "gearwright/contact/contact.hpp"

namespace gearwright {

struct FilletContact {
  int gear;            ///< 1 or 2, whose fillet
  double early;        ///< mm along the normal, before the flanks would touch
  ContactPoint point;  ///< of the tip in the fillet, its TE that of the whole outlines
};

/// The touch of a fillet that comes earliest before the flanks, over the rotations of `flanks`
/// (positions of analyse_contact); none: flanks touch first everywhere.
///
/// `outlines`  the same pair with ContactMount::fillets
/// Accuracy    of a rotation that is looked at: rounding. At most 64 are, evenly chosen; deeper
///             touches between them may be missed
std::optional<FilletContact> fillet_contact(const ContactPair& outlines,
                                            const std::array<double, 2>& form_diameter,
                                            std::span<const ContactPoint> flanks,
                                            Headway* headway = nullptr);

}  // namespace gearwright
