// The keys of [gear1] and [gear2], and what they say of a gear.
//
// A table of a gear has tables of its own: what the finished tooth is given by (basic), circular
// fillets, a cutter (cut_by), a bore; racks: rack_keys.hpp, flank modifications:
// modification_keys.hpp, measuring: inspection_keys.hpp.
#pragma once

#include <optional>

#include "gearwright/arrange/given_gear.hpp"
#include "gearwright/arrange/two_halves.hpp"
#include "gearwright/catalogue/inspection_keys.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/catalogue/material_keys.hpp"

namespace gearwright {

/// [gearN.basic]: the gear as itself.
struct BasicInput {
  double base_diameter = 0.0;                ///< d_b   mm
  double base_tooth_thickness = 0.0;         ///< s_bt  mm, transverse arc
  Angle base_helix_angle;                    ///< β_b
  std::optional<double> root_diameter;       ///< d_f   mm
  std::optional<double> root_form_diameter;  ///< d_Ff  mm
};

const KeyTable& gear_keys();
/// Of [gearN.cut_by]: a gear's, without those of flanks and cutters.
const KeyTable& cutter_keys();
/// Of a [gearN] beside [search] that is no gear of its own.
const KeyTable& blank_keys();
const KeyTable& basic_keys();
const KeyTable& root_fillet_keys();
const KeyTable& tip_fillet_keys();
const KeyTable& bore_keys();
/// Of [gearN.double_helical].
const KeyTable& double_helical_keys();

}  // namespace gearwright
