#include "gearwright/job/scatter_findings.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

// If a greater share of samples has edge contact, this is a finding: one of twenty gear pairs.
constexpr double kOftenEdge = 0.05;

}  // namespace

void warn_of_samples(const Scatter& scatter, SolvedJob& job) {
  const auto warn = [&](WarningCode code, std::string message) {
    job.warnings.push_back({code, std::move(message)});
  };
  if (scatter.jam.count > 0) {
    double least = 0.0;
    for (const ScatterSample& sample : scatter.samples)
      if (sample.member.jam) least = std::min(least, sample.member[ScatterQuantity::least_play]);
    warn(WarningCode::samples_jam,
         fmt::format(
             "The gears jam in {} of {} samples. The least play of gear 2 is {:.5f} degrees.",
             scatter.jam.count, scatter.jam.of, least * kDegPerRad));
  }
  if (scatter.edge_contact.value > kOftenEdge)
    warn(WarningCode::samples_touch_edges,
         fmt::format(
             "An edge of a tooth is in contact in {} of {} samples. Edge contact causes high "
             "pressure.",
             scatter.edge_contact.count, scatter.edge_contact.of));
  if (scatter.contact_lost.count > 0)
    warn(WarningCode::samples_lose_contact,
         fmt::format("Contact is lost at some positions of {} of {} samples.",
                     scatter.contact_lost.count, scatter.contact_lost.of));
  const PairInput& pair = job.completed.pair;
  if (job.spec.scatter.bearings && (pair.distance_tolerance || pair.distance_deviations))
    warn(WarningCode::not_read,
         "The tolerance of the centre distance is not varied, because the bores of "
         "[scatter.bearings] determine the centre distance. A greater radius_mm includes it.");
}

}  // namespace gearwright
