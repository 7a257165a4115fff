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
  constexpr double kMaxInt64 = 9e18;  // less than 2⁶³ − 1 by more than the rounding error of the
                                      // approximate size
  if (approximate_size() < kMaxInt64) {
    size_ = per_module_ * static_cast<std::int64_t>(problem.modules.size()) *
            static_cast<std::int64_t>(problem.helix.size()) *
            static_cast<std::int64_t>(problem.racks.size());
  }
}

double SearchSpace::approximate_size() const {
  return static_cast<double>(per_module_) * static_cast<double>(problem_->modules.size()) *
         static_cast<double>(problem_->helix.size()) * static_cast<double>(problem_->racks.size());
}

SearchSpace::Cursor SearchSpace::at(std::int64_t index) const {
  GW_EXPECTS(size_ && index >= 0 && index < *size_);
  Cursor c{index, 0, 0, 0, 0, 0, 0};
  const std::int64_t in_module = index % per_module_;
  std::int64_t rest = index / per_module_;
  const auto take = [&](std::size_t count) {
    const auto n = static_cast<std::int64_t>(count);
    const std::int64_t digit = rest % n;
    rest /= n;
    return static_cast<std::size_t>(digit);
  };
  c.module = take(problem_->modules.size());
  c.helix = take(problem_->helix.size());
  c.rack = static_cast<std::size_t>(rest);
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
    if (++c.module == problem_->modules.size()) {
      c.module = 0;
      if (++c.helix == problem_->helix.size()) {
        c.helix = 0;
        ++c.rack;
      }
    }
  }
  c.z1 = pinions_[c.pinion].z1;
  c.z2 = pinions_[c.pinion].first;
}

Trial SearchSpace::trial_of(const Cursor& c) const {
  const Angle beta = problem_->helix[c.helix];
  // β2 = Σ − σ β1, where Σ = 0 on parallel axes and σ is the sign of z2.
  const Angle mate = problem_->shaft_angle.value_or(Angle()) - side_of(c.z2) * beta;
  return {c.index, problem_->modules[c.module], c.z1, c.z2, {beta, mate}, static_cast<int>(c.rack)};
}

Trial SearchSpace::trial(std::int64_t index) const { return trial_of(at(index)); }

bool SearchSpace::coprime(int a, int b) { return std::gcd(a, b) == 1; }

}  // namespace gearwright
