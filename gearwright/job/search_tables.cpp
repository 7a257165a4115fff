#include "gearwright/job/search_tables.hpp"

namespace gearwright {

const TableColumns<DesignView>& design_columns(const SearchProblem& problem) {
  static const TableColumns<DesignView> kPlain(design_quantities(),
                                               {"face_width_mm", "S_H", "S_F", "mass_kg"});
  static const TableColumns<DesignView> kWeighed(design_quantities(), {"S_H", "S_F"});
  static const TableColumns<DesignView> kRated(design_quantities());
  return problem.rating ? kRated : problem.weighs() ? kWeighed : kPlain;
}

const TableColumns<ShiftPoint>& point_columns() {
  static const TableColumns<ShiftPoint> kColumns(point_quantities());
  return kColumns;
}

}  // namespace gearwright
