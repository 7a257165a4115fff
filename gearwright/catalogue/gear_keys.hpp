// The keys of [gear1] and [gear2].
//
// The table of a gear contains these tables: the dimensions of the finished tooth (basic), circular
// fillets, a cutter (cut_by) and a bore. Its other tables are in rack_keys.hpp,
// modification_keys.hpp (flank modifications) and inspection_keys.hpp (measuring).
#pragma once

#include <optional>

#include "gearwright/arrange/given_gear.hpp"
#include "gearwright/arrange/two_halves.hpp"
#include "gearwright/catalogue/inspection_keys.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/catalogue/material_keys.hpp"

namespace gearwright {

/// [gearN.basic]: dimensions that describe the gear independently of the rack.
struct BasicInput {
  double base_diameter = 0.0;                ///< d_b   mm
  double base_tooth_thickness = 0.0;         ///< s_bt  mm, transverse arc
  Angle base_helix_angle;                    ///< β_b
  std::optional<double> root_diameter;       ///< d_f   mm
  std::optional<double> root_form_diameter;  ///< d_Ff  mm
};

const KeyTable& gear_keys();
/// The keys of [gearN.cut_by]: the keys of a gear without the keys of flanks and cutters.
const KeyTable& cutter_keys();
/// The keys of [gearN] in a spec with [search]. They are the values that the search does not
/// determine.
const KeyTable& blank_keys();
const KeyTable& basic_keys();
const KeyTable& root_fillet_keys();
const KeyTable& tip_fillet_keys();
const KeyTable& bore_keys();
/// The keys of [gearN.double_helical].
const KeyTable& double_helical_keys();

}  // namespace gearwright
