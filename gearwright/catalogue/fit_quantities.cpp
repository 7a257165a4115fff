#include "gearwright/catalogue/fit_quantities.hpp"

namespace gearwright {

namespace {

const Quantities<Fit>& nearest_quantities() {
  return define("fit.nearest", [](Quantities<Fit>& q) {
    q.term("center_distance_mm", "null if no such value was found", &Fit::nearest_distance)
        .words("nearest centre distance for which a solution exists");
    q.term("shaft_angle_deg", "null if no such value was found", &Fit::nearest_shaft_angle)
        .words("nearest shaft angle for which a solution exists");
  });
}

}  // namespace

const Quantities<BranchView>& branch_quantities() {
  using B = BranchView;
  return define("fit.branches", [](Quantities<B>& q) {
    q.term("helix_angle_deg", "per gear", [](const B& b) { return b.branch.helix; }).per_gear();
    q.term("profile_shift", "per gear", [](const B& b) {
       return std::array{b.branch.shift[0], b.branch.shift[1]};
     }).per_gear();
    q.term("center_distance_mm", "of this branch",
           [](const B& b) { return b.branch.center_distance; });
    q.term("shaft_angle_deg", "of this branch", [](const B& b) { return b.branch.shaft_angle; });
    q.term("working_normal_pressure_angle_deg", "of this branch",
           [](const B& b) { return b.branch.working_normal_pressure_angle; });
    q.add(Type::map, "spec", "spec", "", "the complete spec of this branch", &B::spec)
        .always()
        .doors(kJson);
    q.term("transverse_contact_ratio", "only for a design with few teeth",
           &B::transverse_contact_ratio)
        .when([](const B& b) { return b.transverse_contact_ratio.has_value(); });
    q.text("refused",
           "reason why the verb `pair` rejects the teeth of this branch, although its line of "
           "action is correct; absent if `pair` accepts the branch",
           &B::refused)
        .when([](const B& b) { return b.refused.has_value(); });
  });
}

const Quantities<FitView>& fit_quantities() {
  using V = FitView;
  return define("fit", [](Quantities<V>& q) {
    q.under("Answers");
    q.record<branch_quantities>(
        "branches",
        "solutions in the order of |β_1|, or in the order of α_wn if the gears are known",
        &V::branches);
    q.text("reason", "reason why there is no solution; null if there is a solution",
           [](const V& v) { return v.branches.empty() ? Value(v.fit.reason) : Value(); });
    q.under("Nearest");
    q.record<nearest_quantities>(
        "nearest",
        "nearest values for which a solution exists; null if there is a solution, or if there are "
        "no such values",
        [](const V& v) {
          const bool near = v.fit.nearest_distance || v.fit.nearest_shaft_angle;
          return v.branches.empty() && near ? &v.fit : nullptr;
        });
  });
}

}  // namespace gearwright
