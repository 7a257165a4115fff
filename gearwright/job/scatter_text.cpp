#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/scatter_quantities.hpp"
#include "gearwright/job/corrected_spec.hpp"
#include "gearwright/job/csv_answer.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/scatter_answer.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace {

Value coordinates_at(const ScatterTolerance& t, const std::vector<double>& x, std::size_t at) {
  if (t.coordinates() == 1) return Value(x[at]);
  ValueList list;
  for (int k = 0; k < t.coordinates(); ++k) list.emplace_back(x[at + static_cast<std::size_t>(k)]);
  return Value(std::move(list));
}

// The value of every input. For a bore, a pitch or a wave, it is the list of its coordinates.
ValueMap by_input(const ScatterTask& task, const std::vector<double>& x) {
  ValueMap map;
  std::size_t at = 0;
  for (const ScatterTolerance& t : task.tolerances) {
    map.emplace_back(t.name, coordinates_at(t, x, at));
    at += static_cast<std::size_t>(t.coordinates());
  }
  return map;
}

// A sample in the form of a spec: the errors of the spec changed by this sample, followed by the
// inputs that cannot be given as errors.
ValueMap as_spec(const SolvedJob& job, const ScatterAnswer& a, const std::vector<double>& x) {
  std::array<double, kErrorCount> errors = job.spec.errors.value;
  ValueMap others;
  bool bores = false;
  std::size_t at = 0;
  for (const ScatterTolerance& t : a.task.tolerances) {
    if (const auto* error = std::get_if<VaryingError>(&t.of)) {
      errors[static_cast<std::size_t>(*error)] += x[at];
    } else if (std::holds_alternative<VaryingBore>(t.of)) {
      bores = true;
    } else {
      others.emplace_back(t.name, coordinates_at(t, x, at));
    }
    at += static_cast<std::size_t>(t.coordinates());
  }
  if (bores) {
    const ContactErrors e = deviation_at(a.setup, a.task.tolerances, x).errors;
    errors[0] = e.center_distance;
    errors[1] = e.crossing.deg();
    errors[2] = e.intersecting.deg();
  }
  ValueMap map;
  for (std::size_t i = 0; i < kErrorCount; ++i)
    if (errors[i] != 0.0) map.emplace_back(std::string(error_entries()[i].key), Value(errors[i]));
  ValueMap sample{{"errors", Value(std::move(map))}};
  sample.insert(sample.end(), others.begin(), others.end());
  return sample;
}

// The distribution of one quantity as a view. `x_of` returns the coordinates of a sample.
template <class Of>
SpreadView spread_view(const SolvedJob& job, const ScatterAnswer& a, const SpreadEntry& entry,
                       const Spread& spread, const Of& x_of) {
  ValueList samples;
  for (const Percentile& p : spread.percentiles)
    samples.emplace_back(as_spec(job, a, x_of(p.sample)));
  return {&entry, &spread, std::move(samples)};
}

template <class Of>
std::vector<LoadedSpreadView> loaded_views(const SolvedJob& job, const ScatterAnswer& a,
                                           const std::vector<LoadedSpread>& all, const Of& x_of) {
  std::vector<LoadedSpreadView> views;
  for (const LoadedSpread& loaded : all) {
    LoadedSpreadView& of = views.emplace_back(LoadedSpreadView{&loaded, {}});
    for (std::size_t i = 0; i < loaded_entries().size(); ++i) {
      const LoadedEntry& entry = loaded_entries()[i];
      if (const auto& spread = loaded.*entry.spread)
        of.spread[i] = spread_view(job, a, entry, *spread, x_of);
    }
  }
  return views;
}

RobustView robust_view(const SolvedJob& job, const ScatterAnswer& a) {
  const RobustAnswer& r = *a.robust;
  const bool under_load = r.task.load.has_value();
  const SpreadEntry& entry =
      under_load ? static_cast<const SpreadEntry&>(loaded_entries()[0]) : scatter_entries()[0];
  const auto judged = [&](const JudgedFamily& f) {
    const auto x_of = [&](std::size_t i) -> const auto& { return f.x[i]; };
    return JudgedView{&f, spread_view(job, a, entry, f.peak_to_peak, x_of),
                      loaded_views(job, a, f.loaded, x_of)};
  };
  RobustView view{{},
                  under_load,
                  r.task.percent,
                  judged(r.found.before),
                  judged(r.found.after),
                  to_value(r.corrected->tables)};
  for (std::size_t i = 0; i < r.task.corrections.size(); ++i) {
    const WorkshopCorrection& c = r.task.corrections[i];
    const double value = r.found.value[i];
    view.corrections.push_back(found_correction(c, value,
                                                spec_key(a.setup, c, a.task.member.gear2_drives),
                                                at_bound(r.task.bounds[i], value)));
  }
  return view;
}

