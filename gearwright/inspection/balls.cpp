#include "gearwright/inspection/balls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "gearwright/base/units.hpp"
#include "gearwright/inspection/pin_sizes.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright {

namespace {

using std::numbers::pi;

constexpr double kSizeStep = 1e-4;  // mm, accuracy of the ball sizes given in messages

struct Base {
  double d_b, cos_b, tan_b;
  double sigma;  // +1; −1 for an internal gear
  double eta;    // η_b; negative if there is no space on the base cylinder
};

// Returns the base cylinder of a gear whose teeth have this transverse thickness on the base
// cylinder, mm. [T10.5]
Base base_of(const Gear& gear, double base_thickness) {
  const ReferenceGeometry<double>& g = gear.reference();
  return {g.base_diameter, std::cos(g.base_helix_angle), std::tan(g.base_helix_angle), gear.side(),
          pi / std::abs(gear.spec.teeth) - base_thickness / g.base_diameter};
}
Base base_of(const Gear& gear) { return base_of(gear, gear.reference().base_tooth_thickness); }

// Returns inv α_Kt. [T10.6]
double center_involute(const Base& b, double ball) {
  return b.sigma * (ball / (b.d_b * b.cos_b) - b.eta);
}

Error no_ball(double ball, const std::string& why) { return refused("ball_diameter", ball, why); }

// Returns the ball in the position in which it touches both flanks. Root and tips are not
// considered. Returns none if no position of the ball touches both flanks.
std::optional<BallSeat> seat_of(const Gear& gear, const UsableFlank& flank, double ball) {
  const Base b = base_of(gear);
  const double inv = center_involute(b, ball);
  if (!(inv >= 0.0)) return std::nullopt;
  const double alpha = inverse_involute(inv);
  const double d_K = b.d_b / std::cos(alpha);
  // Twice the roll length of the contacts. [T10.7]
  const double roll = b.d_b * std::tan(alpha) - b.sigma * ball * b.cos_b;
  if (!(roll >= 0.0)) return std::nullopt;
  const double d_M = std::hypot(b.d_b, roll);
  return BallSeat{ball,
                  alpha,
                  d_K,
                  d_M,
                  std::abs(ball / 2 * b.cos_b * b.tan_b),
                  (d_K + b.sigma * ball) / 2,
                  flank.place(d_M)};
}

// True if the lowest point of the ball lies below the root circle.
bool hits_root(const Gear& gear, const BallSeat& seat) {
  const double sigma = gear.side();
  const double lowest = seat.center_diameter / 2 - sigma * seat.ball_diameter / 2;
  return sigma * 2 * lowest < sigma * gear.root_diameter;
}

bool projects(const Gear& gear, const UsableFlank& flank, const BallSeat& seat) {
  return gear.side() * (seat.radial - flank.tip / 2) > 0.0;
}

// Returns the end of a message about a ball. It gives the range of ball diameters that fit. Such a
// ball touches on the usable flank, does not touch the root, and projects beyond the tip.
std::string sizes_text(const Gear& gear, const UsableFlank& flank) {
  const auto low = ball_touching_at(gear, flank.root_end);
  const auto high = ball_touching_at(gear, flank.tip_end);
  if (!low || !high) return "no ball touches these flanks";
  const auto fits = [&](double ball) {
    const auto seat = seat_of(gear, flank, ball);
    return seat && projects(gear, flank, *seat) && !hits_root(gear, *seat);
  };
  const double middle = ball_touching_at(gear, flank.middle()).value_or((*low + *high) / 2);
  const std::array<double, 3> tried{*low, middle, *high};
  const auto inside = std::find_if(tried.begin(), tried.end(), fits);
  if (inside == tried.end())
    return "a ball that touches on the usable flank cannot be measured, because it touches the "
           "root or does not project beyond the tip";
  // Returns the ball that touches at the end of the flank. If this ball does not fit, returns the
  // ball of the nearest size that fits.
  const auto nearest = [&](double outside) {
    if (fits(outside)) return outside;
    double fitting = *inside;
    while (std::abs(outside - fitting) > kSizeStep) {
      const double between = (outside + fitting) / 2;
      (fits(between) ? fitting : outside) = between;
    }
    return fitting;
  };
  const auto [least, most] = std::minmax({nearest(*low), nearest(*high)});
  return fmt::format("balls of {} mm to {} mm touch on the usable flank and can be measured",
                     format_number(std::ceil(least / kSizeStep) * kSizeStep),
                     format_number(std::floor(most / kSizeStep) * kSizeStep));
}

}  // namespace

