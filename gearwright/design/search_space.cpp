#include "gearwright/design/search_space.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gearwright/base/contract.hpp"

namespace gearwright {

namespace {

constexpr double kRatioSlack = 1e-12;  // tolerance with which 1.9 · 30 counts as 57 in spite of
                                       // rounding

}  // namespace

std::array<int, 2> wheels_of(const SearchProblem& problem, int z1) {
  const double slack = kRatioSlack * z1;
  double first = std::ceil(problem.ratio[0] * z1 - slack);
  double last = std::floor(problem.ratio[1] * z1 + slack);
  if (problem.internal()) {
    last = std::min(last, -static_cast<double>(z1) - 1.0);
  } else {
    first = std::max(first, static_cast<double>(z1));
  }
  constexpr double kMax = kMaxSearchTeeth;
  GW_EXPECTS(first > last || (std::abs(first) <= kMax && std::abs(last) <= kMax));
  if (first > last) return {1, 0};
  return {static_cast<int>(first), static_cast<int>(last)};
}

SearchSpace::SearchSpace(const SearchProblem& problem) : problem_(&problem) {
  for (int z1 = problem.pinion_teeth[0]; z1 <= problem.pinion_teeth[1]; ++z1) {
    const auto [first, last] = wheels_of(problem, z1);
    if (first > last) continue;
    pinions_.push_back({z1, first, last});
    before_pinion_.push_back(per_module_);
    per_module_ += last - first + 1;
    const bool only = pinions_.size() == 1;
    wheels_ = {only ? first : std::min(wheels_[0], first),
               only ? last : std::max(wheels_[1], last)};
  }
  constexpr double kMaxInt64 = 9e18;  // less than 2⁶³ − 1; the difference exceeds the rounding
                                      // error of the approximate size
  if (approximate_size() < kMaxInt64) {
    choices_ = static_cast<std::size_t>(choices());
    size_ = per_module_ * static_cast<std::int64_t>(choices_) *
            static_cast<std::int64_t>(problem.racks.size());
  }
}

double SearchSpace::choices() const {
  if (!problem_->choices.empty()) return static_cast<double>(problem_->choices.size());
  return static_cast<double>(problem_->modules.size()) *
         static_cast<double>(problem_->helix.size());
}

HelixChoice SearchSpace::choice(std::size_t number) const {
  if (!problem_->choices.empty()) return problem_->choices[number];
  const std::size_t modules = problem_->modules.size();
  return {problem_->modules[number % modules], problem_->helix[number / modules], std::nullopt};
}

double SearchSpace::approximate_size() const {
  return static_cast<double>(per_module_) * choices() * static_cast<double>(problem_->racks.size());
}

SearchSpace::Cursor SearchSpace::at(std::int64_t index) const {
  GW_EXPECTS(size_ && index >= 0 && index < *size_);
  const std::int64_t in_module = index % per_module_;
  const auto rest = static_cast<std::size_t>(index / per_module_);
  Cursor c{index, rest / choices_, rest % choices_, 0, 0, 0, choice(rest % choices_)};
  const auto after = std::upper_bound(before_pinion_.begin(), before_pinion_.end(), in_module);
  c.pinion = static_cast<std::size_t>(after - before_pinion_.begin()) - 1;
  const Wheels& w = pinions_[c.pinion];
  c.z1 = w.z1;
  c.z2 = w.first + static_cast<int>(in_module - before_pinion_[c.pinion]);
  return c;
}

void SearchSpace::next(Cursor& c) const {
  ++c.index;
  if (c.z2 < pinions_[c.pinion].last) {
    ++c.z2;
    return;
  }
  if (++c.pinion == pinions_.size()) {
    c.pinion = 0;
    if (++c.choice == choices_) {
      c.choice = 0;
      ++c.rack;
    }
    c.values = choice(c.choice);
  }
  c.z1 = pinions_[c.pinion].z1;
  c.z2 = pinions_[c.pinion].first;
}

Trial SearchSpace::trial_of(const Cursor& c) const {
  const Angle beta = c.values.helix;
  // β2 = Σ − σ β1, where Σ = 0 on parallel axes and σ is the sign of z2.
  const Angle mate = problem_->shaft_angle.value_or(Angle()) - side_of(c.z2) * beta;
  return {c.index,
          c.values.module,
          c.z1,
          c.z2,
          {beta, mate},
          static_cast<int>(c.rack),
          c.values.face_width};
}

Trial SearchSpace::trial(std::int64_t index) const { return trial_of(at(index)); }

bool SearchSpace::is_in_band(const Trial& trial) const {
  const auto& band = problem_->face_diameters;
  GW_EXPECTS(band && trial.face_width);
  const double d_1 = trial.module * trial.z1 / std::cos(trial.helix[0].rad());
  return (*band)[0] * d_1 <= *trial.face_width && *trial.face_width <= (*band)[1] * d_1;
}

bool SearchSpace::coprime(int a, int b) { return std::gcd(a, b) == 1; }

}  // namespace gearwright
