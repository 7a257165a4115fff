#include "gearwright/spec/read_arc_rack.hpp"

#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include "gearwright/catalogue/rack_keys.hpp"
#include "gearwright/catalogue/spelling.hpp"

namespace gearwright {

namespace {

// Where a default is the full radius, rounding of the last digits may not push it out of the tip.
constexpr double kInside = 1.0 - 1e-12;

ArcRack read_F_or_P(TableReader& t) {
  const auto cutter = t.word("cutter");
  ArcRack rack =
      default_arc_rack(cutter && *cutter == "P" ? ArcRack::Cutter::P : ArcRack::Cutter::F);
  t.read(rack);
  t.finish();
  if (!t.has("root_fillet_radius")) {
    const double greatest = full_radius(rack);
    if (greatest >= 0.0 && greatest < rack.root_fillet_radius)
      rack.root_fillet_radius = greatest * kInside;
  }
  return rack;
}

DoubleArcRack read_double(TableReader& t) {
  DoubleArcRack rack;
  t.read(rack);
  t.finish();
  return rack;
}

RackArc read_arc(const Json& node, const std::string& name) {
  TableReader t(rack_arc_keys(), node, name);
  RackArcInput in;
  t.read(in);
  t.finish();
  const ArcName cuts = in.part == ArcPart::root_fillet  ? ArcName::root_fillet
                       : in.part == ArcPart::tip_fillet ? ArcName::tip_fillet
                                                        : ArcName::flank;
  return {cuts,     in.center_height, in.center_offset,         in.radius,
          in.begin, in.end,           in.part == ArcPart::flank};
}

RackOfArcs read_arcs(TableReader& t) {
  RackOfArcs rack;
  t.read(rack);
  t.require("arcs");
  const Json& list = *t.any("arcs");
  const std::size_t most = t.keys().find("arcs")->list->most;
  if (!list.is_array() || list.empty() || list.size() > most) {
    t.fail("arcs", fmt::format("must be a list of 1 to {} tables, one for each arc, from the "
                               "cutter's tip on",
                               most));
  }
  t.finish();
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string name = fmt::format("{}[{}]", t.name("arcs"), i + 1);
    if (!list[i].is_object()) {
      throw SpecError{
          {name, "",
           fmt::format("must be a table with {}", fmt::join(rack_arc_keys().names(), ", "))}};
    }
    rack.arcs.push_back(read_arc(list[i], name));
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

// The one of a key's tables that the word `kind` chooses; none: the first.
const KeyTable& kind_of_table(const Key& key, const Json& node, const std::string& path) {
  const auto it = node.find("kind");
  if (it == node.end()) return key.tables.front()();
  std::vector<std::string_view> words;
  for (const auto& table : key.tables) {
    words.push_back(table().find("kind")->words.front());
    if (it->is_string() && it->get<std::string>() == words.back()) return table();
  }
  TableReader(key.tables.front()(), node, path)
      .fail("kind", it->is_string()
                        ? fmt::format("must be one of \"{}\"", fmt::join(words, "\", \""))
                        : "must be a text in quotes");
}

}  // namespace

std::optional<Rack> read_arc_rack(TableReader& gear, const Once& module) {
  const Json* node = gear.any("rack");
  if (!node) return std::nullopt;
  if (node->is_string() && node->get<std::string>() == "GBT12759") {
    refuse_involute_keys(gear);
    module.require();
    if (!module.value()) gear.finish();  // which complains
    auto rack = gbt12759_rack(*module.value());
    if (!rack) throw SpecError{spelled(within(gear.name(), rack.error()))};
    return *rack;
  }
  if (!node->is_object()) return std::nullopt;
  const Key& rack = *gear.keys().find("rack");
  const KeyTable& keys = kind_of_table(rack, *node, gear.name("rack"));
  if (&keys == &straight_rack_keys()) return std::nullopt;
  refuse_involute_keys(gear);
  TableReader t(keys, *node, gear.name("rack"));
  t.any("kind");
  if (&keys == &arc_rack_keys()) return read_F_or_P(t);
  if (&keys == &double_arc_rack_keys()) return read_double(t);
  return read_arcs(t);
}

}  // namespace gearwright
