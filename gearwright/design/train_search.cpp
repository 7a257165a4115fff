// Searches for trains. A train is a series of pairs of gears.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "gearwright/base/numbers.hpp"
#include "gearwright/design/drive_space.hpp"
#include "gearwright/pair/shift.hpp"

namespace gearwright {

namespace {

// Tries all numbers of teeth of a train. The ratio determines the last wheel.
class TrainSearch {
 public:
  TrainSearch(const DriveSearchProblem& problem, DriveSearchResult& result)
      : problem_(problem), result_(result) {
    for (int sum = 0; sum <= problem.pinion[1] + problem.wheel[1]; ++sum)
      reached_.push_back(!problem.center_distance ||
                         std::any_of(problem.modules.begin(), problem.modules.end(),
                                     [&](double m) { return may_reach(problem, sum, m); }));
    for (int z1 = problem.pinion[0]; z1 <= problem.pinion[1]; ++z1) {
      wheels_.push_back(0);
      for (int z2 = problem.wheel[0]; z2 <= problem.wheel[1]; ++z2)
        wheels_.back() += may_mesh(z1, z2) ? 1 : 0;
    }
  }

  void visit(int stages) {
    stages_.clear();
    next(stages, 1.0);
  }

 private:
  bool may_mesh(int z1, int z2) const {
    return reached_[static_cast<std::size_t>(z1 + z2)] &&
           (!problem_.coprime || std::gcd(z1, z2) == 1);
  }

  void next(int left, double ratio) {
    for (int z1 = problem_.pinion[0]; z1 <= problem_.pinion[1] && result_.is_complete; ++z1) {
      if (left == 1) {
        last(z1, ratio);
        continue;
      }
      for (int z2 = problem_.wheel[0]; z2 <= problem_.wheel[1]; ++z2) {
        if (!may_mesh(z1, z2)) continue;
        stages_.push_back({z1, z2});
        next(left - 1, -ratio * z2 / z1);
        stages_.pop_back();
      }
    }
  }

  void last(int z1, double before) {
    ++trials_;
    result_.is_complete = trials_ <= kMostTrainTrials && result_.found.size() <= kMostTrains;
    const double per_tooth = -before / z1;
    double lo = problem_.ratio[0] / per_tooth, hi = problem_.ratio[1] / per_tooth;
    if (lo > hi) std::swap(lo, hi);
    // The values are limited before the conversion to int, because they may exceed its range. If
    // even the greatest wheel is too small, no wheel is tried.
    const auto [z_min, z_max] = problem_.wheel;
    const double least = std::clamp<double>(std::floor(lo), z_min, z_max + 1.0);
    const double most = std::min<double>(z_max, std::ceil(hi));
    const int band = wheels_[static_cast<std::size_t>(z1 - problem_.pinion[0])];
    result_.tested += band;
    int kept = 0;
    for (int z2 = static_cast<int>(least); z2 <= most; ++z2) {
      if (!may_mesh(z1, z2)) continue;
      stages_.push_back({z1, z2});
      kept += keep();
      stages_.pop_back();
    }
    result_.rejected[static_cast<std::size_t>(DriveLimit::ratio)] += band - kept;
  }

  // Adds the train and returns 1 if it meets all limits. The ratio is a quotient of two products of
  // numbers of teeth. These products are exact below 2^53.
  int keep() {
    double p = 1.0, q = 1.0, size = 0.0;
    const auto& helix = problem_.base.helix_deg.all;
    const double transverse = 1.0 / std::cos(Angle::degrees(helix.value_or(0.0)).rad());
    for (const auto& [z1, z2] : stages_) {
      p *= -z2;
      q *= z1;
      size += transverse * (z1 + z2) / 2;
    }
    const double ratio = p / q;
    if (!(ratio >= problem_.ratio[0] && ratio <= problem_.ratio[1])) return 0;
    if (problem_.coaxial_teeth) {
      const int sum = stages_[0][0] + stages_[0][1];
      for (const auto& [z1, z2] : stages_)
        if (std::abs(z1 + z2 - sum) > *problem_.coaxial_teeth) return 0;
    }
    double eta = 1.0;
    for (const auto& [z1, z2] : stages_)
      eta *= problem_.base.efficiency.all.value_or(
          estimated_efficiency(z1, z2, problem_.base.friction));
    result_.found.push_back({{}, stages_, 1, 1.0, ratio, 0, kInfinity, size, eta, eta});
    return 1;
  }

