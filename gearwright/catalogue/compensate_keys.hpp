// The keys of [compensate], which selects corrections, and of [compensate.range], which contains
// ranges of errors.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/error_keys.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/contact/corrections.hpp"

namespace gearwright {

struct CorrectionEntry {
  std::string key;  ///< key in the result, "gear1.lead_crowning_um"
  WorkshopCorrection correction;
  std::string words;

  std::string_view unit() const { return key_unit(key); }
  /// The key of a flank correction in [gearN.modifications], for example "lead_crowning_um".
  std::string_view own_key() const { return std::string_view(key).substr(key.find('.') + 1); }
};

const std::vector<CorrectionEntry>& correction_entries();

const CorrectionEntry& entry_of(const WorkshopCorrection& correction);

enum class CompensateAim { transmission_error, loaded_transmission_error, pressure };
constexpr bool under_load(CompensateAim aim) { return aim != CompensateAim::transmission_error; }

struct CompensateInput {
  bool given = false;  ///< true if the spec has [compensate]
  CompensateAim aim = CompensateAim::transmission_error;
  std::vector<std::size_t> corrections;    ///< indices in correction_entries; if empty, the default
                                           ///< corrections for the kind of pair
  std::optional<double> centering_arcsec;  ///< w  penalty for a pattern at the end of the face
  /// [compensate.range]: the least and the greatest value of each error, indexed like
  /// error_entries.
  std::array<std::optional<std::array<double, 2>>, kErrorCount> range{};
};

/// Returns the permitted words in a list of corrections, in the order of correction_entries.
std::vector<std::string_view> correction_words();

const KeyTable& compensate_keys();
const KeyTable& compensate_range_keys();

}  // namespace gearwright
