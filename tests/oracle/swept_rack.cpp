// Explains how the minimum over the roll angle is found, and why no minimum is missed.
//
//   q(ψ) = (w, h)   path of the point past the cutter,   q′ = (cos β (ρ cos ψ − r), −ρ sin ψ)
//
// (1) g(ψ), the distance of q from the cutter, changes by no more than the length of the path. An
//     interval of half width δ about ψ with g(ψ) − δ max|q′| above the best value contains no
//     minimum.
// (2) A minimum g ≥ 0 has its foot on a straight part, with q′ along it:
//       A cos ψ + B sin ψ = C, solved outright;
//     or on a circle about c (a sharp corner is a circle of radius 0):
//       F = (q − c)·q′ = 0, all roots in an interval found by the bounds
//       |F′| ≤ v² + D ρ,  |F″| ≤ 3 v ρ + D ρ     v ≥ |q′|, D ≥ |q − c|, |q″| ≤ ρ, |q‴| ≤ ρ.
//     Re-entrant corners of the cutter need no special treatment, because a smooth path cannot
//     touch one from outside.
// (3) The cutter is symmetric about the middle of each tooth and space, so the foot lies in the
//     same half pitch as the point.
// (4) Every compared value is the distance at some real position, so it is never below the true
//     minimum.
#include "tests/oracle/swept_rack.hpp"

#include <algorithm>
#include <cmath>

#include "tests/oracle/numbers.hpp"
#include "tests/oracle/require.hpp"

