#include "tests/oracle/swept_tooth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gearwright::oracle {
namespace {

PlanePoint at(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Returns the first zero of `value` in [begin, end]. If value(t) ≥ 0, a step of value(t)/rate is
/// safe. Such steps are used until the value is below `near`. From there on, the step is doubled
/// until the value is negative. Bisection follows, whose 60 halvings end at neighbouring doubles.
template <class F>
std::optional<double> first_zero(F value, double begin, double end, double rate, double near) {
  double t = begin, v = value(t);
  if (v <= 0) return t;
  while (v > near) {
    t += v / rate;
    if (t >= end) return std::nullopt;
    v = value(t);
  }
  double step = std::max(v, near * 1e-3) / rate, lo = t, hi = t;
  while (v > 0) {
    if (lo >= end) return std::nullopt;
    lo = hi;
    hi = std::min(lo + step, end);
    v = value(hi);
    if (v > near) return first_zero(value, hi, end, rate, near);
    if (hi >= end && v > 0) return std::nullopt;
    step *= 1.5;
  }
  for (int i = 0; i < 60; ++i) {
    const double mid = 0.5 * (lo + hi);
    (value(mid) > 0 ? lo : hi) = mid;
  }
  return 0.5 * (lo + hi);
}

/// Distance at which the walk begins to search for the crossing. 1e-4 m is small compared with
/// every feature of a cutter.
double near_of(const SweptRack& rack) { return 1e-4 * rack.numbers().normal_module; }

double outermost(const SweptRack& rack) {
  const RackNumbers& n = rack.numbers();
  return std::min(n.tip_radius, 2 * rack.reference_radius() + 4 * n.normal_module);
}

}  // namespace

double material_half_angle(const SweptRack& rack, double radius) {
  const double half_pitch = std::numbers::pi / rack.numbers().teeth;
  if (radius > rack.numbers().tip_radius) return 0.0;
  if (radius <= 0) return rack.clearance({0, 0}) > 0 ? half_pitch : 0.0;
  const auto value = [&](double angle) { return rack.clearance(at(radius, angle)); };
  return first_zero(value, 0.0, half_pitch, radius, near_of(rack)).value_or(half_pitch);
}

std::optional<double> surface_radius(const SweptRack& rack, double angle, double from,
                                     double limit) {
  const auto value = [&](double radius) { return rack.clearance(at(radius, angle)); };
  return first_zero(value, from, limit, 1.0, near_of(rack));
}

double root_radius(const SweptRack& rack) {
  return surface_radius(rack, std::numbers::pi / rack.numbers().teeth, 0.0, outermost(rack))
      .value_or(outermost(rack));
}

bool severed(const SweptRack& rack) {
  return surface_radius(rack, 0.0, 0.0, rack.reference_radius()).has_value();
}

std::optional<double> pointed_radius(const SweptRack& rack) {
  if (severed(rack)) return std::nullopt;
  return surface_radius(rack, 0.0, rack.reference_radius(), outermost(rack));
}

double involute_half_angle(const SweptRack& rack, double radius) {
  const RackNumbers& n = rack.numbers();
  const double r = rack.reference_radius(), r_b = rack.base_radius();
  // Arc of half a tooth on the reference circle = half a space of the rack on the pitch line.
  const double half_arc =
      n.normal_module *
      (std::numbers::pi / 4 + n.profile_shift * std::tan(n.normal_pressure_angle)) /
      std::cos(n.helix_angle);
  const auto roll_less_angle = [&](double rho) {
    const double tangent = std::sqrt(std::max(0.0, (rho - r_b) * (rho + r_b))) / r_b;
    return tangent - std::atan(tangent);
  };
  return half_arc / r + roll_less_angle(r) - roll_less_angle(radius);
}

std::optional<double> form_radius(const SweptRack& rack) {
  // A hundred times the rounding error of `clearance`. The section "Accuracy" describes its effect.
  constexpr double kOnSurface = 1e-11;
  const auto gap = [&](double rho) {
    return rack.clearance(at(rho, involute_half_angle(rack, rho)));
  };
  const auto on_surface = [&](double rho) { return std::abs(gap(rho)) <= kOnSurface; };
  const double r_b = rack.base_radius(), m = rack.numbers().normal_module;
  const double top = std::min(pointed_radius(rack).value_or(outermost(rack)), outermost(rack));

  // The lowest of 400 radii that lies on the involute. They are denser towards the base circle.
  constexpr int kRadii = 400;
  double off = r_b, on = r_b;
  bool found = on_surface(r_b);
  if (found) return r_b;
  for (int i = 1; i <= kRadii && !found; ++i) {
    const double part = static_cast<double>(i) / kRadii;
    off = on;
    on = r_b + (top - r_b) * part * part;
    found = on_surface(on);
  }
  if (!found) return std::nullopt;
  while (on - off > 1e-13 * on) {
    const double mid = 0.5 * (on + off);
    if (mid <= off || mid >= on) break;
    (on_surface(mid) ? on : off) = mid;
  }
  // If the tooth is undercut, the involute is cut away below. Otherwise it runs inside the
  // material, with a depth that grows as the square of the distance. Three roots of the depth are
  // extrapolated to zero.
  const double step = 2e-4 * m;
  if (off - 3 * step < r_b || gap(off - step) <= 0) return on;
  const double a = std::sqrt(gap(on - step)), b = std::sqrt(gap(on - 2 * step)),
               c = std::sqrt(gap(on - 3 * step));
  // s(t) = depth^(1/2) at t = 1, 2, 3 steps below `on`; its parabola through them is zero at t0.
  const double second = a - 2 * b + c, first = (c - a) / 2;
  double t = 2.0 - b / first;
  for (int i = 0; i < 20; ++i) t = 2.0 - (b + second * (t - 2) * (t - 2) / 2) / first;
  return on - t * step;
}

std::optional<Neck> neck(const SweptRack& rack) {
  if (severed(rack)) return std::nullopt;
  const double high = form_radius(rack).value_or(rack.reference_radius());
  const double low = std::max(root_radius(rack), 0.0);
  const auto half_angle = [&](double rho) { return material_half_angle(rack, rho); };
  // From the root land on, the half angle first decreases and then increases towards the flank, or
  // it decreases throughout. The least value at 64 radii is refined by golden section.
  constexpr int kRadii = 64;
  double best = high, best_angle = half_angle(high);
  for (int i = 1; i < kRadii; ++i) {
    const double rho = low + (high - low) * i / kRadii;
    const double angle = half_angle(rho);
    if (angle < best_angle) best = rho, best_angle = angle;
  }
  constexpr double kGolden = 0.6180339887498949;
  double lo = std::max(low, best - (high - low) / kRadii);
  double hi = std::min(high, best + (high - low) / kRadii);
  while (hi - lo > 1e-7 * rack.numbers().normal_module) {
    const double a = hi - kGolden * (hi - lo), b = lo + kGolden * (hi - lo);
    (half_angle(a) < half_angle(b) ? hi : lo) = half_angle(a) < half_angle(b) ? b : a;
  }
  const double middle = 0.5 * (lo + hi), angle = half_angle(middle);
  if (angle < best_angle) best = middle, best_angle = angle;
  return Neck{best, best_angle};
}

}  // namespace gearwright::oracle
