#include "gearwright/catalogue/scattered_design_quantities.hpp"

namespace gearwright {

namespace {

using D = ScatteredDesign;
// The quantities of a pair that distinguish one design from another.
constexpr ScatterQuantity kShown[] = {ScatterQuantity::peak_to_peak, ScatterQuantity::along_face,
                                      ScatterQuantity::least_play, ScatterQuantity::long_period};

bool computed(const D& d) { return d.scatter != nullptr; }

void add_scattered_design(Quantities<D>& q) {
  q.add(Type::index, "design", "number of the design", "",
        "rank of the design in the search; `gearwright search SPEC --take N` with this number "
        "prints the spec of the design",
        [](const D& d) { return static_cast<long long>(d.number); });
  q.term("module_mm", "", [](const D& d) { return d.design.row->trial.module; });
  q.term("teeth", "[z1, z2]; negative for an internal gear", [](const D& d) {
     return std::array{d.design.row->trial.z1, d.design.row->trial.z2};
   }).per_gear();
  q.term("helix_angle_deg", "> 0 right hand", [](const D& d) {
     const auto& helix = d.design.row->trial.helix;
     return std::array{tidy_degrees(helix[0]), tidy_degrees(helix[1])};
   }).per_gear();
  q.term("rack", "position of the rack in the list of racks, from 1; absent if there is one rack",
         [](const D& d) { return d.design.row->trial.rack + 1; })
      .when([](const D& d) { return d.design.problem->racks.size() > 1; });
  q.term("profile_shift", "[x1, x2]", [](const D& d) { return d.design.row->shift; }).per_gear();
  q.term("center_distance_mm", "of the design, as mounted",
         [](const D& d) { return d.design.row->center_distance; });
  q.term("face_width_mm", "of both gears", [](const D& d) { return d.design.row->face_width; });
  for (const ScatterQuantity quantity : kShown) {
    const auto at = static_cast<std::size_t>(quantity);
    const ScatterEntry& entry = scatter_entries()[at];
    q.record<spread_quantities>(
         entry.key,
         entry.meaning, [at](const D& d) -> const auto& { return d.scatter->spread[at]; })
        .when(computed)
        .doors(kJson);
  }
  q.record<probabilities_quantities>("probability",
                                     "probabilities of events, with the interval of Clopper and "
                                     "Pearson",
                                     [](const D& d) -> const ScatterView& { return *d.scatter; })
      .when(computed)
      .doors(kJson);
  q.record<loaded_spread_quantities>(
       "loaded", "results under each torque of `[load]`; only with `loaded`",
       [](const D& d) -> const auto& { return d.scatter->loaded; })
      .when([](const D& d) { return computed(d) && d.scatter->task->load.has_value(); })
      .doors(kJson);
  q.text("reason", "reason why the scatter of the design was not computed; only in `refused`",
         &D::reason)
      .when([](const D& d) { return !computed(d); });
}

}  // namespace

const Quantities<ScatteredDesign>& scattered_design_quantities() {
  return define<add_scattered_design>("scatter_designs.designs");
}

const Quantities<ScatterStudyView>& scatter_study_quantities() {
  return define("scatter_designs", [](Quantities<ScatterStudyView>& q) {
    q.number("percentile", "percentile of the ranking", "p", "the greatest of `percentiles`",
             &ScatterStudyView::percent);
    q.term("samples", "", &ScatterStudyView::samples);
    q.term("replicates", "", &ScatterStudyView::replicates);
    q.add(Type::index, "seed", "seed", "", "", &ScatterStudyView::seed);
    q.add(Type::index, "count", "number of designs", "", "including the designs in `refused`",
          &ScatterStudyView::count);
    q.record<scattered_design_quantities>(
        "designs",
        "designs in the order of the percentile of their peak-to-peak transmission error, the "
        "least first; designs that lose contact in more than (100 − p) % of the samples are last",
        [](const ScatterStudyView&) { return ValueList(); });
    q.record<scattered_design_quantities>("refused", "designs whose scatter was not computed",
                                          [](const ScatterStudyView&) { return ValueList(); });
  });
}

}  // namespace gearwright
