// Makes the figures of an analysis with many samples.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gearwright/figure/figure.hpp"

namespace gearwright {

struct DistributionScene {
  std::string id;     ///< unique in a page, "scatter-te"
  std::string words;  ///< name of the quantity: "transmission error, peak to peak"
  std::string unit;   ///< "″"; empty for a pure number
  std::vector<double> values;
  std::vector<std::pair<double, double>> percentiles;  ///< percent and value
};

/// Draws the histogram, which is the share of the samples in each of several equal intervals.
///
/// Domain    at least two values that differ (contract)
Figure histogram_figure(const DistributionScene& scene);

/// Draws the share of the samples below each value.
///
/// Domain    at least two values that differ (contract)
Figure cumulative_figure(const DistributionScene& scene);

struct IndexScene {
  std::string id;
  std::string words;  ///< name of the quantity whose variance is explained
  struct Group {
    std::string name;  ///< plain text
    double first, total;
  };
  std::vector<Group> groups;
};

/// Draws the first and the total Sobol index of each group as a pair of bars.
///
/// Domain    at least one group (contract)
Figure index_figure(const IndexScene& scene);

/// Designs in the order of their rank, each with a percentile of its distribution.
struct RankingScene {
  std::string id;
  std::string words;    ///< name of the quantity
  std::string unit;     ///< "″"
  std::string percent;  ///< "95 %"
  struct Entry {
    std::string name;  ///< plain text
    double percentile, mean;
    std::optional<double> lower, upper;  ///< confidence interval of the percentile
  };
  std::vector<Entry> entries;
};

/// Draws the percentile with its confidence interval, and the mean, over the rank.
///
/// Domain    at least one entry (contract)
Figure ranking_figure(const RankingScene& scene);

struct DensityScene {
  std::string id;
  std::size_t which = 0;                 ///< 0 for gear 1, 1 for gear 2
  double side = 1.0;                     ///< σ, +1 for an external gear, −1 for an internal gear
  std::vector<double> diameter, height;  ///< mm, of each row and of each column, ascending
  std::vector<double> share;             ///< 0 to 1, [row · columns + column]
  double marking = 0.0;                  ///< thickness of the marking compound, mm
  std::int64_t samples = 0;
};

/// Draws the developed flank. The shade of a point shows the share of the samples whose contact
/// pattern covers it.
///
/// Domain    at least two rows and two columns (contract)
Figure density_figure(const DensityScene& scene);

}  // namespace gearwright
