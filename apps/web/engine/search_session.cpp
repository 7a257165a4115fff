#include "apps/web/engine/search_session.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "apps/web/engine/answering.hpp"
#include "apps/web/engine/stopwatch.hpp"
#include "gearwright/job/loaded_designs.hpp"
#include "gearwright/job/search_answer.hpp"
#include "gearwright/job/search_job.hpp"
#include "gearwright/job/search_workers.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright::web {

namespace {

// Number of trials in the first part. Later parts have as many trials as can be computed in
// kPartMs.
constexpr std::int64_t kFirstPart = 1 << 12;
constexpr std::int64_t kLeastPart = 1 << 8, kMostPart = 1 << 20;
constexpr double kPartMs = 8.0;

// For the progress, a design under load counts as this number of trials.
constexpr std::int64_t kTrialsPerLoad = 100'000;

}  // namespace

SearchSession::SearchSession(SpecText text, JobSpec spec, std::size_t most)
    : text_(std::move(text)),
      spec_(std::move(spec)),
      search_(*spec_.search),
      trials_(search_.space().size().value_or(0)),
      size_(kFirstPart),
      top_(most),
      best_(search_.problem(), designs_to_keep(search_.problem(), most)) {}

Result<std::shared_ptr<SearchSession>> SearchSession::open(std::string given, int most) {
  SpecText text = spec_text(std::move(given));
  auto spec = read(text);
  if (!spec) return spec.error();
  if (auto error = only_in_mm(*spec, kInPage)) return *error;
  if (!spec->search) return no_search();
  const std::size_t designs = most > 0 ? static_cast<std::size_t>(most) : kDefaultDesigns;
  std::shared_ptr<SearchSession> session(
      new SearchSession(std::move(text), std::move(spec).take(), designs));
  if (auto error = refuse_large(session->search_, {})) return spelled(*error, session->spec_.given);
  if (session->trials_ == 0) return no_tooth_numbers();
  session->run_ = begun(session->spec_, session->search_);
  return session;
}

void SearchSession::search_some() {
  const std::int64_t to = std::min(trials_, from_ + size_);
  std::vector<DesignRow> rows;
  const Stopwatch watch;
  counts_ += search_.range(from_, to, rows, {.detail = detail_of(search_.problem(), false)});
  for (const DesignRow& row : rows) best_.add(row);
  const double ms = std::max(0.01, watch.ms());
  size_ = std::clamp(static_cast<std::int64_t>(static_cast<double>(to - from_) * kPartMs / ms),
                     kLeastPart, kMostPart);
  from_ = to;
  if (from_ < trials_) return;
  run_.answer = std::move(best_).answer(counts_);
  stage_ = Stage::loads;
}

void SearchSession::close_some() {
  auto& designs = run_.answer.designs;
  if (stage_ == Stage::loads) {
    if (loaded_.size() < designs_to_load(search_.problem(), run_.answer)) {
      loaded_.push_back(loaded_design(spec_, search_, designs[loaded_.size()]));
      return;
    }
    rank_loaded(search_.problem(), loaded_, top_, run_.answer);
    stage_ = Stage::regions;
    return;
  }
  if (stage_ == Stage::regions && region_ < designs.size()) {
    if (!designs[region_].whole) designs[region_] = search_.whole(designs[region_]);
    ++region_;
    return;
  }
  if (stage_ == Stage::regions) {
    stage_ = Stage::changes;
    return;
  }
  look_for_changes(search_, {}, run_);
  run_.finished = true;
  stage_ = Stage::done;
}

Steps SearchSession::step(double milliseconds) {
  const Stopwatch watch;
  while (stage_ != Stage::done && watch.ms() < milliseconds) {
    if (stage_ == Stage::trials) {
      search_some();
    } else {
      close_some();
    }
  }
  const auto regions = static_cast<std::int64_t>(run_.answer.designs.size());
  const auto loaded = static_cast<std::int64_t>(loaded_.size()) * kTrialsPerLoad;
  const auto loads =
      std::max(loaded, static_cast<std::int64_t>(designs_to_load(search_.problem(), run_.answer)) *
                           kTrialsPerLoad);
  return {from_ + loaded + static_cast<std::int64_t>(region_), trials_ + loads + regions,
          finished()};
}

Json SearchSession::result() const {
  return {{"json", finished() ? search_json_text(search_, run_) : std::string()},
          {"tested", counts_.tested},
          {"feasible", counts_.feasible}};
}

std::string SearchSession::best(int most) const {
  Json rows = Json::array();
  // While the search is running, the best designs are in a heap, so a copy of the heap is sorted.
  const SearchAnswer so_far =
      stage_ == Stage::trials ? BestDesigns(best_).answer(counts_) : SearchAnswer{};
  const auto& designs = stage_ == Stage::trials ? so_far.designs : run_.answer.designs;
  for (const DesignRow& row : designs) {
    if (static_cast<int>(rows.size()) >= most) break;
    rows.push_back(design_row_json(search_, row, false));
  }
  return json_text(rows);
}

Result<std::string> SearchSession::take(int design) const {
  if (!finished()) return Error{"search", "", "is not finished"};
  const auto count = static_cast<int>(run_.answer.designs.size());
  if (design < 1 || design > count)
    return refused("design", design, "there are " + std::to_string(count) + " designs");
  return toml_text(
      pair_spec(spec_, search_, run_.answer.designs[static_cast<std::size_t>(design - 1)]));
}

Result<std::string> SearchSession::report() const {
  if (!finished()) return Error{"search", "", "is not finished"};
  return search_page(spec_, search_, run_);
}

}  // namespace gearwright::web
