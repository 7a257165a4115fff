#include "gearwright/scatter/sample_points.hpp"

#include <fmt/format.h>

#include "gearwright/base/parallel.hpp"

namespace gearwright {

std::optional<Error> check_family(const ContactSetup& setup,
                                  const std::vector<ScatterTolerance>& tolerances) {
  const int d = coordinates_of(tolerances);
  if (2 * d > SobolPoints::kMaxDimensions) {
    return refused("scatter", d,
                   fmt::format("must not have more than {} coordinates in total, because Sobol's "
                               "points are tabulated only up to this number",
                               SobolPoints::kMaxDimensions / 2));
  }
  return check_ends(setup, tolerances);
}

SamplePoints::SamplePoints(const ScatterTask& task)
    : task_(task),
      dimensions_(coordinates_of(task.tolerances)),
      points_(2 * dimensions_),
      copula_(task.tolerances, task.correlations) {}

std::vector<double> SamplePoints::from(int first_coordinate, int replicate, std::uint32_t n) const {
  std::vector<double> u;
  for (int j = first_coordinate; j < first_coordinate + dimensions_; ++j) {
    const std::uint64_t key = scramble_key(task_.seed, replicate, j);
    u.push_back(task_.sampling == Sampling::random
                    ? random_unit(key, n)
                    : unit_interval(owen_scrambled(points_.bits(n, j), key)));
  }
  u = copula_.correlated(std::move(u));
  std::vector<double> x;
  std::size_t from = 0;
  for (const ScatterTolerance& t : task_.tolerances) {
    const auto count = static_cast<std::size_t>(t.coordinates());
    const auto value = t.at(std::span<const double>(u).subspan(from, count));
    x.insert(x.end(), value.begin(), value.begin() + t.coordinates());
    from += count;
  }
  return x;
}

std::vector<std::vector<double>> SamplePoints::first(int replicate, int count) const {
  std::vector<std::vector<double>> places;
  for (int n = 0; n < count; ++n) places.push_back(at(replicate, static_cast<std::uint32_t>(n)));
  return places;
}

std::vector<MemberSpan> spans_at(const ContactSetup& setup, const ScatterTask& task,
                                 const std::vector<std::vector<double>>& places,
                                 std::span<const Influence> influences) {
  std::vector<MemberSpan> spans(places.size());
  parallel_for(
      places.size(),
      [&](std::size_t i) {
        spans[i] = continuous_peak_to_peak(setup, deviation_at(setup, task.tolerances, places[i]),
                                           task.member, influences);
        count_step(task.progress);
      },
      task.threads);
  return spans;
}

std::vector<double> ranked(const std::vector<MemberSpan>& spans) {
  std::vector<double> f;
  for (const MemberSpan& s : spans) f.push_back(s.value.value_or(kLostSpan));
  return f;
}

}  // namespace gearwright
