// The description of a quantity of a result (QuantityInfo), the table of the quantities of a
// record, and their values as text for users.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/catalogue/value.hpp"

namespace gearwright {

/// The interfaces that show a quantity.
enum Doors : unsigned {
  kJson = 1,     ///< JSON, and the interfaces that read JSON
  kListing = 2,  ///< the tables of the terminal
  kPage = 4,     ///< the tables of the report
  kPeople = kListing | kPage,
  kAllDoors = kJson | kPeople
};

/// The meaning of a list of two values.
enum class Two {
  values,   ///< values without a special meaning
  gears,    ///< gear 1 and gear 2, each with a column
  ends,     ///< the two ends of a range
  fraction  ///< numerator and denominator
};

struct QuantityTable;

struct QuantityInfo {
  std::string key;     ///< key in JSON, with its unit: "tip_diameter_mm"
  std::string words;   ///< the term of ISO 21771 or ISO 1122-1, if one exists
  std::string symbol;  ///< "d_a", with indices after the underscore
  Unit unit = Unit::none;
  std::string group{};    ///< heading for users
  std::string meaning{};  ///< one sentence without full stop, which also states when the value
                          ///< exists
  Type type = Type::number;
  std::vector<int> list{};  ///< lengths of nested lists, 0 for any length; empty if the value is
                            ///< not a list
  Two two = Two::values;
  bool always = false;                ///< true if the value is never null; by default, the type of
                                      ///< the getter determines this (Shape)
  std::vector<std::string> one_of{};  ///< possible values of a word
  unsigned doors = kAllDoors;
  std::optional<int> digits{};             ///< decimals for users; by default, the decimals of the
                                           ///< unit
  std::string nothing{};                   ///< text for users if there is no value
  const QuantityTable& (*of)() = nullptr;  ///< for a record, the table of its quantities
  std::string column{};                    ///< heading in CSV and Parquet; "#" is the gear's number
  bool greater_first = false;              ///< true if greater values are better
  bool only_inch = false;                  ///< true if only results in inch contain the quantity
  bool optional_key = false;               ///< true if the key is absent when the quantity does not
                                           ///< exist; if false, the value is then null
};

/// The quantities that a record may contain, in their order.
struct QuantityTable {
  std::string name;  ///< "gear", "pair", "pair.backlash"
  std::vector<const QuantityInfo*> list;
  std::vector<std::string> groups;  ///< headings for users, in their order

  const QuantityInfo* find(std::string_view key) const;
};

/// Returns the number of decimals for users, which by default is unit_digits() of the unit.
int digits_of(const QuantityInfo& info);

/// Returns the unit system for the values of this quantity in a result in `units`. Modules are in
/// mm in both systems.
UnitSystem system_of(const QuantityInfo& info, UnitSystem units);

/// Returns a value as text for users, without its unit. If there is no value or it is not finite,
/// the text is `info.nothing` or, if that is empty, `none`. A list is written as "x, y, z", two
/// ends as "lo … hi", a fraction as "p/q" (as "p" if q = 1), and values by name as "a x, b y".
std::string text_of(const QuantityInfo& info, const Value& value, std::string_view none = "–",
                    UnitSystem units = UnitSystem::mm);

/// A row for users. It shows a quantity with one text per column, or with a single text if both
/// gears share the value.
struct TextRow {
  const QuantityInfo* info;
  std::vector<std::string> texts;
  std::string_view unit;  ///< the unit of the texts, "mm" or "in"
};

struct TextGroup {
  std::string title;
  std::vector<TextRow> rows;
};

/// Returns the table for users. The table shows several records side by side (two gears), or one
/// record with values for each gear (a pair). It contains a quantity if the interface `door` has it
/// and at least one record shows it. The quantities of inner records are also rows.
std::vector<TextGroup> text_groups(const QuantityTable& table,
                                   const std::vector<ValueRecord>& records, Doors door,
                                   UnitSystem units, std::string_view none = "–");

/// Returns the text with a capital first letter, for example "Tip diameter" for "tip diameter".
std::string capitalised(std::string words);

}  // namespace gearwright
