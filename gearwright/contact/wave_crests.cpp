#include "gearwright/contact/wave_crests.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gearwright::detail {

namespace {

// Limit of the search for an exact ridge. Two or three steps are usual.
constexpr int kMaxCrestSteps = 12;
// Limit for the last step of φ, rad. Such a step changes the gap field T by less than 1e-17.
constexpr double kRidge = 1e-9;
// Greatest permitted error of the quadratic functions, relative to the amplitude of the waves.
constexpr double kMiss = 0.01;
// Greatest permitted error of T between two nodes, relative to the amplitude of the waves.
constexpr double kMargin = 0.1;
// The waves add to the curvature of T. If this part exceeds kSteep times the curvature of T on
// smooth flanks, T may have several maxima over the profile.
constexpr double kSteep = 0.5;
constexpr int kPerWave = 6;     // nodes over the height z, per wave
constexpr int kLeastNodes = 7;  // least number of nodes over the height z
// Examined range beyond each end of the path of contact, relative to the length of the path.
constexpr double kBeyondPath = 0.2;

double base_radius(const FlankPatch& f) {
  if (f.removal) return f.removal->base_radius();
  const double s = 0.5 * (f.s_lo + f.s_hi);
  return std::abs(f.profile.at(s).factor) / std::hypot(1.0, s);
}

// The length L = √(ρ² − r_b²) at ln ρ = u.
double roll_at(const FlankPatch& f, double u) {
  const double r_b = base_radius(f);
  return std::sqrt(std::max(0.0, std::exp(2 * u) - r_b * r_b));
}

// Phase of a wave per mm, along L (direction 0) or along z (direction 1); 0 without such a wave.
double rate_of(const FlankPatch& f, std::size_t direction) {
  if (!f.removal) return 0.0;
  const auto& first = f.removal->pieces().front();
  const auto& last = f.removal->pieces().back();
  const double width =
      direction == 0 ? roll_at(f, last.u_hi) - roll_at(f, first.u_lo) : last.z_hi - first.z_lo;
  return 2 * std::numbers::pi * f.removal->waves()[direction].waves / width;
}

double half_height(const FlankPatch& f, std::size_t direction) {
  if (!f.removal || f.removal->waves()[direction].waves == 0) return 0.0;
  return 0.5 * f.removal->waves()[direction].height;
}

bool suits(const FlankPatch& f) {
  return f.profile.involute() && !(f.removal && f.removal->has_topography());
}

// The coefficients of the parabola through the values at −1, 0 and 1.
std::array<double, 3> parabola(double below, double here, double above) {
  return {here, 0.5 * (above - below), 0.5 * (above + below) - here};
}

}  // namespace

WaveCrests::Quadratic WaveCrests::Biquadratic::along_x(double y) const {
  Quadratic f;
  for (std::size_t i = 0; i < 3; ++i) f.c[i] = c[0][i] + y * (c[1][i] + y * c[2][i]);
  return f;
}

std::optional<WaveCrests> WaveCrests::of(const ContactPair& pair, const FlankPatch& one,
                                         const FlankPatch& two) {
  const auto wavy = [](const FlankPatch& f) { return f.removal && f.removal->wavy(); };
  if (!wavy(one) && !wavy(two)) return std::nullopt;
  if (!suits(one) || !suits(two) || pair.place().axis_angle != Angle()) return std::nullopt;
  WaveCrests crests(one, two);
  return crests.make(pair) ? std::optional(crests) : std::nullopt;
}

std::optional<WaveCrests::Ridge> WaveCrests::solve(GapField& field, double s, double z,
                                                   double phi) const {
  // On involutes, the s of the ridge changes by the angle by which gear 1 turns.
  const double way = field.rotation_sign() * one_.profile.side();
  double s2 = s2_;
  for (int i = 0; i < kMaxCrestSteps; ++i) {
    field.set_rotation(phi);
    const GapJet j = field.at(s, z, s2);
    const double step = way * j.t.s / j.t.ss;
    if (!std::isfinite(step) || !(j.t.ss < 0.0)) return std::nullopt;
    if (std::abs(step) < kRidge) {
      const double roll2 = roll_at(two_, j.u.v);
      const double square = std::exp(2 * j.u.v);
      const double roll2_s = square * j.u.s / roll2;
      const double roll2_ss = (square * (2 * j.u.s * j.u.s + j.u.ss) - roll2_s * roll2_s) / roll2;
      return Ridge{phi, j.t.v, roll2, j.t.ss, roll2_s, roll2_ss};
    }
    phi += step;
  }
  return std::nullopt;
}

