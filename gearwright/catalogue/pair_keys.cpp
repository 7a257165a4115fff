#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/search_keys.hpp"
#include "gearwright/pair/rack_pair.hpp"

namespace gearwright {

namespace {

KeyRange no_pressing() {
  return KeyRange::not_negative(
      ", because teeth with negative backlash would press into each other");
}

}  // namespace

const KeyTable& pair_keys() {
  static const KeyTable table{
      "pair",
      "Mounting of the two gears",
      {Key::positive("center_distance_mm", "a", &PairInput::center_distance,
                     "determined by `mounting`", "centre distance")
           .with_also({"centre_distance", "distance", "axis_distance", "center", "cd"}),
       Key::text("center_distance_tolerance", &PairInput::distance_tolerance, "",
                 "tolerance of the centre distance by ISO 286, for example `\"JS7\"` (JS1 to JS12)")
           .with_excludes({"center_distance_deviations_mm"})
           .with_fields({"distance_tolerance"})
           .with_also({"js"}),
       Key::number("center_distance_deviations_mm", "", {}, &PairInput::distance_deviations, "",
                   "lower and upper deviation of the centre distance")
           .with_list(kLowerAndUpper)
           .with_fields({"distance_deviations"}),
       Key::number(
           "shaft_angle_deg", "Σ",
           KeyRange::inside(-180, 180, " (> 0 if the helix angles are mainly right-hand)"),
           &PairInput::shaft_angle,
           "0 if the helix angles allow parallel axes, otherwise the angle of the minimum centre "
           "distance, with a warning. The key is required if the axes of an internal pair cannot "
           "be parallel, or if both gears have the same hand and helix angle",
           "shaft angle Σ = β_w1 + β_w2, for internal pairs β_w1 − β_w2; two right-hand "
           "external gears have Σ > 0, and two left-hand external gears Σ < 0")
           .with_also({"axis_angle", "crossing_angle"}),
       Key::number("backlash_mm", "j_n", no_pressing(),
                   KeyPlace::mean_and_ends<PairInput>(
                       [](auto& p) -> auto& { return p.backlash; },
                       [](auto& p) -> auto& { return p.backlash_ends; }),
                   "the backlash that the given allowances and centre distance produce",
                   "backlash in the normal section at the pitch point, j_bn/cos α_wn; the teeth "
                   "are thinned to give this backlash, in place of their thickness allowances. Two "
                   "numbers are the least and the greatest backlash")
           .with_list(kOneOrEnds)
           .with_excludes({"backlash_circumferential_mm", "backlash_deg"})
           .with_also({"backlash", "play", "normal_backlash", "jn"}),
       Key::number("backlash_circumferential_mm", "j_t", no_pressing(),
                   &PairInput::backlash_circumferential, "",
                   "backlash as an arc of the working pitch circle of gear 1")
           .with_excludes({"backlash_deg"})
           .with_also({"circumferential_backlash", "transverse_backlash", "jt", "jwt"}),
       Key::number("backlash_deg", "", no_pressing(), &PairInput::backlash_angle, "",
                   "backlash as the angle through which gear 1 can turn while gear 2 is held")
           .with_fields({"backlash_angle"})
           .with_also({"angular_backlash", "backlash_angle"}),
       Key::number(
           "backlash_split", "", KeyRange::between(0, 1), &PairInput::backlash_split, "0.5",
           "share of the thinning that is applied to gear 1; the rest is applied to gear 2"),
       Key::word("mounting", {"tight", "extended"}, &PairInput::mounting, "\"tight\"",
                 "kind of the default centre distance. `\"tight\"` is the distance at which "
                 "nominal teeth have no backlash. `\"extended\"` is a_d + m_n (x1 + x2), or for an "
                 "internal pair a_d − m_n (x1 + x2), where a_d is the reference centre distance"),
       Key::flag("choose_profile_shifts", &PairInput::choose_profile_shifts, "true",
                 "if `true`, absent profile shifts are computed from a given centre distance and "
                 "reported in a note; if `false`, the profile shifts must be given"),
       Key::flag("shorten_tips", &PairInput::shorten_tips, "false",
                 "if true, tips without a given `tip_diameter_mm` are shortened by k m_n, so that "
                 "the tip clearance is the clearance of the racks"),
       Key::number("friction_coefficient", "μ", friction_range(), &PairInput::friction_coefficient,
                   "no efficiency", "coefficient of friction of the flanks, for the efficiency")
           .with_also({"friction"}),
       Key::positive(
           "bearing_span_mm", "L", &PairInput::bearing_span,
           "bearing distance of `[rating.mounting]`; without this table there are no tolerances of "
           "the axes",
           "greater of the bearing distances of the two shafts, for the tolerances of the axes")
           .with_also({"bearing_distance", "span"}),
       Key::positive("speed_rpm", "n_1", &PairInput::speed_rpm, "no velocities",
                     "speed of rotation of gear 1, for the pitch line velocity")
           .with_also({"speed", "rpm", "n"})}};
  return table;
}

const KeyTable& rack_bar_keys() {
  static const KeyTable table{
      "rack_bar",
      "A rack as gear 2, with the profile of the basic rack of gear 1",
      {Key::word("form", {"rack"}, KeyPlace::unused(), kRequired, "makes gear 2 a rack"),
       Key::number("teeth", "z", KeyRange::between(1, 100'000), &RackBar::teeth,
                   "not limited; pictures and files contain at least one turn of the pinion",
                   "number of teeth, which determines the length of the rack")
           .with_also({"number_of_teeth"}),
       Key::positive("length_mm", "", KeyPlace::unused(), "determined by `teeth`",
                     "space for the teeth of the rack along the travel, in place of `teeth`; the "
                     "rack has as many whole teeth as fit")
           .with_excludes({"teeth"})
           .with_also({"length"}),
       Key::positive("face_width_mm", "b", &RackBar::face_width, "face width of gear 1",
                     "face width")
           .with_also({"width", "face"}),
       Key::positive("height_mm", "", &RackBar::height, "3 modules below the roots",
                     "height from the back of the rack to its datum line")
           .with_also({"height", "back"}),
       Key::number("thickness_allowance_mm", "E_sn", {}, &RackBar::thickness_allowance, "0",
                   "allowance on the normal tooth thickness at the datum line; < 0 thins the teeth")
           .with_also({"allowance", "thinning"})}};
  return table;
}

namespace {

Key of_few_teeth(std::string_view key, std::string_view symbol,
                 std::optional<double> FitInput::*member, std::string_view fallback,
                 std::string_view meaning) {
  const auto set = [member](FitInput& fit, double value) {
    fit.*member = value;
    return std::string(fit.few_teeth ? "" : "is allowed only with few_teeth = true");
  };
  return Key::not_negative(key, symbol, KeyPlace::by<FitInput, double>(set), fallback, meaning)
      .with_needs({"few_teeth"});
}

}  // namespace

const KeyTable& fit_keys() {
  static const KeyTable table{
      "fit",
      "Settings of the verb `fit`; no other verb reads them",
      {Key::number("working_normal_pressure_angle_deg", "α_wn",
                   KeyRange::between(1, 80, ", usually 14.5 to 30"),
                   &FitInput::working_normal_pressure_angle, "",
                   "working normal pressure angle of the designs"),
       Key::flag("few_teeth", &FitInput::few_teeth, "false",
                 "if true, the pinion has few teeth, and a cutter with the profile of the pinion "
                 "and longer teeth generates the wheel or internal gear"),
       of_few_teeth("least_tip_land_mm", "", &FitInput::min_tip_land, "0",
                    "least normal tooth thickness at both tips"),
       of_few_teeth("least_gap_mm", "", &FitInput::min_gap, "0",
                    "least chord of the tooth space at the start of the flanks, for both gears"),
       of_few_teeth(
           "clearance_mm", "", &FitInput::clearance, "0.2 m_n + 0.05",
           "tip clearance of both gears without backlash; a backlash increases the tip clearance"),
       of_few_teeth(
           "backlash_mm", "", &FitInput::backlash, "0",
           "circumferential backlash, which determines the centre distance to first "
           "order; `backlash_mm` of `[pair]`, in contrast, is the backlash in the normal section"),
       of_few_teeth("contact_ratio", "ε_γ", &FitInput::contact_ratio, "1.2",
                    "required total contact ratio, which determines the face width")}};
  return table;
}

}  // namespace gearwright