std::string head(std::string_view text) { return fmt::format("\n{}\n", text); }

// The range of every input and the key that gives it. Waves and pitches vary within their grade.
std::string input_listing(const ScatterAnswer& a, UnitSystem units) {
  std::string out =
      head("Inputs") + fmt::format("  {:<44}{:>12}{:>12}  {}\n", "", "least", "greatest", "from");
  for (const ScatterTolerance& t : a.task.tolerances) {
    const Unit unit = unit_of(t);
    const auto end = [&](double value) {
      return t.coordinates() == 1 || t.bore() ? format_number(value_in(units, unit, value))
                                              : std::string();
    };
    const std::string name =
        key_in(units, t.name) + (t.bore() ? fmt::format("  {}", unit_text(units, unit)) : "");
    out += fmt::format("  {:<44}{:>12}{:>12}  {}\n", printable(name), end(t.distribution.least()),
                       end(t.distribution.greatest()), key_in(units, t.source));
  }
  if (std::any_of(a.task.tolerances.begin(), a.task.tolerances.end(),
                  [](const auto& t) { return std::holds_alternative<VaryingWave>(t.of); }))
    out += wrapped(
        "  Form waves have the full height of their tolerance in every sample. Only their number "
        "and phase vary.");
  return out;
}

std::string correlation_listing(const ScatterTask& task, UnitSystem units) {
  if (task.correlations.empty()) return {};
  const std::vector<std::string> names = coordinate_names(task.tolerances);
  std::string out = head("Correlations of the inputs");
  for (const ToleranceCorrelation& c : task.correlations)
    out += fmt::format("  {:<44}{:>12}  {}\n", printable(key_in(units, names[c.first])),
                       format_number(c.value), printable(key_in(units, names[c.second])));
  return out;
}

std::string spread_head(const ScatterTask& task) {
  std::string out = fmt::format("  {:<38}{:>12}{:>12}", "", "mean", "st. dev.");
  for (const double p : task.percentiles) out += fmt::format("{:>12}", format_number(p) + " %");
  return out + "\n";
}

// The rows of a table, without the rows whose numbers are all printed as zero.
class NonzeroRows {
 public:
  // `cells` are the numbers of the row, and `more` are further lines that belong to it.
  void add(const std::string& words, std::size_t width, const std::string& cells,
           const std::string& more = {}) {
    const bool zero = cells.find_first_of("123456789") == std::string::npos &&
                      cells.find('0') != std::string::npos;
    if (zero)
      zeros_ += (zeros_.empty() ? "" : ", ") + words;
    else
      text_ += "  " + padded(words, width) + cells + "\n" + more;
  }
  std::string text() const {
    return text_ + (zeros_.empty() ? "" : wrapped("  zero to these digits: " + zeros_));
  }

 private:
  std::string text_, zeros_;
};

void add_spread(NonzeroRows& rows, UnitSystem units, const SpreadEntry& entry,
                const Spread& spread) {
  constexpr std::size_t kWords = 38;
  const auto text = [&](double value) {
    return fmt::format("{:>12}", text_in(units, entry.unit, entry.shown(value), entry.digits));
  };
  const std::string unit(unit_text(units, entry.unit));
  std::string cells = text(spread.mean.value) + text(spread.standard_deviation.value);
  for (const Percentile& p : spread.percentiles) cells += text(p.estimate.value);
  std::string errors;
  if (spread.mean.standard_error) {
    errors = "  " + padded("    standard error", kWords) + text(*spread.mean.standard_error) +
             text(spread.standard_deviation.standard_error.value_or(0.0));
    for (const Percentile& p : spread.percentiles)
      errors += text(p.estimate.standard_error.value_or(0.0));
    errors += "\n";
  }
  rows.add(entry.words + (unit.empty() ? "" : "  " + unit), kWords, cells, errors);
}

