#include "gearwright/cad/drawing.hpp"

#include <fmt/format.h>

#include <utility>

namespace gearwright {

Result<BodyContour> body_contour(const ToothedBody& body) {
  if (body.rack) return BodyContour{rack_contour(body.outline, *body.rack), std::nullopt};
  auto teeth = closed_contour(body.outline);
  if (!teeth) return teeth.error();
  auto bore = bore_contour(body, teeth->inner_radius, teeth->outer_radius);
  if (!bore) return bore.error();
  return BodyContour{std::move(teeth).take(), std::move(bore).take()};
}

Error beyond_tolerance(const Arc& arc, double deviation_mm, double tolerance_mm) {
  return {"tolerance_mm", fmt::format("{}", tolerance_mm),
          fmt::format("the {} cannot be drawn with a tolerance of {} mm; a tolerance of at least "
                      "{:.3g} mm is needed",
                      to_string(arc.name), tolerance_mm, deviation_mm)};
}

}  // namespace gearwright
