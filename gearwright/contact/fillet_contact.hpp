// Tips in root fillets under errors of mounting and cutting.
//
// If a tip meets the mating gear's fillet first, the flanks alone give a transmission error TE that
// the teeth cannot have. With the fillets as additional patches the same search [T8.2] gives TE_f ≥
// TE. The difference is the distance by which the fillet keeps gear 2 off the flanks:
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
  std::vector<std::size_t> asked;         ///< examined positions of the flanks
  std::vector<ContactPoint> whole;        ///< the whole outlines at those positions
  std::optional<FilletContact> earliest;  ///< earliest contact before the flanks; none if the
                                          ///< flanks touch first
};

/// Contact of the whole outlines at those rotations of `flanks` (positions of analyse_contact) that
/// touch.
///
/// `outlines`  the same pair with ContactMount::fillets
/// Accuracy    rounding at each examined rotation. At most 64 rotations, evenly chosen, are
///             examined, and earlier touches between them may be missed
FilletContacts fillet_contacts(const ContactPair& outlines, std::span<const ContactPoint> flanks,
                               Progress* progress = nullptr);

}  // namespace gearwright
