#include "gearwright/contact/compensation.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/contact/center_search.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/contact/possible_bounds.hpp"
#include "gearwright/contact/worst_estimate.hpp"
#include "gearwright/math/decompositions.hpp"
#include "gearwright/math/minimise.hpp"

namespace gearwright {

namespace {

// A search ends when the change of f is below kLastGain · f or below kLastGain_rad. kLastGain_rad
// is a hundredth of kSameError.
constexpr double kLastGain = 1e-5;  // relative
constexpr double kLastGain_rad = 1e-5 * kRadPerArcsec;
// A descent with derivatives ends when the tangents promise a smaller gain, relative to the value.
// It knows this gain before a trial, so it can end later than a search without derivatives.
constexpr double kLastPromise = 1e-7;
// This value, in rad, replaces f if contact is lost. It is far above all other values of f. The
// optimiser requires finite values, so infinity is not used.
constexpr double kLost = 1e3;
// If a task has an aim, kAimLastGain · CompensationAim::same replaces kLastGain_rad, and kAimLost ·
// CompensationAim::same replaces kLost.
constexpr double kAimLastGain = 0.01, kAimLost = 1e9;
// The penalty per radian by which the peak to peak exceeds its limit. The cost of the pattern
// without corrections is also added, so corrections that exceed the limit are never better than no
// corrections. f still decreases as the peak to peak approaches the limit.
constexpr double kOverLimit = 100.0;

// Evaluates the function that is minimised, which is the aim of the task, or f if there is no aim.
class Judge {
 public:
  using Model = CompensationAim::Estimate;  // as a function of the corrections, not of a change

  Judge(const CompensationTask& task, int positions) : task_(task), positions_(positions) {
    const std::vector<double> zero(task.corrections.size(), 0.0);
    const ContactScore score = worst(curves(zero));
    // If the caller does not give the weight w, corrections must not increase the peak to peak.
    if (!task.centering && !score.lost)
      limit_ = std::max(kQuiet, score.span_or_sampled() + 0.5 * kSameError).rad();
    centering_ = task.centering.value_or(default_centering(score.peak_to_peak)).rad();
    place_of_none_ = place_cost(score);
  }

  std::vector<ContactCurve> curves(const std::vector<double>& v) {
    count_step(task_.progress);
    std::vector<ContactCurve> all;
    for (int s = 0; s < task_.scenarios; ++s) {
      const auto pair = task_.pair_at(v, s);
      if (!pair) return {};
      all.push_back(contact_curve(*pair, positions_, task_.profile));
    }
    return all;
  }

  bool has_near() const { return task_.aim && task_.aim->near; }
  // Returns an estimate of the aim around a center. The estimate is exact at the center.
  Model near(const std::vector<double>& center) {
    // The estimate is finite even if teeth with these corrections do not exist. Whether they
    // exist does not depend on the scenario, so only scenario 0 is checked.
    const auto change = [this,
                         center](std::vector<double> v) -> std::optional<std::vector<double>> {
      count_step(task_.progress);
      if (!task_.pair_at(v, 0)) return std::nullopt;
      for (std::size_t k = 0; k < v.size(); ++k) v[k] -= center[k];
      return v;
    };
    std::vector<Model> all;
    for (int s = 0; s < task_.scenarios && task_.pair_at(center, 0); ++s)
      all.push_back(task_.aim->near(center, s, positions_));
    if (all.empty())
      return {[](const auto&) { return kInfinity; }, [](const auto&) { return Tangents{}; }};
    const Model worst = detail::worst_estimate(std::move(all));
    return {[=](const std::vector<double>& v) {
              const auto by = change(v);
              return by ? worst.value(*by) : kInfinity;
            },
            [=](const std::vector<double>& v) {
              const auto by = change(v);
              return by ? worst.tangents(*by) : Tangents{};
            }};
  }
  // After this call, value() evaluates `model`. If `model` is empty, value() is exact.
  void use(Model model) {
    model_ = std::move(model);
    known_.clear();
  }
  const Model& model() const { return model_; }

  // value() stores results, because descents from several starts evaluate the same corrections.
  double value(const std::vector<double>& v) {
    const auto [known, is_new] = known_.try_emplace(v, 0.0);
    if (is_new) known->second = computed(v);
    return known->second;
  }

  int positions() const { return positions_; }
  // These three functions refer to f, or to the aim if there is one. same() returns the smallest
  // relevant difference, last_gain() the difference at which a search ends, and lost() the value if
  // contact is lost.
  double same() const { return task_.aim ? task_.aim->same : kSameError.rad(); }
  double last_gain() const { return task_.aim ? kAimLastGain * task_.aim->same : kLastGain_rad; }
  double lost() const { return task_.aim ? kAimLost * task_.aim->same : kLost; }
  Angle centering() const { return Angle::radians(centering_); }

