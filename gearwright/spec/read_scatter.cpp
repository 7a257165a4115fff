#include "gearwright/spec/read_search.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gearwright/spec/table_reader.hpp"

namespace gearwright {

namespace {

// Checks the distribution. The error names `key`, or a key inside it if the value is a table.
void check(const TableReader& t, const std::string& key, const DistributionSpec& d,
           const Json& value) {
  const auto made = Distribution::of(d);
  if (made) return;
  const Error& error = made.error();
  if (!value.is_object()) {
    t.fail(key, d.range[0] > d.range[1] ? "must contain the least value before the greatest; a "
                                          "tolerance of ±0.02 is [-0.02, 0.02]"
                                        : error.rule);
  }
  throw SpecError{
      {t.name(key) + "." + error.field, shown(value.value(error.field, Json())), error.rule}};
}

std::optional<DistributionSpec> read_tolerance(TableReader& t, const std::string& key) {
  const Json* value = t.any(key);
  if (!value) return std::nullopt;
  DistributionSpec d;
  if (value->is_object()) {
    TableReader table(scatter_range_keys(), *value, t.name(key));
    table.read(d);
    table.finish();
    const auto belongs = [&](const char* to, DistributionSpec::Kind kind, const char* words) {
      if (value->contains(to) && d.kind != kind)
        table.fail(to, std::string("is used only with distribution = \"") + words + "\"");
    };
    belongs("cpk", DistributionSpec::Kind::normal, "normal");
    belongs("offset", DistributionSpec::Kind::normal, "normal");
    belongs("shape", DistributionSpec::Kind::beta, "beta");
  } else {
    const bool two = value->is_array() && value->size() == 2 && (*value)[0].is_number() &&
                     (*value)[1].is_number();
    if (!two) {
      const bool tolerance = value->is_number() && value->get<double>() > 0.0;
      t.fail(key, std::string("must be [least, greatest], or a table with range and distribution") +
                      (tolerance ? "; a tolerance of ±" + shown(*value) + " is [-" + shown(*value) +
                                       ", " + shown(*value) + "]"
                                 : ""));
    }
    d.range = {(*value)[0].get<double>(), (*value)[1].get<double>()};
  }
  check(t, key, d, *value);
  for (const double end : d.range) t.check(key, end);
  return d;
}

ScatterGear read_gear(const Json& node, const std::string& path) {
  ScatterGear gear;
  TableReader t(scatter_gear_keys(), node, path);
  gear.thickness = read_tolerance(t, "thickness_allowance_mm");
  if (const Json* table = t.table("modifications")) {
    TableReader m(scatter_modification_keys(), *table, t.name("modifications"));
    for (std::size_t i = 0; i < modification_entries().size(); ++i)
      gear.modifications[i] =
          read_tolerance(m, std::string(modification_entries()[i].name) + "_um");
    m.finish();
  }
  gear.pitch = t.word("pitch").has_value();
  t.read_whole(gear);
  return gear;
}

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

std::vector<ScatterInput::Correlation> read_correlations(TableReader& t) {
  std::vector<ScatterInput::Correlation> correlations;
  const Json* list = t.any("correlations");
  if (!list) return correlations;
  constexpr const char* kExample =
      "{ between = [\"errors.crossing_deg\", \"errors.intersecting_deg\"], value = 0.5 }";
  if (!list->is_array() || list->empty() || list->size() > kMostCorrelations)
    t.fail("correlations", fmt::format("must be a list of 1 to {} tables, for example [{}]",
                                       kMostCorrelations, kExample));
  for (const Json& item : *list) {
    const std::string path = fmt::format("{}[{}]", t.name("correlations"), correlations.size() + 1);
    if (!item.is_object())
      throw SpecError{
          {path, shown(item), fmt::format("must be a table, for example {}", kExample)}};
    TableReader table(scatter_correlation_keys(), item, path);
    ScatterInput::Correlation& c = correlations.emplace_back();
    if (const auto value = table.number("value")) c.value = *value;
    if (const Json* between = table.any("between")) {
      const bool two = between->is_array() && between->size() == 2 && (*between)[0].is_string() &&
                       (*between)[1].is_string();
      if (!two)
        table.fail("between", fmt::format("must be a list of two inputs, as in {}", kExample));
      c.between = {(*between)[0].get<std::string>(), (*between)[1].get<std::string>()};
      if (c.between[0] == c.between[1])
        table.fail("between",
                   "must be two different inputs; the correlation of an input with itself is 1");
    }
    table.finish();
  }
  return correlations;
}

}  // namespace

ScatterInput read_scatter(const Json& node) {
  ScatterInput s;
  s.given = true;
  TableReader t(scatter_keys(), node, "scatter");
  if (const Json* table = t.table("errors")) {
    TableReader errors(scatter_error_keys(), *table, t.name("errors"));
    for (std::size_t i = 0; i < kErrorCount; ++i)
      s.errors[i] = read_tolerance(errors, std::string(error_entries()[i].key));
    errors.finish();
  }
  if (const Json* table = t.table("bearings")) {
    TableReader bearings(scatter_bearing_keys(), *table, t.name("bearings"));
    bearings.read_whole(s.bearings.emplace());
    for (const std::size_t i : {0, 1, 2}) {
      if (!s.errors[i]) continue;
      t.fail("bearings", "cannot be combined with scatter.errors." +
                             std::string(error_entries()[i].key) +
                             ", because the positions of the bores determine this error");
    }
  }
  for (const std::size_t i : {0, 1}) {
    const std::string key = i == 0 ? "gear1" : "gear2";
    if (const Json* table = t.table(key)) s.gears[i] = read_gear(*table, t.name(key));
  }
  s.groups = read_groups(t);
  s.correlations = read_correlations(t);
  t.read_whole(s);
  return s;
}

}  // namespace gearwright