std::string spread_listing(const ScatterAnswer& a, UnitSystem units) {
  std::string out = head(fmt::format("Distribution over {} samples ({} replicates of {})",
                                     a.scatter.samples.size(), a.task.replicates, a.task.samples));
  NonzeroRows rows;
  for (const ScatterEntry& entry : scatter_entries())
    if (const auto& spread = a.scatter.spread[static_cast<std::size_t>(entry.quantity)])
      add_spread(rows, units, entry, *spread);
  return out + spread_head(a.task) + rows.text();
}

std::string share_row(const char* words, const Probability& p) {
  const std::string share =
      p.count == 0 ? fmt::format("less than {:.3g} %", 100 * p.interval.upper)
                   : fmt::format("{:.4g} %, between {:.4g} and {:.4g} %", 100 * p.value,
                                 100 * p.interval.lower, 100 * p.interval.upper);
  return fmt::format("  {:<38}{} ({} of {})\n", words, share, p.count, p.of);
}

std::string loaded_listing(const ScatterAnswer& a, UnitSystem units) {
  std::string out;
  for (const LoadedSpread& loaded : a.scatter.loaded) {
    out += head(fmt::format("Under {} N m: {} samples, {} positions per pitch",
                            format_number(newton_metres(loaded.torque)), loaded.unsolved.of,
                            a.task.load->request.positions));
    out += spread_head(a.task);
    NonzeroRows rows;
    for (const LoadedEntry& entry : loaded_entries())
      if (const auto& spread = loaded.*entry.spread) add_spread(rows, units, entry, *spread);
    out += rows.text();
    out += share_row("an edge carries load", loaded.edge_carries);
    if (loaded.unsolved.count > 0) out += share_row("samples without a solution", loaded.unsolved);
  }
  return out;
}

std::string probability_listing(const ScatterAnswer& a) {
  return head("Probability") + share_row("an edge touches", a.scatter.edge_contact) +
         share_row("the gears jam", a.scatter.jam) +
         share_row("contact is lost", a.scatter.contact_lost);
}

std::string index_listing(const ScatterAnswer& a, UnitSystem units) {
  std::string out;
  for (const ScatterQuantity q : {ScatterQuantity::peak_to_peak, ScatterQuantity::least_play}) {
    const ScatterEntry& entry = scatter_entries()[static_cast<std::size_t>(q)];
    const auto& indices = a.scatter.indices[static_cast<std::size_t>(q)];
    out += head(fmt::format("Share of the variance: {}", entry.words));
    if (!indices) {
      out +=
          "  There are no indices, because the quantity varies only by rounding or contact is lost "
          "in some samples.\n";
      continue;
    }
    out +=
        fmt::format("  {:<44}{:>12}{:>12}{:>12}{:>12}\n", "", "alone", "± s.e.", "total", "± s.e.");
    const auto text = [](const std::optional<double>& x) {
      return fmt::format("{:>12}", x ? fixed_decimals(*x, 4) : "–");
    };
    NonzeroRows rows;
    for (std::size_t g = 0; g < a.task.groups.size(); ++g) {
      const Estimate& first = indices->first[g];
      const Estimate& total = indices->total[g];
      rows.add(printable(key_in(units, a.task.groups[g].name)), 44,
               text(first.value) + text(first.standard_error) + text(total.value) +
                   text(total.standard_error));
    }
    out += rows.text();
    const auto& linear = indices->linear_share;
    out += linear
               ? fmt::format(
                     "  The derivatives at the pair as drawn explain {:.2f} % of the variance.\n",
                     100 * *linear)
               : "  The quantity has no derivative at the pair as drawn.\n";
  }
  return out;
}

