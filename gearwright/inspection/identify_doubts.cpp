// Checks the inputs of an identification. The tip or the root may contradict the flanks, or the
// gear may be implausible. A mistake in the number of teeth of the gear or of the spans, or in the
// unit of a reading, may explain these findings.
//                                              theory: docs/theory/10-inspection.md
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "gearwright/base/number_text.hpp"
#include "gearwright/inspection/identify_model.hpp"

namespace gearwright {

namespace {

// Groups of readings. A user may have written all readings of a group in the same wrong unit.
constexpr std::array kGroups{Reading::all,           Reading::span,
                             Reading::over_balls,    Reading::tip_diameter,
                             Reading::root_diameter, Reading::center_distance};

// Calls visit(reading, value) for every length of the problem, including the diameters of balls.
template <class Visit>
void each_length(IdentifyProblem& p, const Visit& visit) {
  for (SpanReading& s : p.spans) visit(Reading::span, s.value);
  for (DiameterReading& b : p.balls) {
    visit(Reading::over_balls, b.value);
    visit(Reading::over_balls, b.tool);
  }
  for (const auto& [reading, length] : {std::pair{Reading::lead, &p.lead},
                                        {Reading::tip_diameter, &p.tip},
                                        {Reading::root_diameter, &p.root},
                                        {Reading::center_distance, &p.distance}}) {
    if (length->value) visit(reading, *length->value);
  }
}

// True if the group is `all`, or if the problem has readings of this and of another group.
bool has_group(IdentifyProblem p, Reading group) {
  bool own = group == Reading::all, others = own;
  each_length(p, [&](Reading one, double) {
    if (one != Reading::lead) (one == group ? own : others) = true;
  });
  return own && others;
}

IdentifyProblem scaled(IdentifyProblem p, Reading group, double factor) {
  each_length(p, [&](Reading one, double& length) {
    if (group == Reading::all || group == one) length *= factor;
  });
  return p;
}

// Returns the identification. If the reading of the tip or the root contradicts the flanks of the
// likeliest gear, this reading is left out.
Identification without_contradiction(const IdentifyProblem& problem) {
  Identification answer = detail::identify_readings(problem, detail::LeaveOut::one);
  if (answer.contradiction || !answer.reason.empty() || answer.candidates.empty()) return answer;
  const auto contradiction = answer.candidates.front().contradiction;
  if (!contradiction) return answer;
  IdentifyProblem others = problem;
  (contradiction->reading == Reading::tip_diameter ? others.tip : others.root).value.reset();
  answer = detail::identify_readings(others, detail::LeaveOut::one);
  // The reading is compared with the gear that the other readings determine. The expected value is
  // the value of this gear.
  auto expected = contradiction;
  if (!answer.candidates.empty()) {
    const IdentifiedGear& gear = answer.candidates.front();
    expected->expected = contradiction->reading == Reading::tip_diameter ? gear.nominal_tip_diameter
                                                                         : gear.root_diameter;
  }
  answer.contradiction = std::move(expected);
  return answer;
}

bool sound(const Identification& found) {
  return found.reason.empty() && !found.contradiction && !found.candidates.empty() &&
         found.candidates.front().series != ModuleSeries::none &&
         found.candidates.front().plausible();
}

// Greatest magnitude of the thickness allowance, in modules, of a proposed alternative.
constexpr double kUsualAllowanceOfMistake = 0.1;

// True if tip and thickness of the gear are so usual that the gear is credible as an alternative.
bool agrees_well(const IdentifiedGear& g) {
  return g.thickness_allowance >= -kUsualAllowanceOfMistake * g.normal_module &&
         g.tip != TipReading::longer && g.tip != TipReading::shortened;
}

// Greatest magnitude of the profile shift of most gears. If the profile shift is greater,
// identify() searches for a mistake whose correction gives a smaller profile shift.
constexpr double kUsualShift = 1.0;

bool is_usual(const IdentifiedGear& g) { return std::abs(g.generating_shift) <= kUsualShift; }

// Returns a gear that agrees with all readings after one mistake is corrected, or none if there is
// no such gear.
std::optional<Alternative> alternative_of(const IdentifyProblem& problem) {
  const auto found = [](const IdentifyProblem& p) -> std::optional<IdentifiedGear> {
    const Identification answer = detail::identify_readings(p, detail::LeaveOut::none);
    if (!sound(answer) || answer.candidates.front().contradiction ||
        !agrees_well(answer.candidates.front()))
      return std::nullopt;
    return answer.candidates.front();
  };
  for (const Reading group : kGroups) {
    if (!has_group(problem, group)) continue;
    if (const auto gear = found(scaled(problem, group, problem.other_unit)))
      return Alternative{group, *gear};
  }
  // If neither tip nor root was measured, a gear with another number of teeth has nearly the same
  // readings, so the number of teeth cannot be checked.
  const bool size_measured = problem.tip.value || problem.root.value;
  for (const int off : {1, 2}) {
    if (!size_measured) break;
    std::optional<Alternative> best;
    for (const int step : {-off, off}) {
      IdentifyProblem other = problem;
      other.teeth += step;
      if (std::abs(other.teeth) < 3) continue;
      const auto gear = found(other);
      if (gear && (!best || std::abs(gear->profile_shift) < std::abs(best->gear.profile_shift)))
        best = Alternative{Reading::teeth, *gear};
    }
    if (best) return best;
  }
  for (const int step : {-1, +1}) {
    if (problem.spans.empty()) break;
    IdentifyProblem other = problem;
    for (SpanReading& s : other.spans) s.teeth += step;
    if (std::any_of(other.spans.begin(), other.spans.end(),
                    [](const SpanReading& s) { return s.teeth < 1; }))
      continue;
    if (const auto gear = found(other)) return Alternative{Reading::span_teeth, *gear, step};
  }
  return std::nullopt;
}

// Returns an error if the lead excludes the helix angle for every gear.
std::optional<Error> lead_error(const IdentifyProblem& p) {
  if (!p.lead.value) return std::nullopt;
  for (const auto& beta : {p.helix_angle, p.helix.value}) {
    if (!beta) continue;
    if (beta->rad() == 0.0)
      return refused("measured.lead", *p.lead.value,
                     "cannot be combined with the helix angle 0°, because the lead of a spur gear "
                     "is infinite; leave out one of the two");
    if (*p.lead.value * beta->rad() < 0.0)
      return refused(
          "measured.lead", *p.lead.value,
          fmt::format("has the other sign than the helix angle {}°; both are positive for "
                      "right hand and negative for left hand",
                      format_number(beta->deg())));
  }
  return std::nullopt;
}

// Returns an error if the tip diameter and the root diameter exclude each other for every gear.
std::optional<Error> depth_error(const IdentifyProblem& p) {
  if (!p.tip.value || !p.root.value) return std::nullopt;
  const bool internal = p.teeth < 0;
  if (internal ? *p.root.value > *p.tip.value : *p.root.value < *p.tip.value) return std::nullopt;
  return refused("measured.root_diameter", *p.root.value,
                 fmt::format("must be {} than the tip diameter, {} mm; check both readings",
                             internal ? "greater" : "less", format_number(*p.tip.value)));
}

}  // namespace

Result<Identification> identify(const IdentifyProblem& problem) {
  if (problem.teeth == 0 || std::abs(problem.teeth) < 3)
    return refused("teeth", problem.teeth,
                   "must be at least 3, or at most -3 for an internal gear; count the teeth");
  if (problem.spans.empty() && problem.balls.empty() && !problem.tip.value && !problem.root.value &&
      !(problem.distance.value && problem.mating_teeth))
    return Error{"measured", "",
                 "no reading determines the size of the gear; measure spans over two numbers of "
                 "teeth and a dimension over balls"};
  if (auto error = lead_error(problem)) return *error;
  const auto error = depth_error(problem);
  Identification answer = without_contradiction(problem);
  if (!error && sound(answer) && is_usual(answer.candidates.front())) return answer;
  auto alternative = alternative_of(problem);
  // If one of the two diameters is in the wrong unit, the alternative states this.
  if (error && !alternative) return *error;
  if (alternative && (error || !sound(answer) || is_usual(alternative->gear)))
    answer.alternative = std::move(alternative);
  return answer;
}

}  // namespace gearwright
