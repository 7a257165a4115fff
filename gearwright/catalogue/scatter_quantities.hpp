// The quantities of tolerance scatter: `scatter` of a result.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/scatter/robust.hpp"

namespace gearwright {

/// A quantity of a member, with its name in results.
struct ScatterEntry {
  ScatterQuantity quantity;
  const char* key;    ///< "peak_to_peak_arcsec"
  const char* words;  ///< "transmission error, peak to peak"
  Unit unit;          ///< of the key
  int digits;         ///< for people
  const char* meaning;

  /// A value in rad, or a share, in the unit of the key.
  double shown(double value) const;
};

/// By ScatterQuantity.
const std::array<ScatterEntry, kScatterQuantities>& scatter_entries();

/// One quantity in the unit of its key.
struct SpreadView {
  const ScatterEntry* entry;
  const Spread* spread;
  ValueList
      samples;  ///< by percentile: the next sample, as errors of a spec, and its other changes
};

struct IndexView {
  const IndexEstimates* estimates;
};

struct WorstView {
  const ScatterEntry* entry;
  const WorstMember* worst;
  ValueMap at;  ///< by input
};

/// Statistics of the family without or with corrections, from the samples used for comparison.
struct JudgedView {
  const Scatter* scatter;
  SpreadView peak_to_peak;
};

struct RobustView {
  std::vector<FoundCorrection> corrections;
  double percent;
  JudgedView before, after;
  Value spec;  ///< the whole spec with the corrections in it
};

struct ScatterView {
  const Scatter* scatter;
  const ScatterTask* task;
  std::vector<std::string> inputs;
  std::array<std::optional<SpreadView>, kScatterQuantities> spread;
  std::optional<WorstView> worst_peak_to_peak, worst_least_play;
  std::optional<RobustView> robust;
};

const Quantities<ScatterView>& scatter_quantities();
/// Quantities of one quantity, and of a probability.
const Quantities<SpreadView>& spread_quantities();
const Quantities<Probability>& probability_quantities();

}  // namespace gearwright
