#include "gearwright/catalogue/gear_keys.hpp"

#include <algorithm>
#include <initializer_list>

#include "gearwright/catalogue/measured_keys.hpp"
#include "gearwright/catalogue/modification_keys.hpp"
#include "gearwright/catalogue/rack_keys.hpp"

namespace gearwright {

namespace {

using Range = KeyRange;

// The limits of gear/gear.cpp that do not depend on other keys; a test holds them together.
constexpr double kMaxTeeth = 100'000;
constexpr double kMinModule = 1e-3, kMaxModule = 1e3;                  // mm
constexpr double kMinPressure = 1, kMaxPressure = 60, kMaxHelix = 89;  // degrees
constexpr double kMaxShift = 1e4;                                      // modules
constexpr double kMinPitch = 0.0254, kMaxPitch = 25400;                // 25.4 mm / m_n

KeyTable without(const KeyTable& table, std::initializer_list<std::string_view> left_out) {
  KeyTable rest{table.name, table.meaning, {}};
  for (const Key& key : table.keys)
    if (std::find(left_out.begin(), left_out.end(), key.key) == left_out.end())
      rest.keys.push_back(key);
  return rest;
}

KeyTable only(const KeyTable& table, std::initializer_list<std::string_view> kept) {
  KeyTable part{table.name, table.meaning, {}};
  for (const std::string_view key : kept) part.keys.push_back(*table.find(key));
  return part;
}

}  // namespace

const KeyTable& gear_keys() {
  static const KeyTable table{
      "gear",
      "A gear",
      {{.key = "teeth",
        .symbol = "z",
        .kind = KeyKind::whole,
        .range = {.lo = -kMaxTeeth,
                  .hi = kMaxTeeth,
                  .zero = false,
                  .reason = "; negative for an internal gear"},
        .place = KeyPlace::within<GearInput>([](auto& g) -> auto& { return g.cylindrical.teeth; }),
        .required = true,
        .meaning = "number of teeth, 17 for example; negative for an internal gear, -61",
        .also = {"number_of_teeth", "tooth_number", "tooth_count", "z1", "z2"}},
       {.key = "normal_module_mm",
        .symbol = "m_n",
        .range = Range::between(kMinModule, kMaxModule),
        .meaning = "normal module; it, one of the next two or `basic` must be there, several must "
                   "agree to 1e-9",
        .also = {"module", "modul", "m", "reference_diameter", "pitch_diameter", "d"}},
       {.key = "normal_diametral_pitch_per_in",
        .range = Range::between(kMinPitch, kMaxPitch),
        .meaning = "25.4 mm / m_n",
        .fields = {"normal_module"},
        .also = {"diametral_pitch", "dp", "pitch", "pd"}},
       {.key = "transverse_module_mm",
        .symbol = "m_t",
        .range = Range::positive(),
        .meaning = "m_n / cos β",
        .fields = {"normal_module"},
        .also = {"mt"}},
       {.key = "normal_pressure_angle_deg",
        .symbol = "α_n",
        .range = Range::between(kMinPressure, kMaxPressure, ", usually 14.5 to 30"),
        .fallback = "20",
        .meaning = "normal pressure angle; or the next",
        .also = {"pressure_angle", "pressure", "alpha", "pa", "phi"}},
       {.key = "transverse_pressure_angle_deg",
        .symbol = "α_t",
        .range = Range::inside(0, 90, ", usually 14.5 to 30"),
        .meaning = "transverse pressure angle",
        .fields = {"normal_pressure_angle"}},
       {.key = "helix_angle_deg",
        .symbol = "β",
        .range = Range::between(-kMaxHelix, kMaxHelix, ": > 0 right hand, < 0 left hand"),
        .fallback = "0",
        .meaning =
            "helix angle, > 0 right hand, < 0 left hand, of an internal gear too; or the next two",
        .also = {"helix", "spiral_angle", "skew_angle"}},
       {.key = "lead_angle_deg",
        .symbol = "90° − |β|",
        .range = Range::above(0, 90, " (spur)"),
        .meaning = "lead angle, with `hand`",
        .fields = {"helix_angle"}},
       {.key = "hand",
        .kind = KeyKind::word,
        .words = {"right", "left"},
        .meaning = "hand of the teeth, beside `lead_angle_deg`",
        .also = {"helix_hand", "helix_direction", "direction"}},
       {.key = "profile_shift",
        .symbol = "x",
        .range = Range::between(-kMaxShift, kMaxShift),
        .place = &GearInput::profile_shift,
        .fallback = "see *Shift and centre distance*",
        .meaning =
            "profile shift in normal modules; > 0 thickens the tooth, of an internal gear too",
        .also = {"shift", "profile_shift_coefficient", "addendum_modification",
                 "addendum_modification_coefficient", "correction"}},
       {.key = "thickness_allowance_mm",
        .symbol = "E_sn",
        .list = KeyList{1, 2, true},
        .fallback = "0",
        .meaning = "allowance on the normal tooth thickness at the reference cylinder; < 0 thins "
                   "it; at most 10 modules. Two: E_sni and E_sns, the teeth are made at their mean "
                   "and every number that depends on it has an interval",
        .also = {"allowance", "thinning", "tooth_thinning"}},
       {.key = "face_width_mm",
        .symbol = "b",
        .range = Range::positive(),
        .fallback = "10 m_n, with a warning",
        .meaning = "face width, from 0.001 to 100 000 modules",
        .also = {"width", "face", "thickness", "gear_width"}},
       {.key = "tip_diameter_mm",
        .symbol = "d_a",
        .range = Range::positive(),
        .place = KeyPlace::within<GearInput>(
            [](auto& g) -> auto& { return g.cylindrical.tip_diameter; }),
        .fallback = "d + 2 m_n (h_aP* + x); internal gear: d − 2 m_n (h_aP* + x)",
        .meaning = "tip diameter, at most 1000 d",
        .also = {"outside_diameter", "outer_diameter", "addendum_diameter", "diameter", "od"}},
       {.key = "rack",
        .kind = KeyKind::table,
        .words = {"ISO53-A", "ISO53-B", "ISO53-C", "ISO53-D", "GBT12759"},
        .tables = {straight_rack_keys, arc_rack_keys, double_arc_rack_keys, rack_of_arcs_keys},
        .fallback = "\"ISO53-A\"",
        .meaning = "the rack that cuts the gear: of ISO 53, double circular arcs of GB/T 12759, or "
                   "a table",
        .also = {"profile", "basic_rack", "tool", "hob", "standard"}},
       {.key = "cut_by",
        .kind = KeyKind::table,
        .words = {"gear1", "gear2"},
        .tables = {cutter_keys},
        .fallback = "cut by `rack`",
        .meaning = "the pinion cutter: that finished gear, or a table, a cutter of its own"},
       {.key = "profile_shift_pair",
        .symbol = "e",
        .needs = {"cut_by"},
        .meaning = "beside `cut_by`: x of the gear and of its cutter together; instead of "
                   "`profile_shift`"},
       {.key = "basic",
        .kind = KeyKind::table,
        .tables = {basic_keys},
        .in_documents = false,
        .meaning = "the gear as itself, by what every rack that cuts it leaves"},
       {.key = "root_fillet",
        .kind = KeyKind::table,
        .tables = {root_fillet_keys},
        .in_documents = false,
        .meaning = "a circular arc in place of the root that the rack cuts"},
       {.key = "tip_fillet",
        .kind = KeyKind::table,
        .tables = {tip_fillet_keys},
        .in_documents = false,
        .meaning = "a circular arc in place of the tip that the rack cuts"},
       {.key = "modifications",
        .kind = KeyKind::table,
        .tables = {modification_keys},
        .in_documents = false,
        .meaning = "what is removed from the flanks"},
       {.key = "material",
        .kind = KeyKind::table,
        .tables = {material_keys},
        .in_documents = false,
        .meaning = "what the teeth are made of"},
       {.key = "bore",
        .kind = KeyKind::table,
        .tables = {bore_keys},
        .in_documents = false,
        .meaning = "bore and keyway of the CAD files; of an internal gear its rim"},
       {.key = "measure",
        .kind = KeyKind::table,
        .tables = {measure_keys},
        .in_documents = false,
        .meaning = "where and how the gear is measured"},
       {.key = "quality",
        .kind = KeyKind::whole,
        .range = KeyRange::between(0, 12, ", the flank tolerance classes of ISO 1328-1"),
        .place = KeyPlace::within<GearInput>([](auto& g) -> auto& { return g.tolerance.quality; }),
        .fallback = "no tolerances",
        .meaning = "flank tolerance class (grade) of ISO 1328-1; also `quality` of `tolerance`",
        .also = {"grade", "accuracy_grade"}},
       {.key = "tolerance",
        .kind = KeyKind::table,
        .tables = {tolerance_keys},
        .in_documents = false,
        .meaning = "the grade of the flanks, and how thick the teeth may be"},
       {.key = "measured",
        .kind = KeyKind::table,
        .tables = {measured_keys},
        .in_documents = false,
        .meaning = "readings of an unknown gear, for the verb identify"}}};
  return table;
}

const KeyTable& cutter_keys() {
  static const KeyTable table = [] {
    KeyTable t =
        without(gear_keys(), {"cut_by", "profile_shift_pair", "modifications", "material"});
    t.name = "cutter";
    t.meaning =
        "A pinion cutter; module and angles where they are not those of the gear or its "
        "mating gear";
    return t;
  }();
  return table;
}

const KeyTable& blank_keys() {
  static const KeyTable table = [] {
    KeyTable t = only(gear_keys(), {"normal_pressure_angle_deg", "helix_angle_deg", "face_width_mm",
                                    "rack", "material"});
    t.name = "blank";
    t.meaning = "What a search does not choose of a gear";
    return t;
  }();
  return table;
}

const KeyTable& basic_keys() {
  static const KeyTable table{
      "basic",
      "The gear as itself, by what every rack that cuts it leaves",
      {{.key = "base_diameter_mm",
        .symbol = "d_b",
        .range = Range::positive(),
        .place = &BasicInput::base_diameter,
        .required = true,
        .meaning = "diameter of the base cylinder"},
       {.key = "base_tooth_thickness_mm",
        .symbol = "s_bt",
        .place = &BasicInput::base_tooth_thickness,
        .required = true,
        .meaning = "transverse tooth thickness (arc) on the base cylinder"},
       {.key = "base_helix_angle_deg",
        .symbol = "β_b",
        .range = Range::inside(-kMaxHelix, kMaxHelix,
                               ": steeper, no rack of 1° and more describes the gear"),
        .place = &BasicInput::base_helix_angle,
        .fallback = "0",
        .meaning = "base helix angle, > 0 right hand, < 0 left hand"},
       {.key = "root_diameter_mm",
        .symbol = "d_f",
        .range = Range::positive(),
        .place = &BasicInput::root_diameter,
        .fallback = "what `rack` leaves",
        .meaning = "root diameter: sets the rack's dedendum so that it leaves this root [T4.4]",
        .also = {"root", "df"}},
       {.key = "root_form_diameter_mm",
        .symbol = "d_Ff",
        .range = Range::positive(),
        .place = &BasicInput::root_form_diameter,
        .needs = {"root_diameter_mm"},
        .fallback = "what `rack` leaves",
        .meaning = "beside `root_diameter_mm`: sets the rack's tip rounding so that the flank "
                   "begins here; not of an internal gear"}}};
  return table;
}

const KeyTable& root_fillet_keys() {
  static const KeyTable table{
      "root_fillet",
      "A circular arc, tangent to the flank, in place of the root that the rack cuts",
      {{.key = "kind",
        .kind = KeyKind::word,
        .words = {"circular"},
        .fallback = "\"circular\"",
        .in_documents = false,
        .meaning = "the only one"},
       {.key = "offset_mm",
        .range = Range::not_negative(": the fillet begins at the undercut limit or beyond it"),
        .place = &RootFilletSpec::offset,
        .fallback = "0",
        .meaning = "the fillet begins at l_C = max(l_F, 0) + offset, l_F the undercut limit; "
                   "centred in the space"}}};
  return table;
}

const KeyTable& tip_fillet_keys() {
  static const KeyTable table{
      "tip_fillet",
      "A circular arc, tangent to the flank, in place of the tip that the rack cuts",
      {{.key = "kind",
        .kind = KeyKind::word,
        .words = {"circular"},
        .fallback = "\"circular\"",
        .in_documents = false,
        .meaning = "the only one"},
       {.key = "radius_mm",
        .symbol = "r_t",
        .range = Range::positive(),
        .place = &TipFilletInput::radius,
        .fallback = "one of the three",
        .meaning = "radius; centred on the tooth"},
       {.key = "l_mm",
        .symbol = "l_J",
        .place = &TipFilletInput::l,
        .excludes = {"radius_mm"},
        .meaning = "where the fillet begins"},
       {.key = "clearance_mm",
        .range = Range::not_negative(": the tip would cut into the mating gear's root"),
        .place = &TipFilletInput::clearance,
        .excludes = {"radius_mm", "l_mm"},
        .fallback = "0.2 m_n + 0.05",
        .meaning = "what the tip leaves to the mating gear's root, on parallel axes [T6.7]"},
       {.key = "corner_radius_mm",
        .symbol = "ρ_a",
        .range = Range::positive(),
        .place = &TipFilletInput::corner_radius,
        .excludes = {"radius_mm", "l_mm", "clearance_mm"},
        .meaning =
            "instead: radius of both tip corners, tangent to the flank and to the tip circle "
            "in the transverse section; of a cutter ρ_a0, which cuts the root fillet [T6.17]",
        .also = {"rho_a", "rho_a0", "tip_radius", "corner", "rounding"}}}};
  return table;
}

const KeyTable& bore_keys() {
  static const KeyTable table{
      "bore",
      "Bore and keyway of the CAD files; of an internal gear the bore is its rim",
      {{.key = "diameter_mm",
        .range = Range::positive(),
        .place = &Bore::diameter,
        .required = true,
        .meaning = "diameter of the bore",
        .also = {"bore", "bore_diameter", "hole", "shaft_diameter"}},
       {.key = "keyway_width_mm",
        .range = Range::positive(),
        .place = &Bore::keyway_width,
        .needs = {"keyway_depth_mm"},
        .fallback = "no keyway",
        .meaning = "width of a keyway at +y of the gear frame, less than the bore's diameter",
        .also = {"keyway", "key_width"}},
       {.key = "keyway_depth_mm",
        .range = Range::positive(),
        .place = &Bore::keyway_depth,
        .needs = {"keyway_width_mm"},
        .meaning = "its depth into the hub, from the bore"}}};
  return table;
}

}  // namespace gearwright
