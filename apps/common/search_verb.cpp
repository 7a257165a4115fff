#include "apps/common/search_verb.hpp"

#include <atomic>
#include <csignal>
#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/common/output.hpp"
#include "apps/common/watch.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/base/system.hpp"
#include "gearwright/job/drive_answer.hpp"
#include "gearwright/job/search_answer.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright::apps {

CLI::App* add_campaign(CLI::App& app, const char* name, const char* what, CampaignCommand& c) {
  CLI::App* sub = app.add_subcommand(name, what);
  sub->add_flag("--json", c.json, "Print one JSON object to stdout and nothing else");
  sub->add_option("SPEC", c.spec, "The spec file in TOML, or in JSON if its name ends in .json")
      ->required();
  return sub;
}

void add_search_options(CLI::App* sub, SearchCommand& c) {
  sub->add_option("--out", c.out,
                  "Folder for search.parquet, best.csv, search.json, report.html, and for the "
                  "chunks of a large search");
  sub->add_option("--top", c.top, "Number of designs to list; search.parquet contains all designs")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000000}));
  sub->add_flag("--resume", c.resume, "Continue the search in --out");
  sub->add_option(
      "--shard", c.shard,
      "Compute only shard i of N (i/N), which is every Nth chunk from chunk i on; all shards use "
      "the same --out");
  sub->add_flag("--yes-large", c.yes_large, "Allow a search of more than 2e10 candidates");
  sub->add_option("--chunk", c.chunk,
                  "Number of candidates in a chunk (the default depends on the size of the search)")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1} << 24));
  sub->add_option("--threads", c.threads, "Number of threads (default: as many as the machine has)")
      ->check(CLI::Range(1, 1024));
}

namespace {

std::atomic<bool> stop_wanted{false};

// The first Ctrl-C ends the search at the next trial. The second Ctrl-C ends the program.
extern "C" void on_interrupt(int signal) {
  stop_wanted = true;
  std::signal(signal, SIG_DFL);
}

std::string clock(double seconds) {
  const auto s = static_cast<long long>(seconds + 0.5);
  return s >= 3600 ? fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60)
                   : fmt::format("{}:{:02}", s / 60, s % 60);
}

std::string progress_text(const SearchProgress& p, double seconds) {
  switch (p.stage) {
    case SearchProgress::Stage::changes:
      return fmt::format(
          "no design is feasible; the search for the smallest change that helps has done {} trials",
          p.done);
    case SearchProgress::Stage::loads:
      return fmt::format("{} of {} designs are computed under load", p.done, p.of);
    case SearchProgress::Stage::regions:
      return fmt::format("the regions of {} of {} designs are computed", p.done, p.of);
    case SearchProgress::Stage::trials: break;
  }
  const double rate = static_cast<double>(p.trials) / seconds;
  const std::string done = fmt::format("{} of {} chunks are done", p.chunks, p.of_chunks);
  if (rate == 0.0) return done;
  return fmt::format("{}, {} candidates per second, about {} left", done, rough_count(rate),
                     clock(static_cast<double>(p.left) / rate));
}

int print_unfinished(const SearchCommand& c, const SearchRun& run) {
  const std::string state = fmt::format("{} of {} chunks are done", run.chunks_done, run.chunks);
  if (c.take && !run.stopped) {
    return fail({"--take", std::to_string(*c.take), "the search is not finished, " + state,
                 FailureKind::option},
                c.json);
  }
  if (c.json) print_json(unfinished_json(run));
  if (run.stopped) {
    std::fprintf(stderr, "gearwright: stopped; %s%s\n", state.c_str(),
                 !c.out ? ", and nothing is saved; with --out DIR a search can be resumed"
                        : "; --resume continues the search");
    return 3;
  }
  if (!c.json)
    print(state + fmt::format(" in {}; the last shard to finish writes the result\n", *c.out));
  return 0;
}

int take_one(const SearchCommand& c, const JobSpec& spec, const Search& search,
             const SearchRun& run) {
  const auto& designs = run.answer.designs;
  const auto at = static_cast<std::size_t>(*c.take - 1);
  if (at >= designs.size())
    return fail(no_such_spec(*c.take, designs.size(),
                             "no design is feasible; run the search without --take to find a "
                             "change that would help"),
                c.json);
  print_spec(spec_in(spec.units(), pair_spec(spec, search, designs[at])), c.json);
  return 0;
}

// A search for drives writes no folder, and its answer is printed in the
// same way as the answers of other verbs.
int search_drives_verb(const SearchCommand& c, const JobSpec& spec, const SpecText& text) {
  if (c.out || c.shard || c.resume || c.chunk)
    return usage(
        "--out, --shard, --resume and --chunk are for searches for pairs only; a search for drives "
        "prints its answer, or the complete answer with --json");
  const std::size_t top = std::max<std::size_t>(c.top.value_or(kDefaultDrives),
                                                static_cast<std::size_t>(c.take.value_or(1)));
  const auto answer = watched("search", [&](Progress* progress) {
    return answer_drive_search(spec, top, c.threads, progress);
  });
  if (!answer) return fail(spelled(answer.error(), spec.given), c.json, &text);
  const auto error = print_answer(in_units_of(spec, *answer), c.json, false, c.take);
  return error ? fail(*error, c.json) : 0;
}

}  // namespace

