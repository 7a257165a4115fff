#include "gearwright/contact/transmission.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/contact/wave_crests.hpp"

namespace gearwright {

namespace {

// True if three conditions hold: the patches together form one flank, the borders between the
// patches are kinks of the modifications, and no part of the flank is concave. A relief of an
// involute removes material beyond its kink, so the flank is convex at the kink, too.
bool is_convex(const std::vector<FlankPatch>& flank) {
  const RemovalField* removal = flank.front().removal;
  if (flank.size() != (removal ? removal->pieces().size() : 1)) return false;
  if (flank.size() > 1 && !flank.front().profile.involute()) return false;
  if (!removal || removal->none()) return true;
  if (removal->has_topography() || removal->wavy()) return false;
  using P = Modification;
  return removal->amount(P::profile_crowning) >= 0.0 && removal->amount(P::lead_crowning) >= 0.0;
}

// True for an internal pair on crossed axes, whose flanks overlap beside the line of action
// [T4.35]. The gap field T then has a maximum at an edge on each side of the line.
bool is_saddle(const ContactPair& pair) {
  return pair.side() < 0.0 && pair.place().axis_angle != Angle();
}

// True if the teeth of a ring extend beyond the point at which the line of action touches the base
// circle of the pinion. Beyond this point, the curvature of the concave flank of the ring exceeds
// that of the flank of the pinion. T then has another maximum at the tip of the ring's teeth.
bool reaches_beyond_action(const ContactPair& pair) {
  const Involute* one = pair.patches(1).front().profile.involute();
  const Involute* two = pair.patches(2).front().profile.involute();
  if (pair.side() > 0.0 || !one || !two) return false;
  double tip = kInfinity;
  for (const FlankPatch& p : pair.patches(2)) tip = std::min(tip, std::exp(p.u_lo));
  const double a = pair.place().center_distance + pair.place().errors.center_distance;
  const double r_b2 = two->base_radius(), between = r_b2 - one->base_radius();
  // The line of action touches the base circle of the pinion at the distance √(r_b2² + (a sin
  // α_w)²) from axis 2. Here, a sin α_w is the length of the line of action between the base
  // circles.
  return tip * tip < r_b2 * r_b2 + a * a - between * between;
}

// Returns the number of the patch beyond an end of p, or −1 if there is none. Ends 0 and 1 are the
// lower and the upper end of the range of u (if `of_u` is true) or of s (if `of_u` is false). Ends
// 2 and 3 are the lower and the upper end of the range of z.
int patch_across(const std::vector<FlankPatch>& flank, const FlankPatch& p, int end, bool of_u) {
  const bool lower = (end % 2 == 0) == (end >= 2 || of_u || p.profile.grows());
  const auto is_next = [&](const FlankPatch& o) {
    if (end >= 2) return o.u_lo == p.u_lo && (lower ? o.z_hi == p.z_lo : o.z_lo == p.z_hi);
    return o.z_lo == p.z_lo && (lower ? o.u_hi == p.u_lo : o.u_lo == p.u_hi);
  };
  const auto next = std::find_if(flank.begin(), flank.end(), is_next);
  return next == flank.end() ? -1 : static_cast<int>(next - flank.begin());
}

// Returns the greatest angle from the mesh azimuth, rad, at which points of patch `one` can lie in
// the annulus of patch `two`. [T8.13]
double reach_of(const ContactPair& pair, const FlankPatch& one, const FlankPatch& two) {
  if (pair.place().axis_angle != Angle()) return pair.reach();
  const double a = pair.place().center_distance + pair.place().errors.center_distance;
  const double lo = std::exp(one.u_lo);
  const double hi = std::exp(one.u_hi);
  double least = 1.0;
  const auto take = [&](double rho1) {
    const double rho2 = std::exp(pair.side() < 0.0 ? two.u_lo : two.u_hi);
    const double cosine = pair.is_rack() ? (a - pair.diameter(2, two.u_hi)) / rho1
                                         : (a * a + rho1 * rho1 - rho2 * rho2) / (2 * a * rho1);
    least = std::min(least, pair.side() * cosine);
  };
  if (!(a > 0.0)) return pair.reach();
  take(lo);
  take(hi);
  const double rho2 = std::exp(two.u_hi);
  const double flattest = !pair.is_rack() && a > rho2 ? std::sqrt(a * a - rho2 * rho2) : 0.0;
  if (pair.side() > 0.0 && flattest > lo && flattest < hi) take(flattest);
  return std::acos(std::max(-1.0, least));
}

}  // namespace

bool detail::wins(const Touch& t, double phi, const PairTouch& best) {
  if (!best.found()) return true;
  const double ahead = t.te - best.touch.te;
  if (std::abs(ahead) > kTogether) return ahead > 0.0;
  return std::abs(phi) < std::abs(best.phi);
}

Transmission::Transmission(const ContactPair& pair, Progress* progress)
    : pair_(pair), progress_(progress) {
  double widest = 0.0;
  for (const FlankPatch& a : pair.patches(1)) {
    widest = std::max(widest, std::abs(a.twist) * std::max(std::abs(a.z_lo), std::abs(a.z_hi)));
    for (const FlankPatch& b : pair.patches(2)) {
      fields_.push_back(std::make_unique<GapField>(pair.field(a, b)));
      searches_.push_back(std::make_unique<TouchSearch>(*fields_.back(), pair.mesh_azimuth(),
                                                        reach_of(pair, a, b)));
    }
  }
  for (const FlankPatch& a : pair.patches(1)) {
    for (const FlankPatch& b : pair.patches(2)) {
      auto crests = detail::WaveCrests::of(pair, a, b);
      if (crests) crests_.push_back(std::make_shared<const detail::WaveCrests>(*std::move(crests)));
    }
  }
  if (crests_.size() < fields_.size()) crests_.clear();
  const auto &ones = pair.patches(1), &twos = pair.patches(2);
  convex_ = is_convex(ones) && is_convex(twos) && !is_saddle(pair) && !reaches_beyond_action(pair);
  const int n_2 = static_cast<int>(twos.size());
  for (int f = 0; convex_ && f < static_cast<int>(fields_.size()); ++f) {
    auto& across = across_.emplace_back();
    const int i = f / n_2, j = f % n_2;
    for (int end = 0; end < 4; ++end) {
      const int one = patch_across(ones, ones[static_cast<std::size_t>(i)], end, false);
      const int two = patch_across(twos, twos[static_cast<std::size_t>(j)], end, true);
      across[static_cast<std::size_t>(end)] = one < 0 ? -1 : one * n_2 + j;
      across[static_cast<std::size_t>(end) + 4] = two < 0 ? -1 : i * n_2 + two;
    }
  }
  farthest_pair_ = static_cast<int>(std::ceil((pair.reach() + widest) / pair.pitch())) + 2;
}

Touch Transmission::cold(int fields, double phi) {
  fields_[fields]->set_rotation(phi);
  const Touch t = searches_[fields]->cold();
  if (t.stop == Touch::Stop::too_long) ++too_long_;
  return t;
}

// Searches from a crest. If the search does not converge, the whole flank is searched.
Touch Transmission::from_crest(int fields, double s, double z) {
  const auto f = static_cast<std::size_t>(fields);
  const Touch t = searches_[f]->from(s, z, crests_[f]->s2(), {});
  return t.stop == Touch::Stop::too_long ? searches_[f]->cold() : t;
}

Touch Transmission::highest_crest(int fields, double phi) {
  const auto f = static_cast<std::size_t>(fields);
  auto crests = crests_[f]->at(phi, -kInfinity);
  std::sort(crests.begin(), crests.end(), [](const auto& a, const auto& b) { return a.te > b.te; });
  fields_[f]->set_rotation(phi);
  Touch best;
  for (const auto& c : crests) {
    if (best.found() && c.te < best.te - crests_[f]->margin()) break;
    const Touch t = from_crest(fields, c.s, c.z);
    if (t.found() && (!best.found() || t.te > best.te)) best = t;
  }
  return best;
}

PairTouch Transmission::at(double phi) {
  // A shift by whole pitches changes only the number of the tooth pair.
  const double whole = std::round(phi / pair_.pitch());
  phi -= whole * pair_.pitch();
  count_step(progress_);
  PairTouch best;
  // WaveCrests finds no crests far beyond the path of contact. A pair beyond its path may still
  // touch. If no tooth pair has a crest, the whole flanks are therefore searched.
  for (const bool of_crests : {true, false}) {
    if (of_crests && crests_.empty()) continue;
    if (best.found()) break;
    for (int f = 0; f < static_cast<int>(fields_.size()); ++f) {
      for (int k = -farthest_pair_; k <= farthest_pair_; ++k) {
        const double own = phi - k * pair_.pitch();
        const Touch t = of_crests ? highest_crest(f, own) : cold(f, own);
        if (t.found() && detail::wins(t, own, best)) best = {t, f, own, k};
      }
    }
  }
  best.pair += static_cast<int>(whole);
  return best;
}

PairTouch Transmission::of_pair_0(double phi) {
  PairTouch best;
  for (int f = 0; f < static_cast<int>(fields_.size()); ++f) {
    const Touch t = wavy() ? highest_crest(f, phi) : cold(f, phi);
    if (t.found() && detail::wins(t, phi, best)) best = {t, f, phi, 0};
  }
  return best;
}

PairTouch Transmission::follow(const PairTouch& from, double phi) {
  GW_EXPECTS(from.found());
  fields_[static_cast<std::size_t>(from.fields)]->set_rotation(phi);
  const Touch t =
      search(from.fields).from(from.touch.s, from.touch.z, from.touch.s2, from.touch.active);
  return {t, t.found() ? from.fields : -1, phi, from.pair};
}

PairTouch Transmission::follow_pair(const PairTouch& from, double phi) {
  PairTouch t = follow(from, phi);
  if (!crosses_patches()) return t;
  PairTouch start = from;
  start.touch.active = {};
  for (int f = 0; f < static_cast<int>(fields_.size()) && !t.found(); ++f) {
    start.fields = f;
    t = follow(start, phi);
  }
  return t.found() ? climb(t, phi) : t;
}

std::vector<PairTouch> Transmission::every_of_pair_0(double phi) {
  std::vector<PairTouch> all;
  for (std::size_t f = 0; f < fields_.size(); ++f) {
    fields_[f]->set_rotation(phi);
    for (const Touch& t : searches_[f]->every_maximum())
      if (t.found()) all.push_back({t, static_cast<int>(f), phi, 0});
  }
  return all;
}

// For every position, searches from each crest that may be the highest. The crests of all tooth
// pairs are estimated first, beginning near the centre line, where teeth usually touch.
void Transmission::over_crests(double first, int n, std::vector<PairTouch>& best) {
  struct Start {
    detail::WaveCrests::Crest crest;
    int fields, m;
  };
  const auto size = static_cast<std::size_t>(n);
  std::vector<std::vector<Start>> starts(size);
  std::vector<double> highest(size, -kInfinity);
  const int most = farthest_pair_ * n;
  for (int away = 0; away <= most; ++away) {
    for (const int m : {away, -away}) {
      if (m == 0 && away != 0) continue;
      const auto i = static_cast<std::size_t>(((m % n) + n) % n);
      const double own = first + m * (pair_.pitch() / n);
      for (int f = 0; f < static_cast<int>(crests_.size()); ++f) {
        const detail::WaveCrests& crests = *crests_[static_cast<std::size_t>(f)];
        for (const auto& c : crests.at(own, highest[i] - crests.margin())) {
          starts[i].push_back({c, f, m});
          highest[i] = std::max(highest[i], c.te);
        }
      }
      if (away == 0) break;
    }
  }
  for (std::size_t i = 0; i < size; ++i) {
    count_step(progress_);
    std::sort(starts[i].begin(), starts[i].end(),
              [](const Start& a, const Start& b) { return a.crest.te > b.crest.te; });
    for (const Start& s : starts[i]) {
      const auto f = static_cast<std::size_t>(s.fields);
      if (best[i].found() && s.crest.te < best[i].te() - crests_[f]->margin()) break;
      const double own = first + s.m * (pair_.pitch() / n);
      fields_[f]->set_rotation(own);
      const Touch t = from_crest(s.fields, s.crest.s, s.crest.z);
      if (t.found() && detail::wins(t, own, best[i]))
        best[i] = {t, s.fields, own, (static_cast<int>(i) - s.m) / n};
    }
    // Far beyond the path of contact, WaveCrests overestimates T. An overestimated crest may have
    // excluded the crest that is actually the highest. at() then searches the position once more.
    const bool astray = !best[i].found() || best[i].te() < highest[i] - crests_[0]->margin();
    if (astray) best[i] = at(first + static_cast<double>(i) * (pair_.pitch() / n));
  }
}

std::vector<PairTouch> Transmission::over_a_pitch(double first, int n) {
  const double whole = std::round(first / pair_.pitch());
  first -= whole * pair_.pitch();
  std::vector<PairTouch> best(n);
  if (!crests_.empty())
    over_crests(first, n, best);
  else if (convex_)
    follow_one(first, n, best);
  else
    for (int f = 0; f < static_cast<int>(fields_.size()); ++f) follow_all(f, first, n, best);
  for (PairTouch& t : best) t.pair += static_cast<int>(whole);
  return best;
}

GapJet Transmission::jet_at(const PairTouch& t, double s, double z) {
  GapField& field = *fields_[t.fields];
  field.set_rotation(t.phi);
  double s2 = t.touch.s2;
  const GapJet rough = field.at(s, z, s2);
  // The second evaluation starts with the exact parameter on flank 2.
  s2 = field.two().profile.s_of(rough.u.v, s2);
  return field.at(s, z, s2);
}

TouchCount Transmission::count() const {
  TouchCount sum;
  for (const auto& s : searches_) {
    sum.evaluations += s->count().evaluations;
    sum.searches += s->count().searches;
    sum.cold_starts += s->count().cold_starts;
  }
  return sum;
}

}  // namespace gearwright
