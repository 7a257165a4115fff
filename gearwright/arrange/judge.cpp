#include "gearwright/arrange/judge.hpp"

#include <algorithm>

#include "gearwright/arrange/given_change.hpp"
#include "gearwright/arrange/notes.hpp"
#include "gearwright/arrange/tolerance_ends.hpp"
#include "gearwright/rating/rated_pair.hpp"

namespace gearwright {

namespace {

Judged judged_of(const Arranged& arranged, const JudgedWith& with) {
  Judged judged;
  for (const Gear& gear : arranged.gears) judged.gears.push_back(&gear);
  judged.pair = arranged.pair ? &*arranged.pair : nullptr;
  judged.warnings = &arranged.warnings;
  judged.contact = with.contact;
  judged.errors = with.errors;
  judged.tolerances = arranged.ends != nullptr;
  if (arranged.pair) {
    const auto& gears = arranged.given->gears;
    const auto& pair = arranged.given->pair;
    const bool absent =
        arranged.pair->involute() && !(gears[0]->profile_shift && gears[1]->profile_shift);
    judged.shifts_follow = shifts_follow(*arranged.given);
    judged.distance_sets_shifts = absent && !pair.center_distance;
  }
  judged.rating = with.rating;
  return judged;
}

// The changed gears, rated with the original load. None if the standard does not cover these gears.
struct RatedAgain {
  RatedPair pair;
  Rating rating;
};
std::optional<RatedAgain> rated_again(const Arranged& arranged, const JudgedRating& nominal) {
  auto pair = rated_pair(*arranged.pair);
  if (!pair) return std::nullopt;
  RatedPair again = std::move(pair).take();
  again.halves = nominal.pair->halves;
  auto rating = rate(again, *nominal.input);
  if (!rating) return std::nullopt;
  return RatedAgain{std::move(again), std::move(rating).take()};
}

JudgedState state_at(const Arranged& arranged, const std::vector<TolerancedNumber>& tolerances,
                     const ToleranceCorner& corner, const JudgedWith& with) {
  const auto there = at_corner(arranged, tolerances, corner);
  if (!there) return {};  // a corner may have no solution although both ends have one
  JudgedWith of_there;
  const auto rated = with.rating ? rated_again(*there, *with.rating) : std::nullopt;
  if (rated)
    of_there.rating =
        JudgedRating{&rated->pair, with.rating->input, &rated->rating, with.rating->wanted};
  of_there.errors = with.errors;
  JudgedState state{findings_of(judged_of(*there, of_there)), {}};
  if (rated) state.pair = rated->pair;
  return state;
}

auto same_finding(const Finding& like) {
  return [&like](const Finding& f) { return f.code == like.code && f.gear == like.gear; };
}

// Resets every toleranced number that does not affect the finding to its nominal value.
ToleranceCorner what_matters(const Arranged& arranged,
                             const std::vector<TolerancedNumber>& tolerances,
                             ToleranceCorner corner, const Finding& finding,
                             const JudgedWith& with) {
  for (std::size_t k = 0; k < corner.size(); ++k) {
    ToleranceCorner less = corner;
    less[k].reset();
    if (std::none_of(less.begin(), less.end(), [](const auto& end) { return end.has_value(); }))
      continue;
    const auto found = state_at(arranged, tolerances, less, with).findings;
    const auto it = std::find_if(found.begin(), found.end(), same_finding(finding));
    if (it != found.end() && !worse(finding, *it)) corner = less;
  }
  return corner;
}

}  // namespace

void visit_states(const Arranged& arranged, const JudgedWith& with,
                  const std::function<bool(const JudgedState&)>& visit) {
  if (!visit({findings_of(judged_of(arranged, with)), {}})) return;
  const std::vector<TolerancedNumber> tolerances = tolerances_of(arranged);
  if (tolerances.empty()) return;
  for (const ToleranceCorner& corner : corners_of(tolerances))
    if (!visit(state_at(arranged, tolerances, corner, with))) return;
}

std::vector<Finding> findings_within_tolerances(const Arranged& arranged, const JudgedWith& with) {
  std::vector<Finding> findings = findings_of(judged_of(arranged, with));
  const std::vector<TolerancedNumber> tolerances = tolerances_of(arranged);
  if (tolerances.empty()) return findings;
  struct Worst {
    Finding finding;
    ToleranceCorner corner;
  };
  std::vector<Worst> list;
  for (const ToleranceCorner& corner : corners_of(tolerances)) {
    JudgedState state = state_at(arranged, tolerances, corner, with);
    for (Finding& f : state.findings) {
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
        corner_words(tolerances, what_matters(arranged, tolerances, w.corner, w.finding, with));
    const auto drawn = std::find_if(findings.begin(), findings.end(), same_finding(w.finding));
    if (drawn == findings.end()) {
      findings.push_back(std::move(w.finding));
    } else {
      *drawn = std::move(w.finding);
    }
  }
  return findings;
}

namespace {

std::optional<ChangedState> tried(const Arranged& arranged, const JudgedWith& with,
                                  const SpecChange& change, TryDepth depth) {
  GivenPair given = *arranged.given;
  if (!make_change(given, change)) return std::nullopt;
  auto made = arrange(given, arranged.pair ? Scope::pair : Scope::gears);
  if (!made) return std::nullopt;
  Arranged changed = std::move(made).take();
  JudgedWith of_changed{.errors = with.errors};
  std::optional<ContactResult> contact;
  if (depth == TryDepth::with_contact) {
    if (with.contact_again) contact = with.contact_again(changed);
    if (!contact) return std::nullopt;
    of_changed.contact = &*contact;
  }
  ChangedState state;
  state.findings = depth == TryDepth::as_drawn ? findings_of(judged_of(changed, of_changed))
                                               : findings_within_tolerances(changed, of_changed);
  if (changed.pair) {
    state.contact_ratio = changed.pair->contact_ratio_true();
    state.backlash = changed.pair->normal_backlash();
  }
  return state;
}

}  // namespace

Verdict judge(const Arranged& arranged, const JudgedWith& with) {
  GW_EXPECTS(arranged.given != nullptr);
  return verdict_of(judged_of(arranged, with), findings_within_tolerances(arranged, with),
                    [&](const SpecChange& change, TryDepth depth) {
                      return tried(arranged, with, change, depth);
                    });
}

}  // namespace gearwright
