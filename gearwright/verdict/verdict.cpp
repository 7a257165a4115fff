#include "gearwright/verdict/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gearwright/base/contract.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/base/number_text.hpp"
#include "gearwright/base/printable.hpp"
#include "gearwright/pair/drive.hpp"
#include "gearwright/verdict/margins.hpp"
#include "gearwright/verdict/remedy.hpp"

namespace gearwright {

Level level_of(Severity severity) {
  switch (severity) {
    case Severity::problem: return Level::red;
    case Severity::caution: return Level::amber;
    case Severity::note: return Level::green;
  }
  return Level::amber;
}

std::string recommendation(double recommended_backlash) {
  return fmt::format("ISO/TR 10064-2 recommends at least {:.3f} mm",
                     rounded_up(recommended_backlash, 3));
}

namespace {

// Returns the clause that names the fault of a finding. With a rack, the clause names the part.
std::string reason_of(const Finding& finding, const Judged& judged) {
  const bool rack = judged.rack != nullptr;
  if (rack && finding.code == WarningCode::root)
    return finding.gear == 2 ? "the tip of the pinion cuts into the root of the rack"
                             : "the tip of the rack cuts into the root of the pinion";
  if (rack && finding.code == WarningCode::base_tangent)
    return "the tip of the rack reaches a place where the pinion has no involute";
  if (rack && finding.code == WarningCode::form_circle)
    return "the tip of the rack reaches below the usable flank of the pinion";
  return meaning_of(finding.code).reason;
}

// Returns the backlash in words. If there is little or no backlash, the words include the smallest
// recommended backlash.
std::string backlash_words(const StatedBacklash& j) {
  const std::string words =
      j.none() ? "no backlash"
               : fmt::format("a backlash of {:.4f} mm in the normal section", j.normal);
  if (!j.none() && !j.little()) return words;
  return fmt::format("{} ({})", words, recommendation(j.recommended()));
}

std::string running(const ArcPair& pair) {
  if (pair.contacts.empty())
    return "The gears do not have matching leads. The command `gearwright contact` computes where "
           "the teeth touch.";
  return fmt::format(
      "The pair runs with continuous contact (overlap ratio {:.5f}), with {} per tooth and {}.",
      pair.overlap_ratio,
      pair.contacts.size() == 1 ? "one point of contact"
                                : fmt::format("{} points of contact", pair.contacts.size()),
      backlash_words(pair.stated_backlash()));
}

bool uncut_ring(const Gear* gear) { return !gear->tooth; }

constexpr const char* kNoCutter =
    " The cutter of the internal gear is not given, so its root fillet is not checked.";

std::string running(const InvolutePair& p, const std::string& contact) {
  const bool no_collision = p.interference.empty() && p.beyond_flank.empty();
  return fmt::format("{} {}{}.{}", contact, backlash_words(p.stated_backlash()),
                     !no_collision        ? ""
                     : p.crossed_inside() ? " and no tip interference"
                                          : " and no interference",
                     uncut_ring(&p.gears[1]) ? kNoCutter : "");
}

std::string running(const ParallelPair& p) {
  if (const auto face = face_width_needed(p)) {
    return running(p, fmt::format("The pair runs with continuous contact only because its teeth "
                                  "are helical. The transverse contact ratio is {:.3f}, and the "
                                  "total contact ratio is {:.3f}. The pair needs a face width "
                                  "b ≥ {:.2f} mm. There is",
                                  p.mesh.true_ratio, p.contact_ratio_true(), *face));
  }
  return running(
      p, fmt::format("The pair runs with continuous contact (total contact ratio {:.3f}). There is",
                     p.contact_ratio_true()));
}

std::string running(const CrossedPair& p) {
  return running(
      p,
      p.contact_ratio_true() > 0.0
          ? fmt::format("The pair runs with continuous contact (contact ratio {:.3f}). There is",
                        p.contact_ratio_true())
          : "A tooth pair is in contact at every position, but the contact is not conjugate. There "
            "is");
}

std::string gears_alone(const Judged& judged) {
  const char* who = judged.gears.size() == 1 ? "The gear" : "Each gear";
  if (std::any_of(judged.gears.begin(), judged.gears.end(), uncut_ring)) {
    return fmt::format(
        "{} has the data below. The outline of an internal gear is not checked, because its pinion "
        "cutter is not given.",
        who);
  }
  const bool pointed = std::any_of(judged.gears.begin(), judged.gears.end(),
                                   [](const Gear* gear) { return gear->pointed(); });
  return fmt::format("{} can be cut{}.", who,
                     !pointed                   ? " as specified"
                     : judged.gears.size() == 1 ? ", but not to its tip diameter"
                                                : ", but not every gear to its tip diameter");
}

// Returns the sentence about the safety factors, which are those under the load spectrum if there
// is one.
std::string safety_sentence(const PairRating& judged) {
  if (!judged.spectrum) return safety_words({&judged.rating});
  const SpectrumRating& s = *judged.spectrum;
  return fmt::format(
      " Under the load spectrum, the lowest safety factor is {:.2f} against pitting and {:.2f} "
      "against root breakage.",
      std::min(s.S_H[0], s.S_H[1]), std::min(s.S_F[0], s.S_F[1]));
}

// Returns the sentence about the operation of the gears. It is used only if no finding is red.
std::string standing(const Judged& judged) {
  if (judged.rack && judged.rack->true_contact_ratio() < 1.0)
    return fmt::format(
        "The rack and pinion run only with helical teeth, because the transverse contact ratio is "
        "{:.3f} and the total contact ratio is {:.3f}. There is {}.",
        judged.rack->true_contact_ratio(),
        judged.rack->true_contact_ratio() + judged.rack->overlap_ratio,
        backlash_words(judged.rack->stated_backlash()));
  if (judged.rack)
    return fmt::format("The rack and pinion run as specified, with {}.",
                       backlash_words(judged.rack->stated_backlash()));
  if (!judged.pair) return gears_alone(judged);
  const auto& ends = judged.backlash_ends;
  const std::string nominal =
      judged.pair->visit([](const auto& pair) { return running(pair); }) +
      (!ends ? ""
       : (*ends)[0] == (*ends)[1]
           ? fmt::format(" Within the tolerances, the backlash is {:.4f} mm.", (*ends)[0])
           : fmt::format(" Within the tolerances, the backlash is {:.4f} mm to {:.4f} mm.",
                         (*ends)[0], (*ends)[1])) +
      (judged.rating ? safety_sentence(*judged.rating) : "");
  if (!judged.contact || !judged.errors) return nominal;
  return "Under the errors, a tooth pair is in contact at every position. Without errors: " +
         nominal;
}

std::string not_running(const Judged& judged, const Verdict& verdict) {
  const std::string against = enumerated(detail::reasons(verdict.findings, judged, Level::red));
  const Finding& worst = verdict.findings.front();
  if (judged.rack) {
    const std::string text =
        fmt::format("The rack and pinion do not run as specified: {}.", against);
    const std::string rest = worst.at.empty() ? worst.remedy : worst.whole();
    return rest.empty() ? text : text + " " + rest;
  }
  if (!judged.pair) {
    return fmt::format("{} has a problem: {}.", judged.gears.size() == 1 ? "The gear" : "Each gear",
                       against);
  }
  if (is_safety(worst.code)) return "The pair does not withstand its load. " + worst.whole();
  std::string text = fmt::format("The pair does not run as specified: {}.", against);
  if (!worst.at.empty()) return text + " " + worst.whole();
  const ParallelPair* p = judged.pair->parallel();
  const auto face = p ? face_width_needed(*p) : std::nullopt;
  if (face && p->contact_ratio_true() < 1.0) {
    text += fmt::format(
        " With a transverse contact ratio of {:.3f}, contact is continuous only for helical gears "
        "with b ≥ {:.2f} mm.",
        p->mesh.true_ratio, *face);
  }
  return worst.remedy.empty() ? text : text + " " + worst.remedy;
}

// Returns a sentence with the reasons of the amber findings, except that of the first finding,
// which the headline already contains. Returns an empty text if there are no other reasons.
std::string besides(const Judged& judged, const Verdict& verdict) {
  std::vector<std::string> list = detail::reasons(verdict.findings, judged, Level::amber, 1);
  const std::string named = reason_of(verdict.findings[0], judged);
  std::erase(list, named);
  return list.empty() ? "" : fmt::format(" Also: {}.", enumerated(list));
}

std::string headline(const Judged& judged, const Verdict& verdict) {
  for (std::size_t i = 0; i < judged.gears.size(); ++i) {
    const Gear& gear = *judged.gears[i];
    if (gear.exists()) continue;
    const std::string text =
        fmt::format("Gear {} cannot be made as specified: {}.", i + 1,
                    gear.tooth->through_axis ? "the cutter passes through its axis"
                                             : "its teeth are cut off at their roots");
    const std::string& remedy = verdict.findings.front().remedy;
    return remedy.empty() ? text : text + " " + remedy;
  }
  if (verdict.level == Level::green) return standing(judged);
  if (verdict.level == Level::red) return not_running(judged, verdict) + besides(judged, verdict);
  return fmt::format("{} Check: {}{}", standing(judged), verdict.findings.front().named(),
                     besides(judged, verdict));
}

// Returns the value of the pair or of the gear to which a warning refers, for example a clearance.
// The list is empty if the warning refers to no such value.
std::vector<FindingValue> value_of(const Warning& w, const Judged& judged) {
  if ((w.code == WarningCode::thin_tip || w.code == WarningCode::pointed) && w.gear > 0) {
    const Gear& gear = *judged.gears[w.gear - 1];
    const auto& s_an = gear.tip_tooth_thickness_normal;
    // If the cutter of the gear is pointed, the tip of the gear is not.
    if (s_an && (gear.pointed() || w.code == WarningCode::thin_tip))
      return {{"tip_thickness", *s_an, true}};
  }
  if (!judged.pair) return {};
  const auto i = static_cast<std::size_t>(w.gear == 2 ? 1 : 0);
  const MountedGears& mounted = judged.pair->mounted();
  if (w.code == WarningCode::no_tip_clearance)
    return {{"clearance", mounted.tip_clearance[i], true}};
  if (w.code == WarningCode::contact_ratio || w.code == WarningCode::no_contact)
    return {{"contact_ratio", judged.pair->contact_ratio_true(), false}};
  if (w.code == WarningCode::negative_backlash)
    return {{"backlash", judged.pair->stated_backlash().normal, true}};
  for (const Collision& collision : mounted.beyond_flank) {
    if (w.code == WarningCode::beyond_flank && collision.gear == w.gear)
      return {{"early", -collision.depth, true}};
  }
  const InvolutePair* p = judged.pair->involute();
  if (!p) return {};
  for (const Interference& found : p->interference) {
    const double* amount = std::get_if<double>(&found.amount);
    if (amount && found.code == w.code && found.gear == w.gear)
      return {{"clearance", *amount, true}};
  }
  return {};
}

}  // namespace

const char* to_string(Level level) {
  switch (level) {
    case Level::green: return "green";
    case Level::amber: return "amber";
    case Level::red: return "red";
  }
  return "";
}

std::vector<std::string> detail::reasons(const std::vector<Finding>& findings, const Judged& judged,
                                         Level level, std::size_t first) {
  std::vector<std::string> list;
  for (std::size_t i = first; i < findings.size(); ++i) {
    if (findings[i].level != level) continue;
    const std::string reason = reason_of(findings[i], judged);
    if (!reason.empty()) add_once(list, reason);
  }
  return list;
}

bool is_safety(WarningCode code) {
  return code == WarningCode::root_safety || code == WarningCode::flank_safety ||
         code == WarningCode::spectrum_safety;
}

std::string safety_words(const std::vector<const Rating*>& ratings) {
  if (ratings.empty()) return "";
  double flank = std::numeric_limits<double>::infinity(), root = flank;
  for (const Rating* r : ratings) {
    flank = std::min({flank, r->S_H[0].value, r->S_H[1].value});
    root = std::min({root, r->S_F[0].value, r->S_F[1].value});
  }
  return fmt::format(
      " The lowest safety factor is {:.2f} against pitting and {:.2f} against root breakage.",
      flank, root);
}

std::string Finding::whole() const {
  std::string text = at.empty() ? message : fmt::format("{}: {}", at, message);
  return remedy.empty() ? text : text + " " + remedy;
}

std::string Finding::named() const {
  const bool unnamed = gear > 0 && at.empty() && meaning_of(code).gear_unnamed;
  return unnamed ? fmt::format("Gear {}: {}", gear, whole()) : whole();
}

std::vector<Finding> findings_of(const Judged& judged) {
  GW_EXPECTS(!judged.gears.empty() && judged.warnings != nullptr);
  std::vector<Finding> findings;
  // On crossed axes, edges or crowned flanks can touch although there is no conjugate contact. If
  // the contact was computed and is not lost, the warning about conjugate contact is only amber.
  const bool touches =
      judged.pair && judged.pair->crossed() && judged.contact && !judged.contact->contact_lost;
  for (const Warning& w : *judged.warnings) {
    const bool only_edges =
        touches && w.code == WarningCode::no_contact && judged.pair->contact_ratio_true() == 0.0;
    const Level level = only_edges ? Level::amber : level_of(severity_of(w));
    findings.push_back({w.code, level, w.gear, w.message, "", value_of(w, judged)});
  }
  const auto add = [&](std::vector<Finding> more) {
    std::move(more.begin(), more.end(), std::back_inserter(findings));
  };
  if (judged.pair) {
    add(detail::margin_findings(*judged.pair));
    if (backlash_of(*judged.pair)) add(detail::backlash_findings(judged.pair->stated_backlash()));
  }
  if (judged.rack) add(detail::backlash_findings(judged.rack->stated_backlash()));
  if (judged.rating) add(detail::rating_findings(*judged.rating));
  if (const auto place = pattern_place(judged)) add(detail::contact_findings(*place));
  return findings;
}

std::optional<PatternPlace> pattern_place(const Judged& judged) {
  if (!judged.contact || !(judged.pair || judged.rack)) return std::nullopt;
  const std::array<double, 2> face_widths =
      judged.pair
          ? std::array{judged.pair->gear(1).spec.face_width, judged.pair->gear(2).spec.face_width}
          : std::array{judged.rack->pinion.spec.face_width, judged.rack->rack.face_width};
  const std::vector<ContactPoint>& positions = judged.contact->positions;
  // For a double-helical pair, the list has all positions of the first half, followed by all
  // positions of the second half.
  const bool two_halves = judged.pair && judged.pair->gear(1).gap;
  const std::size_t rotations = positions.size() / (two_halves ? 2 : 1);
  std::size_t touching = 0, edges = 0, points = 0;
  std::array<double, 2> sum{};
  for (std::size_t k = 0; k < rotations; ++k) {
    bool touches = false, at_edge = false;
    for (std::size_t i = k; i < positions.size(); i += rotations) {
      const ContactPoint& p = positions[i];
      touches = touches || p.kind != TouchKind::none;
      at_edge = at_edge || is_edge(p.kind);
      if (p.kind == TouchKind::none || p.kind == TouchKind::line) continue;
      ++points;
      for (const std::size_t g : {0u, 1u}) sum[g] += p.height[g] / (face_widths[g] / 2);
    }
    touching += touches;
    edges += at_edge;
  }
  if (touching == 0) return std::nullopt;
  PatternPlace place{static_cast<double>(edges) / static_cast<double>(touching), {}};
  if (points > 0)
    place.mean =
        (std::abs(sum[1]) > std::abs(sum[0]) ? sum[1] : sum[0]) / static_cast<double>(points);
  return place;
}

bool is_listed_before(const Finding& a, const Finding& b) {
  if (a.level != b.level) return a.level > b.level;
  if (a.level == Level::green) return false;
  if (is_safety(a.code) && is_safety(b.code)) return false;
  return a.code < b.code;
}

bool worse(const Finding& a, const Finding& b) {
  if (a.level != b.level) return a.level > b.level;
  return !a.values.empty() && !b.values.empty() && a.values[0].value < b.values[0].value;
}

Verdict verdict_of(const Judged& judged, std::vector<Finding> findings, const TryChange& attempt) {
  GW_EXPECTS(!judged.gears.empty());
  Verdict verdict;
  verdict.findings = std::move(findings);
  std::stable_sort(verdict.findings.begin(), verdict.findings.end(), is_listed_before);
  if (!verdict.findings.empty()) verdict.level = verdict.findings.front().level;
  detail::add_remedies(verdict.findings, judged, attempt);
  verdict.headline = headline(judged, verdict);
  return verdict;
}

}  // namespace gearwright
