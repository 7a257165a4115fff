// The units of all quantities, for answers in inch. The unit at the end of a key, or of the nearest
// key around it, determines how a number is converted (spec/unit_tree.cpp). This must be the unit
// of the quantity.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include <nlohmann/json.hpp>

#include "gearwright/catalogue/unit_system.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {
namespace {

// Quantities whose unit another member of their record names (kUnitMembers of spec/unit_tree.cpp).
const std::set<std::string> kNamedUnits{"value",   "expected", "expect",  "tool",
                                        "x_range", "x_values", "y_range", "y_values",
                                        "points",  "amount",   "leading", "trailing"};

bool is_length(Unit unit) { return unit_in(UnitSystem::inch, unit) != unit; }

// Distributions of a quantity, whose numbers are in the unit of the key of their record.
const std::set<std::string> kInUnitOfRecord{"scatter spread", "scatter.standard_errors"};
// Shares of the variance of a quantity, which are pure numbers.
const std::set<std::string> kShares{"scatter.index"};

struct Walk {
  std::set<std::pair<const QuantityTable*, Unit>> seen{};
  std::set<const QuantityTable*> tables{};
  std::vector<std::string> faults{};

  // `around` is the unit of the nearest key with a unit, or none if that unit is not a length.
  void check(const QuantityTable& table, Unit around) {
    tables.insert(&table);
    if (!seen.insert({&table, around}).second) return;
    for (const QuantityInfo* q : table.list) {
      const std::string name = table.name + "." + q->key;
      Unit own = unit_of(q->key);
      if (q->key.ends_with("_mm_per_turn")) own = Unit::mm;
      const Unit given =
          metric_unit(q->key) ? own : Unit::none;  // the unit that an answer in inch replaces
      const Unit effective = own != Unit::none             ? given
                             : is_in_unit_of_table(q->key) ? around
                                                           : Unit::none;
      if (q->of) {
        check(q->of(), effective);
        continue;
      }
      if (q->type == Type::map || q->type == Type::text || q->type == Type::word ||
          q->type == Type::flag)
        continue;
      const bool in_both =
          own != Unit::none && given == Unit::none;  // a module, a force per length
      if (kNamedUnits.contains(q->key) && (table.find("unit") || table.find("x"))) continue;
      if (is_length(q->unit) && !in_both && q->unit != effective)
        faults.push_back(name + ": has a length without its key");
      if (kInUnitOfRecord.contains(table.name) || kShares.contains(table.name)) continue;
      if (is_length(effective) && q->unit != effective)
        faults.push_back(name + ": is converted, but is not in the unit of its key");
      static const std::regex kLength("(^|[^a-z/])(mm|µm)($|[^a-z²/])");
      if (effective == Unit::none && own == Unit::none && q->unit == Unit::none &&
          std::regex_search(q->meaning, kLength))
        faults.push_back(name + ": has the meaning \"" + q->meaning + "\" and no unit");
    }
  }
};

TEST(ResultUnits, every_quantity_is_in_the_unit_by_which_it_is_converted) {
  std::set<const QuantityTable*> inner;
  for (const QuantityTable* table : result_tables())
    for (const QuantityInfo* q : table->list)
      if (q->of && &q->of() != table) inner.insert(&q->of());
  Walk walk;
  for (const QuantityTable* table : result_tables())
    if (!inner.contains(table)) walk.check(*table, Unit::none);
  EXPECT_EQ(walk.tables.size(), result_tables().size());
  EXPECT_EQ(walk.faults, std::vector<std::string>());
}

TEST(ResultUnits, shares_of_a_length_are_not_converted) {
  const Json record{
      {"scatter",
       {{"tip_clearance1_mm", {{"mean", 25.4}}},
        {"indices", {{"tip_clearance1_mm", {{"first", {1.0}}, {"linear_share", 0.5}}}}}}}};
  const Json inch = in_units(UnitSystem::inch, record)["scatter"];
  EXPECT_EQ(inch["tip_clearance1_in"]["mean"], 1.0);
  EXPECT_EQ(inch["indices"]["tip_clearance1_in"]["first"][0], 1.0);
  EXPECT_EQ(inch["indices"]["tip_clearance1_in"]["linear_share"], 0.5);
}

}  // namespace
}  // namespace gearwright
