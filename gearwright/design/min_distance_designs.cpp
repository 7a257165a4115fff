// Computes helix angles and shifts of pairs with a given centre distance a and shaft angle Σ. The
// given a is the least possible centre distance of these pairs at Σ.
//
//   H      sum of the pitch diameters in units of p_n/π (design/fit.hpp)
//   β_w1   the only unknown; all other values follow in closed form:
//          β_w2 = σ (Σ − β_w1), H, cos α_wn = H m_n cos α_n/(2a), sin β = sin β_w cos α_wn/cos α_n,
//          2 tan α_n (x1 + x2) = z1 (inv α_wt1 − inv α_t1) + z2 (inv α_wt2 − inv α_t2)
//                                                                              [T4.29]…[T4.32]
#include "gearwright/design/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <functional>
#include <numbers>

#include "gearwright/base/angle.hpp"
#include "gearwright/base/contract.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/math/involute.hpp"
#include "gearwright/math/root.hpp"
#include "gearwright/pair/shift.hpp"

namespace gearwright {

namespace {

constexpr double kMargin = 0.1 * kRadPerDeg;     // least distance between a working helix angle and
                                                 // 90°
constexpr double kSteepest = 89.0 * kRadPerDeg;  // greatest helix angle of a gear
constexpr double kParallel = 1e-9;               // greatest |Σ| of parallel axes, rad, as in
                                                 // pair/partners.cpp
constexpr int kCells = 512;  // number of cells of the range of β_w1, in which roots of functions of
                             // unknown shape are searched
// The function H(β_w1) at one shaft angle, and the minimum of this function.
class PitchSum {
 public:
  PitchSum(const std::array<int, 2>& teeth, double sigma)
      : z1_(teeth[0]), z2_(std::abs(teeth[1])), side_(side_of(teeth[1])), sigma_(sigma) {
    // Both working helix angles must lie within ±90°.
    lo_ = -kHalfPi + std::max(0.0, side_ > 0 ? sigma_ : 0.0) + kMargin;
    hi_ = kHalfPi + std::min(0.0, side_ > 0 ? sigma_ : 0.0) - kMargin;
    const auto slope = [this](double b1) {
      const double c1 = std::cos(b1), c2 = std::cos(second(b1));
      const double t1 = std::tan(b1), t2 = std::tan(second(b1));
      return Slope<double>{side_ * z1_ * t1 / c1 - side_ * z2_ * t2 / c2,
                           side_ * z1_ * (1 + 2 * t1 * t1) / c1 + z2_ * (1 + 2 * t2 * t2) / c2};
    };
    argmin_ = newton_in_bracket(slope, lo_, hi_, 0.5 * (lo_ + hi_), true).x;
  }
  double second(double b1) const { return side_ * (sigma_ - b1); }
  double operator()(double b1) const {
    return side_ * z1_ / std::cos(b1) + z2_ / std::cos(second(b1));
  }
  double lo() const { return lo_; }
  double hi() const { return hi_; }
  double argmin() const { return argmin_; }
  double min() const { return (*this)(argmin_); }
  // Returns the solutions of H(β_w1) = t in ascending order, at most two, because H is convex.
  std::vector<double> where(double t) const {
    const double rest = min() - t;
    if (rest > 0.0) return {};
    const auto f = [&](double b1) { return (*this)(b1)-t; };
    std::vector<double> found;
    for (const auto& [from, to] : {std::pair{lo_, argmin_}, std::pair{argmin_, hi_}}) {
      const Root root = find_root(f, from, to);
      // If the bracket contains no root, the solution lies outside the range of β_w1. H is greater
      // there than for any practical gears.
      if (root.stop == RootStop::no_bracket) continue;
      GW_ENSURES(root.found());
      if (found.empty() || found.back() != root.x) found.push_back(root.x);
    }
    return found;
  }

