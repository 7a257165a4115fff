#include "gearwright/catalogue/gear_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/error.hpp"
#include "gearwright/inspection/thickness_series.hpp"

namespace gearwright {

namespace {

// Limits that do not depend on other keys. A test compares them with the limits of gear/gear.cpp.
constexpr double kMaxTeeth = 100'000;
constexpr double kMinModule = 1e-3, kMaxModule = 1e3;                  // mm
constexpr double kMinPressure = 1, kMaxPressure = 60, kMaxHelix = 89;  // degrees
constexpr double kMaxShift = 1e4;                                      // modules
constexpr double kMinPitch = 0.0254, kMaxPitch = 25400;                // 1/in, 25.4 mm / m_n

// Returns the normal pressure angle, degrees, from tan α_n = tan α_t cos β with α_t in degrees.
double normal_of_transverse(double alpha_t, double cos_beta) {
  return Angle::radians(std::atan(std::tan(Angle::degrees(alpha_t).rad()) * cos_beta)).deg();
}

void set_face(GearInput& gear, double width) {
  gear.cylindrical.face_width = width;
  gear.face_width_given = true;
}

void set_module(GearInput& gear, double module) { gear.cylindrical.normal_module = module; }

void set_pressure_angle(GearInput& gear, Angle angle) {
  gear.cylindrical.normal_pressure_angle = angle;
}

Key only_kind() {
  return Key::word("kind", {"circular"}, KeyPlace::unused(), "\"circular\"", "the only kind")
      .undocumented();
}

using Fillet = TipFilletSpec::By;

KeyPlace tip_fillet(Fillet by) {
  return KeyPlace::by<GearInput, double>([by](GearInput& gear, double value) {
    gear.cylindrical.tip_fillet = TipFilletSpec{by, value};
  });
}

std::optional<KeyFault> complete_tip_fillet(GearInput& gear, const KeyGiven&) {
  gear.tip_clearance_by_rule = !gear.cylindrical.tip_fillet && !gear.tip_clearance;
  return std::nullopt;
}

std::optional<KeyFault> check_bore(Bore& bore, const KeyGiven& given) {
  if (given("keyway")) {
    const auto keyway = hub_keyway(bore.diameter);
    if (!keyway)
      return KeyFault{"keyway",
                      fmt::format("has no keyway for a bore of {} mm, because values are built in "
                                  "for bores of {} to {} mm; give keyway_width_mm and "
                                  "keyway_depth_mm",
                                  format_number(bore.diameter), kKeyedBores[0], kKeyedBores[1])};
    bore.keyway_width = keyway->width;
    bore.keyway_depth = keyway->depth;
  }
  if (bore.keyway_width < bore.diameter) return std::nullopt;
  return KeyFault{"keyway_width_mm",
                  fmt::format("must be less than the diameter of the bore, {} mm",
                              format_number(bore.diameter))};
}

}  // namespace

const KeyTable& gear_keys() {
  static const KeyTable table{
      "gear",
      "A gear",
      {Key::number(
           "teeth", "z",
           KeyRange{.lo = -kMaxTeeth,
                    .hi = kMaxTeeth,
                    .zero = false,
                    .reason = "; the number is negative for an internal gear"},
           {&GearInput::cylindrical, &CylindricalSpec::teeth}, kRequired,
           "number of teeth, for example 17; negative for an internal gear, for example -61")
           .with_also({"number_of_teeth", "tooth_number", "tooth_count", "z1", "z2"}),
       Key::number(
           "normal_module_mm", "m_n", KeyRange::between(kMinModule, kMaxModule),
           KeyPlace::by<GearInput, double>(set_module), "",
           "normal module; this key, `normal_diametral_pitch_per_in`, `transverse_module_mm` or "
           "`basic` is required; if several are given, they must agree to 1e-9")
           .with_also({"module", "modul", "m", "reference_diameter", "pitch_diameter", "d"}),
       Key::number("normal_diametral_pitch_per_in", "", KeyRange::between(kMinPitch, kMaxPitch), {},
                   "", "normal diametral pitch, 25.4 mm / m_n")
           .with_alias({"normal_module_mm", [](double pitch, double) { return 25.4 / pitch; }})
           .with_also({"diametral_pitch", "dp", "pitch", "pd"}),
       Key::positive("transverse_module_mm", "m_t", {}, "", "transverse module, m_n / cos β")
           .with_alias({"normal_module_mm",
                        [](double m_t, double cos_beta) { return m_t * cos_beta; }, true})
           .with_also({"mt"}),
       Key::number("normal_pressure_angle_deg", "α_n",
                   KeyRange::between(kMinPressure, kMaxPressure, ", usually 14.5 to 30"),
                   KeyPlace::by<GearInput, Angle>(set_pressure_angle), "20",
                   "normal pressure angle; `transverse_pressure_angle_deg` can replace this key")
           .with_also({"pressure_angle", "pressure", "alpha", "pa", "phi"}),
       Key::number("transverse_pressure_angle_deg", "α_t",
                   KeyRange::inside(0, 90, ", usually 14.5 to 30"), {}, "",
                   "transverse pressure angle")
           .with_alias({"normal_pressure_angle_deg", normal_of_transverse, true}),
       Key::number(
           "helix_angle_deg", "β",
           KeyRange::between(-kMaxHelix, kMaxHelix, ", > 0 for right hand and < 0 for left hand"),
           {}, "0",
           "helix angle, > 0 right hand, < 0 left hand, also for an internal gear; "
           "`lead_angle_deg` with `hand` can replace this key")
           .with_also({"helix", "spiral_angle", "skew_angle"}),
       Key::number("lead_angle_deg", "90° − |β|", KeyRange::above(0, 90, " (spur)"), {}, "",
                   "lead angle, given together with `hand`")
           .with_fields({"helix_angle"}),
       Key::word("hand", {"right", "left"}, {}, "",
                 "hand of the teeth, given together with `lead_angle_deg`")
           .with_also({"helix_hand", "helix_direction", "direction"}),
       Key::number(
           "profile_shift", "x", KeyRange::between(-kMaxShift, kMaxShift),
           KeyPlace::by<GearInput, double>([](GearInput& g, double x) { g.give_shift(x); }),
           "see *Shift and centre distance*",
           "profile shift in normal modules; > 0 thickens the tooth, also for an internal gear")
           .with_also({"shift", "profile_shift_coefficient", "addendum_modification",
                       "addendum_modification_coefficient", "correction"}),
       Key::number("thickness_allowance_mm", "E_sn", {},
                   KeyPlace::mean_and_ends<GearInput>(
                       [](auto& g) -> auto& { return g.cylindrical.thickness_allowance; },
                       [](auto& g) -> auto& { return g.allowance_ends; }),
                   "0",
                   "allowance on the normal tooth thickness at the reference cylinder; < 0 thins "
                   "the tooth; at most 10 modules. Two numbers are the limits E_sni and E_sns; the "
                   "gear is computed with the mean allowance, and every number that depends on the "
                   "allowance has an interval")
           .with_list(kOneOrEnds)
           .with_also({"allowance", "thinning", "tooth_thinning"}),
       Key::positive("face_width_mm", "b", KeyPlace::by<GearInput, double>(set_face),
                     "10 m_n, with a warning", "face width, from 0.001 to 100 000 modules")
           .with_also({"width", "face", "thickness", "gear_width"}),
       Key::positive("tip_diameter_mm", "d_a",
                     {&GearInput::cylindrical, &CylindricalSpec::tip_diameter},
                     "d + 2 m_n (h_aP* + x); internal gear: d − 2 m_n (h_aP* + x)",
                     "tip diameter, at most 1000 d")
           .with_also(
               {"outside_diameter", "outer_diameter", "addendum_diameter", "diameter", "od"}),
       {.key = "rack",
        .kind = KeyKind::table,
        .words = {"ISO53-A", "ISO53-B", "ISO53-C", "ISO53-D", "GBT12759", "AGMA-14.5", "AGMA-20",
                  "AGMA-25", "AGMA-stub"},
        .tables = {straight_rack_keys, arc_rack_keys, double_arc_rack_keys, rack_of_arcs_keys},
        .fallback = "\"ISO53-A\"",
        .meaning = "the rack that cuts the gear; it is a rack of ISO 53, a double-circular-arc "
                   "rack of GB/T 12759, an AGMA rack (full depth with 14.5°, 20° or 25°, or stub "
                   "with 20°), or a table",
        .also = {"profile", "basic_rack", "tool", "hob", "standard"}},
       {.key = "cut_by",
        .kind = KeyKind::table,
        .words = {"gear1", "gear2"},
        .tables = {cutter_keys},
        .fallback = "cut by `rack`",
        .meaning = "the pinion cutter, which is a gear of the spec or a separate cutter in a table",
        .also = {"cutter", "pinion_cutter"}},
       Key::number("profile_shift_pair", "e", {}, {}, "",
                   "sum of the profile shifts of the gear and its cutter; a gear with `cut_by` may "
                   "have this key instead of `profile_shift`")
           .with_needs({"cut_by"}),
       Key::part("basic", basic_keys, {},
                 "dimensions that describe the gear independently of the rack"),
       Key::part("root_fillet", root_fillet_keys,
                 {&GearInput::cylindrical, &CylindricalSpec::root_fillet},
                 "a circular arc in place of the root that the rack cuts"),
       Key::part("tip_fillet", tip_fillet_keys,
                 KeyPlace::within<GearInput>([](auto& g) -> auto& { return g; }),
                 "a circular arc in place of the tip that the rack cuts"),
       Key::part("modifications", modification_keys, {}, "flank modifications"),
       Key::part("material", material_keys, &GearInput::material, "material of the teeth"),
       Key::part("shaft", shaft_keys, &GearInput::shaft,
                 "shaft and bearings; their deflection changes the contact under load (verb "
                 "`load`) and determines K_Hβ (verb `rate`)"),
       Key::part("bore", bore_keys, &GearInput::bore,
                 "bore and keyway of the CAD files; for an internal gear, the bore is the outside "
                 "of the rim"),
       Key::part("double_helical", double_helical_keys, &GearInput::double_helical,
                 "two halves of opposite hands on one body"),
       Key::part("measure", measure_keys, &GearInput::measure,
                 "positions and tools of the measurements"),
       Key::number("quality", "", flank_classes(),
                   {&GearInput::tolerance, &ToleranceInput::quality}, "no tolerances",
                   "flank tolerance class (grade) of ISO 1328-1; can be given instead of `quality` "
                   "of `tolerance`")
           .with_fields({"tolerance.quality"})
           .with_also({"grade", "accuracy_grade"}),
       Key::part("tolerance", tolerance_keys, &GearInput::tolerance,
                 "the accuracy grade of the flanks and the limits of the tooth thickness"),
       Key::part("measured", measured_keys, {},
                 "readings of an unknown gear for the verb `identify`"),
       Key::word("form", {"gear"}, KeyPlace::unused(), "\"gear\"",
                 "form of the part; \"rack\" in [gear2] makes gear 2 a rack, to which other keys "
                 "apply")}};
  return table;
}

const KeyTable& cutter_keys() {
  static const KeyTable table = [] {
    KeyTable t = gear_keys().without({"cut_by", "profile_shift_pair", "modifications", "material",
                                      "shaft", "form", "double_helical"});
    t.name = "cutter";
    t.meaning =
        "A pinion cutter. If its table has no module or no angle, the cutter has the value of the "
        "gear that it cuts or, if this gear has no value, the value of the mating gear";
    return t;
  }();
  return table;
}

const KeyTable& blank_keys() {
  static const KeyTable table = [] {
    KeyTable t = gear_keys().only({"normal_pressure_angle_deg", "helix_angle_deg", "face_width_mm",
                                   "rack", "material", "modifications"});
    t.name = "blank";
    t.meaning = "Gear data that a search does not determine";
    return t;
  }();
  return table;
}

const KeyTable& basic_keys() {
  static const KeyTable table{
      "basic",
      "Dimensions that describe the gear independently of the rack",
      {Key::positive("base_diameter_mm", "d_b", &BasicInput::base_diameter, kRequired,
                     "diameter of the base cylinder"),
       Key::number("base_tooth_thickness_mm", "s_bt", {}, &BasicInput::base_tooth_thickness,
                   kRequired, "transverse tooth thickness (arc) on the base cylinder"),
       Key::number("base_helix_angle_deg", "β_b",
                   KeyRange::inside(-kMaxHelix, kMaxHelix,
                                    "; for a steeper helix, no rack with a pressure angle of 1° or "
                                    "more describes the gear"),
                   &BasicInput::base_helix_angle, "0",
                   "base helix angle, > 0 right hand, < 0 left hand"),
       Key::positive("root_diameter_mm", "d_f", &BasicInput::root_diameter, "as cut by `rack`",
                     "root diameter, which determines the dedendum of the rack [T4.4]")
           .with_also({"root", "df"}),
       Key::positive("root_form_diameter_mm", "d_Ff", &BasicInput::root_form_diameter,
                     "as cut by `rack`",
                     "diameter at which the flank begins, which determines the tip rounding of the "
                     "rack; only with `root_diameter_mm`, and not for an internal gear")
           .with_needs({"root_diameter_mm"})}};
  return table;
}

const KeyTable& root_fillet_keys() {
  static const KeyTable table{
      "root_fillet",
      "A circular arc, tangent to the flank, in place of the root that the rack cuts",
      {only_kind(),
       Key::number(
           "offset_mm", "",
           KeyRange::not_negative(", because the fillet begins at the undercut limit or beyond it"),
           &RootFilletSpec::offset, "0",
           "distance of the start of the fillet from the undercut limit l_F, so that l_C = "
           "max(l_F, 0) + offset; the fillet is centred in the tooth space")}};
  return table;
}

const KeyTable& tip_fillet_keys() {
  static const KeyTable table{
      "tip_fillet",
      "A circular arc, tangent to the flank, in place of the tip that the rack cuts",
      {only_kind(),
       Key::positive("radius_mm", "r_t", tip_fillet(Fillet::radius),
                     "determined by `l_mm`, `corner_radius_mm` or `clearance_mm`",
                     "radius of the fillet, which is centred on the tooth"),
       Key::number("l_mm", "l_J", {}, tip_fillet(Fillet::l), "",
                   "position along the flank of the rack at which the fillet begins")
           .with_excludes({"radius_mm"}),
       Key::number("clearance_mm", "",
                   KeyRange::not_negative(
                       ", because the tip would otherwise cut into the root of the mating gear"),
                   &GearInput::tip_clearance, "0.2 m_n + 0.05",
                   "tip clearance to the root of the mating gear, on parallel axes [T6.7]")
           .with_excludes({"radius_mm", "l_mm"}),
       Key::positive("corner_radius_mm", "ρ_a", tip_fillet(Fillet::corner), "",
                     "radius of the rounding of both tip corners, instead of a fillet; the "
                     "rounding is tangent to the flank and to the tip circle in the transverse "
                     "section. The rounding of a cutter (ρ_a0) cuts the root fillet [T6.17]")
           .with_excludes({"radius_mm", "l_mm", "clearance_mm"})
           .with_also({"rho_a", "rho_a0", "tip_radius", "corner", "rounding"})},
      complete_tip_fillet};
  return table;
}

const KeyTable& bore_keys() {
  static const KeyTable table{
      "bore",
      "Bore and keyway of the CAD files; for an internal gear the bore is the outside of the rim",
      {Key::positive("diameter_mm", "", &Bore::diameter, kRequired, "diameter of the bore")
           .with_also({"bore", "bore_diameter", "hole", "shaft_diameter"}),
       Key::word("keyway", {"DIN 6885-1"}, KeyPlace::unused(), "no keyway",
                 "standard that gives width and depth of the keyway for the diameter of the bore; "
                 "values are built in for bores of 6 to 380 mm")
           .with_excludes({"keyway_width_mm", "keyway_depth_mm"},
                          "determines both keyway_width_mm and keyway_depth_mm; leave out these "
                          "keys, or leave out keyway"),
       Key::positive(
           "keyway_width_mm", "", &Bore::keyway_width,
           "the width by `keyway`; without `keyway`, the bore has no keyway",
           "width of a keyway at +y of the gear frame; less than the diameter of the bore")
           .with_needs({"keyway_depth_mm"})
           .with_also({"key_width"}),
       Key::positive("keyway_depth_mm", "", &Bore::keyway_depth, "",
                     "depth of the keyway into the hub, measured from the bore")
           .with_needs({"keyway_width_mm"})},
      check_bore};
  return table;
}

const KeyTable& double_helical_keys() {
  using D = DoubleHelical;
  static const KeyTable table{
      "double_helical",
      "Two halves of opposite hands on one body; `helix_angle_deg` is the angle of the half at z > "
      "0, and `face_width_mm` includes both halves and the gap",
      {Key::number("gap_mm", "", KeyRange::not_negative(" (0 for herringbone teeth)"), &D::gap, "0",
                   "gap between the halves"),
       Key::number("stagger_pitches", "s", KeyRange::inside(-1, 1), &D::stagger_pitches, "0",
                   "offset of the teeth at z < 0 relative to the teeth at z > 0, in transverse "
                   "pitches; the mating gear must have the same offset"),
       Key::positive("groove_diameter_mm", "", &D::groove_diameter,
                     "the root diameter minus half a normal module, or plus half a normal module "
                     "for an internal gear",
                     "diameter of the gear within the gap")
           .with_needs({"gap_mm"}),
       Key::positive("hob_diameter_mm", "d_a0", &D::hob_diameter, "the run-out is not computed",
                     "outer diameter of the hob; if the run-out of the hob needs a wider gap, "
                     "there is a warning [T2.43]"),
       Key::number("hob_lead_angle_deg", "γ_0", KeyRange::between(0, 30), &D::hob_lead_angle, "0",
                   "lead angle of the hob")
           .with_needs({"hob_diameter_mm"}),
       Key::not_negative("hob_half_length_mm", "l_0", &D::hob_half_length, "0",
                         "half of the cutting length of the hob")
           .with_needs({"hob_diameter_mm"})}};
  return table;
}

}  // namespace gearwright
