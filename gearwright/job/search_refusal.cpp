#include "gearwright/job/search_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/parallel.hpp"

namespace gearwright {

Error no_search() {
  return absent_input("search", "; a search needs a table [search] with at least the key ratio");
}

Error no_tooth_numbers() {
  return {"search.ratio", "",
          "no numbers of teeth within `pinion_teeth` give this ratio; widen the band of the ratio "
          "or the band `pinion_teeth`"};
}

RegionDetail detail_of(const SearchProblem& problem, bool files) {
  const auto& wanted = problem.objectives;
  const bool by_area = is_in(Objective::area, wanted);
  return files || by_area ? RegionDetail::whole : RegionDetail::point;
}

namespace {

// Returns the speed of one thread in trials per second. It is measured for half a second in total,
// at ten trial numbers that are spread over the search. The tables for a helix angle are made
// before each measurement, because the search makes them only once. A measurement ends after its
// time even if trials are slow.
double measured_rate(const Search& search, std::int64_t trials, const std::atomic<bool>* stop) {
  using Clock = std::chrono::steady_clock;
  constexpr double kSeconds = 0.5;
  constexpr int kPlaces = 10;
  const std::int64_t step = std::min<std::int64_t>(1 << 19, trials);
  std::int64_t done = 0;
  double seconds = 0.0;
  for (int i = 0; i < kPlaces && !(stop && *stop); ++i) {
    // Multiples of the golden ratio spread these trial numbers evenly.
    const double share = std::fmod(i * 0.6180339887498949, 1.0);
    const auto from = static_cast<std::int64_t>(share * static_cast<double>(trials - step));
    std::vector<DesignRow> rows;
    search.range(from, from + 1, rows);
    const auto start = Clock::now();
    const auto so_far = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
    const auto counts = search.range(
        from, from + step, rows,
        {.detail = detail_of(search.problem(), false),
         .watch = [&](std::int64_t) { return so_far() < kSeconds / kPlaces && !(stop && *stop); }});
    done += std::max<std::int64_t>(counts.tested, 1);
    seconds += so_far();
  }
  return static_cast<double>(done) / seconds;
}

std::string duration_text(double seconds) {
  if (seconds < 120) return fmt::format("{:.0f} seconds", seconds);
  if (seconds < 7200) return fmt::format("{:.0f} minutes", seconds / 60);
  if (seconds < 172800) return fmt::format("{:.0f} hours", seconds / 3600);
  if (seconds < 63072000) return fmt::format("{:.0f} days", seconds / 86400);
  return fmt::format("{:.0f} years", seconds / 31557600);
}

// Rejects a grid of profile shifts with too many points, or with too many trials to count the
// points. The number of points follows from the sum of the areas of the regions. This sum is
// estimated from a thousand trials that Search::candidates() returns, or from all such trials if
// there are fewer. The limit only prevents very large files, so an error of a few percent is
// acceptable.
std::optional<Error> refuse_many_points(const Search& search, const SearchOptions& options) {
  if (!search.problem().shift_step || options.yes_large) return std::nullopt;
  const double step = *search.problem().shift_step;
  constexpr double kMaxTrials = 1e7;
  constexpr double kPointBytes = 66;  // measured: 16 in the table, 50 in the chunks
  constexpr std::size_t kSample = 1000;
  if (search.space().approximate_size() > kMaxTrials) {
    return Error{
        "search.shift_step", fmt::format("{}", step),
        fmt::format("the points of the grid cannot be counted beforehand for more than {:g} "
                    "candidates; leave out this key, narrow the search, or add --yes-large",
                    kMaxTrials)};
  }
  const auto stopped = [&] { return options.stop && *options.stop; };
  std::vector<std::int64_t> trials;
  search.candidates(
      [&](const Trial& t) {
        trials.push_back(t.index);
        return true;
      },
      [&](std::int64_t) { return !stopped(); });
  const std::size_t sampled = std::min(trials.size(), kSample);
  double area = 0.0;
  std::size_t designs = 0;
  for (std::size_t i = 0; i < sampled && !stopped(); ++i) {
    const std::size_t place = i * trials.size() / sampled;
    const auto region = shift_region(search.graph(search.space().trial(trials[place])));
    if (!region) continue;
    area += region->area;
    ++designs;
  }
  if (stopped() || designs == 0) return std::nullopt;
  const double share = static_cast<double>(trials.size()) / static_cast<double>(sampled);
  area *= share;
  const double points = area / (step * step);
  if (points <= kManyPoints) return std::nullopt;
  const double enough = std::sqrt(area / kManyPoints);
  return Error{
      "search.shift_step", fmt::format("{}", step),
      fmt::format(
          "the regions of {}{:.0f} designs contain about {:.2g} points of this grid, which need "
          "{:.0f} GB; use a step of at least {:.2g}, narrow the search, or add --yes-large",
          sampled < trials.size() ? "about " : "", static_cast<double>(designs) * share, points,
          points * kPointBytes * 1e-9, enough * 1.01)};
}

}  // namespace

std::optional<Error> refuse_large(const Search& search, const SearchOptions& options) {
  const double size = search.space().approximate_size();
  if (!search.space().size()) {
    return Error{"search", fmt::format("{:.3g}", size),
                 "there are too many candidates; narrow the bands of teeth and ratio, or shorten "
                 "the lists of modules and helix angles"};
  }
  if (options.yes_large) return std::nullopt;
  if (size <= kLargeSearch) return refuse_many_points(search, options);
  const int threads = thread_count(options.threads);
  const double rate = measured_rate(search, *search.space().size(), options.stop) * threads;
  return Error{
      "--yes-large", fmt::format("{:.3g}", size),
      fmt::format(
          "{} candidates would take about {} on this machine, at {} candidates per "
          "second on {} thread{}. Narrow the bands, or add --yes-large. With --out DIR the "
          "search can be stopped and resumed, and --shard i/N divides it among machines{}",
          rough_count(size), duration_text(size / rate), rough_count(rate), threads,
          threads == 1 ? "" : "s",
          search.problem().draw
              ? ". The search is faster if designs are not drawn; for this, give `mounting` in "
                "[search], and leave out tolerances and bands of face widths"
              : ""),
      FailureKind::option};
}

}  // namespace gearwright
