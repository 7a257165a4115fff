#include "gearwright/spec/read_gear.hpp"

#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/gear_keys.hpp"

namespace gearwright {

namespace {

namespace fs = std::filesystem;

// Least distance of two neighbouring lines of a grid, relative to the range of all lines. Closer
// lines are rejected. They are probably one line that was measured twice, and a spline would turn
// the noise between them into a slope.
constexpr double kMinStep = 1e-4;

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells = split(line, ',');
  for (std::string_view& cell : cells) cell = trimmed(cell);
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
      const auto value = decimal_number(cells[i]);
      good = value.has_value();
      x[i] = value.value_or(0.0);
    }
    if (!good) {
      return at_line(line,
                     fmt::format("\"{}\" must be three numbers (diameter_mm, z_mm, removed_um) "
                                 "that are separated by commas and have points as decimal marks",
                                 printable(std::string(text), 60)));
    }
    if (!(x[0] > 0.0)) return at_line(line, "the diameter must be greater than 0");
    for (const double v : x) {
      if (!(std::abs(v) <= kMaxInput))
        return at_line(line, fmt::format("numbers must lie between -{0} and {0}", kMaxInput));
    }
    rows.push_back({x[0], x[1], x[2], line});
  }
  return rows;
}

std::vector<double> lines_of(const std::vector<Row>& rows, double Row::*column) {
  std::vector<double> x;
  for (const Row& row : rows) x.push_back(row.*column);
  std::sort(x.begin(), x.end());
  x.erase(std::unique(x.begin(), x.end()), x.end());
  return x;
}

std::optional<Error> check_lines(const char* what, const std::vector<double>& x) {
  if (x.size() < 2) {
    return Error{"", "",
                 fmt::format("at least two {} are needed, but there are {}", what, x.size())};
  }
  const double least = kMinStep * (x.back() - x.front());
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (x[i] - x[i - 1] >= least) continue;
    return Error{"", "",
                 fmt::format("the {} {} and {} are closer together than a ten-thousandth of their "
                             "range; write the same number if they belong to one line of the grid",
                             what, x[i - 1], x[i])};
  }
  return std::nullopt;
}

std::string read_whole(const TableReader& t, const std::string& key, const fs::path& path) {
  const std::string shown = printable(path.string(), 200);
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (error == std::errc::permission_denied)
    throw IoError("cannot read", path, error.default_error_condition().value(), error.message());
  if (!fs::is_regular_file(status)) {
    t.fail(key, fmt::format("{} is not a file; a relative name starts at the folder of the spec",
                            shown));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw IoError("cannot read", path, errno);
  std::string text(kMaxTopography + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) throw IoError("cannot read", path, errno);
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > kMaxTopography) {
    t.fail(key, fmt::format("has more than {} bytes; use a coarser grid, which is sufficient "
                            "because a cubic spline interpolates between the points",
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
    return at_line(rows[k].line, fmt::format("diameter {} and z {} are already in line {}",
                                             rows[k].diameter, rows[k].z, rows[k - 1].line));
  }
  Topography t{lines_of(rows, &Row::diameter), lines_of(rows, &Row::z), {}};
  if (auto error = check_lines("diameters", t.diameters)) return *error;
  if (auto error = check_lines("heights z", t.heights)) return *error;
  // The rows are sorted and unique. The first row that differs from the next point of the grid
  // shows that this point is missing.
  const std::size_t columns = t.heights.size();
  for (std::size_t k = 0; k < t.diameters.size() * columns; ++k) {
    const double d = t.diameters[k / columns];
    const double z = t.heights[k % columns];
    if (k == rows.size() || rows[k].diameter != d || rows[k].z != z) {
      return Error{"", "",
                   fmt::format("a grid of {} diameters and {} heights z needs a row for each of "
                               "its {} points, but there is no row for diameter {} and z {}",
                               t.diameters.size(), columns, t.diameters.size() * columns, d, z)};
    }
    t.removed.push_back(rows[k].removed / kUmPerMm);
  }
  return t;
}

BothFlanks read_modifications(TableReader& gear, const fs::path& folder) {
  FlanksInput input;
  const Json* node = gear.table("modifications");
  if (!node) return input.flanks;
  TableReader t(modification_keys(), *node, gear.name("modifications"));
  t.read_whole(input);
  const auto& files = input.topography;
  for (const std::size_t flank : {0, 1}) {
    if (!files[flank]) continue;
    const std::string key =
        key_of_flank([&](auto name) { return t.given(name); }, flank, "topography");
    auto& topography = input.flanks[flank].topography;
    if (flank == 1 && files[0] == files[1]) {
      topography = input.flanks[0].topography;
      continue;
    }
    auto grid = topography_from_csv(read_whole(t, key, folder / *files[flank]));
    if (!grid) t.fail(key, grid.error().rule);
    topography = std::make_shared<const Topography>(std::move(grid).take());
  }
  return input.flanks;
}

}  // namespace gearwright
