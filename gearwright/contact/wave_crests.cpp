#include "gearwright/contact/wave_crests.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gearwright::detail {

namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();
constexpr int kMaxSteps = 12;    // limit of the search for an exact ridge; two or three are usual
constexpr double kRidge = 1e-9;  // step of φ, rad, that changes T by less than 1e-17
constexpr double kMiss = 0.01;   // greatest error of the quadratic functions, per amplitude
constexpr double kMargin = 0.1;  // greatest error of T between two nodes, per amplitude
constexpr double kSteep = 0.5;   // ratio of the curvature of T by waves to its curvature on smooth
                                 // flanks, above which T may have several maxima over the profile
constexpr int kAcross = 5;       // points examined over the profile if the ratio exceeds kSteep
constexpr int kPerWave = 6;      // nodes over the height z, per wave
constexpr int kLeastNodes = 7;   // least number of nodes over the height z
constexpr double kBeyondPath = 0.2;  // range searched beyond each end, in lengths of the path

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

// A wave over the profile, as a complex number whose phase advances from point to point. The value
// of the wave is the imaginary part of `at`.
struct Phasor {
  Complex at{}, turn{}, faster{};
};

// The wave of a flank at L, for the amplitude 1.
Complex unit_of(const FlankPatch& f, double rate, double L) {
  const auto w = f.removal->profile_wave(L);
  const double height = half_height(f, 0);
  return {w.d1 / (rate * height), w.c / height};
}

Complex turn_by(double angle) { return {std::cos(angle), std::sin(angle)}; }
// The value of turn_by() to second order in the angle.
Complex turn_by_little(double angle) { return {1.0 - 0.5 * angle * angle, angle}; }

}  // namespace

std::array<double, 3> WaveCrests::Biquadratic::along_x(double y) const {
  std::array<double, 3> a;
  for (std::size_t i = 0; i < 3; ++i) a[i] = c[0][i] + y * (c[1][i] + y * c[2][i]);
  return a;
}