std::string worst_listing(const ScatterView& view, UnitSystem units) {
  std::string out = head("Worst values within all ranges, found by a search");
  for (const auto& worst : {view.worst_peak_to_peak, view.worst_least_play}) {
    if (!worst) continue;
    const ScatterEntry& entry = *worst->entry;
    out += fmt::format("  {:<38}{:>12} {}{}\n", entry.words,
                       fixed_decimals(entry.shown(worst->worst->value), entry.digits),
                       unit_text(entry.unit),
                       worst->worst->corner ? ", at a corner of the ranges" : "");
    if (worst->worst->bound)
      out += fmt::format("  {:<38}{:>12} {}\n", "    no pair has less than",
                         fixed_decimals(entry.shown(*worst->worst->bound), entry.digits),
                         unit_text(entry.unit));
    for (const auto& [name, value] : worst->at) {
      const ValueList* list = value.list();
      const auto number = [&, unit = unit_of(name)](const Value& v) {
        return format_number(value_in(units, unit, v.number().value_or(0.0)));
      };
      std::string shown = list ? "" : number(value);
      for (std::size_t i = 0; list && i < list->size(); ++i)
        shown += (i == 0 ? "" : ", ") + number((*list)[i]);
      out += fmt::format("    {:<40}{}\n", key_in(units, name), shown);
    }
  }
  return out;
}

std::string loosening_listing(const ScatterAnswer& a, UnitSystem units) {
  const Loosening& l = *a.scatter.loosening;
  const auto arcsec = [](double rad) {
    return fixed_decimals(Angle::radians(rad).arcsec(), scatter_entries()[0].digits);
  };
  std::string out = head(
      fmt::format("Factor on one tolerance alone that increases the {} % point of the peak-to-peak "
                  "transmission error over the first {} samples ({} ″) by {:g} %",
                  format_number(l.percent), a.task.samples, arcsec(l.percentile), 100 * kLooser));
  out += fmt::format("  {:<44}{:>12}{:>22}\n", "", "factor", "point if halved  ″");
  for (std::size_t i = 0; i < l.by_tolerance.size(); ++i) {
    const Loosening::Change& c = l.by_tolerance[i];
    out += fmt::format(
        "  {:<44}{:>12}{:>21}\n", key_in(units, a.task.tolerances[i].name),
        c.factor ? fmt::format("{:.2f}", *c.factor) : fmt::format("over {:g}", kMostFactor),
        arcsec(c.halved));
  }
  if (l.tighten_first) {
    const std::size_t i = *l.tighten_first;
    const ScatterTolerance& t = a.task.tolerances[i];
    out += fmt::format(
        "  Tighten {}{} first, because halving this tolerance lowers the percentile to {} ″.\n",
        key_in(units, t.name), t.of_grade(), arcsec(l.by_tolerance[i].halved));
  } else {
    out += "  No single tolerance lowers the percentile if it is halved.\n";
  }
  return out;
}

std::string robust_load_listing(const RobustView& r) {
  std::string out;
  for (std::size_t k = 0; k < r.before.loaded.size(); ++k) {
    const std::string under =
        fmt::format("  {} % points under {} N m", format_number(r.percent),
                    format_number(newton_metres(r.before.loaded[k].loaded->torque)));
    out += fmt::format("{:<46}{:>12}{:>15}\n", under, "without", "with");
    for (std::size_t i = 0; i < loaded_entries().size(); ++i) {
      const LoadedEntry& entry = loaded_entries()[i];
      const auto shown = [&](const JudgedView& j) {
        const auto& spread = j.loaded[k].spread[i];
        return spread ? fixed_decimals(entry.shown(spread->spread->percentiles[0].estimate.value),
                                       entry.digits)
                      : std::string("–");
      };
      out += fmt::format("    {:<42}{:>12}{:>15}  {}\n", entry.words, shown(r.before),
                         shown(r.after), unit_text(entry.unit));
    }
  }
  return out;
}

