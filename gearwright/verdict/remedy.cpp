#include "gearwright/verdict/remedy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "gearwright/base/printable.hpp"
#include "gearwright/pair/stated_backlash.hpp"
#include "gearwright/verdict/margins.hpp"

namespace gearwright::detail {

namespace {

// The numbers of red and amber findings. The score with fewer red findings is better. If both
// scores have the same number of red findings, the score with fewer amber findings is better.
struct Score {
  int red = 0, amber = 0;
  auto operator<=>(const Score&) const = default;
};

Score score_of(const std::vector<Finding>& findings) {
  Score score;
  for (const Finding& f : findings) {
    score.red += f.level == Level::red;
    score.amber += f.level == Level::amber;
  }
  return score;
}

Level level_in(const std::vector<Finding>& findings, const Finding& like) {
  Level level = Level::green;
  for (const Finding& f : findings)
    if (f.code == like.code && f.gear == like.gear) level = std::max(level, f.level);
  return level;
}

// Tries changes of one spec and compares the findings after each change with those of the unchanged
// spec. Each change is evaluated only once.
class Trials {
 public:
  Trials(const std::vector<Finding>& before, const TryChange& attempt, double normal_module)
      : before_(before), attempt_(attempt), no_backlash_(no_backlash(normal_module)) {}

  const std::optional<ChangedState>& of(const SpecChange& change, TryDepth depth) {
    const Key key{change.what, change.gear, change.value, depth};
    const auto found = done_.find(key);
    if (found != done_.end()) return found->second;
    return done_.emplace(key, attempt_(change, depth)).first->second;
  }

  /// Sets the greatest level of findings that a change may add. The default is green.
  void accept(Level level) { accepted_ = level; }

  /// Returns the score after a change. Returns nothing if the change does not remove the finding,
  /// or if it adds or worsens another finding beyond the accepted level.
  std::optional<Score> score(const Finding& finding, const SpecChange& change, TryDepth depth) {
    // The computation without tolerances and contact is done first, because it is the cheapest and
    // rejects most changes.
    if (depth != TryDepth::as_drawn && !score(finding, change, TryDepth::as_drawn))
      return std::nullopt;
    const std::optional<ChangedState>& state = of(change, depth);
    if (!state || level_in(state->findings, finding) > Level::green) return std::nullopt;
    // The finding of circular-arc teeth compares j_bn with its limit. At a large pressure angle, j_n
    // is then still negative.
    if (finding.code == WarningCode::negative_backlash && state->backlash <= -no_backlash_)
      return std::nullopt;
    for (const Finding& f : state->findings)
      if (f.level > std::max(level_in(before_, f), accepted_)) return std::nullopt;
    return score_of(state->findings);
  }

