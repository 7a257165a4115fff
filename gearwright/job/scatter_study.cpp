#include "gearwright/job/scatter_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <tuple>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/output_file.hpp"
#include "gearwright/base/system.hpp"
#include "gearwright/catalogue/scattered_design_quantities.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/scatter_answer.hpp"
#include "gearwright/job/search_answer.hpp"
#include "gearwright/job/solved_job.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

namespace fs = std::filesystem;

namespace {

Error refused_list(const fs::path& path, std::string rule) {
  return {"--designs", native_text(path), std::move(rule), FailureKind::option};
}

// Keys of [scatter] that have no effect on a study. Their results are computed only for a single
// pair, and the rows of a study do not contain them.
constexpr const char* kOfOnePair[] = {"indices", "worst_case", "loosening", "robust", "pattern"};

// Returns the spec of a design as `search --take` prints it, without the keys in kOfOnePair.
Json spec_of(const JobSpec& spec, const Search& search, const DesignRow& row) {
  Json tree = pair_spec(spec, search, row);
  if (tree.contains("scatter"))
    for (const char* key : kOfOnePair) tree["scatter"].erase(key);
  return tree;
}

std::string teeth_words(const std::array<int, 2>& teeth) {
  return fmt::format("{}:{} teeth", teeth[0], teeth[1]);
}

struct StudiedDesign {
  DesignRow row;
  JobSpec pair;
};

Result<StudiedDesign> studied_design(const JobSpec& spec, const Search& search,
                                     const ListedDesign& listed, const StudyOptions& options) {
  std::vector<DesignRow> rows;
  const std::int64_t trials = *search.space().size();
  if (listed.trial >= 0 && listed.trial < trials)
    search.range(listed.trial, listed.trial + 1, rows, {.detail = RegionDetail::point});
  const bool same =
      rows.size() == 1 &&
      (!listed.teeth || *listed.teeth == std::array{rows[0].trial.z1, rows[0].trial.z2});
  if (!same)
    return Error{
        "--designs", options.designs.value_or(""),
        fmt::format("is the result of another search; design {} with {} is not a design of "
                    "this spec. Use the spec of that search and add [scatter] to it",
                    listed.number, teeth_words(listed.teeth.value_or(std::array{0, 0}))),
        FailureKind::option};
  auto pair = read_spec_tree(spec_of(spec, search, rows[0]), spec.folder, SpecUse::scatter);
  if (!pair) return pair.error();
  return StudiedDesign{rows[0], std::move(pair).take()};
}

// Returns an error of [scatter] or [load] that concerns every design, or the error of a design that
// belongs to another search. If there is such an error, the study is not started. The function
// examines the designs in order and stops at the first one that can be solved and has usable flanks
// for its accuracy grade.
std::optional<Error> refused_study(const JobSpec& spec, const Search& search,
                                   const std::vector<ListedDesign>& list,
                                   const StudyOptions& options) {
  for (const ListedDesign& listed : list) {
    const auto design = studied_design(spec, search, listed, options);
    if (!design) return design.error();
    auto solved = solve(design->pair, Scope::pair);
    if (!solved) continue;  // the failure concerns only this design
    const auto varied = varied_inputs(*solved);
    if (!varied && varied.error().kind == FailureKind::no_flank) continue;
    const auto error = !varied                       ? std::optional(varied.error())
                       : design->pair.scatter.loaded ? other_driver(design->pair)
                                                     : std::nullopt;
    return error ? std::optional(spelled(*error, design->pair.given)) : std::nullopt;
  }
  return std::nullopt;
}

// Returns the designs of the result of a search. `given` is the folder of the search, its
// search.json, or the output of --json.
//
// Throws    IoError
// Errors    "--designs" for a file that is not the result of a search, and for a search that is not
//           finished
Result<std::vector<ListedDesign>> listed_designs(const fs::path& given) {
  std::error_code error;
  const bool folder = fs::is_directory(given, error);
  const fs::path path = folder ? given / "search.json" : given;
  if (folder && !fs::exists(path, error))
    return refused_list(
        given, "the folder has no search.json; name the --out folder of a finished search");
  if (path.extension() == ".parquet" || path.extension() == ".csv")
    return refused_list(
        given,
        "name the folder of the search or its search.json instead, because the designs are then "
        "numbered as for the command `gearwright search SPEC --take N`");
  const std::string text = text_of_file(path);
  const auto other = [&] {
    return refused_list(given,
                        "is not the result of a search; name the folder of `gearwright search SPEC "
                        "--out DIR` or a file with the output of `gearwright search SPEC --json`");
  };
  constexpr int kDeepest = 32;
  if (json_depth(text) > kDeepest) return other();
  Json json;
  try {
    json = parse_json(text);
  } catch (const Json::exception&) {  // a syntax error or a number that is too large
    return other();
  }
  if (!json.is_object() || !json.contains("search") || !json["search"].is_object()) return other();
  const Json& search = json["search"];
  if (search.value("finished", Json(true)) == Json(false))
    return refused_list(given, "the search is not finished; continue it with --resume");
  if (!search.contains("designs") || !search["designs"].is_array()) return other();
  std::vector<ListedDesign> list;
  for (const Json& d : search["designs"]) {
    const auto number = static_cast<std::int64_t>(list.size()) + 1;
    const bool whole = d.is_object() && d.contains("trial") && d["trial"].is_number_integer() &&
                       d.contains("teeth") && d["teeth"].is_array() && d["teeth"].size() == 2 &&
                       d["teeth"][0].is_number_integer() && d["teeth"][1].is_number_integer();
    if (!whole)
      return refused_list(given, fmt::format("design {} has no `trial` and `teeth`; repeat the "
                                             "search with this version",
                                             number));
    list.push_back({number, d["trial"].get<std::int64_t>(),
                    std::array{d["teeth"][0].get<int>(), d["teeth"][1].get<int>()}});
  }
  return list;
}

}  // namespace

