// Writes the outline of a gear as SVG path data. The path of one tooth is written once, and the
// gear uses this path z times.
//
// Path units are kOutlineUnit normal modules. The numbers are integers relative to the preceding
// point, which keeps paths short. The y axis of the gear frame is reversed for SVG. Arcs about the
// axis of the gear (the lands) are circles. Other arcs are chains of chords, which are halved until
// they are within the tolerance.
#pragma once

#include <string>
#include <vector>

#include "gearwright/figure/svg.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

constexpr double kOutlineUnit = 5e-5;       ///< m_n; rounding moves a point by at most 0.71 units
constexpr double kOutlineTolerance = 1e-4;  ///< m_n; upper limit of the total deviation due to
                                            ///< chords and rounding

/// Returns points of an arc from root to tip, including both ends. The chords between the points
/// deviate from the arc by at most `tolerance`.
///
/// Units     mm
/// Accuracy  the deviation is measured at a quarter, half and three quarters of each chord's
///           parameter
std::vector<Vec2> chords(const Arc& arc, double tolerance);

/// Returns the path data of a chain of points, mm, in units of `unit_mm`.
std::string outline_path(const std::vector<Vec2>& points, double unit_mm);

/// Returns the path data of one tooth from the middle of one space to the middle of the next.
std::string tooth_path(const Gear& gear);

/// Returns the definitions of the shapes "NAME-tooth" and "NAME". "NAME" is the body of the gear
/// with its teeth. For an internal gear, the body is a rim. If a bore is given and is larger than
/// the root circle, the rim extends to the bore. Otherwise, the rim has the width kRim. The result
/// is empty if the gear has no outline.
std::string gear_definition(const Gear& gear, const std::string& name);

bool has_outline(const Gear& gear);

double outline_unit_mm(const Gear& gear);

/// Returns the largest drawn radius, mm: the tip, or the rim around the roots of an internal gear.
double drawn_radius(const Gear& gear);

}  // namespace gearwright
