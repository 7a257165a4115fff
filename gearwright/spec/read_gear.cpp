#include "gearwright/spec/read_gear.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "gearwright/gear/basic_root.hpp"
#include "gearwright/spec/once.hpp"
#include "gearwright/spec/read_arc_rack.hpp"
#include "gearwright/spec/read_cutting.hpp"
#include "gearwright/spec/read_modifications.hpp"

namespace gearwright {

StraightRack read_rack(TableReader& gear) {
  const Json* node = gear.any("rack");
  if (!node) return *iso53_rack("ISO53-A");
  if (node->is_string()) {
    const auto rack = iso53_rack(node->get<std::string>());
    if (!rack) {
      gear.fail("rack",
                "must be \"ISO53-A\", \"ISO53-B\", \"ISO53-C\", \"ISO53-D\", \"GBT12759\" or a "
                "table, [" +
                    gear.name("rack") + "]");
    }
    return *rack;
  }
  if (!node->is_object()) gear.fail("rack", "must be a name in quotes or a table");
  TableReader t(*node, gear.name("rack"));
  t.any("kind");  // the other kinds are racks of arcs
  StraightRack rack;
  if (auto v = t.number("addendum")) rack.addendum = *v;
  if (auto v = t.number("dedendum")) rack.dedendum = *v;
  if (auto v = t.number("root_fillet_radius")) rack.root_fillet_radius = *v;
  if (auto v = t.number("tip_fillet_radius")) rack.tip_fillet_radius = *v;
  rack.tool_addendum = t.number("tool_addendum");
  if (auto v = t.number("semi_topping_angle_deg")) rack.semi_topping_angle = Angle::degrees(*v);
  if (auto v = t.number("protuberance")) rack.protuberance = *v;
  if (auto v = t.number("protuberance_angle_deg")) rack.protuberance_angle = Angle::degrees(*v);
  t.finish();
  return rack;
}

namespace {

std::optional<Bore> read_bore(TableReader& gear) {
  const Json* node = gear.table("bore");
  if (!node) return std::nullopt;
  TableReader t(*node, gear.name("bore"));
  const auto diameter = t.positive("diameter_mm");
  const auto width = t.positive("keyway_width_mm");
  const auto depth = t.positive("keyway_depth_mm");
  t.finish();
  if (!diameter) t.fail("diameter_mm", "is missing: a bore needs its diameter");
  if (width.has_value() != depth.has_value()) {
    t.fail(width ? "keyway_depth_mm" : "keyway_width_mm",
           "is missing: a keyway needs width and depth");
  }
  if (width && *width >= *diameter) {
    t.fail("keyway_width_mm",
           fmt::format("must be less than the bore's diameter {} mm", *diameter));
  }
  return Bore{*diameter, width.value_or(0.0), depth.value_or(0.0)};
}

std::optional<double> read_helix(TableReader& t) {
  const auto beta = t.number("helix_angle_deg");
  const auto lead = t.number("lead_angle_deg");
  const auto hand = t.one_of("hand", {"right", "left"});
  if (beta && !(std::abs(*beta) < 90.0)) {
    t.fail("helix_angle_deg", "must lie between -90 (left hand) and 90 (right hand)");
  }
  if (lead && !(*lead > 0.0 && *lead <= 90.0)) {
    t.fail("lead_angle_deg", "must be greater than 0 and at most 90 (spur)");
  }
  if (lead && !hand && *lead < 90.0) {
    t.fail("lead_angle_deg", "needs hand = \"right\" or \"left\" beside it");
  }
  Once once(t, "helix angle");
  once.offer("helix_angle_deg", beta);
  if (lead) once.offer("lead_angle_deg", (90.0 - *lead) * (hand && *hand == "left" ? -1.0 : 1.0));
  const auto value = once.value();
  if (hand && value && *value != 0.0 && (*value > 0.0) != (*hand == "right")) {
    t.fail("hand", "contradicts the sign of helix_angle_deg (> 0 is a right hand)");
  }
  return value;
}

void read_measure(TableReader& gear, GearInput& g) {
  const Json* node = gear.table("measure");
  if (!node) return;
  TableReader t(*node, gear.name("measure"));
  g.chord_diameter = t.positive("chord_diameter_mm");
  for (const char* key : {"span_teeth", "ball_diameter_mm", "pin_diameter_mm"}) {
    if (t.has(key)) g.not_read.push_back(t.name(key));
  }
  t.finish();
}

std::optional<double> pressure_angle(TableReader& t, const char* key) {
  const auto value = t.number(key);
  if (value && !(*value > 0.0 && *value < 90.0))
    t.fail(key, "must lie between 0 and 90, usually 14.5 to 30");
  return value;
}

// α_n of the transverse angle α_t, both in degrees:  tan α_n = tan α_t cos β.
double normal_of_transverse(double alpha_t, double cos_beta) {
  return Angle::radians(std::atan(std::tan(Angle::degrees(alpha_t).rad()) * cos_beta)).deg();
}

// The gear as itself takes the place of module, helix and shift, which follow for one rack.
void read_basic(TableReader& gear, GearInput& g, int teeth, const Once& module, const Once& alpha) {
  const Json* node = gear.table("basic");
  if (!node) return;
  TableReader t(*node, gear.name("basic"));
  const auto d_b = t.positive("base_diameter_mm");
  const auto s_bt = t.number("base_tooth_thickness_mm");
  const auto beta_b = t.number("base_helix_angle_deg");
  const auto d_f = t.positive("root_diameter_mm");
  const auto d_Ff = t.positive("root_form_diameter_mm");
  t.finish();
  if (!d_b) t.fail("base_diameter_mm", "is missing: the diameter of the base cylinder");
  if (!s_bt)
    t.fail("base_tooth_thickness_mm",
           "is missing: the transverse tooth thickness (arc) on the base cylinder");
  if (d_Ff && !d_f) {
    t.fail("root_diameter_mm", "is missing: root_form_diameter_mm needs it beside it");
  }
  if (!(std::abs(beta_b.value_or(0.0)) < 89.0)) {
    t.fail("base_helix_angle_deg",
           "must lie between -89 and 89: steeper, no rack of 1° and more describes the gear");
  }
  for (const char* key : {"transverse_module_mm", "transverse_pressure_angle_deg"}) {
    if (gear.has(key))
      gear.fail(key, "has no place beside [" + gear.name("basic") +
                         "]; name the rack by its normal "
                         "module or pressure angle, or leave it out");
  }
  if (gear.has("thickness_allowance_mm")) {
    gear.fail("thickness_allowance_mm",
              "has no place beside [" + gear.name("basic") +
                  "], whose thickness is that of the tooth as cut; leave it out");
  }
  const BaseGear<double> base{teeth, *d_b / 2, *s_bt, Angle::degrees(beta_b.value_or(0.0)).rad()};
  const double m_cos_alpha = normal_base_pitch(base) / std::numbers::pi;
  double alpha_n = Angle::degrees(alpha.value().value_or(20.0)).rad();
  if (module.value()) {
    if (!(*module.value() > m_cos_alpha)) {
      gear.fail("normal_module_mm",
                fmt::format("is too small for this base pitch; m_n cos α_n is {} mm", m_cos_alpha));
    }
    const double of_module = std::acos(m_cos_alpha / *module.value());
    if (alpha.value() && std::abs(of_module - alpha_n) > kSameInput) {
      gear.fail("normal_module_mm",
                fmt::format("contradicts normal_pressure_angle_deg on this base cylinder: at {}° "
                            "the module is {} mm",
                            *alpha.value(), m_cos_alpha / std::cos(alpha_n)));
    }
    alpha_n = of_module;
  }
  if (!has_rack(base, alpha_n)) {
    gear.fail("normal_pressure_angle_deg",
              fmt::format(
                  "{:.9g}° has no rack with the base helix angle {}°; it must be less than {:.9g}°",
                  Angle::radians(alpha_n).deg(), beta_b.value_or(0.0),
                  90.0 - std::abs(beta_b.value_or(0.0))));
  }
  const ReferenceInput<double> rack = as_rack(base, alpha_n);
  const auto agrees = [&](const char* key, const std::optional<double>& given, double value) {
    if (!given || std::abs(*given - value) <= kSameInput * std::max(1.0, std::abs(value))) return;
    gear.fail(key, fmt::format("contradicts [{}], which makes it {}; leave one of them out",
                               gear.name("basic"), value));
  };
  agrees(gear.has("lead_angle_deg") ? "lead_angle_deg" : "helix_angle_deg",
         g.helix_given ? std::optional(g.cylindrical.helix_angle.deg()) : std::nullopt,
         Angle::radians(rack.helix_angle).deg());
  agrees("profile_shift", g.profile_shift, rack.profile_shift);
  CylindricalSpec& c = g.cylindrical;
  c.normal_module = rack.normal_module;
  c.normal_pressure_angle = Angle::radians(rack.normal_pressure_angle);
  c.helix_angle = Angle::radians(rack.helix_angle);
  g.helix_given = true;
  g.profile_shift = rack.profile_shift;
  g.basic = base;
  if (!d_f) return;
  c.profile_shift = rack.profile_shift;
  auto leaving = rack_leaving_root(c, *d_f, d_Ff);
  if (!leaving) {
    const Error& e = leaving.error();
    throw SpecError{{t.name(e.key), e.value, t.name(e.message)}};
  }
  c.rack = *leaving;
}

}  // namespace

GearInput read_gear(const Json& node, const std::string& path, const Json* mate,
                    const std::filesystem::path& folder) {
  TableReader t(node, path);
  GearInput g;
  CylindricalSpec& c = g.cylindrical;
  const auto teeth = t.integer("teeth");
  if (teeth && *teeth == 0) t.fail("teeth", "must not be 0; negative for an internal gear (ring)");
  const auto helix = read_helix(t);
  g.helix_given = helix.has_value();
  c.helix_angle = Angle::degrees(helix.value_or(0.0));
  const double cos_beta = std::cos(c.helix_angle.rad());
  Once module(t, "module");
  module.offer("normal_module_mm", t.positive("normal_module_mm"));
  const auto pitch = t.positive("normal_diametral_pitch_per_in");
  module.offer("normal_diametral_pitch_per_in",
               pitch ? std::optional(25.4 / *pitch) : std::nullopt);
  const auto m_t = t.positive("transverse_module_mm");
  module.offer("transverse_module_mm", m_t ? std::optional(*m_t * cos_beta) : std::nullopt);
  Once alpha(t, "pressure angle");
  alpha.offer("normal_pressure_angle_deg", pressure_angle(t, "normal_pressure_angle_deg"));
  const auto alpha_t = pressure_angle(t, "transverse_pressure_angle_deg");
  alpha.offer("transverse_pressure_angle_deg",
              alpha_t ? std::optional(normal_of_transverse(*alpha_t, cos_beta)) : std::nullopt);
  c.normal_pressure_angle = Angle::degrees(alpha.value().value_or(20.0));
  g.profile_shift = t.number("profile_shift");
  c.thickness_allowance = t.number("thickness_allowance_mm").value_or(0.0);
  const auto face = t.positive("face_width_mm");
  c.tip_diameter = t.positive("tip_diameter_mm");
  c.arc_rack = read_arc_rack(t, module);
  if (!c.arc_rack) c.rack = read_rack(t);
  read_fillets(t, g);
  if (const Json* by = t.any("cut_by"); by && by->is_object() && by->contains("modifications")) {
    t.fail(
        "cut_by.modifications",
        "a cutter has no flank modifications; those of the gear that it cuts stand beside cut_by");
  }
  read_cut_by(t, node, mate, g);
  g.modifications = read_modifications(t, folder);
  g.bore = read_bore(t);
  read_measure(t, g);
  if (t.has("measured")) g.not_read.push_back("[" + t.name("measured") + "]");
  if (teeth) {
    c.teeth = *teeth;
    read_basic(t, g, *teeth, module, alpha);
  } else {
    t.table("basic");
  }
  t.finish();
  // A misspelt key is named before the one that is missing because of it.
  if (!teeth)
    t.fail("teeth", "is missing: the number of teeth, negative for an internal gear (ring)");
  if (g.cut_by) {
    g.cut_by->module = module.value();
    g.cut_by->pressure_angle = alpha.value();
    c.normal_module = module.value().value_or(0.0);
  } else if (!g.basic) {
    c.normal_module = module.required();
  }
  g.face_width_given = face.has_value();
  c.face_width = face.value_or(10 * c.normal_module);
  return g;
}

}  // namespace gearwright
