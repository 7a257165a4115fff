#include "gearwright/scatter/robust.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "gearwright/base/units.hpp"
#include "gearwright/math/minimise.hpp"
#include "gearwright/scatter/sample_points.hpp"

namespace gearwright {

namespace {

constexpr int kCoarseSamples = 128;    // for the search of the whole box
constexpr int kFineSamples = 1024;     // for the descent and the comparison
constexpr double kFirstRadius = 0.25;  // relative to the bounds: initial trust radius of the
                                       // linearised problem
constexpr double kLastRadius = 1e-3;
constexpr int kMostSteps = 20;
constexpr double kGain = 1e-4 * kRadPerArcsec;  // a search ends when the gain is smaller
constexpr double kParts = 100;                  // the values are rounded to a step/100

// The mean of the worst share 1 − p, with the sample at the border counted in part.   [T14.17]
double mean_of_worst(std::vector<double> f, double p) {
  const double worst = (1.0 - p) * static_cast<double>(f.size());
  const auto whole = std::min(static_cast<std::size_t>(worst), f.size() - 1);
  std::nth_element(f.begin(), f.begin() + static_cast<std::ptrdiff_t>(whole), f.end(),
                   std::greater<>());
  std::sort(f.begin(), f.begin() + static_cast<std::ptrdiff_t>(whole));
  double sum = (worst - static_cast<double>(whole)) * f[whole];
  for (std::size_t i = 0; i < whole; ++i) sum += f[i];
  return sum / worst;
}

// Peak to peak of the first samples of the family as a function of the corrections.
class Family {
 public:
  Family(const ContactSetup& setup, const ScatterTask& task, const RobustTask& robust, int samples)
      : setup_(setup), task_(task), robust_(robust), places_(SamplePoints(task).first(0, samples)) {
    for (const WorkshopCorrection& c : robust.corrections) {
      if (const auto influence = influence_of(c)) influences_.push_back(*influence);
    }
  }

  struct Values {
    std::vector<double> f;
    std::vector<std::vector<double>> slope;  // by sample and correction, rad per unit of the
                                             // correction
  };

  Values at(const std::vector<double>& v, bool slopes = false) const {
    Values values;
    const auto changed =
        setup_.changed(change_of(robust_.corrections, v, task_.member.gear2_drives));
    if (!changed || check_ends(*changed, task_.tolerances)) {
      const std::vector<double> none(v.size(), 0.0);
      return {std::vector<double>(places_.size(), kLostSpan), {places_.size(), none}};
    }
    const auto spans =
        spans_at(*changed, task_, places_, slopes ? influences_ : std::vector<Influence>{});
    values.f = ranked(spans);
    if (slopes) add_slopes(values, v, spans);
    return values;
  }

  double percentile(const std::vector<double>& v) const {
    std::vector<double> f = at(v).f;
    std::sort(f.begin(), f.end());
    return quantile(f, p());
  }
  double p() const { return robust_.percent / 100.0; }

 private:
  // Flank corrections have exact slopes; for settings of a tool differences are used.
  void add_slopes(Values& values, const std::vector<double>& v,
                  const std::vector<MemberSpan>& spans) const {
    values.slope.assign(spans.size(), std::vector<double>(v.size()));
    std::size_t next = 0;
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (influence_of(robust_.corrections[i])) {
        for (std::size_t k = 0; k < spans.size(); ++k)
          values.slope[k][i] = spans[k].slope[next] * kMmPerUm;
        ++next;
        continue;
      }
      const Correction& c = robust_.bounds[i];
      std::vector<double> w = v;
      w[i] += v[i] + c.step / kParts <= c.hi ? c.step / kParts : -c.step / kParts;
      const std::vector<double> moved = at(w).f;
      for (std::size_t k = 0; k < spans.size(); ++k)
        values.slope[k][i] = (moved[k] - values.f[k]) / (w[i] - v[i]);
    }
  }

