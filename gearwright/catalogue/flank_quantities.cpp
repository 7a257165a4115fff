#include "gearwright/catalogue/gear_quantities.hpp"

#include <string>

#include "gearwright/base/angle.hpp"

namespace gearwright {

namespace {

double flank_degrees(double rad) { return Angle::radians(rad).deg(); }

// Adds the quantities of one end of the active flank. `end` is "root" or "tip". At this end, the
// contact with the mating gear begins or ends.
void add_active(Quantities<EvaluationRanges>& q, const std::string& end, const char* diameter,
                const char* length, RollPlace ActiveFlank::*at) {
  using R = EvaluationRanges;
  const auto mounted = [](const R& r) { return r.active.has_value(); };
  const auto key = [&](const char* what) { return "active_" + end + what; };
  const auto at_it = [&](const char* what) { return std::string(what) + " at " + diameter; };
  q.number(key("_diameter_mm").c_str(), ("active " + end + " diameter").c_str(), diameter,
           "diameter at which contact with the mating gear ends, if contact is limited to the "
           "usable flanks of both gears [T10.28]; absent without a mating gear",
           [at](const R& r) { return (*r.active.*at).diameter; })
      .when(mounted);
  q.number(key("_roll_length_mm").c_str(), at_it("roll length").c_str(), length, "[T10.22]",
           [at](const R& r) { return (*r.active.*at).length; })
      .when(mounted);
  q.number(key("_roll_angle_deg").c_str(), at_it("roll angle").c_str(), "", "[T10.22]",
           [at](const R& r) { return flank_degrees((*r.active.*at).angle); })
      .when(mounted);
}

}  // namespace

const Quantities<FlankToleranceValues>& tolerance_quantities() {
  using T = FlankToleranceValues;
  return define("measure.tolerances", [](Quantities<T>& q) {
    const auto um = [&](const char* key, const char* words, const char* symbol, const char* meaning,
                        auto member) { q.number(key, words, symbol, meaning, member).digits(1); };
    q.whole("quality", "flank tolerance class", "", "grade of ISO 1328-1", &T::quality);
    q.word("edition", "edition of ISO 1328-1", "", [](const T& t) {
       return t.edition == FlankTolerances::iso_2013 ? "ISO 1328:2013" : "ISO 1328:1995";
     }).one_of({"ISO 1328:2013", "ISO 1328:1995"});
    um("single_pitch_um", "single pitch (±)", "f_ptT", "rounded as the standard requires",
       &T::single_pitch);
    um("cumulative_pitch_um", "cumulative pitch, total", "F_pT", "", &T::cumulative_pitch);
    um("profile_total_um", "profile, total", "F_αT", "", &T::profile_total);
    um("profile_form_um", "profile form", "f_fαT", "", &T::profile_form);
    um("profile_slope_um", "profile slope (±)", "f_HαT", "", &T::profile_slope);
    um("helix_total_um", "helix, total", "F_βT", "", &T::helix_total);
    um("helix_form_um", "helix form", "f_fβT", "", &T::helix_form);
    um("helix_slope_um", "helix slope (±)", "f_HβT", "", &T::helix_slope);
    um("runout_um", "runout", "F_rT", "", &T::runout);
    um("radial_composite_um", "radial composite, total (ISO 1328-2)", "F_i″",
       "by ISO 1328-2:1997; null if d is greater than 1000 mm or m_n is greater than 10 mm",
       &T::radial_composite);
    um("tooth_radial_composite_um", "radial composite, tooth to tooth (ISO 1328-2)", "f_i″",
       "null if d is greater than 1000 mm or m_n is greater than 10 mm",
       &T::tooth_radial_composite);
    um("base_pitch_um", "base pitch (±)", "f_pb", "f_pt cos α_t [T10.31]; null for circular arcs",
       &T::base_pitch);
    um("sector_pitch_um", "sector pitch over an eighth of the teeth", "F_pk",
       "for k = ⌊|z|/8⌋ pitches [T10.31], [T10.37]; null for fewer than 16 teeth",
       &T::sector_pitch);
    um("single_flank_composite_um", "single flank composite, total", "F_i′",
       "for the mating gear of the spec, by ISO 1328-1:1995, annex A [T10.32]; null without a "
       "mating gear, or for the edition of 2013, which requires a design value",
       &T::single_flank);
    um("tooth_single_flank_composite_um", "single flank composite, tooth to tooth", "f_i′",
       "null if F_i′ is null", &T::tooth_single_flank);
    um("axis_deviation_um", "out-of-plane shaft deviation", "f_Σβ",
       "for the pair over the span of the bearings, by ISO/TR 10064-3:1996 [T10.33]; null "
       "without `bearing_span_mm`",
       &T::axis_deviation);
    um("axis_inclination_um", "in-plane shaft deviation", "f_Σδ", "null if f_Σβ is null",
       &T::axis_inclination);
  });
}
const Quantities<EvaluationRanges>& range_quantities() {
  using R = EvaluationRanges;
  return define("measure.flank", [](Quantities<R>& q) {
    const auto place = [&](const char* length, const char* angle, const char* words,
                           const char* roll, const char* symbol, RollPlace R::*at) {
      q.number(length, words, symbol, "[T10.22]", [at](const R& r) { return (r.*at).length; });
      q.number(angle, roll, "", "[T10.22]",
               [at](const R& r) { return flank_degrees((r.*at).angle); });
    };
    place("root_form_roll_length_mm", "root_form_roll_angle_deg", "roll length at d_Ff",
          "roll angle at d_Ff", "L_Ff", &R::root_form);
    place("reference_roll_length_mm", "reference_roll_angle_deg", "roll length at d",
          "roll angle at d", "L", &R::reference);
    place("tip_form_roll_length_mm", "tip_form_roll_angle_deg", "roll length at d_Fa",
          "roll angle at d_Fa", "L_Fa", &R::tip_form);
    add_active(q, "root", "d_Nf", "L_Nf", &ActiveFlank::root);
    add_active(q, "tip", "d_Na", "L_Na", &ActiveFlank::tip);
    q.number("profile_evaluation_mm", "profile evaluation, roll lengths", "L_α",
             "the usable profile without the 5 % next to its tip, by ISO 1328-1 [T10.23]",
             &R::profile)
        .ends();
    q.number("helix_evaluation_mm", "helix evaluation, heights", "L_β",
             "from the middle of the face; at each end, 5 % of the face or one module is excluded, "
             "whichever is less [T10.23]",
             &R::helix)
        .ends();
  });
}

}  // namespace gearwright
