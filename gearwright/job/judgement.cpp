#include "gearwright/job/judgement.hpp"

#include <fmt/format.h>

#include "gearwright/arrange/judge.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/contact_report.hpp"
#include "gearwright/job/listing.hpp"

namespace gearwright {

namespace {

std::vector<std::string> not_judged(const SolvedJob& job, const JudgedParts& parts) {
  std::vector<std::string> list;
  if (!job.mounted()) {
    if (job.gears.size() > 1) list.emplace_back("pair");
    return list;
  }
  if (!parts.contact && wants_contact(job)) list.emplace_back("contact");
  if (!parts.load && !job.spec.load.torques.empty()) list.emplace_back("load");
  if (!parts.rating && job.spec.rating.given) list.emplace_back("rating");
  return list;
}

}  // namespace

Verdict judge(const SolvedJob& job, const JudgedParts& parts) {
  JudgedWith with{.contact = parts.contact, .errors = job.spec.errors.any()};
  with.contact_again = [&](Arranged& changed) -> std::optional<ContactResult> {
    SolvedJob again{std::move(changed), job.spec, job.halves};
    again.spec.contact.map.reset();
    again.spec.contact.pattern = false;
    const auto answer = answer_contact(again);
    changed = std::move(again);
    return answer ? std::optional(answer->judged()) : std::nullopt;
  };
  if (parts.rating) with.rating = *parts.rating;
  Verdict verdict = judge(static_cast<const Arranged&>(job), with);
  for (Finding& f : verdict.findings)
    f.message = spelled(f.message, job.spec.given, f.gear == 0 ? "" : gear_field(f.gear));
  verdict.not_judged = not_judged(job, parts);
  return verdict;
}

std::string verdict_listing(std::string_view level, std::string_view headline) {
  return "\n" +
         wrapped(fmt::format("Verdict: {}.{}{}", level, headline.empty() ? "" : " ", headline));
}

std::string verdict_listing(const Verdict& verdict, UnitSystem units) {
  std::string text = sentence_in(units, verdict.headline);
  if (!verdict.not_judged.empty())
    text += fmt::format(" Parts that are not judged: {}.", fmt::join(verdict.not_judged, ", "));
  return verdict_listing(to_string(verdict.level), text);
}

}  // namespace gearwright
