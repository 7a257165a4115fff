#include "gearwright/job/compensate_text.hpp"

#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include <cmath>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/base/torque.hpp"
#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/job/corrected_spec.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/value_json.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {

CompensateView compensate_view(const CompensateAnswer& a) {
  CompensateView view{{},
                      a.result.before,
                      a.result.after,
                      a.result.nothing_to_correct(),
                      a.result.centering,
                      {},
                      a.setting,
                      a.lead,
                      {}};
  for (std::size_t i = 0; i < a.corrections.size(); ++i) {
    view.corrections.push_back(
        found_correction(a.corrections[i], a.result.value[i], a.spec_keys[i], a.at_bound[i]));
  }
  for (std::size_t i = 0; i < a.scenarios.size(); ++i)
    view.scenarios.push_back({a.scenarios[i], a.result.each_before[i], a.result.each_after[i]});
  view.spec = to_value(a.corrected->tables);
  view.aim = a.aim;
  view.loads = a.loads;
  return view;
}

Json compensate_json(const SolvedJob& job, const CompensateAnswer& a) {
  Json record = titled_record(job.spec);
  record["compensate"] = to_json(compensate_quantities().of(compensate_view(a)));
  return record;
}

std::string compensate_listing(const SolvedJob& job, const CompensateAnswer& a) {
  std::string out;
  if (!job.spec.title.empty()) out += printable(job.spec.title) + "\n";
  const auto head = [&](const char* text) { out += fmt::format("\n{}\n", text); };
  const auto row = [&](const std::string& what, const std::string& value) {
    out += fmt::format("  {:<44}{}\n", what, value);
  };
  out += quantity_listing(compensate_quantities().table(),
                          {compensate_quantities().of(compensate_view(a))}, {});
  head("Corrections together, for the worst of the errors");
  for (std::size_t i = 0; i < a.corrections.size(); ++i) {
    const CorrectionEntry& c = entry_of(a.corrections[i]);
    row(std::string(c.words), fmt::format("{:>11} {}{}", fixed_decimals(a.result.value[i], 4),
                                          c.shown_unit(), a.at_bound[i] ? "  (the bound)" : ""));
    if (a.result.value[i] != 0.0) row("  in the spec: " + a.spec_keys[i], "");
  }
  if (a.result.nothing_to_correct())
    out += fmt::format(
        "  nothing to correct: no correction in the searched range improves the result "
        "by {}\n",
        least_gain(a.aim));
  for (const AimedLoad& l : a.loads) {
    const auto& quantities = loaded_score_quantities();
    head(fmt::format("Under {} N m", format_number(newton_metres(l.torque))).c_str());
    out += quantity_listing(quantities.table(), {quantities.of(l.before), quantities.of(l.after)},
                            {"before", "after"});
  }
  if (!a.loads.empty()) head("Without load");
  const auto& scores = score_quantities();
  out += quantity_listing(scores.table(), {scores.of(a.result.before), scores.of(a.result.after)},
                          {"before", "after"});
  for (std::size_t i = 0; a.scenarios.size() > 1 && i < a.scenarios.size(); ++i) {
    const auto arcsec = [](const ContactScore& s) {
      return std::isfinite(s.peak_to_peak.rad()) ? fixed_decimals(s.peak_to_peak.arcsec(), 4) + " ″"
                                                 : std::string("no contact");
    };
    out += fmt::format("    {:<43}{:>16}{:>15}\n", a.scenarios[i], arcsec(a.result.each_before[i]),
                       arcsec(a.result.each_after[i]));
  }
  return out;
}

}  // namespace gearwright
