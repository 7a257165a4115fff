// What tolerances do to a pair: the distribution of each number of its contact, probabilities, which
// tolerance matters, and the worst of the box.
//
//   n, R   samples of a replicate, replicates        d   coordinates of x
//                                    theory: docs/theory/14-scatter.md
//
// A member of the family is computed by itself, from its own cold start, and statistics run in the order
// of the samples: no result depends on the number of threads.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/math/statistics.hpp"
#include "gearwright/scatter/member.hpp"

namespace gearwright {

enum class Sampling { sobol, random };

/// Tolerances that indices treat as one.
struct ToleranceGroup {
  std::string name;
  std::vector<std::size_t> tolerances;
};

struct ScatterTask {
  std::vector<ScatterTolerance> tolerances;
  std::vector<ToleranceGroup> groups;  ///< each tolerance in one; of `indices` only
  MemberRequest member;
  int samples = 1024;  ///< n, a power of two
  int replicates = 8;  ///< R
  std::uint64_t seed = 1;
  Sampling sampling = Sampling::sobol;
  std::vector<double> percentiles{5, 50, 95};  ///< 0 < p < 100
  double confidence = 0.95;
  bool indices = false;
  bool worst_case = false;
  bool loosening = false;
  int threads = 0;  ///< 0: as many as the machine has
  Progress* progress = nullptr;
};

/// A point x with its member.
struct ScatterSample {
  std::vector<double> x;  ///< in the users' units of the tolerances
  FamilyMember member;
};

struct Percentile {
  double percent;
  Estimate estimate;
  std::optional<double> lower, upper;  ///< of its interval; none: too few samples
  std::size_t sample;                  ///< of all samples that next to it
};

/// One quantity over the members that keep contact.
struct Spread {
  Estimate mean, standard_deviation;
  std::vector<Percentile> percentiles;
  double least, greatest;
};

struct Probability {
  double value;
  std::int64_t count, of;
  ConfidenceInterval interval;
};

/// By group.
struct IndexEstimates {
  std::vector<Estimate> first, total;
};

/// The worst that a search of the box finds.
struct WorstMember {
  double value;           ///< of the quantity
  std::vector<double> x;  ///< where, in the users' units
  bool corner;            ///< every coordinate is at an end of its range
};

/// What each tolerance is worth: the greatest percentile of the task, of the peak to peak TE, if one
/// tolerance becomes wider or narrower about the drawing and all others stay.
struct Loosening {
  double percent, percentile;  ///< rad, of the first replicate as it is
  struct Change {
    std::optional<double>
        factor;     ///< by which it may be multiplied until the percentile has grown by
                    ///< kLooser; none: by kMostFactor, or as far as there are teeth
    double halved;  ///< rad, the percentile with half the tolerance
  };
  std::vector<Change> by_tolerance;
  /// That which lowers the percentile most if it is halved; none: no tolerance lowers it.
  std::optional<std::size_t> tighten_first;
};
constexpr double kLooser = 0.05, kMostFactor = 8.0;

struct Scatter {
  Scatter() = default;                 ///< empty, and no aggregate: scatter_of() makes it
  std::vector<ScatterSample> samples;  ///< replicate by replicate
  /// By ScatterQuantity. None: there is no such number.
  std::array<std::optional<Spread>, kScatterQuantities> spread{};
  /// None: the quantity varies by rounding only, or a sample has no contact.
  std::array<std::optional<IndexEstimates>, kScatterQuantities> indices{};
  Probability edge_contact{}, jam{}, contact_lost{};
  std::optional<WorstMember> worst_peak_to_peak, worst_least_play;
  std::optional<Loosening> loosening;
};

/// Domain    tolerances, samples a power of two, 1 ≤ replicates, 0 < confidence < 1 (contract)
/// Errors    as check_ends(); `tolerances`, more than the table of Sobol's points has dimensions;
///           without_contact() where no sample touches anywhere
/// Accuracy  of a member as member_at(); of a statistic as its interval says
/// Laws      (1) the same bytes on any number of threads   (2) tolerances of width 0 give the numbers of
///           analyse_contact()
Result<Scatter> scatter_of(const ContactSetup& setup, const ScatterTask& task);

}  // namespace gearwright
