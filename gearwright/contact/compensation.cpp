#include "gearwright/contact/compensation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlopt.hpp>

#include "gearwright/base/units.hpp"
#include "gearwright/contact/contact.hpp"
#include "gearwright/math/decompositions.hpp"

namespace gearwright {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A search ends when f changes by less: this part of itself, or a hundredth of kNothing.
constexpr double kLastGain = 1e-5;  // relative
constexpr double kLastGain_rad = 1e-5 * kRadPerArcsec;
// f of corrections at which contact is lost, rad: far above any other, and finite for the optimiser.
constexpr double kLost = 1e3;
// No instrument sees a difference below 0.001 arcsec, rad.
constexpr double kNothing = 1e-3 * kRadPerArcsec;

// One scenario, looked at.
struct Looked {
  std::vector<double> te;  // rad, NaN where lost
  ContactScore score;
};

Looked curve_of(const ContactPair& pair, int positions, Angle target, Angle width) {
  Looked c;
  Transmission transmission(pair);
  double z_half = 0.0;
  for (const FlankPatch& p : pair.patches(1))
    z_half = std::max({z_half, std::abs(p.z_lo), std::abs(p.z_hi)});
  double height = 0.0;
  double profile = 0.0;
  int n = 0;
  for (const PairTouch& t : transmission.over_a_pitch(-0.5 * pair.pitch(), positions)) {
    if (!t.found()) {
      c.score.lost = true;
      c.te.push_back(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    c.te.push_back(t.te());
    ++n;
    // Along a contact line every point touches: the pattern is where the line is, all over.
    if (!t.touch.flat) height += t.touch.z / z_half;
    if (width > Angle()) {
      const auto angle = transmission.field(t.fields).one().profile.rack_angle(t.touch.s);
      if (angle) profile += (*angle - target.rad()) / width.rad();
    }
  }
  c.score.peak_to_peak = Angle::radians(peak_to_peak(c.te));
  c.score.along_face = n ? height / n : 0.0;
  c.score.along_profile = n ? profile / n : 0.0;
  return c;
}

void take_worst(ContactScore& worst, const ContactScore& s) {
  worst.peak_to_peak = std::max(worst.peak_to_peak, s.peak_to_peak);
  if (std::abs(s.along_face) > std::abs(worst.along_face)) worst.along_face = s.along_face;
  if (std::abs(s.along_profile) > std::abs(worst.along_profile))
    worst.along_profile = s.along_profile;
  worst.lost = worst.lost || s.lost;
}

class Judge {
 public:
  explicit Judge(const CompensationTask& task) : task_(task) {}

  std::vector<Looked> curves(const std::vector<double>& v) {
    ++evaluations_;
    std::vector<Looked> all;
    for (int s = 0; s < task_.scenarios; ++s) {
      const auto pair = task_.pair_at(v, s);
      if (!pair) return {};
      all.push_back(curve_of(*pair, task_.positions, task_.profile_target, task_.profile_width));
    }
    return all;
  }

  double value(const std::vector<Looked>& curves) const {
    if (curves.empty()) return kInfinity;
    ContactScore worst;
    for (const Looked& c : curves) take_worst(worst, c.score);
    if (worst.lost || !std::isfinite(worst.peak_to_peak.rad())) return kInfinity;
    return worst.peak_to_peak.rad() +
           task_.centering.rad() * ((task_.along_face ? worst.along_face * worst.along_face : 0.0) +
                                    worst.along_profile * worst.along_profile);
  }

  double value(const std::vector<double>& v) { return value(curves(v)); }
  int evaluations() const { return evaluations_; }

 private:
  const CompensationTask& task_;
  int evaluations_ = 0;
};

// The least squares answer of the problem as it looks from v = 0, each scenario about its own mean.
std::vector<double> linearised(const CompensationTask& task, Judge& judge) {
  const std::size_t n = task.corrections.size();
  const std::vector<double> zero(n, 0.0);
  const auto base = judge.curves(zero);
  const std::size_t rows = static_cast<std::size_t>(task.scenarios * task.positions);
  const auto column = [&](const std::vector<Looked>& curves) {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows));
    Eigen::Index i = 0;
    for (const Looked& c : curves) {
      double mean = 0.0;
      for (const double te : c.te) mean += std::isnan(te) ? 0.0 : te / task.positions;
      for (const double te : c.te) y[i++] = std::isnan(te) ? 0.0 : te - mean;
    }
    return y;
  };
  if (base.empty()) return zero;
  const Eigen::VectorXd y = column(base);
  Eigen::MatrixXd a(y.size(), static_cast<Eigen::Index>(n));
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<double> v = zero;
    const Correction& c = task.corrections[k];
    v[k] = c.step <= c.hi ? c.step : -c.step;
    const auto moved = judge.curves(v);
    if (moved.empty()) return zero;
    a.col(static_cast<Eigen::Index>(k)) = (column(moved) - y) / v[k];
  }
  const Eigen::VectorXd x = least_squares(a, -y);
  std::vector<double> v(n);
  for (std::size_t k = 0; k < n; ++k)
    v[k] =
        std::clamp(x[static_cast<Eigen::Index>(k)], task.corrections[k].lo, task.corrections[k].hi);
  return v;
}

