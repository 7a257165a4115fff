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
  std::string_view words;

  std::string_view unit() const { return key_unit(key); }
  /// "µm", "°", "mm"
  std::string_view shown_unit() const {
    return unit() == "um" ? "µm" : unit() == "deg" ? "°" : unit();
  }
};

constexpr std::size_t kCorrectionCount = 11;

/// Bounds of everyday work; `tool_setting_mm` is bounded by the module as well.
inline constexpr std::array<CorrectionEntry, kCorrectionCount> kCorrections{
    {{"tool_setting_mm", -5.0, 5.0, 0.005, "tool setting of rack F, Δb_F"},
     {"cutter_lead1_deg", -0.5, 0.5, 0.005, "lead angle of the cutter of gear 1"},
     {"cutter_lead2_deg", -0.5, 0.5, 0.005, "lead angle of the cutter of gear 2"},
     {"gear1.lead_slope_um", -100.0, 100.0, 2.0, "helix slope modification of gear 1"},
     {"gear1.lead_crowning_um", 0.0, 50.0, 2.0, "helix crowning of gear 1"},
     {"gear1.profile_slope_um", -50.0, 50.0, 1.0, "profile slope of gear 1"},
     {"gear1.profile_crowning_um", 0.0, 50.0, 1.0, "profile crowning of gear 1"},
     {"gear2.lead_slope_um", -100.0, 100.0, 2.0, "helix slope modification of gear 2"},
     {"gear2.lead_crowning_um", 0.0, 50.0, 2.0, "helix crowning of gear 2"},
     {"gear2.profile_slope_um", -50.0, 50.0, 1.0, "profile slope of gear 2"},
     {"gear2.profile_crowning_um", 0.0, 50.0, 1.0, "profile crowning of gear 2"}}};

/// What corrections are to make least.
enum class CompensateAim { transmission_error, loaded_transmission_error, pressure };
constexpr bool under_load(CompensateAim aim) { return aim != CompensateAim::transmission_error; }

struct CompensateInput {
  bool given = false;  ///< the spec has [compensate]
  CompensateAim aim = CompensateAim::transmission_error;
  std::vector<std::size_t> corrections;    ///< places in kCorrections; empty: the pair's own
  std::optional<double> centering_arcsec;  ///< what a pattern at the end of the face may cost
  /// [compensate.range]: the least and the greatest value of an error, by its place in
  /// error_entries.
  std::array<std::optional<std::array<double, 2>>, kErrorCount> range{};
};

const KeyTable& compensate_keys();
const KeyTable& compensate_range_keys();

}  // namespace gearwright
