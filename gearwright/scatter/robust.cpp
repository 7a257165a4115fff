#include "gearwright/scatter/robust.hpp"

#include <algorithm>

#include "gearwright/base/units.hpp"
#include "gearwright/scatter/robust_load.hpp"
#include "gearwright/scatter/robust_search.hpp"
#include "gearwright/scatter/sample_points.hpp"

namespace gearwright {

namespace {

constexpr int kCoarseSamples = 128;  // limit of the samples in the search of the whole box
constexpr int kFineSamples = 1024;   // limit of the samples in the descent and the comparison

// Peak to peak of rigid teeth in the first samples of the family.
class RigidFamily final : public CorrectedFamily {
 public:
  RigidFamily(const ContactSetup& setup, const ScatterTask& task, const RobustTask& robust,
              int samples)
      : setup_(setup), task_(task), robust_(robust), places_(SamplePoints(task).first(0, samples)) {
    for (std::size_t i = 0; i < robust.corrections.size(); ++i) {
      // continuous_peak_to_peak() has no derivatives for double-helical pairs.
      const auto influence = influence_of(robust.corrections[i]);
      if (!influence || task.member.stagger) continue;
      exact_.push_back(i);
      influences_.push_back(*influence);
    }
  }

  Values at(const std::vector<double>& v, bool slopes) const override {
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

 private:
  // Corrections that remove material from flanks have exact slopes. For tool settings, cutter leads
  // and double-helical pairs, difference quotients are used.
  void add_slopes(Values& values, const std::vector<double>& v,
                  const std::vector<MemberSpan>& spans) const {
    values.slope.assign(spans.size(), std::vector<double>(v.size()));
    std::size_t next = 0;
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (next == exact_.size() || exact_[next] != i) {
        add_difference(values, *this, v, i, robust_.bounds[i]);
        continue;
      }
      for (std::size_t k = 0; k < spans.size(); ++k)
        values.slope[k][i] = spans[k].slope[next] * kMmPerUm;
      ++next;
    }
  }

  const ContactSetup& setup_;
  const ScatterTask& task_;
  const RobustTask& robust_;
  std::vector<std::vector<double>> places_;
  std::vector<std::size_t> exact_;     // corrections with exact slopes, in ascending order
  std::vector<Influence> influences_;  // influences of the corrections in exact_
};

std::vector<double> rigid_corrections(const ContactSetup& setup, const ScatterTask& task,
                                      const RobustTask& robust) {
  const int samples = std::min(task.samples, kFineSamples);
  const RigidFamily coarse(setup, task, robust, std::min(samples, kCoarseSamples));
  const RigidFamily fine(setup, task, robust, samples);
  // This estimate covers two descents of about ten steps, the search of the box, and the final
  // local search.
  begin_stage(task.progress, "searching for corrections that reduce the percentile",
              static_cast<std::int64_t>(robust.corrections.size()) *
                  (40 * std::min(samples, kCoarseSamples) + 55 * samples));
  constexpr double kGain = 1e-4 * kRadPerArcsec;
  return lowest_percentile({coarse, fine, robust.bounds, robust.percent / 100.0, kGain, true},
                           std::vector<double>(robust.corrections.size(), 0.0));
}

Error no_percentile(const char* reason) {
  return Error{"scatter.robust", "", std::string("cannot be computed, because ") + reason};
}

Result<JudgedFamily> judged_rigid(const ContactSetup& setup, const ScatterTask& judged) {
  auto scatter = scatter_of(setup, judged);
  if (!scatter) return scatter.error();
  const auto& spread = scatter->spread[static_cast<std::size_t>(ScatterQuantity::peak_to_peak)];
  if (!spread) return no_percentile("contact is lost in every sample");
  JudgedFamily family{{}, *spread, scatter->edge_contact, scatter->contact_lost, {}};
  for (const ScatterSample& s : scatter->samples) family.x.push_back(s.x);
  return family;
}

}  // namespace

Result<RobustCorrections> robust_corrections(const ContactSetup& drawn, const ScatterTask& task,
                                             const RobustTask& robust) {
  GW_EXPECTS(!robust.corrections.empty() && robust.bounds.size() == robust.corrections.size());
  const ContactSetup setup = with_fields_for(drawn, robust.corrections);
  ScatterTask judged = task;
  judged.percentiles = {robust.percent};
  judged.indices = judged.worst_case = judged.loosening = false;
  judged.load.reset();
  judged.seed = task.seed + 1;
  const auto judge = [&](const ContactSetup& of) -> Result<JudgedFamily> {
    if (!robust.load) return judged_rigid(of, judged);
    auto family = judged_under_load(of, judged, *robust.load);
    if (!family) return no_percentile("no sample has a solution under load");
    return std::move(*family);
  };
  auto before = judge(drawn);
  if (!before) return before.error();
  RobustCorrections found{std::vector<double>(robust.corrections.size(), 0.0), *before, *before};
  std::vector<double> value = as_written(robust.bounds,
                                         robust.load ? corrections_under_load(setup, task, robust)
                                                     : rigid_corrections(setup, task, robust),
                                         kRobustParts);
  const auto changed =
      setup.changed(change_of(robust.corrections, value, task.member.gear2_drives));
  if (value == found.value || !changed || check_ends(*changed, task.tolerances)) return found;
  auto after = judge(*changed);
  if (!after || after->lost.count > found.before.lost.count ||
      !(after->percentile().estimate.value <
        found.before.percentile().estimate.value - kSameError.rad()))
    return found;
  found.value = std::move(value);
  found.after = std::move(after).take();
  return found;
}

}  // namespace gearwright