namespace {

double at_x(const std::array<double, 3>& a, double x) { return a[0] + x * (a[1] + x * a[2]); }

// The coefficients of the parabola through the values at −1, 0 and 1.
std::array<double, 3> parabola(double below, double here, double above) {
  return {here, 0.5 * (above - below), 0.5 * (above + below) - here};
}

}  // namespace

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
  // On involutes, the ridge moves along s by as much as gear 1 turns.
  const double way = field.rotation_sign() * one_.profile.side();
  double s2 = s2_;
  for (int i = 0; i < kMaxSteps; ++i) {
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
  z_shift_ = pair.mount().shift.z();
  z_lo_ = std::max(one_.z_lo, two_.z_lo - z_shift_);
  z_hi_ = std::min(one_.z_hi, two_.z_hi - z_shift_);
  if (apart()) return true;
  z_mid_ = 0.5 * (z_lo_ + z_hi_);
  z_half_ = 0.5 * (z_hi_ - z_lo_);
  roll2_lo_ = roll_at(two_, two_.u_lo);
  roll2_hi_ = roll_at(two_, two_.u_hi);
  // The part of flank 1 that meets flank 2. Without errors, L_1 + L_2 (L_2 − L_1 for an internal
  // gear) is `action`, the distance between the two points at which the line of action touches the
  // base circles. The point of flank 1 at the pitch point has the roll angle s_w.
  const double r_b1 = base_radius(one_), r_b2 = base_radius(two_);
  const double a = pair.place().center_distance + pair.place().errors.center_distance;
  const double sign = pair.mirror();
  const double across_bases = a * a - std::pow(r_b2 + sign * r_b1, 2);
  if (!(across_bases > 0.0)) return false;
  const double action = std::sqrt(across_bases);
  const auto s_opposite = [&](double roll2) { return sign * (action - roll2) / r_b1; };
  const auto [least, greatest] = std::minmax({s_opposite(roll2_lo_), s_opposite(roll2_hi_)});
  double from = std::max(one_.s_lo, least);
  double to = std::min(one_.s_hi, greatest);
  if (!(from < to)) {
    // An edge may touch a little beyond the path of contact, where the quadratic functions are not
    // valid.
    if (from - to < kBeyondPath * (greatest - least)) return false;
    z_hi_ = z_lo_;
    return true;
  }
  const double turn_per_z = -one_.twist / pair.rotation_sign();
  const double s_w = action / (r_b2 + sign * r_b1);
  const PolarJet pitch_point = one_.profile.at(s_w);
  double phi = (pair.mesh_azimuth() - std::arg(pitch_point.factor) - pitch_point.phase -
                one_.center - z_mid_ * one_.twist) /
               pair.rotation_sign();
  double phi_s = pair.rotation_sign() * one_.profile.side();
  phi += phi_s * (0.5 * (from + to) - s_w);
  for (int pass = 0; pass < 2; ++pass) {
    s_mid_ = 0.5 * (from + to);
    s_half_ = 0.5 * (to - from);
    const auto here = solve(field, s_mid_, z_mid_, phi);
    if (!here) return false;
    const auto next = solve(field, s_mid_ + 0.5 * s_half_, z_mid_, here->phi + phi_s * s_half_ / 2);
    if (!next) return false;
    phi_s = (next->phi - here->phi) / (0.5 * s_half_);
    const double slope = (next->roll2 - here->roll2) / (0.5 * s_half_);
    const auto [below, above] = std::minmax(
        {s_mid_ + (roll2_lo_ - here->roll2) / slope, s_mid_ + (roll2_hi_ - here->roll2) / slope});
    from = std::max(one_.s_lo, below);
    to = std::min(one_.s_hi, above);
    phi = here->phi + phi_s * (0.5 * (from + to) - s_mid_);
    if (!(from < to)) return false;
  }
  s_mid_ = 0.5 * (from + to);
  s_half_ = 0.5 * (to - from);
  std::array<std::array<Ridge, 3>, 3> ridges;
  const auto exact = [&](double x, double y) {
    return solve(field, s_mid_ + x * s_half_, z_mid_ + y * z_half_,
                 phi + phi_s * x * s_half_ + turn_per_z * y * z_half_);
  };
  double least_bend = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) {
      const auto ridge = exact(i - 1, k - 1);
      if (!ridge) return false;
      ridges[k][i] = *ridge;
      least_bend = std::min(least_bend, -ridge->bend);
    }
  }
  const auto fit = [&](double Ridge::*value) {
    std::array<std::array<double, 3>, 3> rows;
    for (std::size_t k = 0; k < 3; ++k)
      rows[k] = parabola(ridges[k][0].*value, ridges[k][1].*value, ridges[k][2].*value);
    Biquadratic f;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto by_y = parabola(rows[0][i], rows[1][i], rows[2][i]);
      for (std::size_t k = 0; k < 3; ++k) f.c[k][i] = by_y[k];
    }
    return f;
  };
  phi_ = fit(&Ridge::phi);
  te_ = fit(&Ridge::te);
  roll2_ = fit(&Ridge::roll2);
  bend_ = fit(&Ridge::bend);
  roll2_s_ = fit(&Ridge::roll2_s);
  roll2_ss_ = fit(&Ridge::roll2_ss);
  const auto roll1 = [&](double s) {
    return roll_at(one_, std::log(std::abs(one_.profile.at(s).factor)));
  };
  roll1_per_s_ = (roll1(to) - roll1(from)) / (to - from);
  roll1_ = roll1(s_mid_);
  double s2 = s2_;
  field.set_rotation(ridges[1][1].phi);
  arm_ = GapField::arm(field.at(s_mid_, z_mid_, s2));

  const double line = turn_per_z / phi_s;  // −ds/dz along a line of contact
  const std::array<double, 2> by_s{roll1_per_s_, ridges[1][1].roll2_s};
  const std::array<double, 2> by_z{
      line * roll1_per_s_, line * (ridges[1][2].roll2 - ridges[1][0].roll2) / (2 * s_half_)};
  double steep = 0.0;
  double fastest = 0.0;
  const std::array<const FlankPatch*, 2> own{&one_, &two_};
  for (const std::size_t g : {0, 1}) {
    const double across = rate_of(*own[g], 0);
    wave_[g] = {half_height(*own[g], 0) / arm_, across};
    steep += half_height(*own[g], 0) * std::pow(across * by_s[g], 2) / arm_;
    across_ += half_height(*own[g], 0) / arm_;
    along_ += half_height(*own[g], 1) / arm_;
    fastest = std::max({fastest, std::abs(across * by_z[g]), std::abs(rate_of(*own[g], 1))});
  }
  steep_ = steep > kSteep * least_bend;
  const double amplitude = across_ + along_;
  margin_ = kMargin * amplitude;
  const double waves = fastest * (z_hi_ - z_lo_) / (2 * std::numbers::pi);
  const int nodes = std::max(kLeastNodes, static_cast<int>(std::ceil(kPerWave * waves)) + 1);
  for (int i = 0; i < nodes; ++i) {
    const double z = z_lo_ + (z_hi_ - z_lo_) * i / (nodes - 1);
    sections_.push_back({z, along_face(z)});
  }
  branch_ = std::sqrt(across_ / least_bend);
  phi_lo_ = std::numeric_limits<double>::infinity();
  phi_hi_ = kNone;
  for (const int k : {0, 2}) {
    for (const int i : {0, 2}) {
      phi_lo_ = std::min(phi_lo_, ridges[k][i].phi);
      phi_hi_ = std::max(phi_hi_, ridges[k][i].phi);
    }
  }
  const double more = kBeyondPath * std::abs(2 * s_half_ * phi_s);
  phi_lo_ -= more;
  phi_hi_ += more;
  // Half way between the nine exact ridges, the quadratic functions have their greatest error.
  for (const double y : {-0.5, 0.5}) {
    for (const double x : {-0.5, 0.5}) {
      const auto ridge = exact(x, y);
      if (!ridge) return false;
      const double missed = at_x(te_.along_x(y), x) - ridge->te;
      const double aside =
          ridge->bend * std::pow((at_x(phi_.along_x(y), x) - ridge->phi) / phi_s, 2);
      if (!(std::abs(missed) + std::abs(aside) < kMiss * amplitude)) return false;
    }
  }
  return true;
}

