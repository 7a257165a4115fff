#include "gearwright/job/judgement.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gearwright/job/contact_answer.hpp"
#include "gearwright/job/contact_report.hpp"
#include "gearwright/job/default_notes.hpp"
#include "gearwright/job/spec_change.hpp"
#include "gearwright/job/tolerance_corners.hpp"
#include "gearwright/rating/rated_pair.hpp"

namespace gearwright {

namespace {

Judged judged_of(const SolvedJob& job, const JudgedParts& parts) {
  GW_EXPECTS(job.given != nullptr);
  Judged judged;
  for (const Gear& gear : job.gears) judged.gears.push_back(&gear);
  judged.pair = job.pair ? &*job.pair : nullptr;
  judged.warnings = &job.warnings;
  judged.contact = parts.contact;
  judged.errors = job.spec.errors.any();
  judged.tolerances = job.ends != nullptr;
  if (job.pair) {
    const auto& gears = job.given->gears;
    const auto& pair = job.given->pair;
    const bool absent =
        job.pair->involute() && !(gears[0]->profile_shift && gears[1]->profile_shift);
    judged.shifts_follow = shifts_follow(*job.given);
    judged.distance_sets_shifts = absent && !pair.center_distance;
  }
  if (parts.rating) {
    const RatingAnswer& r = *parts.rating;
    judged.rating = JudgedRating{&r.pair, &r.input, &r.rating, r.wanted};
  }
  return judged;
}

// The same rating of the gears at a corner of the tolerances; none: the standard has none there.
std::optional<RatingAnswer> rated_again(const SolvedJob& job, const RatingAnswer& nominal) {
  std::array<double, 2> bore{};
  for (const int which : {1, 2})
    if (const auto given = job.bore(which))
      bore[static_cast<std::size_t>(which - 1)] = given->diameter;
  auto pair = rated_pair(*job.pair->involute(), bore);
  if (!pair) return std::nullopt;
  RatingAnswer answer = nominal;
  answer.pair = *pair;
  auto rating = rate(answer.pair, answer.input);
  if (!rating) return std::nullopt;
  answer.rating = std::move(rating).take();
  return answer;
}

std::vector<Finding> findings_at(const SolvedJob& job,
                                 const std::vector<TolerancedNumber>& tolerances,
                                 const ToleranceCorner& corner, const JudgedParts& parts) {
  const auto there = at_corner(job, tolerances, corner);
  if (!there) return {};  // the ends themselves have been solved
  const auto rating = parts.rating ? rated_again(*there, *parts.rating) : std::nullopt;
  return findings_of(judged_of(*there, {nullptr, rating ? &*rating : nullptr, false}));
}

auto same_finding(const Finding& like) {
  return [&like](const Finding& f) { return f.code == like.code && f.gear == like.gear; };
}

// The corner with every tolerance at its nominal value that makes no difference to the finding.
ToleranceCorner what_matters(const SolvedJob& job, const std::vector<TolerancedNumber>& tolerances,
                             ToleranceCorner corner, const Finding& finding,
                             const JudgedParts& parts) {
  for (std::size_t k = 0; k < corner.size(); ++k) {
    ToleranceCorner less = corner;
    less[k].reset();
    if (std::none_of(less.begin(), less.end(), [](const auto& end) { return end.has_value(); }))
      continue;
    const auto found = findings_at(job, tolerances, less, parts);
    const auto it = std::find_if(found.begin(), found.end(), same_finding(finding));
    if (it != found.end() && !worse(finding, *it)) corner = less;
  }
  return corner;
}

// As drawn, and what is of a worse level at an end of the tolerances.
std::vector<Finding> findings_within_tolerances(const SolvedJob& job, const JudgedParts& parts) {
  std::vector<Finding> findings = findings_of(judged_of(job, parts));
  const std::vector<TolerancedNumber> tolerances = tolerances_of(job);
  if (tolerances.empty()) return findings;
  struct Worst {
    Finding finding;
    ToleranceCorner corner;
  };
  std::vector<Worst> list;
  for (const ToleranceCorner& corner : corners_of(tolerances)) {
    for (Finding& f : findings_at(job, tolerances, corner, parts)) {
      const auto drawn = std::find_if(findings.begin(), findings.end(), same_finding(f));
      if (f.level <= (drawn == findings.end() ? Level::green : drawn->level)) continue;
      const auto same = std::find_if(list.begin(), list.end(),
                                     [&](const Worst& w) { return same_finding(f)(w.finding); });
      if (same == list.end()) {
        list.push_back({std::move(f), corner});
      } else if (worse(f, same->finding)) {
        *same = {std::move(f), corner};
      }
    }
  }
  for (Worst& w : list) {
    w.finding.at =
        corner_words(tolerances, what_matters(job, tolerances, w.corner, w.finding, parts));
    const auto drawn = std::find_if(findings.begin(), findings.end(), same_finding(w.finding));
    if (drawn == findings.end()) {
      findings.push_back(std::move(w.finding));
    } else {
      *drawn = std::move(w.finding);
    }
  }
  return findings;
}

std::optional<ChangedState> tried(const SolvedJob& job, const SpecChange& change, TryDepth depth) {
  JobSpec spec = *job.given;
  const bool with_contact = depth == TryDepth::with_contact;
  if (with_contact) {  // a door may have set these after the spec was solved
    spec.errors = job.spec.errors;
    spec.contact = job.spec.contact;
    for (std::size_t i = 0; i < job.gears.size(); ++i)
      spec.gears[i]->modifications = job.spec.gears[i]->modifications;
    spec.contact.map.reset();
    spec.contact.pattern = false;
  }
  if (!make_change(spec, change)) return std::nullopt;
  auto solved = solve(spec, job.pair ? Scope::pair : Scope::gears);
  if (!solved) return std::nullopt;
  SolvedJob changed = std::move(solved).take();
  std::optional<ContactAnswer> contact;
  if (with_contact) {
    auto answer = answer_contact(changed);
    if (!answer) return std::nullopt;
    contact = std::move(answer).take();
  }
  const JudgedParts parts{.contact = contact ? &contact->driving : nullptr};
  ChangedState state;
  state.findings = depth == TryDepth::as_drawn ? findings_of(judged_of(changed, parts))
                                               : findings_within_tolerances(changed, parts);
  if (changed.pair) {
    state.contact_ratio = true_contact_ratio(*changed.pair);
    const InvolutePair* p = changed.pair->involute();
    state.backlash = p ? p->mesh.backlash.normal : changed.pair->arcs()->backlash_normal;
  }
  return state;
}

std::vector<std::string> not_judged(const SolvedJob& job, const JudgedParts& parts) {
  std::vector<std::string> list;
  if (!job.pair) {
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
  Verdict verdict = verdict_of(
      judged_of(job, parts), findings_within_tolerances(job, parts),
      [&](const SpecChange& change, TryDepth depth) { return tried(job, change, depth); });
  verdict.not_judged = not_judged(job, parts);
  return verdict;
}

std::string verdict_listing(std::string_view level, std::string_view headline) {
  constexpr std::size_t kWidth = 80;  // of a terminal
  std::string text = fmt::format("\nVerdict: {}.", level);
  std::size_t column = text.size() - 1;
  while (!headline.empty()) {
    const std::size_t end = std::min(headline.find(' '), headline.size());
    const std::string_view word = headline.substr(0, end);
    headline.remove_prefix(std::min(end + 1, headline.size()));
    const bool fits = column + 1 + word.size() <= kWidth;
    text += fits ? " " : "\n  ";
    column = (fits ? column + 1 : 2) + word.size();
    text += word;
  }
  return text + "\n";
}

std::string verdict_listing(const Verdict& verdict) {
  std::string text = verdict.headline;
  if (!verdict.not_judged.empty())
    text += fmt::format(" Not judged: {}.", fmt::join(verdict.not_judged, ", "));
  return verdict_listing(to_string(verdict.level), text);
}

}  // namespace gearwright
