#include "gearwright/scatter/pattern_density.hpp"

#include "gearwright/base/contract.hpp"
#include "gearwright/base/parallel.hpp"
#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

PatternDensity pattern_density(const ContactSetup& setup, const ScatterTask& task,
                               const Scatter& scatter, const DensityRequest& request) {
  GW_EXPECTS(request.marking > 0.0 && request.samples <= task.samples);
  const auto each = static_cast<std::size_t>(request.samples);
  const auto all = static_cast<std::size_t>(task.samples);
  const std::size_t count = each * static_cast<std::size_t>(task.replicates);
  GW_EXPECTS(scatter.samples.size() == all * static_cast<std::size_t>(task.replicates));
  begin_stage(task.progress, "computing the density of the contact pattern",
              static_cast<std::int64_t>(count));
  std::vector<std::array<FlankRaster, 2>> rasters(count);
  parallel_for(
      count,
      [&](std::size_t i) {
        const ScatterSample& sample = scatter.samples[i / each * all + i % each];
        const Deviation deviation = deviation_at(setup, task.tolerances, sample.x);
        const MemberSetup member(setup, deviation);
        rasters[i] = contact_pattern((*member).pair(deviation.errors, task.member.gear2_drives),
                                     request.positions, request.size);
        count_step(task.progress);
      },
      task.threads);
  PatternDensity density{request.marking, static_cast<std::int64_t>(count), {}};
  for (std::size_t which = 0; which < 2; ++which) {
    FlankDensity& flank = density.flanks[which];
    flank.diameter = rasters[0][which].diameter;
    flank.height = rasters[0][which].height;
    flank.count.assign(rasters[0][which].gap.size(), 0);
    flank.side = setup.gear(static_cast<int>(which) + 1).side();
    for (const auto& raster : rasters)
      for (std::size_t k = 0; k < flank.count.size(); ++k)
        flank.count[k] += raster[which].gap[k] <= request.marking ? 1 : 0;
  }
  return density;
}

}  // namespace gearwright