std::optional<WaveCrests::Path> WaveCrests::nominal_path(const ContactPair& pair) {
  // `action` is the length of the line of action between its points of contact with the two base
  // circles. If the centre distance is the only error, `action` equals L_1 + L_2, or L_2 − L_1 for
  // an internal gear. The pitch point is the point of flank 1 with the roll angle s_w.
  const double r_b1 = base_radius(one_), r_b2 = base_radius(two_);
  const double a = pair.place().center_distance + pair.place().errors.center_distance;
  const double sign = pair.side();
  const double bases = r_b2 + sign * r_b1;
  const double across_bases = a * a - bases * bases;
  if (!(across_bases > 0.0)) return std::nullopt;
  const double action = std::sqrt(across_bases);
  const auto s_opposite = [&](double roll2) { return sign * (action - roll2) / r_b1; };
  const auto [least, greatest] = std::minmax({s_opposite(roll2_lo_), s_opposite(roll2_hi_)});
  Path path;
  path.from = std::max(one_.s_lo, least);
  path.to = std::min(one_.s_hi, greatest);
  if (!(path.from < path.to)) {
    // An edge may touch a little beyond the path of contact, where the quadratic functions are not
    // valid. Beyond the part of the path that kBeyondPath adds, the patches never touch.
    if (!(path.from - path.to < kBeyondPath * (greatest - least))) z_hi_ = z_lo_;
    return std::nullopt;
  }
  const double s_w = action / (r_b2 + sign * r_b1);
  const PolarJet pitch_point = one_.profile.at(s_w);
  path.phi = (pair.mesh_azimuth() - std::arg(pitch_point.factor) - pitch_point.phase - one_.center -
              z_mid_ * one_.twist) /
             pair.rotation_sign();
  path.phi_s = pair.rotation_sign() * one_.profile.side();
  path.phi_z = -one_.twist / pair.rotation_sign();
  path.phi += path.phi_s * (0.5 * (path.from + path.to) - s_w);
  return path;
}

void WaveCrests::set_middle(const Path& path) {
  s_mid_ = 0.5 * (path.from + path.to);
  s_half_ = 0.5 * (path.to - path.from);
}

bool WaveCrests::adjust(GapField& field, Path& path) {
  for (int pass = 0; pass < 2; ++pass) {
    set_middle(path);
    const auto here = solve(field, s_mid_, z_mid_, path.phi);
    if (!here) return false;
    const auto next =
        solve(field, s_mid_ + 0.5 * s_half_, z_mid_, here->phi + path.phi_s * s_half_ / 2);
    if (!next) return false;
    path.phi_s = (next->phi - here->phi) / (0.5 * s_half_);
    const double slope = (next->roll2 - here->roll2) / (0.5 * s_half_);
    const auto [below, above] = std::minmax(
        {s_mid_ + (roll2_lo_ - here->roll2) / slope, s_mid_ + (roll2_hi_ - here->roll2) / slope});
    path.from = std::max(one_.s_lo, below);
    path.to = std::min(one_.s_hi, above);
    path.phi = here->phi + path.phi_s * (0.5 * (path.from + path.to) - s_mid_);
    if (!(path.from < path.to)) return false;
  }
  set_middle(path);
  return true;
}

std::optional<WaveCrests::Ridge> WaveCrests::ridge_at(GapField& field, const Path& path, double x,
                                                      double y) const {
  return solve(field, s_mid_ + x * s_half_, z_mid_ + y * z_half_,
               path.phi + path.phi_s * x * s_half_ + path.phi_z * y * z_half_);
}

std::optional<WaveCrests::Ridges> WaveCrests::ridges_on(GapField& field, const Path& path) const {
  Ridges ridges;
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) {
      const auto ridge = ridge_at(field, path, i - 1, k - 1);
      if (!ridge) return std::nullopt;
      ridges[k][i] = *ridge;
    }
  }
  return ridges;
}

WaveCrests::Biquadratic WaveCrests::interpolate(const Ridges& ridges, double Ridge::*value) {
  std::array<std::array<double, 3>, 3> rows;
  for (std::size_t k = 0; k < 3; ++k)
    rows[k] = parabola(ridges[k][0].*value, ridges[k][1].*value, ridges[k][2].*value);
  Biquadratic f;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto by_y = parabola(rows[0][i], rows[1][i], rows[2][i]);
    for (std::size_t k = 0; k < 3; ++k) f.c[k][i] = by_y[k];
  }
  return f;
}

void WaveCrests::set_rotations(const Ridges& ridges, const Path& path) {
  phi_lo_ = std::numeric_limits<double>::infinity();
  phi_hi_ = -phi_lo_;
  for (const int k : {0, 2}) {
    for (const int i : {0, 2}) {
      phi_lo_ = std::min(phi_lo_, ridges[k][i].phi);
      phi_hi_ = std::max(phi_hi_, ridges[k][i].phi);
    }
  }
  const double more = kBeyondPath * std::abs(2 * s_half_ * path.phi_s);
  phi_lo_ -= more;
  phi_hi_ += more;
}

