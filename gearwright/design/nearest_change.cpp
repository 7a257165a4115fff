#include "gearwright/design/nearest_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/design/strength_change.hpp"
#include "gearwright/design/whole_overlap.hpp"
#include "gearwright/gear/gear.hpp"

namespace gearwright {

namespace {

using detail::add_limit;
using detail::Knob;
using detail::shown;

std::string shown(const std::array<double, 2>& b) {
  return b[0] == b[1] ? shown(b[0]) : fmt::format("[{:.10g}, {:.10g}]", b[0], b[1]);
}

// Greatest number of trials that the filter evaluates for one member.
constexpr std::int64_t kMaxSifted = 20 * kMaxForChange;
// Effort of permitting interference, which is high, because such designs do not run.
constexpr double kNotToRun = 100.0;
// Relative accuracy of a change. Changes are printed with four digits.
constexpr double kEnough = 1e-9;

// Computes the least change of one member, and counts the evaluated graphs.
class Least {
 public:
  Least(const SearchProblem& problem, const Knob& knob, const SearchWatch& watch,
        std::int64_t most_questions)
      : knob_(&knob), watch_(&watch), max_questions_(most_questions), problem_(problem) {}

  /// Returns the value nearest to the given one for which a design exists. The change is rounded
  /// away from zero to four digits.
  std::optional<double> find() {
    if (knob_->value == knob_->far || !reach()) return std::nullopt;
    const auto to = knob_->kind == Knob::Kind::limit ? of_limit() : of_new_trials();
    if (!to || knob_->kind == Knob::Kind::teeth) return to;
    const double move = *to - knob_->value;
    const double step = std::pow(10.0, std::floor(std::log10(std::abs(move))) - 3.0);
    constexpr double kWhole = 1e-6;  // tolerance, steps, so that whole steps are not rounded up
    const double rounded =
        knob_->value + std::copysign(std::ceil(std::abs(move) / step - kWhole) * step, move);
    const double tidy = std::stod(shown(rounded));
    return lets_through(tidy) ? tidy : *to;
  }
  std::int64_t questions() const { return questions_; }
  bool bounded() const { return bounded_; }
  bool stopped() const { return stopped_; }

 private:
  // Moves the far end of the range towards the given value until there are few enough trials.
  bool reach() {
    far_ = knob_->far;
    for (int i = 0; i < 60; ++i) {
      knob_->set(problem_, far_);
      const double most = std::max(std::abs(problem_.ratio[0]), std::abs(problem_.ratio[1]));
      if (problem_.ratio[0] <= problem_.ratio[1] &&
          most * problem_.pinion_teeth[1] <= kMaxSearchTeeth) {
        const auto size = SearchSpace(problem_).size();
        if (size && *size <= kMaxSifted) return *size > 0;
      }
      bounded_ = true;
      far_ = (far_ + knob_->value) / 2.0;
      if (knob_->kind == Knob::Kind::teeth) far_ = std::trunc(far_);
      if (far_ == knob_->value) return false;
    }
    return false;
  }
  bool feasible(const Trial& t, double value) {
    ++questions_;
    knob_->set(problem_, value);
    const ShiftGraph graph(problem_, t, trial_gear(problem_, t.z1, t.helix[0], t.rack, 0),
                           trial_gear(problem_, t.z2, t.helix[1], t.rack, 1));
    return has_design(graph);
  }
  bool go_on() {
    if (*watch_ && !(*watch_)(1)) stopped_ = true;
    if (questions_ >= max_questions_) bounded_ = true;
    return !stopped_ && questions_ < max_questions_;
  }
  bool lets_through(double value) {
    if (knob_->kind == Knob::Kind::limit) return feasible(*witness_, value);
    // The changed band of ratios must include the trial that was found. SearchSpace applies a
    // tolerance to the band, so this is checked.
    knob_->set(problem_, value);
    const auto [first, last] = wheels_of(problem_, witness_->z1);
    return first <= witness_->z2 && witness_->z2 <= last;
  }
  // Sets the member to the far end of its range and calls f for every trial that passes the filter.
  template <class F>
  void each_candidate(const F& f) {
    knob_->set(problem_, far_);
    const Search search(problem_);
    search.candidates(f, [&](std::int64_t) {
      if (*watch_ && !(*watch_)(0)) stopped_ = true;
      return !stopped_;
    });
  }

