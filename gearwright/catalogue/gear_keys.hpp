// The keys of [gear1] and [gear2], of the tables that they contain, and of [pair] and [fit].
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "gearwright/arrange/given_pair.hpp"
#include "gearwright/arrange/two_halves.hpp"
#include "gearwright/base/angle.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/compliance/shaft.hpp"
#include "gearwright/gear/modifications.hpp"

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
/// The keys of [gearN.cut_by]: the keys of a gear that also apply to its pinion cutter. A cutter
/// has, for example, no cutter of its own, no flank modifications and no material.
const KeyTable& cutter_keys();
/// The keys of [gearN] in a spec with [search], for values that the search does not determine.
const KeyTable& blank_keys();
const KeyTable& basic_keys();
const KeyTable& root_fillet_keys();
const KeyTable& tip_fillet_keys();
const KeyTable& bore_keys();
const KeyTable& double_helical_keys();

const KeyTable& material_keys();

// The keys of [gear1.shaft] and [gear2.shaft]: bearings, diameters and the side of the torque.

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
/// The value is one number or two limits. If limits are given, the teeth are computed with their
/// mean.
inline constexpr KeyList kOneOrEnds{.most = 2, .single = true, .order = kLowerFirst};

const KeyTable& measure_keys();
const KeyTable& tolerance_keys();
KeyRange flank_classes();  ///< the flank tolerance classes of both editions of ISO 1328-1

inline constexpr std::size_t kMostBallReadings = 20;

const KeyTable& measured_keys();
/// The keys of one entry of over_balls_mm.
const KeyTable& measured_ball_keys();
/// The keys of a [gearN] that describes an unknown gear by readings and has no module. They contain
/// the data of the gear that are known.
const KeyTable& unknown_gear_keys();

const KeyTable& pair_keys();

/// The keys of [gear2] if gear 2 is a rack.
const KeyTable& rack_bar_keys();

/// The keys of [fit]. The verb `fit` has these inputs in addition to the gears and the pair.
struct FitInput {
  std::optional<Angle> working_normal_pressure_angle;  ///< α_wn of the requested designs
  bool few_teeth = false;  ///< true for a pinion with circular fillets and the wheel that it cuts
  std::optional<double> min_tip_land, min_gap, clearance, backlash;  ///< mm, for few_teeth
  std::optional<double> contact_ratio;                               ///< total contact ratio, for
                                                                     ///< few_teeth
};

const KeyTable& fit_keys();

// The table of the flank modifications with their words, symbols and keys. The keys of
// [gearN.modifications] are made from this table.
//
// A key without a prefix applies to both flanks. A key with the prefix right_ or left_ applies to
// one flank and takes precedence over the key without a prefix.

/// A modification. If its name is "tip_relief", the key of its amount is tip_relief_um.
struct ModificationEntry : ModificationMember {
  std::string_view symbol;       ///< C_αa
  std::string_view words;        ///< "tip relief"
  std::string_view reach;        ///< end of the key that limits a relief: "_start_mm"
  std::string_view reach_words;  ///< "from diameter"
  std::string_view meaning;      ///< the material removed
};

/// The entries in the order of kModifications.
const std::array<ModificationEntry, kModifications.size()>& modification_entries();

constexpr std::array<std::string_view, 2> kFlankSides{"right_", "left_"};
/// Prefixes of the members of one flank, as in "modifications.right.tip_relief.amount".
constexpr std::array<std::string_view, 2> kFlankMembers{"right.", "left."};

/// [gearN.modifications]: the right and the left flank, and the files of their topographies.
struct FlanksInput {
  BothFlanks flanks;
  std::array<std::optional<std::string>, 2> topography;  ///< name of a CSV file
};

const KeyTable& modification_keys();
/// Returns the key that applies to a flank: the key with the prefix of the flank if it is given,
/// and otherwise the key for both flanks.
std::string key_of_flank(const KeyGiven& given, std::size_t flank, const std::string& key);

}  // namespace gearwright
