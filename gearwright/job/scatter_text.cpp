#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gearwright/catalogue/scatter_tables.hpp"
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

// Returns the value of every input. The value of a bore, a pitch or a wave is the list of its
// coordinates.
ValueMap by_input(const ScatterTask& task, const std::vector<double>& x) {
  ValueMap map;
  std::size_t at = 0;
  for (const ScatterTolerance& t : task.tolerances) {
    map.emplace_back(t.name, coordinates_at(t, x, at));
    at += static_cast<std::size_t>(t.coordinates());
  }
  return map;
}

// Returns a sample in the form of a spec. It contains the errors of the spec, changed by this
// sample, followed by the inputs that cannot be given as errors.
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

// Returns the distribution of one quantity as a view. `x_of` returns the coordinates of a sample.
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

std::string scatter_listing(const SolvedJob& job, const ScatterAnswer& a) {
  std::string out = title_listing(job.spec);
  for (const TextTable& table : scatter_tables(scatter_view(job, a), job.spec.units()))
    out += table_listing(table);
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
      const auto value = sample.member[entry.quantity];
      out += "," + (value ? csv_cell(Value(entry.shown(*value)), units, entry.unit) : "");
    }
    out += fmt::format(",{}\r\n", sample.member.lost);
  }
  return out;
}

}  // namespace gearwright
