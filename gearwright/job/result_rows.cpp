#include "gearwright/job/result_rows.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

namespace {

std::string ends_text(const QuantityInfo& info, const Json& ends, UnitSystem units) {
  if (!ends.is_array() || ends.size() != 2 || !ends[0].is_number() || !ends[1].is_number())
    return "";
  const auto [least, greatest] = std::minmax({ends[0].get<double>(), ends[1].get<double>()});
  return text_of(info, least, "", units) + " … " + text_of(info, greatest, "", units);
}

// Returns the value with these keys in a tree, or null.
Json value_at(const Json& tree, std::string path) {
  std::replace(path.begin(), path.end(), '.', '/');
  const Json::json_pointer place("/" + path);
  return tree.contains(place) ? tree[place] : Json();
}

Json ends_of(const QuantityRow& row, const std::vector<Json>& intervals, UnitSystem units) {
  Json texts = Json::array();
  for (std::size_t i = 0; i < row.values.size() && !intervals.empty(); ++i) {
    const bool shared = row.values.size() > intervals.size();  // a single record with both gears
    Json ends = value_at(intervals[shared ? 0 : i], row.path);
    if (shared) ends = ends.is_array() ? ends[i] : Json();
    texts.push_back(ends_text(*row.info, ends, units));
  }
  return texts;
}

// Adds the rows of a rack. If a row of gear 1 has the same quantity, the value of the rack is put
// into the second column of that row instead.
void append_rack(Json& rows, const Json& of_rack) {
  for (const Json& row : of_rack) {
    const auto same =
        std::find_if(rows.begin(), rows.end(), [&](const Json& r) { return r["id"] == row["id"]; });
    if (same != rows.end()) {
      (*same)["texts"][1] = row["texts"][1];
    } else {
      rows.push_back(row);
    }
  }
}

}  // namespace

Json rows_json(UnitSystem units, const RowTable& table) {
  Json rows = Json::array();
  for (const QuantityRow& row :
       quantity_rows(table.quantities, table.records, kPeople, units, table.range)) {
    const QuantityInfo& info = *row.info;
    Json texts = Json::array();
    for (const Value& value : row.values) texts.push_back(text_of(info, value, "–", units));
    rows.push_back({{"id", std::string(table.name) + "." + row.path},
                    {"group", row.group},
                    {"words", row.words},
                    {"symbol", info.symbol},
                    {"unit", unit_text(system_of(info, units), info.unit)},
                    {"meaning", plain_words(info.meaning)},
                    {"texts", std::move(texts)},
                    {"ends", ends_of(row, table.intervals, units)},
                    {"note", table.note ? table.note(info) : std::string()}});
  }
  return rows;
}

Json job_rows(const SolvedJob& job, UnitSystem units) {
  Json rows = Json::array();
  if (job.mounted()) {
    RowTable pair{
        .name = "pair",
        .quantities = job.rack ? rack_pair_quantities().table() : pair_quantities().table(),
        .records = {pair_record(job)}};
    if (job.pair && job.ends) pair.intervals.push_back(interval_json(pair_limits(job)));
    rows = rows_json(units, pair);
  }
  RowTable gears{.name = "gears", .quantities = gear_quantities().table()};
  RowTable halves{.name = "gears", .quantities = double_helical_quantities().table()};
  for (std::size_t i = 0; i < job.gears.size(); ++i) {
    gears.records.push_back(gear_record(job.gears[i], job.halves[i]));
    halves.records.push_back(job.halves[i] ? double_helical_quantities().of(*job.halves[i])
                                           : ValueRecord());
    if (job.ends) gears.intervals.push_back(interval_json(gear_limits(job, i)));
  }
  if (job.rack) {
    gears.records.emplace_back();  // the column of the rack
    if (job.ends) gears.intervals.emplace_back();
  }
  for (const RowTable& table : {gears, halves})
    for (Json& row : rows_json(units, table)) rows.push_back(std::move(row));
  if (job.rack)
    append_rack(rows, rows_json(units, {.name = "gears",
                                        .quantities = rack_quantities().table(),
                                        .records = {{}, rack_quantities().of(job.rack->rack)}}));
  return rows;
}

}  // namespace gearwright
