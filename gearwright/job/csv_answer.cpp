#include "gearwright/job/csv_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/catalogue/pair_quantities.hpp"
#include "gearwright/job/contact_text.hpp"

namespace gearwright {

namespace {

std::string cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

// A plain value; lists and records have cells of their own.
std::string cell(const Value& value) {
  if (const auto* n = std::get_if<long long>(&value.variant())) return std::to_string(*n);
  if (const auto* flag = std::get_if<bool>(&value.variant())) return *flag ? "1" : "0";
  if (const auto* x = std::get_if<double>(&value.variant())) return fmt::format("{}", *x);
  if (const auto* s = std::get_if<std::string>(&value.variant())) return cell(std::string_view(*s));
  return {};
}

std::string row(const std::vector<std::string>& cells) {
  return fmt::format("{}\r\n", fmt::join(cells, ","));
}

bool plain(const Value& v) { return !v.list() && !v.record() && !v.map(); }

bool all_plain(const ValueList& list) { return std::all_of(list.begin(), list.end(), plain); }

void add_row(const QuantityInfo& info, const std::string& path, const std::string& first,
             const std::string& second, std::string& out) {
  out += row({path, cell(std::string_view(info.words)), cell(std::string_view(info.symbol)),
              std::string(unit_text(info.unit)), first, second});
}

// A quantity of one or two records: plain values side by side, two of one record too; a longer list
// of one record takes a row for each. Lists of records are for --json.
void add_rows(const QuantityInfo& info, const std::string& path,
              const std::vector<const Value*>& values, std::string& out) {
  const ValueList* list = values.front()->list();
  if (values.size() == 1 && list) {
    if (!all_plain(*list)) return;
    if (list->size() == 2) {
      add_row(info, path, cell((*list)[0]), cell((*list)[1]), out);
    } else {
      for (std::size_t i = 0; i < list->size(); ++i)
        add_row(info, fmt::format("{}.{}", path, i + 1), cell((*list)[i]), "", out);
    }
    return;
  }
  if (!std::all_of(values.begin(), values.end(), [](const Value* v) { return plain(*v); })) return;
  add_row(info, path, cell(*values[0]), values.size() > 1 ? cell(*values[1]) : "", out);
}

// Records side by side, those of the gears, or one of the pair; null: the gear has none.
void add_records(const std::string& path, const std::vector<const ValueRecord*>& records,
                 std::string& out) {
  std::vector<const QuantityInfo*> all;
  for (const ValueRecord* record : records) {
    if (!record) continue;
    for (const Member& m : *record) {
      if ((m.info->doors & kJson) && std::find(all.begin(), all.end(), m.info) == all.end())
        all.push_back(m.info);
    }
  }
  static const Value kNothing;
  for (const QuantityInfo* info : all) {
    std::vector<const Value*> values;
    std::vector<const ValueRecord*> inner;
    for (const ValueRecord* record : records) {
      const Value* value = &kNothing;
      if (record) {
        const auto same = std::find_if(record->begin(), record->end(),
                                       [&](const Member& o) { return o.info == info; });
        if (same != record->end()) value = &same->value;
      }
      values.push_back(value);
      inner.push_back(value->record());
    }
    const std::string here = path + "." + info->key;
    if (std::any_of(inner.begin(), inner.end(), [](const auto* r) { return r != nullptr; })) {
      add_records(here, inner, out);
    } else {
      add_rows(*info, here, values, out);
    }
  }
}

using Cells = std::vector<std::pair<std::string, std::string>>;

// Columns of one value of a row: records and short lists take one for each number.
void add_cells(const std::string& name, const Value& value, Cells& cells) {
  if (const ValueRecord* record = value.record()) {
    for (const Member& m : *record)
      if (m.info->doors & kJson) add_cells(name + "." + m.info->key, m.value, cells);
  } else if (const ValueList* list = value.list()) {
    for (std::size_t i = 0; i < list->size(); ++i)
      add_cells(fmt::format("{}.{}", name, i + 1), (*list)[i], cells);
  } else if (!value.nothing()) {
    cells.emplace_back(name, cell(value));
  }
}

// Rows of records; a column for whatever one of them has.
std::string records_csv(const ValueList& records) {
  std::vector<std::string> heads;
  std::vector<Cells> rows;
  for (const Value& v : records) {
    Cells cells;
    for (const Member& m : *v.record())
      if (m.info->doors & kJson) add_cells(m.info->key, m.value, cells);
    std::size_t at = 0;
    for (const auto& [name, text] : cells) {
      const auto it = std::find(heads.begin(), heads.end(), name);
      // What this row has and no earlier one stands beside its neighbour.
      if (it == heads.end()) {
        heads.insert(heads.begin() + static_cast<std::ptrdiff_t>(at++), name);
      } else {
        at = static_cast<std::size_t>(it - heads.begin()) + 1;
      }
    }
    rows.push_back(std::move(cells));
  }
  std::string out = row(heads);
  for (const Cells& cells : rows) {
    std::vector<std::string> line(heads.size());
    for (const auto& [name, text] : cells)
      line[static_cast<std::size_t>(std::find(heads.begin(), heads.end(), name) - heads.begin())] =
          text;
    out += row(line);
  }
  return out;
}

}  // namespace

std::string quantities_csv(const SolvedJob& job) {
  std::string out = row({"key", "quantity", "symbol", "unit", "first", "second"});
  std::vector<ValueRecord> records;
  for (const Gear& g : job.gears) records.push_back(gear_quantities().of(g));
  std::vector<const ValueRecord*> gears;
  for (const ValueRecord& record : records) gears.push_back(&record);
  add_records("gears", gears, out);
  if (job.pair) {
    const ValueRecord pair = pair_quantities().of(*job.pair);
    add_records("pair", {&pair}, out);
  }
  return out;
}

std::string contact_csv(const SolvedJob& job, const ContactAnswer& answer) {
  for (const Member& m : contact_record(job, answer)) {
    if (m.info->key == "positions" && m.value.list()) return records_csv(*m.value.list());
  }
  return {};
}

std::string load_csv(const LoadAnalysis& answer) {
  ValueList rows;
  if (!answer.contact) return {};
  for (const LoadedTorque& t : answer.contact->torques)
    for (const LoadedPosition& p : t.positions)
      rows.push_back(load_position_quantities().of({&t, &p, answer.contact->regime}));
  return records_csv(rows);
}

std::string rating_csv(const RatingAnswer& answer) {
  std::string out =
      row({"key", "quantity", "symbol", "unit", "first", "second", "formula", "branch"});
  const std::vector<FactorSource> sources = factor_sources(answer.rating);
  for (const Member& m : rating_quantities().of(answer.view())) {
    const QuantityInfo& info = *m.info;
    if (info.type == Type::map) continue;
    const ValueList* two = m.value.list();
    const auto source = std::find_if(sources.begin(), sources.end(),
                                     [&](const FactorSource& s) { return s.key == info.key; });
    const bool known = source != sources.end();
    const std::string branches = known ? fmt::format("{}", fmt::join(source->branches, "; ")) : "";
    out += row({"rating." + info.key, cell(std::string_view(info.words)),
                cell(std::string_view(info.symbol)), std::string(unit_text(info.unit)),
                cell(two ? two->front() : m.value), two ? cell(two->back()) : "",
                known ? cell(std::string_view(source->formula)) : "",
                cell(std::string_view(branches))});
  }
  return out;
}

std::string outline_csv(const Outline& outline, int points) {
  std::string out = row({"arc", "x_mm", "y_mm"});
  for (const Arc& arc : outline.arcs) {
    for (const Vec2& p : sample(arc, points))
      out += row(
          {std::string(to_string(arc.name)), fmt::format("{}", p.x()), fmt::format("{}", p.y())});
  }
  return out;
}

}  // namespace gearwright
