#include "gearwright/catalogue/scatter_quantities.hpp"

#include "gearwright/base/angle.hpp"

namespace gearwright {

namespace {

Value shown(const SpreadEntry& entry, const std::optional<double>& value) {
  return value ? Value(entry.shown(*value)) : Value();
}

template <class Of>
ValueList listed(const std::vector<Percentile>& all, const SpreadEntry& entry, Of of) {
  ValueList list;
  for (const Percentile& p : all) list.push_back(shown(entry, std::invoke(of, p)));
  return list;
}

ValueList listed(const std::vector<Estimate>& all, bool error) {
  ValueList list;
  for (const Estimate& e : all) list.push_back(error ? Value(e.standard_error) : Value(e.value));
  return list;
}

const Quantities<SpreadView>& error_quantities() {
  using S = SpreadView;
  return define("scatter.standard_errors", [](Quantities<S>& q) {
    q.number("mean", "standard error of the mean", "", "null if there is only one replicate",
             [](const S& s) { return shown(*s.entry, s.spread->mean.standard_error); });
    q.number(
        "standard_deviation", "standard error of the standard deviation", "", "",
        [](const S& s) { return shown(*s.entry, s.spread->standard_deviation.standard_error); });
    q.number("percentiles", "standard errors of the percentiles", "", "", [](const S& s) {
      return listed(s.spread->percentiles, *s.entry,
                    [](const Percentile& p) { return p.estimate.standard_error; });
    });
  });
}

const Quantities<IndexEstimates>& index_quantities() {
  using I = IndexEstimates;
  return define("scatter.index", [](Quantities<I>& q) {
    const auto list = [&q](const char* key, const char* words, const char* symbol, bool total,
                           bool error) {
      q.number(key, words, symbol, "for each input or group",
               [total, error](const I& i) { return listed(total ? i.total : i.first, error); });
    };
    list("first", "first-order index", "S", false, false);
    list("total", "total index", "S_T", true, false);
    list("first_error", "standard error of the first-order index", "", false, true);
    list("total_error", "standard error of the total index", "", true, true);
    q.number("linear_share", "linear share of the variance", "Var(g·x)/Var f",
             "share of the variance that is explained by the derivatives at the nominal values "
             "[T14.28]; null if the quantity has no derivative at the nominal values",
             &I::linear_share);
  });
}

const Quantities<ScatterView>& indices_quantities() {
  return define("scatter.indices", [](Quantities<ScatterView>& q) {
    q.text("groups", "inputs or groups in the order of the lists", [](const ScatterView& v) {
      ValueList names;
      for (const ToleranceGroup& g : v.task->groups) names.emplace_back(g.name);
      return names;
    });
    for (const ScatterEntry& entry : scatter_entries()) {
      const auto at = static_cast<std::size_t>(entry.quantity);
      q.record<index_quantities>(
          entry.key, "Sobol indices of the quantity; null if the quantity varies only by rounding",
          [at](const ScatterView& v) -> const auto& { return v.scatter->indices[at]; });
    }
  });
}

const Quantities<WorstView>& worst_quantities() {
  using W = WorstView;
  return define("scatter.worst value", [](Quantities<W>& q) {
    q.number("value", "worst value", "", "in the unit of its key",
             [](const W& w) { return w.entry->shown(w.worst->value); });
    q.add(Type::map, "at", "values of the inputs", "",
          "inputs that give the worst value, each in its unit", &W::at);
    q.flag("corner", "corner", "true if every input is at an end of its range",
           [](const W& w) { return w.worst->corner; });
    q.number("bound", "bound", "",
             "lower bound of the values of all pairs within the ranges, in the unit of its key "
             "[T14.29]; null for the peak-to-peak value, which is not convex. The bounds of other "
             "quantities are given only for external involute pairs on parallel axes without "
             "reliefs, topographies and waves",
             [](const W& w) { return shown(*w.entry, w.worst->bound); });
  });
}

const Quantities<ScatterView>& worsts_quantities() {
  return define("scatter.worst", [](Quantities<ScatterView>& q) {
    q.record<worst_quantities>("peak_to_peak_arcsec",
                               "greatest value found by a search; there might be greater values",
                               &ScatterView::worst_peak_to_peak);
    q.record<worst_quantities>("least_play_deg", "least value found by a search",
                               &ScatterView::worst_least_play);
  });
}

const Quantities<JudgedView>& judged_quantities() {
  using J = JudgedView;
  return define("scatter.robust judged", [](Quantities<J>& q) {
    q.number("percentile_arcsec", "percentile of the peak-to-peak transmission error", "",
             "minimised percentile", [](const J& j) {
               return Angle::radians(j.family->percentile().estimate.value).arcsec();
             });
    q.number("standard_error_arcsec", "standard error of the percentile", "",
             "computed from the replicates [T14.9]", [](const J& j) {
               return shown(scatter_entries()[0], j.family->percentile().estimate.standard_error);
             });
    q.record<spread_quantities>("peak_to_peak_arcsec",
                                "distribution of the peak-to-peak transmission error",
                                &J::peak_to_peak);
    q.record<probability_quantities>(
        "edge_contact",
        "samples in which an edge of a tooth touches at some position or, under load, carries "
        "load",
        [](const J& j) -> const auto& { return j.family->edge; });
    q.record<loaded_spread_quantities>(
         "loaded", "results under each torque; only if `aim` is a quantity under load", &J::loaded)
        .when([](const J& j) { return !j.loaded.empty(); });
  });
}

const Quantities<RobustView>& robust_quantities() {
  using R = RobustView;
  return define("scatter.robust", [](Quantities<R>& q) {
    q.record<correction_quantities>(
        "corrections",
        "corrections that were found; every value is 0 if no correction lowers the percentile",
        &R::corrections);
    q.word("aim", "quantity computed for each sample", "value of the key `aim`", [](const R& r) {
       return r.under_load ? "loaded_transmission_error" : "transmission_error";
     }).one_of({"transmission_error", "loaded_transmission_error"});
    q.number("percentile", "percentile", "p", "minimised percentile", &R::percent);
    q.record<judged_quantities>(
        "before", "result without corrections, computed with samples of the next seed", &R::before);
    q.record<judged_quantities>(
        "after", "result with the corrections, computed with samples of the next seed", &R::after);
  });
}

// A tolerance and the effect of loosening or tightening it.
struct LooseningView {
  const std::string* input;
  const Loosening::Change* change;
};

const Quantities<LooseningView>& loosening_change_quantities() {
  using L = LooseningView;
  return define("scatter.loosening input", [](Quantities<L>& q) {
    q.text("input", "name of the tolerance", [](const L& l) { return *l.input; });
    q.number(
        "factor", "factor by which the tolerance can grow until the percentile has grown by 5 %",
        "",
        "null if the percentile grows by at most 5 % for every factor up to 8 with which the teeth "
        "can be made",
        [](const L& l) { return l.change->factor ? Value(*l.change->factor) : Value(); });
    q.number("halved_arcsec", "percentile with half the tolerance", "", "", [](const L& l) {
       return Angle::radians(l.change->halved).arcsec();
     }).or_null();
  });
}

const Quantities<ScatterView>& loosening_quantities() {
  return define("scatter.loosening", [](Quantities<ScatterView>& q) {
    q.number("percentile", "percentile", "", "the greatest of `percentiles`",
             [](const ScatterView& v) { return v.scatter->loosening->percent; });
    q.number("percentile_arcsec", "present percentile", "",
             "percentile for the samples of the first replicate; the effect of each tolerance is "
             "computed with these samples",
             [](const ScatterView& v) {
               return Angle::radians(v.scatter->loosening->percentile).arcsec();
             });
    q.record<loosening_change_quantities>(
        "tolerances", "effect of each tolerance", [](const ScatterView& v) {
          std::vector<LooseningView> list;
          for (std::size_t i = 0; i < v.inputs.size(); ++i)
            list.push_back({&v.inputs[i], &v.scatter->loosening->by_tolerance[i]});
          return list;
        });
    q.text("tighten_first",
           "input for which halving the tolerance lowers the percentile most; null if halving a "
           "single tolerance never lowers it",
           [](const ScatterView& v) {
             const auto& first = v.scatter->loosening->tighten_first;
             return first ? Value(v.inputs[*first]) : Value();
           });
  });
}

void add_scatter(Quantities<ScatterView>& q) {
  q.text("inputs", "names of the inputs that vary, in order", &ScatterView::inputs);
  q.text("ranges_from", "keys of the spec that give the ranges of the inputs, in order",
         [](const ScatterView& v) {
           ValueList keys;
           for (const ScatterTolerance& t : v.task->tolerances) keys.emplace_back(t.source);
           return keys;
         });
  q.term("samples", "", [](const ScatterView& v) { return v.task->samples; });
  q.term("replicates", "", [](const ScatterView& v) { return v.task->replicates; });
  q.whole("seed", "seed", "", "",
          [](const ScatterView& v) { return static_cast<long long>(v.task->seed); });
  for (const ScatterEntry& entry : scatter_entries()) {
    const auto at = static_cast<std::size_t>(entry.quantity);
    q.record<spread_quantities>(
         entry.key,
         entry.meaning, [at](const ScatterView& v) -> const auto& { return v.spread[at]; })
        .doors(kJson);
  }
  q.record<probabilities_quantities>(
       "probability", "probabilities of events, with the interval of Clopper and Pearson")
      .doors(kJson);
  q.record<indices_quantities>("indices", "Sobol indices of each quantity; only with `indices`")
      .when([](const ScatterView& v) { return v.task->indices; })
      .doors(kJson);
  q.record<worsts_quantities>("worst", "worst values within all ranges; only with `worst_case`")
      .when([](const ScatterView& v) { return v.task->worst_case; })
      .doors(kJson);
  q.record<loosening_quantities>("loosening",
                                 "factors by which the tolerances can grow; only with `loosening`")
      .when([](const ScatterView& v) { return v.scatter->loosening.has_value(); })
      .doors(kJson);
  q.record<loaded_spread_quantities>(
       "loaded", "results under each torque of `[load]`; only with `loaded`", &ScatterView::loaded)
      .when([](const ScatterView& v) { return v.task->load.has_value(); })
      .doors(kJson);
  q.record<density_quantities>("pattern",
                               "density of the contact pattern on both flanks; only with `pattern`",
                               &ScatterView::density)
      .when([](const ScatterView& v) { return v.task->density.has_value(); })
      .doors(kJson);
  q.record<robust_quantities>(
       "robust", "corrections for a percentile; only with `[scatter.robust]`", &ScatterView::robust)
      .when([](const ScatterView& v) { return v.robust.has_value(); })
      .doors(kJson);
  q.add(Type::map, "spec", "spec", "",
        "the complete spec with the corrections; only with `[scatter.robust]`",
        [](const ScatterView& v) { return v.robust->spec; })
      .when([](const ScatterView& v) { return v.robust.has_value(); })
      .doors(kJson);
}

}  // namespace

const Quantities<ScatterView>& scatter_quantities() { return define<add_scatter>("scatter"); }

Unit unit_of(const ScatterTolerance& tolerance) {
  return unit_of(coordinate_names({&tolerance, 1}).front());
}

const Quantities<SpreadView>& spread_quantities() {
  using S = SpreadView;
  return define("scatter spread", [](Quantities<S>& q) {
    q.number("mean", "mean", "", "",
             [](const S& s) { return s.entry->shown(s.spread->mean.value); });
    q.number("standard_deviation", "standard deviation", "", "",
             [](const S& s) { return s.entry->shown(s.spread->standard_deviation.value); });
    q.number("percentiles", "percentiles", "", "values of the requested `percentiles`",
             [](const S& s) {
               return listed(s.spread->percentiles, *s.entry,
                             [](const Percentile& p) { return std::optional(p.estimate.value); });
             });
    q.number("lower", "lower ends of the intervals of the percentiles", "",
             "null if there are too few samples", [](const S& s) {
               return listed(s.spread->percentiles, *s.entry, &Percentile::lower);
             });
    q.number("upper", "upper ends of the intervals of the percentiles", "",
             "null if there are too few samples", [](const S& s) {
               return listed(s.spread->percentiles, *s.entry, &Percentile::upper);
             });
    q.record<error_quantities>("standard_errors", "computed from the replicates [T14.9]");
    q.number("least", "least value of all samples", "", "",
             [](const S& s) { return s.entry->shown(s.spread->least); });
    q.number("greatest", "greatest value of all samples", "", "",
             [](const S& s) { return s.entry->shown(s.spread->greatest); });
    q.add(Type::map, "samples", "samples", "",
          "sample nearest to each percentile, with `errors` as in a spec and the increments of the "
          "other inputs",
          &S::samples);
  });
}

const Quantities<ScatterView>& probabilities_quantities() {
  return define("scatter.probability", [](Quantities<ScatterView>& q) {
    q.record<probability_quantities>(
        "edge_contact", "an edge of a tooth touches at some position",
        [](const ScatterView& v) -> const auto& { return v.scatter->edge_contact; });
    q.record<probability_quantities>(
        "jam", "the least play is negative",
        [](const ScatterView& v) -> const auto& { return v.scatter->jam; });
    q.record<probability_quantities>(
        "contact_lost",
        "at one position or more, no teeth touch; the distributions do not contain such samples",
        [](const ScatterView& v) -> const auto& { return v.scatter->contact_lost; });
  });
}

const Quantities<Probability>& probability_quantities() {
  using P = Probability;
  return define("scatter probability", [](Quantities<P>& q) {
    q.number("value", "share of the samples", "", "", &P::value);
    q.add(Type::index, "count", "number of samples with the event", "", "",
          [](const P& p) { return static_cast<long long>(p.count); });
    q.add(Type::index, "of", "number of all samples", "", "",
          [](const P& p) { return static_cast<long long>(p.of); });
    q.number("lower", "lower end of the confidence interval", "", "[T14.7]",
             [](const P& p) { return p.interval.lower; });
    q.number("upper", "upper end of the confidence interval", "", "[T14.7]",
             [](const P& p) { return p.interval.upper; });
  });
}

}  // namespace gearwright
