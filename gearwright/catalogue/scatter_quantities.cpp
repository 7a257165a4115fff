#include "gearwright/catalogue/scatter_quantities.hpp"

#include "gearwright/base/angle.hpp"

namespace gearwright {

namespace {

using V = ScatterView;
using Q = ScatterQuantity;

Value listed(const std::vector<Percentile>& all, const ScatterEntry& entry,
             std::optional<double> (*of)(const Percentile&)) {
  ValueList list;
  for (const Percentile& p : all) {
    const auto value = of(p);
    list.push_back(value ? Value(entry.shown(*value)) : Value());
  }
  return list;
}

Value listed(const std::vector<Estimate>& all, bool error) {
  ValueList list;
  for (const Estimate& e : all) list.push_back(error ? Value(e.standard_error) : Value(e.value));
  return list;
}

const Quantities<SpreadView>& error_quantities() {
  using S = SpreadView;
  static const Quantities<S> kAll("scatter.standard_errors", [](Quantities<S>& q) {
    q.pure("", "mean", "standard error of the mean", "", "null of one replicate", [](const S& s) {
      const auto& e = s.spread->mean.standard_error;
      return e ? Value(s.entry->shown(*e)) : Value();
    });
    q.pure("", "standard_deviation", "that of the standard deviation", "", "", [](const S& s) {
      const auto& e = s.spread->standard_deviation.standard_error;
      return e ? Value(s.entry->shown(*e)) : Value();
    });
    q.pure("", "percentiles", "those of the percentiles", "", "", [](const S& s) {
       return listed(s.spread->percentiles, *s.entry,
                     [](const Percentile& p) { return p.estimate.standard_error; });
     }).list({0});
  });
  return kAll;
}
const QuantityTable& error_table() { return error_quantities().table(); }

const Quantities<IndexView>& index_quantities() {
  using I = IndexView;
  static const Quantities<I> kAll("scatter.index", [](Quantities<I>& q) {
    const auto list = [&q](const char* key, const char* words, const char* symbol, bool total,
                           bool error) {
      q.pure("", key, words, symbol, "by input or group",
             [total, error](const I& i) {
               return listed(total ? i.estimates->total : i.estimates->first, error);
             })
          .list({0})
          .always();
    };
    list("first", "first index", "S", false, false);
    list("total", "total index", "S_T", true, false);
    list("first_error", "standard error of the first index", "", false, true);
    list("total_error", "standard error of the total index", "", true, true);
  });
  return kAll;
}
const QuantityTable& index_table() { return index_quantities().table(); }

const Quantities<V>& indices_quantities() {
  static const Quantities<V> kAll("scatter.indices", [](Quantities<V>& q) {
    q.text("groups", "what the lists are by: inputs or groups",
           [](const V& v) {
             ValueList names;
             for (const ToleranceGroup& g : v.task->groups) names.emplace_back(g.name);
             return Value(names);
           })
        .list({0})
        .always();
    for (const ScatterEntry& entry : scatter_entries()) {
      const auto at = static_cast<std::size_t>(entry.quantity);
      q.record("", entry.key, "null where it varies by rounding only", index_table,
               [at](const V& v) {
                 const auto& found = v.scatter->indices[at];
                 return found ? Value(index_quantities().of({&*found})) : Value();
               });
    }
  });
  return kAll;
}
const QuantityTable& indices_table() { return indices_quantities().table(); }

const Quantities<WorstView>& worst_quantities() {
  using W = WorstView;
  static const Quantities<W> kAll("scatter.worst value", [](Quantities<W>& q) {
    q.pure("", "value", "worst value", "", "in the unit of its key", [](const W& w) {
       return Value(w.entry->shown(w.worst->value));
     }).always();
    q.add(Type::map, Unit::none, "", "at", "where", "", "by input, in its unit", [](const W& w) {
       return Value(w.at);
     }).always();
    q.flag("", "corner", "corner", "every input is at an end of its range",
           [](const W& w) { return Value(w.worst->corner); });
  });
  return kAll;
}
const QuantityTable& worst_table() { return worst_quantities().table(); }

const Quantities<V>& worsts_quantities() {
  static const Quantities<V> kAll("scatter.worst", [](Quantities<V>& q) {
    const auto of = [](const std::optional<WorstView>& w) {
      return w ? Value(worst_quantities().of(*w)) : Value();
    };
    q.record("", "peak_to_peak_arcsec", "the greatest that was found; a search, no bound",
             worst_table, [of](const V& v) { return of(v.worst_peak_to_peak); });
    q.record("", "least_play_deg", "the least that was found", worst_table,
             [of](const V& v) { return of(v.worst_least_play); });
  });
  return kAll;
}
const QuantityTable& worsts_table() { return worsts_quantities().table(); }

const QuantityTable& probability_table() { return probability_quantities().table(); }

const Quantities<V>& probabilities_quantities() {
  static const Quantities<V> kAll("scatter.probability", [](Quantities<V>& q) {
    q.record("", "edge_contact", "an edge of a tooth touches somewhere", probability_table,
             [](const V& v) { return Value(probability_quantities().of(v.scatter->edge_contact)); })
        .always();
    q.record("", "jam", "least play < 0", probability_table, [](const V& v) {
       return Value(probability_quantities().of(v.scatter->jam));
     }).always();
    q.record("", "contact_lost", "at some position no teeth touch; left out of the distributions",
             probability_table,
             [](const V& v) { return Value(probability_quantities().of(v.scatter->contact_lost)); })
        .always();
  });
  return kAll;
}
const QuantityTable& probabilities_table() { return probabilities_quantities().table(); }

const QuantityTable& spread_table() { return spread_quantities().table(); }

const QuantityTable& correction_table() { return correction_quantities().table(); }

const Quantities<JudgedView>& judged_quantities() {
  using J = JudgedView;
  static const Quantities<J> kAll("scatter.robust judged", [](Quantities<J>& q) {
    const auto arcsec = [](double rad) { return Value(Angle::radians(rad).arcsec()); };
    q.add(Type::number, Unit::arcsec, "", "percentile_arcsec", "percentile of the peak to peak", "",
          "that which is minimised",
          [arcsec](const J& j) {
            return arcsec(RobustCorrections::percentile(*j.scatter).estimate.value);
          })
        .always();
    q.add(Type::number, Unit::arcsec, "", "standard_error_arcsec", "its standard error", "",
          "from the replicates [T14.9]", [arcsec](const J& j) {
            const auto& e = RobustCorrections::percentile(*j.scatter).estimate.standard_error;
            return e ? arcsec(*e) : Value();
          });
    q.record("", "peak_to_peak_arcsec", "its distribution", spread_table, [](const J& j) {
       return Value(spread_quantities().of(j.peak_to_peak));
     }).always();
    q.record("", "edge_contact", "an edge of a tooth touches somewhere", probability_table,
             [](const J& j) { return Value(probability_quantities().of(j.scatter->edge_contact)); })
        .always();
  });
  return kAll;
}
const QuantityTable& judged_table() { return judged_quantities().table(); }

const Quantities<RobustView>& robust_quantities() {
  using R = RobustView;
  static const Quantities<R> kAll("scatter.robust", [](Quantities<R>& q) {
    q.record("", "corrections", "what was found; every value is 0 if none lowers the percentile",
             correction_table,
             [](const R& r) { return Value(correction_quantities().each(r.corrections)); })
        .list({0})
        .always();
    q.pure("", "percentile", "percentile", "p", "that which is minimised", [](const R& r) {
       return Value(r.percent);
     }).always();
    q.record("", "before", "without corrections, by samples of the next seed", judged_table,
             [](const R& r) { return Value(judged_quantities().of(r.before)); })
        .always();
    q.record("", "after", "with them, by the same samples", judged_table, [](const R& r) {
       return Value(judged_quantities().of(r.after));
     }).always();
  });
  return kAll;
}
const QuantityTable& robust_table() { return robust_quantities().table(); }

// A tolerance and what it is worth.
struct LooseningView {
  const std::string* input;
  const Loosening::Change* change;
};

const Quantities<LooseningView>& change_quantities() {
  using L = LooseningView;
  static const Quantities<L> kAll("scatter.loosening input", [](Quantities<L>& q) {
    q.text("input", "the tolerance", [](const L& l) { return Value(*l.input); }).always();
    q.pure("", "factor", "factor until the percentile has grown by 5 %", "",
           "null: by 8, or as far as there are such teeth, it grows by less",
           [](const L& l) { return l.change->factor ? Value(*l.change->factor) : Value(); });
    q.add(Type::number, Unit::arcsec, "", "halved_arcsec", "percentile with half the tolerance", "",
          "", [](const L& l) { return Value(Angle::radians(l.change->halved).arcsec()); });
  });
  return kAll;
}
const QuantityTable& change_table() { return change_quantities().table(); }

const Quantities<V>& loosening_quantities() {
  static const Quantities<V> kAll("scatter.loosening", [](Quantities<V>& q) {
    q.pure("", "percentile", "percentile", "", "the greatest of `percentiles`", [](const V& v) {
       return Value(v.scatter->loosening->percent);
     }).always();
    q.add(Type::number, Unit::arcsec, "", "percentile_arcsec", "its value as it is", "",
          "of the first replicate, whose samples all lines have in common",
          [](const V& v) {
            return Value(Angle::radians(v.scatter->loosening->percentile).arcsec());
          })
        .always();
    q.record("", "tolerances", "by input", change_table,
             [](const V& v) {
               std::vector<LooseningView> list;
               for (std::size_t i = 0; i < v.inputs.size(); ++i)
                 list.push_back({&v.inputs[i], &v.scatter->loosening->by_tolerance[i]});
               return Value(change_quantities().each(list));
             })
        .list({0})
        .always();
    q.text("tighten_first",
           "the input that lowers the percentile most if it is halved; null: none does",
           [](const V& v) {
             const auto& first = v.scatter->loosening->tighten_first;
             return first ? Value(v.inputs[*first]) : Value();
           });
  });
  return kAll;
}
const QuantityTable& loosening_table() { return loosening_quantities().table(); }

void say(Quantities<V>& q) {
  q.text("inputs", "what varies, in order",
         [](const V& v) {
           ValueList names;
           for (const std::string& name : v.inputs) names.emplace_back(name);
           return Value(names);
         })
      .list({0})
      .always();
  q.whole("", "samples", "samples of each replicate", "n", "", [](const V& v) {
     return Value(v.task->samples);
   }).always();
  q.whole("", "replicates", "replicates", "R", "", [](const V& v) {
     return Value(v.task->replicates);
   }).always();
  q.whole("", "seed", "seed", "", "", [](const V& v) {
     return Value(static_cast<long long>(v.task->seed));
   }).always();
  for (const ScatterEntry& entry : scatter_entries()) {
    const auto at = static_cast<std::size_t>(entry.quantity);
    q.record("", entry.key, entry.meaning, spread_table, [at](const V& v) {
       return v.spread[at] ? Value(spread_quantities().of(*v.spread[at])) : Value();
     }).doors(kJson);
  }
  q.record("", "probability", "of events, with the interval of Clopper and Pearson",
           probabilities_table, [](const V& v) { return Value(probabilities_quantities().of(v)); })
      .always()
      .doors(kJson);
  q.record("", "indices", "Sobol indices of each quantity; with `indices` only", indices_table,
           [](const V& v) { return Value(indices_quantities().of(v)); })
      .when([](const V& v) { return v.task->indices; })
      .doors(kJson);
  q.record("", "worst", "the worst within all ranges; with `worst_case` only", worsts_table,
           [](const V& v) { return Value(worsts_quantities().of(v)); })
      .when([](const V& v) { return v.task->worst_case; })
      .doors(kJson);
  q.record("", "loosening", "how far each tolerance may grow; with `loosening` only",
           loosening_table, [](const V& v) { return Value(loosening_quantities().of(v)); })
      .when([](const V& v) { return v.scatter->loosening.has_value(); })
      .doors(kJson);
  q.record("", "robust", "corrections for a percentile; with `[scatter.robust]` only", robust_table,
           [](const V& v) { return Value(robust_quantities().of(*v.robust)); })
      .when([](const V& v) { return v.robust.has_value(); })
      .doors(kJson);
  q.add(Type::map, Unit::none, "", "spec", "spec", "",
        "the whole spec with the corrections in it; with `[scatter.robust]` only",
        [](const V& v) { return v.robust->spec; })
      .when([](const V& v) { return v.robust.has_value(); })
      .doors(kJson);
}

}  // namespace

const std::array<ScatterEntry, kScatterQuantities>& scatter_entries() {
  static const std::array<ScatterEntry, kScatterQuantities> entries{{
      {Q::peak_to_peak, "peak_to_peak_arcsec", "transmission error, peak to peak", Unit::arcsec, 4,
       "transmission error, peak to peak of the continuous curve [T14.11]"},
      {Q::harmonic1, "harmonic1_arcsec", "transmission error, 1st harmonic", Unit::arcsec, 4,
       "its first harmonic, as `contact` has it"},
      {Q::harmonic2, "harmonic2_arcsec", "transmission error, 2nd harmonic", Unit::arcsec, 4,
       "its second harmonic"},
      {Q::harmonic3, "harmonic3_arcsec", "transmission error, 3rd harmonic", Unit::arcsec, 4,
       "its third harmonic"},
      {Q::mean, "mean_arcsec", "transmission error, mean", Unit::arcsec, 2,
       "its mean, which carries the play: a phase and no noise"},
      {Q::along_face, "contact_along_face", "contact along the face", Unit::none, 4,
       "mean place of the contact along the face, −1 to 1 [T8.24]"},
      {Q::along_profile, "contact_along_profile", "contact along the profile", Unit::none, 4,
       "mean place of the contact along the profile [T8.24]; of circular-arc pairs, else null"},
      {Q::edge_share, "edge_share", "positions with an edge in contact", Unit::none, 4,
       "share of the positions of a pitch at which an edge touches, 0 to 1"},
      {Q::least_play, "least_play_deg", "least play of gear 2", Unit::deg, 5,
       "least play of gear 2 with both flanks; < 0: the gears jam"},
      {Q::long_period, "long_period_arcsec", "transmission error until the same teeth meet again",
       Unit::arcsec, 3,
       "transmission error over all pairs of teeth, peak to peak over the positions [T14.22]; with "
       "`pitch` only, else null"},
  }};
  return entries;
}

double ScatterEntry::shown(double value) const {
  const Angle angle = Angle::radians(value);
  return unit == Unit::arcsec ? angle.arcsec() : unit == Unit::deg ? angle.deg() : value;
}

const Quantities<ScatterView>& scatter_quantities() {
  static const Quantities<ScatterView> kAll("scatter", say);
  return kAll;
}

const Quantities<SpreadView>& spread_quantities() {
  using S = SpreadView;
  static const Quantities<S> kAll("scatter spread", [](Quantities<S>& q) {
    q.pure("", "mean", "mean", "", "", [](const S& s) {
       return Value(s.entry->shown(s.spread->mean.value));
     }).always();
    q.pure("", "standard_deviation", "standard deviation", "", "", [](const S& s) {
       return Value(s.entry->shown(s.spread->standard_deviation.value));
     }).always();
    q.pure("", "percentiles", "percentiles", "", "those of `percentiles`",
           [](const S& s) {
             return listed(s.spread->percentiles, *s.entry,
                           [](const Percentile& p) { return std::optional(p.estimate.value); });
           })
        .list({0})
        .always();
    q.pure("", "lower", "lower ends of their intervals", "", "null: too few samples",
           [](const S& s) {
             return listed(s.spread->percentiles, *s.entry,
                           [](const Percentile& p) { return p.lower; });
           })
        .list({0});
    q.pure("", "upper", "upper ends of their intervals", "", "null: too few samples",
           [](const S& s) {
             return listed(s.spread->percentiles, *s.entry,
                           [](const Percentile& p) { return p.upper; });
           })
        .list({0});
    q.record("", "standard_errors", "from the replicates [T14.9]", error_table, [](const S& s) {
       return Value(error_quantities().of(s));
     }).always();
    q.pure("", "least", "least of all samples", "", "", [](const S& s) {
       return Value(s.entry->shown(s.spread->least));
     }).always();
    q.pure("", "greatest", "greatest of all samples", "", "", [](const S& s) {
       return Value(s.entry->shown(s.spread->greatest));
     }).always();
    q.add(Type::map, Unit::none, "", "samples", "samples", "",
          "the sample next to each percentile: `errors` as in a spec, and other inputs as added",
          [](const S& s) { return Value(s.samples); })
        .list({0})
        .always();
  });
  return kAll;
}

const Quantities<Probability>& probability_quantities() {
  using P = Probability;
  static const Quantities<P> kAll("scatter probability", [](Quantities<P>& q) {
    q.pure("", "value", "share of the samples", "", "", [](const P& p) {
       return Value(p.value);
     }).always();
    q.add(Type::index, Unit::none, "", "count", "samples in which it is so", "", "",
          [](const P& p) { return Value(static_cast<long long>(p.count)); })
        .always();
    q.add(Type::index, Unit::none, "", "of", "all samples", "", "", [](const P& p) {
       return Value(static_cast<long long>(p.of));
     }).always();
    q.pure("", "lower", "lower end of the interval", "", "[T14.7]", [](const P& p) {
       return Value(p.interval.lower);
     }).always();
    q.pure("", "upper", "upper end of the interval", "", "[T14.7]", [](const P& p) {
       return Value(p.interval.upper);
     }).always();
  });
  return kAll;
}

}  // namespace gearwright
