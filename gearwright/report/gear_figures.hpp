// The pictures of one gear: its tooth, the actual root of a gear with few teeth compared with the
// root cut by the rack alone, and the tooth at other profile shifts.
//
//   F    where undercut begins: the flank on the base circle, ξ = 0
//   C, J where a circular root fillet and a circular tip fillet touch the flank
//   r_r, r_t  their radii, mm
//   l    mm along the rack's straight flank, from its lower end
//   x    profile shift         x_E  the same with the thickness allowance
//                                              theory: docs/theory/06-few-teeth.md
//
// `shape` is the name of the gear's definitions (gear_shape.hpp). `name` is shown to users: "Gear
// 1".
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/figure/figure.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The classes of the page's style for an arc of that name.
const char* arc_style(ArcName name);

/// A point of the gear frame in a figure in which the tooth at the x axis is upright. The side y > 0
/// is on the right.
inline Vec2 upright(const Vec2& p) { return {p.y(), p.x()}; }

/// Adds the shape of the gear with a tooth upright.
void add_upright_gear(Figure& figure, const Gear& gear, const std::string& shape,
                      std::string style);

/// Adds both sides of the upright tooth arc by arc, each arc in the style of its name.
void add_upright_arcs(Figure& figure, const Gear& gear,
                      const std::function<const char*(ArcName)>& style);

/// Names the circle about the axis of the upright gear in the column at the right, at the point
/// where it leaves the plot, unless that point is outside the plot.
void lead_circle(Figure& figure, double radius, std::string markup);

/// The tooth, upright, with its arcs in colours, the circles of the drawing and a legend.
///
/// Domain    the gear has an outline (contract)
Figure tooth_figure(const Gear& gear, const std::string& shape, const std::string& name);

/// This figure for a page. If there is no outline, a paragraph gives the reason.
std::string tooth_part(const Gear& gear, const std::string& shape, const std::string& name);

/// True if the picture of the root is useful. The gear must be cut by a rack and have an outline,
/// and it must have a circular root fillet, undercut, or at most 12 teeth.
bool root_is_worth_a_picture(const Gear& gear);

/// The gear of the same spec without circular fillets, as cut by its rack. None if the spec has no
/// circular fillets or if there is no such gear.
std::optional<Gear> by_rack_alone(const Gear& gear);

/// The point of the flank on the base circle, side y > 0, mm.
///
/// Formula   r_b e^{i ψ_b}, ψ_b = s_bt/d_b
Vec2 undercut_limit_point(const Gear& gear);

/// The root; empty if it shows nothing of interest.
std::string root_figure(const Gear& gear, const std::string& shape, const std::string& name);

/// The tooth at one shift.
struct ShiftedTooth {
  double shift;                 ///< x
  bool own;                     ///< the gear's own shift
  Gear rack_cut;                ///< without circular fillets; may not exist
  std::optional<Gear> rounded;  ///< with the circular root fillet, where one fits
};

/// True if the choice of the shift matters: the gear has at most 8 teeth, is cut by a rack, and has
/// a circular root fillet or undercut.
bool shift_is_worth_a_picture(const Gear& gear);

/// The gear at x = 0.3, 0.5, 0.7, 0.9, 1.0 and its own shift, in the order of x, with tips as left
/// by the rack. The root fillet is that of the gear, or begins at the undercut limit. The tip
/// fillet of the gear is included if it fits.
///
/// Domain    shift_is_worth_a_picture (contract)
std::vector<ShiftedTooth> shifted_teeth(const Gear& gear);

/// The tooth at those shifts, with the root cut by the rack and with a circular one, at the same
/// scale. Empty if they show nothing of interest.
std::string shift_figures(const Gear& gear, const std::string& shape, const std::string& name);

}  // namespace gearwright
