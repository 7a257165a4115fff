#include "gearwright/report/contact_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "gearwright/base/contract.hpp"

namespace gearwright {

double pitch_of(const ContactReport& report) {
  return 2 * std::numbers::pi / std::abs(report.gears[0]->spec.teeth);
}

const char* words_of(TouchKind kind) {
  switch (kind) {
    case TouchKind::none: return "no contact";
    case TouchKind::interior: return "inside both flanks";
    case TouchKind::line: return "along a line";
    case TouchKind::tip1: return "tip edge of gear 1";
    case TouchKind::tip2: return "tip edge of gear 2";
    case TouchKind::face1: return "end of face 1";
    case TouchKind::face2: return "end of face 2";
    case TouchKind::form1: return "foot of flank 1";
    case TouchKind::form2: return "foot of flank 2";
    case TouchKind::ridge: return "start of a relief";
    case TouchKind::corner: return "corner of a tooth";
  }
  contract_failed("postcondition", "known kind of contact", __FILE__, __LINE__);
}

FlankPlace place_on(const ContactAxis& axis, const Vec3& point) {
  const Vec3 from = point - axis.point;
  const double height = from.dot(axis.direction);
  return {height, (from - height * axis.direction).norm()};
}

std::vector<FlankPlace> ellipse_on(const ContactReport& report, const ContactPoint& p,
                                   std::size_t which) {
  if (!p.ellipse || !p.ellipse->semi_major) return {};
  constexpr int kCorners = 64;
  // The angle counts from the projection of axis 1, about the normal.
  const Vec3& axis_1 = report.axes[0].direction;
  const Vec3 e_1 = (axis_1 - p.normal * p.normal.dot(axis_1)).normalized();
  const Vec3 e_2 = p.normal.cross(e_1);
  const Vec3 major =
      std::cos(p.ellipse->angle.rad()) * e_1 + std::sin(p.ellipse->angle.rad()) * e_2;
  const Vec3 minor = p.normal.cross(major);
  const ContactAxis& axis = report.axes[which];
  const FlankPlace at = place_on(axis, p.point);
  const Vec3 radial = ((p.point - axis.point) - at.height * axis.direction).normalized();
  std::vector<FlankPlace> points;
  for (int k = 0; k < kCorners; ++k) {
    const double turn = 2 * std::numbers::pi * k / kCorners;
    const Vec3 d = *p.ellipse->semi_major * std::cos(turn) * major +
                   p.ellipse->semi_minor * std::sin(turn) * minor;
    points.push_back({at.height + d.dot(axis.direction), at.radius + d.dot(radial)});
  }
  return points;
}

std::string words_of(const NamedAmount& amount) {
  return fmt::format("{}{:.6g}{}{}", amount.value < 0.0 ? "−" : "+", std::abs(amount.value),
                     amount.unit == "°" ? "" : " ", amount.unit);
}

}  // namespace gearwright
