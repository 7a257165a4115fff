// What a page looks like and how its pictures zoom: style sheets and a script, files of report/page/.
//
// The build turns each file there into the function of its name (cmake/gw_embed.cmake). The pages of
// turning.hpp and search_table.hpp have their scripts in the same way.
#pragma once

#include <string_view>

namespace gearwright {

/// Light and dark by the reader's preference, paper always light. Colours: Okabe and Ito's set,
/// which people tell apart whatever their colour vision; nothing is said by colour alone.
std::string_view page_style();

/// What the page of a design search adds: the wide table, colours of the edges of a region, dots and
/// curves of its charts. The colours are those of the page, which turn with light, dark and paper.
std::string_view search_style();

/// Wheel zooms about the pointer, dragging moves, double click restores; keys + − 0 and arrows do
/// the same for a picture that has the focus. Without a script the pictures stand still and are
/// complete.
std::string_view page_script();

}  // namespace gearwright
