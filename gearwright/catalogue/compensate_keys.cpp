#include "gearwright/catalogue/compensate_keys.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/catalogue/gear_keys.hpp"

namespace gearwright {

namespace {

constexpr int kMaxRanges = 5;  // 5 ranges have 2^5 = 32 corners

std::optional<KeyFault> check_ranges(CompensateInput& c, const KeyGiven&) {
  int count = 0;
  for (std::size_t i = 0; i < kErrorCount; ++i) {
    if (!c.range[i] || ++count <= kMaxRanges) continue;
    return KeyFault{std::string(error_entries()[i].key),
                    fmt::format("exceeds the limit of {} ranges; the limit exists because all "
                                "combinations of the ends of the ranges are computed",
                                kMaxRanges)};
  }
  return std::nullopt;
}

}  // namespace

const std::vector<CorrectionEntry>& correction_entries() {
  using M = Modification;
  static const std::vector<CorrectionEntry> entries = [] {
    std::vector<CorrectionEntry> list{
        {"tool_setting_mm", {CutterSetting::tool_setting, 0}, "tool setting of rack F, Δb_F"}};
    for (const int gear : {1, 2})
      list.push_back({fmt::format("cutter_lead{}_deg", gear),
                      {CutterSetting::cutter_lead, gear},
                      fmt::format("lead angle of the cutter of gear {}", gear)});
    for (const int gear : {1, 2}) {
      for (const M kind : {M::lead_slope, M::lead_crowning, M::profile_slope, M::profile_crowning,
                           M::tip_relief, M::root_relief, M::end_relief}) {
        const ModificationEntry& m = modification_entries()[static_cast<std::size_t>(kind)];
        list.push_back({fmt::format("gear{}.{}_um", gear, m.name),
                        {kind, gear},
                        fmt::format("{} of gear {}", m.words, gear)});
      }
    }
    return list;
  }();
  return entries;
}

std::vector<std::string_view> correction_words() {
  std::vector<std::string_view> words;
  for (const CorrectionEntry& c : correction_entries()) words.push_back(c.key);
  return words;
}

const KeyTable& compensate_keys() {
  static const KeyTable table{
      "compensate",
      "Corrections that the verb `compensate` can make, and the errors that they must compensate",
      {Key::word(
           "corrections", correction_words(), &CompensateInput::corrections,
           "`tool_setting_mm` and `cutter_lead1_deg` for circular-arc pairs, otherwise "
           "`gear1.lead_slope_um` and `gear1.lead_crowning_um`",
           "names of corrections: `tool_setting_mm` (Δb_F of rack F, at most 5 mm and at most a "
           "tenth of a module), `cutter_lead1_deg` and `cutter_lead2_deg` (within ±0.5), and, for "
           "gear 1 and likewise for gear 2, `gear1.lead_slope_um` (±100), `gear1.lead_crowning_um` "
           "(0 to 50), `gear1.profile_slope_um` (±50), `gear1.profile_crowning_um` (0 to 50), and "
           "`gear1.tip_relief_um`, `gear1.root_relief_um` and `gear1.end_relief_um` (0 to 50) if "
           "the spec has such a relief. Each correction is added to the value in the spec")
           .with_list(KeyList{.most = correction_entries().size(), .noun = "correction"})
           .with_form("a list of names, [\"gear1.lead_crowning_um\"]"),
       Key::word("aim", {"transmission_error", "loaded_transmission_error", "pressure"},
                 &CompensateInput::aim, "\"transmission_error\"",
                 "the quantity to minimise. `transmission_error` applies to rigid teeth and also "
                 "centres the pattern. `loaded_transmission_error` (peak to peak) and `pressure` "
                 "(greatest value) apply to teeth under the torques of `[load]`. For "
                 "`loaded_transmission_error` and `pressure`, the worst torque determines the "
                 "result, and `centering_arcsec` has no effect"),
       Key::not_negative(
           "centering_arcsec", "w", &CompensateInput::centering_arcsec,
           "a tenth of the transmission error without corrections, but at least 0.1. "
           "With this default, corrections that increase the transmission error by "
           "0.01 arcsec or more are excluded",
           "penalty for a pattern at the end of the face [T8.24]. For circular arcs, it is the "
           "penalty for a pattern at the end of the profile, because their contact moves along the "
           "face. If the key is given, the transmission error may increase to improve the position "
           "of the pattern. If the corrections together improve the sum of error and penalty by "
           "less than 0.001 arcsec, every correction is 0"),
       Key::part("range", compensate_range_keys,
                 KeyPlace::within<CompensateInput>([](auto& c) -> auto& { return c; }),
                 "ranges [least, greatest] of up to five errors; the corrections are chosen for "
                 "the worst errors found within these ranges")}};
  return table;
}

const KeyTable& compensate_range_keys() {
  static const KeyTable table = [] {
    KeyTable t{"compensate_range",
               "Ranges of errors, each [least, greatest]; the corrections are chosen for the worst "
               "errors found within the ranges",
               {},
               check_ranges};
    for (std::size_t i = 0; i < kErrorCount; ++i) {
      const Key& error = error_keys().keys[i];
      t.keys.push_back(Key::number(error.key, error.symbol, error.range,
                                   KeyPlace::within<CompensateInput>([i](auto& c) -> auto& {
                                     return c.range[i];
                                   }),
                                   "", error.meaning)
                           .with_list(kErrorRange));
    }
    return t;
  }();
  return table;
}

const CorrectionEntry& entry_of(const WorkshopCorrection& correction) {
  const auto& all = correction_entries();
  const auto it = std::find_if(
      all.begin(), all.end(), [&](const CorrectionEntry& e) { return e.correction == correction; });
  GW_EXPECTS(it != all.end());
  return *it;
}

}  // namespace gearwright
