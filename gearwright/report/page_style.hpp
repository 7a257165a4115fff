// What the page looks like and how its pictures zoom: one style sheet, one script, both plain text.
#pragma once

#include <string_view>

namespace gearwright {

/// Light and dark by the reader's preference, paper always light. Colours: Okabe and Ito's set,
/// which people tell apart whatever their colour vision; nothing is said by colour alone.
std::string_view page_style();

/// Wheel zooms about the pointer, dragging moves, double click restores; keys + − 0 and arrows do
/// the same for a picture that has the focus. Without a script the pictures stand still and are
/// complete.
std::string_view page_script();

}  // namespace gearwright
