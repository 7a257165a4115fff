#include "gearwright/job/search_files.hpp"

#include <fmt/format.h>

#include <functional>
#include <variant>

#include "gearwright/base/output_file.hpp"
#include "gearwright/job/parquet.hpp"
#include "gearwright/job/search_answer.hpp"
#include "gearwright/job/version.hpp"
#include "gearwright/report/search_report.hpp"

namespace gearwright {

namespace {

using Value = std::variant<std::monostate, std::int64_t, double, std::string>;

// One column of the tables: its name, its type, its value of a row.
struct Column {
  std::string name;
  ParquetType type;
  std::function<Value(const DesignRow&)> value;
  bool optional = false;
};

double deg(double rad) { return Angle::radians(rad).deg(); }

std::vector<Column> columns() {
  std::vector<Column> c;
  const auto whole = [&](const char* name, std::function<std::int64_t(const DesignRow&)> f) {
    c.push_back({name, ParquetType::int32, [f](const DesignRow& r) { return Value(f(r)); }});
  };
  const auto real = [&](std::string name, std::function<double(const DesignRow&)> f) {
    c.push_back(
        {std::move(name), ParquetType::float64, [f](const DesignRow& r) { return Value(f(r)); }});
  };
  const auto maybe = [&](std::string name,
                         std::function<std::optional<double>(const DesignRow&)> f) {
    c.push_back({std::move(name), ParquetType::float64,
                 [f](const DesignRow& r) {
                   const auto v = f(r);
                   return v ? Value(*v) : Value();
                 },
                 true});
  };
  c.push_back(
      {"trial", ParquetType::int64, [](const DesignRow& r) { return Value(r.trial.index); }});
  whole("rack", [](const DesignRow& r) { return r.trial.rack + 1; });
  real("module_mm", [](const DesignRow& r) { return r.trial.module; });
  whole("z1", [](const DesignRow& r) { return r.trial.z1; });
  whole("z2", [](const DesignRow& r) { return r.trial.z2; });
  for (const int i : {0, 1})
    real(fmt::format("helix{}_deg", i + 1),
         [i](const DesignRow& r) { return deg(r.trial.helix[i]); });
  real("ratio", [](const DesignRow& r) { return r.ratio; });
  real("center_distance_mm", [](const DesignRow& r) { return r.center_distance; });
  for (const int i : {0, 1})
    real(fmt::format("x{}", i + 1), [i](const DesignRow& r) { return r.shift[i]; });
  c.push_back({"point", ParquetType::text, [](const DesignRow& r) {
                 return Value(std::string(r.balanced ? "eq11" : "lo_hi"));
               }});
  real("contact_ratio", [](const DesignRow& r) { return r.contact_ratio; });
  real("contact_ratio_true", [](const DesignRow& r) { return r.contact_ratio_true; });
  real("overlap_ratio", [](const DesignRow& r) { return r.overlap_ratio; });
  real("working_angle_deg", [](const DesignRow& r) { return deg(r.working_angle); });
  real("backlash_normal_mm", [](const DesignRow& r) { return r.backlash_normal; });
  for (const int i : {0, 1}) {
    real(fmt::format("tip_thickness{}_mm", i + 1),
         [i](const DesignRow& r) { return r.tip_thickness[i]; });
  }
  for (const int i : {0, 1}) {
    real(fmt::format("tip_clearance{}_mm", i + 1),
         [i](const DesignRow& r) { return r.tip_clearance[i]; });
  }
  real("tip_shortening_mm", [](const DesignRow& r) { return r.tip_alteration; });
  for (const int gear : {0, 1}) {
    for (const int end : {0, 1}) {
      maybe(fmt::format("sliding{}_{}", gear + 1, end == 0 ? "A" : "E"),
            [gear, end](const DesignRow& r) { return r.sliding[gear][end]; });
    }
  }
  maybe("sliding_max", [](const DesignRow& r) { return r.greatest_sliding(); });
  whole("interference", [](const DesignRow& r) { return r.interference ? 1 : 0; });
  real("area", [](const DesignRow& r) { return r.area; });
  real("shift_sum_min", [](const DesignRow& r) { return r.sums[0]; });
  real("shift_sum_max", [](const DesignRow& r) { return r.sums[1]; });
  for (const int i : {0, 1}) {
    real(fmt::format("lo_x{}", i + 1), [i](const DesignRow& r) { return r.lo[i]; });
    real(fmt::format("hi_x{}", i + 1), [i](const DesignRow& r) { return r.hi[i]; });
  }
  return c;
}

void write_parquet(const std::filesystem::path& path, const JobSpec& spec, const Search& search,
                   const DesignSource& designs) {
  const std::vector<Column> table = columns();
  std::vector<ParquetColumn> heads;
  for (const Column& c : table) heads.push_back({c.name, c.type, c.optional});
  std::string limits;
  for (int i = 0; i < kLimits; ++i)
    limits += fmt::format("{}{}", i == 0 ? "" : ", ", name(static_cast<Limit>(i)));
  write_file_by(path, [&](const std::filesystem::path& part) {
    ParquetWriter writer(part, heads,
                         {{"program", fmt::format("gearwright {}", kVersion)},
                          {"spec", spec.tree},
                          {"limits", limits},
                          {"trials", std::to_string(*search.space().size())}});
    std::vector<DesignRow> rows;
    while (designs(rows)) {
      for (const DesignRow& row : rows) {
        for (std::size_t i = 0; i < table.size(); ++i) {
          const Value v = table[i].value(row);
          if (const auto* n = std::get_if<std::int64_t>(&v)) writer.set(i, *n);
          if (const auto* x = std::get_if<double>(&v)) writer.set(i, *x);
          if (const auto* s = std::get_if<std::string>(&v)) writer.set(i, std::string_view(*s));
        }
        writer.end_row();
      }
    }
    writer.close();
  });
}

std::string csv_text(const SearchAnswer& answer) {
  const std::vector<Column> table = columns();
  std::string text = "rank";
  for (const Column& c : table) text += "," + c.name;
  text += ",front\n";
  std::size_t on_front = 0;
  for (std::size_t i = 0; i < answer.designs.size(); ++i) {
    text += std::to_string(i + 1);
    for (const Column& c : table) {
      const Value v = c.value(answer.designs[i]);
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
                                                      const DesignSource& designs) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw IoError("cannot make the folder " + folder.string() + ": " + error.message());
  const std::vector<std::filesystem::path> files{folder / "search.parquet", folder / "best.csv",
                                                 folder / "search.json", folder / "report.html"};
  write_parquet(files[0], spec, search, designs);
  write_file(files[1], csv_text(run.answer));
  write_file(files[2], search_json_text(search, run));
  const SearchReport report{.title = spec.title,
                            .spec_text = spec.text,
                            .search = search,
                            .answer = run.answer,
                            .reasons = reasons_of(run),
                            .version = kVersion};
  write_file(files[3], search_report(report));
  return files;
}

}  // namespace gearwright