 private:
  double computed(const std::vector<double>& v) {
    if (model_.value) return model_.value(v);
    if (task_.aim) return aimed(v);
    const auto all = curves(v);
    if (all.empty()) return kInfinity;
    const ContactScore s = worst(all);
    if (s.lost) return kInfinity;
    const double te = s.span_or_sampled().rad();
    const double f = te + place_cost(s);
    return te > limit_ ? f + place_of_none_ + kOverLimit * (te - limit_) : f;
  }

  double aimed(const std::vector<double>& v) {
    count_step(task_.progress);
    double worst = 0.0;
    for (int s = 0; s < task_.scenarios; ++s)
      worst = std::max(worst, task_.aim->of(v, s, positions_));
    return worst;
  }

  double place_cost(const ContactScore& s) const {
    const double along = task_.along_face ? s.pattern_middle * s.pattern_middle : 0.0;
    return centering_ * (along + s.along_profile * s.along_profile);
  }

  static ContactScore worst(const std::vector<ContactCurve>& all) {
    ContactScore score;
    for (const ContactCurve& c : all) take_worst(score, c.score);
    return score;
  }

  const CompensationTask& task_;
  int positions_;
  double limit_ = kInfinity;                      // limit of the peak to peak, rad
  double centering_ = 0.0, place_of_none_ = 0.0;  // rad; w, and the cost of the pattern at v = 0
  Model model_;
  std::map<std::vector<double>, double> known_;
};

// Returns the corrections that minimise the sum of the squares of TE over all scenarios. TE is
// linearised at v = 0, and the mean of each TE curve is subtracted first.
std::vector<double> linearised(const CompensationTask& task, Judge& judge) {
  const std::size_t n = task.corrections.size();
  const std::vector<double> zero(n, 0.0);
  const auto base = judge.curves(zero);
  const std::size_t rows = static_cast<std::size_t>(task.scenarios * judge.positions());
  const auto column = [&](const std::vector<ContactCurve>& curves) {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows));
    Eigen::Index i = 0;
    for (const ContactCurve& c : curves) {
      double mean = 0.0;
      for (const double te : c.te) mean += std::isnan(te) ? 0.0 : te / judge.positions();
      for (const double te : c.te) y[i++] = std::isnan(te) ? 0.0 : te - mean;
    }
    return y;
  };
  if (base.empty()) return zero;
  const Eigen::VectorXd y = column(base);
  Eigen::MatrixXd a(y.size(), static_cast<Eigen::Index>(n));
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<double> v = zero;
    const Correction& c = task.corrections[k];
    v[k] = c.step <= c.hi ? c.step : -c.step;
    const auto moved = judge.curves(v);
    if (moved.empty()) return zero;
    a.col(static_cast<Eigen::Index>(k)) = (column(moved) - y) / v[k];
  }
  const Eigen::VectorXd x = least_squares(a, -y);
  std::vector<double> v(n);
  for (std::size_t k = 0; k < n; ++k)
    v[k] =
        std::clamp(x[static_cast<Eigen::Index>(k)], task.corrections[k].lo, task.corrections[k].hi);
  return v;
}

std::vector<double> optimise(const std::vector<Correction>& box, Judge& judge, Minimiser how,
                             int evaluations, double step_factor, std::vector<double> v) {
  MinimiserTask search{.evaluations = evaluations,
                       .relative_gain = kLastGain,
                       .gain = judge.last_gain(),
                       .f = [&](const std::vector<double>& x) {
                         const double f = judge.value(x);
                         return std::isfinite(f) ? f : judge.lost();
                       }};
  // A search of the whole box by a model must not end early, because a narrow optimum may lie at
  // the border of the box.
  if (how == Minimiser::whole_box && judge.model().value) search.relative_gain = search.gain = 0.0;
  for (const Correction& c : box) {
    search.lo.push_back(c.lo);
    search.hi.push_back(c.hi);
    search.step.push_back(c.step * step_factor);
  }
  return minimise(how, search, std::move(v));
}

// The part of the bounds within which the result of a search by models is improved with more
// positions.
constexpr double kFineReach = 0.03;
// Rounding a value, or setting a value to 0, may lose at most this fraction of the gain.
constexpr double kPartLost = 0.01;

// The best corrections so far, and the value of f (or of the aim) for them.
struct Best {
  Judge& judge;
  std::vector<double> v;
  double least;

  Best(Judge& j, std::vector<double> start)
      : judge(j), v(std::move(start)), least(judge.value(v)) {}
  void take(const std::vector<double>& other) {
    const double f = judge.value(other);
    if (!(f < least)) return;
    least = f;
    v = other;
  }
};

