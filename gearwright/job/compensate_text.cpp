#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/correction_tables.hpp"
#include "gearwright/job/compensate_answer.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

std::string compensate_listing(const SolvedJob& job, const CompensateAnswer& a) {
  const UnitSystem units = job.spec.units();
  TextTable found = correction_table(
      "All corrections together, chosen for the worst combination of errors", a.corrections, units);
  if (a.nothing_to_correct)
    found.notes.push_back(
        fmt::format("There is nothing to correct, because no correction in the searched range "
                    "improves the result by at least {}.",
                    least_gain(a.aim)));
  if (a.nothing_to_correct && !job.spec.errors.any())
    found.notes.emplace_back(
        "The spec has no [errors]. Give this table, for example with crossing_deg = 0.05.");
  std::string out = title_listing(job.spec) + listing_of(units, compensate_quantities(), a) +
                    table_listing(found);
  const char* const worst = a.scenarios.size() > 1 ? ", for the worst combination of errors" : "";
  for (const AimedLoad& l : a.loads) {
    const auto& quantities = loaded_score_quantities();
    out += fmt::format("\nUnder {} N m{}\n", format_number(newton_metres(l.torque)), worst) +
           quantity_listing(units, quantities.table(),
                            {quantities.of(l.before), quantities.of(l.after)}, {"before", "after"});
  }
  if (!a.loads.empty()) out += fmt::format("\nWithout load{}\n", worst);
  const auto& scores = score_quantities();
  out += quantity_listing(units, scores.table(), {scores.of(a.before), scores.of(a.after)},
                          {"before", "after"});
  if (a.scenarios.size() > 1) out += table_listing(scenario_table(a.scenarios, units));
  return out;
}

}  // namespace gearwright
