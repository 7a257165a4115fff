#include "gearwright/contact/fillet_contact.hpp"

#include <cmath>

namespace gearwright {

namespace {

// Fillets that were cut to meet the flank do so to rounding.
constexpr double kTouching = 1e-8;  // mm

// With fillets a position costs several times the flanks alone, and 10⁶ may be asked.
constexpr std::size_t kMaxRotations = 64;

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
                                            std::span<const ContactPoint> flanks,
                                            Headway* headway) {
  std::vector<const ContactPoint*> touches;
  for (const ContactPoint& p : flanks)
    if (p.kind != TouchKind::none) touches.push_back(&p);
  if (touches.empty()) return std::nullopt;
  const std::size_t every = (touches.size() + kMaxRotations - 1) / kMaxRotations;
  ContactRequest request;
  request.headway = headway;
  for (std::size_t i = 0; i < touches.size(); i += every)
    request.rotations.push_back(touches[i]->rotation1);
  const ContactResult whole = analyse_contact(outlines, request);
  std::optional<FilletContact> worst;
  for (std::size_t i = 0; i < whole.positions.size(); ++i) {
    const ContactPoint& flank = *touches[i * every];
    const ContactPoint& p = whole.positions[i];
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
