#include "gearwright/scatter/sample_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "gearwright/base/units.hpp"

namespace gearwright {

std::vector<Warning> sample_warnings(const Scatter& scatter) {
  // Edge contact is reported if more than this share of the samples have it: one gear pair in
  // twenty.
  constexpr double kOftenEdge = 0.05;
  std::vector<Warning> warnings;
  const auto warn = [&](WarningCode code, std::string message) {
    warnings.push_back({code, std::move(message)});
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
  return warnings;
}

}  // namespace gearwright