Result<BallSeat> ball_in_space(const Gear& gear, double ball) {
  GW_EXPECTS(ball > 0.0);
  const auto flank = measurable_flank(gear, "ball_diameter", ball);
  if (!flank) return flank.error();
  if (std::abs(gear.spec.teeth) < 2)
    return no_ball(
        ball, "a gear with a single tooth space has no opposite tooth space for the second ball");
  const std::string sizes = sizes_text(gear, *flank);
  const auto seat = seat_of(gear, *flank, ball);
  // seat_of() finds no seat if the ball would have to touch the flanks inside the base circle,
  // where they have no involute. In the tooth space of an external gear, this happens if the ball
  // is too small. In the tooth space of an internal gear, it happens if the ball is too large.
  if (!seat) {
    const bool small =
        !gear.internal() || ball < ball_touching_at(gear, flank->middle()).value_or(0.0);
    return no_ball(ball, (small ? "is too small to touch both flanks; "
                                : "is too large for the tooth space; ") +
                             sizes);
  }
  if (seat->place == ContactPlace::beyond_tip)
    return no_ball(ball, fmt::format("rests on the tips, because it would touch the flanks at a "
                                     "diameter of {} mm, beyond the tip diameter of {} mm; {}",
                                     format_number(seat->contact_diameter, flank->tip),
                                     format_number(flank->tip, seat->contact_diameter), sizes));
  if (hits_root(gear, *seat))
    return no_ball(
        ball,
        fmt::format("touches the root, at a diameter of {} mm, before it touches both flanks; {}",
                    format_number(gear.root_diameter), sizes));
  if (!projects(gear, *flank, *seat))
    return no_ball(ball, fmt::format("does not project beyond the tip, because it reaches a "
                                     "radius of {} mm, but the tip is at a radius of {} mm; {}",
                                     format_number(seat->radial, flank->tip / 2),
                                     format_number(flank->tip / 2, seat->radial), sizes));
  return *seat;
}

double over_two_balls(const Gear& gear, const BallSeat& seat) {
  const int z = std::abs(gear.spec.teeth);
  GW_EXPECTS(z >= 2);
  const double across = z % 2 == 0 ? 1.0 : std::cos(pi / (2 * z));
  return seat.center_diameter * across + gear.side() * seat.ball_diameter;
}

namespace {

// The least distance between two helices on one cylinder, and the axial distance of the points that
// are nearest to each other. In every transverse plane, the points of the two helices deviate by
// the angle δ from opposite positions.
//
// T is tan² β_K, where β_K is the helix angle on the cylinder. Relative to the diameter of the
// cylinder, the least distance is √(cos²(ε/2) + (T/4) sin²(ε)), where ε solves ε − T sin(ε) = δ
// [T10.9]. The axial distance is (√T/2) sin(ε) = (ε − δ)/(2 √T) [T10.35].
struct Across {
  double distance, along;
};
Across least_across(double delta, double T) {
  double epsilon = delta;
  if (T > 0.0 && (delta > 0.0 || T > 1.0)) {
    const auto f = [&](double e) {
      return Slope<double>{e - T * std::sin(e) - delta, 1.0 - T * std::cos(e)};
    };
    // If T > 1, e − T sin e has a minimum between 0 and π, and the root lies above it.
    const double lo = T > 1.0 ? std::acos(1.0 / T) : 0.0;
    const double start = std::clamp(delta + T * std::sin(delta), lo, pi);
    const auto root = newton_in_bracket<double>(f, lo, pi, start, true);
    GW_ENSURES(root.found());
    epsilon = root.x;
  }
  const double c = std::cos(epsilon / 2), s = std::sin(epsilon) / 2;
  return {std::sqrt(c * c + T * s * s), std::sqrt(T) * s};
}

}  // namespace

