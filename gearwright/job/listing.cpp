#include "gearwright/job/listing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "gearwright/base/overloaded.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/base/system.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/catalogue/pair_quantities.hpp"
#include "gearwright/catalogue/rack_pair_quantities.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

namespace {

// Display width of UTF-8 text: the number of bytes that do not continue a character.
std::size_t width(const std::string& s) {
  std::size_t n = 0;
  for (unsigned char c : s) n += (c & 0xC0) != 0x80;
  return n;
}

std::string pad(const std::string& s, std::size_t n) {
  return s + std::string(width(s) < n ? n - width(s) : 0, ' ');
}

std::string pad_left(const std::string& s, std::size_t n) {
  return std::string(width(s) < n ? n - width(s) : 0, ' ') + s;
}

constexpr std::size_t kWordsWidth = 38;  // minimum width, if all labels are shorter
constexpr std::size_t kSymbolWidth = 9;  // the longest symbol, "F_z/F_t", and two blanks
constexpr std::size_t kValueWidth = 13;  // "-123456.1234"; a line for two gears then has 80 columns
constexpr std::size_t kUnitWidth = 11;   // the longest unit, "N/(mm µm)", and two blanks

std::string line(const std::string& words, std::size_t words_width, const std::string& symbol,
                 const std::vector<std::string>& values, std::string_view unit,
                 std::size_t columns = 0, const std::string& note = {}) {
  std::string text = "  " + pad(words, words_width) + pad(symbol, kSymbolWidth);
  for (const std::string& v : values)
    text += width(v) < kValueWidth ? pad_left(v, kValueWidth) : "  " + v;
  if (!note.empty() && values.size() < columns)
    text += std::string(kValueWidth * (columns - values.size()), ' ');
  text += "  " + (note.empty() ? std::string(unit) : pad(std::string(unit), kUnitWidth) + note);
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

// The member of a record, or of one of its inner records, or null if the record lacks it.
const Member* member_at(const ValueRecord& record, std::string_view path) {
  const std::size_t dot = std::min(path.find('.'), path.size());
  for (const Member& m : record) {
    if (m.info->key != path.substr(0, dot)) continue;
    const ValueRecord* const inner = m.value.record();
    return dot == path.size() ? &m : inner ? member_at(*inner, path.substr(dot + 1)) : nullptr;
  }
  return nullptr;
}

// Breaks words into lines of at most 12 characters, if no word is longer.
std::vector<std::string> broken(const std::string& words) {
  constexpr std::size_t kHeadWidth = 12;
  std::vector<std::string> lines;
  std::istringstream text(words);
  for (std::string word; text >> word;) {
    if (lines.empty() || width(lines.back()) + 1 + width(word) > kHeadWidth)
      lines.push_back(word);
    else
      lines.back() += " " + word;
  }
  return lines;
}

constexpr std::string_view kAbsent = "-";  // the cell of a value that a record does not have

struct RowColumn {
  std::vector<std::string> lines;  // the heading, followed by the cells
  std::size_t head;                // number of lines of the heading
  bool left;                       // true if the cells are aligned to the left
};

// The column of a quantity that is described by `info`, or of one of the gears (1 or 2).
RowColumn row_column(UnitSystem units, const QuantityInfo& info, const std::string& head, int gear,
                     const std::vector<const Member*>& members) {
  RowColumn column{
      broken(gear > 0 ? fmt::format("{}{}{}", head, head == info.symbol ? "" : " ", gear) : head),
      0, info.type == Type::word || info.type == Type::map};
  column.lines.emplace_back(unit_text(system_of(info, units), info.unit));
  column.head = column.lines.size();
  for (const Member* m : members) {
    const ValueList* const each = m && gear > 0 ? m->value.list() : nullptr;
    const Value value = each ? (*each)[static_cast<std::size_t>(gear - 1)] : m ? m->value : Value();
    column.lines.push_back(text_of(info, value, kAbsent, units));
  }
  return column;
}

// The values that vary within the tolerances. The listing is empty if there are none.
std::string pair_interval_listing(const SolvedJob& job) {
  if (!job.ends || !job.pair) return {};
  // Each end has a listing of its own, because the values of two gears already need two columns.
  const auto both = differing(pair_quantities().of(*job.ends->lower.pair),
                              pair_quantities().of(*job.ends->upper.pair));
  return "\nValues with the thinnest teeth and the most backlash\n" +
         quantity_listing(job.spec.units(), pair_quantities().table(), {both[0]}, {}) +
         "\nValues with the thickest teeth and the least backlash\n" +
         quantity_listing(job.spec.units(), pair_quantities().table(), {both[1]}, {});
}

}  // namespace

std::string quantity_listing(UnitSystem units, const QuantityTable& table,
                             const std::vector<ValueRecord>& records,
                             const std::vector<std::string>& columns,
                             const std::function<std::string(const QuantityInfo&)>& note) {
  const std::vector<TextGroup> groups = text_groups(table, records, kListing, units, "-");
  std::size_t words_width = kWordsWidth;
  for (const TextGroup& g : groups) {
    for (const TextRow& row : g.rows)
      words_width = std::max(words_width, width(row.info->words) + 2);
  }
  std::string text;
  if (!columns.empty()) text += "\n" + line("", words_width, "", columns, "");
  for (const TextGroup& g : groups) {
    if (!g.title.empty()) text += (columns.empty() ? "\n" : "") + g.title + "\n";
    for (const TextRow& row : g.rows)
      text += line(row.info->words, words_width, row.info->symbol, row.texts, row.unit,
                   columns.size(), note ? note(*row.info) : std::string());
  }
  return text;
}

std::string row_listing(UnitSystem units, const std::vector<std::string>& names,
                        const std::vector<ValueRecord>& records,
                        std::initializer_list<std::string_view> keys) {
  struct Shown {
    const QuantityInfo* info = nullptr;
    std::vector<const Member*> members{};
  };
  std::vector<Shown> all;
  for (const std::string_view key : keys) {
    Shown shown;
    for (const ValueRecord& record : records) {
      shown.members.push_back(member_at(record, key));
      if (const Member* m = shown.members.back(); m && m->shown) shown.info = m->info;
    }
    if (shown.info) all.push_back(std::move(shown));
  }
  std::vector<RowColumn> columns{{names, 0, true}};
  for (const Shown& s : all) {
    const auto same = [&](const Shown& other) { return other.info->symbol == s.info->symbol; };
    const bool words = s.info->symbol.empty() || std::count_if(all.begin(), all.end(), same) > 1;
    const std::string& head = words ? s.info->words : s.info->symbol;
    for (const int gear : s.info->two == Two::gears ? std::vector{1, 2} : std::vector{0}) {
      RowColumn column = row_column(units, *s.info, head, gear, s.members);
      const auto cells = static_cast<std::ptrdiff_t>(records.size());
      if (std::count(column.lines.end() - cells, column.lines.end(), kAbsent) < cells)
        columns.push_back(std::move(column));
    }
  }
  std::size_t heads = 0;
  for (const RowColumn& c : columns) heads = std::max(heads, c.head);
  std::vector<std::string> lines(heads + records.size());
  for (RowColumn& c : columns) {
    c.lines.insert(c.lines.begin(), heads - c.head, "");
    std::size_t widest = 0;
    for (const std::string& text : c.lines) widest = std::max(widest, width(text));
    for (std::size_t i = 0; i < lines.size(); ++i)
      lines[i] += "  " + (c.left ? pad(c.lines[i], widest) : pad_left(c.lines[i], widest));
  }
  std::string text;
  for (std::string& each : lines) {
    each.erase(each.find_last_not_of(' ') + 1);
    if (!each.empty()) text += each + "\n";
  }
  return text;
}

std::vector<std::string> gear_columns(std::size_t count) {
  std::vector<std::string> columns;
  for (std::size_t i = 1; i <= count; ++i) columns.push_back(fmt::format("gear {}", i));
  return columns;
}

std::string pair_listing(const SolvedJob& job) {
  if (job.rack) {
    return "\nRack\n" +
           quantity_listing(job.spec.units(), rack_quantities().table(),
                            {rack_quantities().of(job.rack->rack)}, {}) +
           "\nRack and pinion\n" +
           quantity_listing(job.spec.units(), rack_pair_quantities().table(),
                            {rack_pair_quantities().of(*job.rack)}, {});
  }
  return job.pair ? pair_listing(*job.pair, job.spec.units()) + pair_interval_listing(job)
                  : std::string();
}

std::string interval_listing(const SolvedJob& job, std::size_t gear, const QuantityTable& table,
                             const ValueRecord& lower, const ValueRecord& upper) {
  const std::vector<ValueRecord> ends = differing(lower, upper);
  if (std::all_of(ends.begin(), ends.end(), [](const ValueRecord& e) { return e.empty(); }))
    return "";
  const UnitSystem units = job.spec.units();
  const std::string subject = gear_columns(job.gears.size())[gear];
  const Gear &one = job.ends->lower.gears[gear], &two = job.ends->upper.gears[gear];
  const auto between = [&](const char* words, double a, double b) {
    return a == b ? std::string()
                  : fmt::format("the {} {} and {} {}", words, text_in(units, Unit::mm, a, 4),
                                text_in(units, Unit::mm, b, 4), unit_text(units, Unit::mm));
  };
  const std::string allowances =
      between("thickness allowances", one.spec.thickness_allowance, two.spec.thickness_allowance);
  const std::string tips = between("tip diameters", one.tip_diameter, two.tip_diameter);
  const bool both = !allowances.empty() && !tips.empty();
  const char* const distance = allowances.empty() && tips.empty() ? "both centre distances" : "";
  return fmt::format("\nValues of {} at {}{}{}{}\n{}", subject, allowances, both ? " with " : "",
                     tips, distance,
                     both ? "  Other combinations can have greater or smaller values.\n" : "") +
         quantity_listing(units, table, ends, {subject + " lower", subject + " upper"});
}

std::string title_listing(const JobSpec& spec, std::string_view before) {
  return spec.title.empty() ? "" : fmt::format("{}{}\n", before, printable(spec.title));
}

std::string gear_listing(const SolvedJob& job) {
  std::vector<ValueRecord> records;
  for (std::size_t i = 0; i < job.gears.size(); ++i)
    records.push_back(gear_record(job.gears[i], job.halves[i]));
  std::string text =
      title_listing(job.spec, "\n") + quantity_listing(job.spec.units(), gear_quantities().table(),
                                                       records, gear_columns(records.size()));
  std::vector<ValueRecord> halves;
  for (const auto& of : job.halves)
    if (of) halves.push_back(double_helical_quantities().of(*of));
  if (!halves.empty())
    text += quantity_listing(job.spec.units(), double_helical_quantities().table(), halves,
                             gear_columns(halves.size()));
  for (std::size_t i = 0; job.ends && i < job.gears.size(); ++i)
    text += interval_listing(job, i, gear_quantities().table(),
                             gear_quantities().of(job.ends->lower.gears[i]),
                             gear_quantities().of(job.ends->upper.gears[i]));
  return text;
}

std::string pair_listing(const Pair& pair, UnitSystem units) {
  const char* kind =
      pair.visit(Overloaded{[](const ArcPair&) { return "Circular-arc pair, parallel axes"; },
                            [](const CrossedPair&) { return "Pair on crossed axes"; },
                            [](const ParallelPair& p) {
                              return p.margins ? "Internal pair, parallel axes"
                                               : "External pair, parallel axes";
                            }});
  const bool halves = pair.gear(1).gap.has_value();
  return fmt::format("\n{}{}\n", kind,
                     halves ? "; contact ratios and axial force are those of one half" : "") +
         quantity_listing(units, pair_quantities().table(), {pair_quantities().of(pair)}, {});
}

std::string warning_listing(const std::vector<Warning>& warnings, UnitSystem units) {
  std::string out;
  for (const Warning& w : warnings) {
    out +=
        fmt::format("{}{}: {}{}\n", out.empty() ? "\n" : "",
                    severity_of(w) == Severity::note ? "note" : "warning",
                    w.gear ? fmt::format("gear {}: ", w.gear) : "", sentence_in(units, w.message));
  }
  return out;
}

std::string file_listing(const std::vector<JobFile>& files, UnitSystem units) {
  std::string out = "\n";
  for (const JobFile& f : files) {
    std::string note = f.note;
    // The deviation follows the first part of the note, before what the file omits.
    if (f.deviation_mm)
      note.insert(std::min(note.find(';'), note.size()),
                  fmt::format(", within {:.2g} µm", *f.deviation_mm * kUmPerMm));
    out += "  " + pad(printable(native_text(f.path)), 44) + "  " + pad(f.what, 14) +
           sentence_in(units, note) + "\n";
  }
  return out;
}

std::string outline_listing(const Outline& outline, int n, UnitSystem units) {
  std::string out = pad("arc", 13) + pad(key_in(units, "x_mm"), 24) + key_in(units, "y_mm") + "\n";
  const auto number = [&](double mm) { return fmt::format("{}", value_in(units, Unit::mm, mm)); };
  for (const Arc& arc : outline.arcs) {
    const std::string name(to_string(arc.name));
    for (const Vec2& p : sample(arc, n)) {
      out += pad(name, 13) + pad(number(p.x()), 24) + number(p.y()) + "\n";
    }
  }
  return out;
}

}  // namespace gearwright