  const ContactSetup& setup_;
  const ScatterTask& task_;
  const RobustTask& robust_;
  std::vector<std::vector<double>> places_;
  std::vector<Influence> influences_;
};

MinimiserTask search_of(const RobustTask& robust, int evaluations, double step,
                        std::function<double(const std::vector<double>&)> f) {
  MinimiserTask search{.evaluations = evaluations, .gain = kGain, .f = std::move(f)};
  for (const Correction& c : robust.bounds) {
    search.lo.push_back(c.lo);
    search.hi.push_back(c.hi);
    search.step.push_back(step * (c.hi - c.lo));
  }
  return search;
}

// Descent of the CVaR: minimum of the linearised problem within a radius, which grows or shrinks
// with success.   [T14.18]
std::vector<double> descend(const Family& family, const RobustTask& robust, std::vector<double> v) {
  double radius = kFirstRadius;
  Family::Values here = family.at(v, true);
  double worth = mean_of_worst(here.f, family.p());
  for (int step = 0; step < kMostSteps && radius >= kLastRadius; ++step) {
    MinimiserTask model = search_of(robust, 200 * static_cast<int>(v.size()), 0.5 * radius,
                                    [&](const std::vector<double>& w) {
                                      std::vector<double> f = here.f;
                                      for (std::size_t k = 0; k < f.size(); ++k)
                                        for (std::size_t i = 0; i < v.size(); ++i)
                                          f[k] += here.slope[k][i] * (w[i] - v[i]);
                                      return mean_of_worst(std::move(f), family.p());
                                    });
    for (std::size_t i = 0; i < v.size(); ++i) {
      const double reach = radius * (model.hi[i] - model.lo[i]);
      model.lo[i] = std::max(model.lo[i], v[i] - reach);
      model.hi[i] = std::min(model.hi[i], v[i] + reach);
    }
    const std::vector<double> next = minimise(Minimiser::downhill, model, v);
    const double promised = worth - model.f(next);
    if (!(promised > kGain)) break;
    const double gained = worth - mean_of_worst(family.at(next).f, family.p());
    if (gained < 0.25 * promised) radius *= 0.35;
    if (gained > 0.75 * promised) radius = std::min(1.0, 2.0 * radius);
    if (!(gained > 0.0)) continue;
    v = next;
    here = family.at(v, true);
    worth = mean_of_worst(here.f, family.p());
  }
  return v;
}

std::vector<double> searched(const Family& coarse, const Family& fine, const RobustTask& robust) {
  const int n = static_cast<int>(robust.corrections.size());
  const std::vector<double> zero(robust.corrections.size(), 0.0);
  const auto box = search_of(robust, 40 * n, kFirstRadius,
                             [&](const std::vector<double>& v) { return coarse.percentile(v); });
  std::vector<double> best = zero;
  double least = fine.percentile(zero);
  const auto take = [&](const std::vector<double>& v) {
    const double f = fine.percentile(v);
    if (!(f < least)) return;
    least = f;
    best = v;
  };
  const std::vector<double> of_box = minimise(Minimiser::whole_box, box, zero);
  take(of_box);
  for (const auto& start : {zero, of_box}) take(descend(fine, robust, start));
  const auto polish = search_of(robust, 15 * n, 0.02,
                                [&](const std::vector<double>& v) { return fine.percentile(v); });
  take(minimise(Minimiser::downhill, polish, best));
  return as_written(robust.bounds, best, kParts);
}

}  // namespace

Result<RobustCorrections> robust_corrections(const ContactSetup& drawn, const ScatterTask& task,
                                             const RobustTask& robust) {
  GW_EXPECTS(!robust.corrections.empty() && robust.bounds.size() == robust.corrections.size());
  std::array<bool, 2> wanted{};
  for (const WorkshopCorrection& c : robust.corrections)
    if (influence_of(c)) wanted[static_cast<std::size_t>(c.gear - 1)] = true;
  const ContactSetup setup = drawn.with_fields(wanted);
  ScatterTask judged = task;
  judged.percentiles = {robust.percent};
  judged.indices = judged.worst_case = false;
  judged.load.reset();
  judged.seed = task.seed + 1;
  RobustCorrections found{std::vector<double>(robust.corrections.size(), 0.0), {}, {}};
  auto before = scatter_of(drawn, judged);
  if (!before) return before.error();
  found.before = found.after = std::move(before).take();
  const auto spread = [](const Scatter& s) {
    return s.spread[static_cast<std::size_t>(ScatterQuantity::peak_to_peak)].has_value();
  };
  if (!spread(found.before))
    return Error{"percentile", "", "cannot be computed, because contact is lost in every sample"};
  const int samples = std::min(task.samples, kFineSamples);
  const Family coarse(setup, task, robust, std::min(samples, kCoarseSamples));
  const Family fine(setup, task, robust, samples);
  // Two descents of about ten steps, the box and the polish.
  begin_stage(task.progress, "corrections for the percentile",
              static_cast<std::int64_t>(robust.corrections.size()) *
                  (40 * std::min(samples, kCoarseSamples) + 55 * samples));
  const std::vector<double> value = searched(coarse, fine, robust);
  const auto changed =
      setup.changed(change_of(robust.corrections, value, task.member.gear2_drives));
  if (!changed || check_ends(*changed, task.tolerances)) return found;
  auto after = scatter_of(*changed, judged);
  if (!after || !spread(*after)) return found;
  const auto percentile = [](const Scatter& s) {
    return RobustCorrections::percentile(s).estimate.value;
  };
  if (after->contact_lost.count > found.before.contact_lost.count ||
      !(percentile(*after) < percentile(found.before) - kSameError.rad()))
    return found;
  found.value = value;
  found.after = std::move(after).take();
  return found;
}

}  // namespace gearwright
