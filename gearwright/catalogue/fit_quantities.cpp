#include "gearwright/catalogue/fit_quantities.hpp"

#include "gearwright/base/angle.hpp"

namespace gearwright {

namespace {

const Quantities<BranchView>& branch_quantities() {
  using B = BranchView;
  static const Quantities<B> kAll("fit.branches", [](Quantities<B>& q) {
    q.deg("", "helix_angle_deg", "helix angle", "β", "per gear",
          [](const B& b) {
            return Value(std::array{b.branch.helix[0].deg(), b.branch.helix[1].deg()});
          })
        .per_gear()
        .always();
    q.pure("", "profile_shift", "profile shift coefficient", "x", "per gear",
           [](const B& b) {
             return Value(std::array{b.branch.shift[0], b.branch.shift[1]});
           })
        .per_gear()
        .always();
    q.mm("", "center_distance_mm", "centre distance", "a", "of this answer", [](const B& b) {
       return Value(b.branch.center_distance);
     }).always();
    q.deg("", "shaft_angle_deg", "shaft angle", "Σ", "of this answer", [](const B& b) {
       return Value(b.branch.shaft_angle.deg());
     }).always();
    q.deg("", "working_normal_pressure_angle_deg", "working normal pressure angle", "α_wn",
          "of this answer",
          [](const B& b) { return Value(b.branch.working_normal_pressure_angle.deg()); })
        .always();
    q.add(Type::map, Unit::none, "", "spec", "spec", "", "the whole spec of this answer",
          [](const B& b) { return b.spec; })
        .always()
        .doors(kJson);
    q.pure("", "transverse_contact_ratio", "transverse contact ratio", "ε_α",
           "of a design with few teeth",
           [](const B& b) { return Value(b.transverse_contact_ratio); })
        .when([](const B& b) { return b.transverse_contact_ratio.has_value(); });
    q.text("refused",
           "why the verb pair rejects this answer, whose line of action is correct but whose teeth "
           "are not; absent if pair accepts it",
           [](const B& b) { return b.refused ? Value(*b.refused) : Value(); })
        .when([](const B& b) { return b.refused.has_value(); });
  });
  return kAll;
}
const QuantityTable& branch_table() { return branch_quantities().table(); }

const Quantities<Fit>& nearest_quantities() {
  static const Quantities<Fit> kAll("fit.nearest", [](Quantities<Fit>& q) {
    q.mm("", "center_distance_mm", "nearest centre distance at this shaft angle", "a",
         "null: none is near", [](const Fit& f) { return Value(f.nearest_distance); });
    q.deg("", "shaft_angle_deg", "nearest shaft angle at this centre distance", "Σ",
          "null: none is near", [](const Fit& f) {
            return f.nearest_shaft_angle ? Value(f.nearest_shaft_angle->deg()) : Value();
          });
  });
  return kAll;
}
const QuantityTable& nearest_table() { return nearest_quantities().table(); }

}  // namespace

const Quantities<FitView>& fit_quantities() {
  using V = FitView;
  static const Quantities<V> kAll("fit", [](Quantities<V>& q) {
    q.record("Answers", "branches", "by growing |β_1|, of known gears by growing α_wn",
             branch_table, [](const V& v) { return Value(branch_quantities().each(v.branches)); })
        .list({0})
        .always();
    q.text("reason", "why there is no answer; null if there is one",
           [](const V& v) { return v.fit->branches.empty() ? Value(v.fit->reason) : Value(); });
    q.record("Nearest", "nearest", "null if there are answers, or no near values", nearest_table,
             [](const V& v) {
               const Fit& f = *v.fit;
               const bool near = f.nearest_distance || f.nearest_shaft_angle;
               return f.branches.empty() && near ? Value(nearest_quantities().of(f)) : Value();
             });
  });
  return kAll;
}

}  // namespace gearwright
