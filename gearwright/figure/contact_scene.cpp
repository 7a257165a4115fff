#include "gearwright/figure/contact_scene.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/contact/contact_pair.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {

ContactScene contact_scene(const std::array<const Gear*, 2>& gears, const ContactPair& pair,
                           double marking, ContactResult driving) {
  const ContactMount& m = pair.place();
  const double sigma = m.axis_angle.rad();
  const ContactAxis axis_1{
      pair.in_housing(0.0, 0.0),
      pair.in_housing(pair.tilt() * FreeVector<Axis1>{Vec3(0, 0, pair.turned())})};
  const Vec3 direction_2(0, std::sin(sigma), std::cos(sigma));
  const ContactAxis axis_2{
      Vec3(m.center_distance + m.errors.center_distance, 0, 0) + m.middle[1] * direction_2,
      direction_2};
  const int positions = static_cast<int>(driving.positions.size());
  return {gears, {axis_1, axis_2}, m.gear2_drives, marking, positions, std::move(driving)};
}

void mirror_axes(ContactScene& scene) {
  for (ContactAxis& axis : scene.axes) {
    axis.point.z() = -axis.point.z();
    axis.direction.x() = -axis.direction.x();
    axis.direction.y() = -axis.direction.y();
  }
}

double pitch_of(const ContactScene& scene) {
  return 2 * std::numbers::pi / std::abs(scene.gears[0]->spec.teeth);
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
    case TouchKind::form1: return "root end of flank 1";
    case TouchKind::form2: return "root end of flank 2";
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

std::vector<FlankPlace> ellipse_on(const ContactScene& scene, const ContactPoint& p,
                                   std::size_t which) {
  if (!p.ellipse || !p.ellipse->semi_major) return {};
  constexpr int kCorners = 64;
  // The angle of the ellipse is measured about the normal, from the projection of axis 1.
  const Vec3& axis_1 = scene.axes[0].direction;
  const Vec3 e_1 = (axis_1 - p.normal * p.normal.dot(axis_1)).normalized();
  const Vec3 e_2 = p.normal.cross(e_1);
  const Vec3 major =
      std::cos(p.ellipse->angle.rad()) * e_1 + std::sin(p.ellipse->angle.rad()) * e_2;
  const Vec3 minor = p.normal.cross(major);
  const ContactAxis& axis = scene.axes[which];
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

std::string pair_words(int k) { return k == 0 ? "0" : with_minus(fmt::format("{:+d}", k)); }

const char* pair_style(int k) {
  constexpr std::array kPairs{"tp0", "tp1 bold", "tp2 fine"};
  return kPairs[static_cast<std::size_t>(((k % 3) + 3) % 3)];
}

std::string shown_arcsec(double arcsec) {
  return std::abs(arcsec) < 5e-7 ? "0" : fixed(arcsec, arcsec_decimals(arcsec));
}

int arcsec_decimals(double arcsec) {
  const double size = std::abs(arcsec);
  return size >= 100 ? 1 : size >= 10 ? 2 : size >= 0.1 ? 3 : 6;
}

TeUnit te_unit(const RackTravel& rack) {
  return rack ? TeUnit{kUmPerMm * rack.radius, " µm", "µm"}
              : TeUnit{kArcsecPerRad, "″", "arc seconds"};
}

std::string words_of(const NamedAmount& amount) {
  return with_minus(
      fmt::format("{:+.6g}{}{}", amount.value, amount.unit == "°" ? "" : " ", amount.unit));
}

}  // namespace gearwright