// Descends on the model of the judge from `start` within the box.
std::vector<double> descended(const std::vector<Correction>& box, const Judge& judge, double radius,
                              const std::vector<double>& start) {
  MinimaxTask task{.radius = radius, .relative_gain = kLastPromise, .f = judge.model().tangents};
  for (const Correction& c : box) {
    task.lo.push_back(c.lo);
    task.hi.push_back(c.hi);
  }
  return minimax_descent(task, start);
}

// Searches the whole box, descends from several starts, and returns the best corrections.
std::vector<double> searched(const CompensationTask& task, Judge& judge) {
  const std::vector<double> zero(task.corrections.size(), 0.0);
  Best best(judge, zero);
  if (best.least < judge.same()) return zero;
  const int n = static_cast<int>(zero.size());
  // The program spends most of its time on TE curves, so their total number is limited. This limit
  // is the same for any number of scenarios. A search also ends after 400 evaluations per
  // correction.
  const int budget = std::clamp(task.curves / task.scenarios, 1, 400 * n);
  std::vector<std::vector<double>> starts = task.starts;
  starts.push_back(zero);
  starts.push_back(linearised(task, judge));
  starts.push_back(optimise(task.corrections, judge, Minimiser::whole_box, budget, 1.0, zero));
  for (std::vector<double>& start : starts) {
    for (std::size_t k = 0; k < start.size(); ++k)
      start[k] = std::clamp(start[k], task.corrections[k].lo, task.corrections[k].hi);
    best.take(start);
    best.take(judge.model().tangents
                  ? descended(task.corrections, judge, 0.25, start)
                  : optimise(task.corrections, judge, Minimiser::downhill, budget, 1.0, start));
  }
  if (judge.model().tangents) return best.v;
  // A search may have stopped at a crease of f, so the search is repeated with smaller steps.
  for (const double step : {1.0, 0.1, 0.01})
    best.take(optimise(task.corrections, judge, Minimiser::downhill, budget, step, best.v));
  return best.v;
}

// Works like searched(), but evaluates the estimate of the aim instead of the aim. The search is
// then repeated around the best corrections, with the estimate that is exact for them. Without an
// estimate, or if the aim without corrections is not finite, searched() is used.
std::vector<double> searched_nearby(const CompensationTask& task, Judge& judge) {
  const std::vector<double> zero(task.corrections.size(), 0.0);
  if (!judge.has_near()) return searched(task, judge);
  const Judge::Model first = judge.near(zero);
  if (!std::isfinite(first.value(zero))) return searched(task, judge);
  const auto found = detail::lowest_by_models(
      zero, judge.same(),
      [&](const std::vector<double>& at) { return at == zero ? first : judge.near(at); },
      [](const Judge::Model& model, const std::vector<double>& v) { return model.value(v); },
      [&](const Judge::Model& model, const std::vector<double>& at, double reach) {
        judge.use(model);
        if (reach == 1.0) return searched(task, judge);
        return descended(detail::around(task.corrections, reach, at), judge, 0.5, at);
      });
  judge.use({});
  return found;
}

// Returns the final corrections. They are computed with as many positions as the reported scores,
// because a peak of TE may lie between the positions of the coarser search.
std::vector<double> settled(const CompensationTask& task, Judge& fine, std::vector<double> found) {
  const std::vector<double> zero(task.corrections.size(), 0.0);
  if (fine.has_near()) found = as_written(task.corrections, found, 1e4);
  Best best(fine, zero);
  const double none = best.least;
  if (found != zero) {
    if (fine.has_near()) fine.use(fine.near(found));
    best.take(found);
    const int most = 60 * static_cast<int>(found.size());
    const int budget = std::clamp(task.curves / (6 * task.scenarios), 1, most);
    if (fine.has_near())
      best.take(descended(detail::around(task.corrections, kFineReach, found), fine, 0.5, found));
    else
      for (const double step : {0.3, 0.03})
        best.take(optimise(task.corrections, fine, Minimiser::downhill, budget, step, best.v));
  }
  const double same = fine.same();
  if (!(best.least < none - same)) return zero;
  const double loss = std::max(same, std::isfinite(none) ? kPartLost * (none - best.least) : same);
  for (const double parts : {1e2, 1e4, 1e6}) {
    // Rounding may move a value across a crease of f, so the neighbours of each value are tried.
    Best drawn(fine, as_written(task.corrections, best.v, parts));
    for (std::size_t k = 0; k < found.size(); ++k) {
      for (const double away : {-1.0, 1.0}) {
        std::vector<double> next = drawn.v;
        next[k] += away * task.corrections[k].step / parts;
        drawn.take(as_written(task.corrections, next, parts));
      }
    }
    if (drawn.least > best.least + loss || !(drawn.least < none - same)) continue;
    best.v = drawn.v;
    break;
  }
  if (!fine.has_near()) return best.v;
  // The last steps used estimates, which are exact for the result of the search only. The final
  // choice compares the exact values of three cases: the result of the last steps, the result of
  // the search, and no corrections.
  const double searched = fine.value(found);
  fine.use({});
  const double refined = fine.value(best.v);
  if (!(std::min(refined, searched) < none - same)) return zero;
  return searched < refined - same ? found : best.v;
}

