#include "gearwright/report/contact_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "gearwright/base/contract.hpp"
#include "gearwright/report/html_text.hpp"

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

std::string pair_words(int k) { return k == 0 ? "0" : fmt::format("{:+d}", k); }

std::string shown_arcsec(double arcsec) {
  const double size = std::abs(arcsec);
  if (size < 5e-7) return "0";
  return fixed(arcsec, size >= 100 ? 1 : size >= 10 ? 2 : size >= 0.1 ? 3 : 6);
}

std::string contact_words(const ContactResult& contact) {
  if (contact.contact_lost) {
    return "At some positions no tooth pair touches: the teeth would part and strike. This "
           "pair needs a wider face, more teeth in mesh or smaller errors.";
  }
  const auto all = static_cast<double>(contact.positions.size());
  const auto count = [&](auto is) {
    return static_cast<double>(std::count_if(contact.positions.begin(), contact.positions.end(),
                                             [&](const ContactPoint& p) { return is(p.kind); }));
  };
  const double edges = count(is_edge) / all;
  const bool lines = count([](TouchKind k) { return k == TouchKind::line; }) == all;
  if (contact.peak_to_peak.arcsec() < kConjugate && edges == 0.0)
    return lines
               ? "Motion is transmitted exactly, and the flanks touch along lines across the face, "
                 "as intended."
               : "Motion is transmitted exactly, and the flanks touch as intended.";
  std::string text = fmt::format("While a tooth passes, gear 2 runs up to {}″ unevenly. ",
                                 shown_arcsec(contact.peak_to_peak.arcsec()));
  if (lines) return text + "The flanks touch along lines across the face: no edge carries.";
  if (edges == 0.0) {
    text += "The flanks always touch inside their limits: no edge carries.";
    const double ridges = count([](TouchKind k) { return k == TouchKind::ridge; }) / all;
    if (ridges > 0.0)
      text += fmt::format(" During {:.0f} % of the rotation they touch at the start of a relief.",
                          std::max(1.0, 100 * ridges));
    return text;
  }
  return text + fmt::format(
                    "During {:.0f} % of the rotation an edge touches where a flank should; "
                    "crowning or reliefs would bring the contact inside, or smaller errors.",
                    100 * edges);
}

std::string words_of(const NamedAmount& amount) {
  return fmt::format("{}{:.6g}{}{}", amount.value < 0.0 ? "−" : "+", std::abs(amount.value),
                     amount.unit == "°" ? "" : " ", amount.unit);
}

}  // namespace gearwright
