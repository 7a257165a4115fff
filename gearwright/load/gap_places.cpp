#include "gearwright/load/gap_places.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gearwright {

namespace {

using End = FlankPatch::End;

constexpr int kRows = 17;  // along the flank
constexpr int kMostSteps = 60;
constexpr double kSlope = 1e-15;      // rad per unit of s, for a maximum within rounding
constexpr double kFarFromMesh = 0.6;  // rad: farther points of gear 1 do not meet a flank

bool inside(const FlankPatch& b, const GapJet& j) {
  return j.u.v >= b.u_lo && j.u.v <= b.u_hi && j.Z.v >= b.z_lo && j.Z.v <= b.z_hi;
}

// Greatest principal curvature of the gap. [T8.15]
double curvature(const GapJet& j) {
  const double ss = std::norm(j.w1_s);
  const double sz = (std::conj(j.w1_s) * j.w1_z).real();
  const double zz = std::norm(j.w1_z) + 1.0;
  const double area = ss * zz - sz * sz;
  const double arm = GapField::arm(j);
  const double a = -arm * j.t.ss;
  const double b = -arm * j.t.sz;
  const double c = -arm * j.t.zz;
  const double mean = 0.5 * (a * zz - 2 * b * sz + c * ss) / area;
  const double product = (a * c - b * b) / area;
  return mean + std::sqrt(std::max(0.0, mean * mean - product));
}

TouchKind edge_of_two(const FlankPatch& b, const GapJet& j) {
  const bool high = j.u.v > 0.5 * (b.u_lo + b.u_hi);
  const End end = high == b.profile.grows() ? b.s_hi_end : b.s_lo_end;
  return end == End::tip ? TouchKind::tip2 : end == End::form ? TouchKind::form2 : TouchKind::line;
}

TouchKind edge_of_one(End end) {
  return end == End::tip ? TouchKind::tip1 : end == End::form ? TouchKind::form1 : TouchKind::line;
}

}  // namespace

GapSearch::GapSearch(const ContactPair& pair) : pair_(pair) {
  double widest = 0.0;
  for (const FlankPatch& a : pair.patches(1)) {
    widest = std::max(widest, std::abs(a.twist) * std::max(std::abs(a.z_lo), std::abs(a.z_hi)));
    for (const FlankPatch& b : pair.patches(2))
      fields_.emplace_back(a, b, pair.mount(), pair.ratio(), pair.rotation_sign());
  }
  farthest_pair_ = static_cast<int>(std::ceil((pair.reach() + widest) / pair.pitch())) + 1;
}

std::optional<GapPlace> GapSearch::nearest(const GapField& field, double z) const {
  const FlankPatch& a = field.one();
  const FlankPatch& b = field.two();
  if (z < a.z_lo || z > a.z_hi) return std::nullopt;
  double s2 = 0.5 * (b.s_lo + b.s_hi);
  const auto at = [&](double s) { return field.at(s, z, s2); };
  const auto row = [&](int i) { return a.s_lo + (a.s_hi - a.s_lo) * i / (kRows - 1); };
  std::array<bool, kRows> in{};
  int best = -1;
  double highest = 0.0;
  for (int i = 0; i < kRows; ++i) {
    const GapJet j = at(row(i));
    const double from_mesh = std::arg(j.w1) - pair_.mesh_azimuth();
    in[i] =
        inside(b, j) && std::abs(std::remainder(from_mesh, 2 * std::numbers::pi)) < kFarFromMesh;
    if (in[i] && (best < 0 || j.t.v > highest)) {
      best = i;
      highest = j.t.v;
    }
  }
  if (best < 0) return std::nullopt;
  // The ends of the interior range on both sides of the best row.
  const auto end = [&](int step) {
    const int next = best + step;
    if (next < 0 || next >= kRows) return row(best);
    if (in[next]) return row(next);
    double good = row(best);
    double bad = row(next);
    for (int i = 0; i < kMostSteps; ++i) {
      const double mid = 0.5 * (good + bad);
      if (mid == good || mid == bad) break;
      (inside(b, at(mid)) ? good : bad) = mid;
    }
    return good;
  };
  const double lo = end(-1);
  const double hi = end(1);
  GapPlace place;
  double s = row(best);
  GapJet j = at(lo);
  if (j.t.s <= 0.0) {
    s = lo;
    place.kind = lo == a.s_lo ? edge_of_one(a.s_lo_end) : edge_of_two(b, j);
  } else if (j = at(hi); j.t.s >= 0.0) {
    s = hi;
    place.kind = hi == a.s_hi ? edge_of_one(a.s_hi_end) : edge_of_two(b, j);
  } else {
    double below = lo;
    double above = hi;
    s = std::clamp(s, below, above);
    for (int i = 0; i < kMostSteps; ++i) {
      j = at(s);
      if (std::abs(j.t.s) < kSlope) break;
      (j.t.s > 0.0 ? below : above) = s;
      double next = j.t.ss < 0.0 ? s - j.t.s / j.t.ss : below - 1.0;
      if (!(next > below && next < above)) next = 0.5 * (below + above);
      if (next == s || above - below < 1e-13 * (hi - lo)) break;
      s = next;
    }
  }
  place.te = j.t.v;
  place.arm = GapField::arm(j);
  place.radius = {std::abs(j.w1), std::exp(j.u.v)};
  place.curvature = curvature(j);
  return place;
}

std::vector<PairPlaces> GapSearch::places(double rotation, const std::vector<double>& heights) {
  std::vector<PairPlaces> found;
  for (int k = farthest_pair_; k >= -farthest_pair_; --k) {
    PairPlaces p{k, rotation - k * pair_.pitch(), {}};
    p.at.resize(heights.size());
    bool any = false;
    for (GapField& field : fields_) {
      field.set_rotation(p.turn);
      for (std::size_t i = 0; i < heights.size(); ++i) {
        auto place = nearest(field, heights[i]);
        if (!place || (p.at[i] && p.at[i]->te >= place->te)) continue;
        p.at[i] = place;
        any = true;
      }
    }
    if (any) found.push_back(std::move(p));
  }
  return found;
}

}  // namespace gearwright
