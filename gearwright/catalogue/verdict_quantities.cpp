#include "gearwright/catalogue/gear_quantities.hpp"

#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

namespace {

ValueMap values_of(const Finding& finding) {
  ValueMap values;
  for (const FindingValue& v : finding.values)
    values.emplace_back(v.name + (v.length ? "_mm" : ""), Value(v.value));
  return values;
}

// Returns the path of the member that a change sets, relative to the table of the gear or of the
// pair.
const char* member_of(Adjustable what) {
  switch (what) {
    case Adjustable::profile_shift: return "profile_shift";
    case Adjustable::tip_diameter: return "tip_diameter";
    case Adjustable::thickness_allowance: return "thickness_allowance";
    case Adjustable::teeth: return "teeth";
    case Adjustable::helix_angle: return "helix_angle";
    case Adjustable::face_width: return "face_width";
    case Adjustable::bore: return "bore.diameter";
    case Adjustable::lead_crowning: return "modifications.lead_crowning";
    case Adjustable::lead_slope: return "modifications.lead_slope";
    case Adjustable::center_distance: return "center_distance";
  }
  return "";
}

ValueMap change_of(const Finding& finding) {
  ValueMap keys;
  if (!finding.change) return keys;
  const auto& [what, gear, value, path] = *finding.change;
  if (!path.empty()) {
    keys.emplace_back(path, Value(value));
    return keys;
  }
  const auto add = [&, what = what, value = value](const std::string& table) {
    keys.emplace_back(spelled_member(table, member_of(what)).key, Value(value));
  };
  if (what == Adjustable::center_distance) {
    add("pair");
  } else {
    for (const int which : {1, 2})
      if (gear == 0 || gear == which) add(gear_field(which));
  }
  return keys;
}

const Quantities<Finding>& finding_quantities() {
  using F = Finding;
  return define("verdict.finding", [](Quantities<F>& q) {
    q.text("code",
           "code of a warning, or `form_margin`, `fillet_margin`, `tip_margin`, `edge_contact`, "
           "`contact_place`, `root_safety`, `flank_safety`, `spectrum_safety`",
           [](const F& f) { return to_string(f.code); });
    q.word("level", "level", "level of the finding; green is only information", [](const F& f) {
       return to_string(f.level);
     }).one_of({"green", "amber", "red"});
    q.term("gear", "number of the gear, 1 or 2; null for the pair or the spec",
           [](const F& f) { return f.gear ? Value(f.gear) : Value(); });
    q.text("message", "sentence for users", &F::message);
    q.text("at",
           "ends of the tolerances at which the finding occurs; null if the finding occurs at the "
           "nominal values",
           [](const F& f) { return f.at.empty() ? Value() : Value(f.at); });
    q.text("remedy",
           "change that removes the finding, verified by computation; null if no such single "
           "change was found",
           [](const F& f) { return f.remedy.empty() ? Value() : Value(f.remedy); });
    q.add(Type::map, "change", "change", "",
          "keys of the spec that the remedy sets, with their values", change_of);
    q.add(Type::map, "values", "values", "",
          "values that led to the finding, by name, such as a clearance and its limit; names of "
          "lengths end in `_mm`",
          values_of);
  });
}

}  // namespace

const Quantities<Verdict>& verdict_quantities() {
  using V = Verdict;
  return define("verdict", [](Quantities<V>& q) {
    q.word("level", "verdict",
           "green means that the gears run without findings, amber that the gears run but the "
           "findings should be checked, and red that the gears cannot be made as specified or do "
           "not run",
           [](const V& v) { return to_string(v.level); })
        .one_of({"green", "amber", "red"});
    q.text("headline", "the verdict in words, with the worst finding and a remedy", &V::headline);
    q.record<finding_quantities>(
        "findings", "all warnings and all margins that are too small, with the worst finding first",
        &V::findings);
    q.add(Type::text, "not_judged", "not judged", "",
          "parts of the spec that this verb did not compute: `pair`, `contact`, `load`, `rating`, "
          "or, in a drive, the rating of a mesh that ISO 6336 does not cover",
          &V::not_judged);
  });
}

}  // namespace gearwright
