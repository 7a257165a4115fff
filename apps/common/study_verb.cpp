#include "apps/common/search_verb.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "apps/common/output.hpp"
#include "apps/common/watch.hpp"
#include "gearwright/job/scatter_study.hpp"

namespace gearwright::apps {

void add_study_options(CLI::App* sub, StudyCommand& c) {
  sub->add_option("--designs", c.designs,
                  "The search whose designs are ranked, given as its --out folder, its search.json "
                  "or the output of search --json (default: run the search of the spec)");
  sub->add_option("--top", c.top,
                  "Study only this number of the best designs of a search (default: all)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000000}));
  sub->add_option(
      "--out", c.out,
      "Folder for the study of a search: scatter.json, scatter.csv, scatter.html and the "
      "finished designs");
  sub->add_flag("--resume", c.resume, "Continue the study of a search in the folder --out");
  sub->add_option("--shard", c.shard,
                  "Study only shard i of N (i/N), which is every Nth design from design i on; all "
                  "shards use the same --out");
  sub->add_option("--threads", c.threads, "Threads (default: as many as the machine has)")
      ->check(CLI::Range(1, 1024));
}

namespace {

int print_unfinished(const StudyCommand& c, const StudyRun& run) {
  if (c.json) {
    print_json(unfinished_study(run));
  } else {
    print(
        fmt::format("{} of {} designs are finished and saved in the folder {}; the last shard to "
                    "finish writes the result\n",
                    run.done, run.of, *c.out));
  }
  return 0;
}

int print_study(const StudyCommand& c, const JobSpec& spec, const StudyRun& run) {
  if (c.json) {
    print(study_json_text(spec, run));
  } else if (c.csv) {
    print(study_csv(spec, run));
  } else {
    print(study_listing(spec, run, c.top.value_or(kListedStudy)) + written_files(run.files));
  }
  return 0;
}

}  // namespace

int run_study_verb(const StudyCommand& c, const SpecText& text, const Together* together) {
  const bool prints = !together || together->rank == 0;
  const auto wrong = [&](const std::string& message) { return prints ? usage(message) : 2; };
  const auto failed = [&](const Error& error) { return prints ? fail(error, c.json, &text) : 1; };
  StudyOptions options;
  if (const auto error = fill_campaign(c, together, "scatter", "study", options))
    return wrong(*error);
  const auto spec = read_spec(text);
  if (!spec) return failed(spec.error());
  if (!spec->search)
    return failed({c.designs ? "search" : "", "",
                   c.designs ? "is missing; --designs needs the spec of the search that found the "
                               "designs, with [scatter] added"
                             : "--out, --top, --shard and --resume are for the designs of a "
                               "search; for one pair, the command `gearwright run` writes files"});
  if (const auto error = only_in_mm(*spec, "the study of the designs of a search"))
    return failed(*error);
  options.designs = c.designs;
  options.top = c.top;
  options.threads = threads_of(c, together);
  std::atomic<std::int64_t> done{0}, of{0};
  options.on_design = [&](std::int64_t now, std::int64_t all) {
    done = now;
    of = all;
  };
  const WatchWords words{
      [&] { return of == 0 ? "" : fmt::format("{} of {} designs, ", done.load(), of.load()); },
      [&] {
        return !c.out ? "nothing was written; with --out DIR a study can be resumed"
                      : fmt::format("{} of {} designs are done, --resume continues", done.load(),
                                    of.load());
      }};
  const auto work = [&](Progress* progress) {
    options.progress = progress;
    return run_study(*spec, options);
  };
  const auto run = prints ? watched("scatter", work, words) : work(nullptr);
  if (!run) return failed(spelled(run.error(), spec->given));
  for (const std::string& note : run->notes) std::fprintf(stderr, "gearwright: %s\n", note.c_str());
  if (!run->finished) return prints ? print_unfinished(c, *run) : 0;
  return print_study(c, *spec, *run);
}

int run_study_verb(const StudyCommand& c, const Together* together) {
  const auto text = read_spec_text(c.spec);
  if (!text) return !together || together->rank == 0 ? fail(text.error(), c.json) : 1;
  return run_study_verb(c, *text, together);
}

}  // namespace gearwright::apps