void WaveCrests::set_waves(const Ridges& ridges, const Path& path) {
  const auto roll1 = [&](double s) {
    return roll_at(one_, std::log(std::abs(one_.profile.at(s).factor)));
  };
  roll1_per_s_ = (roll1(path.to) - roll1(path.from)) / (path.to - path.from);
  roll1_ = roll1(s_mid_);
  double least_bend = std::numeric_limits<double>::infinity();
  for (const auto& row : ridges)
    for (const Ridge& ridge : row) least_bend = std::min(least_bend, -ridge.bend);

  const double line = path.phi_z / path.phi_s;  // −ds/dz along a line of contact
  const std::array<double, 2> by_s{roll1_per_s_, ridges[1][1].roll2_s};
  const std::array<double, 2> by_z{
      line * roll1_per_s_, line * (ridges[1][2].roll2 - ridges[1][0].roll2) / (2 * s_half_)};
  double steep = 0.0;
  double fastest = 0.0;
  const std::array<const FlankPatch*, 2> own{&one_, &two_};
  for (const std::size_t g : {0, 1}) {
    const double across = rate_of(*own[g], 0);
    wave_[g] = {half_height(*own[g], 0) / arm_, across};
    const double along_s = across * by_s[g];
    steep += half_height(*own[g], 0) * (along_s * along_s) / arm_;
    across_ += half_height(*own[g], 0) / arm_;
    along_ += half_height(*own[g], 1) / arm_;
    fastest = std::max({fastest, std::abs(across * by_z[g]), std::abs(rate_of(*own[g], 1))});
  }
  steep_ = steep > kSteep * least_bend;
  branch_ = std::sqrt(across_ / least_bend);
  const double waves = fastest * (z_hi_ - z_lo_) / (2 * std::numbers::pi);
  const int nodes = std::max(kLeastNodes, static_cast<int>(std::ceil(kPerWave * waves)) + 1);
  for (int i = 0; i < nodes; ++i) {
    const double z = z_lo_ + (z_hi_ - z_lo_) * i / (nodes - 1);
    sections_.push_back({z, along_face(z)});
  }
}

bool WaveCrests::accurate(GapField& field, const Path& path) const {
  for (const double y : {-0.5, 0.5}) {
    for (const double x : {-0.5, 0.5}) {
      const auto ridge = ridge_at(field, path, x, y);
      if (!ridge) return false;
      const double missed = te_.along_x(y).at(x) - ridge->te;
      const double beside = (phi_.along_x(y).at(x) - ridge->phi) / path.phi_s;
      const double aside = ridge->bend * (beside * beside);
      if (!(std::abs(missed) + std::abs(aside) < kMiss * (across_ + along_))) return false;
    }
  }
  return true;
}

bool WaveCrests::make(const ContactPair& pair) {
  std::array<std::optional<RemovalField>, 2> smooth;
  std::array<FlankPatch, 2> flank{one_, two_};
  for (const std::size_t g : {0, 1}) {
    if (!flank[g].removal) continue;
    smooth[g] = flank[g].removal->smooth();
    flank[g].removal = &*smooth[g];
  }
  GapField field = pair.field(flank[0], flank[1]);
  s2_ = 0.5 * (two_.s_lo + two_.s_hi);
  z_shift_ = pair.mount().shift.r.z();
  z_lo_ = std::max(one_.z_lo, two_.z_lo - z_shift_);
  z_hi_ = std::min(one_.z_hi, two_.z_hi - z_shift_);
  if (apart()) return true;
  z_mid_ = 0.5 * (z_lo_ + z_hi_);
  z_half_ = 0.5 * (z_hi_ - z_lo_);
  roll2_lo_ = roll_at(two_, two_.u_lo);
  roll2_hi_ = roll_at(two_, two_.u_hi);
  std::optional<Path> path = nominal_path(pair);
  if (apart()) return true;
  if (!path || !adjust(field, *path)) return false;
  const auto ridges = ridges_on(field, *path);
  if (!ridges) return false;
  phi_ = interpolate(*ridges, &Ridge::phi);
  te_ = interpolate(*ridges, &Ridge::te);
  roll2_ = interpolate(*ridges, &Ridge::roll2);
  bend_ = interpolate(*ridges, &Ridge::bend);
  roll2_s_ = interpolate(*ridges, &Ridge::roll2_s);
  roll2_ss_ = interpolate(*ridges, &Ridge::roll2_ss);
  double s2 = s2_;
  field.set_rotation((*ridges)[1][1].phi);
  arm_ = GapField::arm(field.at(s_mid_, z_mid_, s2));
  set_waves(*ridges, *path);
  set_rotations(*ridges, *path);
  margin_ = kMargin * (across_ + along_);
  return accurate(field, *path);
}

}  // namespace gearwright::detail
