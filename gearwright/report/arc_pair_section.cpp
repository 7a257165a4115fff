#include "gearwright/report/arc_pair_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "gearwright/report/gear_shape.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/named_circles.hpp"
#include "gearwright/report/shown_values.hpp"
#include "gearwright/report/svg.hpp"
#include "gearwright/report/table_builder.hpp"

namespace gearwright {

using shown::angle;
using shown::length;
using shown::ratio;

namespace {

constexpr double kWidth = 520.0;
constexpr double kHeight = 440.0;
constexpr int kCurvatureDigits = 6;  // 1/mm

std::string contact_figure(const ArcPair& pair, std::size_t which,
                           const std::array<std::string, 2>& shapes) {
  const ArcPairContact& contact = pair.contacts[which];
  const Vec3& at = contact.at.point;
  const double m = pair.gears[0].spec.normal_module;
  const Viewport view{kWidth, kHeight, Vec2(at.x(), at.y()), kHeight / (6.8 * m)};
  Svg svg(fmt::format("contact{}", which + 1), kWidth, kHeight,
          fmt::format("The contact on the convex flank of gear {}", contact.convex_gear),
          fmt::format("Both gears in the transverse section {:.4g} mm from the middle of the face, "
                      "where the convex flank of gear {} touches the concave one of its mate.",
                      at.z(), contact.convex_gear));
  const std::array<double, 2> angles = angles_at_contact(pair, contact);
  const std::array<Vec2, 2> axes{Vec2(0.0, 0.0), Vec2(pair.center_distance, 0.0)};
  // Outlines after both bodies: where the teeth overlap, both are seen.
  for (const char* style : {"body g", "outline g"}) {
    for (const std::size_t i : {1, 0}) {
      const Gear& gear = pair.gears[i];
      svg.use(shapes[i], view.px(axes[i]), view.scale * outline_unit_mm(gear),
              Angle::radians(angles[i]).deg(), style + std::to_string(i + 1));
    }
  }
  svg.line(view.px({axes[0].x(), 0}), view.px({axes[1].x(), 0}), "thin dashdot");
  const auto d_w = pair.working_pitch_diameter();
  for (const std::size_t i : {0, 1}) {
    const std::string n = std::to_string(i + 1);
    draw_named_circles(svg, view, axes[i], i == 0 ? 1.0 : -1.0, i,
                       {{"d_a" + n, pair.gears[i].actual_tip_radius(), ""},
                        {"d_w" + n, d_w[i] / 2, " dashdot"},
                        {"d_f" + n, pair.gears[i].root_diameter / 2, " dash"}});
  }
  // The normal's part in this section.
  const Vec2 n = Vec2(contact.at.normal.x(), contact.at.normal.y()).normalized() * 1.6 * m;
  const Vec2 p(at.x(), at.y());
  svg.line(view.px(p - n), view.px(p + n), "action-line");
  svg.dot(view.px(p), 4.0, "mark action-dot");
  return fmt::format(
      "<figure>{}<figcaption><strong>Contact on the convex flank of gear {}</strong>, section z = "
      "{} mm, gear 1 driving clockwise. <span class=\"key\"><i class=\"swatch g1\"></i>gear "
      "1</span> <span class=\"key\"><i class=\"swatch g2\"></i>gear 2</span> <span "
      "class=\"key\"><i class=\"swatch action\"></i>common normal</span> Tip circles full, working "
      "pitch circles dash-dot, root circles dashed. The point runs along the face, parallel to the "
      "axes.</figcaption></figure>\n",
      svg.str(), contact.convex_gear, fixed(at.z(), kLengthDigits));
}

void add_contact(TableBuilder& t, const ArcPairContact& c) {
  const ArcContact& at = c.at;
  t.group(fmt::format("Contact on the convex flank of gear {}", c.convex_gear));
  t.common("Normal angle of the racks", "θ", "°", angle(at.theta));
  t.common("The same at the reference centre distance", "θ_0", "°",
           c.nominal_theta ? angle(*c.nominal_theta) : shown::none());
  t.common("Point at rotation 0", "x, y, z", "mm",
           length(at.point.x()) + ", " + length(at.point.y()) + ", " + length(at.point.z()));
  const bool first = c.convex_gear == 1;
  const double d_1 = 2 * (first ? at.radius_convex : at.radius_concave);
  const double d_2 = 2 * (first ? at.radius_concave : at.radius_convex);
  t.row("Diameter on which the teeth touch", "", "mm", {length(d_1), length(d_2)});
  t.common("Relative curvatures", "k_1, k_2", "1/mm",
           fixed(at.gap[0], kCurvatureDigits) + ", " + fixed(at.gap[1], kCurvatureDigits));
  t.common("Major axis of the contact ellipse to the axis", "", "°", angle(at.angle));
  t.common("Ratio of its axes", "", "",
           at.gap[0] > 0.0 ? ratio(std::sqrt(at.gap[1] / at.gap[0])) : shown::none());
  const double rho_1 = first ? at.transverse_radius_convex : at.transverse_radius_concave;
  const double rho_2 = first ? at.transverse_radius_concave : at.transverse_radius_convex;
  t.row("Radius of the transverse profile", "ρ", "mm", {length(rho_1), length(rho_2)});
  t.common("Difference, concave less convex", "Δρ", "mm",
           length(at.transverse_radius_concave - at.transverse_radius_convex));
  t.common("What it would be in line contact", "", "mm", length(at.line_contact_difference));
}

std::string pair_table(const ArcPair& p) {
  TableBuilder t("Pair data", {"Gear 1", "Gear 2"});
  t.group("Mounting");
  t.common("Centre distance", "a", "mm", length(p.center_distance));
  t.common("Reference centre distance", "a_d", "mm", length(p.reference_center_distance));
  t.common("Gear ratio", "u", "", ratio(p.gear_ratio()));
  const auto d_w = p.working_pitch_diameter();
  t.row("Working pitch diameter", "d_w", "mm", {length(d_w[0]), length(d_w[1])});
  t.row("Own tip to the mate’s root", "c", "mm",
        {length(p.tip_clearance[0]), length(p.tip_clearance[1])});
  t.group("Contact");
  t.common("Overlap ratio", "ε_β", "", ratio(p.overlap_ratio));
  if (p.contacts.size() > 1)
    t.common("Points of contact at a time, on average", "", "", ratio(p.contact_ratio));
  t.common("Face width for continuous contact", "b", "mm", length(p.face_for_contact));
  if (p.backlash_rotation) {
    t.common("Backlash along the normal", "j_bn", "mm", length(p.backlash_normal));
    t.row("Backlash: rotation, the mate held", "", "°",
          {angle((*p.backlash_rotation)[0]), angle((*p.backlash_rotation)[1])});
  }
  for (const ArcPairContact& c : p.contacts) add_contact(t, c);
  return t.str();
}

}  // namespace

std::array<double, 2> angles_at_contact(const ArcPair& pair, const ArcPairContact& contact) {
  const double z = contact.at.point.z();
  const Eigen::Isometry3d pose = pair.pose_2().isometry();
  std::array<double, 2> angles{pair.gears[0].twist() * z,
                               std::atan2(pose(1, 0), pose(0, 0)) + pair.gears[1].twist() * z};
  // The concave gear is turned against the convex one, so that the flanks touch.
  angles[contact.convex_gear == 1 ? 1 : 0] += contact.at.rotation_offset.rad();
  return angles;
}

std::string arc_pair_section(const ArcPair& pair, const std::array<std::string, 2>& shapes) {
  std::string figures;
  for (std::size_t i = 0; i < pair.contacts.size(); ++i) figures += contact_figure(pair, i, shapes);
  const char* frame =
      pair.contacts.size() == 1
          ? "<section class=\"pair\">\n<h2>Pair</h2>\n<div class=\"columns\"><div>{}</div><div>{}"
            "</div></div>\n</section>\n"
          : "<section class=\"pair\">\n<h2>Pair</h2>\n<div class=\"figures\">{}</div>\n{}"
            "</section>\n";
  return fmt::format(fmt::runtime(frame), figures, pair_table(pair));
}

std::string arc_verdict(const ArcPair& pair) {
  if (pair.contacts.empty())
    return "The gears are not of one lead: where they touch is a matter of contact analysis.";
  // A backlash that the report shows as 0.0000 mm is none.
  const double j = pair.backlash_normal;
  return fmt::format(
      "The pair runs: contact is continuous (overlap ratio {}), with {} per tooth and {}.",
      ratio(pair.overlap_ratio),
      pair.contacts.size() == 1 ? "one point of contact"
                                : fmt::format("{} points of contact", pair.contacts.size()),
      std::abs(j) < 0.5e-4 ? "no backlash" : "a normal backlash of " + length(j) + " mm");
}

}  // namespace gearwright
