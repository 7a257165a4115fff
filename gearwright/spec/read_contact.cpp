#include "gearwright/spec/read_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace gearwright {

namespace {

// An error is the same wherever it is given: as a value, in a range, along an axis of a map.
std::array<double, 2> read_range(TableReader& t, const std::string& key, const Key& error) {
  const auto range = *t.numbers(key);
  if (!(range[0] < range[1])) t.fail(key, "must grow: the least value, then the greatest");
  for (const double v : range)
    if (!error.range.contains(v)) t.fail(key, error.range.sentence(v));
  return {range[0], range[1]};
}

ContactMapInput read_map(const Json& node) {
  TableReader t(contact_map_keys(), node, "contact.map");
  ContactMapInput map;
  const std::array<std::string, 2> names{"x", "y"};
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string range = names[i] + "_range";
    t.require(names[i]);
    t.require(range);
    map.key[i] = *error_index(*t.word(names[i]));
    map.range[i] = read_range(t, range, error_keys().keys[map.key[i]]);
  }
  if (map.key[0] == map.key[1]) t.fail("y", "must be another error than x");
  if (const auto points = t.numbers("points")) {
    for (std::size_t i = 0; i < 2; ++i) {
      if ((*points)[i] != std::floor((*points)[i])) t.fail("points", "must be whole numbers");
      t.check("points", (*points)[i]);
      map.points[i] = static_cast<int>((*points)[i]);
    }
  }
  t.finish();
  return map;
}

constexpr std::size_t kMaxRanges = 5;  // 32 corners

std::vector<WorkshopCorrection> read_corrections(TableReader& t) {
  std::vector<WorkshopCorrection> wanted;
  const Json* list = t.any("corrections");
  if (!list) return wanted;
  const Key& key = *t.keys().find("corrections");
  const std::vector<std::string> known(key.words.begin(), key.words.end());
  if (!list->is_array() || list->empty()) t.fail("corrections", "must be " + form_of(key));
  for (const Json& item : *list) {
    const std::string name = item.is_string() ? item.get<std::string>() : json_text(item);
    const auto it = std::find(known.begin(), known.end(), name);
    if (it == known.end()) {
      t.fail("corrections",
             fmt::format("unknown correction {}; {}", printable(name, 60), word_hint(name, known)));
    }
    const auto& correction = kCorrections[static_cast<std::size_t>(it - known.begin())].correction;
    if (std::find(wanted.begin(), wanted.end(), correction) != wanted.end())
      t.fail("corrections", fmt::format("names {} twice", name));
    wanted.push_back(correction);
  }
  return wanted;
}

}  // namespace

ErrorsInput read_errors(const Json& node) {
  TableReader t(error_keys(), node, "errors");
  ErrorsInput errors;
  errors.given = true;
  t.read(errors);
  t.finish();
  return errors;
}

ContactInput read_contact(const Json& node) {
  TableReader t(contact_keys(), node, "contact");
  ContactInput c;
  c.given = true;
  t.read(c);
  if (static_cast<long long>(c.positions) * c.pitches > kMaxPositions) {
    t.fail("pitches", fmt::format("positions times pitches must be at most {}; every pitch is like "
                                  "the first",
                                  kMaxPositions));
  }
  for (const double r : t.numbers("rotation1_deg").value_or(std::vector<double>())) {
    t.check("rotation1_deg", r);
    c.rotations.push_back(Angle::degrees(r));
  }
  if (const Json* map = t.table("map")) c.map = read_map(*map);
  t.finish();
  return c;
}

CompensateInput read_compensate(const Json& node) {
  TableReader t(compensate_keys(), node, "compensate");
  CompensateInput c;
  c.given = true;
  t.read(c);
  c.corrections = read_corrections(t);
  if (const Json* table = t.table("range")) {
    TableReader r(compensate_range_keys(), *table, "compensate.range");
    std::size_t count = 0;
    for (std::size_t i = 0; i < kErrorCount; ++i) {
      const Key& error = error_keys().keys[i];
      const std::string key(error.key);
      if (!r.has(key)) continue;
      c.range[i] = read_range(r, key, error);
      if (++count > kMaxRanges)
        r.fail(key, fmt::format("is one range too many: {} at most, for every corner of them is "
                                "looked at",
                                kMaxRanges));
    }
    r.finish();
  }
  t.finish();
  return c;
}

}  // namespace gearwright
