#include "gearwright/spec/read_gear.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/gear/basic_root.hpp"
#include "gearwright/spec/read_cutting.hpp"
#include "gearwright/spec/read_modifications.hpp"
#include "gearwright/spec/read_rack.hpp"

namespace gearwright {

namespace {

std::optional<double> read_helix(TableReader& t) {
  const auto beta = t.number("helix_angle_deg");
  const auto lead = t.number("lead_angle_deg");
  const auto hand = t.word("hand");
  if (lead && !hand && *lead < 90.0) {
    t.fail("lead_angle_deg", "needs hand = \"right\" or \"left\" beside it");
  }
  const double sign = hand && *hand == "left" ? -1.0 : 1.0;
  const auto of_lead = lead ? std::optional((90.0 - *lead) * sign) : std::nullopt;
  if (beta && of_lead && std::abs(*of_lead - *beta) > kSameInput * std::abs(*beta)) {
    t.fail("lead_angle_deg",
           "contradicts helix_angle_deg; both give the helix angle; leave one of them out");
  }
  const auto value = beta ? beta : of_lead;
  if (hand && value && *value != 0.0 && (*value > 0.0) != (*hand == "right")) {
    t.fail("hand", "contradicts the sign of helix_angle_deg (> 0 is a right hand)");
  }
  return value;
}

// Checks tolerances that repeat the gear's own keys.
void check_tolerance(TableReader& gear, const GearInput& g) {
  const Json* node = gear.table("tolerance");
  if (!node) return;
  const TableReader t(tolerance_keys(), *node, gear.name("tolerance"));
  const auto beside = gear.number("quality");
  if (beside && *g.tolerance.quality != *beside)
    t.fail("quality", fmt::format("contradicts {} = {}; leave one of them out",
                                  gear.name("quality"), *beside));
  const char* const given = g.tolerance.series       ? "thickness_series"
                            : g.tolerance.span       ? "span_mm"
                            : g.tolerance.over_balls ? "over_balls_mm"
                                                     : nullptr;
  if (given && gear.has("thickness_allowance_mm"))
    t.fail(given, fmt::format("cannot be combined with {}; both give the tooth thickness; leave "
                              "one of them out",
                              gear.name("thickness_allowance_mm")));
}

// The gear by its own dimensions replaces module, helix and shift, which follow for one rack.
void read_basic(TableReader& gear, GearInput& g, std::optional<double> module,
                std::optional<double> alpha) {
  const Json* node = gear.table("basic");
  if (!node) return;
  const auto in = read_table<BasicInput>(basic_keys(), *node, gear.name("basic"));
  for (const char* key : {"transverse_module_mm", "transverse_pressure_angle_deg"}) {
    if (gear.has(key))
      gear.fail(key, "has no place beside [" + gear.name("basic") +
                         "]; name the rack by its normal "
                         "module or pressure angle, or leave it out");
  }
  if (gear.has("thickness_allowance_mm")) {
    gear.fail("thickness_allowance_mm",
              "has no place beside [" + gear.name("basic") +
                  "], which gives the thickness of the tooth as cut; leave it out");
  }
  const BaseGear<double> base{g.cylindrical.teeth, in.base_diameter / 2, in.base_tooth_thickness,
                              in.base_helix_angle.rad()};
  const double m_cos_alpha = normal_base_pitch(base) / std::numbers::pi;
  double alpha_n = Angle::degrees(alpha.value_or(20.0)).rad();
  if (module) {
    if (!(*module > m_cos_alpha)) {
      gear.fail("normal_module_mm",
                fmt::format("is too small for this base pitch; m_n cos α_n is {} mm",
                            format_number(m_cos_alpha, *module)));
    }
    const double of_module = std::acos(m_cos_alpha / *module);
    if (alpha && std::abs(of_module - alpha_n) > kSameInput) {
      gear.fail("normal_module_mm",
                fmt::format("contradicts normal_pressure_angle_deg on this base cylinder: at {}° "
                            "the module is {} mm",
                            format_number(*alpha),
                            format_number(m_cos_alpha / std::cos(alpha_n), *module)));
    }
    alpha_n = of_module;
  }
  if (!has_rack(base, alpha_n)) {
    const double alpha_deg = Angle::radians(alpha_n).deg();
    const double limit = 90.0 - std::abs(in.base_helix_angle.deg());
    gear.fail("normal_pressure_angle_deg",
              fmt::format("no rack with {}° has the base helix angle {}°; it must be less than {}°",
                          format_number(alpha_deg, limit), format_number(in.base_helix_angle.deg()),
                          format_number(limit, alpha_deg)));
  }
  const ReferenceInput<double> rack = as_rack(base, alpha_n);
  const auto agrees = [&](const char* key, const std::optional<double>& given, double value) {
    if (!given || std::abs(*given - value) <= kSameInput * std::max(1.0, std::abs(value))) return;
    gear.fail(key, fmt::format("contradicts [{}], which makes it {}; leave one of them out",
                               gear.name("basic"), format_number(value, *given)));
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
  if (!in.root_diameter) return;
  c.profile_shift = rack.profile_shift;
  auto leaving = rack_leaving_root(c, *in.root_diameter, in.root_form_diameter);
  if (!leaving) throw SpecError{spelled(within(gear.name("basic"), leaving.error()))};
  c.rack = *leaving;
}

}  // namespace

GearInput read_gear(const KeyTable& keys, const Json& node, const std::string& path,
                    const Json* mate, const std::filesystem::path& folder) {
  TableReader t(keys, node, path);
  GearInput g;
  t.read(g);
  CylindricalSpec& c = g.cylindrical;
  const auto helix = read_helix(t);
  g.helix_given = helix.has_value();
  g.hand_given = t.has("hand");
  g.transverse_given = t.has("transverse_module_mm") || t.has("transverse_pressure_angle_deg");
  c.helix_angle = Angle::degrees(helix.value_or(0.0));
  const double cos_beta = std::cos(c.helix_angle.rad());
  const auto module = t.one_of("normal_module_mm", "module", cos_beta);
  const auto alpha = t.one_of("normal_pressure_angle_deg", "pressure angle", cos_beta);
  c.normal_pressure_angle = Angle::degrees(alpha.value_or(20.0));
  c.rack = read_rack(t, module);
  if (keys.find("cut_by")) {
    read_cut_by(t, node, mate, g);
  }
  if (keys.find("modifications")) g.modifications = read_modifications(t, folder);
  check_tolerance(t, g);
  t.table("measured");                                         // spec/read_measured.cpp
  if (keys.find("double_helical")) t.table("double_helical");  // spec/spec.cpp
  if (t.has("teeth")) {
    read_basic(t, g, module, alpha);
  } else {
    t.table("basic");
  }
  if (!module && !g.cut_by && !t.has("basic")) t.lacks_one_of("normal_module_mm", "module");
  t.finish();
  if (g.cut_by) {
    g.cut_by->module = module;
    if (alpha) g.cut_by->pressure_angle = Angle::degrees(*alpha);
    c.normal_module = module.value_or(0.0);
  } else if (!g.basic) {
    c.normal_module = *module;
  }
  g.complete_face_width();
  return g;
}

}  // namespace gearwright
