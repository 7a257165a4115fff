// Defines the design search and the type Search of its result.
#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <array>
#include <mutex>
#include <tuple>

#include "apps/python/arrays.hpp"
#include "apps/python/model.hpp"
#include "apps/python/watched.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/base/version.hpp"
#include "gearwright/catalogue/scatter_keys.hpp"
#include "gearwright/catalogue/search_quantities.hpp"
#include "gearwright/job/scatter_study.hpp"
#include "gearwright/job/search_answer.hpp"
#include "gearwright/job/search_files.hpp"
#include "gearwright/job/search_job.hpp"
#include "gearwright/job/search_tables.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright::python {

namespace {

namespace fs = std::filesystem;

// A finished search. Its designs are sorted, best first.
struct Found {
  explicit Found(SpecText given) : text(std::move(given)), spec(value_or_raise(read_spec(text))) {
    if (!spec.search) raise(no_search());
    search = std::make_shared<const Search>(*spec.search);
  }

  SpecText text;
  JobSpec spec;
  std::shared_ptr<const Search> search;
  SearchRun run;

  const DesignRow& row(py::ssize_t i) const {
    const auto n = static_cast<py::ssize_t>(run.answer.designs.size());
    if (i < 0) i += n;
    if (i < 0 || i >= n) throw py::index_error(fmt::format("there are {} designs", n));
    return run.answer.designs[static_cast<std::size_t>(i)];
  }
};
using FoundPtr = std::shared_ptr<const Found>;

// The names of SearchProgress::Stage, in the order of the enumerators.
constexpr std::array kStages{"candidates", "changes that would help", "designs under load",
                             "regions"};

FoundPtr search(const py::object& given, const std::optional<long long>& top, int threads,
                const py::object& progress, const py::object& out, bool resume, bool yes_large) {
  threads_in_range(threads);
  if (top && *top < 1) raise({"top", std::to_string(*top), "must be at least 1"});
  auto found = std::make_shared<Found>(
      is_path(given)
          ? value_or_raise(read_spec_text(path_of(given, "spec")))
          : SpecText{"", json_text(spec_with_keys(tree_of(given, ""))), SpecFormat::json});
  Watched watched;
  SearchOptions options;
  options.out = path_or_none(out, "out").value_or("");
  options.resume = resume;
  options.yes_large = yes_large;
  if (top) options.top = static_cast<std::size_t>(*top);
  options.threads = threads;
  options.stop = &watched.stop;
  std::mutex mutex;
  SearchProgress latest;
  options.progress = [&](const SearchProgress& now) {
    const std::lock_guard lock(mutex);
    latest = now;
  };
  const auto total = found->search->space().size();
  const auto tell = [&] {
    if (progress.is_none()) return;
    const SearchProgress now = [&] {
      const std::lock_guard lock(mutex);
      return latest;
    }();
    const bool trials = now.stage == SearchProgress::Stage::trials;
    progress(kStages[static_cast<std::size_t>(now.stage)], trials ? now.trials : now.done,
             trials ? total.value_or(0) : now.of);
  };
  std::optional<Result<SearchRun>> run;
  watch(
      watched, [&] { run = run_search(found->spec, *found->search, options); }, tell);
  if (!*run) raise(spelled(run->error(), found->spec.given));
  found->run = std::move(*run).take();
  return found;
}

py::object design(const Found& found, py::ssize_t i) {
  const DesignView view{&found.search->problem(), &found.row(i)};
  return by_name(design_quantities().table(), Value(design_quantities().of(view)));
}

// Returns a structured array with the columns of search.parquet and best.csv.
py::array to_numpy(const Found& found) {
  const auto columns = design_columns(found.search->problem());
  const auto& heads = columns.heads();
  const auto& rows = found.run.answer.designs;
  const auto each_cell = [&](const auto& cell) {
    for (std::size_t r = 0; r < rows.size(); ++r)
      columns.row({&found.search->problem(), &rows[r]},
                  [&](std::size_t c, const Value& v) { cell(r, c, v); });
  };
  std::vector<std::size_t> longest(heads.size(), 1);
  each_cell([&](std::size_t, std::size_t c, const Value& v) {
    if (const auto* s = std::get_if<std::string>(&v.variant()))
      longest[c] = std::max(longest[c], s->size());
  });
  StructuredArray array;
  for (std::size_t c = 0; c < heads.size(); ++c) {
    const bool text = heads[c].type == ParquetType::text;
    const bool number = heads[c].type == ParquetType::float64 || heads[c].optional;
    array.add(heads[c].name, text ? fmt::format("U{}", longest[c]) : number ? "f8" : "i8");
  }
  array.allocate(rows.size());
  each_cell([&](std::size_t r, std::size_t c, const Value& v) { array.set(r, c, {&v}); });
  return array.take();
}

void to_parquet(const Found& found, const py::object& given_path) {
  const fs::path path = path_of(given_path, "path");
  const py::gil_scoped_release free;
  write_file_by(path, [&](const fs::path& part) {
    ParquetTable<DesignView> table(part, design_columns(found.search->problem()),
                                   {{"program", fmt::format("gearwright {}", kVersion)},
                                    {"spec", json_text(found.spec.tree->tables)}});
    for (const DesignRow& row : found.run.answer.designs)
      table.add({&found.search->problem(), &row});
    table.close();
  });
}

PairValue pair_of(const Found& found, py::ssize_t i) {
  return {make_model(pair_spec(found.spec, *found.search, found.row(i)), {}, Scope::pair)};
}

py::dict counts_of(const Found& found) {
  const SearchCounts& counts = found.run.answer.counts;
  py::dict rejected;
  for (const Limit limit : found.search->problem().rejecting_limits())
    rejected[py::str(std::string(name(limit)))] = counts.rejected[static_cast<std::size_t>(limit)];
  py::dict all;
  all["tested"] = counts.tested;
  all["feasible"] = counts.feasible;
  all["rejected"] = rejected;
  return all;
}

// Ranks the designs by their scatter. The result has the form of `scatter_designs` in the program's
// JSON.
py::object ranked_by_scatter(const Found& found, const std::optional<long long>& top, int threads,
                             const py::kwargs& kwargs) {
  threads_in_range(threads);
  if (top && *top < 1) raise({"top", std::to_string(*top), "must be at least 1"});
  const UnitSystem units = found.spec.units();
  Json tree = value_or_raise(parse_spec(found.text.text, found.text.format));
  const Json changes = with_keys(tree_of(kwargs, "scatter"), {&scatter_keys()}, units, "scatter");
  set_keys(tree, "scatter", changes);
  const JobSpec spec = value_or_raise(read_spec_tree(tree, found.text.folder));
  StudyOptions options;
  options.threads = threads;
  if (top) options.top = static_cast<std::size_t>(*top);
  for (const DesignRow& row : found.run.answer.designs)
    options.list.push_back({static_cast<std::int64_t>(options.list.size()) + 1, row.trial.index});
  if (options.list.empty()) raise({"search", "", "no design is feasible"});
  const StudyRun run = watched_result(spec.given, [&](Progress* progress) {
    options.progress = progress;
    return run_study(spec, options);
  });
  return to_python(in_units(units, study_json(spec, run)));
}

// A pickle contains the finished search in packed form, because a search may take hours.
template <class Run>
auto plain_members(Run& run) {
  auto& answer = run.answer;
  auto& counts = answer.counts;
  return std::tie(counts.tested, counts.feasible, counts.rejected, counts.findings,
                  counts.points_tested, counts.points_feasible, answer.pareto, answer.cut,
                  run.changes_left_out, run.notes, run.safest_finding);
}
using PlainMembers =
    std::tuple<std::int64_t, std::int64_t, std::array<std::int64_t, kLimits>,
               std::array<std::int64_t, kWarningCodes>, std::int64_t, std::int64_t,
               std::vector<std::size_t>, bool, std::string, std::vector<std::string>, std::string>;
using Change = std::tuple<std::string, std::string, std::string, double>;

py::tuple kept_search(const Found& found) {
  const SearchRun& run = found.run;
  const auto packed = [](const std::vector<DesignRow>& rows) {
    return py::bytes(pack({rows, {}}));
  };
  std::vector<Change> changes;
  for (const NearestChange& c : run.changes) changes.emplace_back(c.field, c.from, c.to, c.effort);
  const bool toml = found.text.format == SpecFormat::toml;
  return py::make_tuple(found.text.text, toml, found.text.folder, plain_members(run),
                        packed(run.answer.designs), run.safest ? packed({*run.safest}) : packed({}),
                        changes);
}

std::shared_ptr<Found> recalled_search(const py::tuple& state) {
  const auto format = state[1].cast<bool>() ? SpecFormat::toml : SpecFormat::json;
  auto found = std::make_shared<Found>(
      SpecText{"", state[0].cast<std::string>(), format, state[2].cast<fs::path>()});
  SearchRun& run = found->run = begun(found->spec, *found->search);
  run.finished = true;
  plain_members(run) = state[3].cast<PlainMembers>();
  const auto designs = [&](int i) {
    return unpack(state[i].cast<std::string>(), "a pickled search").designs;
  };
  run.answer.designs = designs(4);
  for (const DesignRow& safest : designs(5)) run.safest = safest;
  for (const auto& [field, from, to, effort] : state[6].cast<std::vector<Change>>())
    run.changes.push_back({field, from, to, effort});
  return found;
}

}  // namespace