// Returns `found` without the corrections that are not needed. Beginning with the last one, the
// function sets each correction to 0 and searches the others again. If f then does not exceed
// `limit`, the correction remains 0. At least one correction is kept.
std::vector<double> fewest(const CompensationTask& task, Judge& coarse, Judge& fine,
                           std::vector<double> found) {
  const std::size_t n = found.size();
  std::vector<std::size_t> used;
  for (std::size_t k = 0; k < n; ++k)
    if (found[k] != 0.0) used.push_back(k);
  const double gain = fine.value(std::vector<double>(n, 0.0)) - fine.value(found);
  const double limit =
      fine.value(found) + fine.same() + (std::isfinite(gain) ? kPartLost * gain : 0.0);
  for (std::size_t i = used.size(); i-- > 0 && used.size() > 1;) {
    std::vector<std::size_t> fewer = used;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    const auto all = [fewer, n](const std::vector<double>& v) {
      std::vector<double> whole(n, 0.0);
      for (std::size_t k = 0; k < fewer.size(); ++k) whole[fewer[k]] = v[k];
      return whole;
    };
    const auto part = [&](const auto& whole) {
      std::remove_cvref_t<decltype(whole)> some;
      for (const std::size_t k : fewer) some.push_back(whole[k]);
      return some;
    };
    CompensationTask reduced = task;
    reduced.corrections = part(task.corrections);
    for (std::vector<double>& start : reduced.starts) start = part(start);
    reduced.starts.push_back(part(found));
    reduced.pair_at = [&task, all](const std::vector<double>& v, int s) {
      return task.pair_at(all(v), s);
    };
    Judge search(reduced, coarse.positions()), last(reduced, fine.positions());
    const auto alone = all(settled(reduced, last, searched(reduced, search)));
    if (fine.value(alone) > limit) continue;
    used = std::move(fewer);
    found = alone;
  }
  return found;
}

}  // namespace

bool Compensation::nothing_to_correct() const {
  return std::all_of(value.begin(), value.end(), [](double v) { return v == 0.0; });
}

Angle default_centering(Angle peak_to_peak) {
  constexpr double kPart = 0.1;
  constexpr Angle kLeast = Angle::arcseconds(0.1);
  // If the peak to peak is NaN, the comparison is false and the result is kLeast.
  return peak_to_peak > kLeast / kPart ? kPart * peak_to_peak : kLeast;
}

std::vector<double> as_written(const std::vector<Correction>& corrections,
                               std::vector<double> values, double parts) {
  GW_EXPECTS(values.size() == corrections.size() && parts > 0.0);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const Correction& c = corrections[k];
    const double per_unit = parts / c.step;
    double n = std::round(values[k] * per_unit);
    if (n / per_unit > c.hi) --n;
    if (n / per_unit < c.lo) ++n;
    values[k] = n == 0.0 ? 0.0 : n / per_unit;
  }
  return values;
}

Compensation compensate(const CompensationTask& given) {
  GW_EXPECTS(!given.corrections.empty() && given.scenarios >= 1);
  GW_EXPECTS(given.positions >= 2 && given.fine_positions >= 2);
  for (const Correction& c : given.corrections)
    GW_EXPECTS(c.lo <= 0.0 && c.hi >= 0.0 && c.lo < c.hi && c.step > 0.0);
  const CompensationTask task = detail::within_teeth(given);
  const std::vector<double> zero(task.corrections.size(), 0.0);
  // The usual number of evaluations in one search of the box and a descent from every start. Most
  // descents end early.
  constexpr std::int64_t kUsual = 1000;
  begin_stage(task.progress, "trying corrections", kUsual);
  Judge coarse(task, task.positions);
  Judge fine(task, task.fine_positions);
  Compensation result;
  result.value = settled(task, fine, searched_nearby(task, coarse));
  if (!task.aim) result.value = fewest(task, coarse, fine, result.value);
  result.centering = fine.centering();
  for (const ContactCurve& c : fine.curves(zero)) {
    result.each_before.push_back(c.score);
    take_worst(result.before, c.score);
  }
  for (const ContactCurve& c : fine.curves(result.value)) {
    result.each_after.push_back(c.score);
    take_worst(result.after, c.score);
  }
  return result;
}

}  // namespace gearwright
