#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gearwright/catalogue/correction_tables.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/propose_answer.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

std::string propose_listing(const SolvedJob& job, const ProposeAnswer& a) {
  const UnitSystem units = job.spec.units();
  std::string out = title_listing(job.spec) + listing_of(units, propose_quantities(), a);
  for (const TextTable& table : proposal_tables(a, units, a.recommended))
    out += table_listing(table);
  return out + "\n" +
         wrapped(fmt::format("* Recommended: {}, {}. {}", a.recommended + 1,
                             words_of(a.proposals[a.recommended]), sentence_in(units, a.reason))) +
         "The option --take NUMBER > modified.toml writes the spec of a proposal.\n";
}

}  // namespace gearwright