 private:
  double z1_, z2_, side_, sigma_, lo_, hi_, argmin_;
};

// Returns the given shaft angle, or 0 if the axes are parallel within kParallel.
double shaft_angle_of(const FitProblem& p) {
  return std::abs(p.shaft_angle->rad()) <= kParallel ? 0.0 : p.shaft_angle->rad();
}

// Computes the design for a given value of β_w1, if it exists.
class Designs {
 public:
  explicit Designs(const FitProblem& p) : p_(p), H_(p.teeth, shaft_angle_of(p)) {}
  const PitchSum& pitch_sum() const { return H_; }
  // Returns T, the required value of H for the working pressure angle α_wn.
  double target(double cos_wn) const {
    return 2 * *p_.center_distance * cos_wn /
           (p_.normal_module * std::cos(p_.normal_pressure_angle.rad()));
  }
  struct Design {
    std::array<double, 2> helix;
    double alpha_wn, shift_sum;
  };
  std::optional<Design> at(double b1) const { return at(b1, H_(b1) / target(1.0)); }
  std::optional<Design> at(double b1, double cos_wn) const {
    if (!(cos_wn > 0.0 && cos_wn < 1.0)) return std::nullopt;
    const double alpha_n = p_.normal_pressure_angle.rad();
    const double cos_n = std::cos(alpha_n);
    const double sin_wn = std::sqrt((1 - cos_wn) * (1 + cos_wn));
    const std::array<double, 2> b{b1, H_.second(b1)};
    Design d{{}, std::acos(cos_wn), 0.0};
    for (int i : {0, 1}) {
      const double sine = std::sin(b[i]) * cos_wn / cos_n;
      if (!(std::abs(sine) < std::sin(kSteepest))) return std::nullopt;
      d.helix[i] = std::asin(sine);
      const double alpha_wt = std::atan2(sin_wn, cos_wn * std::cos(b[i]));
      const double alpha_t = std::atan(std::tan(alpha_n) / std::cos(d.helix[i]));
      d.shift_sum += p_.teeth[i] * (involute(alpha_wt) - involute(alpha_t));
    }
    d.shift_sum /= 2 * std::tan(alpha_n);
    return d;
  }

