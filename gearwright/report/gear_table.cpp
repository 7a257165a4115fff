#include "gearwright/report/gear_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/report/quantity_table.hpp"
#include "gearwright/report/shown_values.hpp"

namespace gearwright {

using shown::given;
using shown::none;

namespace {

constexpr int kRackDigits = 6;  // of arcs, in modules or degrees

std::optional<double> unless_zero(double value) {
  return value != 0.0 ? std::optional(value) : std::nullopt;
}

// Rows that no rack has a number for are left out. A gear that a pinion has cut has no rack.
void add_rack(TableBuilder& table, const std::vector<const Gear*>& gears) {
  struct Row {
    const char *words, *symbol, *unit;
    std::optional<double> (*value)(const StraightRack&);
  };
  static const std::array<Row, 8> kRows{
      {{"Addendum", "h_aP*", "", [](const StraightRack& r) { return std::optional(r.addendum); }},
       {"Dedendum", "h_fP*", "", [](const StraightRack& r) { return std::optional(r.dedendum); }},
       {"Root fillet radius", "ρ_fP*", "",
        [](const StraightRack& r) { return std::optional(r.root_fillet_radius); }},
       {"Tip fillet radius", "ρ_1*", "",
        [](const StraightRack& r) { return unless_zero(r.tip_fillet_radius); }},
       {"Height of the tool’s straight flank", "", "",
        [](const StraightRack& r) { return r.tool_addendum; }},
       {"Semi-topping angle", "", "°",
        [](const StraightRack& r) {
          return r.semi_topping_angle ? std::optional(r.semi_topping_angle->deg()) : std::nullopt;
        }},
       {"Protuberance", "pr_P*", "",
        [](const StraightRack& r) { return unless_zero(r.protuberance); }},
       {"Protuberance angle", "α_pr", "°", [](const StraightRack& r) {
          return r.protuberance != 0.0 ? std::optional(r.protuberance_angle.deg()) : std::nullopt;
        }}}};
  const auto rack_of = [](const Gear& g) {
    return g.cut_by || !g.involute() ? nullptr : &g.spec.straight_rack();
  };
  if (std::none_of(gears.begin(), gears.end(), [&](const Gear* g) { return rack_of(*g); })) return;
  table.group("Basic rack, in normal modules");
  for (const Row& row : kRows) {
    std::vector<std::string> values;
    bool any = false;
    for (const Gear* g : gears) {
      const StraightRack* rack = rack_of(*g);
      const std::optional<double> v = rack ? row.value(*rack) : std::nullopt;
      values.push_back(v ? given(*v) : none());
      any = any || v;
    }
    if (any) table.row(row.words, row.symbol, row.unit, values);
  }
}

// The arcs of a rack, one row each: signed radius, place of the centre, from which to which angle.
void add_arcs(TableBuilder& table, const std::vector<const Gear*>& gears) {
  std::size_t most = 0;
  for (const Gear* g : gears) most = std::max(most, g->arcs() ? g->arcs()->rack.arcs.size() : 0);
  if (most == 0) return;
  table.group("Basic rack of arcs, in normal modules; from the cutter’s tip on");
  const auto row = [&](const char* words, const char* symbol, const char* unit, const auto& value) {
    std::vector<std::string> values;
    for (const Gear* g : gears) values.push_back(g->arcs() ? value(g->arcs()->rack) : none());
    table.row(words, symbol, unit, values);
  };
  row("Addendum", "h_a*", "", [](const RackOfArcs& r) { return given(r.addendum); });
  row("Dedendum", "h_f*", "", [](const RackOfArcs& r) { return given(r.dedendum); });
  for (std::size_t i = 0; i < most; ++i) {
    const auto of = [i](double RackArc::*member) {
      return [i, member](const RackOfArcs& r) {
        return i < r.arcs.size() ? fixed(r.arcs[i].*member, kRackDigits) : none();
      };
    };
    const std::string n = std::to_string(i + 1);
    row(("Arc " + n + ": radius, > 0 convex, < 0 concave tooth").c_str(), "q*", "",
        of(&RackArc::radius));
    row("  height of its centre", "x*", "", of(&RackArc::center_height));
    row("  distance of its centre from the tooth’s middle", "y*", "", of(&RackArc::center_offset));
    row("  normal angle, root … tip", "τ", "°", [i](const RackOfArcs& r) {
      if (i >= r.arcs.size()) return none();
      return fixed(r.arcs[i].begin.deg(), kRackDigits) + " … " +
             fixed(r.arcs[i].end.deg(), kRackDigits);
    });
  }
}

}  // namespace

std::string gear_table(const std::vector<const Gear*>& gears) {
  using namespace gear_group;
  std::vector<std::string> columns;
  std::vector<ValueRecord> records;
  for (const Gear* g : gears) {
    records.push_back(gear_quantities().of(*g));
    columns.push_back(fmt::format("Gear {}", records.size()));
  }
  // What only gears with few teeth have stands in a table of its own (few_teeth_table.hpp).
  std::vector<TextGroup> common, cutter;
  for (TextGroup& g : text_groups(gear_quantities().table(), records, kPage)) {
    if (g.title == kCutter)
      cutter.push_back(std::move(g));
    else if (g.title == kTeeth || g.title == kDiameters || g.title == kTooth)
      common.push_back(std::move(g));
  }
  TableBuilder table("Gear data, symbols of ISO 21771", columns);
  add_groups(table, common);
  add_rack(table, gears);
  add_arcs(table, gears);
  add_groups(table, cutter);
  return table.str();
}

}  // namespace gearwright
