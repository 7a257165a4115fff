// What the page of a design search adds to the style of every page: the wide table, colours of the
// edges of a region, dots and curves of its charts.
#pragma once

#include <string_view>

namespace gearwright {

std::string_view search_style();

}  // namespace gearwright