namespace gearwright::oracle {
namespace {

// With full rounding, a width is zero and may become negative by rounding. 1e-9 m is a thousand
// times the rounding error and a thousandth of machining accuracy.
constexpr double kRoundingWidth = 1e-9;

}  // namespace

SweptRack::SweptRack(const RackNumbers& n) : numbers_(n) {
  require(n.teeth >= 1, "teeth: a rack cuts gears with at least 1");
  require(n.normal_module > 0, "normal_module: must be > 0");
  require(n.normal_pressure_angle > 0 && n.normal_pressure_angle < kPi / 2,
          "normal_pressure_angle: must lie between 0 and a right angle");
  require(std::abs(n.helix_angle) < kPi / 2, "helix_angle: must be below a right angle");
  require(n.root_fillet_radius >= 0 && n.tip_fillet_radius >= 0 && n.protuberance >= 0,
          "radii and protuberance: must be >= 0");
  const double m = n.normal_module, alpha = n.normal_pressure_angle;
  const double sin_a = std::sin(alpha), cos_a = std::cos(alpha), tan_a = std::tan(alpha);
  cos_beta_ = std::cos(n.helix_angle);
  shift_ = n.profile_shift * m;
  half_pitch_ = kPi * m / 2;
  r_ = n.teeth * m / (2 * cos_beta_);
  r_b_ = r_ * std::cos(std::atan(tan_a / cos_beta_));
  const double depth = n.dedendum * m;
  r_f_ = r_ + shift_ - depth;
  const double quarter = half_pitch_ / 2;  // half thickness of the cutter at the datum line
  const auto flank_u = [&](double h) { return quarter + h * tan_a; };

  // Tip: rounding about (u, h), tangent to the tip land and to the flank set off by pr.
  const double rho = n.root_fillet_radius * m, proud = n.protuberance * m;
  const double centre_h = rho - depth;
  double centre_u = flank_u(centre_h) + (proud - rho) / cos_a;
  require(centre_u > -kRoundingWidth * m, "root_fillet_radius: larger than the full rounding");
  centre_u = std::max(centre_u, 0.0);
  // With an acute tip, two neighbouring positions could both miss a point that is cut away between
  // them; see (2).
  require(rho > 0 || centre_u > 0, "dedendum: a sharp cutter needs a tip land");
  double last_normal = alpha;  // normal angle at which the rounding ends
  if (proud > 0) {
    require(n.protuberance_angle >= 0 && n.protuberance_angle < alpha,
            "protuberance_angle: must lie between 0 and the pressure angle");
    // If the protuberance is small, it consists only of the rounding, because the arc meets the
    // flank before it reaches α_pr.
    const double slack = rho > 0 ? 1 - proud / rho : -1.0;
    const double meets = slack > -1 ? alpha - std::acos(slack) : -kInfinity;
    last_normal = std::max(n.protuberance_angle, meets);
  }
  const double sin_l = std::sin(last_normal), cos_l = std::cos(last_normal);
  const double round_u = centre_u + rho * cos_l, round_h = centre_h - rho * sin_l;
  u_land_ = centre_u;
  u_round_ = round_u;
  segments_.push_back({0, -depth, 1, 0, centre_u});
  arcs_.push_back({centre_u, centre_h, rho, 0, -1, cos_l, -sin_l});
  double flank_h = round_h;
  if (proud > 0) {
    // The arc is rounded about the intersection of the protuberance line with the flank.
    flank_h =
        (round_u - round_h * std::tan(last_normal) - quarter) / (tan_a - std::tan(last_normal));
    flank_h = std::max(flank_h, round_h);
    segments_.push_back({round_u, round_h, sin_l, cos_l, (flank_h - round_h) / cos_l});
    line_angles_.push_back(last_normal);
  }
  u_protuberance_ = proud > 0 ? flank_u(flank_h) : round_u;

  // The flank, up to the start of the next element or to the intersection with the flank of the
  // next tooth.
  const double meeting_h = quarter / tan_a;
  const double rho1 = n.tip_fillet_radius * m;
  require(!(rho1 > 0 && n.semi_topping_angle), "semi_topping_angle: instead of a bottom rounding");
  require(!n.semi_topping_angle || n.tool_addendum, "tool_addendum: needed for a ramp");
  require(flank_h < meeting_h, "dedendum: the straight flank has no length");
  std::optional<double> end_h = n.tool_addendum;
  if (end_h) {
    *end_h *= m;
  } else if (rho1 > 0) {
    end_h = n.addendum * m - rho1 * (1 - sin_a);
  }
  const bool ends = end_h && *end_h < meeting_h;
  const double flank_end_h = ends ? *end_h : meeting_h;
  require(flank_end_h > flank_h, "tool_addendum: the straight flank has no length");
  const double end_u = ends ? flank_u(flank_end_h) : half_pitch_;
  u_flank_ = end_u;
  u_bottom_ = end_u;
  segments_.push_back({u_protuberance_, flank_h, sin_a, cos_a, (flank_end_h - flank_h) / cos_a});
  line_angles_.push_back(alpha);
  if (!ends) return;
  if (n.semi_topping_angle) {
    const double ramp = *n.semi_topping_angle;
    require(ramp > alpha && ramp < kPi / 2,
            "semi_topping_angle: must lie between the pressure angle and a right angle");
    segments_.push_back({end_u, flank_end_h, std::sin(ramp), std::cos(ramp),
                         (half_pitch_ - end_u) / std::sin(ramp)});
    line_angles_.push_back(ramp);
    return;
  }
  if (rho1 > 0) {
    const double u = end_u + rho1 * cos_a;
    require(u < half_pitch_ + kRoundingWidth * m,
            "tip_fillet_radius: larger than the full rounding");
    u_bottom_ = std::min(u, half_pitch_);
    arcs_.push_back({u, flank_end_h - rho1 * sin_a, rho1, 0, 1, -cos_a, sin_a});
  }
  segments_.push_back({u_bottom_, flank_end_h + rho1 * (1 - sin_a), 1, 0, half_pitch_ - u_bottom_});
}

// The cutter is the region above its edge h(u). h never decreases as u increases.
double SweptRack::edge_height(double u) const {
  const RackNumbers& n = numbers_;
  if (u <= u_land_) return segments_[0].h;
  if (u <= u_round_) {
    const Arc& a = arcs_[0];
    return a.h - std::sqrt(std::max(0.0, (a.radius - (u - a.u)) * (a.radius + (u - a.u))));
  }
  if (u <= u_protuberance_)
    return segments_[1].h + (u - u_round_) * segments_[1].dh / segments_[1].du;
  if (u <= u_flank_) return (u - half_pitch_ / 2) / std::tan(n.normal_pressure_angle);
  if (u <= u_bottom_) {
    const Arc& a = arcs_[1];
    return a.h + std::sqrt(std::max(0.0, (a.radius - (u - a.u)) * (a.radius + (u - a.u))));
  }
  const Segment& last = segments_.back();
  return last.h + (u - last.u) * last.dh / last.du;
}

double SweptRack::distance_to_cutter(double h, double w) const {
  const double cell = std::floor(w / half_pitch_);
  const bool even = std::fmod(cell, 2.0) == 0;
  const double within = w - cell * half_pitch_;
  const double u = even ? half_pitch_ - within : within;
  double squared = kInfinity;
  for (const Segment& s : segments_) {
    const double a = u - s.u, b = h - s.h;
    const double t = std::clamp(a * s.du + b * s.dh, 0.0, s.length);
    const double e = a - t * s.du, f = b - t * s.dh;
    squared = std::min(squared, e * e + f * f);
  }
  double distance = std::sqrt(squared);
  for (const Arc& s : arcs_) {
    const double a = u - s.u, b = h - s.h;
    if (s.u0 * b - s.h0 * a >= 0 && a * s.h1 - b * s.u1 >= 0) {
      distance = std::min(distance, std::abs(std::sqrt(a * a + b * b) - s.radius));
    }
  }
  return h > edge_height(u) ? -distance : distance;
}

double SweptRack::gap_at(PlanePoint p, double roll) const {
  const double c = std::cos(roll), s = std::sin(roll);
  return distance_to_cutter(p.x * c - p.y * s - r_ - shift_,
                            (p.x * s + p.y * c - r_ * roll) * cos_beta_);
}

/// One minimisation, with its point and the best position so far.
struct SweptRack::Search {
  const SweptRack& rack;
  double rho, theta;
  double finest = 0.0;  ///< half width of the intervals of ψ at which the circles are evaluated
  double best = kInfinity, best_psi = 0.0;

