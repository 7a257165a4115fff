#include "gearwright/catalogue/propose_quantities.hpp"

#include <fmt/format.h>

#include "gearwright/base/number_text.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/compensate_quantities.hpp"

namespace gearwright {

namespace {

const std::vector<std::string>& profile_words() {
  static const std::vector<std::string> kWords{"as_given", "short_tip_relief", "long_tip_relief",
                                               "short_relief_gear1", "long_relief_gear1"};
  return kWords;
}

Value um(const std::optional<double>& mm) { return mm ? Value(*mm * kUmPerMm) : Value(); }

const Quantities<ProposedGear>& gear_of_proposal_quantities() {
  using G = ProposedGear;
  return define("propose.proposals.gears", [](Quantities<G>& q) {
    q.number("tip_relief_um", "tip relief", "C_αa", "null if unchanged", [](const G& g) {
       return um(g.tip_relief);
     }).digits(0);
    q.number("tip_relief_start_mm", "start of the tip relief", "", "diameter", &G::tip_start)
        .digits(3);
    q.number("root_relief_um", "root relief", "C_αf", "null if unchanged", [](const G& g) {
       return um(g.root_relief);
     }).digits(0);
    q.number("root_relief_start_mm", "start of the root relief", "", "diameter", &G::root_start)
        .digits(3);
    q.number("lead_crowning_um", "helix crowning", "C_β", "null if unchanged", [](const G& g) {
       return um(g.lead_crowning);
     }).digits(0);
    q.number("lead_slope_um", "helix slope modification of the loaded flank", "C_Hβ",
             "null if unchanged", [](const G& g) { return um(g.lead_slope); })
        .digits(0);
    q.text("amounts", "amounts in words; empty if the amounts are the same as in the spec",
           amounts_of);
  });
}

const Quantities<ProposedLoad>& load_of_proposal_quantities() {
  using L = ProposedLoad;
  return define("propose.proposals.under_load", [](Quantities<L>& q) {
    q.term("torque_Nm", "on gear 1", [](const L& l) { return newton_metres(l.torque); });
    q.record<loaded_score_quantities>("score", "as computed by `load` for the spec of the proposal",
                                      &L::score);
  });
}

}  // namespace

const Quantities<Proposal>& proposal_quantities() {
  using P = Proposal;
  return define("propose.proposals", [](Quantities<P>& q) {
    q.word("profile", "profile modifications",
           "the modifications of the spec, or linear reliefs at the tips of both gears, or at tip "
           "and root of gear 1",
           [](const P& p) { return profile_words()[static_cast<std::size_t>(p.profile)]; })
        .one_of(profile_words());
    q.text("words", "modifications in words", words_of);
    q.flag("pitch_deviations", "reliefs with pitch deviations",
           "true if the reliefs allow for load and pitch deviations, false if the reliefs allow "
           "for the load alone",
           &P::pitch);
    q.flag("lead", "helix modifications",
           "true if the proposal has a helix crowning and slope of gear 1, false if the proposal "
           "keeps the helix modifications of the spec",
           &P::lead);
    q.record<gear_of_proposal_quantities>("gears", "amounts, per gear", &P::gears).list({2});
    q.record<load_of_proposal_quantities>("under_load", "one entry for each torque", &P::loads);
    q.record<loaded_score_quantities>("worst", "worst value of each number over the torques",
                                      &P::worst);
    q.record<loaded_score_quantities>(
        "at_helix_limits",
        "worst values over 16 positions, all torques and both signs of `helix_deviation_um`; this "
        "deviation is added to the deflection slope; null without tolerances",
        &P::at_limits);
    q.number("peak_to_peak_without_load_arcsec", "transmission error without load, peak to peak",
             "",
             "as `continuous_peak_to_peak_arcsec` of the verb `contact` for the spec of the "
             "proposal; null if contact is lost at some rotation",
             &P::without_load);
    q.add(Type::map, "spec", "spec", "", "the whole spec with the modifications of the proposal",
          &P::spec)
        .always();
  });
}

std::string amounts_of(const ProposedGear& g) {
  std::string list;
  const auto add = [&](const char* words, const std::optional<double>& mm,
                       const std::optional<double>& start = {}) {
    if (mm.value_or(0.0) == 0.0) return;
    list += fmt::format("{}{} {:.0f} µm", list.empty() ? "" : ", ", words, *mm * kUmPerMm);
    if (start) list += fmt::format(" from {} mm", fixed_decimals(*start, 3));
  };
  add("tip relief", g.tip_relief, g.tip_start);
  add("root relief", g.root_relief, g.root_start);
  add("helix crowning", g.lead_crowning);
  add("helix slope", g.lead_slope);
  return list;
}

std::string words_of(const Proposal& p) {
  const char* profile = "";
  switch (p.profile) {
    case ProposedProfile::as_given: profile = p.lead ? "" : "as given"; break;
    case ProposedProfile::short_tips: profile = "short tip relief"; break;
    case ProposedProfile::long_tips: profile = "long tip relief"; break;
    case ProposedProfile::short_gear1: profile = "short relief of gear 1"; break;
    case ProposedProfile::long_gear1: profile = "long relief of gear 1"; break;
  }
  const std::string words = profile + std::string(p.pitch ? " with f_pb" : "");
  if (!p.lead) return words;
  const bool slope = p.gears[0].lead_slope.value_or(0.0) != 0.0;
  const bool crowning = p.gears[0].lead_crowning.value_or(0.0) != 0.0;
  const std::string lead = crowning && slope ? "helix crowning and slope"
                           : slope           ? "helix slope"
                                             : "helix crowning";
  return words.empty() ? lead : words + ", " + lead;
}

std::vector<std::size_t> same_proposals(const std::vector<Proposal>& list, std::size_t i) {
  // If several proposals have the same spec, the effects of this spec are computed only once. The
  // results of these proposals are therefore equal in every bit, and == can compare them.
  const auto same = [&](std::size_t k) {
    return !list[i].transmission_error.empty() &&
           list[k].transmission_error == list[i].transmission_error &&
           list[k].worst.max_pressure == list[i].worst.max_pressure;
  };
  std::vector<std::size_t> found{i};
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (k == i || !same(k)) continue;
    if (k < i) return {};
    found.push_back(k);
  }
  return found;
}

