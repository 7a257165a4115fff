#include "gearwright/scatter/robust_load.hpp"

#include <algorithm>
#include <memory>

#include "gearwright/base/parallel.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/contact/center_search.hpp"
#include "gearwright/load/nearby_load.hpp"
#include "gearwright/scatter/loaded_family.hpp"
#include "gearwright/scatter/robust_search.hpp"
#include "gearwright/scatter/sample_points.hpp"
#include "gearwright/scatter/spread.hpp"

namespace gearwright {

namespace {

// Greatest numbers of samples in the search of the whole box and in all other steps.
constexpr int kCoarseLoaded = 16, kFineLoaded = 64;
constexpr int kPositions = 16;              // per pitch during the search, as in `compensate`
constexpr double kGain = kSameError.rad();  // smallest gain worth another step

// True if every trial repeats the whole contact computation, so that the results are exact.
bool exact_trials(const LoadedFamily& load, const RobustTask& robust) {
  return load.request.regime == LoadRegime::point || !influences_of(robust.corrections);
}

// The family with corrections near a center. If the contact is line contact and every correction
// has an influence, the contact is computed only at the center. Each trial then changes the gaps
// and recomputes only the forces. In all other cases, each trial repeats the whole contact
// computation.
class LoadedTrials final : public CorrectedFamily {
 public:
  LoadedTrials(const ContactSetup& setup, const ScatterTask& task, const RobustTask& robust,
               const LoadedFamily& load, std::vector<std::vector<double>> places,
               std::vector<double> center)
      : setup_(setup),
        task_(task),
        robust_(robust),
        load_(load),
        places_(std::move(places)),
        center_(std::move(center)),
        near_(places_.size()) {
    if (exact_trials(load_, robust_)) return;
    const std::vector<Influence> influences = *influences_of(robust.corrections);
    const auto changed = corrected(center_);
    if (!changed) return;
    parallel_for(
        places_.size(),
        [&](std::size_t i) {
          const Deviation deviation = deviation_at(*changed, task_.tolerances, places_[i]);
          const MemberSetup member(*changed, deviation);
          for (const LoadedSide& side :
               loaded_sides(*member, deviation.errors, task_.member, load_))
            near_[i].emplace_back(*side.pair, (*member).gear(1), (*member).gear(2),
                                  load_.compliance, side.request, influences);
          count_step(task_.progress);
        },
        task_.threads);
  }

  Values at(const std::vector<double>& v, bool slopes) const override {
    Values values{std::vector<double>(places_.size(), kLostSpan), {}};
    if (slopes) values.slope.assign(places_.size(), std::vector<double>(v.size(), 0.0));
    const auto changed = corrected(v);
    if (!changed) return values;
    if (exact_trials(load_, robust_)) {
      const auto peaks = loaded_peaks(scores_under_load(*changed, task_, load_, places_));
      for (std::size_t i = 0; i < peaks.size(); ++i) values.f[i] = peaks[i].value_or(kLostSpan);
      for (std::size_t i = 0; slopes && i < v.size(); ++i)
        add_difference(values, *this, v, i, robust_.bounds[i]);
      return values;
    }
    std::vector<double> change;
    for (std::size_t i = 0; i < v.size(); ++i) change.push_back((v[i] - center_[i]) * kMmPerUm);
    parallel_for(
        places_.size(),
        [&](std::size_t k) {
          if (near_[k].empty()) return;
          const NearbyLoad::Span span = NearbyLoad::span(near_[k], change, slopes);
          count_step(task_.progress);
          if (!span.value) return;
          values.f[k] = *span.value;
          for (std::size_t i = 0; i < span.slope.size(); ++i)
            values.slope[k][i] = span.slope[i] * kMmPerUm;
        },
        task_.threads);
    return values;
  }

 private:
  std::optional<ContactSetup> corrected(const std::vector<double>& v) const {
    auto changed = setup_.changed(change_of(robust_.corrections, v, task_.member.gear2_drives));
    if (!changed || check_ends(*changed, task_.tolerances)) return std::nullopt;
    return std::move(changed).take();
  }

