// Computes the effect of tolerances on a pair. The results are the distribution of each quantity of
// the contact, probabilities, the influence of each tolerance, and the worst member.
//
//   n, R   samples of a replicate, replicates        d   number of coordinates of x
//                                    theory: docs/theory/14-scatter.md
//
// No result depends on the number of threads, because every member is computed independently of the
// others, and statistics are computed in the order of the samples.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/base/progress.hpp"
#include "gearwright/gear/warning.hpp"
#include "gearwright/load/loaded_contact.hpp"
#include "gearwright/math/statistics.hpp"
#include "gearwright/scatter/correlation.hpp"
#include "gearwright/scatter/member.hpp"
#include "gearwright/scatter/pattern_density.hpp"

namespace gearwright {

enum class Sampling { sobol, random };

/// Tolerances that are treated as one variable for the Sobol indices.
struct ToleranceGroup {
  std::string name;
  std::vector<std::size_t> tolerances;
};

/// Contact under torque, computed for the first samples of each replicate.
struct LoadedFamily {
  PairCompliance compliance;
  LoadRequest request;  ///< without rotations; the root stresses are not used
  int samples = 32;     ///< per replicate, a power of two, at most ScatterPlan::samples
  /// For a double-helical pair, `request` is the request of the half at z > 0, with half of the
  /// torques, and `second_half` is the request of the mirror image of the other half.
  std::optional<LoadRequest> second_half{};

  /// Returns the torque on gear 1 of the whole pair, N mm.
  double torque(std::size_t k) const { return (second_half ? 2 : 1) * request.torques[k]; }
};

/// The number of samples, and the results that are computed from them.
struct ScatterPlan {
  int samples = 1024;  ///< n, samples of each replicate, a power of two
  int replicates = 8;  ///< R, number of replicates
  Sampling sampling = Sampling::sobol;
  std::vector<double> percentiles{5, 50, 95};  ///< 0 < p < 100
  double confidence = 0.95;
  bool indices = false;
  bool worst_case = false;
  bool loosening = false;
};

/// The toleranced inputs of a family.
struct VariedInputs {
  std::vector<ScatterTolerance> tolerances;
  /// Correlations of the scores of coordinates that check_correlations() accepts.
  std::vector<ToleranceCorrelation> correlations{};
  /// Every tolerance belongs to one group, and correlated tolerances belong to the same group. Used
  /// for `indices` only.
  std::vector<ToleranceGroup> groups{};
};

struct ScatterTask : ScatterPlan, VariedInputs {
  MemberRequest member;
  std::uint64_t seed = 1;
  std::optional<LoadedFamily> load{};
  std::optional<DensityRequest> density{};
  int threads = 0;  ///< number of threads; 0 means one thread per core
  Progress* progress = nullptr;
};

struct ScatterSample {
  std::vector<double> x;  ///< coordinates in the users' units of the tolerances
  FamilyMember member;
};

struct Percentile {
  double percent;
  Estimate estimate;
  std::optional<double> lower, upper;  ///< ends of the confidence interval; none with few samples
  std::size_t sample;                  ///< index of the sample with the nearest value
};

/// Statistics of one quantity over the members that keep contact.
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

/// Statistics of the results under one torque, over the samples that have a solution.
struct LoadedSpread {
  double torque;                       ///< N mm, on gear 1
  std::optional<Spread> peak_to_peak,  ///< rad, loaded transmission error
      max_pressure,                    ///< MPa
      face_load_factor;                ///< K_Hβ; none for point contact
  Probability edge_carries{};
  /// Probability that, at some position, no teeth touch or the forces do not converge.
  Probability unsolved{};
};

/// The first-order and total Sobol indices of each group.
struct IndexEstimates {
  std::vector<Estimate> first, total;
  /// The share of the variance that the derivatives at the nominal pair explain; none if the
  /// derivatives do not exist.
  std::optional<double> linear_share{};
};

/// The worst member found by a search of the box.
struct WorstMember {
  double value;           ///< peak to peak or least play of this member, rad
  std::vector<double> x;  ///< coordinates of this member, in the users' units
  bool corner;            ///< true if every tolerance is at an end of its range, and every bore on
                          ///< its circle
  /// The lower bound of the least play from least_play_bound(), rad. None if the quantity is the
  /// peak to peak, or if there is no such bound.
  std::optional<double> bound;
};

/// The effect of each tolerance on the highest percentile of the peak-to-peak TE. One tolerance
/// becomes wider or narrower about the nominal value, and all others stay the same.
struct Loosening {
  /// `percent` is the highest of ScatterPlan::percentiles. `percentile` is the peak-to-peak value
  /// at `percent`, in rad. The value is taken from the first replicate, with all tolerances as
  /// specified.
  double percent, percentile;
  struct Change {
    /// Greatest factor for the width of the tolerance with which the percentile exceeds
    /// `percentile` by at most the fraction kLooser, or by kSameError if this is greater. None if
    /// the percentile stays within this limit for all factors up to kMostFactor with which the
    /// teeth are possible.
    std::optional<double> factor;
    double halved;  ///< rad, the percentile if this tolerance is halved
  };
  std::vector<Change> by_tolerance;
  /// The tolerance whose halving lowers the percentile most; none if no halving lowers it by more
  /// than kSameError.
  std::optional<std::size_t> tighten_first;
};
constexpr double kLooser = 0.05, kMostFactor = 8.0;

struct Scatter {
  Scatter() = default;                 ///< empty; also prevents aggregate initialisation
  std::vector<ScatterSample> samples;  ///< replicate by replicate
  /// The spread of each ScatterQuantity; none if no sample that keeps contact has a value of this
  /// quantity.
  std::array<std::optional<Spread>, kScatterQuantities> spread{};
  /// None if the indices are not requested, if the quantity varies by rounding only, or if a sample
  /// has no contact or no value.
  std::array<std::optional<IndexEstimates>, kScatterQuantities> indices{};
  Probability edge_contact{}, jam{}, contact_lost{};
  std::optional<WorstMember> worst_peak_to_peak, worst_least_play;
  std::optional<Loosening> loosening;
  std::vector<LoadedSpread> loaded;  ///< results for each torque of ScatterTask::load
  std::optional<PatternDensity> density;
};

/// Computes all samples of a family and their statistics.
///
/// Domain    at least one tolerance, samples a power of two, replicates ≥ 1, 0 < confidence < 1
///           (contract)
/// Errors    as check_ends(); `scatter` if the tolerances have more coordinates than the table
///           of Sobol's points; nothing_touches() if the teeth touch in no sample
/// Accuracy  as member_at() for each member; each statistic has a confidence interval
/// Laws      (1) the result is the same, byte for byte, for any number of threads
///           (2) tolerances of width 0 give the numbers of analyse_contact()
Result<Scatter> scatter_of(const ContactSetup& setup, const ScatterTask& task);

/// Warns if samples jam, lose contact, or often have edge contact.
std::vector<Warning> sample_warnings(const Scatter& scatter);

/// Searches the ranges of the tolerances for the point x with the greatest peak to peak, and
/// returns this point. Returns none if the point is a corner, if its peak to peak does not exceed
/// `known` by more than 2 % and by more than 0.01″, or if the family cannot be computed.
///
/// Formula   [T14.15]
/// Domain    at least one tolerance (contract)
/// Accuracy  the worst of several local maxima; not a bound
std::optional<std::vector<double>> worse_inside(const ContactSetup& setup,
                                                std::vector<ScatterTolerance> tolerances,
                                                bool gear2_drives, Angle known, Progress* progress);

}  // namespace gearwright
