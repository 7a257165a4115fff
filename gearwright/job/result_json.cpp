#include "gearwright/job/result_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "gearwright/job/arc_answer.hpp"
#include "gearwright/pair/drive.hpp"

namespace gearwright {

namespace {

double deg(double rad) { return Angle::radians(rad).deg(); }

Json optional(const std::optional<double>& value, double factor = 1.0) {
  return value ? Json(factor * *value) : Json(nullptr);
}

// A number of the reference geometry: one that only an involute gear has is NaN elsewhere.
Json of_involute(double value) { return std::isnan(value) ? Json(nullptr) : Json(value); }

Json point(const Point<Housing>& p) { return Json::array({p.r.x(), p.r.y(), p.r.z()}); }

Json line_json(const Pair& p) {
  Json line;
  line["length_mm"] = p.path_length();
  line["leading"] = {point(p.on_line_of_action(p.mesh.rho1_A)),
                     point(p.on_line_of_action(p.mesh.rho1_E))};
  line["trailing"] = {point(p.on_trailing_line(p.mesh.rho1_A)),
                      point(p.on_trailing_line(p.mesh.rho1_E))};
  return line;
}

// A…E by their distance from the pitch point along the line, and both curvature radii.
Json path_points(const Pair& p) {
  // Lengths along the line: in the transverse section, or in space where the axes cross.
  const double c = p.crossed() ? std::cos(p.input.gears[0].helix_angle) : 1.0;
  Json points = Json::object();
  const auto add = [&](const char* name, double rho1) {
    points[name] = {{"from_A_mm", (rho1 - p.mesh.rho1_A) / c},
                    {"from_pitch_point_mm", (rho1 - p.mesh.rho1_C) / c},
                    {"rho1_mm", rho1},
                    {"rho2_mm", p.mesh.rho2(rho1)},
                    {"point_mm", point(p.on_line_of_action(rho1))}};
  };
  add("A", p.mesh.rho1_A);
  add("B", p.mesh.rho1_B);
  add("C", p.mesh.rho1_C);
  add("D", p.mesh.rho1_D);
  add("E", p.mesh.rho1_E);
  return points;
}

Json place_json(const CrossedPlace& place) {
  return {{"center_distance_mm", place.center_distance},
          {"shaft_angle_deg", deg(place.shaft_angle)},
          {"working_normal_pressure_angle_deg", deg(place.normal_pressure_angle)}};
}

// What only crossed axes have.
void add_crossed(Json& j, const Pair& p) {
  for (const char* key : {"min_face_width_mm", "min_face_width_both_flanks_mm", "face_interval_mm",
                          "line_offset_mm", "minimum_center_distance", "contact_ratio_range"}) {
    j[key] = nullptr;
  }
  if (!p.crossed()) return;
  const FaceWidths<double>& f = *p.face_widths;
  j["min_face_width_mm"] = {f.one_flank[0], f.one_flank[1]};
  j["min_face_width_both_flanks_mm"] = {f.both_flanks[0], f.both_flanks[1]};
  j["face_interval_mm"] = {{"gear1", f.interval[0]}, {"gear2", f.interval[1]}};
  j["line_offset_mm"] = p.mesh.line_offset;
  if (p.least_distance) j["minimum_center_distance"] = place_json(*p.least_distance);
  if (!p.contact_ratio_range) return;
  const CrossedPlaces& r = *p.contact_ratio_range;
  j["contact_ratio_range"] = {{"working_normal_pressure_angle_deg",
                               {deg(r.lo.normal_pressure_angle), deg(r.hi.normal_pressure_angle)}},
                              {"center_distance_mm", {r.lo.center_distance, r.hi.center_distance}},
                              {"shaft_angle_deg", {deg(r.lo.shaft_angle), deg(r.hi.shaft_angle)}},
                              {"ends_at_90_deg_helix", r.limit}};
}

// Speeds of sliding at A, the pitch point of gear 1 and E, per radian of gear 1.
Json sliding_json(const Pair& p) {
  Json across = Json::array(), along = Json::array(), total = Json::array();
  for (const double rho1 : {p.mesh.rho1_A, p.mesh.rho1_C, p.mesh.rho1_E}) {
    const FlankSpeeds<double> w = flank_speeds(p.input, p.mesh, rho1);
    const double v_across = w.across[0] - w.across[1];
    const double v_along = w.along[0] - w.along[1];
    across.push_back(v_across);
    along.push_back(v_along);
    total.push_back(std::hypot(v_across, v_along));
  }
  return {{"across_teeth", across}, {"along_teeth", along}, {"total", total}};
}

}  // namespace

Json gear_json(const Gear& g) {
  const bool exists = g.exists();
  Json j;
  j["teeth"] = g.spec.teeth;
  j["kind"] = g.arcs                              ? "circular_arc"
              : g.cut_by && !g.cut_by->by_default ? "generated"
                                                  : "involute";
  j["cutter_teeth"] = g.cut_by ? Json(g.cut_by->cutter_teeth) : Json(nullptr);
  j["generating_center_distance_mm"] = g.cut_by ? Json(g.cut_by->distance) : Json(nullptr);
  j["normal_module_mm"] = g.spec.normal_module;
  j["normal_pressure_angle_deg"] =
      g.involute() ? Json(g.spec.normal_pressure_angle.deg()) : Json(nullptr);
  j["transverse_pressure_angle_deg"] = of_involute(deg(g.reference.transverse_pressure_angle));
  j["helix_angle_deg"] = g.spec.helix_angle.deg();
  j["base_helix_angle_deg"] = of_involute(deg(g.reference.base_helix_angle));
  j["profile_shift"] = g.involute() ? Json(g.spec.profile_shift) : Json(nullptr);
  j["generating_profile_shift"] = of_involute(g.reference.generating_profile_shift);
  j["face_width_mm"] = g.spec.face_width;
  j["lead_mm"] = g.lead == 0.0 ? Json(nullptr) : Json(g.lead);
  j["reference_diameter_mm"] = g.reference.reference_diameter;
  j["base_diameter_mm"] = of_involute(g.reference.base_diameter);
  j["tip_diameter_mm"] = g.tip_diameter;
  j["root_diameter_mm"] = g.root_diameter;
  j["root_form_diameter_mm"] = exists ? optional(g.root_form_radius(), 2.0) : Json(nullptr);
  j["tip_form_diameter_mm"] = !exists || (g.tooth && !g.tooth->tip_form_radius)
                                  ? Json(nullptr)
                                  : Json(2 * g.tip_form_radius());
  j["finished_tip_diameter_mm"] = exists ? Json(2 * g.actual_tip_radius()) : Json(nullptr);
  j["base_tooth_thickness_mm"] = of_involute(g.reference.base_tooth_thickness);
  j["reference_tooth_thickness_normal_mm"] =
      g.arcs ? optional(g.arcs->reference_thickness)
             : Json(g.reference.reference_tooth_thickness_normal);
  j["tip_tooth_thickness_normal_mm"] = optional(g.tip_tooth_thickness_normal);
  j["pointed_diameter_mm"] = optional(g.pointed_diameter);
  j["normal_base_pitch_mm"] = of_involute(g.reference.base_pitch_normal);
  j["transverse_base_pitch_mm"] = of_involute(g.reference.base_pitch_transverse);
  j["undercut"] = g.undercut;
  if (g.arcs) {
    j["flank_begin_rack_angle_deg"] = g.arcs->flank_begin.deg();
    j["undercut_limit_rack_angle_deg"] =
        g.arcs->undercut_limit ? Json(g.arcs->undercut_limit->deg()) : Json(nullptr);
  }
  j["undercut_free_profile_shift"] =
      g.internal() ? Json(nullptr) : optional(g.undercut_free_profile_shift);
  const GeneratedTooth* tooth = g.tooth ? &*g.tooth : nullptr;
  j["pointed"] = g.pointed();
  j["severed"] = tooth && tooth->severed;
  j["through_axis"] = tooth && tooth->through_axis;
  j["tip_cut_by_rack"] = tooth && tooth->tip_cut_by_rack;
  const auto fillet = [&](const char* name, const std::optional<FilletArc>& arc) {
    j[std::string(name) + "_radius_mm"] = arc ? Json(arc->radius) : Json(nullptr);
    j[std::string(name) + "_span_deg"] = arc ? Json(deg(arc->span)) : Json(nullptr);
  };
  fillet("root_fillet", tooth ? tooth->root_fillet : std::nullopt);
  fillet("tip_fillet", tooth ? tooth->tip_fillet : std::nullopt);
  j["undercut_l_mm"] = optional(g.undercut_l);
  j["point_c_l_mm"] = optional(g.point_c_l);
  j["point_j_l_mm"] = optional(g.point_j_l);
  j["neck_thickness_mm"] = tooth && tooth->neck_half_angle
                               ? Json(2 * *tooth->neck_radius * std::sin(*tooth->neck_half_angle))
                               : Json(nullptr);
  return j;
}

Json pair_json(const Pair& p) {
  const auto& sides = p.mesh.rack.sides;
  Json j;
  j["kind"] = p.crossed()                             ? "crossed"
              : p.kind == PairKind::parallel_external ? "parallel_external"
                                                      : "parallel_internal";
  j["gear_ratio"] = p.gear_ratio();
  j["shaft_angle_deg"] = deg(p.shaft_angle());
  j["center_distance_mm"] = p.center_distance;
  j["reference_center_distance_mm"] = p.reference_center_distance;
  j["backlash_free_center_distance_mm"] = optional(p.backlash_free_center_distance);
  j["extended_center_distance_mm"] = p.extended_center_distance;
  j["working_normal_pressure_angle_deg"] = deg(p.mesh.rack.normal_pressure_angle);
  j["working_transverse_pressure_angle_deg"] = {deg(sides[0].transverse_angle),
                                                deg(sides[1].transverse_angle)};
  j["working_helix_angle_deg"] = {deg(sides[0].helix_angle), deg(sides[1].helix_angle)};
  j["working_pitch_diameter_mm"] = {2 * sides[0].pitch_radius, 2 * sides[1].pitch_radius};
  j["pitch_plane_distance_mm"] = p.mesh.pitch_plane_distance;
  add_crossed(j, p);
  j["contact_ratio"] = p.contact_ratio();
  j["transverse_contact_ratio"] = optional(p.transverse_contact_ratio());
  j["contact_ratio_true"] = p.contact_ratio_true();
  j["overlap_ratio"] = p.crossed() ? Json(nullptr) : Json(p.mesh.overlap_ratio);
  j["line_of_action"] = line_json(p);
  j["base_tangent_distance_mm"] =
      p.mesh.base_tangent_distance / (p.crossed() ? std::cos(p.input.gears[0].helix_angle) : 1.0);
  j["path"] = path_points(p);
  j["interference"] = Json::array();
  for (const Interference& i : p.interference) {
    j["interference"].push_back(
        {{"code", i.code}, {"gear", i.gear}, {"amount", i.amount}, {"message", i.message}});
  }
  j["tip_clearance_mm"] = {p.tip_clearance[0], p.tip_clearance[1]};
  j["contact_root_diameter_mm"] = {optional(p.contact_root_diameter[0]),
                                   optional(p.contact_root_diameter[1])};
  j["form_clearance_mm"] = {optional(p.form_clearance[0]), optional(p.form_clearance[1])};
  j["fillet_clearance_mm"] = {optional(p.fillet_clearance[0]), optional(p.fillet_clearance[1])};
  j["tip_shortening_mm"] = p.tip_shortening;
  j["specific_sliding"] = {{"gear1", {optional(p.sliding_A.zeta_1), optional(p.sliding_E.zeta_1)}},
                           {"gear2", {optional(p.sliding_A.zeta_2), optional(p.sliding_E.zeta_2)}}};
  j["needed_face_width_mm"] = nullptr;
  j["approach_contact_ratio"] = nullptr;
  j["recess_contact_ratio"] = nullptr;
  j["axial_force_ratio"] = nullptr;
  j["backlash_per_center_distance"] = nullptr;
  if (!p.crossed()) {
    j["needed_face_width_mm"] = {{"total_1", optional(face_width_for_total(p, 1.0))},
                                 {"total_1_2", optional(face_width_for_total(p, 1.2))},
                                 {"overlap_1", optional(face_width_for_overlap(p))}};
    const auto parts = approach_and_recess(p);
    j["approach_contact_ratio"] = parts[0];
    j["recess_contact_ratio"] = parts[1];
    j["axial_force_ratio"] = axial_force(p);
    j["backlash_per_center_distance"] = backlash_per_distance(p);
  }
  j["sliding_velocity_mm_per_rad"] = sliding_json(p);
  j["efficiency"] = p.efficiency ? Json{{"gear1_drives", optional(p.efficiency->gear1_drives)},
                                        {"gear2_drives", optional(p.efficiency->gear2_drives)}}
                                 : Json(nullptr);
  const Backlash<double>& b = p.mesh.backlash;
  j["backlash"] = {{"normal_base_mm", b.normal_base},
                   {"normal_mm", b.normal},
                   {"circumferential_mm", {b.circumferential[0], b.circumferential[1]}},
                   {"rotation_deg", {deg(b.rotation[0]), deg(b.rotation[1])}}};
  if (p.kind == PairKind::parallel_internal) {
    j["internal"] = {{"involute_margin_mm", optional(p.involute_margin)},
                     {"trochoid_margin_deg", optional(p.trochoid_margin, 180 / std::numbers::pi)},
                     {"trimming_margin_deg", optional(p.trimming_margin, 180 / std::numbers::pi)}};
  }
  return j;
}

Json warnings_json(const std::vector<Warning>& warnings) {
  Json list = Json::array();
  for (const Warning& w : warnings) {
    list.push_back({{"code", w.code},
                    {"message", w.message},
                    {"gear", w.gear ? Json(w.gear) : Json(nullptr)}});
  }
  return list;
}

Json job_json(const SolvedJob& job) {
  Json j;
  if (!job.spec.title.empty()) j["title"] = job.spec.title;
  j["gears"] = Json::array();
  for (const Gear& g : job.gears) j["gears"].push_back(gear_json(g));
  if (job.pair) j["pair"] = pair_json(*job.pair);
  if (job.arc_pair) j["pair"] = arc_pair_json(*job.arc_pair);
  j["warnings"] = warnings_json(job.warnings);
  return j;
}

Json outline_json(const Outline& outline, int n) {
  GW_EXPECTS(!outline.arcs.empty());
  Json arcs = Json::array();
  for (const Arc& arc : outline.arcs) {
    Json points = Json::array();
    for (const Vec2& p : sample(arc, n)) points.push_back({p.x(), p.y()});
    arcs.push_back({{"name", to_string(arc.name)}, {"points", std::move(points)}});
  }
  return {{"arcs", std::move(arcs)}};
}

Json files_json(const std::vector<JobFile>& files) {
  Json list = Json::array();
  for (const JobFile& f : files) {
    list.push_back({{"file", f.path.filename().string()},
                    {"what", f.what},
                    {"max_deviation_um", optional(f.deviation_mm, 1e3)},
                    {"note", f.note}});
  }
  return list;
}

Json error_json(const Error& error) {
  return {{"error", {{"key", error.key}, {"value", error.value}, {"message", error.message}}}};
}

}  // namespace gearwright