  std::optional<double> of_limit() {
    std::vector<std::int64_t> order;
    each_candidate([&](const Trial& t) {
      order.push_back(t.index);
      return true;
    });
    if (stopped_) return std::nullopt;
    knob_->set(problem_, far_);
    const SearchProblem at_far = problem_;
    const SearchSpace space(at_far);
    std::mt19937_64 random(1);  // the seed has no effect if all trials are evaluated
    const double enough = kEnough * std::max(1.0, std::abs(knob_->value));
    std::optional<double> best;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (!go_on()) break;
      std::swap(order[i], order[i + random() % (order.size() - i)]);
      const Trial t = space.trial(order[i]);
      const double nearer = best ? *best + std::copysign(enough, knob_->value - knob_->far) : far_;
      if (best && std::abs(*best - knob_->value) <= enough) break;
      if (!feasible(t, nearer)) continue;
      double no = knob_->value;
      double yes = nearer;
      while (std::abs(yes - no) > enough) {
        const double middle = (no + yes) / 2.0;
        if (middle == no || middle == yes) break;
        (feasible(t, middle) ? yes : no) = middle;
      }
      best = yes;
      witness_ = t;
    }
    return best;
  }

  // Returns the value of the member that is needed to include the trial.
  double needs(const Trial& t) const {
    return knob_->kind == Knob::Kind::teeth ? t.z1 : static_cast<double>(t.z2) / t.z1;
  }

  std::optional<double> of_new_trials() {
    struct Place {
      double move;
      std::int64_t index;
      bool operator<(const Place& other) const {
        return move != other.move ? move < other.move : index < other.index;
      }
    };
    const double slack = knob_->kind == Knob::Kind::teeth ? 0.0 : kEnough * std::abs(knob_->value);
    const double side = knob_->far < knob_->value ? -1.0 : 1.0;
    const auto most = static_cast<std::size_t>(max_questions_);
    std::vector<Place> places;
    const auto keep_nearest = [&] {
      if (places.size() <= most) return;
      std::nth_element(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(most),
                       places.end());
      places.resize(most);
    };
    each_candidate([&](const Trial& t) {
      const double move = side * (needs(t) - knob_->value);
      if (move > slack) places.push_back({move, t.index});
      if (places.size() >= 4 * most) keep_nearest();
      return true;
    });
    if (stopped_) return std::nullopt;
    keep_nearest();
    std::sort(places.begin(), places.end());
    knob_->set(problem_, far_);
    const SearchProblem at_far = problem_;
    const SearchSpace space(at_far);
    for (const Place& place : places) {
      if (!go_on()) break;
      const Trial t = space.trial(place.index);
      if (!feasible(t, far_)) continue;
      witness_ = t;
      return needs(t);
    }
    return std::nullopt;
  }

  const Knob* knob_;
  const SearchWatch* watch_;
  std::int64_t max_questions_;
  SearchProblem problem_;  // the problem with the current value of the changed member
  double far_ = 0.0;
  std::optional<Trial> witness_;
  std::int64_t questions_ = 0;
  bool bounded_ = false, stopped_ = false;
};

std::vector<Knob> knobs(const SearchProblem& p) {
  using L = SearchLimits;
  const L& limits = p.limits;
  std::vector<Knob> k;
  const auto add_end = [&k](const char* field, const std::array<double, 2>& band, int i, double far,
                            double scale, Knob::Kind kind, auto set) {
    k.push_back({field, band[i], far, scale, kind,
                 [set, i](SearchProblem& q, double v) { set(q, i, v); },
                 [band, i](double v) {
                   auto b = band;
                   b[i] = v;
                   return shown(b);
                 }});
  };
  add_limit(p, k, "limits.contact_ratio", &L::contact_ratio, std::min(1.0, limits.contact_ratio));
  add_limit(p, k, "limits.tip_thickness", &L::tip_thickness, 0.0);
  if (const auto& band = p.center_distance) {
    for (const int i : {0, 1})
      add_end("center_distance", *band, i, (*band)[i] * (i == 0 ? 0.5 : 2.0), (*band)[i],
              Knob::Kind::limit,
              [](SearchProblem& q, int end, double v) { (*q.center_distance)[end] = v; });
  }
  for (const int i : {0, 1}) {
    const double ratio = p.ratio[i];
    double far = ratio + (i == 0 ? -0.5 : 0.5) * std::abs(ratio);
    // An internal gear has more teeth than its pinion, so ratios above −1 are impossible.
    constexpr double kBeyondOne = 1e-3;
    far = p.internal() ? std::min(far, -1.0 - kBeyondOne) : std::max(far, 1.0);
    add_end("ratio", p.ratio, i, far, std::abs(ratio), Knob::Kind::ratio,
            [](SearchProblem& q, int end, double v) { q.ratio[end] = v; });
    const std::array<double, 2> teeth{1.0 * p.pinion_teeth[0], 1.0 * p.pinion_teeth[1]};
    add_end("pinion_teeth", teeth, i, i == 0 ? std::min(5.0, teeth[0]) : 2.0 * teeth[1] + 10.0,
            teeth[i], Knob::Kind::teeth, [](SearchProblem& q, int end, double v) {
              if (q.pinion_teeth[end] == static_cast<int>(v)) return;
              q.pinion_teeth[end] = static_cast<int>(v);
              // A band of b/d_1 gives other face widths for other pinions.
              if (q.face_diameters && !q.overlap_ratios.empty()) set_overlap_choices(q);
            });
  }
  if (limits.min_shift && limits.max_shift) {
    const std::array<double, 2> band{*limits.min_shift, *limits.max_shift};
    for (const int i : {0, 1})
      add_end(i == 0 ? "limits.min_shift" : "limits.max_shift", band, i,
              band[i] + (i == 0 ? -2.0 : 2.0), 1.0, Knob::Kind::limit,
              [](SearchProblem& q, int end, double v) {
                (end == 0 ? q.limits.min_shift : q.limits.max_shift) = v;
              });
  }
  if (limits.undercut_margin > 0.0)
    add_limit(p, k, "limits.undercut_margin", &L::undercut_margin, 0.0);
  add_limit(p, k, "limits.overlap_ratio", &L::overlap_ratio, 0.0);
  add_limit(p, k, "limits.sliding", &L::sliding, limits.sliding.value_or(0.0) + 20.0, 2.0);
  add_limit(p, k, "limits.tip_clearance", &L::tip_clearance,
            std::min(0.0, limits.tip_clearance.value_or(0.0)));
  if (limits.avoid_interference && limits.form_clearance > 0.0)
    add_limit(p, k, "limits.form_clearance", &L::form_clearance, 0.0);
  if (p.rating) detail::add_strength_knobs(p, k);
  return k;
}

}  // namespace

