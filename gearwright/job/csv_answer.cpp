#include "gearwright/job/csv_answer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/catalogue/columns.hpp"
#include "gearwright/catalogue/contact_quantities.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

namespace {

std::string cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string row(const std::vector<std::string>& cells) {
  return fmt::format("{}\r\n", fmt::join(cells, ","));
}

bool plain(const Value& v) { return !v.list() && !v.record() && !v.map(); }

bool all_plain(const ValueList& list) { return std::all_of(list.begin(), list.end(), plain); }

const Value kNothing;

using Cells = std::vector<const Value*>;
using Rows = std::vector<const ValueRecord*>;  // for each row, a record or null

// Calls f(column, cells) for each column of a table that the JSON result also contains and that has
// a value in at least one row.
template <class F>
void each_column(const QuantityTable& table, const Rows& rows, const F& f) {
  for (const RecordColumn& column : columns_of(table)) {
    bool there = false;
    Cells cells;
    for (const ValueRecord* row : rows) {
      const Value* const value = row ? column.in(*row) : nullptr;
      there = there || value;
      cells.push_back(value ? value : &kNothing);
    }
    if (there && column.has(kJson)) f(column, cells);
  }
}

void add_row(UnitSystem units, const QuantityInfo& info, const std::string& path,
             const Value& first, const Value& second, std::string& out) {
  const UnitSystem own = system_of(info, units);
  out += row({path, cell(key_in(units, info.words)), cell(info.symbol),
              std::string(unit_text(own, info.unit)), csv_cell(first, own, info.unit),
              csv_cell(second, own, info.unit)});
}

// Adds a quantity of one or two records. Plain values of two records are side by side. The values
// of one record are also side by side if there are two of them. A list with any other number of
// values has a row for each value. Lists of records are omitted, because only --json contains them.
void add_rows(UnitSystem units, const QuantityInfo& info, const std::string& path,
              const Cells& cells, std::string& out) {
  const ValueList* list = cells.front()->list();
  if (cells.size() == 1 && list) {
    if (!all_plain(*list)) return;
    if (list->size() == 2) {
      add_row(units, info, path, (*list)[0], (*list)[1], out);
    } else {
      for (std::size_t i = 0; i < list->size(); ++i)
        add_row(units, info, fmt::format("{}.{}", path, i + 1), (*list)[i], kNothing, out);
    }
    return;
  }
  if (!std::all_of(cells.begin(), cells.end(), [](const Value* v) { return plain(*v); })) return;
  add_row(units, info, path, *cells[0], cells.size() > 1 ? *cells[1] : kNothing, out);
}

void add_records(UnitSystem units, const std::string& path, const QuantityTable& table,
                 const Rows& records, std::string& out) {
  each_column(table, records, [&](const RecordColumn& column, const Cells& cells) {
    add_rows(units, column.info(), path + "." + key_in(units, column.name(".")), cells, out);
  });
}

std::string quantity_heads() {
  return row({"key", "quantity", "symbol", "unit", "first", "second"});
}

struct CsvColumn {
  std::string name;
  UnitSystem units;
  Unit unit;
  Cells cells;
};

// Adds a column for each plain value of a quantity, including the values in its lists and records.
void add_columns(UnitSystem units, const std::string& name, const QuantityInfo& info,
                 const Cells& cells, std::vector<CsvColumn>& all) {
  if (info.of && info.list.empty()) return;  // the columns of the record follow separately
  if (info.type == Type::map) return;        // only --json has a spec
  std::size_t longest = 0;
  Rows records;
  for (const Value* v : cells) {
    if (v->list()) longest = std::max(longest, v->list()->size());
    records.push_back(v->record());
  }
  for (std::size_t i = 0; i < longest; ++i) {
    Cells items;
    for (const Value* v : cells)
      items.push_back(v->list() && i < v->list()->size() ? &(*v->list())[i] : &kNothing);
    add_columns(units, fmt::format("{}.{}", name, i + 1), info, items, all);
  }
  if (info.of) {
    each_column(info.of(), records, [&](const RecordColumn& column, const Cells& inner) {
      add_columns(units, name + "." + key_in(units, column.name(".")), column.info(), inner, all);
    });
  } else if (longest == 0 && !std::all_of(cells.begin(), cells.end(),
                                          [](const Value* v) { return all_nothing(*v); })) {
    all.push_back({name, system_of(info, units), info.unit, cells});
  }
}

std::string records_csv(UnitSystem units, const QuantityTable& table, const ValueList& records) {
  Rows rows;
  for (const Value& v : records) rows.push_back(v.record());
  std::vector<CsvColumn> columns;
  each_column(table, rows, [&](const RecordColumn& column, const Cells& cells) {
    add_columns(units, key_in(units, column.name(".")), column.info(), cells, columns);
  });
  std::vector<std::string> line;
  for (const CsvColumn& column : columns) line.push_back(column.name);
  std::string out = row(line);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < columns.size(); ++c)
      line[c] = csv_cell(*columns[c].cells[r], columns[c].units, columns[c].unit);
    out += row(line);
  }
  return out;
}

}  // namespace

