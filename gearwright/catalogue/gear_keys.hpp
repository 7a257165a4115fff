// The keys of [gear1] and [gear2], and what they say of a gear.
//
// A table of a gear has tables of its own: what the finished tooth is given by (basic), circular
// fillets, a cutter (cut_by), a bore; racks: rack_keys.hpp, flank modifications:
// modification_keys.hpp, measuring: inspection_keys.hpp.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/catalogue/inspection_keys.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/catalogue/material_keys.hpp"
#include "gearwright/gear/basic.hpp"
#include "gearwright/gear/bore.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/gear/modifications.hpp"

namespace gearwright {

struct GearInput;

/// [gearN] cut_by: the pinion cutter, and how deep it goes.
struct CutByInput {
  int gear = 0;                             ///< 1 or 2: that gear, finished; 0: a cutter of its own
  std::shared_ptr<const GearInput> cutter;  ///< [gearN.cut_by]
  std::optional<double> profile_shift_pair;  ///< e: shift of the cutter and of the gear together
  std::optional<double> module;              ///< mm; given though it is the cutter's
  std::optional<Angle> pressure_angle;       ///< α_n; given though it is the cutter's
};

/// [gear1], [gear2]: the gear's numbers; `cylindrical.profile_shift` is used once `profile_shift`
/// is known.
struct GearInput {
  CylindricalSpec cylindrical;
  std::optional<double> profile_shift;    ///< x
  bool helix_given = false;               ///< else 0 for a gear, and an unknown for `fit`
  bool face_width_given = false;          ///< else 10 m_n, and a warning says so
  std::optional<BaseGear<double>> basic;  ///< [gearN.basic], as given; module, helix, shift follow
  std::optional<CutByInput> cut_by;       ///< none: cut by its rack
  std::optional<double> tip_clearance;    ///< [gearN.tip_fillet] clearance_mm, to the mating root
  bool tip_clearance_by_rule = false;     ///< [gearN.tip_fillet] without a number: 0.2 m_n + 0.05
  std::optional<Ends> allowance_ends;     ///< E_sni, E_sns  mm; the gear is made at their mean
  MeasureInput measure;                   ///< [gearN.measure]
  ToleranceInput tolerance;               ///< [gearN.tolerance]
  std::vector<std::string> not_read;      ///< sub-tables of verbs that are not in this version
  std::optional<Bore> bore;
  MaterialInput material;
  std::array<FlankModifications, 2> modifications;  ///< right flank, left flank
};

/// [gearN.basic]: the gear as itself.
struct BasicInput {
  double base_diameter = 0.0;                ///< d_b   mm
  double base_tooth_thickness = 0.0;         ///< s_bt  mm, transverse arc
  Angle base_helix_angle;                    ///< β_b
  std::optional<double> root_diameter;       ///< d_f   mm
  std::optional<double> root_form_diameter;  ///< d_Ff  mm
};

/// [gearN.tip_fillet]: where it begins, said in one of three ways, or the rounding of both corners.
struct TipFilletInput {
  std::optional<double> radius, l, clearance, corner_radius;  ///< mm
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

}  // namespace gearwright