std::string robust_listing(const RobustView& r, UnitSystem units) {
  std::string out =
      head(fmt::format("Corrections for the {} % point of the {}", format_number(r.percent),
                       r.under_load ? "loaded transmission error, peak to peak, at the worst torque"
                                    : "transmission error, peak to peak"));
  for (const FoundCorrection& c : r.corrections)
    out += fmt::format("  {:<44}{:>11} {}{}\n", c.words, text_in(units, unit_of(c.key), c.value, 4),
                       unit_text(units, unit_of(c.key)),
                       c.at_bound ? "  (at the end of the range)" : "");
  if (std::all_of(r.corrections.begin(), r.corrections.end(),
                  [](const FoundCorrection& c) { return c.value == 0.0; }))
    out += wrapped("  No correction in the searched range lowers the percentile.");
  for (const auto& [words, j] :
       {std::pair{"without corrections", &r.before}, {"with corrections", &r.after}}) {
    const Estimate& e = j->family->percentile().estimate;
    const auto shown = [](double rad) {
      return fixed_decimals(scatter_entries()[0].shown(rad), scatter_entries()[0].digits);
    };
    out += fmt::format("  {:<44}{:>11} ″{}\n",
                       fmt::format("{} % point {}", format_number(r.percent), words),
                       shown(e.value), e.standard_error ? " ± " + shown(*e.standard_error) : "");
    out +=
        share_row(r.under_load ? "  an edge carries load" : "  an edge touches", j->family->edge);
  }
  return out + robust_load_listing(r);
}

}  // namespace

ScatterView scatter_view(const SolvedJob& job, const ScatterAnswer& a) {
  ScatterView view{&a.scatter, &a.task, {}, {}, {}, {}, {}, {}};
  for (const ScatterTolerance& t : a.task.tolerances) view.inputs.push_back(t.name);
  const auto x_of = [&](std::size_t i) -> const auto& { return a.scatter.samples[i].x; };
  for (const ScatterEntry& entry : scatter_entries()) {
    const auto at = static_cast<std::size_t>(entry.quantity);
    if (const auto& spread = a.scatter.spread[at])
      view.spread[at] = spread_view(job, a, entry, *spread, x_of);
  }
  view.loaded = loaded_views(job, a, a.scatter.loaded, x_of);
  if (a.scatter.density) view.density = &*a.scatter.density;
  if (a.robust) view.robust = robust_view(job, a);
  const auto worst = [&](const std::optional<WorstMember>& w,
                         ScatterQuantity q) -> std::optional<WorstView> {
    if (!w) return std::nullopt;
    return WorstView{&scatter_entries()[static_cast<std::size_t>(q)], &*w, by_input(a.task, w->x)};
  };
  view.worst_peak_to_peak = worst(a.scatter.worst_peak_to_peak, ScatterQuantity::peak_to_peak);
  view.worst_least_play = worst(a.scatter.worst_least_play, ScatterQuantity::least_play);
  return view;
}

Json scatter_json(const SolvedJob& job, const ScatterAnswer& a) {
  return titled_record(job.spec, "scatter", scatter_quantities().of(scatter_view(job, a)));
}

std::string scatter_listing(const SolvedJob& job, const ScatterAnswer& a) {
  const UnitSystem units = job.spec.units();
  std::string out = title_listing(job.spec) + input_listing(a, units) +
                    correlation_listing(a.task, units) + spread_listing(a, units) +
                    probability_listing(a) + loaded_listing(a, units);
  if (a.task.indices) out += index_listing(a, units);
  if (a.task.worst_case) out += worst_listing(scatter_view(job, a), units);
  if (a.scatter.loosening) out += loosening_listing(a, units);
  if (a.robust) out += robust_listing(robust_view(job, a), units);
  return out;
}

std::string scatter_csv(const SolvedJob& job, const ScatterAnswer& a) {
  const UnitSystem units = job.spec.units();
  const std::vector<std::string> names = coordinate_names(a.task.tolerances);
  std::string out = "replicate,sample";
  for (const std::string& name : names) out += "," + key_in(units, name);
  for (const ScatterEntry& entry : scatter_entries()) out += "," + key_in(units, entry.key);
  out += ",contact_lost\r\n";
  const auto n = static_cast<std::size_t>(a.task.samples);
  for (std::size_t i = 0; i < a.scatter.samples.size(); ++i) {
    const ScatterSample& sample = a.scatter.samples[i];
    out += fmt::format("{},{}", i / n, i % n);
    for (std::size_t k = 0; k < sample.x.size(); ++k)
      out += "," + csv_cell(Value(sample.x[k]), units, unit_of(names[k]));
    for (const ScatterEntry& entry : scatter_entries()) {
      const double value = sample.member[entry.quantity];
      out += "," + (std::isnan(value) ? std::string()
                                      : csv_cell(Value(entry.shown(value)), units, entry.unit));
    }
    out += fmt::format(",{}\r\n", sample.member.lost);
  }
  return out;
}

}  // namespace gearwright
