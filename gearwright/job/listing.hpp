// Writes results as listings for users. The program prints a listing if neither --json nor --csv is
// given. Internal to job/, the programs and tests.
#pragma once

#include <cstddef>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/catalogue/text_table.hpp"
#include "gearwright/job/files.hpp"

namespace gearwright {

struct RecordLimits;

/// Returns a line that consists of `before` and the title of the spec. The text is empty if the
/// spec has no title.
std::string title_listing(const JobSpec& spec, std::string_view before = "");
std::string gear_listing(const SolvedJob& job);
std::string pair_listing(const Pair& pair, UnitSystem units);
/// Lists the values of the pair and their ranges within the tolerances, or the values of a rack and
/// its pinion. The text is empty for a single gear.
std::string pair_listing(const SolvedJob& job);
/// Lists records side by side, in these units, under the headings `columns`. If `columns` is empty,
/// there is only one record, which may have two values for each quantity. `note` returns a text for
/// the end of the line of a quantity.
std::string quantity_listing(UnitSystem units, const QuantityTable& table,
                             const std::vector<ValueRecord>& records,
                             const std::vector<std::string>& columns,
                             const std::function<std::string(const QuantityInfo&)>& note = nullptr);
template <class S>
std::string listing_of(UnitSystem units, const Quantities<S>& quantities,
                       const std::type_identity_t<S>& subject) {
  return quantity_listing(units, quantities.table(), {quantities.of(subject)}, {});
}
/// Lists the rows of a gear's record that differ between the lower and the upper end of its
/// tolerances. The text is empty if no row differs.
///
/// Domain    the job has tolerances (job.ends)
std::string interval_listing(const SolvedJob& job, std::size_t gear, const QuantityTable& table,
                             const RecordLimits& limits);
std::vector<std::string> gear_columns(std::size_t count);
std::string warning_listing(const std::vector<Warning>& warnings, UnitSystem units);
std::string file_listing(const std::vector<JobFile>& files, UnitSystem units);
/// Lists n points of every arc, including its ends. The first line contains the headings. Every
/// other line contains the name of the arc, x and y.
std::string outline_listing(const Outline& outline, int n, UnitSystem units);

// Tables for terminals with one row for each record, such as a point of contact or a design.
//
// A line of a table of designs has at most kTableWidth characters, unless a single column is wider.
// To keep this width, a column with equal values in all rows is listed once above the table.
// Columns that do not fit are moved to a second table with the same rows.
//
// The width of a text is its number of characters. In a terminal, each character of the listings
// takes one column.

constexpr std::size_t kLineWidth = 80;    ///< width of sentences, the usual width of a terminal
constexpr std::size_t kTableWidth = 110;  ///< width of tables with a row for each design

/// Returns the text, filled on the right with blanks to `width` characters.
std::string padded(const std::string& text, std::size_t width);
/// Returns the text, filled on the left with blanks to `width` characters.
std::string padded_left(const std::string& text, std::size_t width);

/// Breaks sentences at blanks into lines of at most kLineWidth characters. A longer word has a line
/// of its own. Blanks at the start are kept, and the lines after the first begin with two
/// additional blanks. Every line ends with a line break.
std::string wrapped(std::string_view text);

/// Lists records below each other, in these units. The line of each record begins with its name and
/// has the columns of `keys`.
std::string row_listing(UnitSystem units, const std::vector<std::string>& names,
                        const std::vector<ValueRecord>& records,
                        std::initializer_list<std::string_view> keys);

/// Lists a table with its title and its notes. If TextTable::omit_zeros is set, and all numbers of
/// a row are printed as zero, the row is omitted, and a line below the table contains its words.
std::string table_listing(const TextTable& table);

/// Lists designs below each other. The first column names the designs. If there are at least two
/// designs, some columns are replaced by the list "Common to all designs" above the table. These
/// are the columns with the same text in all rows, and the columns whose numbers are equal to those
/// of an earlier column or differ from them only in sign.
std::string design_listing(const std::vector<ListingColumn>& columns);
/// Lists the designs of a search in their order, with their ranks, the column `second` and the
/// quantities `keys` of `records`. `pareto` contains the indices of the Pareto front.
std::string ranked_listing(UnitSystem units, const std::vector<std::size_t>& pareto,
                           ListingColumn second, const std::vector<ValueRecord>& records,
                           std::initializer_list<std::string_view> keys);

}  // namespace gearwright
