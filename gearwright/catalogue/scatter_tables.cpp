#include "gearwright/catalogue/scatter_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/correction_tables.hpp"

namespace gearwright {

namespace {

// Returns, for example, "The gears jam in 3 of 64 samples (4.688 %, between 0.9782 and 13.09 %)."
std::string event_words(std::string_view words, const Probability& p) {
  const std::string share =
      p.count == 0 ? fmt::format("less than {:.3g} %", 100 * p.interval.upper)
                   : fmt::format("{:.4g} %, between {:.4g} and {:.4g} %", 100 * p.value,
                                 100 * p.interval.lower, 100 * p.interval.upper);
  return capitalised(fmt::format("{} in {} of {} samples ({}).", words, p.count, p.of, share));
}

// Returns a table with the range of every input and the key that gives the range. The cells of
// waves and pitches are empty, because they vary within the tolerances of their accuracy grade.
TextTable input_table(const ScatterView& view, UnitSystem units) {
  TextTable table{"Inputs", {"least", "greatest", "from"}};
  bool waves = false;
  for (const ScatterTolerance& t : view.task->tolerances) {
    const Unit unit = unit_of(t);
    const bool number = t.coordinates() == 1 || t.bore();
    const auto end = [&](double value) {
      return number ? format_number(value_in(units, unit, value)) : std::string();
    };
    table.rows.push_back(
        {printable(key_in(units, t.name)),
         std::string(t.bore() ? unit_text(units, unit) : ""),
         {end(t.distribution.least()), end(t.distribution.greatest()), key_in(units, t.source)}});
    waves = waves || std::holds_alternative<VaryingWave>(t.of);
  }
  if (waves)
    table.notes.emplace_back(
        "Form waves have the full height of their tolerance in every sample. Only their number and "
        "phase vary.");
  return table;
}

TextTable correlation_table(const ScatterTask& task, UnitSystem units) {
  TextTable table{"Correlations of the inputs", {"ρ"}};
  const std::vector<std::string> names = coordinate_names(task.tolerances);
  const auto name = [&](std::size_t i) { return printable(key_in(units, names[i])); };
  for (const ToleranceCorrelation& c : task.correlations)
    table.rows.push_back({name(c.first) + ", " + name(c.second), "", {format_number(c.value)}});
  return table;
}

// Returns a row with the texts of the estimates and of their standard errors. With a single
// replicate, there are no standard errors.
TextTable::Row estimate_row(UnitSystem units, const SpreadEntry& entry, std::string words,
                            const std::vector<Estimate>& estimates) {
  TextTable::Row row{std::move(words), std::string(unit_text(units, entry.unit)), {}};
  const auto text = [&](double value) {
    return text_in(units, entry.unit, entry.shown(value), entry.digits);
  };
  for (const Estimate& e : estimates) {
    row.cells.push_back(text(e.value));
    if (e.standard_error) row.errors.push_back(text(*e.standard_error));
  }
  return row;
}

template <class Spreads>
TextTable distribution_table(const ScatterView& view, UnitSystem units, std::string title,
                             const Spreads& spreads) {
  TextTable table{std::move(title), {"mean", "standard deviation"}};
  table.omit_zeros = true;
  for (const double p : view.task->percentiles) table.columns.push_back(format_number(p) + " %");
  for (const std::optional<SpreadView>& v : spreads) {
    if (!v) continue;
    std::vector<Estimate> estimates{v->spread->mean, v->spread->standard_deviation};
    for (const Percentile& p : v->spread->percentiles) estimates.push_back(p.estimate);
    table.rows.push_back(estimate_row(units, *v->entry, v->entry->words, estimates));
  }
  return table;
}

TextTable loaded_table(const ScatterView& view, UnitSystem units, const LoadedSpreadView& v) {
  const LoadedSpread& loaded = *v.loaded;
  TextTable table =
      distribution_table(view, units,
                         fmt::format("Under {} N m: {} samples, {} positions per pitch",
                                     format_number(newton_metres(loaded.torque)),
                                     loaded.unsolved.of, view.task->load->request.positions),
                         v.spread);
  table.notes.push_back(event_words("an edge carries load", loaded.edge_carries));
  if (loaded.unsolved.count > 0)
    table.notes.push_back(event_words("a sample has no solution", loaded.unsolved));
  return table;
}

TextTable index_table(const ScatterView& view, UnitSystem units, ScatterQuantity quantity) {
  const auto at = static_cast<std::size_t>(quantity);
  const auto& indices = view.scatter->indices[at];
  TextTable table{fmt::format("Share of the variance: {}", scatter_entries()[at].words),
                  {"alone", "± s.e.", "total", "± s.e."}};
  table.omit_zeros = true;
  if (!indices) {
    table.notes.emplace_back(
        "There are no indices, because the quantity varies only by rounding or contact is lost in "
        "some samples.");
    return table;
  }
  const auto text = [](const std::optional<double>& x) {
    return x ? fixed_decimals(*x, 4) : std::string(kAbsent);
  };
  for (std::size_t g = 0; g < view.task->groups.size(); ++g) {
    const Estimate& first = indices->first[g];
    const Estimate& total = indices->total[g];
    table.rows.push_back({printable(key_in(units, view.task->groups[g].name)),
                          "",
                          {text(first.value), text(first.standard_error), text(total.value),
                           text(total.standard_error)}});
  }
  table.notes.push_back(
      indices->linear_share
          ? fmt::format("The derivatives at the nominal values explain {:.2f} % of the variance.",
                        100 * *indices->linear_share)
          : "The quantity has no derivative at the nominal values.");
  return table;
}

// Returns a table with a column for each worst value. Each column contains the worst value, its
// bound and the inputs that cause the value.
TextTable worst_table(const ScatterView& view, UnitSystem units) {
  TextTable table{"Worst values within all ranges, found by a search", {}};
  std::vector<TextTable::Row> rows{{"value", "", {}}, {"no pair has less than", "", {}}};
  for (const std::string& input : view.inputs)
    rows.push_back({printable(key_in(units, input)), "", {}});
  rows.push_back({"at a corner of the ranges", "", {}});
  bool bounds = false;
  for (const auto& w : {view.worst_peak_to_peak, view.worst_least_play}) {
    if (!w) continue;
    const ScatterEntry& entry = *w->entry;
    table.columns.emplace_back(entry.words);
    table.units.emplace_back(unit_text(entry.unit));
    const auto text = [&](double x) { return fixed_decimals(entry.shown(x), entry.digits); };
    rows[0].cells.push_back(text(w->worst->value));
    rows[1].cells.push_back(w->worst->bound ? text(*w->worst->bound) : "");
    bounds = bounds || w->worst->bound;
    for (std::size_t i = 0; i < w->at.size(); ++i) {
      const auto& [name, value] = w->at[i];
      const ValueList* list = value.list();
      std::string cell;
      for (const Value& v : list ? *list : ValueList{value})
        cell += (cell.empty() ? "" : ", ") +
                format_number(value_in(units, unit_of(name), v.number().value_or(0.0)));
      rows[2 + i].cells.push_back(cell);
    }
    rows.back().cells.emplace_back(w->worst->corner ? "yes" : "no");
  }
  if (!bounds) rows.erase(rows.begin() + 1);
  table.rows = std::move(rows);
  return table;
}

TextTable loosening_table(const ScatterView& view, UnitSystem units) {
  const Loosening& l = *view.scatter->loosening;
  const SpreadEntry& te = scatter_entries()[0];
  const auto arcsec = [&](double rad) { return fixed_decimals(te.shown(rad), te.digits); };
  TextTable table{
      fmt::format(
          "Factor by which a single tolerance can grow until the {} % point of the "
          "peak-to-peak transmission error of the first {} samples ({} ″) has grown by {:g} %",
          format_number(l.percent), view.task->samples, arcsec(l.percentile), 100 * kLooser),
      {"factor", "percentile if halved"}};
  table.units = {"", std::string(unit_text(te.unit))};
  for (std::size_t i = 0; i < l.by_tolerance.size(); ++i) {
    const Loosening::Change& c = l.by_tolerance[i];
    table.rows.push_back(
        {key_in(units, view.inputs[i]),
         "",
         {c.factor ? fixed_decimals(*c.factor, 2) : fmt::format("> {:g}", kMostFactor),
          arcsec(c.halved)}});
  }
  if (l.tighten_first) {
    const ScatterTolerance& t = view.task->tolerances[*l.tighten_first];
    table.notes.push_back(fmt::format(
        "Tighten {}{} first, because halving this tolerance lowers the percentile to {} ″.",
        key_in(units, t.name), t.of_grade(), arcsec(l.by_tolerance[*l.tighten_first].halved)));
  } else {
    table.notes.emplace_back("Halving a single tolerance does not lower the percentile.");
  }
  return table;
}

// Returns a table of the corrections and a table of the minimised percentile without and with them.
// For loaded teeth, a table of the percentiles under each torque follows.
std::vector<TextTable> robust_tables(const RobustView& r, UnitSystem units) {
  const std::string point = format_number(r.percent) + " % point";
  const std::vector<std::string> both{"without corrections", "with corrections"};
  TextTable found = correction_table(
      fmt::format("Corrections for the {} of the {}", point,
                  r.under_load ? "loaded transmission error, peak to peak, at the worst torque"
                               : "transmission error, peak to peak"),
      r.corrections, units);
  if (std::all_of(r.corrections.begin(), r.corrections.end(),
                  [](const FoundCorrection& c) { return c.value == 0.0; }))
    found.notes.emplace_back("No correction in the searched range lowers the percentile.");
  TextTable aim{"Comparison with samples that the search did not use", both};
  const JudgedFamily &before = *r.before.family, &after = *r.after.family;
  aim.rows.push_back(estimate_row(units, scatter_entries()[0], point + " of this error",
                                  {before.percentile().estimate, after.percentile().estimate}));
  const std::string edge = r.under_load ? ", an edge carries load" : ", an edge touches";
  aim.notes = {event_words(both[0] + edge, before.edge), event_words(both[1] + edge, after.edge)};
  std::vector<TextTable> tables{std::move(found), std::move(aim)};
  for (std::size_t k = 0; k < r.before.loaded.size(); ++k) {
    const double torque = newton_metres(r.before.loaded[k].loaded->torque);
    TextTable table{fmt::format("{}s under {} N m", point, format_number(torque)), both};
    for (std::size_t i = 0; i < loaded_entries().size(); ++i) {
      const LoadedEntry& entry = loaded_entries()[i];
      TextTable::Row row{entry.words, std::string(unit_text(entry.unit)), {}};
      for (const JudgedView* j : {&r.before, &r.after}) {
        const auto& v = j->loaded[k].spread[i];
        row.cells.push_back(
            v ? fixed_decimals(entry.shown(v->spread->percentiles[0].estimate.value), entry.digits)
              : std::string(kAbsent));
      }
      table.rows.push_back(std::move(row));
    }
    tables.push_back(std::move(table));
  }
  return tables;
}

}  // namespace

std::vector<TextTable> scatter_tables(const ScatterView& view, UnitSystem units) {
  const Scatter& s = *view.scatter;
  std::vector<TextTable> tables{input_table(view, units)};
  if (!view.task->correlations.empty()) tables.push_back(correlation_table(*view.task, units));
  tables.push_back(
      distribution_table(view, units,
                         fmt::format("Distribution over {} samples ({} replicates of {})",
                                     s.samples.size(), view.task->replicates, view.task->samples),
                         view.spread));
  tables.back().notes = {event_words("an edge touches", s.edge_contact),
                         event_words("the gears jam", s.jam),
                         event_words("contact is lost", s.contact_lost)};
  for (const LoadedSpreadView& v : view.loaded) tables.push_back(loaded_table(view, units, v));
  for (const ScatterQuantity q : {ScatterQuantity::peak_to_peak, ScatterQuantity::least_play})
    if (view.task->indices) tables.push_back(index_table(view, units, q));
  if (view.task->worst_case) tables.push_back(worst_table(view, units));
  if (s.loosening) tables.push_back(loosening_table(view, units));
  if (view.robust)
    for (TextTable& table : robust_tables(*view.robust, units)) tables.push_back(std::move(table));
  return tables;
}

}  // namespace gearwright
