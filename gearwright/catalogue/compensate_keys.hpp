// The keys of [compensate] and [compensate.range], which are the permitted corrections and the
// ranges of errors.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "gearwright/catalogue/error_keys.hpp"
#include "gearwright/catalogue/key.hpp"
#include "gearwright/contact/corrections.hpp"

namespace gearwright {

/// A correction and its name in specs and results.
struct CorrectionEntry {
  std::string_view key;  ///< key in the result, "gear1.lead_crowning_um"
  WorkshopCorrection correction;
  std::string_view words;

  std::string_view unit() const { return key_unit(key); }
  /// The key of a flank correction in the table of modifications, "lead_crowning_um".
  std::string_view own_key() const { return key.substr(key.find('.') + 1); }
};

constexpr std::size_t kCorrectionCount = 17;

inline constexpr std::array<CorrectionEntry, kCorrectionCount> kCorrections{{
    {"tool_setting_mm", {CorrectionOf::tool_setting, 0}, "tool setting of rack F, Δb_F"},
    {"cutter_lead1_deg", {CorrectionOf::cutter_lead, 1}, "lead angle of the cutter of gear 1"},
    {"cutter_lead2_deg", {CorrectionOf::cutter_lead, 2}, "lead angle of the cutter of gear 2"},
    {"gear1.lead_slope_um", {CorrectionOf::lead_slope, 1}, "helix slope modification of gear 1"},
    {"gear1.lead_crowning_um", {CorrectionOf::lead_crowning, 1}, "helix crowning of gear 1"},
    {"gear1.profile_slope_um", {CorrectionOf::profile_slope, 1}, "profile slope of gear 1"},
    {"gear1.profile_crowning_um",
     {CorrectionOf::profile_crowning, 1},
     "profile crowning of gear 1"},
    {"gear1.tip_relief_um", {CorrectionOf::tip_relief, 1}, "tip relief of gear 1"},
    {"gear1.root_relief_um", {CorrectionOf::root_relief, 1}, "root relief of gear 1"},
    {"gear1.end_relief_um", {CorrectionOf::end_relief, 1}, "end relief of gear 1"},
    {"gear2.lead_slope_um", {CorrectionOf::lead_slope, 2}, "helix slope modification of gear 2"},
    {"gear2.lead_crowning_um", {CorrectionOf::lead_crowning, 2}, "helix crowning of gear 2"},
    {"gear2.profile_slope_um", {CorrectionOf::profile_slope, 2}, "profile slope of gear 2"},
    {"gear2.profile_crowning_um",
     {CorrectionOf::profile_crowning, 2},
     "profile crowning of gear 2"},
    {"gear2.tip_relief_um", {CorrectionOf::tip_relief, 2}, "tip relief of gear 2"},
    {"gear2.root_relief_um", {CorrectionOf::root_relief, 2}, "root relief of gear 2"},
    {"gear2.end_relief_um", {CorrectionOf::end_relief, 2}, "end relief of gear 2"},
}};

/// The entry of a correction.
const CorrectionEntry& entry_of(const WorkshopCorrection& correction);

/// The quantity that the corrections minimise.
enum class CompensateAim { transmission_error, loaded_transmission_error, pressure };
constexpr bool under_load(CompensateAim aim) { return aim != CompensateAim::transmission_error; }

struct CompensateInput {
  bool given = false;  ///< true if the spec has [compensate]
  CompensateAim aim = CompensateAim::transmission_error;
  std::vector<std::size_t> corrections;    ///< indices in kCorrections; if empty, the default
                                           ///< corrections for the kind of pair
  std::optional<double> centering_arcsec;  ///< cost of a contact pattern at the end of the face
  /// [compensate.range]: the least and the greatest value of each error, by its index in
  /// error_entries.
  std::array<std::optional<std::array<double, 2>>, kErrorCount> range{};
};

/// The permitted words in a list of corrections, in the order of kCorrections.
std::vector<std::string_view> correction_words();

const KeyTable& compensate_keys();
const KeyTable& compensate_range_keys();

}  // namespace gearwright