std::string text_of_file(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  if (!file) throw IoError("cannot read " + native_text(path));
  return bytes.str();
}

std::size_t ranking_percentile(const JobSpec& spec) {
  const std::vector<double>& all = spec.scatter.percentiles;
  return static_cast<std::size_t>(std::max_element(all.begin(), all.end()) - all.begin());
}

bool loses_contact(const JobSpec& spec, const Json& row) {
  const double left_out = 100.0 - spec.scatter.percentiles[ranking_percentile(spec)];
  return 100.0 * row["probability"]["contact_lost"]["value"].get<double>() > left_out;
}

Result<Json> study_row(const JobSpec& spec, const Search& search, const ListedDesign& listed,
                       const StudyOptions& options) {
  const auto design = studied_design(spec, search, listed, options);
  if (!design) return design.error();
  const JobSpec& pair = design->pair;
  const DesignView view{&search.problem(), &design->row};
  const auto refuse = [&](const Error& error) -> Result<Json> {
    return to_json(scattered_design_quantities().of(
        {listed.number, view, nullptr, spelled(error, pair.given).message()}));
  };
  auto solved = solve(pair, Scope::pair);
  if (!solved) return refuse(solved.error());
  SolvedJob job = std::move(solved).take();
  const auto answer = answer_scatter(job, options.progress, options.threads);
  if (!answer) return refuse(answer.error());
  const ScatterView scatter = scatter_view(job, *answer);
  if (!scatter.spread[static_cast<std::size_t>(ScatterQuantity::peak_to_peak)])
    return refuse(
        {"", "", "contact is lost at some position in every sample", FailureKind::nothing_touches});
  return to_json(scattered_design_quantities().of({listed.number, view, &scatter}));
}

void rank_rows(const JobSpec& spec, std::vector<Json> rows, StudyRun& run) {
  const std::size_t at = ranking_percentile(spec);
  using Key = std::tuple<bool, double, std::int64_t>;
  std::vector<std::pair<Key, Json>> ranked;
  for (Json& row : rows) {
    if (row.contains("reason")) {
      run.refused.push_back(std::move(row));
      continue;
    }
    const Key key{loses_contact(spec, row),
                  row["peak_to_peak_arcsec"]["percentiles"][at].get<double>(),
                  row["design"].get<std::int64_t>()};
    ranked.emplace_back(key, std::move(row));
  }
  std::sort(ranked.begin(), ranked.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto& [key, row] : ranked) run.designs.push_back(std::move(row));
}

Result<StudyRun> run_study(const JobSpec& spec, const StudyOptions& options) {
  GW_EXPECTS(spec.search);
  const Search search(*spec.search);
  std::vector<ListedDesign> list = options.list;
  if (options.designs) {
    auto listed = listed_designs(*options.designs);
    if (!listed) return listed.error();
    list = std::move(listed).take();
  } else if (list.empty()) {
    SearchOptions quick;
    quick.top = options.top;
    quick.regions = 0;
    quick.threads = options.threads;
    const auto found = run_search(spec, search, quick);
    if (!found) return found.error();
    for (const DesignRow& row : found->answer.designs)
      list.push_back({static_cast<std::int64_t>(list.size()) + 1, row.trial.index});
  }
  if (list.empty())
    return Error{
        "search", "",
        "no design is feasible; the command `gearwright search` names a change that would help"};
  if (options.top && list.size() > *options.top) list.resize(*options.top);
  if (auto error = refused_study(spec, search, list, options)) return *error;
  StudyRun run;
  std::vector<Json> rows;
  if (!options.out.empty()) {
    auto shared = run_study_campaign(spec, search, list, options, rows);
    if (!shared) return shared.error();
    run = std::move(shared).take();
    if (!run.finished) return run;
  } else {
    run.of = static_cast<std::int64_t>(list.size());
    for (const ListedDesign& listed : list) {
      if (options.on_design) options.on_design(run.done, run.of);
      auto row = study_row(spec, search, listed, options);
      if (!row) return row.error();
      rows.push_back(std::move(row).take());
      ++run.done;
    }
    run.finished = true;
  }
  rank_rows(spec, std::move(rows), run);
  if (options.out.empty()) return run;
  const auto write = [&](const char* name, const std::string& text) {
    run.files.push_back(options.out / name);
    write_file(run.files.back(), text);
  };
  write("scatter.json", study_json_text(spec, run));
  write("scatter.csv", study_csv(spec, run));
  write("scatter.html", study_page(spec, run));
  return run;
}

}  // namespace gearwright
