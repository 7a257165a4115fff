#include "gearwright/job/search_files.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

#include "gearwright/base/output_file.hpp"
#include "gearwright/base/version.hpp"
#include "gearwright/job/csv_answer.hpp"
#include "gearwright/job/search_answer.hpp"
#include "gearwright/job/search_tables.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

void add_heads(const RecordColumn& column, std::vector<ParquetColumn>& heads) {
  const QuantityInfo& info = column.info();
  const ParquetType type = info.type == Type::index ? ParquetType::int64
                           : info.type == Type::whole || info.type == Type::flag
                               ? ParquetType::int32
                           : info.type == Type::number ? ParquetType::float64
                                                       : ParquetType::text;
  const std::size_t mark = info.column.find('#');
  const std::vector<std::string> names = info.list.empty() ? std::vector<std::string>{""}
                                         : info.two == Two::ends
                                             ? std::vector<std::string>{"min", "max"}
                                             : std::vector<std::string>{"1", "2"};
  for (const std::string& name : names) {
    std::string head = info.column;
    if (mark != std::string::npos) head.replace(mark, 1, name);
    heads.push_back({std::move(head), type, !info.always});
  }
}

TableColumns<DesignView> design_columns(const SearchProblem& problem) {
  // Columns that exist only for some problems.
  const std::set<std::string_view> optional{
      "backlash_mm", "face_width_mm", "S_H",           "S_F",      "mass_kg",
      "efficiency",  "balance",       "relative_cost", "noise_um", "loaded_noise_um"};
  const DesignRow any;
  std::vector<std::string_view> without;
  const Quantities<DesignView>& quantities = design_quantities();
  for (const Quantity& q : quantities.list())
    if (optional.contains(q.info.key) && !quantities.exists(q, {&problem, &any}))
      without.push_back(q.info.key);
  return TableColumns<DesignView>(design_quantities(), without);
}

TableColumns<ShiftPoint> point_columns() { return TableColumns<ShiftPoint>(point_quantities()); }

namespace {

// Default number of designs in best.csv. The option --top replaces it.
constexpr std::size_t kCsvDesigns = 1000;

// Writes both tables in one pass over the designs. The second table exists only if the spec
// requests a grid of profile shifts. The source contains no transmission errors under load, which
// are in `loaded`.
void write_tables(const std::filesystem::path& designs, const std::filesystem::path& points,
                  const JobSpec& spec, const Search& search,
                  const std::vector<LoadedDesign>& loaded, const FindSource& source) {
  std::map<std::int64_t, std::optional<double>> noises;
  for (const LoadedDesign& design : loaded) noises.emplace(design.trial.index, design.noise);
  std::string limits;
  for (const Limit limit : search.problem().rejecting_limits())
    limits += fmt::format("{}{}", limits.empty() ? "" : ", ", name(limit));
  const std::vector<std::pair<std::string, std::string>> notes{
      {"program", fmt::format("gearwright {}", kVersion)},
      {kSpecNote, json_text(spec.tree->tables)},
      {"limits", limits},
      {"trials", std::to_string(*search.space().size())}};
  write_file_by(designs, [&](const std::filesystem::path& part) {
    ParquetTable<DesignView> table(part, design_columns(search.problem()), notes);
    const auto each = [&](const auto& also) {
      ChunkFinds finds;
      while (source(finds)) {
        for (DesignRow& row : finds.designs) {
          if (const auto noise = noises.find(row.trial.index); noise != noises.end())
            row.loaded_noise = noise->second;
          table.add({&search.problem(), &row});
        }
        also(finds);
      }
    };
    if (!search.problem().shift_step) {
      each([](const ChunkFinds&) {});
    } else {
      write_file_by(points, [&](const std::filesystem::path& points_part) {
        ParquetTable<ShiftPoint> cloud(points_part, point_columns(), notes);
        each([&](const ChunkFinds& finds) {
          for (const ShiftPoint& p : finds.points) cloud.add(p);
        });
        cloud.close();
      });
    }
    table.close();
  });
}

std::string csv_text(const SearchProblem& problem, const SearchAnswer& answer, std::size_t most) {
  std::string text = "rank";
  const TableColumns<DesignView> columns = design_columns(problem);
  for (const ParquetColumn& c : columns.heads()) text += "," + c.name;
  text += ",front\n";
  std::size_t on_front = 0;
  for (std::size_t i = 0; i < answer.designs.size() && i < most; ++i) {
    text += std::to_string(i + 1);
    columns.row({&problem, &answer.designs[i]},
                [&](std::size_t, const Value& v) { text += "," + csv_cell(v); });
    const bool front = on_front < answer.pareto.size() && answer.pareto[on_front] == i;
    if (front) ++on_front;
    text += front ? ",1\n" : ",0\n";
  }
  return text;
}

}  // namespace

std::vector<std::filesystem::path> write_search_files(const JobSpec& spec, const Search& search,
                                                      const SearchRun& run,
                                                      const std::filesystem::path& folder,
                                                      std::optional<std::size_t> top,
                                                      const FindSource& source) {
  make_folder(folder);
  std::vector<std::filesystem::path> files{folder / kDesignsFile};
  if (search.problem().shift_step) files.push_back(folder / "points.parquet");
  write_tables(files.front(), files.back(), spec, search, run.answer.loaded, source);
  const auto write = [&](const char* name, const std::string& text) {
    files.push_back(folder / name);
    write_file(files.back(), text);
  };
  write("best.csv", csv_text(search.problem(), run.answer, top.value_or(kCsvDesigns)));
  write("search.json", search_json_text(search, run, spec.units()));
  write("report.html", search_page(spec, search, run));
  return files;
}

}  // namespace gearwright
