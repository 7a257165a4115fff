#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/job/compensate_answer.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

Json compensate_json(const SolvedJob& job, const CompensateAnswer& a) {
  return titled_record(job.spec, "compensate", compensate_quantities().of(a));
}

std::string compensate_listing(const SolvedJob& job, const CompensateAnswer& a) {
  const UnitSystem units = job.spec.units();
  std::string out = title_listing(job.spec);
  const auto head = [&](const std::string& text) { out += fmt::format("\n{}\n", text); };
  const auto row = [&](const std::string& what, const std::string& value) {
    out += fmt::format("  {:<44}{}\n", what, value);
  };
  out +=
      quantity_listing(units, compensate_quantities().table(), {compensate_quantities().of(a)}, {});
  head("All corrections together, chosen for the worst combination of errors");
  for (const FoundCorrection& c : a.corrections) {
    row(c.words, fmt::format("{:>11} {}{}", text_in(units, unit_of(c.key), c.value, 4),
                             unit_text(units, unit_of(c.key)),
                             c.at_bound ? "  (at the end of the range)" : ""));
    if (c.value != 0.0) row("  key in the spec: " + key_in(units, c.spec_key), "");
  }
  if (a.nothing_to_correct)
    out += wrapped(
        fmt::format("  There is nothing to correct, because no correction in the searched range "
                    "improves the result by {}.",
                    least_gain(a.aim)));
  if (a.nothing_to_correct && !job.spec.errors.any())
    out += wrapped(
        "  The spec has no [errors]. Give this table, for example with crossing_deg = 0.05.");
  const char* const worst = a.scenarios.size() > 1 ? ", for the worst combination of errors" : "";
  for (const AimedLoad& l : a.loads) {
    const auto& quantities = loaded_score_quantities();
    head(fmt::format("Under {} N m{}", format_number(newton_metres(l.torque)), worst));
    out += quantity_listing(units, quantities.table(),
                            {quantities.of(l.before), quantities.of(l.after)}, {"before", "after"});
  }
  if (!a.loads.empty()) head(fmt::format("Without load{}", worst));
  const auto& scores = score_quantities();
  out += quantity_listing(units, scores.table(), {scores.of(a.before), scores.of(a.after)},
                          {"before", "after"});
  const auto arcsec = [](const ContactScore& s) {
    return std::isfinite(s.span_or_sampled().rad())
               ? fixed_decimals(s.span_or_sampled().arcsec(), 4) + " ″"
               : std::string("no contact");
  };
  if (a.scenarios.size() > 1)
    for (const Scenario& s : a.scenarios)
      out += fmt::format("    {:<43}{:>16}{:>15}\n", sentence_in(units, s.errors), arcsec(s.before),
                         arcsec(s.after));
  return out;
}

}  // namespace gearwright
