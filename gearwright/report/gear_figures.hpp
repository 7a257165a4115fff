// Draws the pictures of one gear, which are the tooth, the root, and the tooth at other profile
// shifts. For a gear with few teeth, the root is compared with the root that the rack alone cuts.
//
//   F    point of the flank on the base circle (roll angle ξ = 0), where undercut begins
//   C, J where the circular root fillet and the circular tip fillet touch the flank
//   r_r, r_t  radii of the circular root fillet and of the circular tip fillet, mm
//   l    distance along the straight flank of the rack from its lower end, mm
//   x    profile shift         x_E  profile shift with the thickness allowance
//                                              theory: docs/theory/06-few-teeth.md
//
// `shape` is the name of the SVG definition of the gear (gear_shape.hpp). `name` is the name that
// the user sees: "Gear 1".
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/figure/figure.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

const char* arc_style(ArcName name);

/// Converts a point of the gear frame to a figure in which the tooth on the x axis points up. The
/// side y > 0 is on the right.
inline Vec2 upright(const Vec2& p) { return {p.y(), p.x()}; }

void add_upright_gear(Figure& figure, const Gear& gear, const std::string& shape,
                      std::string style);

void add_upright_arcs(Figure& figure, const Gear& gear,
                      const std::function<const char*(ArcName)>& style);

/// Writes the name of a circle about the axis of the upright gear into the right column. The height
/// of the name is the height at which the circle leaves the plot. Does nothing if this height is
/// outside the plot.
void lead_circle(Figure& figure, double radius, std::string_view symbol, int decimals);

/// Draws the tooth, pointing up, with its arcs in colours, the circles of the drawing and a legend.
///
/// Domain    the gear has an outline (contract)
Figure tooth_figure(const Gear& gear, const std::string& shape, const std::string& name);

/// Writes the figure of the tooth as HTML. If the gear has no outline, the result is a paragraph
/// with the reason.
std::string tooth_part(const Gear& gear, const std::string& shape, const std::string& name,
                       UnitSystem units);

/// True if the picture of the root is useful. The gear must be an external involute gear with an
/// outline, cut by a rack. It must also have a circular root fillet, undercut, or at most 12 teeth.
bool root_is_worth_a_picture(const Gear& gear);

/// Returns the gear as its rack alone would cut it, without circular fillets. Returns none if the
/// spec has no circular fillets, if a pinion cutter cuts the gear, or if the gear cannot be made
/// without the fillets.
std::optional<Gear> by_rack_alone(const Gear& gear);

/// Returns the point of the flank on the base circle, on the side y > 0, mm.
///
/// Formula   r_b e^{i ψ_b}, ψ_b = s_bt/d_b
Vec2 undercut_limit_point(const Gear& gear);

/// Draws the root of the tooth, without a caption.
///
/// Domain    root_is_worth_a_picture() (contract)
Figure root_plot(const Gear& gear, const std::string& shape, const std::string& name);

/// Draws the root with its caption. The result is empty if root_is_worth_a_picture() is false.
std::string root_figure(const Gear& gear, const std::string& shape, const std::string& name,
                        UnitSystem units = UnitSystem::mm);

/// The tooth at one profile shift.
struct ShiftedTooth {
  double shift;                 ///< x
  bool own;                     ///< true if this is the gear's own shift
  Gear rack_cut;                ///< the gear without circular fillets; may be impossible
  std::optional<Gear> rounded;  ///< with the circular root fillet; none if the fillet does not fit
};

/// True if the gear has at most 8 teeth, is cut by a rack, and has a circular root fillet or
/// undercut. For other gears, a picture does not help to choose the profile shift.
bool shift_is_worth_a_picture(const Gear& gear);

/// Returns the gear at x = 0.3, 0.5, 0.7, 0.9, 1.0 and at its own shift, sorted by x. Shifts that a
/// spec does not permit are omitted. The tip diameters result from the rack. A `rounded` gear has
/// the circular root fillet of the given gear, or by default a root fillet that begins at the
/// undercut limit. It has the tip fillet of the given gear if this tip fillet fits.
///
/// Domain    shift_is_worth_a_picture (contract)
std::vector<ShiftedTooth> shifted_teeth(const Gear& gear);

/// Draws the teeth of shifted_teeth(), all at the same scale. Each picture shows the root as the
/// rack cuts it and, if a circular root fillet fits, the root with this fillet. The result is empty
/// if shift_is_worth_a_picture() is false.
std::string shift_figures(const Gear& gear, const std::string& shape, const std::string& name);

}  // namespace gearwright
