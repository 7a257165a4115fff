#include "gearwright/job/listing.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/base/overloaded.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/base/system.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

namespace {

constexpr std::size_t kWordsWidth = 38;  // width of the labels, unless a label is longer
constexpr std::size_t kSymbolWidth = 9;  // the longest symbol, "F_z/F_t", and two blanks
constexpr std::size_t kValueWidth = 13;  // "-123456.1234"; a line for two gears then has 80 columns
constexpr std::size_t kUnitWidth = 11;   // the longest unit, "N/(mm µm)", and two blanks

std::string line(const std::string& words, std::size_t words_width, const std::string& symbol,
                 const std::vector<std::string>& values, std::string_view unit,
                 std::size_t columns = 0, const std::string& note = {}) {
  std::string text = "  " + padded(words, words_width) + padded(symbol, kSymbolWidth);
  for (const std::string& v : values)
    text += character_count(v) < kValueWidth ? padded_left(v, kValueWidth) : "  " + v;
  if (!note.empty() && values.size() < columns)
    text += std::string(kValueWidth * (columns - values.size()), ' ');
  text += "  " + (note.empty() ? std::string(unit) : padded(std::string(unit), kUnitWidth) + note);
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

// Lists the values that vary within the tolerances. The text is empty if there are none.
std::string pair_interval_listing(const SolvedJob& job) {
  if (!job.ends || !job.pair) return {};
  // Each limit has a separate listing, because the values of two gears already need two columns.
  const auto both = differing(pair_limits(job));
  return "\nValues with the thinnest teeth and the most backlash\n" +
         quantity_listing(job.spec.units(), pair_quantities().table(), {both[0]}, {}) +
         "\nValues with the thickest teeth and the least backlash\n" +
         quantity_listing(job.spec.units(), pair_quantities().table(), {both[1]}, {}) +
         "  If other combinations of the tolerances give smaller or greater values, the first\n"
         "  list has the least value of all combinations, and the second list the greatest.\n";
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
      words_width = std::max(words_width, character_count(row.info->words) + 2);
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

std::vector<std::string> gear_columns(std::size_t count) {
  std::vector<std::string> columns;
  for (std::size_t i = 1; i <= count; ++i) columns.push_back(fmt::format("gear {}", i));
  return columns;
}

std::string pair_listing(const SolvedJob& job) {
  if (job.rack) {
    return "\nRack\n" + listing_of(job.spec.units(), rack_quantities(), job.rack->rack) +
           "\nRack and pinion\n" + listing_of(job.spec.units(), rack_pair_quantities(), *job.rack);
  }
  return job.pair ? pair_listing(*job.pair, job.spec.units()) + pair_interval_listing(job)
                  : std::string();
}

std::string interval_listing(const SolvedJob& job, std::size_t gear, const QuantityTable& table,
                             const RecordLimits& limits) {
  const std::vector<ValueRecord> ends = differing(limits);
  const UnitSystem units = job.spec.units();
  if (text_groups(table, ends, kListing, units, "-").empty()) return "";
  const std::string subject = gear_columns(job.gears.size())[gear];
  const Gear &one = job.ends->lower.gears[gear], &two = job.ends->upper.gears[gear];
  const auto between = [&](const char* words, double a, double b, double drawn) {
    return a == b && a == drawn
               ? std::string()
               : fmt::format("the {} {} and {} {}", words, text_in(units, Unit::mm, a, 4),
                             text_in(units, Unit::mm, b, 4), unit_text(units, Unit::mm));
  };
  const std::string allowances =
      between("thickness allowances", one.spec.thickness_allowance, two.spec.thickness_allowance,
              one.spec.thickness_allowance);
  const bool tip_given = job.completed.gears[gear]->tolerance.tip_deviations.has_value();
  const std::string tips = between("tip diameters", one.tip_diameter, two.tip_diameter,
                                   tip_given ? job.gears[gear].tip_diameter : one.tip_diameter);
  const bool both = !allowances.empty() && !tips.empty();
  const char* const distance = allowances.empty() && tips.empty() ? "both centre distances" : "";
  return fmt::format("\nValues of {} at {}{}{}{}\n{}", subject, allowances, both ? " with " : "",
                     tips, distance,
                     both ? "  The values at other combinations of the tolerances lie between the "
                            "two values of a row.\n"
                          : "") +
         quantity_listing(units, table, ends, {subject + " lower", subject + " upper"});
}

std::string title_listing(const JobSpec& spec, std::string_view before) {
  return spec.title.empty() ? "" : fmt::format("{}{}\n", before, printable(spec.title));
}

std::string gear_listing(const SolvedJob& job) {
  const std::vector<ValueRecord> records = gear_records(job);
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
    text += interval_listing(job, i, gear_quantities().table(), gear_limits(job, i));
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
                     halves ? "; contact ratios and axial force apply to one half" : "") +
         listing_of(units, pair_quantities(), pair);
}

std::string warning_listing(const std::vector<Warning>& warnings, UnitSystem units) {
  std::string out;
  for (const Warning& w : warnings) {
    out += (out.empty() ? "\n" : "") +
           wrapped(fmt::format("{}: {}{}", severity_of(w) == Severity::note ? "note" : "warning",
                               w.gear ? fmt::format("gear {}: ", w.gear) : "",
                               sentence_in(units, w.message)));
  }
  return out;
}

std::string file_listing(const std::vector<JobFile>& files, UnitSystem units) {
  std::string out = "\n";
  for (const JobFile& f : files) {
    std::string note = f.note;
    // In a note, the text after the first semicolon states what the file omits. The deviation is
    // inserted before this semicolon.
    if (f.deviation_mm)
      note.insert(std::min(note.find(';'), note.size()),
                  fmt::format(", within {:.2g} µm", f.printed_deviation_um()));
    out += "  " + padded(printable(native_text(f.path)), 44) + "  " + padded(f.what, 14) +
           sentence_in(units, note) + "\n";
  }
  return out;
}

std::string outline_listing(const Outline& outline, int n, UnitSystem units) {
  std::string out =
      padded("arc", 13) + padded(key_in(units, "x_mm"), 24) + key_in(units, "y_mm") + "\n";
  const auto number = [&](double mm) { return fmt::format("{}", value_in(units, Unit::mm, mm)); };
  for (const Arc& arc : outline.arcs) {
    const std::string name(to_string(arc.name));
    for (const Vec2& p : sample(arc, n)) {
      out += padded(name, 13) + padded(number(p.x()), 24) + number(p.y()) + "\n";
    }
  }
  return out;
}

}  // namespace gearwright
