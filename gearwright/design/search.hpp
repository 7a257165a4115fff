// The design search: every trial with the limit that rejected it or its design, and the best
// designs in order.
//
// A range of trials is searched independently, so the search can be divided at any point among
// threads, shards and ranks. Three limits that cost a few operations reject most trials; the filter
// (design/candidate.hpp) evaluates them for several trials at once, and a graph is computed only
// for undecided trials.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
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
  std::array<std::int64_t, kLimits> rejected{};  ///< by the first limit that leaves no region
  std::int64_t points_tested = 0, points_feasible = 0;  ///< of the grid of shifts

  SearchCounts& operator+=(const SearchCounts& other);
  friend bool operator==(const SearchCounts&, const SearchCounts&) = default;
};

/// Numbers of trials decided by the filter, and of those that needed their graph.
struct SieveCounts {
  std::int64_t decided = 0, asked = 0;
};

/// A callback for long searches: it receives the number of trials since the last call and returns
/// true to continue. It is called many times per second, from any working thread; it may be empty.
using SearchWatch = std::function<bool(std::int64_t trials)>;

/// Requests for a range in addition to its designs.
struct RangeOptions {
  RegionDetail detail = RegionDetail::whole;  ///< of each row; rank by area needs `whole`
  SieveCounts* sieve = nullptr;
  std::vector<ShiftPoint>* points = nullptr;  ///< of the grid of shifts
  SearchWatch watch{};
};

class Search {
 public:
  explicit Search(SearchProblem problem);

  const SearchProblem& problem() const { return problem_; }
  const SearchSpace& space() const { return space_; }

  /// Searches [from, to) and appends its feasible designs in the order of the trials. Thread-safe.
  /// If the watch ends the search, the result covers a part of the range.
  SearchCounts range(std::int64_t from, std::int64_t to, std::vector<DesignRow>& rows,
                     const RangeOptions& wish = {}) const;

  /// The row with the numbers of its region.
  DesignRow whole(const DesignRow& row) const;

  /// True if some trial of [from, to) is feasible; stops at the first.
  bool exists(std::int64_t from, std::int64_t to) const;

  /// Calls f for every trial that passes the filter, until f returns false.
  void candidates(const std::function<bool(const Trial&)>& f, const SearchWatch& watch = {}) const;

  ShiftGraph graph(const Trial& trial) const;
  bool feasible(const Trial& trial) const { return has_design(graph(trial)); }

 private:
  // Runs [from, to) through the filter: calls decide(trial, verdict, gear 1, gear 2) until it
  // returns false.
  template <class F>
  void sift(std::int64_t from, std::int64_t to, const SearchWatch& watch, const F& decide) const;
  std::shared_ptr<const TrialGears> gears(int which, int rack, Angle helix) const;

  SearchProblem problem_;
  SearchSpace space_;
  mutable std::mutex mutex_;
  mutable std::map<std::tuple<int, int, Angle>, std::shared_ptr<const TrialGears>> tables_;
};

/// The result of a search. Designs are sorted best first, by the objective; with several objectives
/// the Pareto front comes first, and both parts are sorted by the first objective.
struct SearchAnswer {
  SearchAnswer() = default;  ///< empty, and not an aggregate; a Search makes it
  SearchCounts counts;
  std::vector<DesignRow> designs;
  std::vector<std::size_t> pareto;  ///< indices in `designs` of those that no other dominates
  bool cut = false;                 ///< there are more feasible designs than `designs` holds
};

/// Keeps the best of any number of designs, and the front.
class BestDesigns {
 public:
  /// `most` is the number of designs that the result may contain.
  BestDesigns(const SearchProblem& problem, std::size_t most);
  void add(const DesignRow& row);
  SearchAnswer answer(const SearchCounts& counts) &&;

 private:
  struct Place {
    RankKey key;
    std::size_t row;
    bool operator<(const Place& other) const { return key < other.key; }
  };
  const SearchProblem* problem_;
  std::size_t max_;
  std::vector<Place> heap_;      ///< the worst on top; rows are not moved
  std::vector<DesignRow> rows_;  ///< of the heap
  ParetoFront front_;
  std::int64_t added_ = 0;
};

}  // namespace gearwright
