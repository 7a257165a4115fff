// The quantities of a family of pairs under torque. A result contains them under `scatter.loaded`.
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/scatter_quantities.hpp"

namespace gearwright {

const std::array<LoadedEntry, 3>& loaded_entries() {
  using L = LoadedSpread;
  static const std::array<LoadedEntry, 3> entries{{
      {{"peak_to_peak_arcsec", "transmission error, peak to peak", Unit::arcsec, 4,
        "loaded transmission error, peak to peak over the positions, as in `load`"},
       &L::peak_to_peak},
      {{"max_pressure_MPa", "greatest pressure", Unit::megapascal, 1,
        "greatest pressure of the flanks over the positions"},
       &L::max_pressure},
      {{"face_load_factor", "face load factor", Unit::none, 3,
        "maximum load along the face divided by the mean load; null for point contact"},
       &L::face_load_factor},
  }};
  return entries;
}

const Quantities<LoadedSpreadView>& loaded_spread_quantities() {
  using V = LoadedSpreadView;
  return define("scatter.loaded", [](Quantities<V>& q) {
    q.term("torque_Nm", "on gear 1", [](const V& v) { return newton_metres(v.loaded->torque); });
    for (std::size_t i = 0; i < loaded_entries().size(); ++i) {
      const LoadedEntry& entry = loaded_entries()[i];
      q.record<spread_quantities>(
          entry.key, entry.meaning, [i](const V& v) -> const auto& { return v.spread[i]; });
    }
    q.record<probability_quantities>(
        "edge_carries", "samples in which an edge of a tooth carries load at some position",
        [](const V& v) -> const auto& { return v.loaded->edge_carries; });
    q.record<probability_quantities>(
        "unsolved",
        "samples with a position at which no teeth touch or the forces do not converge; these "
        "samples are not in the distributions",
        [](const V& v) -> const auto& { return v.loaded->unsolved; });
  });
}

}  // namespace gearwright
