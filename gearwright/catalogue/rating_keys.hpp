// The keys of [rating], [rating.mounting] and [[rating.spectrum]]: the load, the life, the making and the mounting that a
// strength rating asks for, and factors that the engineer gives himself.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gearwright/catalogue/material_keys.hpp"
#include "gearwright/rating/spectrum.hpp"

namespace gearwright {

/// [rating], as given. What is known of the gears themselves is taken from them.
struct RatingTable {
  bool given = false;                     ///< the spec has [rating]
  RatingInput input;                      ///< all but torque and materials
  std::optional<double> power;            ///< P    kW
  std::optional<double> torque;           ///< T_1  N m, on gear 1
  std::optional<double> web_thickness;    ///< b_s  mm
  std::optional<double> rim_thickness;    ///< s_R  mm, of both gears
  std::vector<LoadBin> spectrum;          ///< [[rating.spectrum]], in place of one load and life
  std::optional<MaterialInput> material;  ///< of a gear without its own
  std::optional<double> safety_flank_min, safety_root_min;  ///< wanted
  bool tooth_contact = false;  ///< the teeth under this load beside the standard
};

const KeyTable& rating_keys();
const KeyTable& rating_mounting_keys();
/// Of [rating.plastic], for VDI 2736.
const KeyTable& rating_plastic_keys();
/// Of one step of [[rating.spectrum]].
const KeyTable& load_bin_keys();

constexpr std::size_t kMaxLoadBins = 1000;

}  // namespace gearwright