void bind_search(py::module_& m) {
  py::class_<Found, std::shared_ptr<Found>> type(
      m, "Search", "A finished design search with its designs, the best first");
  bind_copies(type, &kept_search, &recalled_search);
  type.def("__len__", [](const Found& f) { return f.run.answer.designs.size(); })
      .def("__getitem__", &design, "The design of this rank as a Record")
      .def("pair", &pair_of, py::arg("place") = 0, "The Pair of a design")
      .def("scatter", &ranked_by_scatter, py::arg("top") = py::none(), py::arg("threads") = 0,
           "Ranks the designs by the greatest percentile of their transmission error, with the "
           "keys of [scatter] (errors=, quality=, samples=); absent keys are taken from the spec. "
           "Returns a dict like `scatter_designs` in the program's JSON. pair(row[\"design\"] - 1) "
           "is the Pair of a row. If top is given, only this number of the best designs is ranked")
      .def("to_numpy", &to_numpy,
           "A structured array with the columns of search.parquet and a row for each design")
      .def("to_parquet", &to_parquet, py::arg("path"),
           "Writes the designs to a Parquet file, with the same columns")
      .def_property_readonly("counts", &counts_of,
                             "The number of candidates that were tested, the number that are "
                             "feasible, and the number that each limit ruled out")
      .def_property_readonly(
          "front", [](const Found& f) { return py::tuple(py::cast(f.run.answer.pareto)); },
          "Ranks of the Pareto-optimal designs")
      .def_property_readonly(
          "changes",
          [](const Found& f) { return py::tuple(py::cast(change_lines(f.run, f.spec.units()))); },
          "Changes of a single number that would make designs feasible; empty if a design is "
          "feasible")
      .def(
          "as_dict",
          [](const Found& f) { return to_python(search_json(*f.search, f.run, f.spec.units())); },
          "The output of the program with --json")
      .def(
          "report", [](const Found& f) { return search_page(f.spec, *f.search, f.run); },
          "The report of the search as HTML")
      .def("__repr__", [](const Found& f) {
        return fmt::format("Search({} designs of {} candidates)", f.run.answer.designs.size(),
                           f.run.answer.counts.tested);
      });
  m.def("_search", &search, py::arg("spec"), py::arg("top"), py::arg("threads"),
        py::arg("progress"), py::arg("out"), py::arg("resume"), py::arg("yes_large"));
}

}  // namespace gearwright::python
