// Makes solids with several gears, and computes the volume of every kind of solid, for tests of the
// CAD files.
#pragma once

#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "gearwright/base/numbers.hpp"
#include "gearwright/cad/section.hpp"
#include "gearwright/cad/toothed_body.hpp"

namespace gearwright::testing {

/// Makes a solid with the second gear above the first, turned by `turn`. A cylinder with the length
/// `gap` and the radius `neck` joins both gears. Both gears have the bore of the first gear.
inline ToothedBody stacked(ToothedBody body, ToothedBody upper, double gap, double neck,
                           double turn) {
  const double top = body.gears().back().top();
  upper.bore = body.bore;
  upper.neck = neck;
  upper.height = top + gap + upper.face_width / 2.0;
  upper.turn = turn;
  body.above.push_back(std::move(upper));
  return body;
}

/// Returns the metal area times the face width. In a groove or a neck, the metal area is the ring
/// around the bore.
inline double exact_volume(const ToothedBody& body) {
  const double hole = body.bore ? bore_area(*body.bore) : 0.0;
  const auto ring = [&](double radius) { return std::abs(kPi * radius * radius - hole); };
  double volume = 0.0;
  for (const SolidGear& gear : body.gears()) {
    const auto& halves = gear.body->two_helices;
    const double gap = gear.body->grooved() ? halves->gap : 0.0;
    volume += metal_area(*gear.body) * (gear.body->face_width - gap);
    if (gap > 0.0) volume += ring(halves->groove_radius) * gap;
  }
  for (std::size_t i = 1; i < body.gears().size(); ++i)
    volume +=
        ring(body.gears()[i].body->neck) * (body.gears()[i].bottom() - body.gears()[i - 1].top());
  return volume;
}

}  // namespace gearwright::testing
