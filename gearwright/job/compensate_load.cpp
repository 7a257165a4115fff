#include "gearwright/job/compensate_load.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace gearwright {

namespace {

constexpr double kSamePressure = 0.1;  // MPa; one ten-thousandth of usual flank pressures

}  // namespace

Result<LoadedAim> LoadedAim::of(SolvedJob& job, Progress* progress) {
  auto made = load_task(job);
  if (!made) return made.error();
  Held held{std::move(made).take(), {}, job.spec.compensate.aim};
  LoadRequest& request = held.task.request;
  request.rotations.clear();
  request.root_stress = false;
  request.progress = progress;
  auto compliance = held.task.compliance();
  if (!compliance) return compliance.error();
  held.compliance = std::move(compliance).take();
  request.progress = nullptr;        // progress counts trials, not their positions
  std::vector<Warning> of_the_pair;  // warnings about the uncorrected pair, which are not reported
  if (auto error = judge_load(held.task, held.task.contact(held.compliance), of_the_pair))
    return *error;
  return LoadedAim(std::make_shared<const Held>(std::move(held)));
}

std::vector<LoadedScore> LoadedAim::scores(const ContactPair& pair, int positions) const {
  const LoadTask& task = held_->task;
  LoadRequest request = task.request;
  request.positions = positions;
  return loaded_scores(
      loaded_contact(pair, task.setup.gear(1), task.setup.gear(2), held_->compliance, request));
}

CompensationAim LoadedAim::aim() const {
  const bool pressure = held_->aim == CompensateAim::pressure;
  return {[self = *this, pressure](const ContactPair& pair, int positions) {
            const auto scores = self.scores(pair, positions);
            if (scores.empty()) return std::numeric_limits<double>::infinity();
            double worst = 0.0;
            for (const LoadedScore& s : scores)
              worst = std::max(worst, pressure ? s.max_pressure : s.peak_to_peak.rad());
            return worst;
          },
          pressure ? kSamePressure : kSameError.rad()};
}

}  // namespace gearwright
