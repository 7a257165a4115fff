#include "gearwright/spec/read_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace gearwright {

namespace {

constexpr double kGreatestTilt =
    10.0;  // degrees: beyond it a shaft is not misaligned but elsewhere
constexpr double kGreatestSlope = 5000;    // µm over the face
constexpr int kMostPositions = 1'000'000;  // in all
constexpr int kMostMapPoints = 1000;       // along one side

std::vector<double> numbers(TableReader& t, const char* key, std::size_t least, std::size_t most) {
  std::vector<double> values;
  const Json* list = t.any(key);
  if (!list) return values;
  bool good = list->is_array() && list->size() >= least && list->size() <= most;
  for (std::size_t i = 0; good && i < list->size(); ++i) {
    good = (*list)[i].is_number() && std::isfinite((*list)[i].get<double>());
    if (good) values.push_back((*list)[i].get<double>());
  }
  if (!good)
    t.fail(key, least == most ? fmt::format("must be a list of {} numbers", least)
                              : fmt::format("must be a list of {} to {} numbers", least, most));
  return values;
}

std::size_t error_key(TableReader& t, const char* key) {
  const auto text = t.one_of(key, {kErrorKeys.begin(), kErrorKeys.end()});
  if (!text) t.fail(key, "is missing: a key of [errors], such as crossing_deg");
  return static_cast<std::size_t>(std::find(kErrorKeys.begin(), kErrorKeys.end(), *text) -
                                  kErrorKeys.begin());
}

ContactMapInput read_map(const Json& node) {
  TableReader t(node, "contact.map");
  ContactMapInput map;
  const std::array<const char*, 2> names{"x", "y"};
  const std::array<const char*, 2> ranges{"x_range", "y_range"};
  for (int i = 0; i < 2; ++i) {
    map.key[i] = error_key(t, names[i]);
    const auto range = numbers(t, ranges[i], 2, 2);
    if (range.empty()) t.fail(ranges[i], "is missing: the least and the greatest value");
    if (!(range[0] < range[1])) t.fail(ranges[i], "must grow: the least value, then the greatest");
    for (const double v : range) check_error(t, ranges[i], map.key[i], v);
    map.range[i] = {range[0], range[1]};
  }
  if (map.key[0] == map.key[1]) t.fail("y", "must be another error than x");
  const auto points = numbers(t, "points", 2, 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(points[i] >= 2 && points[i] <= kMostMapPoints && points[i] == std::floor(points[i])))
      t.fail("points", fmt::format("must be whole numbers from 2 to {}", kMostMapPoints));
    map.points[i] = static_cast<int>(points[i]);
  }
  t.finish();
  return map;
}

}  // namespace

void check_error(const TableReader& t, const std::string& key, std::size_t index, double value) {
  const std::string name = kErrorKeys[index];
  if (name.ends_with("_deg") && !(std::abs(value) <= kGreatestTilt)) {
    t.fail(key, fmt::format("must lie between -{} and {} degrees: an error is small; a shaft angle "
                            "belongs to pair.shaft_angle_deg",
                            kGreatestTilt, kGreatestTilt));
  }
  if (name.ends_with("_um") && !(std::abs(value) <= kGreatestSlope)) {
    t.fail(key, fmt::format("must lie between -{0} and {0} micrometres: a helix angle belongs to "
                            "the gear",
                            kGreatestSlope));
  }
}

ErrorsInput read_errors(const Json& node) {
  TableReader t(node, "errors");
  ErrorsInput errors;
  errors.given = true;
  for (std::size_t i = 0; i < kErrorKeys.size(); ++i) {
    const auto value = t.number(kErrorKeys[i]);
    if (!value) continue;
    check_error(t, kErrorKeys[i], i, *value);
    errors.value[i] = *value;
  }
  t.finish();
  return errors;
}

ContactInput read_contact(const Json& node) {
  TableReader t(node, "contact");
  ContactInput c;
  c.given = true;
  const auto whole = [&](const char* key, int& value, int least, int most) {
    const auto given = t.integer(key);
    if (given && !(*given >= least && *given <= most))
      t.fail(key, fmt::format("must lie between {} and {}", least, most));
    value = given.value_or(value);
  };
  whole("positions", c.positions, 4, 100'000);
  whole("pitches", c.pitches, 1, 10'000);
  if (static_cast<long long>(c.positions) * c.pitches > kMostPositions) {
    t.fail("pitches", fmt::format("positions times pitches must be at most {}; every pitch is like "
                                  "the first",
                                  kMostPositions));
  }
  c.marking = t.positive("marking_mm").value_or(c.marking);
  if (c.marking > 1.0) t.fail("marking_mm", "must be at most 1, usually 0.003 to 0.01");
  whole("driver", c.driver, 1, 2);
  c.pattern = t.boolean("pattern").value_or(false);
  c.rotations = numbers(t, "rotation1_deg", 1, 100'000);
  for (const double r : c.rotations)
    if (!(std::abs(r) <= 1e6)) t.fail("rotation1_deg", "must lie between -1e6 and 1e6");
  if (const Json* map = t.table("map")) c.map = read_map(*map);
  t.finish();
  return c;
}

namespace {

constexpr std::size_t kMostRanges = 5;  // 32 corners

std::vector<std::size_t> read_corrections(TableReader& t) {
  std::vector<std::size_t> wanted;
  const Json* list = t.any("corrections");
  if (!list) return wanted;
  std::vector<std::string> known;
  for (const CorrectionKind& c : kCorrections) known.emplace_back(c.key);
  if (!list->is_array() || list->empty())
    t.fail("corrections", "must be a list of names, [\"gear1.lead_crowning_um\"]");
  for (const Json& item : *list) {
    const std::string name = item.is_string() ? item.get<std::string>() : json_text(item);
    const auto it = std::find(known.begin(), known.end(), name);
    if (it == known.end()) {
      t.fail("corrections", fmt::format("does not know {}; did you mean {}?", printable(name, 60),
                                        nearest_word(name, known)));
    }
    const auto index = static_cast<std::size_t>(it - known.begin());
    if (std::find(wanted.begin(), wanted.end(), index) != wanted.end())
      t.fail("corrections", fmt::format("names {} twice", name));
    wanted.push_back(index);
  }
  return wanted;
}

}  // namespace

CompensateInput read_compensate(const Json& node) {
  TableReader t(node, "compensate");
  CompensateInput c;
  c.corrections = read_corrections(t);
  if (const auto w = t.number("centering_arcsec")) {
    if (*w < 0.0) t.fail("centering_arcsec", "must not be negative");
    c.centering_arcsec = *w;
  }
  if (const Json* table = t.table("range")) {
    TableReader r(*table, "compensate.range");
    std::size_t count = 0;
    for (std::size_t i = 0; i < kErrorKeys.size(); ++i) {
      const auto range = numbers(r, kErrorKeys[i], 2, 2);
      if (range.empty()) continue;
      if (!(range[0] < range[1]))
        r.fail(kErrorKeys[i], "must grow: the least value, then the greatest");
      for (const double v : range) check_error(r, kErrorKeys[i], i, v);
      c.range[i] = {range[0], range[1]};
      if (++count > kMostRanges)
        r.fail(kErrorKeys[i], fmt::format("is one range too many: {} at most, for every corner of "
                                          "them is looked at",
                                          kMostRanges));
    }
    r.finish();
  }
  t.finish();
  return c;
}

}  // namespace gearwright
