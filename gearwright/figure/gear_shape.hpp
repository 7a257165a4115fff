// A gear's outline as SVG path data: one tooth is written once, the gear uses it z times.
//
// Path units are kOutlineUnit normal modules, as integers relative to the point before, which keeps
// paths short; the gear frame's y axis is turned over to SVG's. Arcs about the gear's axis (the
// lands) are circles, other arcs chains of chords, halved until they lie within the tolerance.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gearwright/figure/svg.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

constexpr double kOutlineUnit = 5e-5;       ///< m_n; rounding moves a point by at most 0.71 of it
constexpr double kOutlineTolerance = 1e-4;  ///< m_n; chords and rounding together stay within
constexpr double kRim = 2.5;                ///< m_n: metal drawn around internal roots

/// Points of an arc, root to tip, such that the chords stay within `tolerance`, both ends included.
///
/// Units     mm
/// Accuracy  the deviation is measured at a quarter, half and three quarters of each chord's
///           parameter
std::vector<Vec2> chords(const Arc& arc, double tolerance);

/// Path data of one arc of the tooth at the x axis; `side` +1 as generated (y > 0), −1 mirrored.
std::string arc_path(const Gear& gear, const Arc& arc, int side);

/// Both sides of the tooth arc by arc in a window with x_up, each in the style of its name.
void draw_upright_arcs(Svg& svg, const Viewport& view, const Gear& gear,
                       const std::function<const char*(ArcName)>& style);

/// Path data of one tooth from the middle of one space to the middle of the next.
std::string tooth_path(const Gear& gear);

/// Definitions of the shapes "NAME-tooth" and "NAME" (the gear's body and its teeth; of an internal
/// gear a rim of kRim and its teeth). A gear that has no outline has none: empty.
std::string gear_definition(const Gear& gear, const std::string& name);

/// True if there is an outline to draw.
bool has_outline(const Gear& gear);

/// mm per path unit.
double outline_unit_mm(const Gear& gear);

/// The largest drawn radius, mm: the tip, or the rim around the roots of an internal gear.
double drawn_radius(const Gear& gear);

}  // namespace gearwright
