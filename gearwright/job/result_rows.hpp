// Makes the rows of results as JSON, for the tables of the page. The rows have the words, values
// and units of the listings (job/listing.hpp). Internal to job/ and the programs.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/quantity_rows.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {

/// A table of the page with one or two records of the same quantities.
struct RowTable {
  std::string_view name;  ///< first word of the ids, "gears"
  const QuantityTable& quantities;
  std::vector<ValueRecord> records = {};
  RowRange range = RowRange::all;
  std::vector<Json> intervals = {};  ///< interval_json() of each record; empty without tolerances
  std::function<std::string(const QuantityInfo&)> note = nullptr;  ///< text after the values
};

/// Returns the rows of a table: [{id, group, words, symbol, unit, meaning, texts, ends, note}].
/// `texts` has one text for each column. `ends` also has one text for each column. This text
/// contains the values at both ends of the tolerances, the smaller value first. It is empty if the
/// value does not depend on the tolerances. Without tolerances, the list `ends` is empty.
Json rows_json(UnitSystem units, const RowTable& table);

/// Returns the rows of the pair, with ids that begin with "pair", and the rows of the gears, with
/// ids that begin with "gears". A rack is gear 2.
Json job_rows(const SolvedJob& job, UnitSystem units);

}  // namespace gearwright
