// Implements the option --as-rack of the verb `gear`, which describes the teeth of a gear by
// another rack.
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "gearwright/base/number_text.hpp"
#include "gearwright/gear/basic.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/measures.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

namespace {

// Permitted normal pressure angles of the rack in degrees, the same as for a gear.
constexpr double kMinRackAngle = 1.0, kMaxRackAngle = 60.0;

}  // namespace

std::optional<WantedRack> parse_wanted_rack(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos || text.find(',', comma + 1) != std::string::npos)
    return std::nullopt;
  const auto number = [](const std::string& part, bool& good) -> std::optional<double> {
    if (part.empty()) return std::nullopt;
    const auto v = decimal_number(part);
    good = good && v && *v > 0.0;
    return v;
  };
  bool good = true;
  WantedRack q;
  q.normal_module = number(text.substr(0, comma), good);
  if (const auto angle = number(text.substr(comma + 1), good)) {
    q.normal_pressure_angle = Angle::degrees(*angle);
    good = good && *angle >= kMinRackAngle && *angle <= kMaxRackAngle;
  }
  if (!good || (!q.normal_module && !q.normal_pressure_angle)) return std::nullopt;
  return q;
}

Result<ReferenceInput<double>> gear_as_rack(const Gear& gear, const WantedRack& wanted) {
  auto rack = as_rack(gear, wanted);
  if (rack) return rack;
  Error error = rack.error();
  if (error.field == "normal_module") error.value += ",";
  if (error.field == "normal_pressure_angle") error.value.insert(0, ",");
  return Error{"--as-rack", error.value, error.rule, FailureKind::option};
}

Json rack_json(const ReferenceInput<double>& rack) {
  return to_json(as_rack_quantities().of(rack));
}

std::string rack_listing(const std::vector<ReferenceInput<double>>& racks, UnitSystem units) {
  std::vector<ValueRecord> records;
  for (const auto& rack : racks) records.push_back(as_rack_quantities().of(rack));
  return quantity_listing(units, as_rack_quantities().table(), records,
                          gear_columns(records.size()));
}

}  // namespace gearwright
