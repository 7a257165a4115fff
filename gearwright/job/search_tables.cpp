#include "gearwright/job/search_tables.hpp"

#include <set>

namespace gearwright {

void add_heads(const RecordColumn& column, std::vector<ParquetColumn>& heads) {
  const QuantityInfo& info = column.info();
  const ParquetType type = info.type == Type::index ? ParquetType::int64
                           : info.type == Type::whole || info.type == Type::flag
                               ? ParquetType::int32
                           : info.type == Type::number ? ParquetType::float64
                                                       : ParquetType::text;
  const std::size_t mark = info.column.find('#');
  const std::vector<std::string> names = info.list.empty() ? std::vector<std::string>{""}
                                         : info.two == Two::ends
                                             ? std::vector<std::string>{"min", "max"}
                                             : std::vector<std::string>{"1", "2"};
  for (const std::string& name : names) {
    std::string head = info.column;
    if (mark != std::string::npos) head.replace(mark, 1, name);
    heads.push_back({std::move(head), type, !info.always});
  }
}

TableColumns<DesignView> design_columns(const SearchProblem& problem) {
  // Only some searches have these columns. The problem determines which of them exist.
  const std::set<std::string_view> optional{"backlash_mm", "face_width_mm", "S_H",
                                            "S_F",         "mass_kg",       "efficiency",
                                            "balance",     "relative_cost", "noise_um"};
  const DesignRow any;
  std::vector<std::string_view> without;
  for (const Quantity<DesignView>& q : design_quantities().list())
    if (optional.contains(q.info.key) && !q.exists({&problem, &any})) without.push_back(q.info.key);
  return TableColumns<DesignView>(design_quantities(), without);
}

TableColumns<ShiftPoint> point_columns() { return TableColumns<ShiftPoint>(point_quantities()); }

}  // namespace gearwright
