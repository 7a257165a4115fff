#include "gearwright/design/nearest_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

bool feasible(const SearchProblem& problem) {
  if (!(problem.ratio[0] <= problem.ratio[1])) return false;
  const double most = std::max(std::abs(problem.ratio[0]), std::abs(problem.ratio[1]));
  if (!(most * problem.pinion_teeth[1] <= kMaxSearchTeeth)) return false;
  const Search search(problem);
  if (!search.space().size() || *search.space().size() > 20 * kMaxForChange) return false;
  return search.exists(0, *search.space().size());
}

std::string shown(double v) { return fmt::format("{:.10g}", v); }
std::string shown(const std::array<double, 2>& b) {
  return b[0] == b[1] ? shown(b[0]) : fmt::format("[{:.10g}, {:.10g}]", b[0], b[1]);
}

// A number that may move from its value towards a far end.
struct Knob {
  std::string field;  // of SearchProblem
  double value, far;
  double scale;  // one unit of effort
  bool whole;    // teeth
  std::function<void(SearchProblem&, double)> set;
  std::function<std::string(double)> show;
};

// The least move after which a design exists, rounded outwards to four digits of the move.
std::optional<double> min_move(const SearchProblem& problem, const Knob& knob) {
  const auto works = [&](double value) {
    SearchProblem p = problem;
    knob.set(p, value);
    return feasible(p);
  };
  if (knob.value == knob.far || !works(knob.far)) return std::nullopt;
  // The change is printed with four digits of itself: this much of the value is beyond all of them.
  constexpr double kEnough = 1e-9;
  double no = knob.value;
  double yes = knob.far;
  const double enough = knob.whole ? 1.0 : kEnough * std::max(1.0, std::abs(knob.value));
  while (std::abs(yes - no) > enough) {
    double middle = (no + yes) / 2.0;
    if (knob.whole) middle = knob.far < knob.value ? std::floor(middle) : std::ceil(middle);
    if (middle == no || middle == yes) break;
    (works(middle) ? yes : no) = middle;
  }
  if (knob.whole) return yes;
  const double move = yes - knob.value;
  const double step = std::pow(10.0, std::floor(std::log10(std::abs(move))) - 3.0);
  constexpr double kWhole = 1e-6;  // of a step: a move of whole steps is not one step more
  const double rounded =
      knob.value + std::copysign(std::ceil(std::abs(move) / step - kWhole) * step, move);
  const double tidy = std::stod(shown(rounded));
  return works(tidy) ? tidy : yes;
}

