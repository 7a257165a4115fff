// Page 8: the transmission error is the greatest of the branches of the tooth pairs. The example is
// a crowned helical pair on crossed shafts, over three pitches of gear 1. Below: the height on the
// face at which the leading pair touches.
#include <cmath>
#include <string>

#include "docs/figures/figure.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/figure/contact_scene.hpp"
#include "gearwright/pair/shift.hpp"

namespace gearwright::figures {

Drawing contact_figure() {
  Drawing f(
      "08-contact", 860, 560, "The transmission error is the greatest branch of all tooth pairs",
      "Rotation of gear 2 that each tooth pair requires over three pitches, the upper envelope of "
      "these branches, and the height on the face at which the leading pair touches.");
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
  // The value of the branch at a rotation determines the leading pair there.
  const auto at = [&](const std::vector<Vec2>& curve, double x) {
    for (std::size_t i = 1; i < curve.size(); ++i) {
      if (curve[i - 1].x() > x || curve[i].x() < x) continue;
      const double share = (x - curve[i - 1].x()) / (curve[i].x() - curve[i - 1].x());
      return curve[i - 1].y() + share * (curve[i].y() - curve[i - 1].y());
    }
    return -1e9;
  };
  // Three pitches of a quantity of each tooth pair.
  const auto plot = [](const char* id, const FigureAxis& y, double tall) {
    Figure f{
        id,
        y.words,
        y.words + " over the rotation of gear 1.",
        "",
        {.words = "rotation of gear 1", .unit = "pitches", .lo = -1.5, .hi = 1.5, .symbol = "φ_1"},
        y};
    f.tall = tall;
    return f;
  };
  Figure top =
      plot("branches",
           {.words = "rotation of gear 2 that a tooth pair requires, less the expected one",
            .unit = "arcsec",
            .lo = -12,
            .hi = 4,
            .symbol = "T"},
           0.31);
  Figure low = plot("height",
                    {.words = "height of the contact on the face",
                     .unit = "mm",
                     .lo = -13,
                     .hi = 13,
                     .symbol = "z"},
                    0.17);
  const auto leading = [&](double x) {
    double best = -1e9;
    for (int k = -3; k <= 3; ++k) best = std::max(best, at(branch, x - k));
    return best;
  };
  for (int k = -3; k <= 3; ++k) {
    const std::string style = std::string("curve ") + pair_style(k + 3);
    std::vector<Vec2> points, heights;
    for (const Vec2& p : branch) points.push_back({p.x() + k, p.y()});
    top.line(std::move(points), style);
    for (const Vec2& p : height)
      if (at(branch, p.x()) >= leading(p.x() + k) - 1e-9) heights.push_back({p.x() + k, p.y()});
    low.line(std::move(heights), style);
  }
  std::vector<Vec2> envelope;
  for (int i = -150; i <= 150; ++i) envelope.push_back({i / 100.0, leading(i / 100.0)});
  top.line(std::move(envelope), "curve ink");
  top.note = "21 : 55 teeth, β = 12°, crowned; axes crossed by 0.02°";
  top.text({0.0, 2.6}, markup("{TE} = max over {k} of {T}({φ_1} − 2π{k}/{z_1}) [T8.2]"),
           Anchor::middle, "halo");
  f.add(top, {0, 0}, 860);
  f.add(low, {0, 330}, 860);
  return f;
}

}  // namespace gearwright::figures