  struct Place {
    double w, h, dw, dh, ddw, ddh;
  };
  Place place(double psi) const {
    const double c = rho * std::cos(psi), s = rho * std::sin(psi), k = rack.cos_beta_;
    return {(s - rack.r_ * (psi - theta)) * k,
            c - rack.r_ - rack.shift_,
            (c - rack.r_) * k,
            -s,
            -s * k,
            -c};
  }
  double gap(double psi) const {
    return rack.distance_to_cutter(
        rho * std::cos(psi) - rack.r_ - rack.shift_,
        (rho * std::sin(psi) - rack.r_ * (psi - theta)) * rack.cos_beta_);
  }
  void consider(double psi, double value) {
    if (value < best) best = value, best_psi = psi;
  }
  void consider(double psi) { consider(psi, gap(psi)); }

  /// The positions at which the path is parallel to a straight part.
  void straight_parts() {
    for (const double tau : rack.line_angles_) {
      const double a = std::cos(tau) * rack.cos_beta_ * rho, b = std::sin(tau) * rho;
      const double c = std::cos(tau) * rack.cos_beta_ * rack.r_;
      const double spread = std::acos(std::min(1.0, c / std::hypot(a, b)));
      const double middle = std::atan2(b, a);
      for (const double psi : {middle - spread, middle + spread}) consider(psi), consider(-psi);
    }
  }

