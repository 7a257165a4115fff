// Materials of the gears of a drive from [planetary], [[stage]] or [drive].
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gearwright/catalogue/material_keys.hpp"
#include "gearwright/spec/inherit.hpp"
#include "gearwright/spec/read_drive.hpp"
#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

namespace {

using Materials = std::map<std::string, MaterialInput>;

std::vector<std::string> members() {
  std::vector<std::string> names;
  for (std::size_t m = 0; m < kSetMembers; ++m)
    names.emplace_back(to_string(static_cast<SetMember>(m)));
  return names;
}

void take(const Json& owner, const std::string& path, const std::vector<std::string>& gears,
          Materials& materials) {
  if (!owner.is_object() || !owner.contains("material")) return;
  const Json& node = owner["material"];
  const std::string key = path + ".material";
  if (!node.is_object())
    throw SpecError{{key, shown(node), fmt::format("must be a table, [{}]", key)}};
  for (const std::string& gear : gears)
    materials[gear] = read_table<MaterialInput>(material_keys(), node, key);
}

// One material for all members, or one for each named member.
void take_set(const Json& set, const std::string& path, const std::string& prefix,
              Materials& materials) {
  if (!set.is_object() || !set.contains("material")) return;
  const Json& node = set["material"];
  const std::vector<std::string> names = members();
  const auto named = [&](const auto& item) {
    return std::find(names.begin(), names.end(), item.key()) != names.end();
  };
  const auto items = node.items();
  if (node.is_object() && !node.empty() && std::all_of(items.begin(), items.end(), named)) {
    for (const auto& [member, material] : items)
      take(Json{{"material", material}}, path + ".material." + member, {prefix + member},
           materials);
    return;
  }
  std::vector<std::string> all;
  for (const std::string& name : names) all.push_back(prefix + name);
  take(set, path, all, materials);
}

void take_stage(const Json& stage, const std::string& path, const std::string& prefix,
                Materials& materials) {
  if (!stage.is_object()) return;
  if (stage.contains("planetary")) {
    take_set(stage, path, prefix, materials);
    take_set(stage["planetary"], path + ".planetary", prefix, materials);
    return;
  }
  take(stage, path, {prefix + "gear1", prefix + "gear2"}, materials);
  if (!stage.contains("gears") || !stage["gears"].is_array() || stage["gears"].size() != 2) return;
  const Json both = inherit(Json{{"gear1", stage["gears"][0]}, {"gear2", stage["gears"][1]}}).tree;
  for (const std::string gear : {"gear1", "gear2"})
    take(both[gear], fmt::format("{}.gears[{}]", path, gear.back()), {prefix + gear}, materials);
}

}  // namespace

std::map<std::string, MaterialInput> drive_materials(const Json& tree) {
  Materials materials;
  if (tree.contains("planetary")) take_set(tree["planetary"], "planetary", "", materials);
  if (tree.contains("stage") && tree["stage"].is_array())
    for (std::size_t i = 0; i < tree["stage"].size(); ++i)
      take_stage(tree["stage"][i], fmt::format("stage[{}]", i + 1), fmt::format("s{}_", i + 1),
                 materials);
  if (tree.contains("drive") && tree["drive"].is_object() && tree["drive"].contains("gear") &&
      tree["drive"]["gear"].is_array())
    for (std::size_t i = 0; i < tree["drive"]["gear"].size(); ++i) {
      const Json& gear = tree["drive"]["gear"][i];
      if (!gear.is_object() || !gear.contains("name") || !gear["name"].is_string()) continue;
      take(gear, fmt::format("drive.gear[{}]", i + 1), {gear["name"].get<std::string>()},
           materials);
    }
  return materials;
}

}  // namespace gearwright
