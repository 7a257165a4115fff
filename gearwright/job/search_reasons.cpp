#include "gearwright/job/search_reasons.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/job/listing.hpp"
#include "gearwright/job/loaded_designs.hpp"
#include "gearwright/job/search_answer.hpp"

namespace gearwright {

std::string size_words(const SearchProblem& problem, double module) {
  return problem.by_pitch
             ? fmt::format("diametral pitch {}", without_rounding_error(kMmPerInch / module))
             : fmt::format("module {}", module);
}

namespace {

constexpr std::string_view kRatingUnused =
    "[rating] has no effect on this search. Give safety_flank_min and safety_root_min in [search] "
    "to rate its designs.";

// Returns, for example, "The safest rejected design (module 2, 20:60) has S_H = 0.930 and S_F =
// 1.210." If these safety factors are sufficient, the finding that rejects the design follows.
std::string safest_line(const SearchProblem& problem, const SearchRun& run) {
  const DesignRow& row = *run.safest;
  const std::string safeties =
      fmt::format("The safest rejected design ({}, {}:{}) has S_H = {:.3f} and S_F = {:.3f}",
                  size_words(problem, row.trial.module), row.trial.z1, row.trial.z2,
                  std::min(*row.flank_safety[0], *row.flank_safety[1]),
                  std::min(*row.root_safety[0], *row.root_safety[1]));
  if (run.safest_finding.empty()) return safeties + ".";
  return safeties +
         " with nominal teeth. The verdict on its drawing rejects it: " + run.safest_finding;
}

// Returns, for example, "K_Hβ = 1.4 is a default. …". The text is empty if the spec determines
// K_Hβ.
std::string face_load_line(const SearchRun& run) {
  if (!run.default_face_load) return {};
  return fmt::format(
      "K_Hβ = {:g} is a default. Give face_load_factor or [rating.mounting] in [rating]; for a "
      "pair written by --take, K_Hβ can also be computed from [gear1.shaft] and [gear2.shaft].",
      *run.default_face_load);
}

// Returns, for example, "Z_L and Z_R are 1 by default. Give lubricant_viscosity_40C_mm2_s and
// flank_roughness_um in [rating]." The text is empty if no factor is assumed.
std::string assumed_line(const std::vector<AssumedFactor>& assumed) {
  if (assumed.empty()) return {};
  std::vector<std::string> symbols, inputs;
  for (const AssumedFactor& factor : assumed) {
    symbols.emplace_back(factor.symbol);
    add_once(inputs, factor.input);
  }
  return fmt::format("{} {} 1 by default. Give {} in [rating].", enumerated(symbols),
                     symbols.size() == 1 ? "is" : "are", enumerated(inputs));
}

// Returns a sentence about `overlap_ratio`, if a listed helical design has an overlap ratio below 1
// and the spec does not limit the overlap ratio. Otherwise, the text is empty.
std::string overlap_line(const SearchProblem& problem, const SearchAnswer& answer) {
  if (problem.crossed() || !problem.choices.empty() || problem.limits.overlap_ratio) return {};
  const auto end = answer.designs.begin() +
                   static_cast<std::ptrdiff_t>(std::min(answer.designs.size(), kListedDesigns));
  const bool short_overlap = std::any_of(answer.designs.begin(), end, [](const DesignRow& row) {
    return row.trial.helix[0] != Angle() && row.overlap_ratio < 1.0;
  });
  return short_overlap ? "Helical designs in the list have an overlap ratio ε_β below 1. "
                         "overlap_ratio = 1 in [search] gives every design a whole overlap ratio."
                       : "";
}

// Returns, for example, "β from 5° to 30° is a default. …". The text is empty if the spec
// determines the helix angles.
std::string default_helix_line(const SearchProblem& problem) {
  if (!problem.default_overlap_helix) return {};
  const auto& [least, greatest] = problem.overlap_helix_deg;
  return fmt::format(
      "β from {:g}° to {:g}° is a default. Give helix_angle_deg = [least, greatest] in [search] "
      "for another band.",
      least, greatest);
}

std::string no_change_helps(const SearchRun& run, UnitSystem units) {
  std::vector<std::string> keys;
  for (const std::string& field : run.changes_tried) {
    std::string key = spelled_change({field, "", "", 0.0}, units).key;
    add_once(keys, std::move(key));
  }
  return fmt::format(
      "Changing only one of these keys does not help: {}. Centre distances were changed by a "
      "factor of at most 2, and ratios by at most half of their value. Other keys, such as the "
      "modules or the helix angles, were not changed.",
      fmt::join(keys, ", "));
}

}  // namespace

std::vector<SearchReason> reasons_of(const SearchProblem& problem, const SearchRun& run,
                                     UnitSystem units) {
  std::vector<SearchReason> lines;
  if (problem.rating)
    lines.push_back({sentence_in(units, "Designs are " + rating_line(problem) + ".")});
  if (run.default_face_load) lines.push_back({face_load_line(run)});
  if (const std::string line = assumed_line(run.assumed); !line.empty())
    lines.push_back({sentence_in(units, line)});
  if (problem.default_overlap_helix) lines.push_back({default_helix_line(problem)});
  if (problem.rating_unused) lines.push_back({std::string(kRatingUnused)});
  if (run.pair_not_read) lines.push_back({std::string(kPairNotRead)});
  if (run.teeth_not_read) lines.push_back({std::string(kTeethNotRead)});
  if (problem.draw)
    lines.push_back({sentence_in(units, "Designs are " + drawing_line(problem) + ".")});
  if (!run.answer.loaded.empty()) lines.push_back({loaded_line(problem, run.answer)});
  for (const std::string& line : load_failures(run.answer)) lines.push_back({line});
  if (const std::string line = overlap_line(problem, run.answer); !line.empty())
    lines.push_back({line});
  if (run.answer.counts.feasible > 0) return lines;
  if (run.safest) lines.push_back({sentence_in(units, safest_line(problem, run))});
  if (!run.changes.empty())
    lines.push_back(
        {"No design is feasible. Each of these changes alone would make designs feasible:"});
  for (const std::string& line : change_lines(run, units)) lines.push_back({"  " + line, true});
  if (!run.changes_left_out.empty()) {
    lines.push_back({capitalised(run.changes_left_out) + "."});
  } else if (run.changes.empty()) {
    lines.push_back({no_change_helps(run, units)});
  }
  return lines;
}

}  // namespace gearwright