  const ContactSetup& setup_;
  const ScatterTask& task_;
  const RobustTask& robust_;
  const LoadedFamily& load_;
  std::vector<std::vector<double>> places_;
  std::vector<double> center_;
  std::vector<std::vector<NearbyLoad>> near_;  // one per sample, or one per half of each sample
};

class LoadSearch {
 public:
  LoadSearch(const ContactSetup& setup, const ScatterTask& task, const RobustTask& robust)
      : setup_(setup), task_(task), robust_(robust), load_(*robust.load) {
    for (LoadRequest* of : {&load_.request, load_.second_half ? &*load_.second_half : nullptr})
      if (of) of->positions = std::min(of->positions, kPositions);
  }

  // Returns the best corrections for these samples. The trials near a center use the contact
  // computed at this center. If the trials are exact, one center is sufficient.
  std::vector<double> lowest(const std::vector<std::vector<double>>& places,
                             std::vector<double> center) const {
    using Trials = std::unique_ptr<LoadedTrials>;
    const auto search = [&](const Trials& fine, const std::vector<double>& at, double reach) {
      const bool whole = reach == 1.0;
      const Trials coarse = whole ? trials(first(places), at) : nullptr;
      return lowest_percentile({whole ? *coarse : *fine, *fine,
                                detail::around(robust_.bounds, reach, at), p(), kGain, whole},
                               at);
    };
    if (exact_trials(load_, robust_)) return search(trials(places, center), center, 1.0);
    return detail::lowest_by_models(
        std::move(center), kGain, [&](const std::vector<double>& at) { return trials(places, at); },
        [&](const Trials& t, const std::vector<double>& v) { return t->percentile(v, p()); },
        search);
  }

  double percentile(const std::vector<std::vector<double>>& places,
                    const std::vector<double>& v) const {
    return trials(places, v)->percentile(v, p());
  }

 private:
  double p() const { return robust_.percent / 100.0; }
  static std::vector<std::vector<double>> first(const std::vector<std::vector<double>>& places) {
    const auto count = std::min<std::size_t>(places.size(), kCoarseLoaded);
    return {places.begin(), places.begin() + static_cast<std::ptrdiff_t>(count)};
  }
  std::unique_ptr<LoadedTrials> trials(const std::vector<std::vector<double>>& places,
                                       const std::vector<double>& center) const {
    return std::make_unique<LoadedTrials>(setup_, task_, robust_, load_, places, center);
  }

  const ContactSetup& setup_;
  const ScatterTask& task_;
  const RobustTask& robust_;
  LoadedFamily load_;
};

}  // namespace

std::vector<double> corrections_under_load(const ContactSetup& setup, const ScatterTask& task,
                                           const RobustTask& robust) {
  const std::size_t n = robust.corrections.size();
  const LoadSearch search(setup, task, robust);
  const auto places = SamplePoints(task).first(0, std::min(task.samples, kFineLoaded));
  begin_stage(task.progress, "searching for corrections that reduce the percentile under load",
              static_cast<std::int64_t>(n * places.size()) * 200);
  const std::vector<double> zero(n, 0.0);
  const auto drawn = static_cast<std::size_t>(coordinates_of(task.tolerances));
  const std::vector<double> nominal = search.lowest({std::vector<double>(drawn, 0.0)}, zero);
  const bool better = search.percentile(places, nominal) < search.percentile(places, zero);
  return search.lowest(places, better ? nominal : zero);
}

std::optional<JudgedFamily> judged_under_load(const ContactSetup& setup, const ScatterTask& judged,
                                              const LoadedFamily& load) {
  const SamplePoints points(judged);
  JudgedFamily family;
  for (int r = 0; r < judged.replicates; ++r)
    for (std::vector<double>& x : points.first(r, load.samples)) family.x.push_back(std::move(x));
  begin_stage(judged.progress, "computing the samples under load",
              static_cast<std::int64_t>(family.x.size()));
  const auto scores = scores_under_load(setup, judged, load, family.x);
  auto spread = spread_of(judged, loaded_peaks(scores), load.samples, kNotNegative);
  if (!spread) return std::nullopt;
  family.peak_to_peak = std::move(*spread);
  family.loaded = spreads_under_load(judged, load, scores);
  family.edge = share_of(scores, judged.confidence, [](const auto& s) {
    return std::any_of(s.begin(), s.end(), [](const LoadedScore& t) { return t.edge_carries; });
  });
  family.lost = share_of(scores, judged.confidence, [](const auto& s) { return s.empty(); });
  return family;
}

}  // namespace gearwright
