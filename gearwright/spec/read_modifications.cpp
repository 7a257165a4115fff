#include "gearwright/spec/read_modifications.hpp"

#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <locale>
#include <sstream>

#include "gearwright/base/output_file.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/modification_keys.hpp"

namespace gearwright {

namespace {

namespace fs = std::filesystem;

constexpr double kMaxNumber = 1e9;  // of any number of a spec, in its unit
// Two lines of a grid nearer to each other than this, over the range, are one line measured twice:
// the spline between them would make a slope of what is noise.
constexpr double kMinStep = 1e-4;

// A key's values: for both flanks (0), for the right one (1) and for the left one (2).
template <class T>
struct Sided {
  std::string key;
  std::array<std::optional<T>, 3> given;

  std::string name(std::size_t which) const {
    return which == 0 ? key : std::string(kFlankSides[which - 1]) + key;
  }
  /// Which of the three counts for a flank (0 right, 1 left).
  std::size_t which(std::size_t flank) const { return given[flank + 1] ? flank + 1 : 0; }
  const std::optional<T>& of(std::size_t flank) const { return given[which(flank)]; }
};

template <class Read>
auto read_sided(TableReader& t, const std::string& key, const Read& read) {
  using T = typename decltype(read(key))::value_type;
  Sided<T> s{key, {}};
  for (std::size_t i = 0; i < 3; ++i) s.given[i] = read(s.name(i));
  if (s.given[0] && s.given[1] && s.given[2]) {
    t.fail(key, fmt::format("has no effect beside {} and {}; leave it out", s.name(1), s.name(2)));
  }
  return s;
}

Sided<double> read_number(TableReader& t, const std::string& key) {
  return read_sided(t, key, [&](const std::string& k) { return t.number(k); });
}

struct ReliefInput {
  Sided<double> amount, reach;
  Sided<std::string> shape;
};

ReliefInput read_relief(TableReader& t, const ModificationEntry& m) {
  const std::string name(m.name);
  return {read_number(t, name + "_um"), read_number(t, name + std::string(m.reach)),
          read_sided(t, name + "_shape", [&](const std::string& k) { return t.word(k); })};
}

// A start or a shape of a relief that neither of its flanks has would be lost without a word.
template <class T>
void check_used(const TableReader& t, const Sided<T>& s, const Sided<double>& amount) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!s.given[i]) continue;
    bool used = false;
    for (std::size_t flank = 0; flank < 2; ++flank)
      used = used || (s.which(flank) == i && amount.of(flank));
    if (!used) t.fail(s.name(i), "belongs to " + amount.key + ", which is not given here");
  }
}

void take_relief(const TableReader& t, const ReliefInput& in, Relief FlankModifications::*relief,
                 std::array<FlankModifications, 2>& flanks) {
  check_used(t, in.reach, in.amount);
  check_used(t, in.shape, in.amount);
  for (std::size_t flank = 0; flank < 2; ++flank) {
    const auto& amount = in.amount.of(flank);
    if (!amount) continue;
    if (*amount > 0.0 && !in.reach.of(flank)) {
      t.fail(in.reach.key,
             "is missing: " + in.amount.name(in.amount.which(flank)) + " needs it beside it");
    }
    const auto& shape = in.shape.of(flank);
    flanks[flank].*
        relief = {*amount / kUmPerMm, in.reach.of(flank),
                  shape && *shape == "parabolic" ? ReliefShape::parabolic : ReliefShape::linear};
  }
}

std::string_view trimmed(std::string_view s) {
  const std::size_t begin = s.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return s.substr(begin, s.find_last_not_of(" \t\r") - begin + 1);
}

// The same in every locale.
std::optional<double> number_of(std::string_view cell) {
  std::istringstream in{std::string(cell)};
  in.imbue(std::locale::classic());
  double x = 0.0;
  if (!(in >> x) || in.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
  return x;
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin != std::string_view::npos;) {
    const std::size_t comma = line.find(',', begin);
    cells.push_back(trimmed(line.substr(begin, comma - begin)));
    begin = comma == std::string_view::npos ? comma : comma + 1;
  }
  return cells;
}

struct Row {
  double diameter, z, removed;
  int line;
};

Error at_line(int line, const std::string& why) {
  return {"", "", fmt::format("line {}: {}", line, why)};
}

bool is_header(const std::vector<std::string_view>& cells) {
  return cells == std::vector<std::string_view>{"diameter_mm", "z_mm", "removed_um"};
}

Result<std::vector<Row>> rows_of(std::string_view csv) {
  if (csv.substr(0, 3) == "\xef\xbb\xbf") csv.remove_prefix(3);
  std::vector<Row> rows;
  bool first = true;
  int line = 0;
  while (!csv.empty()) {
    ++line;
    const std::size_t end = csv.find('\n');
    const std::string_view text = trimmed(csv.substr(0, end));
    csv.remove_prefix(end == std::string_view::npos ? csv.size() : end + 1);
    if (text.empty() || text.front() == '#') continue;
    const auto cells = cells_of(text);
    const bool may_be_header = first;
    first = false;
    if (may_be_header && is_header(cells)) continue;
    std::array<double, 3> x{};
    bool good = cells.size() == x.size();
    for (std::size_t i = 0; good && i < x.size(); ++i) {
      const auto value = number_of(cells[i]);
      good = value.has_value();
      x[i] = value.value_or(0.0);
    }
    if (!good) {
      return at_line(line, fmt::format("\"{}\" must be three numbers with commas between, "
                                       "diameter_mm, z_mm, removed_um, and points as decimal marks",
                                       printable(std::string(text), 60)));
    }
    if (!(x[0] > 0.0)) return at_line(line, "the diameter must be greater than 0");
    for (const double v : x) {
      if (!(std::abs(v) <= kMaxNumber))
        return at_line(line, fmt::format("numbers must lie between -{0} and {0}", kMaxNumber));
    }
    rows.push_back({x[0], x[1], x[2], line});
  }
  return rows;
}

