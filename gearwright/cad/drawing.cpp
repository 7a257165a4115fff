#include "gearwright/cad/drawing.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "gearwright/cad/bore_walls.hpp"

namespace gearwright {

Result<std::optional<BoreContour>> bore_contour(const ToothedBody& body, double inner,
                                                double outer) {
  if (!body.bore) return std::optional<BoreContour>();
  if (const auto checked = make_bore(body, inner, outer); !checked) return checked.error();
  const double r = body.bore->diameter / 2.0;
  const double half = body.bore->keyway_width / 2.0;
  if (half == 0.0) return std::optional(BoreContour{r, false, {{r, 0.0}, {-r, 0.0}}, {1.0, 1.0}});

  // Two arcs from the keyway down to (0, −r) and up again, so that neither is more than half a
  // turn.
  const double y = std::sqrt((r - half) * (r + half));
  const double floor = r + body.bore->keyway_depth;
  const double bulge = std::tan((std::numbers::pi - std::asin(half / r)) / 4.0);
  return std::optional(
      BoreContour{r,
                  true,
                  {{-half, y}, {0.0, -r}, {half, y}, {half, floor}, {-half, floor}},
                  {bulge, bulge, 0.0, 0.0, 0.0}});
}

Error beyond_tolerance(const Arc& arc, double deviation_mm, double tolerance_mm) {
  return {"tolerance_mm", fmt::format("{}", tolerance_mm),
          fmt::format("the {} cannot be drawn within {} mm, only within {:.3g} mm; allow that much",
                      to_string(arc.name), tolerance_mm, deviation_mm)};
}

}  // namespace gearwright
