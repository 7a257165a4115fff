#include "gearwright/job/arc_answer.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gearwright/base/angle.hpp"

namespace gearwright {

namespace {

double deg(double rad) { return Angle::radians(rad).deg(); }

Json vec(const Vec3& v) { return Json::array({v.x(), v.y(), v.z()}); }

// The semi-axis that a gap curvature leaves under the marking; none where the gap closes.
std::optional<double> semi_axis(double k) {
  return k > 0.0 ? std::optional(std::sqrt(2 * kMarking_mm / k)) : std::nullopt;
}

Json number(const std::optional<double>& v) { return v ? Json(*v) : Json(nullptr); }

double face(const ArcPair& p) {
  return std::min(p.gears[0].spec.face_width, p.gears[1].spec.face_width);
}

// The helix angle on the working pitch cylinder: tan β grows with the radius.
double working_helix(const ArcPair& p, std::size_t i) {
  const Gear& g = p.gears[i];
  return std::atan(std::tan(g.spec.helix_angle.rad()) * p.working_pitch_diameter()[i] /
                   g.reference.reference_diameter);
}

// The transverse angle of the rack's normal angle θ.
double transverse(const ArcPair& p, std::size_t i, double theta) {
  return std::atan(std::tan(theta) / std::cos(p.gears[i].spec.helix_angle.rad()));
}

Json contact_json(const ArcPair& p, const ArcPairContact& c) {
  const ArcContact& at = c.at;
  const auto tensor = [](const Mat2& k) {
    return Json::array({Json::array({k(0, 0), k(0, 1)}), Json::array({k(1, 0), k(1, 1)})});
  };
  const bool first = c.convex_gear == 1;
  const Mat2& k_1 = first ? at.curvature_convex : at.curvature_concave;
  const Mat2& k_2 = first ? at.curvature_concave : at.curvature_convex;
  const auto diameters = first ? std::array{2 * at.radius_convex, 2 * at.radius_concave}
                               : std::array{2 * at.radius_concave, 2 * at.radius_convex};
  return {{"convex_gear", c.convex_gear},
          {"rack_angle_deg", deg(at.theta)},
          {"nominal_rack_angle_deg",
           std::isnan(c.nominal_theta) ? Json(nullptr) : Json(deg(c.nominal_theta))},
          {"point_mm", vec(at.point)},
          {"normal", vec(at.normal)},
          {"contact_diameter_mm", {diameters[0], diameters[1]}},
          {"rotation2_offset_deg",
           deg(first ? at.rotation_offset : at.rotation_offset / p.gear_ratio())},
          {"curvature_per_mm", {{"gear1", tensor(k_1)}, {"gear2", tensor(k_2)}}},
          {"gap_curvature_per_mm", {at.gap[0], at.gap[1]}},
          {"ellipse",
           {{"marking_mm", kMarking_mm},
            {"semi_major_mm", number(semi_axis(at.gap[0]))},
            {"semi_minor_mm", number(semi_axis(at.gap[1]))},
            {"angle_deg", deg(at.angle)}}},
          {"transverse_radius_mm",
           {{"convex", at.transverse_radius_convex}, {"concave", at.transverse_radius_concave}}},
          {"transverse_radius_difference_mm",
           at.transverse_radius_concave - at.transverse_radius_convex},
          {"line_contact_radius_difference_mm", at.line_contact_difference}};
}

// The way of the first contact over the common face, and its mirror image on the other flanks.
Json line_json(const ArcPair& p) {
  if (p.contacts.empty()) return nullptr;
  const Vec3 at = p.first_contact().at.point;
  const double half = face(p) / 2 * (p.gears[0].spec.helix_angle.rad() > 0.0 ? 1.0 : -1.0);
  return {{"length_mm", face(p)},
          {"leading", {vec({at.x(), at.y(), -half}), vec({at.x(), at.y(), half})}},
          {"trailing", {vec({at.x(), -at.y(), half}), vec({at.x(), -at.y(), -half})}}};
}

Json backlash_json(const ArcPair& p) {
  if (!p.backlash_rotation) return nullptr;
  const auto& j = *p.backlash_rotation;
  const auto d_w = p.working_pitch_diameter();
  const double theta = p.first_contact().at.theta;
  return {{"normal_base_mm", p.backlash_normal},
          {"normal_mm", p.backlash_normal / std::cos(theta)},
          {"circumferential_mm", {j[0] * d_w[0] / 2, j[1] * d_w[1] / 2}},
          {"rotation_deg", {deg(j[0]), deg(j[1])}}};
}

}  // namespace

Json arc_pair_json(const ArcPair& p) {
  const bool touch = !p.contacts.empty();
  Json j;
  j["kind"] = "parallel_external";
  j["gear_ratio"] = p.gear_ratio();
  j["shaft_angle_deg"] = 0.0;
  j["center_distance_mm"] = p.center_distance;
  j["reference_center_distance_mm"] = p.reference_center_distance;
  j["backlash_free_center_distance_mm"] = nullptr;
  j["extended_center_distance_mm"] = nullptr;
  j["working_normal_pressure_angle_deg"] = nullptr;
  j["working_transverse_pressure_angle_deg"] = nullptr;
  if (touch) {
    const double theta = p.first_contact().at.theta;
    j["working_normal_pressure_angle_deg"] = deg(theta);
    j["working_transverse_pressure_angle_deg"] = {deg(transverse(p, 0, theta)),
                                                  deg(transverse(p, 1, theta))};
  }
  j["working_helix_angle_deg"] = {deg(working_helix(p, 0)), deg(working_helix(p, 1))};
  const auto d_w = p.working_pitch_diameter();
  j["working_pitch_diameter_mm"] = {d_w[0], d_w[1]};
  for (const char* key :
       {"pitch_plane_distance_mm", "min_face_width_mm", "min_face_width_both_flanks_mm",
        "minimum_center_distance", "contact_ratio_range"}) {
    j[key] = nullptr;
  }
  j["contact_ratio"] = p.contact_ratio;
  j["transverse_contact_ratio"] = 0.0;
  j["contact_ratio_true"] = touch ? Json(p.contact_ratio) : Json(nullptr);
  j["overlap_ratio"] = p.overlap_ratio;
  j["face_width_for_contact_mm"] = p.face_for_contact;
  j["line_of_action"] = line_json(p);
  j["interference"] = Json::array();
  for (const Warning& w : p.warnings) {
    if (w.code != "root" && w.code != "interference") continue;
    j["interference"].push_back({{"code", w.code},
                                 {"gear", w.gear ? Json(w.gear) : Json(nullptr)},
                                 {"message", w.message}});
  }
  j["tip_clearance_mm"] = {p.tip_clearance[0], p.tip_clearance[1]};
  j["specific_sliding"] = nullptr;
  j["efficiency"] = nullptr;
  j["backlash"] = backlash_json(p);
  j["arc_contacts"] = Json::array();
  for (const ArcPairContact& c : p.contacts) j["arc_contacts"].push_back(contact_json(p, c));
  return j;
}

}  // namespace gearwright
