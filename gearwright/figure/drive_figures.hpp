// Draws the kinematic scheme of a whole drive, its power flow, and its curves under load.
//
// Each body has its own colour, which is the same in all pictures of a drive.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gearwright/drive/drive_places.hpp"
#include "gearwright/figure/figure.hpp"

namespace gearwright {

/// Returns the class of a body's colour: "b0" to "b7", then "b0" again.
std::string body_style(std::size_t body);

/// Draws the scheme of the drive in a half section. It shows gears, shafts, fixed bodies, and
/// carriers with one planet of each kind. Speeds and torques are written at the ends of the shafts.
/// Coaxial shafts are drawn beside each other. Radii are to scale, but lengths are not. The words
/// are arranged for a picture with the width `width`, px.
Figure scheme_figure(const Drive& drive, const DrivePlaces& places, double width);

/// Draws the power flow from the inputs through bodies and meshes to the output. There is no figure
/// if no power flows or if the drive is self-locking.
std::optional<Figure> power_figure(const Drive& drive);

/// Draw the load share of each planet of a set over one period, and the displacement of the
/// floating body of the set. There is no second figure if the set has no floating body. The axis of
/// both figures is the rotation of the input.
///
/// Domain    a drive under load, index of one of its loaded sets (contract)
Figure planet_share_figure(const Drive& drive, std::size_t set);
std::optional<Figure> displacement_figure(const Drive& drive, std::size_t set);

/// Draws the transmission error of the output over one period, under load and with rigid teeth.
///
/// Domain    a drive under load, index of one of its curves (contract)
Figure loaded_output_figure(const Drive& drive, std::size_t curve);

/// Draws all figures of a drive under load. They show the shares and displacements of the sets with
/// several planets, and the transmission errors of the output. The result is empty without a load.
std::vector<Figure> drive_load_figures(const Drive& drive);

}  // namespace gearwright
