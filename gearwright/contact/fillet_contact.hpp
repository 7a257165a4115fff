// Contact of tips with root fillets, under errors of mounting and cutting.
//
// If a tip meets the fillet of the mating gear before the flanks touch, the flanks alone give a
// wrong transmission error TE. The search [T8.2] is therefore repeated with the fillets as
// additional patches. It gives TE_f. The difference gives the gap between the flanks:
//
//   early = |TE_f − TE| h   mm, where h is the lever arm of the contact normal about axis 2, mm
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "gearwright/contact/contact.hpp"

namespace gearwright {

struct FilletContact {
  int gear;            ///< 1 or 2, the gear of the fillet
  double early;        ///< mm, normal gap between the flanks when the tip touches the fillet
  ContactPoint point;  ///< where the tip touches the fillet; point.te is TE_f
};

struct FilletContacts {
  std::vector<std::size_t> asked;   ///< examined positions, as indices of `flanks`
  std::vector<ContactPoint> whole;  ///< contact of the whole outlines at these positions
  /// The contact with the greatest `early`; none if the flanks touch first at all positions.
  std::optional<FilletContact> earliest;
};

/// Computes the contact of the whole outlines at the rotations at which the flanks touch. `flanks`
/// are the positions of analyse_contact() for the flanks alone.
///
/// `outlines`  the pair to which `flanks` belongs, but with ContactMount::fillets = true
/// Accuracy    rounding at each examined rotation. At most 64 rotations at equal steps are
///             examined, so a contact with a greater `early` between these rotations may be missed
FilletContacts fillet_contacts(const ContactPair& outlines, std::span<const ContactPoint> flanks,
                               Progress* progress = nullptr);

}  // namespace gearwright