int run_search_verb(const SearchCommand& c, const Together* together) {
  const bool prints = !together || together->rank == 0;
  SearchOptions options;
  const auto wrong = [&](const std::string& message) { return prints ? usage(message) : 2; };
  if (const auto error = fill_campaign(c, together, "search", "search", options))
    return wrong(*error);
  const auto text = read_spec_text(c.spec);
  if (!text) return prints ? fail(text.error(), c.json) : 1;
  const auto spec = read_spec(*text);
  if (!spec) return prints ? fail(spec.error(), c.json, &*text) : 1;
  if (searches_drives(*spec)) {
    if (together) return wrong("a search for drives runs in one process, without mpirun");
    return search_drives_verb(c, *spec, *text);
  }
  if (!spec->search) return prints ? fail(no_search(), c.json, &*text) : 1;
  const Search search(*spec->search);
  options.yes_large = c.yes_large;
  options.top = c.top;
  if (c.take)
    options.top = std::max<std::size_t>(c.top.value_or(0), static_cast<std::size_t>(*c.take));
  // Regions of profile shifts are computed only for output that contains them. The spec of one
  // design contains no region. A table contains the regions of its rows.
  if (!c.out && c.take) options.regions = 0;
  if (!c.out && !c.take && !c.json) options.regions = kListedDesigns;
  options.chunk = c.chunk;
  options.threads = threads_of(c, together);
  options.stop = &stop_wanted;
  StatusLine line;
  if (prints)
    options.progress = [&](const SearchProgress& p) {
      line.show([&](double seconds) { return progress_text(p, seconds); });
    };
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
  const auto run = run_search(*spec, search, options);
  line.clear();
  if (!run) return prints ? fail(spelled(run.error(), spec->given), c.json, &*text) : 1;
  for (const std::string& note : run->notes) std::fprintf(stderr, "gearwright: %s\n", note.c_str());
  if (!run->finished) return prints ? print_unfinished(c, *run) : run->stopped ? 3 : 0;
  if (c.take) return take_one(c, *spec, search, *run);
  if (c.json) {
    print(search_json_text(search, *run, spec->units()));
  } else {
    print(search_listing(search, *run, spec->units()) + written_files(run->files));
  }
  return 0;
}

namespace {

// Describes one of several processes that share a folder. Shards are counted from 1.
struct Shard {
  int which = 1, of = 1;
};

// Reads a shard such as "3/8". Returns nothing if the text is not a shard.
std::optional<Shard> parse_shard(const std::string& text) {
  const auto parts = split(text, '/');
  if (parts.size() != 2) return std::nullopt;
  const auto which = whole_number(parts[0]), of = whole_number(parts[1]);
  if (!which || !of || *which < 1 || *which > *of || *of > 1'000'000) return std::nullopt;
  return Shard{static_cast<int>(*which), static_cast<int>(*of)};
}

}  // namespace

std::optional<std::string> fill_campaign(const CampaignCommand& c, const Together* together,
                                         const std::string& verb, const std::string& noun,
                                         CampaignOptions& options) {
  if (c.out && c.out->empty()) return "--out needs the name of a folder";
  if (!c.out && (c.resume || c.shard))
    return std::string(c.resume ? "--resume" : "--shard") + " needs --out DIR, the folder of the " +
           noun;
  if (c.shard) {
    const auto shard = parse_shard(*c.shard);
    if (together) return "--shard cannot be used under mpirun, whose ranks share one queue";
    if (!shard) return "--shard takes i/N with 1 <= i <= N, for example --shard 3/8";
    options.shard = shard->which;
    options.shards = shard->of;
    options.many = true;
  }
  if (together && !c.out)
    return "a " + noun + " on several ranks needs --out DIR, the folder that the ranks share";
  if (together && c.spec == "-")
    return "under mpirun, only one rank receives the standard input; give the spec as a file";
  options.out = c.out.value_or("");
  options.resume = c.resume;
  options.writer = c.shard ? "shard " + *c.shard : verb;
  if (!together) return std::nullopt;
  options.writer = "rank " + std::to_string(together->rank);
  options.many = together->rank > 0;
  options.together = true;
  options.next_chunk = together->next_chunk;
  options.folder_is_open = together->folder_is_open;
  options.finish_together = together->finish_together;
  return std::nullopt;
}

int threads_of(const CampaignCommand& c, const Together* together) {
  return together && c.threads == 0 ? 1 : c.threads;
}

std::string written_files(const std::vector<std::filesystem::path>& files) {
  std::string text;
  for (const auto& file : files) text += "  " + native_text(file) + "\n";
  return text.empty() ? text : "\nfiles\n" + text;
}

}  // namespace gearwright::apps