NearestChanges nearest_changes(const SearchProblem& problem, const SearchWatch& watch,
                               std::int64_t most_questions) {
  GW_EXPECTS(Search(problem).space().size().value_or(kMaxForChange + 1) <= kMaxForChange);
  NearestChanges found;
  const auto count = [&](const Least& least, const std::string& field) {
    found.asked += least.questions();
    if (least.bounded()) found.bounded.push_back(field);
    found.stopped = found.stopped || least.stopped();
  };
  for (const Knob& knob : knobs(problem)) {
    if (found.stopped) return found;
    found.tried.push_back(knob.field);
    Least least(problem, knob, watch, most_questions);
    const auto to = least.find();
    count(least, knob.field);
    if (!to) continue;
    found.changes.push_back({knob.field, knob.show(knob.value), knob.show(*to),
                             std::abs(*to - knob.value) / knob.scale});
  }
  const auto switched = [&](const std::string& field, const std::string& from,
                            const std::string& to, double effort, const auto& set) {
    if (found.stopped) return false;
    found.tried.push_back(field);
    SearchProblem p = problem;
    set(p);
    const Search search(p);
    std::int64_t questions = 0;
    bool helps = false;
    search.candidates(
        [&](const Trial& t) {
          if (watch && !watch(1)) found.stopped = true;
          if (found.stopped) return false;
          if (questions++ == most_questions) {
            found.bounded.push_back(field);
            return false;
          }
          helps = search.feasible(t);
          return !helps;
        },
        [&](std::int64_t) { return !found.stopped; });
    found.asked += questions;
    if (helps) found.changes.push_back({field, from, to, effort});
    return helps;
  };
  if (problem.coprime)
    switched("coprime", "true", "false", 0.5, [](SearchProblem& p) { p.coprime = false; });
  // If designs are drawn, the change never permits interference.
  if (problem.limits.avoid_interference && !problem.draw) {
    switched("limits.avoid_interference", "exclude", "flag", kNotToRun, [](SearchProblem& p) {
      p.limits.avoid_interference = p.limits.clear_fillets = false;
      p.limits.form_clearance = 0.0;
    });
  }
  if (problem.rating) {
    const std::string& now = problem.rating->input.materials[0].name;
    for (const Material& steel : detail::stronger_steels(*problem.rating)) {
      constexpr double kAnotherSteel = 0.5;
      if (switched(gear_field(1, "material.name"), now.empty() ? "the given material" : now,
                   steel.name, kAnotherSteel, [&](SearchProblem& p) {
                     p.rating->input.materials = {steel, steel};
                   }))
        break;
    }
    if (!found.stopped) found.safest = detail::safest_design(problem, watch, most_questions);
  }
  std::stable_sort(
      found.changes.begin(), found.changes.end(),
      [](const NearestChange& a, const NearestChange& b) { return a.effort < b.effort; });
  // Both ends of a band have the same name. Each name is stored only once.
  for (std::vector<std::string>* fields : {&found.bounded, &found.tried}) {
    std::vector<std::string> once;
    for (std::string& field : *fields) add_once(once, std::move(field));
    *fields = std::move(once);
  }
  return found;
}

}  // namespace gearwright
