#include "gearwright/inspection/span.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gearwright {

namespace {

// d_M = √(d_b² + (W cos β_b)²). [T10.3]
double contact_diameter(const ReferenceGeometry<double>& g, double length) {
  return std::hypot(g.base_diameter, length * std::cos(g.base_helix_angle));
}

// Returns the length of the span whose contacts have this diameter. [T10.3]
double length_to(const ReferenceGeometry<double>& g, double diameter) {
  return leaf::curvature_at(diameter, g.base_diameter) / std::cos(g.base_helix_angle);
}

// Returns the real number k at which W_k has this length.
double teeth_of(const Gear& gear, double length) {
  const double pitch = gear.reference().base_pitch_normal;
  return 1.0 + (length - span_length(gear, 1)) / pitch;
}

Span span_of(const Gear& gear, const UsableFlank& flank, int k) {
  const ReferenceGeometry<double>& g = gear.reference();
  const double length = span_length(gear, k);
  const double d_M = contact_diameter(g, length);
  const double face = length * std::abs(std::sin(g.base_helix_angle));  // [T10.4]
  const ContactPlace place = length > 0.0 ? flank.place(d_M) : ContactPlace::below_flank;
  return {k, length, d_M, face, place, face <= gear.spec.face_width};
}

struct Teeth {
  int least, most;
};

// Returns the range of k for which the contacts lie on the usable flank and, if requested, within
// the face. If most < least, the range is empty.
Teeth touching_teeth(const Gear& gear, const UsableFlank& flank, bool within_face) {
  const ReferenceGeometry<double>& g = gear.reference();
  const double lo = teeth_of(gear, length_to(g, flank.least()));
  const double hi = teeth_of(gear, length_to(g, flank.greatest()));
  const int z = std::abs(gear.spec.teeth);
  Teeth range{static_cast<int>(std::clamp(std::floor(lo), 1.0, double(z))),
              static_cast<int>(std::clamp(std::ceil(hi), 1.0, double(z)))};
  const auto good = [&](int k) {
    const Span span = span_of(gear, flank, k);
    return within_face ? span.usable() : span.place == ContactPlace::usable;
  };
  while (range.least <= range.most && !good(range.least)) ++range.least;
  while (range.most >= range.least && !good(range.most)) --range.most;
  return range;
}

std::string range_text(const Gear& gear, const UsableFlank& flank) {
  const Teeth k = touching_teeth(gear, flank, true);
  const char* what = gear.internal() ? "tooth spaces" : "teeth";
  if (k.most < k.least)
    return fmt::format("no span over {} can be measured on this flank and face", what);
  return k.least == k.most ? fmt::format("{} {} can be measured", k.least, what)
                           : fmt::format("{} to {} {} can be measured", k.least, k.most, what);
}

}  // namespace

double span_length(const Gear& gear, int k) {
  const ReferenceGeometry<double>& g = gear.reference();
  const double cos_b = std::cos(g.base_helix_angle);
  // A span over k teeth consists of k − 1 pitches and one tooth. A span over k tooth spaces of an
  // internal gear is one tooth shorter than k pitches.
  const double side = gear.side();
  const double pitches = k - (1 + side) / 2;
  return cos_b * (pitches * g.base_pitch_transverse + side * g.base_tooth_thickness);
}

double thickness_per_span(const Gear& gear) {
  return gear.side() / std::cos(gear.spec.normal_pressure_angle.rad());
}

double practical_face_width(const Gear& gear, const Span& span) {
  const double rest = 1.2 + 0.018 * span.length;  // b_M  mm, along the flank
  return span.min_face_width + rest * std::cos(gear.reference().base_helix_angle);
}

Result<Span> span_over(const Gear& gear, int k) {
  const auto no = [&](const std::string& why) { return refused("span_teeth", k, why); };
  if (!straight_tools_fit(gear)) return no(kNoPlaneAnvils);
  const auto flank = measurable_flank(gear, "span_teeth", k);
  if (!flank) return flank.error();
  const int z = std::abs(gear.spec.teeth);
  if (k < 1 || k > z)
    return no(fmt::format("must lie between 1 and {}; {}", z, range_text(gear, *flank)));
  const Span span = span_of(gear, *flank, k);
  if (!(span.length > 0.0))
    return no("the flanks over this number of teeth do not face the anvils; " +
              range_text(gear, *flank));
  // For a number of teeth just outside the range, the function returns a span, so that a warning
  // can give its length.
  const Teeth on_flank = touching_teeth(gear, *flank, false);
  const bool near = k >= on_flank.least - 1 && k <= on_flank.most + 1;
  if (span.place == ContactPlace::beyond_tip && !near) {
    return no(
        fmt::format("the anvils would touch at a diameter of {} mm, beyond the tip at {} mm; {}",
                    format_number(span.contact_diameter, flank->tip),
                    format_number(flank->tip, span.contact_diameter), range_text(gear, *flank)));
  }
  return span;
}

std::optional<Span> usual_span(const Gear& gear) {
  const auto spans = usable_spans(gear, 1);
  return spans.empty() ? std::nullopt : std::optional(spans.front());
}

std::vector<Span> usable_spans(const Gear& gear, int most) {
  GW_EXPECTS(most >= 1);
  if (!straight_tools_fit(gear)) return {};
  const auto flank = usable_flank(gear);
  if (!flank) return {};
  const Teeth k = touching_teeth(gear, *flank, true);
  if (k.most < k.least) return {};
  // d_M increases with k, so the usual k is one of the two whole numbers next to the real k at
  // which d_M is the diameter of the V circle.
  const ReferenceGeometry<double>& g = gear.reference();
  const double d_v = std::max(v_circle_diameter(gear), g.base_diameter);
  const double real = teeth_of(gear, length_to(g, d_v));
  const auto off = [&](int n) { return std::abs(span_of(gear, *flank, n).contact_diameter - d_v); };
  const int below = static_cast<int>(std::clamp(std::floor(real), double(k.least), double(k.most)));
  const int above = std::min(below + 1, k.most);
  const int usual = off(above) < off(below) ? above : below;
  int first = std::max(k.least, usual - (most - 1) / 2);
  const int last = std::min(k.most, first + most - 1);
  first = std::max(k.least, last - most + 1);
  std::vector<Span> spans;
  for (int n = first; n <= last; ++n) spans.push_back(span_of(gear, *flank, n));
  return spans;
}

}  // namespace gearwright
