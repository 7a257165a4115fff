#include "gearwright/job/worst_of_range.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

namespace {

constexpr double kWorse = 1.02;
constexpr Angle kLeastWorse = Angle::arcseconds(0.01);
constexpr int kSamples = 64;  // the search starts at the worst samples and at the worst corners

}  // namespace

std::optional<std::array<double, kErrorCount>> worse_inside_ranges(const ContactSetup& setup,
                                                                   const JobSpec& spec, Angle known,
                                                                   Progress* progress) {
  ScatterTask task;
  std::vector<std::size_t> ranged;
  for (std::size_t i = 0; i < kErrorCount; ++i) {
    const auto& range = spec.compensate.range[i];
    if (!range) continue;
    const double nominal = spec.errors.value[i];
    const ErrorEntry& e = error_entries()[i];
    const auto around = Distribution::of({{(*range)[0] - nominal, (*range)[1] - nominal}});
    if (!around) return std::nullopt;
    task.tolerances.push_back(
        {std::string(e.key), e.si(), *around, static_cast<VaryingError>(i), {}});
    ranged.push_back(i);
  }
  if (ranged.empty()) return std::nullopt;
  task.member.gear2_drives = spec.contact.driver == 2;
  task.samples = kSamples;
  task.replicates = 1;
  task.worst_case = true;
  task.progress = progress;
  const auto scatter = scatter_of(setup, task);
  if (!scatter || !scatter->worst_peak_to_peak) return std::nullopt;
  const WorstMember& worst = *scatter->worst_peak_to_peak;
  const double limit = std::max(kWorse * known.rad(), (known + kLeastWorse).rad());
  if (worst.corner || !(worst.value > limit)) return std::nullopt;
  std::array<double, kErrorCount> value = spec.errors.value;
  for (std::size_t k = 0; k < ranged.size(); ++k) {
    const auto& [least, greatest] = *spec.compensate.range[ranged[k]];
    const double digit = std::pow(10.0, std::floor(std::log10(greatest - least)) - 3.0);
    double& x = value[ranged[k]];
    x = std::clamp(digit * std::round((x + worst.x[k]) / digit), least, greatest);
  }
  return value;
}

}  // namespace gearwright
