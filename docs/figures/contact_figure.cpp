// Page 8: the transmission error is the greatest of the branches of the tooth pairs. The example is a
// crowned helical pair on crossed shafts, over three pitches of gear 1. Below: the height on the face
// at which the leading pair touches.
#include <cmath>
#include <stdexcept>

#include "docs/figures/figure.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/pair/shift.hpp"

namespace gearwright::figures {

Figure contact_figure() {
  Figure f("08-contact", 860, 560,
           "Transmission error as the greatest of the tooth pairs' branches",
           "Rotation demanded by each tooth pair over three pitches with their upper envelope, and "
           "the height on "
           "the face at which the leading pair touches.");
  CylindricalSpec spec;
  spec.teeth = 21;
  spec.normal_module = 3;
  spec.helix_angle = Angle::degrees(12);
  spec.face_width = 26;
  const Gear one = gear_of(spec);
  spec.teeth = 55;
  spec.helix_angle = Angle::degrees(-12);
  const Gear two = gear_of(spec);
  FlankModifications crowning;
  crowning.lead_crowning = 0.008;
  crowning.profile_crowning = 0.004;
  const auto field = make_removal_field(crowning, {one.base_radius(), *one.root_form_radius(),
                                                   one.tip_form_radius(), one.spec.face_width});
  if (!field) throw std::logic_error(field.error().message());
  ContactMount place;
  place.center_distance =
      reference_center_distance(21, 55, spec.normal_module, std::cos(spec.helix_angle.rad()));
  place.errors.crossing = Angle::degrees(0.02);
  const ContactPair pair({&one, {&*field, &*field}}, {&two, {}}, place);

  // The branch of one tooth pair. The branches of the others are displaced by whole pitches [T8.2].
  Transmission transmission(pair);
  const double arcsec = Angle::radians(1).deg() * 3600;
  const double pitch = pair.pitch();
  std::vector<Vec2> branch, height;
  for (int i = -160; i <= 160; ++i) {
    const double phi = 2.0 * pitch * i / 160;
    const PairTouch touch = transmission.of_pair_0(phi);
    if (!touch.found()) continue;
    branch.push_back({phi / pitch, touch.te() * arcsec});
    const ContactPoint point = describe(transmission, touch, Angle::radians(phi), 0.006);
    height.push_back({phi / pitch, point.height[0]});
  }
  const Plot top{{-1.5, 1.5, 74, 838}, {-12, 4, 300, 36}};
  const Plot low{{-1.5, 1.5, 74, 838}, {-13, 13, 500, 356}};
  draw_frame(f, top, "",
             "rotation of gear 2 that a tooth pair demands, less the expected one: {T}, arcsec", 0,
             6);
  draw_frame(f, low, "rotation {φ1} of gear 1, pitches", "height {z} of the touch on the face, mm",
             6, 4);

  // The value of the branch at a rotation determines the leading pair there.
  const auto at = [&](const std::vector<Vec2>& curve, double x) {
    for (std::size_t i = 1; i < curve.size(); ++i) {
      if (curve[i - 1].x() > x || curve[i].x() < x) continue;
      const double share = (x - curve[i - 1].x()) / (curve[i].x() - curve[i - 1].x());
      return curve[i - 1].y() + share * (curve[i].y() - curve[i - 1].y());
    }
    return -1e9;
  };
  f.svg().begin_clip(74, 36, 764, 264);
  const char* styles[] = {"g1", "g2", "green"};
  for (int k = -3; k <= 3; ++k) {
    std::vector<Vec2> points;
    for (const Vec2& p : branch)
      if (std::abs(p.x() + k) < 1.6 && p.y() > -14) points.push_back(top.px(p.x() + k, p.y()));
    if (points.size() > 1) f.svg().polyline(points, styles[(k + 3) % 3]);
  }
  std::vector<Vec2> envelope;
  for (int i = -150; i <= 150; ++i) {
    double best = -1e9;
    for (int k = -3; k <= 3; ++k) best = std::max(best, at(branch, i / 100.0 - k));
    envelope.push_back(top.px(i / 100.0, best));
  }
  f.svg().polyline(envelope, "ink heavy");
  f.svg().end_group();
  for (int k = -2; k <= 2; ++k) {
    std::vector<Vec2> points;
    for (const Vec2& p : height) {
      const double x = p.x() + k;
      double best = -1e9;
      for (int j = -3; j <= 3; ++j) best = std::max(best, at(branch, x - j));
      if (std::abs(x) <= 1.5 && at(branch, p.x()) >= best - 1e-9)
        points.push_back(low.px(x, p.y()));
    }
    if (points.size() > 1) f.svg().polyline(points, std::string(styles[(k + 3) % 3]) + " thick");
  }
  f.label(top.px(0.02, -9.5), "{TE} = max over {k} of {T}({φ1} − 2π{k}/{z_1}) [T8.2]",
          Anchor::middle, {0, 4}, "halo");
  f.label({838, 52}, "21 : 55 teeth, {β} = 12°, crowned; axes crossed by 0.02°", Anchor::end,
          {-6, 0}, "soft small halo");
  return f;
}

}  // namespace gearwright::figures
