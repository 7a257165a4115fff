#include "gearwright/report/compensate_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/error_keys.hpp"
#include "gearwright/report/html_text.hpp"
#include "gearwright/report/quantity_table.hpp"
#include "gearwright/report/table_builder.hpp"

namespace gearwright {

namespace {

std::string arcsec(const ContactScore& s) {
  return s.nothing_touches() ? "no contact" : fixed(s.peak_to_peak.arcsec(), 4);
}

// Of an aim under load, at the torque that is worst before.
std::string finding_under_load(const CompensateView& v) {
  const bool pressure = v.aim == CompensateAim::pressure;
  const auto aimed = [&](const LoadedScore& s) {
    return pressure ? s.max_pressure : s.peak_to_peak.arcsec();
  };
  const auto worst = std::max_element(
      v.loads.begin(), v.loads.end(),
      [&](const auto& a, const auto& b) { return aimed(a.before) < aimed(b.before); });
  const auto text = [&](const LoadedScore& s) {
    return pressure ? fixed(s.max_pressure, 0) : fixed(s.peak_to_peak.arcsec(), 3);
  };
  return fmt::format("Under {:.6g} N m {} then {}{} instead of {}{}.", worst->torque / kMmPerM,
                     pressure ? "the flanks bear up to" : "gear 2 runs up to", text(worst->after),
                     pressure ? " N/mm²" : "″ unevenly", text(worst->before), pressure ? "" : "″");
}

std::string finding(const CompensateView& v) {
  if (v.nothing_to_correct)
    return fmt::format(
        "Nothing to correct: none of these within reach makes the pair better by {}.",
        least_gain(v.aim));
  if (!v.loads.empty()) return finding_under_load(v);
  // The pattern's place is that along the face, else along the profile.
  const bool face = v.before.along_face != 0.0 || v.after.along_face != 0.0;
  const auto place = [&](const ContactScore& s) {
    return percent(face ? s.along_face : s.along_profile);
  };
  return fmt::format(
      "At worst gear 2 then runs up to {}″ unevenly instead of {}″, the contact lies {} % off the "
      "middle of the {} instead of {} %, and an edge touches at {} % of the positions instead of "
      "{} %.",
      arcsec(v.after), arcsec(v.before), place(v.after), face ? "face" : "profile", place(v.before),
      percent(v.after.edge_share), percent(v.before.edge_share));
}

const char* aim_words(CompensateAim aim) {
  switch (aim) {
    case CompensateAim::loaded_transmission_error:
      return "What counts is the transmission error of the loaded teeth, at the worst of the "
             "torques.";
    case CompensateAim::pressure:
      return "What counts is the greatest pressure on the flanks, at the worst of the torques.";
    case CompensateAim::transmission_error: break;
  }
  return "The transmission error counts first; of what is equally quiet, that whose contact lies "
         "in "
         "the middle of the flank.";
}

// "crossing_deg = -0.01, axial_1_mm = 2" in a reader's words; "as given" stays.
std::string in_words(std::string_view errors) {
  std::string text;
  while (!errors.empty()) {
    const std::string_view one = errors.substr(0, errors.find(", "));
    errors.remove_prefix(std::min(errors.size(), one.size() + 2));
    const std::size_t equals = std::min(one.size(), one.find(" = "));
    const auto index = error_index(one.substr(0, equals));
    text += text.empty() ? "" : ", ";
    if (!index) {
      text += one;
      continue;
    }
    const ErrorEntry& e = error_entries()[*index];
    text += fmt::format("{} {}{}", e.words, one.substr(equals + 3),
                        e.unit() == "deg"  ? "°"
                        : e.unit() == "um" ? " µm"
                                           : " mm");
  }
  return text;
}

std::string corrections(const CompensateView& v) {
  TableBuilder t("Corrections", {"On top of the drawing"});
  for (const FoundCorrection& c : v.corrections)
    t.row(capitalised(c.words), "", c.shown_unit, {fixed(c.value, kLengthDigits)});
  return t.str();
}

std::string scores(const CompensateView& v) {
  const auto& quantities = score_quantities();
  const auto& loaded = loaded_score_quantities();
  TableBuilder t("The aims, at the worst of the errors", {"Before", "After"});
  for (const AimedLoad& l : v.loads) {
    t.group(fmt::format("Under {:.6g} N m", l.torque / kMmPerM));
    for (const TextGroup& g :
         text_groups(loaded.table(), {loaded.of(l.before), loaded.of(l.after)}, kPage))
      add_rows(t, g);
  }
  const auto unloaded =
      text_groups(quantities.table(), {quantities.of(v.before), quantities.of(v.after)}, kPage);
  if (v.loads.empty()) {
    add_groups(t, unloaded);
  } else {
    t.group("Without load");
    for (const TextGroup& g : unloaded) add_rows(t, g);
  }
  if (v.scenarios.size() > 1) {
    t.group("Transmission error, peak to peak, one by one");
    for (const Scenario& s : v.scenarios)
      t.row(capitalised(in_words(s.errors)), "", "″", {arcsec(s.before), arcsec(s.after)});
  }
  return t.str();
}

// The answers in closed form that circular-arc teeth have besides.
std::string closed_forms(const CompensateView& v) {
  if (!v.setting && !v.lead) return {};
  TableBuilder t("In closed form, one by one", {"Value"});
  const auto& quantities = compensate_quantities();
  add_groups(t, text_groups(quantities.table(), {quantities.of(v)}, kPage));
  return t.str();
}

}  // namespace

std::string compensate_section(const CompensateView& view) {
  GW_EXPECTS(!view.before.nothing_touches() && !view.corrections.empty());
  return fmt::format(
      "<section class=\"compensate\">\n<h2>Corrections</h2>\n<div "
      "class=\"columns\"><div>\n<p>What a workshop can change so that this pair bears its errors. "
      "{} <code>gearwright compensate --take</code> prints the specification "
      "with the corrections in it.</p>\n<p><strong>{}</strong></p>\n{}</div><div>\n{}</div></div>\n"
      "{}</section>\n",
      aim_words(view.aim), finding(view), corrections(view), scores(view), closed_forms(view));
}

}  // namespace gearwright
