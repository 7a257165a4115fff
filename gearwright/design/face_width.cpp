#include "gearwright/design/face_width.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gearwright {

namespace {

// Relative tolerance of a width that was computed from a module or a diameter.
constexpr double kRounding = 1e-9;

}  // namespace

std::array<double, 2> face_widths(const SearchProblem& problem, const Trial& trial) {
  if (trial.face_width) return {*trial.face_width, *trial.face_width};
  std::array<double, 2> widths{0.0, std::numeric_limits<double>::infinity()};
  const auto keep = [&](const std::array<double, 2>& band, double unit) {
    widths = {std::max(widths[0], band[0] * unit), std::min(widths[1], band[1] * unit)};
  };
  if (problem.face_width) keep(*problem.face_width, 1.0);
  if (problem.face_modules) keep(*problem.face_modules, trial.module);
  const double d_1 = trial.module * trial.z1 / std::cos(trial.helix[0].rad());
  if (problem.face_diameters) keep(*problem.face_diameters, d_1);
  if (!problem.face_width && !problem.face_modules && !problem.face_diameters)
    keep({kFaceModules, kFaceModules}, trial.module);
  return widths;
}

std::optional<double> next_face_width(const SearchProblem& problem, const Trial& trial,
                                      double before, double width) {
  const auto [least, most] = face_widths(problem, trial);
  if (!(least <= most) || before >= most) return std::nullopt;
  const double step = problem.face_step;
  double next = std::ceil(std::max(width, least) / step - kRounding) * step;
  if (next <= before) next = (std::floor(before / step + kRounding) + 1.0) * step;
  // If a band contains no multiple of the step, the band has only one width, its least one.
  const bool only = std::ceil(least / step - kRounding) * step > most * (1.0 + kRounding);
  if (least == most || only)
    return before < least && width <= least ? std::optional(least) : std::nullopt;
  return next <= most * (1.0 + kRounding) ? std::optional(next) : std::nullopt;
}

double first_face_width(const ShiftGraph& graph) {
  const SearchProblem& problem = graph.problem();
  const Trial& trial = graph.trial();
  double width = 0.0;
  const double per_width = graph.overlap_of(1.0);
  if (problem.limits.overlap_ratio && per_width > 0.0)
    width = *problem.limits.overlap_ratio * trial.module / per_width * (1.0 - kRounding);
  const auto first = next_face_width(problem, trial, 0.0, width);
  return first ? *first : face_widths(problem, trial)[1];
}

}  // namespace gearwright
