// The keys of [compensate] and [compensate.range]: which corrections may be made, and against which
// errors.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/error_keys.hpp"
#include "gearwright/catalogue/key.hpp"

namespace gearwright {

/// A correction that a workshop can make.
struct CorrectionEntry {
  std::string_view key;  ///< as in the result, "gear1.lead_crowning_um"
  double lo, hi;         ///< bounds, in its unit
  double step;           ///< a small change

  std::string_view unit() const { return key_unit(key); }
};

constexpr std::size_t kCorrectionCount = 11;

/// Bounds of everyday work; `tool_setting_mm` is bounded by the module as well.
inline constexpr std::array<CorrectionEntry, kCorrectionCount> kCorrections{
    {{"tool_setting_mm", -5.0, 5.0, 0.005},
     {"cutter_lead1_deg", -0.5, 0.5, 0.005},
     {"cutter_lead2_deg", -0.5, 0.5, 0.005},
     {"gear1.lead_slope_um", -100.0, 100.0, 2.0},
     {"gear1.lead_crowning_um", 0.0, 50.0, 2.0},
     {"gear1.profile_slope_um", -50.0, 50.0, 1.0},
     {"gear1.profile_crowning_um", 0.0, 50.0, 1.0},
     {"gear2.lead_slope_um", -100.0, 100.0, 2.0},
     {"gear2.lead_crowning_um", 0.0, 50.0, 2.0},
     {"gear2.profile_slope_um", -50.0, 50.0, 1.0},
     {"gear2.profile_crowning_um", 0.0, 50.0, 1.0}}};

struct CompensateInput {
  std::vector<std::size_t> corrections;  ///< places in kCorrections; empty: the pair's own
  double centering_arcsec = 1.0;         ///< what a pattern at the end of the face may cost
  /// [compensate.range]: the least and the greatest value of an error, by its place in
  /// error_entries.
  std::array<std::optional<std::array<double, 2>>, kErrorCount> range{};
};

const KeyTable& compensate_keys();
const KeyTable& compensate_range_keys();

}  // namespace gearwright
