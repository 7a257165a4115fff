#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "gearwright/catalogue/compensate_quantities.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/propose_answer.hpp"
#include "gearwright/job/result_json.hpp"

namespace gearwright {

namespace {

std::string effects(const ProposeAnswer& a, UnitSystem units) {
  std::vector<std::string> names;
  std::vector<ValueRecord> worst, at_limits;
  for (std::size_t i = 0; i < a.proposals.size(); ++i) {
    if (same_proposals(a.proposals, i).empty()) continue;
    const Proposal& p = a.proposals[i];
    names.push_back(
        fmt::format("{} {:>2}  {}", i == a.recommended ? "*" : " ", i + 1, words_of(p)));
    worst.push_back(loaded_score_quantities().of(p.worst));
    if (p.at_limits) at_limits.push_back(loaded_score_quantities().of(*p.at_limits));
  }
  const auto rows = [&](const std::vector<ValueRecord>& scores) {
    return row_listing(
        units, names, scores,
        {"peak_to_peak_arcsec", "max_pressure_MPa", "face_load_factor", "edge_carries"});
  };
  const std::size_t torques = a.proposals.front().loads.size();
  return fmt::format("\nEffects{}\n", torques > 1 ? ", worst values over the torques" : "") +
         rows(worst) +
         (at_limits.empty()
              ? ""
              : "\nEffects with the helix slope deviations in the less favourable direction\n" +
                    rows(at_limits));
}

std::string amounts(const ProposeAnswer& a, UnitSystem units) {
  std::string out = "\nAmounts in whole µm, reliefs rounded upwards\n";
  for (std::size_t i = 0; i < a.proposals.size(); ++i) {
    const std::vector<std::size_t> same = same_proposals(a.proposals, i);
    if (same.size() > 1)
      out += wrapped(fmt::format("  {:>2} is also {}", i + 1, words_of_same(a.proposals, same)));
    if (i == 0 || same.empty()) continue;
    int line = 0;
    for (const std::size_t gear : {0, 1}) {
      const std::string text = sentence_in(units, amounts_of(a.proposals[i].gears[gear]));
      if (text.empty()) continue;
      const std::string number = line++ == 0 ? std::to_string(i + 1) : "";
      out += fmt::format("  {:>2}  gear {}: {}\n", number, gear + 1, text);
    }
  }
  return out;
}

}  // namespace

Json propose_json(const SolvedJob& job, const ProposeAnswer& a) {
  return titled_record(job.spec, "propose", propose_quantities().of(a));
}

std::string propose_listing(const SolvedJob& job, const ProposeAnswer& a) {
  const UnitSystem units = job.spec.units();
  return title_listing(job.spec) +
         quantity_listing(units, propose_quantities().table(), {propose_quantities().of(a)}, {}) +
         amounts(a, units) + effects(a, units) + "\n" +
         wrapped(fmt::format("* Recommended: {}, {}. {}", a.recommended + 1,
                             words_of(a.proposals[a.recommended]), sentence_in(units, a.reason))) +
         "To print the spec of a proposal: --take NUMBER > modified.toml\n";
}

}  // namespace gearwright