std::string csv_cell(const Value& value, UnitSystem units, Unit unit) {
  if (const auto* n = std::get_if<long long>(&value.variant())) return std::to_string(*n);
  if (const auto* flag = std::get_if<bool>(&value.variant())) return *flag ? "1" : "0";
  if (const auto* x = std::get_if<double>(&value.variant()))
    return fmt::format("{}", value_in(units, unit, *x));
  if (const auto* s = std::get_if<std::string>(&value.variant())) return cell(*s);
  return {};
}

std::string quantities_csv(const SolvedJob& job) {
  std::string out = quantity_heads();
  const UnitSystem units = job.spec.units();
  const std::vector<ValueRecord> records = gear_records(job);
  Rows gears;
  for (const ValueRecord& record : records) gears.push_back(&record);
  add_records(units, "gears", gear_quantities().table(), gears, out);
  const auto add = [&](const std::string& name, const auto& quantities, const auto& of) {
    const ValueRecord record = quantities.of(of);
    add_records(units, name, quantities.table(), {&record}, out);
  };
  for (std::size_t i = 0; i < job.gears.size(); ++i) {
    if (!job.halves[i]) continue;
    add(fmt::format("gears.{}", i), double_helical_quantities(), *job.halves[i]);
  }
  if (job.pair) add("pair", pair_quantities(), *job.pair);
  if (job.rack) {
    add("rack", rack_quantities(), job.rack->rack);
    add("pair", rack_pair_quantities(), *job.rack);
  }
  return out;
}

std::string measure_csv(const SolvedJob& job, const std::vector<GearMeasures>& measures) {
  std::string out = quantity_heads();
  const ValueList list = measure_quantities().each(measures);
  Rows rows;
  for (const Value& v : list) rows.push_back(v.record());
  add_records(job.spec.units(), "gears.measure", measure_quantities().table(), rows, out);
  return out;
}

std::string contact_csv(const SolvedJob& job, const ContactAnswer& answer) {
  return records_csv(job.spec.units(), position_quantities().table(),
                     position_quantities().each(answer.driving.positions));
}

std::string load_csv(const SolvedJob& job, const LoadAnalysis& answer) {
  ValueList rows;
  if (!answer.contact) return {};
  for (const LoadedTorque& t : answer.contact->torques)
    for (const LoadedPosition& p : t.positions)
      rows.push_back(load_position_quantities().of({&t, &p, answer.contact->regime}));
  return records_csv(job.spec.units(), load_position_quantities().table(), rows);
}

std::string propose_csv(const SolvedJob& job, const ProposeView& view) {
  return records_csv(job.spec.units(), proposal_quantities().table(),
                     proposal_quantities().each(view.proposals));
}

std::string rating_csv(const SolvedJob& job, const RatingAnswer& answer) {
  const UnitSystem units = job.spec.units();
  std::string out =
      row({"key", "quantity", "symbol", "unit", "first", "second", "formula", "branch"});
  const std::vector<FactorSource> sources = factor_sources(answer.rating);
  for (const Member& m : rating_quantities().of(answer)) {
    const QuantityInfo& info = *m.info;
    if (info.type == Type::map) continue;
    const ValueList* two = m.value.list();
    const auto source = std::find_if(sources.begin(), sources.end(),
                                     [&](const FactorSource& s) { return s.key == info.key; });
    const bool known = source != sources.end();
    const std::string branches = known ? fmt::format("{}", fmt::join(source->branches, "; ")) : "";
    out += row({"rating." + key_in(units, info.key), cell(info.words), cell(info.symbol),
                std::string(unit_text(units, info.unit)),
                csv_cell(two ? two->front() : m.value, units, info.unit),
                two ? csv_cell(two->back(), units, info.unit) : "",
                known ? cell(source->formula) : "", cell(sentence_in(units, branches))});
  }
  return out;
}

std::string outline_csv(const Outline& outline, int points, UnitSystem units) {
  std::string out = row({"arc", key_in(units, "x_mm"), key_in(units, "y_mm")});
  for (const Arc& arc : outline.arcs) {
    for (const Vec2& p : sample(arc, points))
      out += row({std::string(to_string(arc.name)), csv_cell(p.x(), units, Unit::mm),
                  csv_cell(p.y(), units, Unit::mm)});
  }
  return out;
}

}  // namespace gearwright
