#include "gearwright/catalogue/gear_quantities.hpp"

#include <cmath>

#include "gearwright/base/overloaded.hpp"

namespace gearwright {

namespace {

constexpr const char* kHalves = "Double helical";

void add_halves(Quantities<Halves>& q) {
  using H = Halves;
  q.under(kHalves);
  q.number("half_face_width_mm", "face width of one half", "b_B", "(b − gap)/2 [T2.42]",
           &H::half_face_width);
  q.number("gap_mm", "gap between the halves", "", "as in the spec",
           [](const H& h) { return h.given.gap; });
  q.number("apex_to_half_mm", "distance of a half from the apex", "",
           "gap/2, because the two helices of one tooth meet in the middle plane",
           [](const H& h) { return h.given.gap / 2; });
  q.number("stagger_pitches", "stagger of the half at z < 0 in pitches", "s", "as in the spec",
           [](const H& h) { return h.given.stagger_pitches; });
  q.number("groove_diameter_mm", "groove diameter", "",
           "diameter of the gear within the gap: as given, otherwise the root diameter minus m_n/2 "
           "(plus m_n/2 for an internal gear); null without a gap",
           &H::groove_diameter);
  q.number("hob_run_out_mm", "least gap for the run-out of the hob", "",
           "[T2.43]; null without a hob", &H::hob_run_out);
  q.number("axial_shift_per_index_error", "axial shift per index error", "Δz/e",
           "1/(2 tan |β|); if there is an index error between the halves, a floating gear shifts "
           "along its axis by this multiple of the error, so that both halves have the same share "
           "of the error [T2.44]",
           &H::axial_shift_per_index_error);
}

}  // namespace

using namespace gear_group;

namespace {

using Reference = ReferenceGeometry<double>;

Value doubled(const std::optional<double>& radius) { return radius ? Value(2 * *radius) : Value(); }

const InvoluteTeeth* involute_of(const Gear& g) { return g.involute(); }
const ArcTeeth* arcs_of_gear(const Gear& g) { return g.arcs(); }
const Gear* involute_gear(const Gear& g) { return involute_of(g) ? &g : nullptr; }
const Reference* reference_of(const Gear& g) {
  const InvoluteTeeth* teeth = involute_of(g);
  return teeth ? &teeth->reference : nullptr;
}
bool has_involutes(const Gear& g) { return involute_of(g) != nullptr; }
bool is_undercut(const Gear& g) {
  const InvoluteTeeth* teeth = involute_of(g);
  return teeth && teeth->undercut_l.value_or(0.0) > 0.0;
}

// Returns a getter for an angle of the reference geometry, whose angles are in rad.
auto angle(double Reference::*rad) {
  return [rad](const Reference& r) { return Angle::radians(r.*rad); };
}

const char* kind(const Gear& g) {
  if (!has_involutes(g)) return "circular_arc";
  return g.cut_by && !g.cut_by->by_default ? "generated" : "involute";
}

const char* hand(const Gear& g) {
  const double beta = g.spec.helix_angle.rad();
  return beta > 0.0 ? "right" : beta < 0.0 ? "left" : "spur";
}

Value tip_form_diameter(const Gear& g) {
  if (!g.exists() || (g.tooth && !g.tooth->tip_form_radius)) return {};
  return 2 * g.tip_form_radius();
}

Value reference_thickness(const Gear& g) {
  return std::visit(Overloaded{[](const InvoluteTeeth& t) {
                                 return Value(t.reference.reference_tooth_thickness_normal);
                               },
                               [](const ArcTeeth& t) { return Value(t.reference_thickness); }},
                    g.flanks);
}

Value neck_thickness(const Gear& g) {
  if (!g.tooth || !g.tooth->neck_half_angle || !g.tooth->neck_radius) return {};
  return 2 * *g.tooth->neck_radius * std::sin(g.tooth->neck_half_angle->rad());
}

template <auto member>
auto maybe(const Gear& g) {
  return g.*member ? &*(g.*member) : nullptr;
}
template <auto member>
const FilletArc* fillet(const Gear& g) {
  return g.tooth && (*g.tooth).*member ? &*((*g.tooth).*member) : nullptr;
}
const Bore* keyway(const Gear& g) {
  return g.bore && g.bore->keyway_width > 0.0 ? &*g.bore : nullptr;
}

void add_reference_data(Quantities<Gear>& q) {
  auto of_reference = q.part(reference_of);
  auto of_involute_gear = q.part(involute_gear);
  auto of_cutter = q.part(maybe<&Gear::cut_by>);
  q.under(kTeeth);
  q.term("teeth", "negative for an internal gear", [](const Gear& g) { return g.spec.teeth; });
  q.word("kind", "kind of teeth",
         "`generated` if the spec has `cut_by`; for `circular_arc` teeth, pressure angles, base "
         "quantities and profile shifts are null",
         kind)
      .one_of({"involute", "generated", "circular_arc"})
      .doors(kJson);
  q.under(kCutter);
  of_cutter.whole("cutter_teeth", "number of teeth of the cutter", "z_0",
                  "null without a pinion cutter", &PinionCutting::cutter_teeth);
  of_cutter.number("generating_center_distance_mm", "generating centre distance", "E",
                   "centre distance of gear and pinion cutter when the tooth is finished; null "
                   "without a pinion cutter",
                   &PinionCutting::distance);
  q.under(kTeeth);
  q.term("normal_module_mm", "as in the spec, or as computed from other keys",
         [](const Gear& g) { return g.spec.normal_module; });
  q.number("transverse_module_mm", "transverse module", "m_t", "m_n/cos β",
           &Gear::transverse_module)
      .doors(kPeople);
  q.number("normal_diametral_pitch_per_in", "normal diametral pitch", "P_nd", "25.4 mm/m_n",
           [](const Gear& g) { return kMmPerInch / g.spec.normal_module; })
      .doors(kPeople)
      .in_inch();
  of_involute_gear.term("normal_pressure_angle_deg", "of the basic rack",
                        [](const Gear& g) { return g.spec.normal_pressure_angle; });
  of_reference.number("transverse_pressure_angle_deg", "transverse pressure angle", "α_t",
                      "at the reference cylinder", angle(&Reference::transverse_pressure_angle));
  q.term("helix_angle_deg", "at the reference cylinder, > 0 right hand",
         [](const Gear& g) { return g.spec.helix_angle; });
  q.word("hand_of_helix", "hand of helix", "right, left or spur", hand).doors(kPeople);
  of_reference.number("base_helix_angle_deg", "base helix angle", "β_b", "> 0 right hand",
                      angle(&Reference::base_helix_angle));
  of_involute_gear.term("profile_shift",
                        "in normal modules; > 0 thickens the tooth, also of an internal gear",
                        [](const Gear& g) { return g.spec.profile_shift; });
  of_reference.term("generating_profile_shift", "including the thickness allowance",
                    &Reference::generating_profile_shift);
  q.term("face_width_mm", "as in the spec, or 10 m_n",
         [](const Gear& g) { return g.spec.face_width; });
  q.number("lead_mm", "lead", "p_z", "> 0 right hand; null for spur gears", [](const Gear& g) {
     return g.lead == 0.0 ? Value() : Value(g.lead);
   }).expected(has_involutes);
}

void add_sizes(Quantities<Gear>& q) {
  auto of_reference = q.part(reference_of);
  q.under(kDiameters);
  q.term("reference_diameter_mm", "z m_t", &Gear::reference_diameter);
  of_reference.number("base_diameter_mm", "base diameter", "d_b", "of the involute",
                      &Reference::base_diameter);
  q.term("tip_diameter_mm", "of the blank", &Gear::tip_diameter);
  q.term("root_diameter_mm", "negative if the rack passes through the axis", &Gear::root_diameter);
  q.number("root_form_diameter_mm", "root form diameter", "d_Ff",
           "diameter at the start of the usable flank; the flank starts where it intersects the "
           "root as cut, or at point C of a circular root fillet",
           [](const Gear& g) { return g.exists() ? doubled(g.root_form_radius()) : Value(); })
      .expected(has_involutes);
  q.number("tip_form_diameter_mm", "tip form diameter", "d_Fa",
           "diameter at the end of the usable flank; the flank ends at point J of a circular tip "
           "fillet, at the chamfer or at the tip; null if no flank is left",
           tip_form_diameter)
      .expected(has_involutes);
  q.number(
       "finished_tip_diameter_mm", "finished tip diameter", "",
       "diameter at the actual end of the tooth; the tooth ends at the tip of the blank, at the "
       "bottom land of the cutter or at the point where the flanks meet; d_a for an internal gear",
       [](const Gear& g) { return g.exists() ? Value(2 * g.actual_tip_radius()) : Value(); })
      .shown([](const Gear& g) { return 2 * g.actual_tip_radius() != g.tip_diameter; });
  q.under(kTooth);
  of_reference.number("base_tooth_thickness_mm", "transverse base tooth thickness", "s_bt",
                      "extrapolated for an internal gear, so that the value can be negative",
                      &Reference::base_tooth_thickness);
  q.term("reference_tooth_thickness_normal_mm",
         "at the reference cylinder, including the thickness allowance", reference_thickness);
  q.term("thickness_allowance_mm", "allowance that is included in s_n; < 0 thins the tooth",
         [](const Gear& g) { return g.spec.thickness_allowance; })
      .doors(kPage);
  of_reference
      .number("reference_tooth_thickness_transverse_mm", "transverse tooth thickness", "s_t",
              "at the reference cylinder, including the thickness allowance",
              &Reference::reference_tooth_thickness_transverse)
      .doors(kPage);
  q.number("tip_tooth_thickness_normal_mm", "normal tip tooth thickness", "s_an",
           "of the finished tooth", &Gear::tip_tooth_thickness_normal)
      .expected(has_involutes);
  q.under(kDiameters);
  q.number("pointed_diameter_mm", "diameter of the pointed tooth", "",
           "diameter at which the two flanks would meet (for an internal gear, inside the tip) "
           "[T2.13]; null if they do not meet",
           &Gear::pointed_diameter)
      .expected(has_involutes);
}

void add_flank_limits(Quantities<Gear>& q) {
  auto of_reference = q.part(reference_of);
  auto of_arcs = q.part(arcs_of_gear);
  auto of_involute_gear = q.part(involute_gear);
  q.under(kTooth);
  of_reference.term("normal_base_pitch_mm", "equal for both gears of a pair",
                    &Reference::base_pitch_normal);
  of_reference.term("transverse_base_pitch_mm", "π d_b/z", &Reference::base_pitch_transverse);
  q.flag("undercut", "undercut",
         "true if x_E is less than the minimum profile shift and no circular fillet replaces the "
         "root",
         &Gear::undercut)
      .shown([](const Gear& g) { return !g.internal(); });
  of_arcs
      .number("flank_begin_rack_angle_deg", "rack angle at the start of the flank", "τ",
              "normal angle at which the flank arc of the cutter begins; only for circular arcs",
              &ArcTeeth::flank_begin)
      .always()
      .when();
  of_arcs
      .number("undercut_limit_rack_angle_deg", "rack angle at the undercut limit", "",
              "normal angle at which the flank would have a cusp [T7.12]; null if there is no "
              "cusp; only for circular arcs",
              &ArcTeeth::undercut_limit)
      .when();
  of_involute_gear
      .number("undercut_free_profile_shift", "minimum profile shift coefficient", "x_Emin",
              "the least x_E without undercut, signed; null for a gear that is not cut by a rack",
              &Gear::undercut_free_shift)
      .expected();
  q.flag("pointed", "pointed",
         "true if the flanks meet before the tip (for an internal gear, outside the tip diameter)",
         &Gear::pointed)
      .doors(kJson);
  q.flag("severed", "cut through by undercut",
         "true if the root fillets of both flanks meet, so that there is no tooth",
         [](const Gear& g) { return g.tooth && g.tooth->severed; })
      .doors(kJson);
  q.flag("through_axis", "cutter passes the axis",
         "true if the cutter passes through the axis, so that there is no tooth",
         [](const Gear& g) { return g.tooth && g.tooth->through_axis; })
      .doors(kJson);
  q.flag("tip_cut_by_rack", "tip cut by the rack",
         "true if the tooth ends at the bottom land of the cutter, below the tip diameter of the "
         "blank",
         [](const Gear& g) { return g.tooth && g.tooth->tip_cut_by_rack; })
      .doors(kJson);
}

void add_fillets_and_body(Quantities<Gear>& q) {
  auto of_teeth = q.part(involute_of);
  auto of_root = q.part(fillet<&GeneratedTooth::root_fillet>);
  auto of_tip = q.part(fillet<&GeneratedTooth::tip_fillet>);
  auto of_bulge = q.part(maybe<&Gear::tip_bulge>);
  auto of_keyway = q.part(keyway);
  q.under(kRootFillet);
  of_root.number("root_fillet_radius_mm", "radius", "r_r", "null without a circular root fillet",
                 &FilletArc::radius);
  of_root.number("root_fillet_span_deg", "angle from the flank to the centre line of the space",
                 "σ_r", "null without a circular root fillet", &FilletArc::span);
  of_root
      .number("root_fillet_center_mm", "distance of the centre of the arc from the axis", "",
              "null without a circular root fillet", &FilletArc::distance)
      .doors(kPage);
  q.under(kTipFillet);
  of_tip.number("tip_fillet_radius_mm", "radius", "r_t",
                "radius of the circular tip fillet or of rounded tip corners; null without them",
                &FilletArc::radius);
  of_tip.number("tip_fillet_span_deg", "angle from the flank to the centre line of the tooth",
                "σ_t",
                "for rounded tip corners, angle from the flank to the tip land; null without a tip "
                "fillet",
                &FilletArc::span);
  of_tip
      .number("tip_fillet_center_mm", "distance of the centre of the arc from the axis", "",
              "null without a circular tip fillet", &FilletArc::distance)
      .doors(kPage);
  q.under(kUndercut);
  of_teeth
      .number("undercut_l_mm", "undercut limit F along the flank of the rack", "l_F",
              "< 0 without undercut; null for an internal gear", &InvoluteTeeth::undercut_l)
      .shown(is_undercut);
  q.under(kRootFillet);
  of_teeth.number("point_c_l_mm", "point C, where the root fillet touches the flank", "l_C",
                  "position along the flank of the rack; null without a circular root fillet",
                  &InvoluteTeeth::point_c_l);
  q.under(kTipFillet);
  of_teeth.number("point_j_l_mm", "point J, where the tip fillet touches the flank", "l_J",
                  "position along the flank of the rack; null without a circular tip fillet",
                  &InvoluteTeeth::point_j_l);
  q.under(kTooth);
  of_bulge
      .number("tip_bulge_mm", "tip beyond the involute", "",
              "distance along the flank normal by which the tip projects beyond the involute, if "
              "the flank of the cutter did not reach the tip",
              &TipBulge::amount)
      .when();
  of_bulge
      .number("tip_bulge_from_mm", "diameter at which the tip begins to project", "",
              "end of the part of the tooth that the flank of the cutter cuts",
              &TipBulge::from_diameter)
      .when();
  q.number("neck_thickness_mm", "root thickness at the neck (chord)", "",
           "chord at the neck, which is the place on the root fillets below the tip where the half "
           "angle of the tooth is least [T3.10]; 0 or negative if `severed`. On an undercut tooth, "
           "the least chord is up to a few percent shorter and lies nearer to the root",
           neck_thickness)
      .expected(has_involutes);
  q.under(kBody);
  q.part(maybe<&Gear::bore>)
      .number("bore_diameter_mm", "bore diameter", "", "in the CAD files; null without a bore",
              &Bore::diameter);
  of_keyway.number("keyway_width_mm", "keyway width", "", "null without a keyway",
                   &Bore::keyway_width);
  of_keyway.number("keyway_depth_mm", "keyway depth", "", "depth into the hub, from the bore",
                   &Bore::keyway_depth);
}

void add_gear(Quantities<Gear>& q) {
  q.groups({kTeeth, kDiameters, kTooth, kUndercut, kRootFillet, kTipFillet, kCutter});
  add_reference_data(q);
  add_sizes(q);
  add_flank_limits(q);
  add_fillets_and_body(q);
}

}  // namespace

const Quantities<Gear>& gear_quantities() { return define<add_gear>("gear"); }

const Quantities<Warning>& warning_quantities() {
  return define("warning", [](Quantities<Warning>& q) {
    q.text("code", "code for programs; it never changes",
           [](const Warning& w) { return to_string(w.code); });
    q.text("message", "sentence for users", &Warning::message);
    q.term("gear", "number of the gear, 1 or 2; null for the pair or the spec",
           [](const Warning& w) { return w.gear ? Value(w.gear) : Value(); });
  });
}

ValueRecord gear_record(const Gear& gear, const std::optional<Halves>& halves) {
  ValueRecord record = gear_quantities().of(gear);
  if (!halves) return record;
  for (Member& member : record)
    if (member.info->key == "face_width_mm") member.value = halves->face_width;
  return record;
}

const Quantities<Halves>& double_helical_quantities() {
  return define<add_halves>("double_helical");
}

}  // namespace gearwright
