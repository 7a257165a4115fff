// The keys of [gear1] and [gear2], and of the tables that they contain. The flank modifications are
// in modification_keys.hpp.
#pragma once

#include <cstddef>
#include <optional>

#include "gearwright/arrange/given_gear.hpp"
#include "gearwright/arrange/two_halves.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/compliance/shaft.hpp"

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

// The keys of [gearN.material]: the material of the teeth, for loads and ratings.

const KeyTable& material_keys();

// The keys of [gear1.shaft] and [gear2.shaft]: the bearings, the diameters and the side of the
// torque.

const KeyTable& shaft_keys();

constexpr std::size_t kMostShaftDiameters = 50;

// The keys of [gearN.rack]: the straight rack, the racks F and P, double circular arcs, and any
// chain of arcs. Lengths are in normal modules.

const KeyTable& straight_rack_keys();
const KeyTable& arc_rack_keys();         ///< kind = "circular_arc"
const KeyTable& double_arc_rack_keys();  ///< kind = "double_circular_arc"
const KeyTable& rack_of_arcs_keys();     ///< kind = "arcs"
const KeyTable& rack_arc_keys();         ///< the keys of each table in `arcs`

// The keys for measuring a gear: the tools in [gearN.measure], the permitted readings in
// [gearN.tolerance], and the readings of an unknown gear in [gearN.measured].

inline constexpr KeyList kLowerAndUpper{.least = 2, .most = 2, .order = kLowerFirst};
/// One number or two limits. If limits are given, the teeth are computed with their mean.
inline constexpr KeyList kOneOrEnds{.most = 2, .single = true, .order = kLowerFirst};

const KeyTable& measure_keys();
const KeyTable& tolerance_keys();
KeyRange flank_classes();  ///< the flank tolerance classes of both editions of ISO 1328-1

inline constexpr std::size_t kMostBallReadings = 20;

const KeyTable& measured_keys();
/// The keys of one entry of over_balls_mm.
const KeyTable& measured_ball_keys();
/// The keys of a [gearN] that has readings but no module, for other known data of the gear.
const KeyTable& unknown_gear_keys();

}  // namespace gearwright
