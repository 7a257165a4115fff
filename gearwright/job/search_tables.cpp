#include "gearwright/job/search_tables.hpp"

namespace gearwright {

const TableColumns<DesignView>& design_columns() {
  static const TableColumns<DesignView> kColumns(design_quantities());
  return kColumns;
}

const TableColumns<ShiftPoint>& point_columns() {
  static const TableColumns<ShiftPoint> kColumns(point_quantities());
  return kColumns;
}

}  // namespace gearwright
