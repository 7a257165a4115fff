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
#include <vector>

#include "gearwright/contact/contact.hpp"

namespace gearwright {

struct FilletContact {
  int gear;            ///< 1 or 2, whose fillet
  double early;        ///< mm along the normal, before the flanks would touch
  ContactPoint point;  ///< of the tip in the fillet, its TE that of the whole outlines
};

struct FilletContacts {
  std::vector<std::size_t> asked;         ///< of the flanks' positions
  std::vector<ContactPoint> whole;        ///< there, of the whole outlines
  std::optional<FilletContact> earliest;  ///< before the flanks; none: flanks touch first
};

/// The whole outlines at the rotations of `flanks` (positions of analyse_contact) that touch.
///
/// `outlines`  the same pair with ContactMount::fillets
/// Accuracy    of a rotation that is looked at: rounding. At most 64 are, evenly chosen; deeper
///             touches between them may be missed
FilletContacts fillet_contacts(const ContactPair& outlines, std::span<const ContactPoint> flanks,
                               Progress* progress = nullptr);

}  // namespace gearwright
