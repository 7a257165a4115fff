#include "gearwright/job/propose_answer.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/scatter/tolerance.hpp"

namespace gearwright {

namespace {

Proposal tips_of(const ReliefProposal& r, double pitch) {
  Proposal p;
  p.profile = r.length == ReliefLength::long_relief ? ProposedProfile::long_tips
                                                    : ProposedProfile::short_tips;
  p.pitch = pitch > 0.0;
  const auto amount = r.tip_amount(pitch);
  for (const std::size_t g : {0, 1})
    p.gears[g] = {.tip_relief = amount[g], .tip_start = r.tip_start[g]};
  return p;
}

Proposal gear1_of(const ReliefProposal& r, double pitch) {
  Proposal p = tips_of(r, pitch);
  p.profile = r.length == ReliefLength::long_relief ? ProposedProfile::long_gear1
                                                    : ProposedProfile::short_gear1;
  p.gears[0].root_relief = r.root_amount(pitch);
  p.gears[0].root_start = r.root_start;
  p.gears[1] = {};
  return p;
}

const char* words_of(ReliefLength length) {
  return length == ReliefLength::long_relief ? "long" : "short";
}

std::string why_none(const SolvedJob& job, ReliefLength length) {
  const double ratio = job.pair->involute()->mesh.true_ratio;
  const char* const why =
      ratio > 1.0 ? "at a transverse contact ratio of {:.3f} no tooth pair ever carries "
                    "the whole load"
                  : "the flanks touch over only {:.3f} base pitches, but a relief needs more than "
                    "one";
  return fmt::format("There are no {} reliefs, because {}.", words_of(length),
                     fmt::format(fmt::runtime(why), ratio));
}

std::string still_loaded(ReliefLength length, int gear) {
  return fmt::format(
      "Even with the greatest {} relief that is tried (a fortieth of the module), the tips of gear "
      "{} carry load.",
      words_of(length), gear);
}

// Returns the reliefs of all lengths. They are computed with the helix modifications of the spec
// or, if `lead` is not null, with those of `lead`.
std::vector<ReliefProposal> find_reliefs(const SolvedJob& job, const LoadTask& task,
                                         const PairCompliance& compliance, const LeadProposal* lead,
                                         std::vector<std::string>& remarks) {
  std::vector<ReliefProposal> found;
  for (const ReliefLength length : {ReliefLength::short_relief, ReliefLength::long_relief}) {
    const auto relief = propose_relief(job, task, compliance, length, lead);
    if (!relief) {
      remarks.push_back(
          fmt::format("There are no {} reliefs: {}.", words_of(length), relief.error().message()));
      continue;
    }
    if (!*relief) {
      remarks.push_back(why_none(job, length));
      continue;
    }
    for (const int which : {1, 2})
      if (!(*relief)->unloaded[which - 1]) remarks.push_back(still_loaded(length, which));
    found.push_back(**relief);
  }
  return found;
}

}  // namespace

GradeDeviations grade_deviations(const SolvedJob& job) {
  double pitch = 0.0;
  double helix = 0.0;
  bool any = false;
  const double face = std::min(job.gear(1).spec.face_width, job.gear(2).spec.face_width);
  for (const int which : {1, 2}) {
    const std::size_t i = which - 1;
    const ToleranceInput& own = job.spec.gears[i]->tolerance;
    const RatingInput& rating = job.spec.rating.input;
    std::optional<int> grade = own.quality;
    FlankTolerances edition = own.edition;
    if (!grade && rating.quality) {
      grade = (*rating.quality)[i];
      edition = tolerance_edition(rating.edition);
    }
    if (!grade || !has_class(edition, *grade)) continue;
    const auto flank = graded_flank(job.gear(which), edition, *grade);
    if (!flank) continue;
    any = true;
    const double slope = flank->helix_slope * face / job.gear(which).spec.face_width;
    pitch += flank->single_pitch * flank->single_pitch;
    helix += slope * slope;
  }
  if (!any) return {};
  const auto g = job.gear(1).reference();
  const double normal = std::cos(g.base_helix_angle);
  return {std::sqrt(pitch) * std::cos(g.transverse_pressure_angle) * normal,
          std::sqrt(helix) * normal};
}

ProposalList list_proposals(const SolvedJob& job, const LoadTask& task,
                            const PairCompliance& compliance, const LeadProposal& lead,
                            double pitch_deviation) {
  ProposalList list;
  const auto add = [&](Proposal p) {
    p.lead = lead.any();
    if (p.lead) {
      p.gears[0].lead_crowning = lead.crowning;
      p.gears[0].lead_slope = lead.slope;
    }
    list.proposals.push_back(std::move(p));
  };
  auto reliefs = find_reliefs(job, task, compliance, nullptr, list.remarks);
  if (!reliefs.empty()) list.short_deflection = reliefs.front().deflection;
  if (lead.any()) {
    for (const ReliefProposal& r : reliefs) list.proposals.push_back(tips_of(r, 0.0));
    add({});
    list.remarks.clear();  // find_reliefs() adds them again for the modifications of `lead`
    reliefs = find_reliefs(job, task, compliance, &lead, list.remarks);
  }
  for (const ReliefProposal& r : reliefs) add(tips_of(r, 0.0));
  for (const ReliefProposal& r : reliefs) add(gear1_of(r, 0.0));
  if (!(pitch_deviation > 0.0)) return list;
  for (const ReliefProposal& r : reliefs) add(tips_of(r, pitch_deviation));
  return list;
}

namespace {

// Amounts are whole µm, and starts of reliefs have three decimals of a millimetre. Rounding removes
// the additional digits that a conversion of units adds.
double decimals(double x, double steps) { return std::round(x * steps) / steps; }
double um(double mm) { return decimals(mm * kUmPerMm, 1.0); }
double diameter(double mm) { return decimals(mm, kUmPerMm); }

bool begins_with_any(std::string_view key, const std::vector<std::string_view>& names) {
  for (const std::string_view side : kFlankSides)
    if (key.starts_with(side)) key.remove_prefix(side.size());
  for (const std::string_view name : names)
    if (key.starts_with(name)) return true;
  return false;
}

void erase(Json& table, const std::vector<std::string_view>& names) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : table.items())
    if (begins_with_any(key, names)) keys.push_back(key);
  for (const std::string& key : keys) table.erase(key);
}