WaveCrests::Node WaveCrests::node(double phi, double z, double along_face, double least) const {
  const double y = (z - z_mid_) / z_half_;
  const auto turn = phi_.along_x(y);
  double x = (phi - turn[0]) / turn[1];
  for (int i = 0; i < 2; ++i) x -= (at_x(turn, x) - phi) / (turn[1] + 2 * turn[2] * x);
  const double ridge = s_mid_ + x * s_half_;
  const double roll2 = at_x(roll2_.along_x(y), x);
  const double roll2_s = at_x(roll2_s_.along_x(y), x);
  const double roll2_ss = at_x(roll2_ss_.along_x(y), x);
  // The points of flank 1 that lie opposite the ends of flank 2. If the parabola does not reach an
  // end, its vertex is used.
  const auto opposite = [&](double end) {
    const double rest = end - roll2;
    const double root = roll2_s * roll2_s + 2 * roll2_ss * rest;
    return ridge + 2 * rest / (roll2_s + std::copysign(std::sqrt(std::max(0.0, root)), roll2_s));
  };
  const auto [a, b] = std::minmax({opposite(roll2_lo_), opposite(roll2_hi_)});
  const double lo = std::max(one_.s_lo, a);
  const double hi = std::min(one_.s_hi, b);
  Node n;
  n.z = z;
  n.inside = std::min(ridge - lo, hi - ridge);
  if (lo > hi) return n;
  // The slope of T is nearly the curvature of T at the ridge times the distance from the ridge.
  const auto bends = bend_.along_x(y);
  const double bend = at_x(bends, x);
  const double bend_s = (bends[1] + 2 * bends[2] * x) / s_half_;
  const double top = at_x(te_.along_x(y), x) - along_face;
  const auto smooth = [&](double d) { return top + (0.5 * bend + bend_s * d / 3) * d * d; };
  const double start = std::clamp(ridge, lo, hi);
  if (smooth(start - ridge) + across_ < least) return n;
  n.outside = false;
  const double reach = steep_ ? 2 * std::sqrt(across_ / -bend) : 0.0;
  const double first = std::max(lo, start - reach);
  const double step = (std::min(hi, start + reach) - first) / (kAcross - 1);
  const int places = step > 0.0 ? kAcross : 1;
  // At equal steps of s, the phase of the wave of flank 1 advances by a constant angle, and the
  // phase of the wave of flank 2 by an angle that grows linearly.
  double d = first - ridge;
  std::array<Phasor, 2> waves;
  if (wave_[0].height > 0.0)
    waves[0] = {unit_of(one_, wave_[0].rate, roll1_ + roll1_per_s_ * (first - s_mid_)),
                turn_by(wave_[0].rate * roll1_per_s_ * step),
                {1.0, 0.0}};
  if (wave_[1].height > 0.0)
    waves[1] = {unit_of(two_, wave_[1].rate, roll2 + (roll2_s + 0.5 * roll2_ss * d) * d),
                turn_by(wave_[1].rate * step * (roll2_s + roll2_ss * (d + 0.5 * step))),
                turn_by_little(wave_[1].rate * step * step * roll2_ss)};
  double away = 0.0;
  Complex best_1, best_2;
  for (int i = 0; i < places; ++i) {
    const double te =
        smooth(d) - wave_[0].height * waves[0].at.imag() - wave_[1].height * waves[1].at.imag();
    if (i == 0 || te > n.te) {
      n.te = te;
      away = d;
      best_1 = waves[0].at;
      best_2 = waves[1].at;
    }
    d += step;
    for (Phasor& w : waves) {
      w.at = times(w.at, w.turn);
      w.turn = times(w.turn, w.faster);
    }
  }
  const double rate_1 = wave_[0].rate * roll1_per_s_;
  const double rate_2 = wave_[1].rate * (roll2_s + roll2_ss * away);
  const double slope = (bend + bend_s * away) * away - wave_[0].height * rate_1 * best_1.real() -
                       wave_[1].height * rate_2 * best_2.real();
  const double second = bend + 2 * bend_s * away +
                        wave_[0].height * rate_1 * rate_1 * best_1.imag() +
                        wave_[1].height * rate_2 * rate_2 * best_2.imag();
  n.s = ridge + away;
  if (second < 0.0) {
    const double last = std::clamp(n.s - slope / second, lo, hi) - n.s;
    n.te += (slope + 0.5 * second * last) * last;
    n.s += last;
  }
  n.aside = n.s - ridge;
  return n;
}