 private:
  const FitProblem& p_;
  PitchSum H_;
};

// Returns the roots of f in those parts of [lo, hi] in which f exists. If f changes its sign
// between neighbouring grid points, one root is found there. Near an extremum that crosses zero,
// two roots are found.
std::vector<double> roots(const std::function<std::optional<double>(double)>& f, double lo,
                          double hi) {
  std::vector<double> found;
  const auto value = [&](double x) { return f(x).value_or(kNoNumber); };
  const auto bracket = [&](double a, double b) {
    const Root root = find_root(value, a, b);
    if (root.found()) found.push_back(root.x);
  };
  std::vector<double> x(kCells + 1);
  std::vector<std::optional<double>> y(kCells + 1);
  for (int i = 0; i <= kCells; ++i) {
    x[i] = lo + (hi - lo) * i / kCells;
    y[i] = f(x[i]);
  }
  for (int i = 0; i < kCells; ++i) {
    if (!y[i] || !y[i + 1]) continue;
    const double here = *y[i], next = *y[i + 1];
    if (here == 0.0 || (here < 0.0) != (next < 0.0)) {
      bracket(x[i], x[i + 1]);
    } else if (i > 0 && y[i - 1] && std::abs(here) <= std::abs(*y[i - 1]) &&
               std::abs(here) <= std::abs(next) && (here < 0.0) == (*y[i - 1] < 0.0)) {
      const double sign = here < 0.0 ? -1.0 : 1.0;
      const auto [at, least] = boost::math::tools::brent_find_minima(
          [&](double s) { return sign * value(s); }, x[i - 1], x[i + 1], 40);
      if (least <= 0.0) {
        bracket(x[i - 1], at);
        bracket(at, x[i + 1]);
      }
    }
  }
  return found;
}

std::array<double, 2> divided(const FitProblem& p, double sum) {
  if (p.shift[0]) return {*p.shift[0], sum - *p.shift[0]};
  if (p.shift[1]) return {sum - *p.shift[1], *p.shift[1]};
  if (sum == 0.0) return {0.0, 0.0};
  const auto [x1, x2] = divided_shift_sum(p.teeth[0], p.teeth[1], sum);
  return {x1, x2};
}

// For a given working pressure angle, finds two values: the smallest possible a at the given Σ, and
// the greatest possible |Σ| at the given a.
void find_nearest(const FitProblem& p, double cos_wn, Fit& result) {
  const Designs designs(p);
  const PitchSum& H = designs.pitch_sum();
  const double t = designs.target(cos_wn);
  result.nearest_distance = *p.center_distance * H.min() / t;
  result.reason = refused("", *p.center_distance, {*result.nearest_distance},
                          fmt::format("at the shaft angle {}° the centre distance of such a pair "
                                      "is at least {{}} mm (working normal pressure angle {:.6g}°)",
                                      format_number(p.shaft_angle->deg()),
                                      Angle::radians(std::acos(cos_wn)).deg()))
                      .rule;
  if (p.teeth[1] < 0) return;
  // On parallel axes, the minimum of H over β_w1 is z1 + z2. The minimum grows with |Σ|.
  if (!(t > p.teeth[0] + p.teeth[1])) {
    result.reason +=
        refused("", *p.center_distance, {*p.center_distance * (p.teeth[0] + p.teeth[1]) / t},
                "; no shaft angle permits such a pair at the given centre distance, because even "
                "on parallel axes the centre distance must be at least {} mm")
            .rule;
    return;
  }
  const double sign = p.shaft_angle->rad() < 0.0 ? -1.0 : 1.0;
  const auto f = [&](double s) { return PitchSum(p.teeth, sign * s).min() - t; };
  const Root root = find_root(f, 0.0, std::numbers::pi - 3 * kMargin);
  if (root.found())
    result.nearest_shaft_angle = Angle::radians(sign * root.x);  // absent if |Σ| exceeds 179.7°
}

std::optional<Error> contradiction(const FitProblem& p) {
  const bool shifts = p.shift[0] && p.shift[1];
  const bool helix = p.helix[0] || p.helix[1];
  const std::string helix_field = gear_field(p.helix[0] ? 1 : 2, "helix_angle");
  const std::string alpha_field = "fit.working_normal_pressure_angle";
  const auto too_many = [](const std::string& field, const std::string& other) {
    return Error{field, "",
                 fmt::format("cannot be given together with {}, the centre distance and the shaft "
                             "angle, because any three of these determine the fourth; leave out "
                             "one of them",
                             other)};
  };
  if (p.working_normal_pressure_angle && shifts)
    return too_many(alpha_field, "the two profile shifts");
  if (p.working_normal_pressure_angle && helix)
    return too_many(alpha_field, "`" + helix_field + "`");
  if (helix && shifts) return too_many(helix_field, "the two profile shifts");
  if (!(std::abs(p.shaft_angle->rad()) < std::numbers::pi - 3 * kMargin)) {
    return refused("pair.shaft_angle", p.shaft_angle->deg(),
                   "no two helix angles give this shaft angle; the shaft angle must lie between "
                   "-179.7° and 179.7°");
  }
  return std::nullopt;
}

}  // namespace

Result<Fit> min_distance_designs(const FitProblem& p) {
  GW_EXPECTS(p.center_distance && p.shaft_angle && !(p.helix[0] && p.helix[1]));
  if (auto error = contradiction(p)) return *error;
  const Designs designs(p);
  const PitchSum& H = designs.pitch_sum();
  Fit result;
  const auto add = [&](double b1, std::optional<double> cos_wn = std::nullopt,
                       std::optional<double> sum = std::nullopt) {
    const auto d = cos_wn ? designs.at(b1, *cos_wn) : designs.at(b1);
    if (!d) return;
    result.branches.push_back({{Angle::radians(d->helix[0]), Angle::radians(d->helix[1])},
                               divided(p, sum.value_or(d->shift_sum)),
                               *p.center_distance,
                               Angle::radians(shaft_angle_of(p)),
                               Angle::radians(d->alpha_wn)});
  };
  const bool shifts = p.shift[0] && p.shift[1];
  const double wanted_sum = shifts ? *p.shift[0] + *p.shift[1] : 0.0;
  const int known = p.helix[0] ? 0 : p.helix[1] ? 1 : -1;
  if (known >= 0) {
    const auto miss = [&](double b1) -> std::optional<double> {
      const auto d = designs.at(b1);
      if (!d) return std::nullopt;
      return d->helix[known] - p.helix[known]->rad();
    };
    for (const double b1 : roots(miss, H.lo(), H.hi())) add(b1);
    result.reason = fmt::format(
        "there is no pair with `{}` = {} whose minimum centre distance is the given distance",
        gear_field(known + 1, "helix_angle"), format_number(p.helix[known]->deg()));
  } else if (p.working_normal_pressure_angle || wanted_sum == 0.0) {
    // If a pair has x1 + x2 = 0 at its minimum centre distance, its working pressure angle
    // equals the pressure angle of the rack.
    const Angle alpha = p.working_normal_pressure_angle.value_or(p.normal_pressure_angle);
    const double cos_wn = std::cos(alpha.rad());
    const std::optional<double> sum =
        p.working_normal_pressure_angle ? std::nullopt : std::optional(0.0);
    for (const double b1 : H.where(designs.target(cos_wn))) add(b1, cos_wn, sum);
    if (result.branches.empty()) find_nearest(p, cos_wn, result);
  } else {
    const auto miss = [&](double b1) -> std::optional<double> {
      const auto d = designs.at(b1);
      if (!d) return std::nullopt;
      return d->shift_sum - wanted_sum;
    };
    for (const double b1 : roots(miss, H.lo(), H.hi())) add(b1, std::nullopt, wanted_sum);
    if (result.branches.empty()) {
      find_nearest(p, 1.0, result);
      result.reason = fmt::format(
          "there is no pair with x1 + x2 = {} whose minimum centre distance is the given distance",
          format_number(wanted_sum));
      result.nearest_distance.reset();
      result.nearest_shaft_angle.reset();
    }
  }
  if (!result.branches.empty()) result.reason.clear();
  std::sort(
      result.branches.begin(), result.branches.end(),
      [](const FitBranch& a, const FitBranch& b) { return abs(a.helix[0]) < abs(b.helix[0]); });
  return result;
}

}  // namespace gearwright
