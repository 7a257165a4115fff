// Searches for designs. For every trial, the search computes a design or the limit that rejects the
// trial. The result contains the best designs in sorted order.
//
// Ranges of trials are searched independently, so a search can be divided among threads, shards and
// ranks. The first three limits need only a few operations and reject most trials. The filter
// (design/candidate.hpp) evaluates these limits for several trials at once. If the filter does not
// reject a trial, its graph (design/shift_graph.hpp) is computed.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <vector>

#include "gearwright/design/design_row.hpp"
#include "gearwright/design/search_space.hpp"
#include "gearwright/design/shift_points.hpp"

namespace gearwright {

struct SearchCounts {
  std::int64_t tested = 0;  ///< number of trials; with `coprime`, trials with a common factor are
                            ///< not counted
  std::int64_t feasible = 0;
  std::array<std::int64_t, kLimits> rejected{};  ///< number of trials that each limit rejects; a
                                                 ///< trial counts only for the first such limit
  /// For each WarningCode, the number of trials that the limit `verdict` rejects because of this
  /// finding. A trial counts only for its worst finding.
  std::array<std::int64_t, kWarningCodes> findings{};
  std::int64_t points_tested = 0, points_feasible = 0;  ///< points of the grid of shifts

  SearchCounts& operator+=(const SearchCounts& other);
  friend bool operator==(const SearchCounts&, const SearchCounts&) = default;
};

/// `decided` is the number of trials that the filter decided. `asked` is the number of trials that
/// the filter could not decide.
struct SieveCounts {
  std::int64_t decided = 0, asked = 0;
};

/// A callback for long searches, which may be empty. It receives the number of trials since the
/// last call and returns true if the search shall continue. Any working thread may call it, many
/// times per second.
using SearchWatch = std::function<bool(std::int64_t trials)>;

struct RangeOptions {
  RegionDetail detail = RegionDetail::whole;  ///< whether rows contain the values of the region; a
                                              ///< ranking by area requires `whole`
  SieveCounts* sieve = nullptr;
  std::vector<ShiftPoint>* points =
      nullptr;  ///< if not null, receives the feasible points of the grid of shifts
  SearchWatch watch{};
};

class Search {
 public:
  explicit Search(SearchProblem problem);

  const SearchProblem& problem() const { return problem_; }
  const SearchSpace& space() const { return space_; }

  /// Searches the trials [from, to) and appends the feasible designs in the order of the trials.
  /// Thread-safe. If the watch stops the search, the result covers only a part of the range.
  SearchCounts range(std::int64_t from, std::int64_t to, std::vector<DesignRow>& rows,
                     const RangeOptions& wish = {}) const;

  /// Returns the given row, completed by the values of its region.
  DesignRow whole(const DesignRow& row) const;
  /// True if a trial in [from, to) is feasible. The search stops at the first such trial.
  bool exists(std::int64_t from, std::int64_t to) const;

  /// Calls f for every trial that the filter does not reject. The calls end when f returns false.
  void candidates(const std::function<bool(const Trial&)>& f, const SearchWatch& watch = {}) const;

  ShiftGraph graph(const Trial& trial) const;
  bool feasible(const Trial& trial) const { return has_design(graph(trial)); }

 private:
  // Evaluates the filter for the trials [from, to), and calls decide(trial, verdict, gear 1, gear
  // 2) for one trial after another. The calls end when `decide` returns false.
  template <class F>
  void sift(std::int64_t from, std::int64_t to, const SearchWatch& watch, const F& decide) const;
  std::shared_ptr<const TrialGears> gears(int which, int rack, Angle helix) const;

  SearchProblem problem_;
  SearchSpace space_;
  mutable std::mutex mutex_;
  mutable std::map<std::tuple<int, int, Angle>, std::shared_ptr<const TrialGears>> tables_;
};

/// The transmission error under load of one design of a result (job/loaded_designs.hpp).
struct LoadedDesign {
  Trial trial;
  std::optional<double> noise{};  ///< µm, peak to peak along the line of action
  std::string reason{};           ///< reason why there is no value; otherwise empty
};

/// The result of a search. Designs are sorted by the first objective, the best first. If there are
/// several objectives, the designs of the Pareto front come before all others. If the first
/// objective is the noise, the designs in `loaded` are sorted by their transmission error under
/// load instead of the estimate.
struct SearchAnswer {
  SearchAnswer() = default;  ///< empty; prevents aggregate initialisation
  SearchCounts counts;
  std::vector<DesignRow> designs;
  std::vector<std::size_t> pareto;   ///< indices of the Pareto front in `designs`
  bool cut = false;                  ///< true if some feasible designs are missing in `designs`
  std::vector<LoadedDesign> loaded;  ///< computed for the best designs, if requested
};
/// Receives any number of designs and keeps only the best ones and the Pareto front.
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
  std::vector<Place> heap_;      ///< indices of the best rows; the worst of these rows is on top
  std::vector<DesignRow> rows_;  ///< the rows to which `heap_` refers
  ParetoFront front_;
  std::int64_t added_ = 0;
};

}  // namespace gearwright