 private:
  using Key = std::tuple<Adjustable, int, double, TryDepth>;
  const std::vector<Finding>& before_;
  const TryChange& attempt_;
  Level accepted_ = Level::green;
  double no_backlash_;  // mm
  std::map<Key, std::optional<ChangedState>> done_;
};

struct Found {
  SpecChange change;
  Score score;
};

// Returns the change of a number with which the contact lies nearest to the middle of the face. The
// number is found by bisection, because the contact moves in one direction as the number grows.
// Returns none in these cases: the contact stays on one side of the middle; it lies more than
// kMiddlePlace from the middle after the change; edges touch more often than in `before`; the
// change does not remove the finding.
std::optional<Found> centring_change(Trials& trials, const Finding& finding, const Lever& lever,
                                     const PatternPlace& before) {
  const auto change_of = [&](double steps) {
    return SpecChange{lever.what, lever.gear, lever.in_steps(steps)};
  };
  const auto place_at = [&](double steps) {
    const auto& state = trials.of(change_of(steps), TryDepth::with_contact);
    return state ? state->place : std::nullopt;
  };
  const auto mean_at = [&](double steps) {
    const auto place = place_at(steps);
    return place ? place->mean : std::nullopt;
  };
  double hi = std::floor(lever.span / lever.step()), lo = -hi;
  const auto at_lo = mean_at(lo), at_hi = mean_at(hi);
  if (!at_lo || !at_hi || *at_lo * *at_hi > 0.0) return std::nullopt;
  while (hi - lo > 1.0) {
    const double middle = std::floor((lo + hi) / 2);
    const auto mean = mean_at(middle);
    if (!mean) return std::nullopt;
    (*mean * *at_hi > 0.0 ? hi : lo) = middle;
  }
  const double best = std::abs(*mean_at(lo)) < std::abs(*mean_at(hi)) ? lo : hi;
  const PatternPlace place = *place_at(best);
  if (std::abs(*place.mean) > kMiddlePlace || place.edge_share > before.edge_share)
    return std::nullopt;
  const auto score = trials.score(finding, change_of(best), TryDepth::with_contact);
  return score ? std::optional(Found{change_of(best), *score}) : std::nullopt;
}

// Returns the smallest change of one number that reaches the best score. Values are multiples of
// the step, so the printed value is exactly the value that was tried.
std::optional<Found> least_change(Trials& trials, const Finding& finding, const Lever& lever,
                                  TryDepth depth) {
  const double step = lever.step();
  const double begin = lever.now / step;
  const auto steps_for = [&](double offset) {  // at least one step away from the present value
    const double to = begin + lever.direction * std::max(offset / step, 0.0);
    const double whole = lever.direction > 0 ? std::ceil(to - 1e-9) : std::floor(to + 1e-9);
    return std::abs(whole - begin) < 1e-9 ? whole + lever.direction : whole;
  };
  const auto change_of = [&](double steps) {
    return SpecChange{lever.what, lever.gear, lever.in_steps(steps)};
  };
  if (lever.exact) {
    const SpecChange change{lever.what, lever.gear, *lever.exact};
    const auto score = trials.score(finding, change, depth);
    return score ? std::optional(Found{change, *score}) : std::nullopt;
  }
  std::vector<double> places;
  for (const double share : {1.0 / 64, 1.0 / 32, 1.0 / 16, 1.0 / 8, 0.25, 0.5, 0.75, 1.0}) {
    const bool dear =
        depth == TryDepth::with_contact && (share == 1.0 / 32 || share == 1.0 / 8 || share == 0.75);
    if (!dear) places.push_back(steps_for(share * lever.span));
  }
  if (lever.hint) {
    const double offset = lever.direction * (*lever.hint - lever.now);
    if (offset > 0.0 && offset < lever.span) places.push_back(steps_for(offset));
  }
  std::optional<Score> best;
  double at = begin, below = begin;
  const auto try_places = [&] {
    std::sort(places.begin(), places.end(),
              [&](double a, double b) { return lever.direction * (a - b) < 0.0; });
    places.erase(std::unique(places.begin(), places.end()), places.end());
    double last = begin;
    for (const double steps : places) {
      const auto score = trials.score(finding, change_of(steps), depth);
      if (score && (!best || *score < *best)) {
        best = score;
        at = steps;
        below = last;
      }
      last = steps;
    }
  };
  try_places();
  // The range of profile shifts with neither undercut nor a thin tip may lie between two of the
  // tried values, because it can be very narrow. More values are therefore tried.
  if (!best && lever.what == Adjustable::profile_shift && depth != TryDepth::with_contact) {
    constexpr int kFine = 20;
    for (int i = 1; i < kFine; ++i) places.push_back(steps_for(i * lever.span / kFine));
    try_places();
  }
  if (!best) return std::nullopt;
  while (std::abs(at - below) > 1.0) {
    const double middle = std::floor((at + below) / 2);
    if (middle == at || middle == below) break;
    const auto score = trials.score(finding, change_of(middle), depth);
    (score && *score <= *best ? at : below) = middle;
  }
  return Found{change_of(at), *trials.score(finding, change_of(at), depth)};
}

}  // namespace

void add_remedies(std::vector<Finding>& findings, const Judged& judged, const TryChange& attempt) {
  const std::vector<Finding> before = findings;
  Trials trials(before, attempt, judged.gears[0]->spec.normal_module);
  const auto place = pattern_place(judged);
  std::string strength;  // the remedy shared by all findings about safety factors
  for (Finding& finding : findings) {
    if (is_safety(finding.code) && finding.at.empty() && judged.rating) {
      if (strength.empty()) strength = rating_remedy(*judged.rating);
      finding.remedy = strength;
    } else {
      finding.remedy = meaning_of(finding.code).advice;
    }
    const Cure* const cure = cure_of(finding);
    const bool worst = finding.level == findings.front().level && finding.level > Level::green;
    if (!worst || !attempt || cure == nullptr) continue;
    const TryDepth depth = cure->needs_contact ? TryDepth::with_contact
                           : judged.tolerances ? TryDepth::at_tolerances
                                               : TryDepth::as_drawn;
    const bool under_errors = judged.contact && judged.errors && !cure->needs_contact;
    const TryDepth deepest = under_errors ? TryDepth::with_contact : depth;
    const auto best_change = [&] {
      std::optional<Found> best;
      for (const Lever& lever : levers(*cure, finding, judged)) {
        // Another number of teeth changes the ratio, so it is tried only if nothing else helps.
        if (best && judged.pair && lever.what == Adjustable::teeth) break;
        auto found = lever.what == Adjustable::lead_slope
                         ? centring_change(trials, finding, lever, *place)
                         : least_change(trials, finding, lever, depth);
        // The contact under the errors is computed only for the change that would be printed. If it
        // is worse than before, the other changes of this number are tried with their contact.
        if (found && under_errors) {
          const auto score = trials.score(finding, found->change, deepest);
          found = score ? std::optional(Found{found->change, *score})
                        : least_change(trials, finding, lever, deepest);
        }
        if (found && (!best || found->score < best->score)) best = found;
        // For a finding of a contact analysis, the search stops at the first change that removes
        // the finding, because each trial takes milliseconds.
        if (best && (best->score == Score{} || cure->needs_contact)) break;
      }
      return best;
    };
    std::optional<Found> best = best_change();
    // The pinion of a rack may have undercut, which is an amber finding at every centre distance
    // with contact. Changes that lead from the red finding to amber ones are therefore tried, too.
    const bool first = &finding == &findings.front() && finding.level == Level::red;
    std::string left;
    if (!best && judged.rack && first) {
      trials.accept(Level::amber);
      best = best_change();
      trials.accept(Level::green);
      if (best)
        left =
            enumerated(reasons(trials.of(best->change, deepest)->findings, judged, Level::amber));
    }
    if (!best) continue;
    finding.change = best->change;
    finding.remedy =
        remedy_words(*cure, best->change, finding, judged, *trials.of(best->change, deepest));
    if (!left.empty()) finding.remedy += fmt::format(" After this change, check: {}.", left);
  }
}

}  // namespace gearwright::detail
