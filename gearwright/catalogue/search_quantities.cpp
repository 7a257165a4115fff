#include "gearwright/catalogue/search_quantities.hpp"

#include "gearwright/catalogue/spelling.hpp"

namespace gearwright {

SpelledChange spelled_change(const NearestChange& change) {
  const bool of_search = !change.field.starts_with("rating.") && !change.field.starts_with("gear");
  SpelledChange spelled{spelled_member((of_search ? "search." : "") + change.field), change.from,
                        change.to};
  if (change.field == "limits.avoid_interference")
    spelled = {"search.interference", "\"exclude\"", "\"flag\""};
  if (change.field.ends_with("material.name"))
    spelled = {spelled.key, "\"" + change.from + "\"", "\"" + change.to + "\""};
  return spelled;
}

namespace {

const Quantities<NearestChange>& change_quantities() {
  using C = NearestChange;
  static const Quantities<C> kAll("search.changes", [](Quantities<C>& q) {
    q.text("key", "of the spec", [](const C& c) { return spelled_change(c).key; }).always();
    q.text("from", "as given", [](const C& c) { return spelled_change(c).from; }).always();
    q.text("to", "with which a design exists", [](const C& c) {
       return spelled_change(c).to;
     }).always();
    q.number("effort", "effort", "", "they are ordered by it", &C::effort).always();
  });
  return kAll;
}
const Quantities<SearchLimits>& margin_quantities() {
  using L = SearchLimits;
  static const Quantities<L> kAll("search.margins", [](Quantities<L>& q) {
    q.word("interference", "interference", "`exclude` or `flag`",
           [](const L& l) { return l.avoid_interference ? "exclude" : "flag"; })
        .one_of({"exclude", "flag"})
        .always();
    q.number("tip_clearance_min", "tip clearance", "c", "`null`: none is asked", &L::tip_clearance);
    q.number("form_clearance_min", "form clearance", "c_F", "along the line of action",
             &L::form_clearance)
        .always();
    q.number("safety_flank_min", "safety against pitting", "S_Hmin", "where one is asked",
             &L::safety_flank)
        .when([](const L& l) { return l.safety_flank.has_value(); });
    q.number("safety_root_min", "safety against root breakage", "S_Fmin", "where one is asked",
             &L::safety_root)
        .when([](const L& l) { return l.safety_root.has_value(); });
  });
  return kAll;
}

void say_search(Quantities<SearchView>& q) {
  using S = SearchView;
  const auto count = [&q](const char* key, const char* meaning,
                          std::int64_t SearchCounts::*member) -> Quantity<S>& {
    return q
        .add(Type::index, key, key, "", meaning,
             [member](const S& s) { return s.answer->counts.*member; })
        .always();
  };
  const auto grid = [](const S& s) { return s.problem->shift_step.has_value(); };
  count("tested", "trials: modules, z1, z2, helices and racks tried", &SearchCounts::tested);
  count("feasible_count", "those with a region", &SearchCounts::feasible);
  q.add(Type::map, "rejected", "rejected", "",
        "number of trials that each limit ruled out; the first limit that leaves nothing counts, "
        "in the order `shift_limits`, `center_distance`, `contact_ratio`, `overlap_ratio`, "
        "`sliding`, `tip_clearance`, `interference`, of a rated search `safety_flank`, "
        "`safety_root`; no working angle counts as `contact_ratio`",
        [](const S& s) {
          ValueMap map;
          for (std::size_t i = 0; i < static_cast<std::size_t>(s.problem->limit_count()); ++i)
            map.emplace_back(name(static_cast<Limit>(i)), s.answer->counts.rejected[i]);
          return Value(std::move(map));
        })
      .always();
  q.record<margin_quantities>(
       "margins", "limits that every design satisfies; clearances in modules",
       [](const S& s) -> const auto& { return s.problem->limits; })
      .always();
  count("points_tested", "of the grid of `shift_step`", &SearchCounts::points_tested).when(grid);
  count("points_feasible", "of the grid of `shift_step`", &SearchCounts::points_feasible)
      .when(grid);
  q.record<change_quantities>(
       "changes",
       "if no design is feasible: single changes that would make designs feasible, the "
       "smallest first; for at most 2 million trials",
       [](const S& s) { return change_quantities().each(*s.changes); })
      .always()
      .list({0})
      .when([](const S& s) { return s.answer->counts.feasible == 0; });
  q.record<design_quantities>(
       "safest",
       "if no design is feasible: the rated design, among at most 10 000, that comes nearest to "
       "the required safeties",
       [](const S& s) {
         return s.safest ? Value(design_quantities().of({s.problem, s.safest})) : Value();
       })
      .when([](const S& s) { return s.safest != nullptr; });
  q.add(Type::index, "pareto", "Pareto front", "",
        "positions in `designs` of the Pareto-optimal designs, with several objectives",
        [](const S& s) {
          const auto& front = s.answer->pareto;
          return Value(ValueList(front.begin(), front.end()));
        })
      .list({0})
      .always()
      .doors(kJson);
  q.record<design_quantities>("designs", "best first, every feasible one up to 100 000, or `--top`",
                              [](const S&) { return Value(ValueList()); })
      .list({0})
      .always();
}

}  // namespace

const Quantities<SearchView>& search_quantities() {
  static const Quantities<SearchView> kAll("search", say_search);
  return kAll;
}

}  // namespace gearwright
