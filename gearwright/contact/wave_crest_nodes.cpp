// Computes the crests of form waves at one rotation. The greatest value of the gap field T over the
// profile is computed at several heights z. A crest is a local maximum of these values over z.
#include "gearwright/contact/wave_crests.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gearwright::detail {

namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();
constexpr int kAcross = 5;  // points examined on a profile over which T may have several maxima

// A wave over the profile, as a complex number `at` whose phase advances from point to point. At
// each step, `at` is multiplied by `turn`, and `turn` is multiplied by `faster`. The imaginary part
// of `at` is the value of the wave.
struct Phasor {
  Complex at{}, turn{}, faster{};
};

// The wave of a flank at L, for the amplitude 1.
Complex unit_of(const FlankPatch& f, double rate, double L) {
  const auto w = f.removal->profile_wave(L);
  const double height = 0.5 * f.removal->waves()[0].height;
  return {w.d1 / (rate * height), w.c / height};
}

Complex turn_by(double angle) { return {std::cos(angle), std::sin(angle)}; }
// Computes turn_by() to second order in the angle.
Complex turn_by_little(double angle) { return {1.0 - 0.5 * angle * angle, angle}; }

}  // namespace

WaveCrests::Node WaveCrests::node(double phi, double z, double along_face, double least) const {
  const double y = (z - z_mid_) / z_half_;
  const auto turn = phi_.along_x(y);
  double x = (phi - turn.c[0]) / turn.c[1];
  for (int i = 0; i < 2; ++i) x -= (turn.at(x) - phi) / (turn.c[1] + 2 * turn.c[2] * x);
  const double ridge = s_mid_ + x * s_half_;
  const double roll2 = roll2_.along_x(y).at(x);
  const double roll2_s = roll2_s_.along_x(y).at(x);
  const double roll2_ss = roll2_ss_.along_x(y).at(x);
  // The points of flank 1 that lie opposite the ends of flank 2. A parabola in s approximates L of
  // the opposite point of flank 2. If the parabola does not reach an end, the result is a point
  // beyond the vertex of the parabola. This point is twice as far from the ridge as the point at
  // which the tangent at the ridge reaches the end.
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
  // The slope of T is approximately the product of the curvature of T at the ridge and the distance
  // from the ridge.
  const auto bends = bend_.along_x(y);
  const double bend = bends.at(x);
  const double bend_s = (bends.c[1] + 2 * bends.c[2] * x) / s_half_;
  const double top = te_.along_x(y).at(x) - along_face;
  const auto smooth = [&](double d) { return top + (0.5 * bend + bend_s * d / 3) * d * d; };
  const double start = std::clamp(ridge, lo, hi);
  if (smooth(start - ridge) + across_ < least) return n;
  n.outside = false;
  const double reach = steep_ ? 2 * std::sqrt(across_ / -bend) : 0.0;
  const double first = std::max(lo, start - reach);
  const double step = (std::min(hi, start + reach) - first) / (kAcross - 1);
  const int places = step > 0.0 ? kAcross : 1;
  // At equal steps of s, the phase of the wave of flank 1 advances by a constant angle, and the
  // phase of the wave of flank 2 advances by an angle that grows linearly.
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
    // A node is added where the ridge leaves D (touch.hpp), because the ridge has a kink there.
    if (!nodes.empty() && (nodes.back().inside > 0.0) != (next.inside > 0.0)) {
      const Node& last = nodes.back();
      const double part = last.inside / (last.inside - next.inside);
      const double corner = last.z + part * (next.z - last.z);
      nodes.push_back(node(phi, corner, along_face(corner), least));
    }
    nodes.push_back(next);
  }
  // Returns T of the neighbouring node `other`, or kNone if this node is on another branch.
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
