// The pictures of one gear: its tooth, the root of a gear with few teeth as it is and as the rack alone
// would cut it, and the tooth at other profile shifts.
//
//   F    where undercut begins: the flank on the base circle, ξ = 0
//   C, J where a circular root fillet and a circular tip fillet touch the flank
//   r_r, r_t  their radii, mm
//   l    mm along the rack's straight flank, from its lower end
//   x    profile shift         x_E  the same with the thickness allowance
//                                              theory: docs/theory/06-few-teeth.md
//
// `shape` is the name of the gear's definitions (gear_shape.hpp), `name` is for people: "Gear 1".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The classes of the page's style for an arc of that name.
const char* arc_style(ArcName name);

/// The tooth, upright, its arcs in colours, with the circles of the drawing and its legend; where there
/// is no outline, a paragraph with the reason.
std::string tooth_figure(const Gear& gear, const std::string& shape, const std::string& name);

/// Whether the picture of the root shows something: a circular root fillet, undercut, or at most 12
/// teeth, of a gear that a rack has cut and that has an outline.
bool root_is_worth_a_picture(const Gear& gear);

/// The same spec without circular fillets, as its rack cuts it; nothing when the spec has none, or
/// when there is no such gear.
std::optional<Gear> by_rack_alone(const Gear& gear);

/// The flank's point on the base circle, side y > 0, mm.
///
/// Formula   r_b e^{i ψ_b}, ψ_b = s_bt/d_b
Vec2 undercut_limit_point(const Gear& gear);

/// The root; empty where it shows nothing.
std::string root_figure(const Gear& gear, const std::string& shape, const std::string& name);

/// The tooth at one shift.
struct ShiftedTooth {
  double shift;                 ///< x
  bool own;                     ///< the gear's own shift
  Gear rack_cut;                ///< without circular fillets; may not exist
  std::optional<Gear> rounded;  ///< with the circular root fillet, where one fits
};

/// Whether shifting is the question: at most 8 teeth, cut by a rack, with a circular root fillet or
/// undercut.
bool shift_is_worth_a_picture(const Gear& gear);

/// The gear at x = 0.3, 0.5, 0.7, 0.9, 1.0 and its own shift, by growing x, with tips as the rack
/// has them. The root fillet is the gear's, else begins at the undercut limit; with it goes the
/// gear's tip fillet where one fits.
///
/// Domain    shift_is_worth_a_picture (contract)
std::vector<ShiftedTooth> shifted_teeth(const Gear& gear);

/// The tooth at those shifts, the root that the rack cuts and a circular one instead, to one scale;
/// empty where they show nothing.
std::string shift_figures(const Gear& gear, const std::string& shape, const std::string& name);

}  // namespace gearwright
