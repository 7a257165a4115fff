#include "gearwright/job/search_files.hpp"

#include <fmt/format.h>

#include "gearwright/base/output_file.hpp"
#include "gearwright/store/parquet.hpp"
#include "gearwright/job/search_answer.hpp"
#include "gearwright/job/search_tables.hpp"
#include "gearwright/base/version.hpp"
#include "gearwright/report/search_report.hpp"

namespace gearwright {

namespace {

constexpr std::size_t kCsvDesigns = 1000;  // unless --top asks for more: people read this one

// One table on its way to disk.
template <class Row>
class Table {
 public:
  Table(const std::filesystem::path& part, const std::vector<TableColumn<Row>>& columns,
        const std::vector<std::pair<std::string, std::string>>& notes)
      : columns_(columns), writer_(part, heads(columns), notes) {}

  void add(const Row& row) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const TableValue v = columns_[i].value(row);
      if (const auto* n = std::get_if<std::int64_t>(&v)) writer_.set(i, *n);
      if (const auto* x = std::get_if<double>(&v)) writer_.set(i, *x);
      if (const auto* s = std::get_if<std::string>(&v)) writer_.set(i, std::string_view(*s));
    }
    writer_.end_row();
  }
  void close() { writer_.close(); }

 private:
  static std::vector<ParquetColumn> heads(const std::vector<TableColumn<Row>>& columns) {
    std::vector<ParquetColumn> h;
    for (const auto& c : columns) h.push_back({c.name, c.type, c.optional});
    return h;
  }
  const std::vector<TableColumn<Row>>& columns_;
  ParquetWriter writer_;
};

// Both tables in one pass over the finds; without a grid of shifts there is no second one.
void write_tables(const std::filesystem::path& designs, const std::filesystem::path& points,
                  const JobSpec& spec, const Search& search, const FindSource& source) {
  std::string limits;
  for (int i = 0; i < kLimits; ++i)
    limits += fmt::format("{}{}", i == 0 ? "" : ", ", name(static_cast<Limit>(i)));
  const std::vector<std::pair<std::string, std::string>> notes{
      {"program", fmt::format("gearwright {}", kVersion)},
      {"spec", spec.tree},
      {"limits", limits},
      {"trials", std::to_string(*search.space().size())}};
  write_file_by(designs, [&](const std::filesystem::path& part) {
    Table<DesignRow> table(part, design_columns(), notes);
    const auto each = [&](const auto& also) {
      ChunkFinds finds;
      while (source(finds)) {
        for (const DesignRow& row : finds.designs) table.add(row);
        also(finds);
      }
    };
    if (!search.problem().shift_step) {
      each([](const ChunkFinds&) {});
    } else {
      write_file_by(points, [&](const std::filesystem::path& points_part) {
        Table<ShiftPoint> cloud(points_part, point_columns(), notes);
        each([&](const ChunkFinds& finds) {
          for (const ShiftPoint& p : finds.points) cloud.add(p);
        });
        cloud.close();
      });
    }
    table.close();
  });
}

std::string csv_text(const SearchAnswer& answer, std::size_t most) {
  const auto& table = design_columns();
  std::string text = "rank";
  for (const auto& c : table) text += "," + c.name;
  text += ",front\n";
  std::size_t on_front = 0;
  for (std::size_t i = 0; i < answer.designs.size() && i < most; ++i) {
    text += std::to_string(i + 1);
    for (const auto& c : table) {
      const TableValue v = c.value(answer.designs[i]);
      text += ',';
      if (const auto* n = std::get_if<std::int64_t>(&v)) text += std::to_string(*n);
      if (const auto* x = std::get_if<double>(&v)) text += fmt::format("{}", *x);
      if (const auto* s = std::get_if<std::string>(&v)) text += *s;
    }
    const bool front = on_front < answer.pareto.size() && answer.pareto[on_front] == i;
    if (front) ++on_front;
    text += front ? ",1\n" : ",0\n";
  }
  return text;
}

// What the page says beside the counts.
std::vector<std::string> reasons_of(const SearchRun& run) {
  std::vector<std::string> lines;
  if (run.answer.counts.feasible > 0) return lines;
  for (const std::string& line : change_lines(run))
    lines.push_back("One change that would let something through: " + line + ".");
  if (lines.empty()) {
    lines.push_back(run.changes_left_out.empty() ? "No change of one number alone would help."
                                                 : run.changes_left_out + ".");
  }
  return lines;
}

}  // namespace

std::vector<std::filesystem::path> write_search_files(const JobSpec& spec, const Search& search,
                                                      const SearchRun& run,
                                                      const std::filesystem::path& folder,
                                                      std::optional<std::size_t> top,
                                                      const FindSource& source) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw IoError("cannot make the folder " + folder.string() + ": " + error.message());
  std::vector<std::filesystem::path> files{folder / "search.parquet"};
  if (search.problem().shift_step) files.push_back(folder / "points.parquet");
  write_tables(files.front(), files.back(), spec, search, source);
  const auto write = [&](const char* name, const std::string& text) {
    files.push_back(folder / name);
    write_file(files.back(), text);
  };
  write("best.csv", csv_text(run.answer, top.value_or(kCsvDesigns)));
  write("search.json", search_json_text(search, run));
  write("report.html", search_report({.title = spec.title,
                                      .spec_text = spec.text,
                                      .search = search,
                                      .answer = run.answer,
                                      .reasons = reasons_of(run),
                                      .version = kVersion}));
  return files;
}

}  // namespace gearwright
