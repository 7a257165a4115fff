#include "gearwright/report/contact_report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gearwright {

std::string contact_words(const ContactResult& contact, std::optional<Angle> span) {
  if (contact.contact_lost) {
    return "At some positions no tooth pair touches, so the teeth would separate and collide. This "
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
  std::string text = fmt::format("The transmission error is {} peak to peak. ",
                                 te_unit(contact.rack).text(span.value_or(contact.peak_to_peak)));
  if (lines) return text + "The flanks touch along lines across the face, and no edge touches.";
  if (edges == 0.0) {
    text += "The contact is always inside the flanks, and no edge touches.";
    const double ridges = count([](TouchKind k) { return k == TouchKind::ridge; }) / all;
    if (ridges > 0.0)
      text +=
          fmt::format(" During {:.0f} % of the rotation the flanks touch at the start of a relief.",
                      std::max(1.0, 100 * ridges));
    return text;
  }
  return text + fmt::format(
                    "During {:.0f} % of the rotation an edge touches instead of a flank. Crowning, "
                    "reliefs or smaller errors would keep the contact inside the flanks.",
                    100 * edges);
}

}  // namespace gearwright
