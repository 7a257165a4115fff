#include "gearwright/scatter/loaded_family.hpp"

#include <algorithm>

#include "gearwright/base/parallel.hpp"
#include "gearwright/contact/halves.hpp"
#include "gearwright/load/loaded_halves.hpp"
#include "gearwright/scatter/spread.hpp"

namespace gearwright {

namespace {

std::vector<LoadedScore> member_under_load(const ContactSetup& drawn, const ScatterTask& task,
                                           const LoadedFamily& load, const std::vector<double>& x) {
  const Deviation deviation = deviation_at(drawn, task.tolerances, x);
  const MemberSetup setup(drawn, deviation);
  std::vector<LoadedContact> sides;
  for (const LoadedSide& side : loaded_sides(*setup, deviation.errors, task.member, load)) {
    LoadedTurn turn(*side.pair, (*setup).gear(1), (*setup).gear(2), load.compliance, side.request);
    turn.solve(0, turn.positions());
    sides.push_back(turn.result());
  }
  if (!load.second_half) return loaded_scores(sides[0]);
  return loaded_scores(whole_load({&sides.front(), &sides.back()}, (*setup).gear(1), true));
}

}  // namespace

std::vector<LoadedSide> loaded_sides(const ContactSetup& setup, const ContactErrors& errors,
                                     const MemberRequest& member, const LoadedFamily& load) {
  if (!load.second_half) return {{setup.shared_pair(errors, member.gear2_drives), load.request}};
  const double stagger = member.stagger.value();
  const HalvesPair both = HalvesSetup(setup, stagger).pair(errors, member.gear2_drives);
  std::vector<LoadedSide> sides{{both.half[0], load.request}, {both.half[1], *load.second_half}};
  LoadRequest& second = sides[1].request;
  second.rotations = rotations_of_second(setup.gear(1), stagger, {}, second.positions, 1);
  if (both.mesh.alike() && second.deflection_slope == load.request.deflection_slope)
    sides.pop_back();
  return sides;
}

std::vector<std::vector<LoadedScore>> scores_under_load(const ContactSetup& setup,
                                                        const ScatterTask& task,
                                                        const LoadedFamily& load,
                                                        const std::vector<std::vector<double>>& x) {
  std::vector<std::vector<LoadedScore>> scores(x.size());
  parallel_for(
      x.size(),
      [&](std::size_t i) {
        scores[i] = member_under_load(setup, task, load, x[i]);
        count_step(task.progress);
      },
      task.threads);
  return scores;
}

SampleValues loaded_peaks(const std::vector<std::vector<LoadedScore>>& scores) {
  SampleValues peaks;
  for (const auto& s : scores) {
    std::optional<double>& worst = peaks.emplace_back();
    for (const LoadedScore& t : s) worst = std::max(worst.value_or(0.0), t.peak_to_peak.rad());
  }
  return peaks;
}

std::vector<LoadedSpread> spreads_under_load(const ScatterTask& task, const LoadedFamily& load,
                                             const std::vector<std::vector<LoadedScore>>& scores) {
  std::vector<LoadedSpread> all;
  for (std::size_t k = 0; k < load.request.torques.size(); ++k) {
    LoadedSpread of{load.torque(k), {}, {}, {}, {}, {}};
    const auto spread = [&](auto value, double least = 0.0) {
      SampleValues values(scores.size());
      for (std::size_t i = 0; i < scores.size(); ++i)
        if (!scores[i].empty()) values[i] = value(scores[i][k]);
      return spread_of(task, values, load.samples, {.least = least});
    };
    of.peak_to_peak = spread([](const LoadedScore& s) { return s.peak_to_peak.rad(); });
    of.max_pressure = spread([](const LoadedScore& s) { return s.max_pressure; });
    of.face_load_factor = spread([](const LoadedScore& s) { return s.face_load_factor; }, 1.0);
    of.edge_carries = share_of(scores, task.confidence,
                               [&](const auto& s) { return !s.empty() && s[k].edge_carries; });
    of.unsolved = share_of(scores, task.confidence, [](const auto& s) { return s.empty(); });
    all.push_back(std::move(of));
  }
  return all;
}

std::vector<LoadedSpread> loaded_spreads(const ContactSetup& setup, const ScatterTask& task,
                                         const std::vector<ScatterSample>& samples) {
  GW_EXPECTS(task.load && task.load->samples >= 1 && task.load->samples <= task.samples);
  const auto few = static_cast<std::size_t>(task.load->samples);
  const std::size_t count = few * static_cast<std::size_t>(task.replicates);
  const auto sample_of = [&](std::size_t i) {
    return i / few * static_cast<std::size_t>(task.samples) + i % few;
  };
  std::vector<std::vector<double>> x;
  for (std::size_t i = 0; i < count; ++i) x.push_back(samples[sample_of(i)].x);
  begin_stage(task.progress, "computing the samples under load", static_cast<std::int64_t>(count));
  auto all = spreads_under_load(task, *task.load, scores_under_load(setup, task, *task.load, x));
  for (LoadedSpread& of : all)
    for (auto* spread : {&of.peak_to_peak, &of.max_pressure, &of.face_load_factor})
      if (*spread)
        for (Percentile& p : (*spread)->percentiles) p.sample = sample_of(p.sample);
  return all;
}

}  // namespace gearwright
