// The speed that a drive, or a search for drives, lends to its [rating].
#include <cmath>
#include <nlohmann/json.hpp>

#include "gearwright/spec/read_drive.hpp"

namespace gearwright {

namespace {

// The table with the load of the drive; null if it is not a table.
const Json* input_table(const Json& tree) {
  const auto table = [](const Json& owner, const char* key) -> const Json* {
    const auto it = owner.find(key);
    return it != owner.end() && it->is_object() ? &*it : nullptr;
  };
  for (const char* key : {"planetary", "drive", "search"})
    if (const Json* own = table(tree, key)) return own;
  const auto stages = tree.find("stage");
  if (stages == tree.end() || !stages->is_array() || stages->empty() ||
      !stages->front().is_object())
    return nullptr;
  const Json* set = table(stages->front(), "planetary");
  return set && set->contains("speed_rpm") ? set : &stages->front();
}

}  // namespace

void lend_speed(Json& tree) {
  const Json* input = input_table(tree);
  if (!input || !input->contains("speed_rpm") || !tree.contains("rating")) return;
  const Json& given = (*input)["speed_rpm"];
  const Json& first = given.is_array() && !given.empty() ? given.front() : given;
  Json& rating = tree["rating"];
  if (!first.is_number() || first == 0.0 || !rating.is_object() || rating.contains("speed_rpm"))
    return;
  rating["speed_rpm"] = std::abs(first.get<double>());
}

}  // namespace gearwright
