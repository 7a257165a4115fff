// The quantities of the scatter due to tolerances. A result contains them under `scatter`.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/catalogue/quantity.hpp"
#include "gearwright/scatter/pattern_density.hpp"
#include "gearwright/scatter/robust.hpp"

namespace gearwright {

/// A quantity with a distribution, and its name in results.
struct SpreadEntry {
  const char* key;    ///< "peak_to_peak_arcsec"
  const char* words;  ///< "transmission error, peak to peak"
  Unit unit;          ///< unit of the key
  int digits;         ///< decimals for users
  const char* meaning;

  /// Converts a value to the unit of the key. An angle is given in rad.
  double shown(double value) const;
};

struct ScatterEntry : SpreadEntry {
  ScatterQuantity quantity;
};

struct LoadedEntry : SpreadEntry {
  std::optional<Spread> LoadedSpread::*spread;
};

/// The entries in the order of ScatterQuantity.
const std::array<ScatterEntry, kScatterQuantities>& scatter_entries();
const std::array<LoadedEntry, 3>& loaded_entries();

/// The distribution of one quantity, in the unit of its key.
struct SpreadView {
  const SpreadEntry* entry;
  const Spread* spread;
  /// For each percentile, the sample with the nearest value. Each sample contains the errors in the
  /// form of a spec, followed by its other inputs.
  ValueList samples;
};

struct WorstView {
  const ScatterEntry* entry;
  const WorstMember* worst;
  ValueMap at;  ///< values of the inputs, by name
};

/// The results of a family of pairs under one torque.
struct LoadedSpreadView {
  const LoadedSpread* loaded;
  std::array<std::optional<SpreadView>, 3> spread;  ///< in the order of loaded_entries()
};

/// The statistics of a family of pairs. There is one family without and one with corrections. Both
/// families have the same samples, so their statistics can be compared.
struct JudgedView {
  const JudgedFamily* family;
  SpreadView peak_to_peak;
  std::vector<LoadedSpreadView> loaded;  ///< one entry for each torque; empty unless the aim is a
                                         ///< quantity under load
};

struct RobustView {
  std::vector<FoundCorrection> corrections;
  bool under_load;
  double percent;
  JudgedView before, after;
  Value spec;  ///< the whole spec with the corrections
};

struct ScatterView {
  const Scatter* scatter;
  const ScatterTask* task;
  std::vector<std::string> inputs;
  std::array<std::optional<SpreadView>, kScatterQuantities> spread;
  std::optional<WorstView> worst_peak_to_peak, worst_least_play;
  std::optional<RobustView> robust;
  std::vector<LoadedSpreadView> loaded;     ///< one for each torque
  const PatternDensity* density = nullptr;  ///< for figures, and for results if requested
};

const Quantities<ScatterView>& scatter_quantities();

Unit unit_of(const ScatterTolerance& tolerance);

const Quantities<SpreadView>& spread_quantities();
const Quantities<ScatterView>& probabilities_quantities();
const Quantities<Probability>& probability_quantities();
const Quantities<LoadedSpreadView>& loaded_spread_quantities();

// The quantities of the density of contact patterns. A result contains them under
// `scatter.pattern`.

const Quantities<PatternDensity>& density_quantities();

}  // namespace gearwright
