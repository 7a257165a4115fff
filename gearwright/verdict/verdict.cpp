#include "gearwright/verdict/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "gearwright/base/contract.hpp"
#include "gearwright/pair/drive.hpp"
#include "gearwright/verdict/margins.hpp"
#include "gearwright/verdict/rating_findings.hpp"
#include "gearwright/verdict/remedy.hpp"

namespace gearwright {

namespace {

Level level_of(Severity severity) {
  switch (severity) {
    case Severity::problem: return Level::red;
    case Severity::caution: return Level::amber;
    case Severity::note: return Level::green;
  }
  return Level::amber;
}

std::vector<std::string> reasons(const std::vector<Warning>& warnings) {
  std::vector<std::string> list;
  for (const Warning& w : warnings) {
    const Meaning meaning = meaning_of(w);
    if (meaning.severity != Severity::problem) continue;
    if (std::find(list.begin(), list.end(), meaning.reason) == list.end())
      list.emplace_back(meaning.reason);
  }
  return list;
}

std::string joined(const std::vector<std::string>& list) {
  std::string text;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i > 0) text += i + 1 == list.size() ? " and " : ", ";
    text += list[i];
  }
  return text;
}

// The least normal backlash of gears and housing of iron or steel below 15 m/s, mm.
// Source  ISO/TR 10064-2:1996, annex A: 2/3 (0.06 + 0.0005 a + 0.03 m_n)
double recommended_backlash(double center_distance, double normal_module) {
  return 2.0 / 3.0 * (0.06 + 0.0005 * center_distance + 0.03 * normal_module);
}

// A backlash that is shown as 0.0000 mm is none: right for a table of nominal teeth, not for gears
// that are to turn.
std::string backlash_words(double j, double center_distance, double normal_module) {
  if (std::abs(j) >= 0.5e-4) return fmt::format("a normal backlash of {:.4f} mm", j);
  return fmt::format("no backlash (ISO/TR 10064-2 recommends at least {:.2f} mm)",
                     recommended_backlash(center_distance, normal_module));
}

std::string running(const ArcPair& pair) {
  if (pair.contacts.empty())
    return "The gears are not of one lead: where they touch is a matter of contact analysis.";
  return fmt::format(
      "The pair runs: contact is continuous (overlap ratio {:.5f}), with {} per tooth and {}.",
      pair.overlap_ratio,
      pair.contacts.size() == 1 ? "one point of contact"
                                : fmt::format("{} points of contact", pair.contacts.size()),
      backlash_words(pair.backlash_normal, pair.center_distance, pair.gears[0].spec.normal_module));
}

bool uncut_ring(const Gear* gear) { return gear->internal() && !gear->tooth; }

constexpr const char* kNoCutter =
    " The internal gear’s cutter is not given: its root fillet is not checked.";

std::string running(const InvolutePair& p) {
  const std::optional<double> face = face_width_needed(p);
  const std::string contact =
      face
          ? fmt::format(
                "The pair runs only as a helical gear pair: transverse contact ratio {:.3f}, total "
                "{:.3f}; it needs b ≥ {:.2f} mm. There is",
                p.mesh.true_ratio, p.contact_ratio_true(), *face)
          : fmt::format("The pair runs: contact is continuous ({}contact ratio {:.3f}), there is",
                        p.crossed() ? "" : "total ", p.contact_ratio_true());
  const bool nothing_strikes = p.interference.empty() && p.beyond_flank.empty();
  return fmt::format(
      "{} {}{}.{}", contact,
      backlash_words(p.mesh.backlash.normal, p.center_distance, p.gears[0].spec.normal_module),
      nothing_strikes ? " and no interference" : "", uncut_ring(&p.gears[1]) ? kNoCutter : "");
}

std::string gears_alone(const Judged& judged) {
  const char* who = judged.gears.size() == 1 ? "The gear" : "Each gear";
  if (std::any_of(judged.gears.begin(), judged.gears.end(), uncut_ring)) {
    return fmt::format(
        "{} has the data below; an internal gear’s outline is what its pinion cutter leaves, which "
        "is not given, and is not checked.",
        who);
  }
  return fmt::format("{} can be cut as specified.", who);
}

// How it stands, when nothing speaks against it.
std::string standing(const Judged& judged) {
  if (!judged.pair) return gears_alone(judged);
  const std::string nominal = judged.pair->visit([](const auto& pair) { return running(pair); });
  if (!judged.contact || !judged.errors) return nominal;
  return "Under its errors a tooth pair touches in every position. Without them: " + nominal;
}

std::string not_running(const Judged& judged, const std::vector<std::string>& against) {
  if (!judged.pair) {
    return fmt::format("{} has a problem: {}.", judged.gears.size() == 1 ? "The gear" : "Each gear",
                       joined(against));
  }
  std::string text = fmt::format("The pair does not run as specified: {}.", joined(against));
  const InvolutePair* p = judged.pair->involute();
  const auto face = p ? face_width_needed(*p) : std::nullopt;
  if (face && p->contact_ratio_true() < 1.0) {
    text += fmt::format(
        " With a transverse contact ratio of {:.3f} contact is continuous only on helical gears, "
        "from b ≥ {:.2f} mm on.",
        p->mesh.true_ratio, *face);
  }
  return text;
}

std::string headline(const Judged& judged, const Verdict& verdict) {
  for (std::size_t i = 0; i < judged.gears.size(); ++i) {
    const Gear& gear = *judged.gears[i];
    if (gear.exists()) continue;
    return fmt::format("Gear {} cannot be made as specified: {}.", i + 1,
                       gear.tooth->through_axis ? "the cutter passes its axis"
                                                : "its teeth are cut off at their roots");
  }
  if (verdict.level == Level::green) return standing(judged);
  const Finding& worst = verdict.findings.front();
  if (verdict.level == Level::red) {
    const std::vector<std::string> against = reasons(*judged.warnings);
    if (against.empty()) return "The pair does not hold its load. " + worst.whole();
    const std::string text = not_running(judged, against);
    return worst.remedy.empty() ? text : text + " " + worst.remedy;
  }
  const std::string where = worst.gear > 0 && worst.message.find("gear ") == std::string::npos
                                ? fmt::format("Gear {}: ", worst.gear)
                                : "";
  return fmt::format("{} To look at: {}{}", standing(judged), where, worst.whole());
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

Verdict verdict_of(const Judged& judged) {
  GW_EXPECTS(!judged.gears.empty() && judged.warnings != nullptr);
  Verdict verdict;
  for (const Warning& w : *judged.warnings) {
    const Meaning meaning = meaning_of(w);
    verdict.findings.push_back({w.code,
                                level_of(meaning.severity),
                                w.gear,
                                w.message,
                                detail::remedy_for(w, judged),
                                {},
                                meaning.told});
  }
  const auto add = [&](std::vector<Finding> more) {
    for (Finding& f : more) verdict.findings.push_back(std::move(f));
  };
  if (judged.pair) add(detail::margin_findings(*judged.pair));
  if (judged.rating) add(detail::rating_findings(*judged.rating));
  if (judged.contact && judged.pair) add(detail::contact_findings(*judged.contact, *judged.pair));
  std::stable_sort(verdict.findings.begin(), verdict.findings.end(),
                   [](const Finding& a, const Finding& b) { return a.level > b.level; });
  if (!verdict.findings.empty()) verdict.level = verdict.findings.front().level;
  verdict.headline = headline(judged, verdict);
  return verdict;
}

}  // namespace gearwright
