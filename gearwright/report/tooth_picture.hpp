// The tooth of one gear, upright, its arcs in colours, with the circles of the drawing.
#pragma once

#include <string>

#include "gearwright/gear/gear.hpp"

namespace gearwright {

/// The classes of the page's style for an arc of that name.
const char* arc_style(ArcName name);

/// A figure with the picture and its legend; where there is no outline, a paragraph that says why.
/// `shape` is the name of the gear's definitions (gear_shape.hpp), `name` is for people: "Gear 1".
std::string tooth_figure(const Gear& gear, const std::string& shape, const std::string& name);

}  // namespace gearwright
