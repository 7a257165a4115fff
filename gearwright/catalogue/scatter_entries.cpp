// The quantities of one pair of a family: names, units and meanings, in the order of
// ScatterQuantity.
#include "gearwright/base/angle.hpp"
#include "gearwright/catalogue/scatter_quantities.hpp"

namespace gearwright {

const std::array<ScatterEntry, kScatterQuantities>& scatter_entries() {
  using Q = ScatterQuantity;
  static const std::array<ScatterEntry, kScatterQuantities> entries{{
      {{"peak_to_peak_arcsec", "transmission error, peak to peak", Unit::arcsec, 4,
        "transmission error, peak to peak of the continuous curve [T14.11]"},
       Q::peak_to_peak},
      {{"harmonic1_arcsec", "transmission error, 1st harmonic", Unit::arcsec, 4,
        "first harmonic of the transmission error, as in `contact`"},
       Q::harmonic1},
      {{"harmonic2_arcsec", "transmission error, 2nd harmonic", Unit::arcsec, 4,
        "second harmonic of the transmission error"},
       Q::harmonic2},
      {{"harmonic3_arcsec", "transmission error, 3rd harmonic", Unit::arcsec, 4,
        "third harmonic of the transmission error"},
       Q::harmonic3},
      {{"mean_arcsec", "transmission error, mean", Unit::arcsec, 2,
        "mean transmission error; the mean includes the play and does not affect noise"},
       Q::mean},
      {{"contact_along_face", "contact along the face", Unit::none, 4,
        "mean position of the contact along the face, −1 to 1 [T8.24]"},
       Q::along_face},
      {{"contact_along_profile", "contact along the profile", Unit::none, 4,
        "mean position of the contact along the profile [T8.24]; null for involute pairs"},
       Q::along_profile},
      {{"edge_share", "positions with an edge in contact", Unit::none, 4,
        "share of the positions within one pitch at which an edge touches, 0 to 1"},
       Q::edge_share},
      {{"least_play_deg", "least play of gear 2", Unit::deg, 5,
        "least play of gear 2 from contact on one flank to contact on the other flank; < 0 if the "
        "gears jam"},
       Q::least_play},
      {{"long_period_arcsec", "transmission error until the same teeth mesh again", Unit::arcsec, 3,
        "transmission error over all pairs of teeth, peak to peak over the positions [T14.22]; "
        "null for double-helical gears and without accuracy grades"},
       Q::long_period},
      {{"tip_clearance1_mm", "tip clearance of gear 1", Unit::mm, 4,
        "clearance between the tip of gear 1 and the root of gear 2, as in `pair`; null on crossed "
        "axes, for circular-arc teeth, or if the tooth thickness varies and no closed form exists "
        "[T14.31]"},
       Q::tip_clearance1},
      {{"tip_clearance2_mm", "tip clearance of gear 2", Unit::mm, 4,
        "clearance between the tip of gear 2 and the root of gear 1, as in `pair` [T14.31]"},
       Q::tip_clearance2},
      {{"form_clearance1_mm", "form clearance of gear 1", Unit::mm, 4,
        "radial distance from the start of the usable flank of gear 1 to the start of contact, as "
        "in `pair` [T14.31]; < 0 if the tip of gear 2 reaches below the usable flank"},
       Q::form_clearance1},
      {{"form_clearance2_mm", "form clearance of gear 2", Unit::mm, 4,
        "radial distance from the start of the usable flank of gear 2 to the start of contact, as "
        "in `pair` [T14.31]"},
       Q::form_clearance2},
  }};
  return entries;
}

double SpreadEntry::shown(double value) const {
  const Angle angle = Angle::radians(value);
  return unit == Unit::arcsec ? angle.arcsec() : unit == Unit::deg ? angle.deg() : value;
}

}  // namespace gearwright
