// Runs a search in steps, so that a worker can handle messages between them.
//
// Each step computes a part of the trials. The final designs, their order and the text are the same
// as in the result of the program.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "apps/web/engine/work.hpp"
#include "gearwright/job/search_job.hpp"

namespace gearwright::web {

class SearchSession {
 public:
  /// Errors    the errors of read_spec and run_search; a spec in inch or without [search]
  static Result<std::shared_ptr<SearchSession>> open(std::string text, int most);

  std::int64_t trials() const { return trials_; }
  Steps step(double milliseconds);
  bool finished() const { return stage_ == Stage::done; }
  /// Returns the counts and the text of the answer. The text is empty until the search is finished.
  Json result() const;
  std::string best(int most) const;
  Result<std::string> take(int design) const;
  Result<std::string> report() const;

 private:
  SearchSession(SpecText text, JobSpec spec, std::size_t most);
  void search_some();
  void close_some();

  enum class Stage { trials, loads, regions, changes, done };
  SpecText text_;
  JobSpec spec_;
  Search search_;
  std::int64_t trials_, from_ = 0, size_;
  std::size_t top_;  // greatest number of designs of the answer
  std::size_t region_ = 0;
  Stage stage_ = Stage::trials;
  SearchCounts counts_;
  BestDesigns best_;
  std::vector<LoadedDesign> loaded_;
  SearchRun run_;
};

}  // namespace gearwright::web
