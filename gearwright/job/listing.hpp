// Results as listings for users. A terminal shows them if --json is not given.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/job/files.hpp"

namespace gearwright {

/// The title of the spec on its own line, after `before`. The listing is empty if the spec has no
/// title.
std::string title_listing(const JobSpec& spec, std::string_view before = "");
std::string gear_listing(const SolvedJob& job);
std::string pair_listing(const Pair& pair, UnitSystem units);
/// The values of the pair and their ranges within the tolerances. The listing is empty without a
/// pair.
std::string pair_listing(const SolvedJob& job);
/// Lists records side by side, in these units, under the headings `columns`. Without `columns`
/// there is one record, which may have two values for each quantity. `note` returns the text at the
/// end of a quantity's line.
std::string quantity_listing(UnitSystem units, const QuantityTable& table,
                             const std::vector<ValueRecord>& records,
                             const std::vector<std::string>& columns,
                             const std::function<std::string(const QuantityInfo&)>& note = nullptr);
/// The rows of a gear's record that differ between the two ends of its tolerances.
///
/// Domain    the gear has tolerances
std::string interval_listing(const SolvedJob& job, std::size_t gear, const QuantityTable& table,
                             const std::array<ValueRecord, 2>& limits);
/// The column headings "gear 1" and "gear 2".
std::vector<std::string> gear_columns(std::size_t count);
std::string warning_listing(const std::vector<Warning>& warnings, UnitSystem units);
std::string file_listing(const std::vector<JobFile>& files, UnitSystem units);
/// One line per arc with its ends, then a line for every point with name, x and y.
std::string outline_listing(const Outline& outline, int n, UnitSystem units);

}  // namespace gearwright
