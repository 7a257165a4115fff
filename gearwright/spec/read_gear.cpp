#include "gearwright/spec/read_gear.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "gearwright/catalogue/rack_keys.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/gear/basic_root.hpp"
#include "gearwright/spec/once.hpp"
#include "gearwright/spec/read_arc_rack.hpp"
#include "gearwright/spec/read_cutting.hpp"
#include "gearwright/spec/read_modifications.hpp"
#include "gearwright/spec/read_rating.hpp"

namespace gearwright {

StraightRack read_rack(TableReader& gear) {
  const Json* node = gear.any("rack");
  if (!node) return *iso53_rack("ISO53-A");
  if (node->is_string()) {
    const auto rack = iso53_rack(node->get<std::string>());
    if (!rack) {
      gear.fail("rack", fmt::format("must be \"{}\" or a table, [{}]",
                                    fmt::join(gear.keys().find("rack")->words, "\", \""),
                                    gear.name("rack")));
    }
    return *rack;
  }
  if (!node->is_object()) gear.fail("rack", "must be a name in quotes or a table");
  TableReader t(straight_rack_keys(), *node, gear.name("rack"));
  t.any("kind");  // the other kinds are racks of arcs
  StraightRack rack;
  t.read(rack);
  t.finish();
  return rack;
}

namespace {

std::optional<Bore> read_bore(TableReader& gear) {
  const Json* node = gear.table("bore");
  if (!node) return std::nullopt;
  TableReader t(bore_keys(), *node, gear.name("bore"));
  Bore bore{};
  t.read(bore);
  t.finish();
  if (bore.keyway_width >= bore.diameter) {
    t.fail("keyway_width_mm", fmt::format("must be less than the bore's diameter {} mm",
                                          format_number(bore.diameter)));
  }
  return bore;
}

std::optional<double> read_helix(TableReader& t) {
  const auto beta = t.number("helix_angle_deg");
  const auto lead = t.number("lead_angle_deg");
  const auto hand = t.word("hand");
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
  TableReader t(measure_keys(), *node, gear.name("measure"));
  t.read(g.measure);
  t.finish();
}

// Two numbers in order, lower first.
Ends ends_of(const TableReader& t, const std::string& key, const std::vector<double>& values) {
  for (const double v : values)
    if (std::abs(v) > kMaxInput)
      t.fail(key, fmt::format("must lie between -{0} and {0}", kMaxInput));
  if (!(values[0] <= values[1])) t.fail(key, "must be two numbers, the lower one first");
  return {values[0], values[1]};
}

void read_allowance(TableReader& t, GearInput& g) {
  const auto values = t.numbers("thickness_allowance_mm");
  if (!values) return;
  const Ends ends = ends_of(t, "thickness_allowance_mm", {values->front(), values->back()});
  g.cylindrical.thickness_allowance = values->size() == 1 ? ends[0] : (ends[0] + ends[1]) / 2;
  if (values->size() == 2) g.allowance_ends = ends;
}

void read_tolerance(TableReader& gear, GearInput& g) {
  const Json* node = gear.table("tolerance");
  if (!node) return;
  TableReader t(tolerance_keys(), *node, gear.name("tolerance"));
  const auto beside = g.tolerance.quality;
  t.read(g.tolerance);
  if (beside && g.tolerance.quality != beside)
    t.fail("quality", fmt::format("contradicts {} = {}; leave one of them out",
                                  gear.name("quality"), *beside));
  if (const auto values = t.numbers("span_mm")) g.tolerance.span = ends_of(t, "span_mm", *values);
  if (const auto values = t.numbers("over_balls_mm"))
    g.tolerance.over_balls = ends_of(t, "over_balls_mm", *values);
  if (const auto values = t.numbers("tip_diameter_deviations_mm"))
    g.tolerance.tip_deviations = ends_of(t, "tip_diameter_deviations_mm", *values);
  t.finish();
  const char* const given = g.tolerance.series       ? "thickness_series"
                            : g.tolerance.span       ? "span_mm"
                            : g.tolerance.over_balls ? "over_balls_mm"
                                                     : nullptr;
  if (given && gear.has("thickness_allowance_mm"))
    t.fail(given, fmt::format("has no place beside {}: both say how thick the teeth are; leave one "
                              "out",
                              gear.name("thickness_allowance_mm")));
}

// α_n of the transverse angle α_t, both in degrees:  tan α_n = tan α_t cos β.
double normal_of_transverse(double alpha_t, double cos_beta) {
  return Angle::radians(std::atan(std::tan(Angle::degrees(alpha_t).rad()) * cos_beta)).deg();
}

// The gear as itself takes the place of module, helix and shift, which follow for one rack.
void read_basic(TableReader& gear, GearInput& g, const Once& module, const Once& alpha) {
  const Json* node = gear.table("basic");
  if (!node) return;
  TableReader t(basic_keys(), *node, gear.name("basic"));
  BasicInput in;
  t.read(in);
  t.finish();
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
  const BaseGear<double> base{g.cylindrical.teeth, in.base_diameter / 2, in.base_tooth_thickness,
                              in.base_helix_angle.rad()};
  const double m_cos_alpha = normal_base_pitch(base) / std::numbers::pi;
  double alpha_n = Angle::degrees(alpha.value().value_or(20.0)).rad();
  if (module.value()) {
    if (!(*module.value() > m_cos_alpha)) {
      gear.fail("normal_module_mm",
                fmt::format("is too small for this base pitch; m_n cos α_n is {} mm",
                            format_number(m_cos_alpha, *module.value())));
    }
    const double of_module = std::acos(m_cos_alpha / *module.value());
    if (alpha.value() && std::abs(of_module - alpha_n) > kSameInput) {
      gear.fail("normal_module_mm",
                fmt::format("contradicts normal_pressure_angle_deg on this base cylinder: at {}° "
                            "the module is {} mm",
                            format_number(*alpha.value()),
                            format_number(m_cos_alpha / std::cos(alpha_n), *module.value())));
    }
    alpha_n = of_module;
  }
  if (!has_rack(base, alpha_n)) {
    const double asked = Angle::radians(alpha_n).deg();
    const double limit = 90.0 - std::abs(in.base_helix_angle.deg());
    gear.fail("normal_pressure_angle_deg",
              fmt::format("{}° has no rack with the base helix angle {}°; it must be less than {}°",
                          format_number(asked, limit), format_number(in.base_helix_angle.deg()),
                          format_number(limit, asked)));
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
  if (!leaving) throw SpecError{spelled(within(t.name(), leaving.error()))};
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
  Once module(t, "module");
  module.offer("normal_module_mm", t.number("normal_module_mm"));
  const auto pitch = t.number("normal_diametral_pitch_per_in");
  module.offer("normal_diametral_pitch_per_in",
               pitch ? std::optional(25.4 / *pitch) : std::nullopt);
  const auto m_t = t.number("transverse_module_mm");
  module.offer("transverse_module_mm", m_t ? std::optional(*m_t * cos_beta) : std::nullopt);
  Once alpha(t, "pressure angle");
  alpha.offer("normal_pressure_angle_deg", t.number("normal_pressure_angle_deg"));
  const auto alpha_t = t.number("transverse_pressure_angle_deg");
  alpha.offer("transverse_pressure_angle_deg",
              alpha_t ? std::optional(normal_of_transverse(*alpha_t, cos_beta)) : std::nullopt);
  c.normal_pressure_angle = Angle::degrees(alpha.value().value_or(20.0));
  const auto face = t.number("face_width_mm");
  const auto arcs = read_arc_rack(t, module);
  c.rack = arcs ? *arcs : Rack(read_rack(t));
  read_fillets(t, g);
  if (keys.find("cut_by")) {
    read_cut_by(t, node, mate, g);
    g.modifications = read_modifications(t, folder);
    if (const Json* node = t.table("material"))
      g.material = read_material(*node, t.name("material"));
  }
  g.bore = read_bore(t);
  read_measure(t, g);
  read_allowance(t, g);
  read_tolerance(t, g);
  t.table("measured");  // spec/read_measured.cpp
  if (t.has("teeth")) {
    read_basic(t, g, module, alpha);
  } else {
    t.table("basic");
  }
  if (!g.cut_by && !t.has("basic")) module.require();
  t.finish();
  if (g.cut_by) {
    g.cut_by->module = module.value();
    if (alpha.value()) g.cut_by->pressure_angle = Angle::degrees(*alpha.value());
    c.normal_module = module.value().value_or(0.0);
  } else if (!g.basic) {
    c.normal_module = *module.value();
  }
  g.face_width_given = face.has_value();
  c.face_width = face.value_or(10 * c.normal_module);
  return g;
}

}  // namespace gearwright
