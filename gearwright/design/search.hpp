// The design search: every trial, what killed it or what it became, and the best of them in order.
//
// A range of trials is searched by itself and depends on nothing else, so that the whole may be cut
// anywhere: threads, shards, ranks. Most trials die of three limits that cost a few operations; the
// sieve (design/candidate.hpp) does those as many at a time as the processor has lanes, and only
// what it cannot decide for certain gets its graph.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <tuple>
#include <vector>

#include "gearwright/design/design_row.hpp"
#include "gearwright/design/search_space.hpp"
#include "gearwright/design/shift_points.hpp"

namespace gearwright {

struct SearchCounts {
  std::int64_t tested = 0;  ///< trials that count: all, or the coprime ones
  std::int64_t feasible = 0;
  std::array<std::int64_t, kLimits> rejected{};         ///< by the first limit that leaves nothing
  std::int64_t points_tested = 0, points_feasible = 0;  ///< of the grid of shifts

  SearchCounts& operator+=(const SearchCounts& other);
  friend bool operator==(const SearchCounts&, const SearchCounts&) = default;
};

/// Trials whose verdict the sieve gave, and those that needed their graph.
struct SieveCounts {
  std::int64_t decided = 0, asked = 0;
};

class Search {
 public:
  explicit Search(SearchProblem problem);

  const SearchProblem& problem() const { return problem_; }
  const SearchSpace& space() const { return space_; }

  /// Searches [from, to) and appends its feasible designs in the order of the trials, and with a
  /// grid of shifts its feasible points, if they are wanted. Safe from several threads.
  SearchCounts range(std::int64_t from, std::int64_t to, std::vector<DesignRow>& rows,
                     SieveCounts* sieve = nullptr, std::vector<ShiftPoint>* points = nullptr) const;

  /// Some trial of [from, to) is feasible; stops at the first.
  bool exists(std::int64_t from, std::int64_t to) const;

  ShiftGraph graph(const Trial& trial) const;

 private:
  // Runs [from, to) through the sieve: decide(trial, verdict, gear 1, gear 2) until it returns
  // false.
  template <class F>
  void sift(std::int64_t from, std::int64_t to, const F& decide) const;
  std::shared_ptr<const TrialGears> gears(int which, int rack, Angle helix) const;

  SearchProblem problem_;
  SearchSpace space_;
  mutable std::mutex mutex_;
  mutable std::map<std::tuple<int, int, Angle>, std::shared_ptr<const TrialGears>> tables_;
};

/// What a search found. Designs best first: without a Pareto front by the objective; of several
/// objectives the front first, both parts by the first of them.
struct SearchAnswer {
  SearchCounts counts;
  std::vector<DesignRow> designs;
  std::vector<std::size_t> pareto;  ///< places in `designs` of those that none dominates
  bool cut = false;                 ///< there are more feasible designs than `designs` holds
};

/// Keeps the best designs of any number that pass by, and the front.
class BestDesigns {
 public:
  /// `most`: how many designs the answer may hold.
  BestDesigns(const SearchProblem& problem, std::size_t most);
  void add(const DesignRow& row);
  SearchAnswer answer(const SearchCounts& counts) &&;

 private:
  const SearchProblem* problem_;
  std::size_t max_;
  std::vector<DesignRow> heap_;  ///< the worst on top
  ParetoFront front_;
  std::int64_t added_ = 0;
};

}  // namespace gearwright
