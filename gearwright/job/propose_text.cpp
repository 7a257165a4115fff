#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "gearwright/base/number_text.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/propose_answer.hpp"
#include "gearwright/job/result_json.hpp"
#include "gearwright/job/row_listing.hpp"

namespace gearwright {

namespace {

std::string score_columns(const LoadedScore& s) {
  if (!std::isfinite(s.max_pressure))
    return fmt::format("{:>10}{:>11}{:>8}{:>6}", "–", "–", "–", "–");
  return fmt::format("{:>10}{:>11}{:>8}{:>6}", fixed_decimals(s.peak_to_peak.arcsec(), 3),
                     fixed_decimals(s.max_pressure, 1),
                     s.face_load_factor ? fixed_decimals(*s.face_load_factor, 3) : "",
                     s.edge_carries ? "yes" : "no");
}

std::string effects(const ProposeAnswer& a) {
  const bool limits = a.proposals.front().at_limits.has_value();
  const std::size_t torques = a.proposals.front().loads.size();
  std::string out = fmt::format(
      "\nEffects{}{}\n", torques > 1 ? ", worst values over the torques" : "",
      limits ? "; on the right, with the helix slope deviations in the less favourable direction"
             : "");
  const std::string heads =
      fmt::format("{:>10}{:>11}{:>8}{:>6}", "TE p-p", "pressure", "K_Hβ", "edge");
  out += fmt::format("     {:<52}{}{}\n", "", heads, limits ? "   " + heads : "");
  const std::string again = limits ? fmt::format("{:>14}{:>13}{:>11}", "", "arcsec", "N/mm²") : "";
  out += fmt::format("     {:<52}{:>10}{:>11}{}\n", "", "arcsec", "N/mm²", again);
  for (std::size_t i = 0; i < a.proposals.size(); ++i) {
    const Proposal& p = a.proposals[i];
    out +=
        fmt::format("{} {:>2}  {:<52}{}{}\n", i == a.recommended ? "*" : " ", i + 1, words_of(p),
                    score_columns(p.worst), p.at_limits ? "   " + score_columns(*p.at_limits) : "");
  }
  return out;
}

std::string amounts(const ProposeAnswer& a, UnitSystem units) {
  std::string out = "\nAmounts in whole µm, reliefs rounded upwards\n";
  for (std::size_t i = 1; i < a.proposals.size(); ++i) {
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
         amounts(a, units) + effects(a) + "\n" +
         wrapped(fmt::format("* Recommended: {}, {}. {}", a.recommended + 1,
                             words_of(a.proposals[a.recommended]), sentence_in(units, a.reason))) +
         "To print the spec of a proposal: --take NUMBER > modified.toml\n";
}

}  // namespace gearwright