// The different values of a column, growing.
std::vector<double> lines_of(const std::vector<Row>& rows, double Row::*column) {
  std::vector<double> x;
  for (const Row& row : rows) x.push_back(row.*column);
  std::sort(x.begin(), x.end());
  x.erase(std::unique(x.begin(), x.end()), x.end());
  return x;
}

std::optional<Error> check_lines(const char* what, const std::vector<double>& x) {
  if (x.size() < 2) {
    return Error{"", "", fmt::format("there must be two {} or more, here are {}", what, x.size())};
  }
  const double least = kMinStep * (x.back() - x.front());
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (x[i] - x[i - 1] >= least) continue;
    return Error{"", "",
                 fmt::format("the {} {} and {} lie nearer to each other than a ten-thousandth of "
                             "their range; write one number where one line of the grid is meant",
                             what, x[i - 1], x[i])};
  }
  return std::nullopt;
}

std::string read_whole(const TableReader& t, const std::string& key, const fs::path& path) {
  const std::string shown = printable(path.string(), 200);
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (error == std::errc::permission_denied)
    throw IoError("cannot read " + shown + ": " + error.message());
  if (!fs::is_regular_file(status)) {
    t.fail(key, fmt::format("{} is not a file; a relative name starts at the folder of the spec",
                            shown));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw IoError("cannot read " + shown + ": " + std::strerror(errno));
  std::string text(kMaxTopography + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) throw IoError("cannot read " + shown + ": " + std::strerror(errno));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > kMaxTopography) {
    t.fail(key, fmt::format("has more than {} bytes; a coarser grid will do, a cubic spline runs "
                            "between its points",
                            kMaxTopography));
  }
  return text;
}

}  // namespace

Result<Topography> topography_from_csv(std::string_view csv) {
  auto read = rows_of(csv);
  if (!read) return read.error();
  std::vector<Row> rows = std::move(read).take();
  const auto by_place = [](const Row& a, const Row& b) {
    return a.diameter != b.diameter ? a.diameter < b.diameter : a.z < b.z;
  };
  std::stable_sort(rows.begin(), rows.end(), by_place);
  for (std::size_t k = 1; k < rows.size(); ++k) {
    if (by_place(rows[k - 1], rows[k])) continue;
    return at_line(rows[k].line, fmt::format("the point {}, {} stands in line {} already",
                                             rows[k].diameter, rows[k].z, rows[k - 1].line));
  }
  Topography t{lines_of(rows, &Row::diameter), lines_of(rows, &Row::z), {}};
  if (auto error = check_lines("diameters", t.diameters)) return *error;
  if (auto error = check_lines("heights z", t.heights)) return *error;
  // Sorted and each once: the first row that is not the next point of the grid comes after a gap.
  const std::size_t columns = t.heights.size();
  for (std::size_t k = 0; k < t.diameters.size() * columns; ++k) {
    const double d = t.diameters[k / columns];
    const double z = t.heights[k % columns];
    if (k == rows.size() || rows[k].diameter != d || rows[k].z != z) {
      return Error{"", "",
                   fmt::format("{} diameters and {} heights z need a row for each of their {} "
                               "points; {}, {} has none",
                               t.diameters.size(), columns, t.diameters.size() * columns, d, z)};
    }
    t.removed.push_back(rows[k].removed / kUmPerMm);
  }
  return t;
}

std::array<FlankModifications, 2> read_modifications(TableReader& gear, const fs::path& folder) {
  std::array<FlankModifications, 2> flanks;
  const Json* node = gear.table("modifications");
  if (!node) return flanks;
  TableReader t(modification_keys(), *node, gear.name("modifications"));
  std::vector<std::pair<const ModificationEntry*, ReliefInput>> reliefs;
  std::vector<std::pair<const ModificationEntry*, Sided<double>>> plain;
  for (const ModificationEntry& m : modification_entries()) {
    if (m.relief) {
      reliefs.emplace_back(&m, read_relief(t, m));
    } else {
      plain.emplace_back(&m, read_number(t, std::string(m.name) + "_um"));
    }
  }
  const auto file = read_sided(t, "topography", [&](const std::string& k) { return t.text(k); });
  t.finish();
  for (const auto& [m, input] : reliefs) take_relief(t, input, m->relief, flanks);
  for (const auto& [m, input] : plain) {
    for (std::size_t flank = 0; flank < 2; ++flank)
      flanks[flank].*(m->amount) = input.of(flank).value_or(0.0) / kUmPerMm;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (!file.given[i]) continue;
    const std::string key = file.name(i);
    auto grid = topography_from_csv(read_whole(t, key, folder / *file.given[i]));
    if (!grid) t.fail(key, grid.error().rule);
    const auto shared = std::make_shared<const Topography>(std::move(grid).take());
    for (std::size_t flank = 0; flank < 2; ++flank) {
      if (file.which(flank) == i) flanks[flank].topography = shared;
    }
  }
  return flanks;
}

}  // namespace gearwright
