#include "gearwright/catalogue/rack_keys.hpp"

#include "gearwright/tool/arc_rack.hpp"
#include "gearwright/tool/double_arc_rack.hpp"
#include "gearwright/tool/straight_rack.hpp"

namespace gearwright {

namespace {

using Range = KeyRange;

constexpr std::size_t kMaxArcs = 100;  // more than any rack has

Range any_length() { return Range::between(-kMaxModules, kMaxModules); }
Range some_length() { return Range::above(0, kMaxModules); }
Range no_or_some_length(const char* reason = "") { return Range::between(0, kMaxModules, reason); }

Key kind(std::string_view word, std::string_view meaning, bool required) {
  return {.key = "kind",
          .kind = KeyKind::word,
          .words = {word},
          .required = required,
          .in_documents = false,
          .meaning = meaning};
}

}  // namespace

const KeyTable& straight_rack_keys() {
  static const KeyTable table{
      "rack",
      "A cutter with straight flanks; lengths in normal modules",
      {kind("straight", "straight flanks", false),
       {.key = "addendum",
        .symbol = "h_aP*",
        .range = no_or_some_length(),
        .place = &StraightRack::addendum,
        .fallback = "1",
        .meaning = "addendum of the gear tooth above the datum line",
        .also = {"addendum_factor"}},
       {.key = "dedendum",
        .symbol = "h_fP*",
        .range = some_length(),
        .place = &StraightRack::dedendum,
        .fallback = "1.25",
        .meaning = "how deep the cutter goes",
        .also = {"dedendum_factor"}},
       {.key = "root_fillet_radius",
        .symbol = "ρ_fP*",
        .range = no_or_some_length(" (0 is a sharp corner)"),
        .place = &StraightRack::root_fillet_radius,
        .fallback = "0.38",
        .meaning = "the cutter's tip rounding, which cuts the root fillet; 0 is a sharp corner",
        .also = {"fillet_radius", "root_radius", "tip_radius"}},
       {.key = "tip_fillet_radius",
        .symbol = "ρ_1*",
        .range = no_or_some_length(" (0 is none)"),
        .place = &StraightRack::tip_fillet_radius,
        .fallback = "0",
        .meaning = "the cutter's bottom rounding, which cuts a tip fillet"},
       {.key = "tool_addendum",
        .range = any_length(),
        .place = &StraightRack::tool_addendum,
        .fallback = "see below",
        .meaning = "height above the datum line at which the cutter's straight flank ends"},
       {.key = "semi_topping_angle_deg",
        .range = Range::inside(0, 90),
        .place = &StraightRack::semi_topping_angle,
        .needs = {"tool_addendum"},
        .fallback = "none",
        .meaning =
            "a ramp of this pressure angle, greater than α_n, from `tool_addendum` on, which "
            "cuts a tip chamfer; instead of `tip_fillet_radius`"},
       {.key = "protuberance",
        .symbol = "pr_P*",
        .range = no_or_some_length(" (0 is none)"),
        .place = &StraightRack::protuberance,
        .fallback = "0",
        .meaning = "how far the cutter's tip stands proud of its flank, normal to it"},
       {.key = "protuberance_angle_deg",
        .symbol = "α_pr",
        .place = &StraightRack::protuberance_angle,
        .fallback = "10",
        .meaning = "pressure angle of the proud part, greater than 0 and less than α_n"}}};
  return table;
}

const KeyTable& arc_rack_keys() {
  static const KeyTable table{
      "rack_circular_arc",
      "A rack with one circular arc for a flank: F cuts the convex teeth of one gear, P the "
      "concave "
      "ones of its mating gear; lengths in normal modules",
      {kind("circular_arc", "one circular arc for a flank", true),
       {.key = "cutter",
        .kind = KeyKind::word,
        .words = {"F", "P"},
        .place = &ArcRack::cutter,
        .required = true,
        .meaning = "`\"F\"` cuts convex teeth, `\"P\"` concave ones"},
       {.key = "arc_radius",
        .symbol = "ρ*",
        .range = some_length(),
        .place = &ArcRack::arc_radius,
        .required = true,
        .meaning = "radius of the flank's arc [T7.1] [T7.2]"},
       {.key = "center_a",
        .symbol = "a*",
        .range = any_length(),
        .place = &ArcRack::center_a,
        .required = true,
        .meaning = "how far the arc's centre lies beyond the middle"},
       {.key = "center_b",
        .symbol = "b*",
        .range = any_length(),
        .place = &ArcRack::center_b,
        .required = true,
        .meaning = "how far the arc's centre lies from the pitch plane"},
       {.key = "pressure_angle_deg",
        .symbol = "ψ_c",
        .place = &ArcRack::pressure_angle,
        .fallback = "not checked",
        .meaning = "what the drawing says of it: an error where the arc has no such point, a "
                   "warning (`pressure_angle`) where the pair touches elsewhere by more than 0.05° "
                   "[T7.9]"},
       {.key = "addendum",
        .symbol = "h_a*",
        .range = any_length(),
        .place = &ArcRack::addendum,
        .fallback = "F 0.9, P 0",
        .meaning = "addendum of the tooth above the pitch cylinder"},
       {.key = "dedendum",
        .symbol = "h_f*",
        .range = any_length(),
        .place = &ArcRack::dedendum,
        .fallback = "F 0.3, P 1.05",
        .meaning = "how deep the cutter goes"},
       {.key = "root_fillet_radius",
        .symbol = "ρ_r*",
        .range = no_or_some_length(" (0 is a sharp corner)"),
        .place = &ArcRack::root_fillet_radius,
        .fallback = "F 0.35, P 0.5; the full radius where that is less",
        .meaning = "the cutter's tip rounding [T7.4]; at most the full radius [T7.5]"}}};
  return table;
}

const KeyTable& double_arc_rack_keys() {
  static const KeyTable table{
      "rack_double_circular_arc",
      "Convex arc, step, concave arc and a full-radius root, in the symbols of GB/T 12759-1991; "
      "lengths in normal modules",
      {kind("double_circular_arc", "convex arc, step and concave arc", true),
       {.key = "concave_radius",
        .symbol = "ρ_f*",
        .range = some_length(),
        .place = &DoubleArcRack::concave_radius,
        .required = true,
        .meaning = "radius of the concave arc"},
       {.key = "concave_height",
        .symbol = "x_f*",
        .range = any_length(),
        .place = &DoubleArcRack::concave_height,
        .required = true,
        .meaning = "height of its centre over the datum line"},
       {.key = "space_width",
        .symbol = "e_f*",
        .range = some_length(),
        .place = &DoubleArcRack::space_width,
        .required = true,
        .meaning = "width of the space where the concave arc is touched"},
       {.key = "pressure_angle_deg",
        .symbol = "α",
        .range = Range::inside(0, 90, ", usually 24"),
        .place = &DoubleArcRack::pressure_angle,
        .fallback = "24",
        .meaning = "pressure angle where the arcs touch the mating gear's"},
       {.key = "addendum",
        .symbol = "h_a*",
        .range = some_length(),
        .place = &DoubleArcRack::addendum,
        .fallback = "0.9",
        .meaning = "addendum of the tooth above the datum line"},
       {.key = "dedendum",
        .symbol = "h_f*",
        .range = some_length(),
        .place = &DoubleArcRack::dedendum,
        .fallback = "1.1",
        .meaning = "how deep the cutter goes"},
       {.key = "convex_radius",
        .symbol = "ρ_a*",
        .range = some_length(),
        .place = &DoubleArcRack::convex_radius,
        .fallback = "1.3",
        .meaning = "radius of the convex arc"},
       {.key = "convex_height",
        .symbol = "x_a*",
        .range = any_length(),
        .place = &DoubleArcRack::convex_height,
        .fallback = "0.0163",
        .meaning = "height of its centre over the datum line"},
       {.key = "convex_offset",
        .symbol = "l_a*",
        .range = any_length(),
        .place = &DoubleArcRack::convex_offset,
        .fallback = "0.6289",
        .meaning = "how far its centre lies beyond the middle of the tooth"},
       {.key = "step_height",
        .symbol = "h_ja*",
        .range = some_length(),
        .place = &DoubleArcRack::step_height,
        .fallback = "0.16",
        .meaning = "height over the datum line at which the step begins"},
       {.key = "step_depth",
        .symbol = "h_jf*",
        .range = some_length(),
        .place = &DoubleArcRack::step_depth,
        .fallback = "0.2",
        .meaning = "depth under the datum line at which it ends"}}};
  return table;
}

const KeyTable& rack_of_arcs_keys() {
  static const KeyTable table{
      "rack_arcs",
      "Any chain of arcs from the cutter's tip on; lengths in normal modules",
      {kind("arcs", "any chain of arcs", true),
       {.key = "addendum",
        .symbol = "h_a*",
        .place = &RackOfArcs::addendum,
        .required = true,
        .meaning = "addendum of the gear's tooth above the datum line"},
       {.key = "dedendum",
        .symbol = "h_f*",
        .place = &RackOfArcs::dedendum,
        .required = true,
        .meaning = "how deep the cutter goes"},
       {.key = "arcs",
        .kind = KeyKind::table,
        .list = KeyList{1, kMaxArcs},
        .required = true,
        .tables = {rack_arc_keys},
        .meaning = "list of tables, one for each arc, from the cutter's tip on"}}};
  return table;
}

const KeyTable& rack_arc_keys() {
  static const KeyTable table{
      "rack_arc",
      "One arc of a rack's edge; lengths in normal modules",
      {{.key = "part",
        .kind = KeyKind::word,
        .words = {"root_fillet", "flank", "joint", "tip_fillet"},
        .place = &RackArcInput::part,
        .fallback = "\"flank\"",
        .meaning = "what it cuts; a joint lies between two flanks and touches nothing"},
       {.key = "center_height",
        .symbol = "x",
        .place = &RackArcInput::center_height,
        .required = true,
        .meaning = "height of the arc's centre over the datum line"},
       {.key = "center_offset",
        .symbol = "y",
        .place = &RackArcInput::center_offset,
        .required = true,
        .meaning = "distance of the arc's centre from the middle of the tooth"},
       {.key = "radius",
        .symbol = "q",
        .place = &RackArcInput::radius,
        .required = true,
        .meaning = "radius; > 0 cuts a convex part of the tooth, < 0 a concave one, 0 is a corner"},
       {.key = "begin_deg",
        .symbol = "τ",
        .place = &RackArcInput::begin,
        .required = true,
        .meaning = "normal angle at the root side"},
       {.key = "end_deg",
        .symbol = "τ",
        .place = &RackArcInput::end,
        .required = true,
        .meaning = "normal angle at the tip side"}}};
  return table;
}

}  // namespace gearwright
