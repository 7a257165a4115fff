#include "gearwright/catalogue/search_quantities.hpp"

#include "gearwright/catalogue/spelling.hpp"

namespace gearwright {

SpelledChange spelled_change(const NearestChange& change, UnitSystem units) {
  const SpelledMember from = spelled_member("search", change.field, change.from);
  SpelledChange spelled{from.key, from.value,
                        spelled_member("search", change.field, change.to).value};
  if (const KeyUnit* unit = metric_unit(spelled.key)) {
    spelled = {key_in(units, spelled.key), numbers_in(units, spelled.from, *unit),
               numbers_in(units, spelled.to, *unit)};
  }
  return spelled;
}

namespace {

const Quantities<NearestChange>& change_quantities() {
  using C = NearestChange;
  return define("search.changes", [](Quantities<C>& q) {
    q.text("key", "key of the spec", [](const C& c) { return spelled_change(c).key; });
    q.text("from", "value as given", [](const C& c) { return spelled_change(c).from; });
    q.text("to", "value for which a design is feasible",
           [](const C& c) { return spelled_change(c).to; });
    q.number("effort", "effort", "",
             "effort of the change; the changes are in ascending order of this value", &C::effort);
  });
}
const Quantities<SearchProblem>& margin_quantities() {
  using P = SearchProblem;
  return define("search.margins", [](Quantities<P>& q) {
    q.word("interference", "interference", "`exclude` or `flag`", [](const P& p) {
       return p.limits.avoid_interference ? "exclude" : "flag";
     }).one_of({"exclude", "flag"});
    q.number("tip_clearance_min", "tip clearance", "c",
             "required tip clearance; `null` if there is no limit",
             [](const P& p) { return p.limits.tip_clearance; });
    q.number("form_clearance_min", "form clearance", "c_F",
             "required form clearance along the line of action",
             [](const P& p) { return p.limits.form_clearance; });
    q.number("safety_flank_min", "safety against pitting", "S_Hmin",
             "required safety; only if a safety is required",
             [](const P& p) { return p.limits.safety_flank; })
        .when([](const P& p) { return p.limits.safety_flank.has_value(); });
    q.number("safety_root_min", "safety against root breakage", "S_Fmin",
             "required safety; only if a safety is required",
             [](const P& p) { return p.limits.safety_root; })
        .when([](const P& p) { return p.limits.safety_root.has_value(); });
    const auto drawn = [](const P& p) { return static_cast<bool>(p.draw); };
    q.word("mounting", "mounting", "mounting of the drawn designs; only if designs are drawn",
           [](const P& p) { return p.mounting == Mounting::tight ? "tight" : "extended"; })
        .one_of({"extended", "tight"})
        .when(drawn);
    q.text("thickness_series", "series of DIN 3967 for both gears; `null` if there is no series",
           [](const P& p) {
             return p.allowances.series.empty() ? Value() : Value(p.allowances.series);
           })
        .when(drawn);
    q.term("backlash_mm",
           "least and greatest backlash that the thinned teeth have; `null` if the series "
           "determines the allowances",
           [](const P& p) { return p.allowances.backlash; })
        .ends()
        .when(drawn);
    q.text("center_distance_tolerance", "tolerance of ISO 286; `null` if there is no tolerance",
           [](const P& p) {
             return p.allowances.distance_tolerance ? Value(*p.allowances.distance_tolerance)
                                                    : Value();
           })
        .when(drawn);
    q.number("profile_shift", "limits of the profile shifts", "x",
             "lower and upper limit for both gears",
             [](const P& p) {
               return std::array{p.limits.min_shift, p.limits.max_shift};
             })
        .list({2})
        .when(drawn);
    q.number("sliding_max", "limit of the specific sliding", "|ζ|", "", [](const P& p) {
       return p.limits.sliding;
     }).when(drawn);
  });
}

void add_search(Quantities<SearchView>& q) {
  using S = SearchView;
  const auto count = [&q](const char* key, const char* meaning,
                          std::int64_t SearchCounts::*member) -> QuantityEntry<S> {
    return q.add(Type::index, key, key, "", meaning,
                 [member](const S& s) { return s.answer.counts.*member; });
  };
  const auto grid = [](const S& s) { return s.problem->shift_step.has_value(); };
  q.term("tested",
         "number of trials; a trial is a combination of module, z1, z2, helix angles and rack",
         [](const S& s) { return s.answer.counts.tested; });
  count("feasible_count", "number of trials with a region of feasible shifts",
        &SearchCounts::feasible);
  q.add(Type::map, "rejected", "rejected", "",
        "number of trials that each limit ruled out. A trial counts for the first limit that "
        "leaves no profile shift, in the order `shift_limits`, `center_distance`, `contact_ratio`, "
        "`overlap_ratio`, `sliding`, `tip_clearance`, `interference`, then `safety_flank` and "
        "`safety_root` for a rated search, and `verdict` for drawn designs. A trial without a "
        "working pressure angle counts for `contact_ratio`",
        [](const S& s) {
          ValueMap map;
          for (const Limit limit : s.problem->rejecting_limits())
            map.emplace_back(name(limit),
                             s.answer.counts.rejected[static_cast<std::size_t>(limit)]);
          return map;
        });
  q.add(Type::map, "rejected_by_finding", "rejected_by_finding", "",
        "for each code of a finding, the number of trials that `verdict` rejects because of it; a "
        "trial counts for its worst finding. Only for drawn designs",
        [](const S& s) {
          ValueMap map;
          for (const WarningMeaning& finding : warning_meanings())
            if (const auto n = s.answer.counts.findings[static_cast<std::size_t>(finding.code)];
                n > 0)
              map.emplace_back(finding.text, n);
          return map;
        })
      .when([](const S& s) { return static_cast<bool>(s.problem->draw); });
  q.record<margin_quantities>(
       "margins", "limits that every design satisfies; clearances in modules", &S::problem)
      .always();
  q.term("face_load_factor",
         "default of rated searches; only if `[rating]` has neither `face_load_factor` nor "
         "`[rating.mounting]`. After a design is taken, `[rating.mounting]`, `[gear1.shaft]` and "
         "`[gear2.shaft]` can give the factor",
         [](const S& s) { return s.default_face_load; })
      .when([](const S& s) { return s.default_face_load.has_value(); });
  q.add(Type::map, "assumed_factors", "assumed_factors", "",
        "factors of the rating that are 1, because `[rating]` does not give their inputs; only for "
        "rated searches",
        [](const S& s) {
          ValueMap map;
          for (const AssumedFactor& factor : s.assumed) map.emplace_back(factor.key, Value(1.0));
          return map;
        })
      .when([](const S& s) { return !s.assumed.empty(); });
  q.number("helix_angle_deg", "default band of the helix angles", "β",
           "[least, greatest]; only with `overlap_ratio` and without `helix_angle_deg`",
           [](const S& s) {
             return s.problem->default_overlap_helix ? Value(s.problem->overlap_helix_deg)
                                                     : Value();
           })
      .ends()
      .when([](const S& s) { return s.problem->default_overlap_helix; });
  count("points_tested", "number of tested points on the grid of `shift_step`",
        &SearchCounts::points_tested)
      .when(grid);
  count("points_feasible", "number of feasible points on the grid of `shift_step`",
        &SearchCounts::points_feasible)
      .when(grid);
  q.record<change_quantities>(
       "changes",
       "changes of a single limit that would make a design feasible, the smallest change first; "
       "only if no design is feasible, and for at most 2 million trials",
       &S::changes)
      .list({0})
      .always()
      .when([](const S& s) { return s.answer.counts.feasible == 0; });
  q.record<design_quantities>(
       "safest",
       "rated design that comes nearest to the required safeties, among at most 10 000 designs; "
       "only if no design is feasible",
       [](const S& s) {
         return s.safest ? Value(design_quantities().of({s.problem, &*s.safest})) : Value();
       })
      .when([](const S& s) { return s.safest.has_value(); });
  q.text("safest_finding",
         "finding of the verdict that rejects the design `safest`; only if its safety factors with "
         "nominal teeth are sufficient",
         [](const S& s) { return Value(s.safest_finding); })
      .when([](const S& s) { return !s.safest_finding.empty(); });
  q.term("pareto",
         "positions of the Pareto-optimal designs in `designs`; only with several objectives",
         [](const S& s) { return s.answer.pareto; })
      .doors(kJson);
  q.record<design_quantities>("designs",
                              "feasible designs, the best first; at most the number that `--top` "
                              "gives, by default 100 000",
                              [](const S&) { return ValueList(); });
}

}  // namespace

const Quantities<SearchView>& search_quantities() { return define<add_search>("search"); }

}  // namespace gearwright
