#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gearwright/figure/gear_shape.hpp"
#include "gearwright/figure/mesh.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/page_parts.hpp"
#include "gearwright/report/pair_figures.hpp"

namespace gearwright {

namespace {

constexpr double kMeshAspect = 640.0 / 560.0;
constexpr double kLeastAspect = 420.0 / 360.0, kMostAspect = 420.0 / 120.0;

std::string about_ring(const Gear& gear_2) {
  if (!gear_2.internal()) return {};
  if (has_outline(gear_2)) {
    // gear_shape() draws the given outside diameter.
    if (gear_2.bore) return {};
    return fmt::format(" The internal gear is drawn with a rim of {:g} modules.", kRim);
  }
  return " <strong>The internal gear has no outline</strong>, because its cutter is not given. Its "
         "tip and root circles are drawn instead.";
}

}  // namespace

std::array<Figure, 2> mesh_figures(const InvolutePair& pair,
                                   const std::array<std::string, 2>& shapes) {
  const MeshScene scene = mesh_scene(pair, shapes);
  const Bounds window = mesh_window(scene, MeshFrame::mesh, kMeshAspect);
  Figure mesh = mesh_figure(scene, window);
  mesh.caption = fmt::format(
      " C, gear 1 driving clockwise. {} {} {} <span class=\"key turn-key\" hidden><i "
      "class=\"swatch touch\"></i>flanks in contact (after turning)</span> Tip circles are full, "
      "pitch circles dash-dotted and base circles dashed. T are the base tangent points.{}",
      caption_of_gears(), caption_key("action", "path of contact A–E"),
      caption_key("trailing", "line of action of the trailing flanks"), about_ring(pair.gears[1]));
  // The aspect ratio is chosen so that the picture is no higher than the pair needs.
  const Vec2 size = mesh_window(scene, MeshFrame::whole, kMostAspect).size();
  const double tall = mesh_window(scene, MeshFrame::whole, kLeastAspect).size().x();
  const double aspect = std::clamp(tall / size.y(), kLeastAspect, kMostAspect);
  Figure whole = whole_figure(scene, mesh_window(scene, MeshFrame::whole, aspect), window);
  whole.caption =
      fmt::format(", with centre distance {} mm. The frame marks the picture of the mesh.",
                  fixed(pair.center_distance, kLengthDigits));
  return {std::move(mesh), std::move(whole)};
}

std::string mesh_part(const InvolutePair& pair, const std::array<std::string, 2>& shapes,
                      const FigureForm& form, const std::string& below) {
  const auto [mesh, whole] = mesh_figures(pair, shapes);
  const std::string control = turn_control(pair), first = form.html(mesh, kWideFigure, control);
  if (first.empty())
    return side_by_side("<div>" + form.html(whole, kNarrowFigure, control) + "</div>\n" + below);
  return "<div class=\"figures mesh\">\n" + first + "<div>" + form.html(whole, kNarrowFigure) +
         below + "</div>\n</div>\n";
}

}  // namespace gearwright
