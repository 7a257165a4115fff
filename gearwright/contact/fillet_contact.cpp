#include "gearwright/contact/fillet_contact.hpp"

#include <cmath>

namespace gearwright {

namespace {

// Fillets that were cut to meet the flank do so to rounding.
constexpr double kTouching = 1e-8;  // mm

// Of the touch's normal about axis 2.
double arm_about_2(const ContactPair& pair, const ContactPoint& p) {
  const ContactMount& m = pair.place();
  const double sigma = m.shaft_angle.rad();
  const Vec3 axis(0.0, std::sin(sigma), std::cos(sigma));
  const Vec3 on_axis(m.center_distance + m.errors.center_distance, 0.0, 0.0);
  return std::abs((p.point - on_axis).cross(p.normal).dot(axis));
}

}  // namespace

std::optional<FilletContact> fillet_contact(const ContactPair& outlines,
                                            const std::array<double, 2>& form_diameter,
                                            const std::vector<ContactPoint>& flanks) {
  ContactRequest request;
  for (const ContactPoint& p : flanks)
    if (p.kind != TouchKind::none) request.rotations.push_back(p.rotation1);
  if (request.rotations.empty()) return std::nullopt;
  const ContactResult whole = analyse_contact(outlines, request);
  std::optional<FilletContact> worst;
  std::size_t at = 0;
  for (const ContactPoint& flank : flanks) {
    if (flank.kind == TouchKind::none) continue;
    const ContactPoint& p = whole.positions[at++];
    if (p.kind == TouchKind::none) continue;
    const double early = std::abs((p.te - flank.te).rad()) * arm_about_2(outlines, p);
    if (early <= kTouching || (worst && early <= worst->early)) continue;
    const bool ring = outlines.internal();
    const bool in_1 = p.diameter[0] < form_diameter[0];
    const bool in_2 = ring ? p.diameter[1] > form_diameter[1] : p.diameter[1] < form_diameter[1];
    if (in_1 || in_2) worst = FilletContact{in_1 ? 1 : 2, early, p};
  }
  return worst;
}

}  // namespace gearwright
