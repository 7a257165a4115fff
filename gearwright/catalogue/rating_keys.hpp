// The keys of [rating], [rating.mounting] and [[rating.spectrum]]: the load, life, quality and
// mounting for a strength rating, and factors given by the user.
#pragma once

#include <optional>
#include <vector>

#include "gearwright/arrange/load_input.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/rating/spectrum.hpp"

namespace gearwright {

/// [rating] as given. It does not contain the data of the gears themselves.
struct RatingTable {
  bool given = false;                     ///< true if the spec has [rating]
  RatingInput input;                      ///< inputs of [rating], with the torque that follows from
                                          ///< them; materials and gear bodies are added later
  std::optional<double> power;            ///< P    kW
  std::optional<double> torque;           ///< T_1  N m, on gear 1
  std::optional<double> output_torque;    ///< N m, on the driven gear of a pair, without losses;
                                          ///< `torque` follows from it
  std::optional<double> web_thickness;    ///< b_s  mm
  std::optional<double> rim_thickness;    ///< s_R  mm, of both gears
  std::vector<LoadBin> spectrum;          ///< [[rating.spectrum]]; it replaces the single load and
                                          ///< the life of this load
  std::optional<MaterialInput> material;  ///< for a gear without its own material
  std::optional<double> safety_flank_min, safety_root_min;  ///< required safeties
  bool tooth_contact = false;  ///< true if tooth contact under this load is also computed
};

const KeyTable& rating_keys();
const KeyTable& rating_mounting_keys();
/// The keys of [rating.plastic], for VDI 2736.
const KeyTable& rating_plastic_keys();
/// The keys of one step of [[rating.spectrum]].
const KeyTable& load_bin_keys();

constexpr std::size_t kMaxLoadBins = 1000;

// The keys of [load] and [[load.probe]], which give the torque, the probes and the resolution of
// the computation.

const KeyTable& load_keys();
const KeyTable& load_probe_keys();

}  // namespace gearwright