std::vector<double> optimise(const CompensationTask& task, Judge& judge, nlopt::algorithm algorithm,
                             int evaluations, double step_factor, std::vector<double> v) {
  nlopt::opt opt(algorithm, static_cast<unsigned>(v.size()));
  std::vector<double> lo, hi, step;
  for (const Correction& c : task.corrections) {
    lo.push_back(c.lo);
    hi.push_back(c.hi);
    step.push_back(c.step * step_factor);
  }
  opt.set_lower_bounds(lo);
  opt.set_upper_bounds(hi);
  opt.set_initial_step(step);
  opt.set_maxeval(evaluations);
  opt.set_ftol_rel(kLastGain);
  opt.set_ftol_abs(kLastGain_rad);
  const auto objective = [](const std::vector<double>& x, std::vector<double>&,
                            void* data) -> double {
    const double f = static_cast<Judge*>(data)->value(x);
    return std::isfinite(f) ? f : kLost;
  };
  opt.set_min_objective(objective, &judge);
  double least = 0.0;
  try {
    opt.optimize(v, least);
  } catch (const nlopt::roundoff_limited&) {
    // v is the best that rounding lets it be
  }
  return v;
}

// Values as a workshop would write them, as long as nothing is lost by it.
std::vector<double> rounded(const CompensationTask& task, const std::vector<double>& v) {
  std::vector<double> r = v;
  for (std::size_t k = 0; k < v.size(); ++k) {
    const double unit = task.corrections[k].step / 100;
    r[k] = std::round(v[k] / unit) * unit;
  }
  return r;
}

}  // namespace

ContactScore score_of(const ContactPair& pair, int positions, Angle profile_target,
                      Angle profile_width) {
  return curve_of(pair, positions, profile_target, profile_width).score;
}

Compensation compensate(const CompensationTask& task) {
  GW_EXPECTS(!task.corrections.empty() && task.scenarios >= 1 && task.positions >= 2);
  for (const Correction& c : task.corrections)
    GW_EXPECTS(c.lo <= 0.0 && c.hi >= 0.0 && c.lo < c.hi && c.step > 0.0);
  Judge judge(task);
  const std::vector<double> zero(task.corrections.size(), 0.0);
  std::vector<double> best = zero;
  double least = judge.value(zero);
  const auto take = [&](const std::vector<double>& v) {
    const double f = judge.value(v);
    if (!(f < least)) return;
    least = f;
    best = v;
  };
  if (!(least < kNothing)) {
    const int n = static_cast<int>(zero.size());
    // Curves are what costs: so many in all, whatever the number of scenarios.
    const int budget = std::clamp(6000 / task.scenarios, 60, 400 * n);
    std::vector<std::vector<double>> starts = task.starts;
    starts.push_back(zero);
    starts.push_back(linearised(task, judge));
    starts.push_back(optimise(task, judge, nlopt::GN_DIRECT_L, budget, 1.0, zero));
    for (std::vector<double>& start : starts) {
      for (std::size_t k = 0; k < start.size(); ++k)
        start[k] = std::clamp(start[k], task.corrections[k].lo, task.corrections[k].hi);
      take(start);
      take(optimise(task, judge, nlopt::LN_SBPLX, budget, 1.0, start));
    }
    // A crease may have stopped it: again, with smaller steps.
    for (const double step : {1.0, 0.1, 0.01})
      take(optimise(task, judge, nlopt::LN_SBPLX, budget, step, best));
    if (const auto r = rounded(task, best); judge.value(r) <= least + kNothing) best = r;
    if (judge.value(zero) - least < kNothing) best = zero;
  }
  Compensation result;
  result.value = best;
  result.evaluations = judge.evaluations();
  CompensationTask fine = task;
  fine.positions = task.fine_positions;
  Judge told(fine);
  for (const Looked& c : told.curves(zero)) {
    result.each_before.push_back(c.score);
    take_worst(result.before, c.score);
  }
  for (const Looked& c : told.curves(best)) {
    result.each_after.push_back(c.score);
    take_worst(result.after, c.score);
  }
  return result;
}

}  // namespace gearwright
