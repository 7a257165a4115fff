// `shifts_of` relies on two facts about the tip thickness. Let g be the half angle at the tip.
//
//   external  s_at = 2 r_a g,  g′ = (sin α_t − sin α_a)/r_b,  g″ < 0        ring  g″ > 0, r_a′ = −1
//   s_at″ ∝ 2 sin α_t − sin α_a − 1/sin α_a < 0                             ring  > 0
//
// because tan α_n/(z/2) = sin α_t/r_b. The shifts with a given tip thickness are therefore one
// interval for an external gear, whose tooth only becomes thinner as soon as r_a > r. For an
// internal gear they may be two intervals. For the external gear, the helix factor cos β_a does not
// change this. The scan does not depend on these facts, because it uses every extremum as a node.
#include "tests/oracle/plain_pair.hpp"

#include <algorithm>
#include <cmath>

#include "tests/oracle/numbers.hpp"
#include "tests/oracle/require.hpp"

namespace gearwright::oracle {
namespace plain {
namespace {

using Real = long double;

constexpr Real kInfinity = PlainMargins::kFree;
const Real kNan = std::nanl("");
constexpr Real kRounding = 1e-15L;  // permitted deficit at a limit that is met exactly
constexpr Real kClose = 1e-9L;

Real involute(Real alpha) { return std::tan(alpha) - alpha; }

/// The α for which inv α = y ≥ 0. If Newton's method starts from above, where tan α = y + α < y +
/// π/2, its steps only decrease.
Real angle_of_involute(Real y) {
  if (y == 0) return 0;
  for (Real alpha = std::atan(y + kLongPi / 2);;) {
    const Real t = std::tan(alpha), next = alpha - (t - alpha - y) / (t * t);
    if (!(next < alpha)) return alpha;
    alpha = next;
  }
}

/// √(c² − b²), or NaN if c is less than b by more than a rounding error.
Real leg(Real c, Real b) {
  if (!(c >= b * (1 - kRounding))) return kNan;
  return std::sqrt(std::max((c - b) * (c + b), 0.0L));
}

}  // namespace

Pair::Pair(const PlainProblem& p, int teeth_1, int teeth_2)
    : problem(p), z1(teeth_1), z2(teeth_2), sigma(teeth_2 < 0 ? -1 : 1) {
  require(z1 >= 1 && (z2 >= 1 || z2 < -z1), "z1, z2: must be >= 1, or z2 < -z1 for a ring");
  require(p.alpha_n > 0 && p.alpha_n < kLongPi / 2,
          "alpha_n: must lie between 0 and a right angle");
  require(p.beta >= 0 && p.beta < kLongPi / 2, "beta: must lie between 0 and a right angle");
  require(p.ha > 0 && p.tip_thickness_min >= 0, "ha, tip_thickness_min: must be > 0, >= 0");
  const Real cos_beta = std::cos(p.beta);
  alpha_t = std::atan(std::tan(p.alpha_n) / cos_beta);
  for (int i : {0, 1}) {
    r[i] = std::abs(i == 0 ? z1 : z2) / (2 * cos_beta);
    r_b[i] = r[i] * std::cos(alpha_t);
  }
  u = r[1] / r[0];
  base_pitch = kLongPi * std::cos(alpha_t) / cos_beta;
  standard_centre = std::abs(z1 + z2) / (2 * cos_beta);
  base_centre = standard_centre * std::cos(alpha_t);
}

Real Pair::tip_radius(int gear, Real x) const {
  return is_ring(gear) ? r[1] - problem.ha - x : r[gear - 1] + problem.ha + x;
}

Real Pair::root_radius(int gear, Real x) const {
  return is_ring(gear) ? r[1] + problem.hf - x : r[gear - 1] - problem.hf + x;
}

Real Pair::tip_curvature(int gear, Real x) const { return leg(tip_radius(gear, x), r_b[gear - 1]); }

Real Pair::form_curvature(int gear, Real x) const {
  return r[gear - 1] * std::sin(alpha_t) - (problem.undercut_depth - x) / std::sin(alpha_t);
}

Real Pair::tip_thickness(int gear, Real x) const {
  const Real teeth = std::abs(gear == 1 ? z1 : z2), radius = tip_radius(gear, x);
  const Real rho = leg(radius, r_b[gear - 1]);
  if (std::isnan(rho)) return kNan;
  const Real at_tip = involute(std::atan2(rho, r_b[gear - 1])), at_r = involute(alpha_t);
  const Real on_r = (kLongPi / 2 + 2 * x * std::tan(problem.alpha_n)) / teeth;
  const Real half_angle = is_ring(gear) ? on_r - at_r + at_tip : on_r + at_r - at_tip;
  const Real tan_beta_a = radius / r[gear - 1] * std::tan(problem.beta);
  return 2 * radius * half_angle / std::sqrt(1 + tan_beta_a * tan_beta_a);
}

Real Pair::min_shift(int gear) const {
  const Real floor = problem.floor.value_or(-kInfinity);
  if (is_ring(gear)) return floor;
  const Real sine = std::sin(alpha_t);
  return std::max(floor,
                  problem.undercut_depth - r[gear - 1] * sine * sine + problem.undercut_margin);
}

Real Pair::centre_distance(Real sum) const {
  if (!problem.tight) return standard_centre + sigma * sum;
  const Real y = involute(alpha_t) + 2 * std::tan(problem.alpha_n) * sum / (z1 + z2);
  if (!(y >= -kRounding)) return kNan;
  return base_centre / std::cos(angle_of_involute(std::max(y, 0.0L)));
}

Real Pair::tangent_length(Real sum) const { return leg(centre_distance(sum), base_centre); }

std::optional<Interval> Pair::shift_sums(Interval centres) const {
  if (problem.tight && centres.high < base_centre) return std::nullopt;
  const auto sum = [&](Real centre) {
    if (!problem.tight) return sigma * (centre - standard_centre);
    const Real alpha = std::acos(std::min(base_centre / centre, 1.0L));
    return (involute(alpha) - involute(alpha_t)) * (z1 + z2) / (2 * std::tan(problem.alpha_n));
  };
  const Real a = sum(centres.low), b = sum(centres.high);
  return Interval{std::min(a, b), std::max(a, b)};
}

Interval Pair::shift_sum_domain() const {
  const Real end = problem.tight ? -involute(alpha_t) * (z1 + z2) / (2 * std::tan(problem.alpha_n))
                                 : sigma * (base_centre - standard_centre);
  return sigma > 0 ? Interval{end, kInfinity} : Interval{-kInfinity, end};
}

PlainPoint look(const Pair& pair, Real x1, Real x2) {
  const PlainProblem& p = pair.problem;
  const Real sigma = pair.sigma, u = pair.u;
  PlainPoint o;
  const Real c = o.centre_distance = pair.centre_distance(x1 + x2);
  const Real n = leg(c, pair.base_centre);
  o.alpha_wt = std::atan2(n, pair.base_centre);
  o.rho_2A = pair.tip_curvature(2, x2);
  o.rho_1A = sigma * (n - o.rho_2A);
  o.rho_1E = pair.tip_curvature(1, x1);
  o.rho_2E = n - sigma * o.rho_1E;
  o.eps = (o.rho_1E - o.rho_1A) / pair.base_pitch;
  // Between the base tangent points, ρ_1 ≥ 0 and ρ_2 ≥ 0. For an internal gear, the latter is
  // always true.
  Real start = std::max(o.rho_1A, 0.0L), end = sigma > 0 ? std::min(o.rho_1E, n) : o.rho_1E;
  o.eps_true = (end - start) / pair.base_pitch;
  start = std::max(start, pair.form_curvature(1, x1));
  if (sigma > 0) end = std::min(end, n - pair.form_curvature(2, x2));
  o.eps_usable = (end - start) / pair.base_pitch;
  if (std::isnan(o.eps)) o.eps_true = o.eps_usable = kNan;  // max and min may have lost the NaN

  const auto sliding = [&](Real rho_1, Real rho_2) -> std::array<Real, 2> {
    if (!(rho_1 > 0 && rho_2 > 0)) return {kNan, kNan};
    return {1 - rho_2 / (u * rho_1), 1 - u * rho_1 / rho_2};
  };
  o.zeta_A = sliding(o.rho_1A, o.rho_2A);
  o.zeta_E = sliding(o.rho_1E, o.rho_2E);
  o.tip_thickness = {pair.tip_thickness(1, x1), pair.tip_thickness(2, x2)};
  const Real r_a1 = pair.tip_radius(1, x1), r_a2 = pair.tip_radius(2, x2);
  const Real r_f1 = pair.root_radius(1, x1), r_f2 = pair.root_radius(2, x2);
  if (sigma > 0)
    o.tip_clearance = {c - r_a1 - r_f2, c - r_a2 - r_f1};
  else
    o.tip_clearance = {r_f2 - c - r_a1, r_a2 - c - r_f1};

  PlainMargins& m = o.margins;
  const Real ceil = p.ceil.value_or(kInfinity);
  m.s1min = x1 - pair.min_shift(1);
  m.s2min = x2 - pair.min_shift(2);
  m.s1max = std::min(o.tip_thickness[0] - p.tip_thickness_min, ceil - x1);
  m.s2max = std::min(o.tip_thickness[1] - p.tip_thickness_min, ceil - x2);
  if (std::isnan(o.tip_thickness[0])) m.s1max = kNan;
  if (std::isnan(o.tip_thickness[1])) m.s2max = kNan;
  m.eps = o.eps - p.contact_ratio_min;
  if (p.clip != PlainClip::none)
    m.eps_true =
        (p.clip == PlainClip::tangent_points ? o.eps_true : o.eps_usable) - p.contact_ratio_min;
  if (p.sliding_max) {
    m.sliding = kInfinity;
    for (const Real zeta : {o.zeta_A[0], o.zeta_A[1], o.zeta_E[0], o.zeta_E[1]})
      m.sliding =
          std::isnan(zeta) ? -kInfinity : std::min(m.sliding, *p.sliding_max - std::abs(zeta));
  }
  if (p.clearance_min)
    m.clearance = std::min(o.tip_clearance[0], o.tip_clearance[1]) - *p.clearance_min;
  if (p.avoid_interference) {
    m.interference1 = o.rho_1A - pair.form_curvature(1, x1);
    if (sigma > 0) m.interference2 = o.rho_2E - pair.form_curvature(2, x2);
  }
  for (Real* one :
       {&m.s1max, &m.s2max, &m.eps, &m.eps_true, &m.clearance, &m.interference1, &m.interference2})
    if (std::isnan(*one)) *one = -kInfinity;
  return o;
}

std::vector<Interval> where_not_negative(const std::function<Real(Real)>& f,
                                         const std::vector<Real>& nodes) {
  const auto change = [&](Real outside, Real inside) {
    for (int i = 0; i < 64; ++i) {
      const Real middle = (outside + inside) / 2;
      (f(middle) >= 0 ? inside : outside) = middle;
    }
    return inside;
  };
  std::vector<Interval> held;
  bool was_inside = false;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const bool inside = f(nodes[i]) >= 0;
    if (inside && !was_inside)
      held.push_back({i == 0 ? nodes[0] : change(nodes[i - 1], nodes[i]), nodes[i]});
    if (inside) held.back().high = nodes[i];
    if (!inside && was_inside) held.back().high = change(nodes[i], nodes[i - 1]);
    was_inside = inside;
  }
  return held;
}

namespace {

/// The parts of low … high in which the tip is thick enough.
Pieces thick_enough(const Pair& pair, int gear, Real low, Real high) {
  if (low > high) return {{}, low - high <= kClose};
  const auto spare = [&](Real x) {
    return pair.tip_thickness(gear, x) - pair.problem.tip_thickness_min;
  };
  constexpr int kSamples = 500;
  std::vector<Real> nodes, extrema;
  for (int i = 0; i <= kSamples; ++i) nodes.push_back(Interval{low, high}.at(i / Real(kSamples)));
  for (int i = 1; i < kSamples; ++i) {
    const Real before = spare(nodes[i - 1]), here = spare(nodes[i]), after = spare(nodes[i + 1]);
    if ((here >= before) != (here >= after)) continue;
    const Real sign = here >= before ? 1 : -1;
    Real a = nodes[i - 1], b = nodes[i + 1];
    for (int step = 0; step < 120; ++step) {  // thirds
      const Real c = a + (b - a) / 3, d = b - (b - a) / 3;
      if (sign * spare(c) < sign * spare(d))
        a = c;
      else
        b = d;
    }
    extrema.push_back((a + b) / 2);
  }
  nodes.insert(nodes.end(), extrema.begin(), extrema.end());
  std::sort(nodes.begin(), nodes.end());
  Pieces pieces{where_not_negative(spare, nodes), false};
  extrema.push_back(low);
  extrema.push_back(high);
  for (const Real x : extrema) pieces.close_call |= spare(x) != 0 && std::abs(spare(x)) <= kClose;
  return pieces;
}

Pieces external_shifts(const Pair& pair, int gear) {
  const Real at_base = pair.r_b[gear - 1] - pair.r[gear - 1] - pair.problem.ha;
  const Real low = std::max(pair.min_shift(gear), at_base);
  Real high = 0;  // if r_a > r, the tooth only becomes thinner as the shift increases
  while (pair.tip_thickness(gear, high) >= 0) ++high;
  return thick_enough(pair, gear, low, std::min(high, pair.problem.ceil.value_or(kInfinity)));
}

}  // namespace

Pieces shifts_1(const Pair& pair) { return external_shifts(pair, 1); }

Pieces shifts_2(const Pair& pair, Real window_low, Real window_high) {
  if (!pair.is_ring(2)) return external_shifts(pair, 2);
  const Real at_base = pair.r[1] - pair.problem.ha - pair.r_b[1];
  return thick_enough(pair, 2, std::max(pair.min_shift(2), window_low),
                      std::min({pair.problem.ceil.value_or(kInfinity), window_high, at_base}));
}

}  // namespace plain

std::map<std::string, long double> PlainMargins::by_name() const {
  return {{"s1min", s1min},
          {"s1max", s1max},
          {"s2min", s2min},
          {"s2max", s2max},
          {"eps", eps},
          {"eps_true", eps_true},
          {"sliding", sliding},
          {"clearance", clearance},
          {"interference1", interference1},
          {"interference2", interference2}};
}

long double PlainMargins::min() const {
  return std::min({s1min, s1max, s2min, s2max, eps, eps_true, sliding, clearance, interference1,
                   interference2});
}

PlainPoint look(const PlainProblem& problem, int z1, int z2, long double x1, long double x2) {
  return plain::look(plain::Pair(problem, z1, z2), x1, x2);
}

}  // namespace gearwright::oracle
