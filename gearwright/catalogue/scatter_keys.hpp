// The keys of [scatter] and its tables, which give the variations from pair to pair and the
// requested results.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/catalogue/compensate_keys.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/scatter/scatter.hpp"

namespace gearwright {

struct ScatterBearings {
  double span = 0.0;    ///< L  mm, distance of the bearings of a shaft
  double radius = 0.0;  ///< R  mm, radius of the circle in which a bore of axis 1 can lie relative
                        ///< to the bore of axis 2 in the same wall
  double offset = 0.0;  ///< c  mm, position of the gears from the middle of the span, towards +z
};

/// [scatter.gearN]. The distributions are in the units of their keys.
struct ScatterGear {
  std::optional<DistributionSpec> thickness;  ///< deviation of E_sn, mm
  /// One distribution for each of modification_entries(), in µm. It applies to both flanks.
  std::array<std::optional<DistributionSpec>, 7> modifications;
  bool pitch = false;                               ///< true if the pitches vary within the
                                                    ///< tolerances of the accuracy grade
  std::optional<std::array<int, 2>> profile_waves;  ///< range of the wave count, for f_fα
  std::optional<std::array<int, 2>> helix_waves;    ///< range of the wave count, for f_fβ
};

struct ScatterRobust {
  CompensateAim aim = CompensateAim::transmission_error;  ///< the transmission error of rigid or of
                                                          ///< loaded teeth
  std::vector<std::size_t>
      corrections;  ///< indices in correction_entries; empty for the default ones
  double percentile = 95.0;
  std::optional<std::array<double, 2>> range;  ///< range of every correction, each in its own unit
};

struct ScatterInput : ScatterPlan {
  bool given = false;
  int seed = 1;
  bool pattern = false;                       ///< true if the density of patterns is also computed
  bool loaded = false;                        ///< true if contact under [load] is also computed
  std::optional<std::array<int, 2>> quality;  ///< accuracy grades A of gear 1 and gear 2; by
                                              ///< default, those in their own tables
  int loaded_samples = 256;                   ///< greatest number of samples under load, for all
                                              ///< replicates together
  /// A distribution for each of error_entries(), in the unit of its key.
  std::array<std::optional<DistributionSpec>, kErrorCount> errors;
  std::optional<ScatterBearings> bearings;
  std::array<ScatterGear, 2> gears;
  /// [scatter.groups]: the name and the inputs of a group, as the user gives them.
  struct Group {
    std::string name;
    std::vector<std::string> inputs;
  };
  std::vector<Group> groups;
  /// [[scatter.correlations]]: two inputs, as the user gives them, and the correlation of their
  /// normal scores (docs/spec.md).
  struct Correlation {
    std::array<std::string, 2> between;
    double value = 0.0;
  };
  std::vector<Correlation> correlations;
  std::optional<ScatterRobust> robust;
};

constexpr int kMaxScatterSamples = 1 << 19;  ///< limit for samples times replicates
constexpr std::size_t kMostCorrelations = 1000;

const KeyTable& scatter_keys();
const KeyTable& scatter_error_keys();
const KeyTable& scatter_bearing_keys();
const KeyTable& scatter_gear_keys();
const KeyTable& scatter_modification_keys();
const KeyTable& scatter_correlation_keys();
const KeyTable& scatter_robust_keys();
/// The keys of a toleranced number that is given as a table.
const KeyTable& scatter_range_keys();

}  // namespace gearwright