  const DriveSearchProblem& problem_;
  DriveSearchResult& result_;
  std::vector<std::array<int, 2>> stages_;
  std::vector<char> reached_;  // true for a z_1 + z_2 if a module gives the required distance
  std::vector<int> wheels_;    // number of wheels that may mesh with each pinion
  std::int64_t trials_ = 0;
};

}  // namespace

double estimated_efficiency(int z1, int z2, double friction) {
  // Usual value of 1 − ε_α + ε_1² + ε_2², where ε_1 and ε_2 are the parts of ε_α before and after
  // the pitch point.
  constexpr double kPath = 0.7;
  return 1.0 - kPath * std::numbers::pi * friction * (1.0 / z1 + 1.0 / z2);
}

std::optional<std::array<double, 2>> DriveCandidate::stage_shifts(std::size_t stage) const {
  if (shifts.empty() || !shifts[2 * stage] || !shifts[2 * stage + 1]) return std::nullopt;
  return std::array<double, 2>{*shifts[2 * stage], *shifts[2 * stage + 1]};
}

double stage_helix_deg(const DriveSearchProblem& problem, std::size_t stage) {
  const double beta = problem.base.helix_deg.all.value_or(0.0);
  return stage % 2 == 1 ? -beta : beta;
}

bool is_coaxial(const DriveSearchProblem& problem, const DriveCandidate& train) {
  return problem.coaxial_teeth && train.stages.size() > 1 && train.has_one_module() &&
         !problem.modules.empty() && !problem.base.profile_shift.all;
}

bool may_reach(const DriveSearchProblem& problem, int sum_of_teeth, double module) {
  if (!problem.center_distance) return true;
  const double cos_beta = std::cos(Angle::degrees(problem.base.helix_deg.all.value_or(0.0)).rad());
  const double alpha_n = problem.base.normal_pressure_angle.rad();
  const double alpha_t = cos_beta == 1.0 ? alpha_n : std::atan(std::tan(alpha_n) / cos_beta);
  // Σx depends only on z_1 + z_2. The arguments z_1 and z_2 can therefore be this sum and 0.
  const double least =
      reference_center_distance(sum_of_teeth, 0, module, cos_beta) * std::cos(alpha_t);
  const auto shift_sum = [&](double a) {
    if (!(a > least)) return -kInfinity;
    if (!(a <= kMaxDistance * least)) return kInfinity;
    return tight_shift_sum(sum_of_teeth, 0, module, alpha_n, alpha_t, cos_beta, a);
  };
  return shift_sum((*problem.center_distance)[0]) <= kStageShiftSums[1] &&
         shift_sum((*problem.center_distance)[1]) >= kStageShiftSums[0];
}

DriveCandidate with_modules(const DriveSearchProblem& problem, DriveCandidate train,
                            const std::vector<double>& modules) {
  GW_EXPECTS(modules.size() == train.stages.size());
  train.stage_modules = modules;
  train.size = 0.0;
  for (std::size_t k = 0; k < modules.size(); ++k)
    train.size += modules[k] * (train.stages[k][0] + train.stages[k][1]) / 2;
  train.size /= std::cos(Angle::degrees(problem.base.helix_deg.all.value_or(0.0)).rad());
  train.mass = estimated_mass(problem, train);
  return train;
}

void give_stage_modules(const DriveSearchProblem& problem, DriveSearchResult& result) {
  std::vector<DriveCandidate> each;
  for (const DriveCandidate& train : result.found) {
    std::vector<std::vector<double>> choices(1);  // lists of the modules of the first stages
    for (const auto& [z1, z2] : train.stages) {
      std::vector<std::vector<double>> longer;
      for (const double m : problem.modules) {
        if (!may_reach(problem, z1 + z2, m)) continue;
        for (std::vector<double> choice : choices) {
          choice.push_back(m);
          longer.push_back(std::move(choice));
        }
      }
      choices = std::move(longer);
    }
    result.tested += static_cast<std::int64_t>(choices.size()) - 1;
    for (const std::vector<double>& modules : choices) {
      DriveCandidate made = with_modules(problem, train, modules);
      made.module = modules.front();
      if (made.size > problem.size_max) {
        ++result.rejected[static_cast<std::size_t>(DriveLimit::size)];
      } else {
        each.push_back(std::move(made));
      }
    }
    if (each.size() > kMostTrains) {
      result.is_complete = false;
      break;
    }
  }
  result.found = std::move(each);
}

void search_trains(const DriveSearchProblem& problem, DriveSearchResult& result) {
  TrainSearch search(problem, result);
  for (int n = problem.stages[0]; n <= problem.stages[1]; ++n) search.visit(n);
}

}  // namespace gearwright