  /// All ψ within `half` of `mid` at which the distance from (w_c, h_c) is stationary.
  void circle(double w_c, double h_c, double mid, double half) {
    const Place q = place(mid);
    const double x = q.w - w_c, y = q.h - h_c;
    const double v = std::hypot(q.dw, q.dh) + rho * half;
    const double reach = std::hypot(x, y) + v * half;
    const double f = x * q.dw + y * q.dh;
    if (std::abs(f) > (v * v + reach * rho) * half) return;
    const double df = q.dw * q.dw + q.dh * q.dh + x * q.ddw + y * q.ddh;
    if (std::abs(df) > (3 * v + reach) * rho * half) {
      // F is monotone, so there is at most one root. Newton's method is kept within the bracket.
      const auto value = [&](double psi) {
        const Place p = place(psi);
        return (p.w - w_c) * p.dw + (p.h - h_c) * p.dh;
      };
      double lo = mid - half, hi = mid + half;
      const double sign = df > 0 ? 1.0 : -1.0;
      if (sign * value(lo) > 0 || sign * value(hi) < 0) return;
      double psi = std::clamp(mid - f / df, lo, hi);
      for (int i = 0; i < 60; ++i) {
        const Place p = place(psi);
        const double a = p.w - w_c, b = p.h - h_c;
        const double now = a * p.dw + b * p.dh;
        (sign * now < 0 ? lo : hi) = psi;
        const double slope = p.dw * p.dw + p.dh * p.dh + a * p.ddw + b * p.ddh;
        double next = psi - now / slope;
        if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
        const double step = std::abs(next - psi);
        psi = next;
        if (step < 1e-15 || hi - lo < 1e-15) break;
      }
      return consider(psi);
    }
    // This is a double root to within 1e-10 rad, and the distance there is constant to 1e-20 mm.
    if (half < 1e-10) return consider(mid);
    circle(w_c, h_c, mid - half / 2, half / 2);
    circle(w_c, h_c, mid + half / 2, half / 2);
  }

  void explore(double mid, double half) {
    const Place q = place(mid);
    const double g = rack.distance_to_cutter(q.h, q.w);
    consider(mid, g);
    const double travel = (std::hypot(q.dw, q.dh) + rho * half) * half;
    if (g - travel > best) return;
    if (half > finest) {
      explore(mid - half / 2, half / 2);
      explore(mid + half / 2, half / 2);
      return;
    }
    const double p = rack.half_pitch_;
    const double last = std::floor((q.w + travel) / p);
    for (double cell = std::floor((q.w - travel) / p); cell <= last; ++cell) {
      const bool even = std::fmod(cell, 2.0) == 0;
      for (const Arc& arc : rack.arcs_) {
        circle(even ? (cell + 1) * p - arc.u : cell * p + arc.u, arc.h, mid, half);
      }
    }
  }

  /// Golden section around the deepest position, because the minimum inside the cutter may be a
  /// kink.
  void deepen() {
    constexpr double kGolden = 0.6180339887498949;
    double lo = best_psi - 2 * finest, hi = best_psi + 2 * finest;
    double a = hi - kGolden * (hi - lo), b = lo + kGolden * (hi - lo);
    double ga = gap(a), gb = gap(b);
    while (hi - lo > 1e-9) {
      if (ga < gb) {
        hi = b, b = a, gb = ga, a = hi - kGolden * (hi - lo), ga = gap(a);
      } else {
        lo = a, a = b, ga = gb, b = lo + kGolden * (hi - lo), gb = gap(b);
      }
    }
    consider(a, ga);
    consider(b, gb);
  }
};

double SweptRack::clearance(PlanePoint p) const {
  Search search{*this, std::hypot(p.x, p.y), std::atan2(p.y, p.x)};
  search.consider(0.0);
  if (search.rho > 0) search.straight_parts();
  // A point that is lower than the tip of the cutter by more than `best` cannot be nearer. The
  // condition is h ≥ −h_F m − best, which means ρ cos ψ ≥ r_f − best.
  const double floor = r_f_ - std::max(search.best, 0.0);
  if (floor > search.rho) return search.best;
  const double window = floor <= -search.rho ? kPi : std::acos(floor / search.rho);
  search.finest = window / 64;
  search.explore(0.0, window);
  if (search.best < 0) search.deepen();
  return search.best;
}

}  // namespace gearwright::oracle
