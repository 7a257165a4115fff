#include "gearwright/contact/fillet_contact.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace gearwright {

namespace {

// If `early` does not exceed this limit, it counts as a rounding error. Such errors occur where a
// fillet continues the flank.
constexpr double kTouching = 1e-8;  // mm

// The number of rotations is limited, because the user may request up to 10⁶ positions, and a
// position with fillets takes several times as long as a position without fillets.
constexpr std::size_t kMaxRotations = 64;

// Returns the lever arm of the contact normal about axis 2, mm.
double arm_about_2(const ContactPair& pair, const ContactPoint& p) {
  const ContactMount& m = pair.place();
  const double sigma = m.axis_angle.rad();
  const Vec3 axis(0.0, std::sin(sigma), std::cos(sigma));
  const Vec3 on_axis(m.center_distance + m.errors.center_distance, 0.0, 0.0);
  return std::abs((p.point - on_axis).cross(p.normal).dot(axis));
}

// Returns the gear whose root fillet touches at the point, or 0 if no fillet touches.
int gear_of_fillet(const ContactPair& outlines, const ContactPoint& p) {
  for (const int gear : {1, 2}) {
    const auto end = outlines.root_end(gear);
    if (!end) continue;
    const double radius = p.diameter[gear - 1] / 2;
    const double side = gear == 2 ? outlines.side() : 1.0;
    if (side * radius < side * *end) return gear;
  }
  return 0;
}

}  // namespace

FilletContacts fillet_contacts(const ContactPair& outlines, std::span<const ContactPoint> flanks,
                               Progress* progress) {
  std::vector<std::size_t> touches;
  for (std::size_t i = 0; i < flanks.size(); ++i)
    if (flanks[i].kind != TouchKind::none) touches.push_back(i);
  FilletContacts found;
  const std::size_t every = (touches.size() + kMaxRotations - 1) / kMaxRotations;
  ContactRequest request;
  request.progress = progress;
  for (std::size_t i = 0; i < touches.size(); i += every) {
    found.asked.push_back(touches[i]);
    request.rotations.push_back(flanks[touches[i]].rotation1);
  }
  if (touches.empty()) return found;
  found.whole = analyse_contact(outlines, request).positions;
  for (std::size_t i = 0; i < found.asked.size(); ++i) {
    const ContactPoint& flank = flanks[found.asked[i]];
    const ContactPoint& p = found.whole[i];
    if (p.kind == TouchKind::none) continue;
    const double early = std::abs((p.te - flank.te).rad()) * arm_about_2(outlines, p);
    if (early <= kTouching || (found.earliest && early <= found.earliest->early)) continue;
    const int gear = gear_of_fillet(outlines, p);
    if (gear != 0) found.earliest = FilletContact{gear, early, p};
  }
  return found;
}

}  // namespace gearwright
