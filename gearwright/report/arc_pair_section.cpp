#include <fmt/format.h>

#include <cmath>

#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/figure_units.hpp"
#include "gearwright/figure/figure_svg.hpp"
#include "gearwright/figure/mesh.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/report_sections.hpp"
#include "gearwright/report/report_tables.hpp"

namespace gearwright {

namespace {

constexpr double kAspect = 520.0 / 440.0;

}  // namespace

Figure arc_mesh_figure(const ArcPair& pair, std::size_t which,
                       const std::array<std::string, 2>& shapes) {
  const ArcPairContact& contact = pair.contacts[which];
  const Vec3& at = contact.at.point;
  const double m = pair.gears[0].spec.normal_module;
  const Vec2 p(at.x(), at.y());
  const Vec2 half = 3.4 * m * Vec2(kAspect, 1.0);
  Figure f = plane_figure(
      fmt::format("contact{}", which + 1),
      fmt::format("Contact on the convex flank of gear {}", contact.convex_gear),
      fmt::format("Both gears in the transverse section {:.4g} mm from the middle of the face, "
                  "where the convex flank of gear {} touches the concave flank of its mating gear.",
                  at.z(), contact.convex_gear),
      {p - half, p + half});
  MeshScene scene{{&pair.gears[0], &pair.gears[1]}, &pair, nullptr, shapes};
  const auto d_w = pair.working_pitch_diameter();
  for (const std::size_t i : {0u, 1u}) {
    scene.circles[i] = {{"d_a", pair.gears[i].actual_tip_radius()},
                        {"d_w", d_w[i] / 2, " dashdot"},
                        {"d_f", pair.gears[i].root_diameter / 2, " dash"}};
  }
  const std::array<double, 2> angles = angles_at_contact(pair, contact);
  add_bodies(f, scene, {kDegPerRad * angles[0], kDegPerRad * angles[1]});
  f.line({{0.0, 0.0}, {pair.center_distance, 0.0}}, "thin dashdot");
  add_circles(f, scene, true);
  // Direction of the common normal, projected onto the transverse section.
  const Vec2 n = Vec2(contact.at.normal.x(), contact.at.normal.y()).normalized() * 1.6 * m;
  f.line({p - n, p + n}, "action-line");
  f.dot(p, 4.0, "mark action-dot");
  f.caption = fmt::format(
      ", section z = {} mm, gear 1 driving clockwise. {} {} Tip circles are full, working pitch "
      "circles dash-dotted and root circles dashed. The contact point moves along the face, "
      "parallel to the axes.",
      fixed(at.z(), kLengthDigits), caption_of_gears(), caption_key("action", "common normal"));
  return f;
}

std::array<double, 2> angles_at_contact(const ArcPair& pair, const ArcPairContact& contact) {
  const double z = contact.at.point.z();
  std::array<double, 2> angles{pair.gears[0].twist() * z,
                               pair.pose_2().turn() + pair.gears[1].twist() * z};
  // The concave gear is turned until its flank touches the flank of the convex gear.
  angles[contact.convex_gear == 1 ? 1 : 0] += contact.at.rotation_offset.rad();
  return angles;
}

std::string arc_pair_section(const ArcPair& pair, const std::array<std::string, 2>& shapes,
                             const FigureForm& form, std::string_view head) {
  std::string figures;
  for (std::size_t i = 0; i < pair.contacts.size(); ++i)
    figures += form.html(arc_mesh_figure(pair, i, shapes), kPlaneFigure);
  return fmt::format("<section class=\"pair\">\n{}{}{}</section>\n", head, side_by_side(figures),
                     pair_table(pair, form.units));
}

}  // namespace gearwright
