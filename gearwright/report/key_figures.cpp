#include "gearwright/report/report_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gearwright/catalogue/gear_quantities.hpp"
#include "gearwright/catalogue/load_quantities.hpp"
#include "gearwright/catalogue/rating_quantities.hpp"
#include "gearwright/catalogue/scatter_quantities.hpp"
#include "gearwright/figure/load_scene.hpp"
#include "gearwright/figure/markup.hpp"

namespace gearwright {

namespace {

constexpr std::array<std::string_view, 4> kOfPair{"gear_ratio", "center_distance_mm",
                                                  "contact_ratio", "contact_ratio_crossed"};
constexpr std::array<std::string_view, 4> kOfRack{"travel_mm_per_turn", "center_distance_mm",
                                                  "contact_ratio", "normal_mm"};
constexpr std::array<std::string_view, 1> kBacklash{"normal_mm"};
constexpr std::array<std::string_view, 2> kOfRating{"S_F", "S_H"};
constexpr std::array<std::string_view, 3> kOfLoad{"torque_Nm", "max_pressure_MPa",
                                                  "peak_to_peak_arcsec"};

constexpr double kSameRatio = 5e-6;  // contact ratios that look the same with five decimals

std::string box(const std::string& words, std::string_view symbol, const std::string& value) {
  return fmt::format("<div><dt>{} {}</dt><dd>{}</dd></div>\n", words, symbol_html(symbol), value);
}

}  // namespace

std::string key_boxes(const QuantityTable& table, const std::vector<ValueRecord>& records,
                      std::span<const std::string_view> keys, UnitSystem units) {
  const std::vector<TextGroup> groups = text_groups(table, records, kPage, units);
  std::string text;
  for (const std::string_view key : keys) {
    for (const TextGroup& group : groups) {
      const auto row = std::find_if(group.rows.begin(), group.rows.end(),
                                    [&](const TextRow& r) { return r.info->key == key; });
      if (row == group.rows.end()) continue;
      const char* const between = records.size() > 1 ? " … " : " / ";
      std::string value;
      for (const std::string& one : row->texts)
        if (value != one) value += (value.empty() ? "" : between) + one;
      const std::string unit(row->unit);
      text += box(with_symbols(capitalised(row->info->words)), row->info->symbol,
                  escaped(value + (unit == "″" || unit.empty() ? unit : " " + unit)));
      break;
    }
  }
  return text;
}

std::string key_figures(const ReportInput& input) {
  const UnitSystem units = input.units;
  std::string text;
  if (input.pair) {
    const std::vector<ValueRecord> nominal{pair_quantities().of(*input.pair)};
    const auto& ends = input.pair_ends.empty() ? nominal : input.pair_ends;
    // If the usable flanks end before the tips, the box shows the contact ratio of the usable
    // flanks.
    auto keys = kOfPair;
    if (std::abs(input.pair->contact_ratio() - input.pair->contact_ratio_true()) > kSameRatio)
      std::replace(keys.begin(), keys.end(), std::string_view("contact_ratio"),
                   std::string_view("contact_ratio_true"));
    text += key_boxes(pair_quantities().table(), nominal, keys, units);
    text += key_boxes(pair_quantities().table(), ends, kBacklash, units);
  }
  if (input.rack)
    text += key_boxes(rack_pair_quantities().table(), {rack_pair_quantities().of(*input.rack)},
                      kOfRack, units);
  if (input.masses.size() == input.gears.size()) {
    std::vector<std::string> texts;
    for (const double mass : input.masses)
      texts.push_back(fmt::format("{:.3g}", value_in(units, Unit::kg, mass)));
    text +=
        box("Mass", "m", fmt::format("{} {}", fmt::join(texts, " / "), unit_text(units, Unit::kg)));
  }
  if (input.rating)
    text += key_boxes(rating_quantities().table(), {rating_quantities().of(*input.rating)},
                      kOfRating, units);
  if (input.load) {
    const auto views = torque_views(input.load->contact, input.load->standard);
    const auto& torques = input.load->contact.torques;
    const auto shown = static_cast<std::size_t>(&shown_torque(*input.load) - torques.data());
    text += key_boxes(load_torque_quantities().table(), {load_torque_quantities().of(views[shown])},
                      kOfLoad, units);
  } else if (input.contact) {
    text += box("Transmission error, peak to peak", "",
                te_unit(input.contact->driving.rack)
                    .text(input.contact->span[0].value_or(input.contact->driving.peak_to_peak)));
  }
  if (input.scatter) {
    const SpreadEntry& te = scatter_entries()[0];
    for (const auto& s : input.scatter->spread) {
      if (!s || std::string_view(s->entry->key) != te.key || s->spread->percentiles.empty())
        continue;
      const Percentile& p = s->spread->percentiles.back();
      text +=
          box(fmt::format("{}, {} % of the pairs", capitalised(te.words), format_number(p.percent)),
              "", fixed(te.shown(p.estimate.value), te.digits) + std::string(unit_text(te.unit)));
    }
  }
  return text.empty() ? text : "<dl class=\"keyfigures\">\n" + text + "</dl>\n";
}

}  // namespace gearwright
