#include "gearwright/report/few_teeth_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/report/quantity_table.hpp"
#include "gearwright/report/root_picture.hpp"

namespace gearwright {

std::string few_teeth_table(const std::vector<const Gear*>& gears) {
  using namespace gear_group;
  const bool any = std::any_of(gears.begin(), gears.end(), [](const Gear* g) {
    return (g->tooth && (g->tooth->root_fillet || g->tooth->tip_fillet)) ||
           root_is_worth_a_picture(*g);
  });
  if (!any) return {};
  std::vector<std::string> columns;
  std::vector<ValueRecord> records;
  for (const Gear* g : gears) {
    records.push_back(gear_quantities().of(*g));
    columns.push_back(fmt::format("Gear {}", records.size()));
  }
  std::vector<TextGroup> groups = text_groups(gear_quantities().table(), records, kPage);
  groups.erase(std::remove_if(groups.begin(), groups.end(),
                              [](const TextGroup& g) {
                                return g.title != kUndercut && g.title != kRootFillet &&
                                       g.title != kTipFillet;
                              }),
               groups.end());
  if (groups.empty()) return {};
  TableBuilder table("Points and fillets; l runs along the rack’s straight flank", columns);
  add_groups(table, groups);
  return table.str();
}

}  // namespace gearwright
