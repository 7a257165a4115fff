#include "gearwright/catalogue/gear_keys.hpp"

#include "gearwright/tool/arc_rack.hpp"
#include "gearwright/tool/double_arc_rack.hpp"
#include "gearwright/tool/rack_of_arcs.hpp"
#include "gearwright/tool/straight_rack.hpp"

namespace gearwright {

namespace {

constexpr std::size_t kMaxArcs = 100;  // more than any rack has

KeyRange any_length() { return KeyRange::between(-kMaxModules, kMaxModules); }
KeyRange some_length() { return KeyRange::above(0, kMaxModules); }
KeyRange no_or_some_length(const char* reason = "") {
  return KeyRange::between(0, kMaxModules, reason);
}

Key kind(std::string_view word, std::string_view meaning, std::string_view fallback = kRequired) {
  return Key::word("kind", {word}, KeyPlace::unused(), fallback, meaning).undocumented();
}

// Sets all values to the defaults for this cutter. Keys that are read later replace single values.
void set_cutter(ArcRack& rack, ArcRack::Cutter cutter) { rack = default_arc_rack(cutter); }

// If the default tip rounding exceeds the full radius, sets it to slightly less than the full
// radius. The difference is larger than the rounding errors of later checks.
std::optional<KeyFault> complete_arc_rack(ArcRack& rack, const KeyGiven& given) {
  constexpr double kInside = 1.0 - 1e-12;
  const double greatest = full_radius(rack);
  if (!given("root_fillet_radius") && greatest >= 0.0 && greatest < rack.root_fillet_radius)
    rack.root_fillet_radius = greatest * kInside;
  return std::nullopt;
}

enum class ArcPart { root_fillet, flank, joint, tip_fillet };

void set_part(RackArc& arc, ArcPart part) {
  arc.cuts = part == ArcPart::root_fillet  ? ArcName::root_fillet
             : part == ArcPart::tip_fillet ? ArcName::tip_fillet
                                           : ArcName::flank;
  arc.working = part == ArcPart::flank;
}

}  // namespace

const KeyTable& straight_rack_keys() {
  static const KeyTable table{
      "rack",
      "A cutter with straight flanks; lengths in normal modules",
      {kind("straight", "straight flanks", ""),
       Key::number("addendum", "h_aP*", no_or_some_length(), &StraightRack::addendum, "1",
                   "addendum of the gear tooth above the datum line")
           .with_also({"addendum_factor"}),
       Key::number("dedendum", "h_fP*", some_length(), &StraightRack::dedendum, "1.25",
                   "depth of the cutter below the datum line")
           .with_also({"dedendum_factor"}),
       Key::number("root_fillet_radius", "ρ_fP*", no_or_some_length(" (0 is a sharp corner)"),
                   &StraightRack::root_fillet_radius, "0.38",
                   "tip rounding of the cutter, which cuts the root fillet; 0 is a sharp corner")
           .with_also({"fillet_radius", "root_radius", "tip_radius"}),
       Key::number("tip_fillet_radius", "ρ_1*", no_or_some_length(" (0 is none)"),
                   &StraightRack::tip_fillet_radius, "0",
                   "bottom rounding of the cutter, which cuts a tip fillet"),
       Key::number("tool_addendum", "", any_length(), &StraightRack::tool_addendum,
                   "h_aP* − ρ_1* (1 − sin α_n); if `tip_fillet_radius` is 0, the straight flank "
                   "does not end",
                   "height above the datum line at which the straight flank of the cutter ends"),
       Key::number("semi_topping_angle_deg", "", KeyRange::inside(0, 90),
                   &StraightRack::semi_topping_angle, "none",
                   "pressure angle of a ramp that starts at `tool_addendum` and cuts a tip "
                   "chamfer; it must be greater than α_n, and it cannot be combined with "
                   "`tip_fillet_radius`")
           .with_needs({"tool_addendum"}),
       Key::number("protuberance", "pr_P*", no_or_some_length(" (0 is none)"),
                   &StraightRack::protuberance, "0",
                   "protuberance of the cutter tip beyond the flank, in the normal direction"),
       Key::number("protuberance_angle_deg", "α_pr", {}, &StraightRack::protuberance_angle, "10",
                   "pressure angle of the protuberance, greater than 0 and less than α_n")}};
  return table;
}

const KeyTable& arc_rack_keys() {
  static const KeyTable table{
      "rack_circular_arc",
      "A rack with one circular arc as flank; rack F cuts the convex teeth of one gear, and rack P "
      "the concave teeth of the mating gear; lengths in normal modules",
      {kind("circular_arc", "rack with one circular arc as flank"),
       Key::word("cutter", {"F", "P"}, KeyPlace::by<ArcRack, ArcRack::Cutter>(set_cutter),
                 kRequired,
                 "type of the rack; `\"F\"` cuts convex teeth, and `\"P\"` cuts concave teeth"),
       Key::number("arc_radius", "ρ*", some_length(), &ArcRack::arc_radius, kRequired,
                   "radius of the flank arc [T7.1] [T7.2]"),
       Key::number("center_a", "a*", any_length(), &ArcRack::center_a, kRequired,
                   "distance of the arc centre from the middle of the convex tooth (for `\"P\"`, "
                   "of the concave tooth space); > 0 if the centre and the arc are on opposite "
                   "sides of the middle"),
       Key::number("center_b", "b*", any_length(), &ArcRack::center_b, kRequired,
                   "distance of the arc centre from the pitch plane"),
       Key::number("pressure_angle_deg", "ψ_c", {}, &ArcRack::pressure_angle, "not checked",
                   "pressure angle on the drawing, used only as a check; there is an error if the "
                   "arc has no point with this angle, and a warning (`pressure_angle`) if the pair "
                   "touches at an angle that differs by more than 0.05° [T7.9]"),
       Key::number("addendum", "h_a*", any_length(), &ArcRack::addendum, "0.9 for F, 0 for P",
                   "addendum of the tooth above the pitch cylinder"),
       Key::number("dedendum", "h_f*", any_length(), &ArcRack::dedendum, "0.3 for F, 1.05 for P",
                   "depth of the cutter below the datum line"),
       Key::number("root_fillet_radius", "ρ_r*", no_or_some_length(" (0 is a sharp corner)"),
                   &ArcRack::root_fillet_radius,
                   "0.35 for F, 0.5 for P, or the full radius if it is smaller",
                   "tip rounding of the cutter [T7.4]; at most the full radius [T7.5]")},
      complete_arc_rack};
  return table;
}

const KeyTable& double_arc_rack_keys() {
  static const KeyTable table{
      "rack_double_circular_arc",
      "A rack with a convex arc, a step, a concave arc and a full-radius root, with the symbols of "
      "GB/T 12759-1991; lengths in normal modules",
      {kind("double_circular_arc", "rack with a convex arc, a step and a concave arc"),
       Key::number("concave_radius", "ρ_f*", some_length(), &DoubleArcRack::concave_radius,
                   kRequired, "radius of the concave arc"),
       Key::number("concave_height", "x_f*", any_length(), &DoubleArcRack::concave_height,
                   kRequired, "height of the centre of the concave arc above the datum line"),
       Key::number("space_width", "e_f*", some_length(), &DoubleArcRack::space_width, kRequired,
                   "width of the tooth space at the contact on the concave arc"),
       Key::number("pressure_angle_deg", "α", KeyRange::inside(0, 90, ", usually 24"),
                   &DoubleArcRack::pressure_angle, "24",
                   "pressure angle at the contact with the arcs of the mating gear"),
       Key::number("addendum", "h_a*", some_length(), &DoubleArcRack::addendum, "0.9",
                   "addendum of the tooth above the datum line"),
       Key::number("dedendum", "h_f*", some_length(), &DoubleArcRack::dedendum, "1.1",
                   "depth of the cutter below the datum line"),
       Key::number("convex_radius", "ρ_a*", some_length(), &DoubleArcRack::convex_radius, "1.3",
                   "radius of the convex arc"),
       Key::number("convex_height", "x_a*", any_length(), &DoubleArcRack::convex_height, "0.0163",
                   "height of the centre of the convex arc above the datum line"),
       Key::number("convex_offset", "l_a*", any_length(), &DoubleArcRack::convex_offset, "0.6289",
                   "distance of the centre of the convex arc from the middle of the tooth; > 0 if "
                   "the centre and the arc are on opposite sides of the middle"),
       Key::number("step_height", "h_ja*", some_length(), &DoubleArcRack::step_height, "0.16",
                   "height above the datum line at which the step begins"),
       Key::number("step_depth", "h_jf*", some_length(), &DoubleArcRack::step_depth, "0.2",
                   "depth below the datum line at which the step ends")}};
  return table;
}

const KeyTable& rack_of_arcs_keys() {
  static const KeyTable table{
      "rack_arcs",
      "Any chain of arcs, starting at the cutter tip; lengths in normal modules",
      {kind("arcs", "rack of any chain of arcs"),
       Key::number("addendum", "h_a*", {}, &RackOfArcs::addendum, kRequired,
                   "addendum of the gear tooth above the datum line"),
       Key::number("dedendum", "h_f*", {}, &RackOfArcs::dedendum, kRequired,
                   "depth of the cutter below the datum line"),
       {.key = "arcs",
        .kind = KeyKind::table,
        .list = KeyList{.most = kMaxArcs,
                        .must = "must be a list of 1 to {} tables, one for each arc, starting at "
                                "the cutter tip"},
        .place = &RackOfArcs::arcs,
        .required = true,
        .tables = {rack_arc_keys},
        .meaning =
            "arcs of the rack as a list of tables, one for each arc, starting at the cutter tip"}}};
  return table;
}

const KeyTable& rack_arc_keys() {
  static const KeyTable table{
      "rack_arc",
      "One arc of the edge of a rack; lengths in normal modules",
      {Key::word("part", {"root_fillet", "flank", "joint", "tip_fillet"},
                 KeyPlace::by<RackArc, ArcPart>(set_part), "\"flank\"",
                 "part of the tooth that the arc cuts; a joint is a part between two flanks and "
                 "has no contact"),
       Key::number("center_height", "x", {}, &RackArc::center_height, kRequired,
                   "height of the arc centre above the datum line"),
       Key::number("center_offset", "y", {}, &RackArc::center_offset, kRequired,
                   "distance of the arc centre from the middle of the tooth"),
       Key::number("radius", "q", {}, &RackArc::radius, kRequired,
                   "radius of the arc; > 0 cuts a convex part of the tooth, < 0 cuts a concave "
                   "part, and 0 is a corner"),
       Key::number("begin_deg", "τ", {}, &RackArc::begin, kRequired,
                   "normal angle at the root-side end of the arc"),
       Key::number("end_deg", "τ", {}, &RackArc::end, kRequired,
                   "normal angle at the tip-side end of the arc")}};
  return table;
}

}  // namespace gearwright
