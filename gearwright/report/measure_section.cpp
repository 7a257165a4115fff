#include "gearwright/report/measure_section.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/catalogue/measure_quantities.hpp"
#include "gearwright/report/quantity_table.hpp"

namespace gearwright {

std::string measure_section(const std::vector<ValueRecord>& measures,
                            const std::vector<std::vector<ValueRecord>>& ends,
                            const std::vector<KDiagram>& diagrams) {
  const auto groups = text_groups(measure_quantities().table(), measures, kPage);
  if (groups.empty()) return {};
  std::vector<std::string> columns;
  for (std::size_t i = 1; i <= measures.size(); ++i) columns.push_back(fmt::format("Gear {}", i));
  TableBuilder table("What is measured, thickness allowances included", columns);
  add_groups(table, groups);
  std::string text = table.str();
  for (std::size_t i = 0; i < std::min(ends.size(), columns.size()); ++i) {
    const auto differing = text_groups(measure_quantities().table(), ends[i], kPage);
    if (differing.empty()) continue;
    TableBuilder interval(columns[i] + " between its thickness allowances", {"Lower", "Upper"});
    add_groups(interval, differing);
    text += interval.str();
  }
  return "<section>\n<h2>Measuring</h2>\n" + text + k_figures(diagrams) + "</section>\n";
}

}  // namespace gearwright