std::string words_of_same(const std::vector<Proposal>& list, const std::vector<std::size_t>& same) {
  std::string numbers, words;
  for (std::size_t k = 1; k < same.size(); ++k) {
    numbers += fmt::format("{}{}", k > 1 ? ", " : "", same[k] + 1);
    words += (k > 1 ? "; " : ": ") + words_of(list[same[k]]);
  }
  return numbers + words;
}

const Quantities<ProposeView>& propose_quantities() {
  using V = ProposeView;
  return define("propose", [](Quantities<V>& q) {
    q.under("Origin of the amounts");
    q.term("torque_Nm", "greatest of the given torques, for which the amounts are computed",
           [](const V& v) { return newton_metres(v.torque); });
    q.number("tip_deflection_um", "deflection at the tip", "C_i",
             "least amount of a short tip relief with which the tip carries no load, for the helix "
             "modifications of the spec [T12.27]; null without reliefs",
             [](const V& v) {
               const auto& c = v.short_deflection;
               return c ? Value(std::array{(*c)[0] * kUmPerMm, (*c)[1] * kUmPerMm}) : Value();
             })
        .per_gear()
        .digits(2);
    q.number(
         "pitch_deviation_um", "base pitch deviation of both gears", "f_pb",
         "from the accuracy grades of the gears, normal to the flank [T12.28]; null without grades",
         [](const V& v) { return um(v.pitch_deviation); })
        .digits(2);
    q.number("helix_deviation_um", "combined helix slope deviation of both gears", "F",
             "square root of the sum of the squares of f_HβT of both grades. Each f_HβT is "
             "converted from the evaluated range L_β to the face [T14.23]. The deviation is normal "
             "to the flank and applies to the common face [T12.32]; null without grades",
             [](const V& v) { return um(v.helix_deviation); })
        .digits(2);
    q.number("deflection_slope_um", "linear deflection of the shafts along the face", "S",
             "sum of the slope in `[load]` and of the slope caused by the shafts of the gears "
             "under a uniform load [T12.37]; null if both are absent",
             [](const V& v) { return v.deflection ? um(v.deflection->slope) : Value(); })
        .digits(2);
    q.number("deflection_bow_um", "parabolic deflection of the shafts along the face", "B",
             "sum of the bow in `[load]` and of the bow caused by the shafts of the gears under a "
             "uniform load",
             [](const V& v) { return v.deflection ? um(v.deflection->bow) : Value(); })
        .digits(2);
    q.record<proposal_quantities>("proposals", "the spec as given, then the proposals",
                                  &V::proposals)
        .doors(kJson);
    q.whole("recommended", "recommended proposal", "", "1 is the spec as given", [](const V& v) {
       return v.recommended + 1;
     }).doors(kJson);
    q.text("reason", "reason for the recommendation", &V::reason);
  });
}

}  // namespace gearwright
