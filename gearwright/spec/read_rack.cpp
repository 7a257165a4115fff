#include "gearwright/spec/read_rack.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gearwright/catalogue/rack_keys.hpp"
#include "gearwright/catalogue/spelling.hpp"

namespace gearwright {

namespace {

// Rejects keys of an involute gear, which have no meaning here.
void refuse_involute_keys(TableReader& gear) {
  const std::string why = "cannot be combined with a rack of arcs";
  for (const char* key : {"normal_pressure_angle_deg", "transverse_pressure_angle_deg"}) {
    gear.refuse(key,
                why + "; write the pressure angle of the arcs into [" + gear.name("rack") + "]");
  }
  for (const char* key : {"basic", "root_fillet", "tip_fillet"}) gear.refuse(key, why);
  const auto shift = gear.number("profile_shift");
  if (shift && *shift != 0.0)
    gear.fail("profile_shift", why + "; the positions of the arc centres determine the depth");
}

// The table that the word `kind` selects from those of a key; by default the first.
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

StraightRack read_straight_rack(TableReader& gear) {
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
  return read_table<StraightRack>(straight_rack_keys(), *node, gear.name("rack"));
}

Rack read_rack(TableReader& gear, std::optional<double> module) {
  const Json* node = gear.any("rack");
  if (node && *node == "GBT12759") {
    refuse_involute_keys(gear);
    if (!module) {
      gear.lacks_one_of("normal_module_mm", "module");
      gear.finish();  // which fails
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

}  // namespace gearwright