std::vector<Knob> knobs(const SearchProblem& p) {
  std::vector<Knob> k;
  const auto plain = [](double v) { return shown(v); };
  k.push_back({"limits.contact_ratio", p.limits.contact_ratio,
               std::min(1.0, p.limits.contact_ratio), 1.0, false,
               [](SearchProblem& q, double v) { q.limits.contact_ratio = v; }, plain});
  k.push_back({"limits.tip_thickness", p.limits.tip_thickness, 0.0, 1.0, false,
               [](SearchProblem& q, double v) { q.limits.tip_thickness = v; }, plain});
  if (p.center_distance) {
    const auto band = *p.center_distance;
    for (const int i : {0, 1}) {
      k.push_back({"center_distance", band[i], band[i] * (i == 0 ? 0.5 : 2.0), band[i], false,
                   [i](SearchProblem& q, double v) { (*q.center_distance)[i] = v; },
                   [band, i](double v) {
                     auto b = band;
                     b[i] = v;
                     return shown(b);
                   }});
    }
  }
  for (const int i : {0, 1}) {
    const auto band = p.ratio;
    const double widen = (i == 0 ? -0.5 : 0.5) * std::abs(band[i]);
    double far = band[i] + widen;
    if (!p.internal()) far = std::max(far, 1.0);
    // An internal gear has more teeth than its pinion: no ratio from −1 up.
    constexpr double kBeyondOne = 1e-3;
    if (p.internal() && i == 1) far = std::min(far, -1.0 - kBeyondOne);
    k.push_back({"ratio", band[i], far, std::abs(band[i]), false,
                 [i](SearchProblem& q, double v) { q.ratio[i] = v; },
                 [band, i](double v) {
                   auto b = band;
                   b[i] = v;
                   return shown(b);
                 }});
    const auto teeth = p.pinion_teeth;
    const double far_teeth = i == 0 ? std::min(5, teeth[0]) : 2.0 * teeth[1] + 10.0;
    k.push_back(
        {"pinion_teeth", static_cast<double>(teeth[i]), far_teeth, static_cast<double>(teeth[i]),
         true, [i](SearchProblem& q, double v) { q.pinion_teeth[i] = static_cast<int>(v); },
         [teeth, i](double v) {
           std::array<double, 2> b{static_cast<double>(teeth[0]), static_cast<double>(teeth[1])};
           b[i] = v;
           return shown(b);
         }});
  }
  if (p.limits.min_shift && p.limits.max_shift) {
    const std::array<double, 2> band{*p.limits.min_shift, *p.limits.max_shift};
    for (const int i : {0, 1}) {
      k.push_back({i == 0 ? "limits.min_shift" : "limits.max_shift", band[i],
                   band[i] + (i == 0 ? -2.0 : 2.0), 1.0, false,
                   [i](SearchProblem& q, double v) {
                     (i == 0 ? q.limits.min_shift : q.limits.max_shift) = v;
                   },
                   [band, i](double v) {
                     auto b = band;
                     b[i] = v;
                     return shown(b);
                   }});
    }
  }
  if (p.limits.undercut_margin > 0.0) {
    k.push_back({"limits.undercut_margin", p.limits.undercut_margin, 0.0, 1.0, false,
                 [](SearchProblem& q, double v) { q.limits.undercut_margin = v; }, plain});
  }
  if (p.limits.overlap_ratio) {
    k.push_back({"limits.overlap_ratio", *p.limits.overlap_ratio, 0.0, 1.0, false,
                 [](SearchProblem& q, double v) { q.limits.overlap_ratio = v; }, plain});
  }
  if (p.limits.sliding) {
    k.push_back({"limits.sliding", *p.limits.sliding, *p.limits.sliding + 20.0, 2.0, false,
                 [](SearchProblem& q, double v) { q.limits.sliding = v; }, plain});
  }
  if (p.limits.tip_clearance) {
    k.push_back({"limits.tip_clearance", *p.limits.tip_clearance,
                 std::min(0.0, *p.limits.tip_clearance), 1.0, false,
                 [](SearchProblem& q, double v) { q.limits.tip_clearance = v; }, plain});
  }
  return k;
}

}  // namespace

std::vector<NearestChange> nearest_changes(const SearchProblem& problem) {
  GW_EXPECTS(Search(problem).space().size().value_or(kMaxForChange + 1) <= kMaxForChange);
  std::vector<NearestChange> found;
  for (const Knob& knob : knobs(problem)) {
    const auto to = min_move(problem, knob);
    if (!to) continue;
    found.push_back({knob.field, knob.show(knob.value), knob.show(*to),
                     std::abs(*to - knob.value) / knob.scale});
  }
  const auto switched = [&](const char* field, const auto& set) {
    SearchProblem p = problem;
    set(p);
    if (feasible(p)) found.push_back({field, "true", "false", 0.5});
  };
  if (problem.coprime) switched("coprime", [](SearchProblem& p) { p.coprime = false; });
  if (problem.limits.avoid_interference)
    switched("limits.avoid_interference",
             [](SearchProblem& p) { p.limits.avoid_interference = false; });
  std::stable_sort(found.begin(), found.end(), [](const NearestChange& a, const NearestChange& b) {
    return a.effort < b.effort;
  });
  return found;
}

}  // namespace gearwright