PinReading over_pins(const Gear& gear, const BallSeat& seat) {
  const int z = std::abs(gear.spec.teeth);
  GW_EXPECTS(z >= 2);
  const double tan_K = seat.center_diameter / gear.reference().base_diameter *
                       std::tan(gear.reference().base_helix_angle);
  if (gear.spec.helix_angle.rad() == 0.0) {
    const double both = over_two_balls(gear, seat);
    const double c = z % 2 == 0 ? 1.0 : std::cos(pi / (2 * z));
    return {both, both, seat.center_diameter * c * c + gear.side() * seat.ball_diameter, 0.0};
  }
  if (!straight_tools_fit(gear)) return {};
  const double delta = z % 2 == 0 ? 0.0 : pi / z;
  const double outermost = seat.center_diameter + seat.ball_diameter;
  const Across least = least_across(delta, tan_K * tan_K);
  const double face = seat.center_diameter * least.along + 2 * seat.contact_offset;
  return {seat.center_diameter * least.distance + seat.ball_diameter, outermost, outermost, face};
}

std::optional<double> ball_touching_at(const Gear& gear, double contact_diameter) {
  const Base b = base_of(gear);
  GW_EXPECTS(contact_diameter >= b.d_b);
  const double T = b.tan_b * b.tan_b;
  const double xi = leaf::curvature_at(contact_diameter, b.d_b) / b.d_b;
  const double sum = (1.0 + T) * xi + b.sigma * b.eta;
  if (!(sum > 0.0)) return std::nullopt;
  double alpha = sum;
  if (T > 0.0 || alpha >= pi / 2) {
    const auto f = [&](double a) {
      const double t = std::tan(a);
      return Slope<double>{a + T * t - sum, 1.0 + T * (1.0 + t * t)};
    };
    if (T == 0.0) return std::nullopt;
    const auto root = newton_in_bracket<double>(f, 0.0, std::min(sum, pi / 2),
                                                std::min(sum / (1.0 + T), 1.5), true);
    GW_ENSURES(root.found());
    alpha = root.x;
  }
  const double ball = b.sigma * b.d_b * (std::tan(alpha) - xi) / b.cos_b;
  if (!(ball > 0.0)) return std::nullopt;
  return ball;
}

std::optional<double> base_thickness_from_balls(const Gear& gear, double ball, double dimension) {
  const Base b = base_of(gear, 0.0);
  const int z = std::abs(gear.spec.teeth);
  const double across = z % 2 == 0 ? 1.0 : std::cos(pi / (2 * z));
  const double d_K = (dimension - b.sigma * ball) / across;
  if (!(d_K >= b.d_b)) return std::nullopt;
  const double inv = involute_of_roll(leaf::curvature(d_K, b.d_b) / b.d_b);
  // η_b = D_M/(d_b cos β_b) − σ inv α_Kt. b.eta is π/|z|, because b has the tooth thickness 0.
  return b.d_b * (b.eta - ball / (b.d_b * b.cos_b) + b.sigma * inv);
}

namespace {

double nearest_inch(double mm) {
  const double in = mm / kMmPerInch;
  const double step = in < 0.5 ? 1.0 / 64 : in < 1.0 ? 1.0 / 32 : 1.0 / 16;
  return std::max(step, std::round(in / step) * step);
}

// Returns the nearest standard size that can be measured or, if there is none, the nearest size.
double nearest_metric(const Gear& gear, double mm) {
  const auto usable = [&](double size) {
    const auto seat = ball_in_space(gear, size);
    return seat && seat->usable();
  };
  const auto found = nearest_pin_size(mm, usable);
  return found ? *found : *nearest_pin_size(mm, [](double) { return true; });
}

}  // namespace

std::optional<BallSizes> ball_sizes(const Gear& gear) {
  const auto flank = usable_flank(gear);
  if (!flank || std::abs(gear.spec.teeth) < 2) return std::nullopt;
  const auto ideal = ball_touching_at(gear, usual_contact_diameter(gear, *flank));
  if (!ideal) return std::nullopt;
  return BallSizes{*ideal, nearest_metric(gear, *ideal), nearest_inch(*ideal)};
}

}  // namespace gearwright