void put(Json& table, const char* amount_key, const std::optional<double>& amount,
         const char* start_key = "", const std::optional<double>& start = {}) {
  if (amount.value_or(0.0) == 0.0) return;
  table[amount_key] = um(*amount);
  if (start) table[start_key] = diameter(*start);
}

}  // namespace

Json with_proposal(const Json& tree, const Proposal& p, bool gear2_drives) {
  Json made = tree;
  const bool profile = p.profile != ProposedProfile::as_given;
  for (const int which : {1, 2}) {
    const ProposedGear& g = p.gears[which - 1];
    Json& gear = made[gear_field(which)];
    Json table = gear.value("modifications", Json::object());
    if (profile) erase(table, {"tip_relief", "root_relief", "profile_", "topography"});
    if (p.lead) erase(table, {"lead_", "end_relief", "topography"});
    put(table, "tip_relief_um", g.tip_relief, "tip_relief_start_mm", g.tip_start);
    put(table, "root_relief_um", g.root_relief, "root_relief_start_mm", g.root_start);
    put(table, "lead_crowning_um", g.lead_crowning);
    put(table, gear2_drives ? "left_lead_slope_um" : "right_lead_slope_um", g.lead_slope);
    gear.erase("modifications");
    if (!table.empty()) gear["modifications"] = std::move(table);
  }
  return made;
}

}  // namespace gearwright
