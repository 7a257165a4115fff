#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "gearwright/report/gear_shape.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/named_circles.hpp"
#include "gearwright/report/report_sections.hpp"
#include "gearwright/report/report_tables.hpp"

namespace gearwright {

namespace {

constexpr double kWidth = 520.0;
constexpr double kHeight = 440.0;

std::string contact_figure(const ArcPair& pair, std::size_t which,
                           const std::array<std::string, 2>& shapes) {
  const ArcPairContact& contact = pair.contacts[which];
  const Vec3& at = contact.at.point;
  const double m = pair.gears[0].spec.normal_module;
  const Viewport view{kWidth, kHeight, Vec2(at.x(), at.y()), kHeight / (6.8 * m)};
  Svg svg(
      fmt::format("contact{}", which + 1), kWidth, kHeight,
      fmt::format("The contact on the convex flank of gear {}", contact.convex_gear),
      fmt::format("Both gears in the transverse section {:.4g} mm from the middle of the face, "
                  "where the convex flank of gear {} touches the concave one of its mating gear.",
                  at.z(), contact.convex_gear));
  const std::array<double, 2> angles = angles_at_contact(pair, contact);
  const std::array<Vec2, 2> axes{Vec2(0.0, 0.0), Vec2(pair.center_distance, 0.0)};
  // Outlines are drawn after both bodies, so that both are visible where the teeth overlap.
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
  // The component of the normal in this section.
  const Vec2 n = Vec2(contact.at.normal.x(), contact.at.normal.y()).normalized() * 1.6 * m;
  const Vec2 p(at.x(), at.y());
  svg.line(view.px(p - n), view.px(p + n), "action-line");
  svg.dot(view.px(p), 4.0, "mark action-dot");
  return captioned(
      svg.str(),
      fmt::format(
          "<strong>Contact on the convex flank of gear {}</strong>, section z = {} mm, gear 1 "
          "driving clockwise. {} {} Tip circles full, working pitch circles dash-dot, root "
          "circles dashed. The point runs along the face, parallel to the axes.",
          contact.convex_gear, fixed(at.z(), kLengthDigits), caption_of_gears(),
          caption_key("action", "common normal")));
}

}  // namespace

std::array<double, 2> angles_at_contact(const ArcPair& pair, const ArcPairContact& contact) {
  const double z = contact.at.point.z();
  const Eigen::Isometry3d pose = pair.pose_2().isometry();
  std::array<double, 2> angles{pair.gears[0].twist() * z,
                               std::atan2(pose(1, 0), pose(0, 0)) + pair.gears[1].twist() * z};
  // The concave gear is turned relative to the convex one, so that the flanks touch.
  angles[contact.convex_gear == 1 ? 1 : 0] += contact.at.rotation_offset.rad();
  return angles;
}

std::string arc_pair_section(const ArcPair& pair, const std::array<std::string, 2>& shapes) {
  std::string figures;
  for (std::size_t i = 0; i < pair.contacts.size(); ++i) figures += contact_figure(pair, i, shapes);
  return fmt::format(
      "<section class=\"pair\">\n<h2>Pair</h2>\n<div class=\"figures\">{}</div>\n{}</section>\n",
      figures, pair_table(pair));
}

}  // namespace gearwright
