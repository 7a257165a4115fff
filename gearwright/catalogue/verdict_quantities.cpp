#include "gearwright/catalogue/verdict_quantities.hpp"

namespace gearwright {

namespace {

Value values_of(const Finding& finding) {
  ValueMap values;
  for (const FindingValue& v : finding.values)
    values.emplace_back(v.name + (v.length ? "_mm" : ""), Value(v.value));
  return values;
}

const Quantities<Finding>& finding_quantities() {
  using F = Finding;
  static const Quantities<F> kAll("verdict.finding", [](Quantities<F>& q) {
    q.text("code",
           "of a warning, or `form_margin`, `fillet_margin`, `tip_margin`, `edge_contact`, "
           "`contact_place`, `root_safety`, `flank_safety`",
           [](const F& f) { return Value(f.code); })
        .always();
    q.word("", "level", "level", "green: good to know",
           [](const F& f) { return Value(to_string(f.level)); })
        .always()
        .one_of({"green", "amber", "red"});
    q.whole("", "gear", "gear", "", "1 or 2; null for the pair or the spec",
            [](const F& f) { return f.gear ? Value(f.gear) : Value(); });
    q.text("message", "one sentence for people", [](const F& f) {
       return Value(f.message);
     }).always();
    q.text("remedy", "what would help; null where nothing is to be done",
           [](const F& f) { return f.remedy.empty() ? Value() : Value(f.remedy); });
    q.add(Type::map, Unit::none, "", "values", "values", "",
          "the numbers of a margin, by keys with their units", values_of)
        .always();
  });
  return kAll;
}

const SaidTable& finding_table() { return finding_quantities().table(); }

}  // namespace

const Quantities<Verdict>& verdict_quantities() {
  using V = Verdict;
  static const Quantities<V> kAll("verdict", [](Quantities<V>& q) {
    q.word("", "level", "verdict",
           "green: it runs and nothing asks for a look; amber: it runs, somebody should look; red: "
           "as specified it cannot be made or does not run",
           [](const V& v) { return Value(to_string(v.level)); })
        .always()
        .one_of({"green", "amber", "red"});
    q.text("headline", "the verdict in words, with the worst finding and what would help",
           [](const V& v) { return Value(v.headline); })
        .always();
    q.record("", "findings", "worst first: all warnings, and margins that are too small",
             finding_table, [](const V& v) { return Value(finding_quantities().each(v.findings)); })
        .always()
        .list({0});
  });
  return kAll;
}

}  // namespace gearwright
