#include "gearwright/spec/read_arc_rack.hpp"

#include <nlohmann/json.hpp>

#include <fmt/format.h>

namespace gearwright {

namespace {

double needed(TableReader& t, const char* key, const char* what) {
  const auto value = t.number(key);
  if (!value) t.fail(key, std::string("is missing: ") + what);
  return *value;
}

ArcRack read_F_or_P(TableReader& t) {
  const auto cutter = t.one_of("cutter", {"F", "P"});
  ArcRack rack =
      default_arc_rack(cutter && *cutter == "P" ? ArcRack::Cutter::P : ArcRack::Cutter::F);
  if (const auto v = t.number("pressure_angle_deg")) rack.pressure_angle = Angle::degrees(*v);
  const auto radius = t.number("arc_radius");
  const auto a = t.number("center_a");
  const auto b = t.number("center_b");
  if (const auto v = t.number("addendum")) rack.addendum = *v;
  if (const auto v = t.number("dedendum")) rack.dedendum = *v;
  if (const auto v = t.number("root_fillet_radius")) rack.root_fillet_radius = *v;
  t.finish();
  if (!cutter) t.fail("cutter", "is missing: \"F\" cuts convex teeth, \"P\" concave ones");
  if (!radius) t.fail("arc_radius", "is missing: the radius of the flank's arc, in modules");
  if (!a) t.fail("center_a", "is missing: how far the arc's centre lies beyond the middle");
  if (!b) t.fail("center_b", "is missing: how far it lies from the pitch plane, in modules");
  rack.arc_radius = *radius;
  rack.center_a = *a;
  rack.center_b = *b;
  return rack;
}

DoubleArcRack read_double(TableReader& t) {
  DoubleArcRack rack;
  if (const auto v = t.number("pressure_angle_deg")) rack.pressure_angle = Angle::degrees(*v);
  for (const auto& [key, member] : {std::pair{"addendum", &DoubleArcRack::addendum},
                                    std::pair{"dedendum", &DoubleArcRack::dedendum},
                                    std::pair{"convex_radius", &DoubleArcRack::convex_radius},
                                    std::pair{"convex_height", &DoubleArcRack::convex_height},
                                    std::pair{"convex_offset", &DoubleArcRack::convex_offset},
                                    std::pair{"step_height", &DoubleArcRack::step_height},
                                    std::pair{"step_depth", &DoubleArcRack::step_depth}}) {
    if (const auto v = t.number(key)) rack.*member = *v;
  }
  const auto radius = t.number("concave_radius");
  const auto height = t.number("concave_height");
  const auto width = t.number("space_width");
  t.finish();
  if (!radius) t.fail("concave_radius", "is missing: the radius of the concave arc, in modules");
  if (!height) t.fail("concave_height", "is missing: the height of its centre, in modules");
  if (!width) t.fail("space_width", "is missing: of the space where the concave arc is touched");
  rack.concave_radius = *radius;
  rack.concave_height = *height;
  rack.space_width = *width;
  return rack;
}

RackArc read_arc(const Json& node, const std::string& name) {
  TableReader t(node, name);
  RackArc arc;
  const auto part = t.one_of("part", {"root_fillet", "flank", "joint", "tip_fillet"});
  const std::string word = part.value_or("flank");
  arc.cuts = word == "root_fillet"  ? ArcName::root_fillet
             : word == "tip_fillet" ? ArcName::tip_fillet
                                    : ArcName::flank;
  arc.working = word == "flank";
  arc.center_height = needed(t, "center_height", "of the arc's centre over the datum line");
  arc.center_offset = needed(t, "center_offset", "of the arc's centre from the tooth's middle");
  arc.radius = needed(t, "radius", "> 0 cuts a convex part of the tooth, < 0 a concave one");
  arc.begin = Angle::degrees(needed(t, "begin_deg", "the normal angle at the root side"));
  arc.end = Angle::degrees(needed(t, "end_deg", "the normal angle at the tip side"));
  t.finish();
  return arc;
}

constexpr std::size_t kMostArcs = 100;

RackOfArcs read_arcs(TableReader& t) {
  RackOfArcs rack;
  const Json* list = t.any("arcs");
  rack.addendum = needed(t, "addendum", "of the gear's tooth above the datum line");
  rack.dedendum = needed(t, "dedendum", "how deep the cutter goes");
  t.finish();
  if (!list || !list->is_array() || list->empty() || list->size() > kMostArcs) {
    t.fail("arcs", fmt::format("must be a list of 1 to {} tables, one for each arc, from the "
                               "cutter's tip on",
                               kMostArcs));
  }
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string name = fmt::format("{}[{}]", t.name("arcs"), i + 1);
    if (!(*list)[i].is_object()) {
      throw SpecError{{name, "",
                       name + ": must be a table with part, center_height, "
                              "center_offset, radius, begin_deg, end_deg"}};
    }
    rack.arcs.push_back(read_arc((*list)[i], name));
  }
  return rack;
}

// Keys of an involute gear, which mean nothing here.
void refuse_involute_keys(TableReader& gear) {
  const std::string why = "has no place beside a rack of arcs";
  for (const char* key : {"normal_pressure_angle_deg", "transverse_pressure_angle_deg"}) {
    gear.refuse(key, why + ": the arcs' pressure angle stands in [" + gear.name("rack") + "]");
  }
  for (const char* key : {"basic", "root_fillet", "tip_fillet"}) gear.refuse(key, why);
  const auto shift = gear.number("profile_shift");
  if (shift && *shift != 0.0)
    gear.fail("profile_shift", why + ": the place of the arcs' centres says how deep they lie");
}

}  // namespace

std::optional<AnyArcRack> read_arc_rack(TableReader& gear, const Once& module) {
  const Json* node = gear.any("rack");
  if (!node) return std::nullopt;
  if (node->is_string() && node->get<std::string>() == "GBT12759") {
    refuse_involute_keys(gear);
    auto rack = gbt12759_rack(module.required());
    if (!rack) {
      const Error& e = rack.error();
      throw SpecError{{gear.name(e.key), e.value, gear.name(e.message)}};
    }
    return *rack;
  }
  if (!node->is_object()) return std::nullopt;
  TableReader t(*node, gear.name("rack"));
  const auto kind = t.one_of("kind", {"straight", "circular_arc", "double_circular_arc", "arcs"});
  if (!kind || *kind == "straight") return std::nullopt;
  refuse_involute_keys(gear);
  if (*kind == "circular_arc") return read_F_or_P(t);
  if (*kind == "double_circular_arc") return read_double(t);
  return read_arcs(t);
}

}  // namespace gearwright
