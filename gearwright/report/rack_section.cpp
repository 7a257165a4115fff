#include "gearwright/report/rack_section.hpp"

#include <fmt/format.h>

#include <utility>

#include "gearwright/catalogue/rack_pair_quantities.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/rack_mesh.hpp"
#include "gearwright/report/table_builder.hpp"

namespace gearwright {

namespace {

constexpr double kRackWidth = 640.0;  // px
constexpr double kRackAspect = 640.0 / 560.0;

std::string rack_figure(const RackPair& pair, const std::string& shape) {
  auto made = rack_mesh_figure(pair, shape, kRackAspect);
  if (!made) {
    return fmt::format("<p><strong>The rack has no outline</strong>: {}</p>\n",
                       escaped(made.error().message()));
  }
  Figure figure = std::move(made).take();
  figure.caption = fmt::format(
      " C, with the pinion driving clockwise and the rack moving down. {} {} Tip circle and tip "
      "line are full, pitch circle and datum line dash-dotted, and the base circle is dashed. T is "
      "the base tangent point.",
      caption_key("action", "path of contact A–E"),
      caption_key("trailing", "line of action of the trailing flanks"));
  return figure_html(figure, kRackWidth);
}

std::string rack_table(const RackPair& pair, UnitSystem units) {
  TableBuilder rack("Rack data, symbols of ISO 21771", {"Rack"});
  rack.groups(
      text_groups(rack_quantities().table(), {rack_quantities().of(pair.rack)}, kPage, units));
  return rack.str();
}

std::string rack_pair_table(const RackPair& pair, UnitSystem units) {
  TableBuilder mesh("Rack and pinion, symbols of ISO 21771", {"Pinion", "Rack"});
  mesh.groups(
      text_groups(rack_pair_quantities().table(), {rack_pair_quantities().of(pair)}, kPage, units));
  return mesh.str();
}

}  // namespace

std::string rack_section(const RackPair& pair, const std::string& shape, UnitSystem units) {
  return "<section class=\"pair\">\n<h2>Rack and pinion</h2>\n" + rack_figure(pair, shape) +
         rack_pair_table(pair, units) + rack_table(pair, units) + "</section>\n";
}

}  // namespace gearwright
