#include "gearwright/spec/read_gear.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/subject.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/gear/basic.hpp"
#include "gearwright/tool/straight_rack.hpp"

namespace gearwright {

namespace {

std::optional<double> read_helix(TableReader& t) {
  const auto beta = t.number("helix_angle_deg");
  const auto lead = t.number("lead_angle_deg");
  const auto hand = t.word("hand");
  if (lead && !hand && *lead < 90.0) {
    t.fail("lead_angle_deg", "also needs hand = \"right\" or \"left\"");
  }
  const double sign = hand && *hand == "left" ? -1.0 : 1.0;
  const auto of_lead = lead ? std::optional((90.0 - *lead) * sign) : std::nullopt;
  if (beta && of_lead && std::abs(*of_lead - *beta) > kSameInput * std::abs(*beta)) {
    t.fail("lead_angle_deg",
           "contradicts helix_angle_deg, because both keys give the helix angle; leave out one of "
           "the two");
  }
  const auto value = beta ? beta : of_lead;
  if (hand && value && *value != 0.0 && (*value > 0.0) != (*hand == "right")) {
    t.fail("hand", "contradicts the sign of helix_angle_deg (> 0 means right hand)");
  }
  return value;
}

// Rejects a tolerance that contradicts or repeats a key of the gear.
void check_tolerance(TableReader& gear, const GearInput& g) {
  const Json* node = gear.table("tolerance");
  if (!node) return;
  const TableReader t(tolerance_keys(), *node, gear.name("tolerance"));
  const auto beside = gear.number("quality");
  if (beside && *g.tolerance.quality != *beside)
    t.fail("quality", fmt::format("contradicts {} = {}; leave out one of the two",
                                  gear.name("quality"), *beside));
  const char* const given = g.tolerance.series       ? "thickness_series"
                            : g.tolerance.span       ? "span_mm"
                            : g.tolerance.over_balls ? "over_balls_mm"
                                                     : nullptr;
  if (given && gear.has("thickness_allowance_mm"))
    t.fail(given, fmt::format("cannot be combined with {}, because both keys give the tooth "
                              "thickness; leave out one of the two",
                              gear.name("thickness_allowance_mm")));
}

// Reads [basic], which contains dimensions of the finished gear, and computes from them the module,
// the helix angle and the profile shift for a given rack.
void read_basic(TableReader& gear, GearInput& g, std::optional<double> module,
                std::optional<Angle> alpha) {
  const Json* node = gear.table("basic");
  if (!node) return;
  const auto in = read_table<BasicInput>(basic_keys(), *node, gear.name("basic"));
  for (const char* key : {"transverse_module_mm", "transverse_pressure_angle_deg"}) {
    if (gear.has(key))
      gear.fail(key, "cannot be combined with [" + gear.name("basic") +
                         "]; leave out this key, or give the normal module or the normal pressure "
                         "angle of the rack instead");
  }
  if (gear.has("thickness_allowance_mm")) {
    gear.fail("thickness_allowance_mm",
              "cannot be combined with [" + gear.name("basic") +
                  "], which gives the thickness of the tooth as cut; leave out this key");
  }
  const BaseGear<double> base{g.cylindrical.teeth, in.base_diameter / 2, in.base_tooth_thickness,
                              in.base_helix_angle.rad()};
  const double m_cos_alpha = normal_base_pitch(base) / std::numbers::pi;
  double alpha_n = alpha.value_or(Angle::degrees(20.0)).rad();
  if (module) {
    if (!(*module > m_cos_alpha)) {
      gear.fail("normal_module_mm", fmt::format("is too small for this base pitch; the module must "
                                                "be greater than m_n cos α_n = {}\u00a0mm",
                                                format_number(m_cos_alpha, *module)));
    }
    const double of_module = std::acos(m_cos_alpha / *module);
    if (alpha && std::abs(of_module - alpha_n) > kSameInput) {
      gear.fail("normal_module_mm",
                fmt::format("contradicts normal_pressure_angle_deg on this base cylinder, because "
                            "the module at {}° is {}\u00a0mm",
                            format_number(alpha->deg()),
                            format_number(m_cos_alpha / std::cos(alpha_n), *module)));
    }
    alpha_n = of_module;
  }
  if (!has_rack(base, alpha_n)) {
    const double alpha_deg = Angle::radians(alpha_n).deg();
    const double limit = 90.0 - std::abs(in.base_helix_angle.deg());
    gear.fail(
        "normal_pressure_angle_deg",
        fmt::format("a rack with a normal pressure angle of {}° cannot have a base helix angle of "
                    "{}°; the pressure angle must be less than {}°",
                    format_number(alpha_deg, limit), format_number(in.base_helix_angle.deg()),
                    format_number(limit, alpha_deg)));
  }
  const ReferenceInput<double> rack = as_rack(base, alpha_n);
  const auto agrees = [&](const char* key, const std::optional<double>& given, double value) {
    if (!given || std::abs(*given - value) <= kSameInput * std::max(1.0, std::abs(value))) return;
    gear.fail(key,
              fmt::format("contradicts [{}], which gives the value {}; leave out one of the two",
                          gear.name("basic"), format_number(value, *given)));
  };
  agrees(gear.has("lead_angle_deg") ? "lead_angle_deg" : "helix_angle_deg",
         g.helix_given ? std::optional(g.cylindrical.helix_angle.deg()) : std::nullopt,
         Angle::radians(rack.helix_angle).deg());
  agrees("profile_shift", g.given_shift(), rack.profile_shift);
  CylindricalSpec& c = g.cylindrical;
  c.normal_module = rack.normal_module;
  c.normal_pressure_angle = Angle::radians(rack.normal_pressure_angle);
  c.helix_angle = Angle::radians(rack.helix_angle);
  g.helix_given = true;
  g.give_shift(rack.profile_shift);
  g.basic = base;
  if (!in.root_diameter) return;
  auto leaving = rack_leaving_root(c, *in.root_diameter, in.root_form_diameter);
  if (!leaving) throw SpecError{spelled(within(gear.name("basic"), leaving.error()))};
  c.rack = *leaving;
}

// Rejects the keys of an involute gear that have no meaning for a rack of arcs.
void refuse_involute_keys(TableReader& gear) {
  const std::string why = "cannot be combined with a rack of arcs";
  for (const char* key : {"normal_pressure_angle_deg", "transverse_pressure_angle_deg"}) {
    gear.refuse(key, why + "; give the pressure angle of the arcs in [" + gear.name("rack") + "]");
  }
  for (const char* key : {"basic", "root_fillet", "tip_fillet"}) gear.refuse(key, why);
  const auto shift = gear.number("profile_shift");
  if (shift && *shift != 0.0)
    gear.fail("profile_shift",
              why + "; the positions of the arc centres determine the depth of the cutter");
}

// Returns the one of the possible tables of a key that the word `kind` in `node` selects. Without
// `kind`, returns the first table.
const KeyTable& kind_of_table(const Key& key, const Json& node, const std::string& path) {
  const auto it = node.find("kind");
  if (it == node.end()) return key.tables.front()();
  std::vector<std::string> words;
  for (const auto& table : key.tables) {
    words.emplace_back(table().find("kind")->words.front());
    if (it->is_string() && it->get<std::string>() == words.back()) return table();
  }
  TableReader(key.tables.front()(), node, path)
      .fail("kind", it->is_string() ? one_of_rule(it->get<std::string>(), words)
                                    : "must be a text in quotes");
}

// Returns the table of a cutter. The module and the angles that it omits are taken from the gear
// or, if the gear does not give them either, from the mating gear. The helix angle of the gear,
// `helix_deg`, is copied with the opposite hand or, for an internal gear, with the same hand.
// `side` is +1 for an external gear and −1 for an internal gear.
Json with_shared_keys(const Json& cutter, const Json& gear, double side,
                      const std::optional<double>& helix_deg, const Json* mate) {
  Json whole = cutter;
  for (const char* key_of_both : {"normal_module_mm", "normal_pressure_angle_deg"}) {
    const std::vector<std::string> keys = gear_keys().ways(key_of_both);
    if (has_any(cutter, keys)) continue;
    const Json* from = has_any(gear, keys) ? &gear : mate;
    for (const std::string& key : keys)
      if (from && from->contains(key)) whole[key] = (*from)[key];
  }
  static const std::vector<std::string> kHelix{"helix_angle_deg", "lead_angle_deg", "hand"};
  if (has_any(cutter, kHelix)) return whole;
  if (helix_deg) {
    whole["helix_angle_deg"] = -side * *helix_deg;
  } else if (!has_any(gear, kHelix) && mate) {  // the cutter has the helix of the mating gear
    for (const std::string& key : kHelix) {
      if (mate->contains(key)) whole[key] = (*mate)[key];
    }
  }
  return whole;
}

// Default addendum of a cutter, modules. A cutter with this addendum cuts deep enough for the tip
// clearance of the mating gear.
constexpr double kCutterAddendum = 1.25;

// Returns the rack in [gearN], by default ISO53-A. `module`, in mm, selects one of the racks of
// GB/T 12759.
Rack read_rack(TableReader& gear, std::optional<double> module) {
  const Json* node = gear.any("rack");
  if (node && *node == "GBT12759") {
    refuse_involute_keys(gear);
    if (!module) {
      gear.lacks_one_of("normal_module_mm", "module");
      gear.finish();  // fails with the reason
    }
    auto rack = gbt12759_rack(*module);
    if (!rack) throw SpecError{spelled(within(gear.name(), rack.error()))};
    return *rack;
  }
  if (!node || !node->is_object()) return read_straight_rack(gear);
  const std::string path = gear.name("rack");
  const KeyTable& keys = kind_of_table(*gear.keys().find("rack"), *node, path);
  if (&keys == &straight_rack_keys()) return read_straight_rack(gear);
  refuse_involute_keys(gear);
  if (&keys == &arc_rack_keys()) return read_table<ArcRack>(keys, *node, path);
  if (&keys == &double_arc_rack_keys()) return read_table<DoubleArcRack>(keys, *node, path);
  return read_table<RackOfArcs>(keys, *node, path);
}

// Reads `cut_by` and `profile_shift_pair`. `node` is the table of the gear, and `helix_deg` its
// helix angle, if it is given. `mate` is the table of the other gear, or null. The number of teeth
// of `g` has been read.
void read_cut_by(TableReader& gear, const Json& node, const std::optional<double>& helix_deg,
                 const Json* mate, GearInput& g) {
  const auto total = gear.number("profile_shift_pair");
  const Json* by = gear.any("cut_by");
  if (!by) {
    if (total) gear.fail("profile_shift_pair", "is allowed only for a gear with cut_by");
    return;
  }
  CutByInput cut;
  cut.profile_shift_pair = total;
  if (by->is_string()) {
    const auto [number, member] = subject_of(by->get<std::string>());
    if (number == 0 || member != GearMember::none)
      gear.fail("cut_by", "must be \"gear1\", \"gear2\" or a table that describes a cutter");
    cut.gear = number;
  } else if (by->is_object()) {
    const std::string path = gear.name("cut_by");
    for (const auto& [key, why] :
         {std::pair{
              "cut_by",
              "is not allowed, because the cutter itself is cut by a rack; leave out this key"},
          std::pair{"profile_shift_pair", "must be in the table of the gear, not in cut_by"},
          std::pair{"modifications",
                    "is not allowed, because a cutter has no flank modifications; give the "
                    "modifications in the table of the gear"}}) {
      if (by->contains(key)) gear.fail(std::string("cut_by.") + key, why);
    }
    const Json whole = with_shared_keys(*by, node, side_of(g.cylindrical.teeth), helix_deg, mate);
    GearInput cutter = read_gear(cutter_keys(), whole, path);
    if (cutter.cylindrical.teeth < 0)
      gear.fail("cut_by.teeth",
                "must be positive, because an internal gear cannot be a pinion cutter");
    if (!by->contains("rack")) cutter.cylindrical.straight_rack().addendum = kCutterAddendum;
    if (cutter.tip_clearance || cutter.tip_clearance_by_rule) {
      gear.fail("cut_by.tip_fillet",
                "a clearance is not allowed here, because a cutter has no mating gear that "
                "determines it; give corner_radius_mm, radius_mm or l_mm");
    }
    cut.cutter = std::make_shared<GearInput>(std::move(cutter));
  } else {
    gear.fail("cut_by", "must be \"gear1\", \"gear2\" or a table that describes a cutter");
  }
  for (const char* key : {"rack", "root_fillet", "tip_fillet", "basic", "thickness_allowance_mm"}) {
    const bool of_infeed = cut.cutter && std::string_view(key) == "thickness_allowance_mm";
    if (gear.has(key) && !of_infeed) {
      gear.fail(key,
                "cannot be combined with cut_by, because the cutter and the generating centre "
                "distance determine the tooth");
    }
  }
  if (total && g.shift_given) {
    gear.fail("profile_shift_pair",
              "cannot be combined with profile_shift, because both keys determine the depth of the "
              "cutter; leave out one of the two");
  }
  g.cut_by = std::move(cut);
}

}  // namespace

GearInput read_gear(const KeyTable& keys, const Json& node, const std::string& path,
                    const Json* mate, const std::filesystem::path& folder) {
  TableReader t(keys, node, path);
  GearInput g;
  CylindricalSpec& c = g.cylindrical;
  const auto helix = read_helix(t);
  c.helix_angle = Angle::degrees(helix.value_or(0.0));
  t.use_helix(c.helix_angle);
  t.read(g);
  g.helix_given = helix.has_value();
  g.hand_given = t.has("hand");
  g.transverse_given = t.has("transverse_module_mm") || t.has("transverse_pressure_angle_deg");
  std::optional<double> module;
  if (t.given_in_any_way("normal_module_mm")) module = c.normal_module;
  std::optional<Angle> alpha;
  if (t.given_in_any_way("normal_pressure_angle_deg")) alpha = c.normal_pressure_angle;
  alpha = rack_angle(t, alpha);
  c.normal_pressure_angle = alpha.value_or(c.normal_pressure_angle);
  c.rack = read_rack(t, module);
  g.rack_given = t.has("rack");
  if (keys.find("cut_by")) {
    read_cut_by(t, node, helix, mate, g);
  }
  if (keys.find("modifications")) g.modifications = read_modifications(t, folder);
  check_tolerance(t, g);
  t.table("measured");  // read by spec/read_measured.cpp
  if (t.has("teeth")) {
    read_basic(t, g, module, alpha);
  } else {
    t.table("basic");
  }
  if (!module && !g.cut_by && !t.has("basic")) t.lacks_one_of("normal_module_mm", "module");
  t.finish();
  if (g.cut_by) {
    g.cut_by->module = module;
    g.cut_by->pressure_angle = alpha;
  }
  g.complete_face_width();
  return g;
}

StraightRack read_straight_rack(TableReader& gear) {
  const Json* node = gear.any("rack");
  if (!node) return *iso53_rack("ISO53-A");
  if (node->is_string()) {
    if (const AgmaRack* agma = agma_rack(node->get<std::string>())) return agma->rack;
    const auto rack = iso53_rack(node->get<std::string>());
    if (!rack) {
      gear.fail("rack", fmt::format("must be \"{}\" or a table, [{}]",
                                    fmt::join(gear.keys().find("rack")->words, "\", \""),
                                    gear.name("rack")));
    }
    return *rack;
  }
  if (!node->is_object()) gear.fail("rack", "must be a name in quotes or a table");
  return read_table<StraightRack>(straight_rack_keys(), *node, gear.name("rack"));
}

std::optional<Angle> rack_angle(TableReader& gear, std::optional<Angle> given) {
  const Json* node = gear.any("rack");
  const AgmaRack* const agma =
      node && node->is_string() ? agma_rack(node->get<std::string>()) : nullptr;
  if (!agma) return given;
  const Angle own = agma->normal_pressure_angle;
  if (given && std::abs(given->rad() - own.rad()) > kSameInput * own.rad())
    gear.fail("rack", fmt::format("has a pressure angle of {:g}°, but the gear has a pressure "
                                  "angle of {:.6g}°; leave out the pressure angle of the gear",
                                  own.deg(), given->deg()));
  return own;
}

}  // namespace gearwright
