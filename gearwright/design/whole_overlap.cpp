#include "gearwright/design/whole_overlap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "gearwright/design/face_width.hpp"

namespace gearwright {

namespace {

constexpr double kStepsPerDegree = 100.0;

std::vector<double> widths_of(const SearchProblem& problem, double module,
                              const std::array<double, 2>& band_deg) {
  SearchProblem of_module;
  of_module.face_width = overlap_face_widths(problem, module, band_deg);
  of_module.face_step = problem.face_step;
  std::vector<double> widths;
  std::optional<double> next = next_face_width(of_module, {}, 0.0, 0.0);
  for (; next; next = next_face_width(of_module, {}, *next, 0.0)) widths.push_back(*next);
  return widths;
}

}  // namespace

std::optional<double> overlap_helix_deg(double overlap_ratio, double module, double face_width) {
  const double sine = overlap_ratio * std::numbers::pi * module / face_width;
  if (!(sine < 1.0)) return std::nullopt;
  const double exact_deg = Angle::radians(std::asin(sine)).deg();
  return std::ceil(exact_deg * kStepsPerDegree) / kStepsPerDegree;
}

std::array<double, 2> overlap_face_widths(const SearchProblem& problem, double module,
                                          const std::array<double, 2>& band_deg) {
  Trial trial;
  trial.module = module;
  trial.z1 = problem.pinion_teeth[0];
  const double least = face_widths(problem, trial)[0];
  trial.z1 = problem.pinion_teeth[1];
  trial.helix[0] = Angle::degrees(std::max(std::abs(band_deg[0]), std::abs(band_deg[1])));
  return {least, face_widths(problem, trial)[1]};
}

std::vector<HelixChoice> whole_overlap_choices(const SearchProblem& problem,
                                               const std::vector<double>& overlap_ratios,
                                               const std::array<double, 2>& band_deg) {
  std::vector<HelixChoice> choices;
  for (const double module : problem.modules) {
    for (const double width : widths_of(problem, module, band_deg)) {
      for (const double ratio : overlap_ratios) {
        const auto beta = overlap_helix_deg(ratio, module, width);
        if (!beta || *beta < kLeastOverlapHelix_deg) continue;
        for (const double signed_beta : {-*beta, *beta})
          if (band_deg[0] <= signed_beta && signed_beta <= band_deg[1])
            choices.push_back({module, Angle::degrees(signed_beta), width});
      }
    }
  }
  const auto order = [](const HelixChoice& c) {
    return std::tuple(c.helix, c.module, *c.face_width);
  };
  std::sort(choices.begin(), choices.end(),
            [&](const HelixChoice& a, const HelixChoice& b) { return order(a) < order(b); });
  return choices;
}

void set_overlap_choices(SearchProblem& p) {
  p.choices = whole_overlap_choices(p, p.overlap_ratios, p.overlap_helix_deg);
  p.helix.clear();
  for (const HelixChoice& choice : p.choices)
    if (p.helix.empty() || p.helix.back() != choice.helix) p.helix.push_back(choice.helix);
}

}  // namespace gearwright
