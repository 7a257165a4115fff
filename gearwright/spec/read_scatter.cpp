#include "gearwright/spec/read_search.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

namespace {

std::vector<ScatterInput::Group> read_groups(TableReader& t) {
  std::vector<ScatterInput::Group> groups;
  const Json* table = t.any("groups");
  if (!table) return groups;
  if (!table->is_object()) t.fail("groups", "must be a table of names, each with a list of inputs");
  for (const auto& [name, inputs] : table->items()) {
    const auto refuse = [&, &name = name, &inputs = inputs](const char* why) {
      throw SpecError{{t.name("groups") + "." + printable(name, 40), shown(inputs), why}};
    };
    if (!inputs.is_array() || inputs.empty()) refuse("must be a list of at least one input");
    ScatterInput::Group group{name, {}};
    for (const Json& input : inputs) {
      if (!input.is_string())
        refuse("must be a list of inputs, for example [\"errors.crossing_deg\"]");
      group.inputs.push_back(input.get<std::string>());
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace

ScatterInput read_scatter(const Json& node) {
  ScatterInput s;
  s.given = true;
  TableReader t(scatter_keys(), node, "scatter");
  s.groups = read_groups(t);
  t.read_whole(s);
  return s;
}

}  // namespace gearwright