double WaveCrests::along_face(double z) const {
  double c = 0.0;
  for (const auto& [f, height] : {std::pair(&one_, z), std::pair(&two_, z + z_shift_)})
    if (f->removal && f->removal->waves()[1].waves > 0)
      c += f->removal->helix_wave(f->removal_z * height).c;
  return c / arm_;
}

std::vector<WaveCrests::Crest> WaveCrests::at(double phi, double least) const {
  std::vector<Crest> crests;
  if (apart() || phi < phi_lo_ || phi > phi_hi_) return crests;
  std::vector<Node> nodes;
  nodes.reserve(sections_.size() + 4);
  for (const auto& [z, along] : sections_) {
    const Node next = node(phi, z, along, least);
    // The ridge has a kink where it leaves D, so a node is added there.
    if (!nodes.empty() && (nodes.back().inside > 0.0) != (next.inside > 0.0)) {
      const Node& last = nodes.back();
      const double part = last.inside / (last.inside - next.inside);
      const double corner = last.z + part * (next.z - last.z);
      nodes.push_back(node(phi, corner, along_face(corner), least));
    }
    nodes.push_back(next);
  }
  // T of the neighbouring node `other`; kNone if this node is on another branch over the profile.
  const auto te = [&](std::size_t i, std::size_t other) {
    if (other >= nodes.size() || nodes[other].outside) return kNone;
    const bool same = !steep_ || std::abs(nodes[other].aside - nodes[i].aside) < branch_;
    return same ? nodes[other].te : kNone;
  };
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& here = nodes[i];
    const double below = te(i, i - 1);
    const double above = te(i, i + 1);
    if (here.outside || here.te < below || here.te <= above) continue;
    Crest crest{here.te, here.s, here.z};
    if (below > kNone && above > kNone) {
      // The parabola through three nodes.
      const double before = nodes[i - 1].z - here.z;
      const double after = nodes[i + 1].z - here.z;
      const double chord_below = (below - here.te) / before;
      const double chord_above = (above - here.te) / after;
      const double bend = (chord_above - chord_below) / (after - before);
      const double slope = chord_below - bend * before;
      if (bend < 0.0) {
        const double d = std::clamp(-0.5 * slope / bend, before, after);
        const Node& other = nodes[d < 0.0 ? i - 1 : i + 1];
        crest.te += (slope + bend * d) * d;
        crest.z += d;
        crest.s += (other.s - here.s) * d / (other.z - here.z);
      }
    }
    crests.push_back(crest);
  }
  return crests;
}

}  // namespace gearwright::detail
