#include "gearwright/load/gap_places.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gearwright/math/root.hpp"

namespace gearwright {

namespace {

using End = FlankPatch::End;

// Rounding error of the position of a place, relative to the length of the flank.
constexpr double kBorderRounding = 1e-15;
// Two patches count as having the same gap if T differs by less than this value, rad.
constexpr double kSameGap = 1e-13;
// If the angle between a point of flank 1 and the line of centres is greater than this value, rad,
// the point does not face a flank of gear 2.
constexpr double kFarFromMesh = 0.6;

double row_of(const FlankPatch& a, int i) {
  return a.s_lo + (a.s_hi - a.s_lo) * i / (GapSearch::kRows - 1);
}

bool inside(const FlankPatch& b, const GapJet& j) {
  return j.u.v >= b.u_lo && j.u.v <= b.u_hi && j.Z.v >= b.z_lo && j.Z.v <= b.z_hi;
}

// Returns the greatest principal curvature of the gap. [T8.15]
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

// True if the gap at `a` is less than the gap at `b`. At the start of a relief, two patches meet
// and have the same gap up to rounding. The edge between the patches is sharper than each of them,
// so the place with the greater curvature is used.
bool nearer(const GapPlace& a, const GapPlace& b) {
  if (std::abs(a.te - b.te) > kSameGap) return a.te > b.te;
  return a.curvature > b.curvature;
}

TouchKind edge_of_two(const FlankPatch& b, const GapJet& j) {
  const bool high = j.u.v > 0.5 * (b.u_lo + b.u_hi);
  const End end = high == b.profile.grows() ? b.s_hi_end : b.s_lo_end;
  return end == End::tip ? TouchKind::tip2 : end == End::form ? TouchKind::form2 : TouchKind::line;
}

TouchKind edge_of_one(End end) {
  return end == End::tip ? TouchKind::tip1 : end == End::form ? TouchKind::form1 : TouchKind::line;
}

// The signed distance, in u or z, of a point of flank 1 from the nearest border of the patch
// `b` of flank 2, and the derivative of this distance with respect to s. The distance is ≥ 0 if
// the point lies opposite the patch.
struct Margin {
  double v, s;
};
Margin margin(const FlankPatch& b, const GapJet& j) {
  const std::array borders{Margin{j.u.v - b.u_lo, j.u.s}, Margin{b.u_hi - j.u.v, -j.u.s},
                           Margin{j.Z.v - b.z_lo, j.Z.s}, Margin{b.z_hi - j.Z.v, -j.Z.s}};
  return *std::min_element(borders.begin(), borders.end(),
                           [](const Margin& x, const Margin& y) { return x.v < y.v; });
}

// Returns the last s between `good` and `bad`, within rounding, at which the point of flank 1 lies
// opposite the patch `b` of flank 2. The point at s = `good` lies opposite this patch, and the
// point at s = `bad` does not.
template <class At>
double last_inside(const FlankPatch& b, const At& at, double good, double bad, double rounding) {
  const double border = newton_in_bracket<double>(
                            [&](double s) {
                              const Margin m = margin(b, at(s));
                              return Slope<double>{m.v, m.s};
                            },
                            std::min(good, bad), std::max(good, bad), bad, bad < good)
                            .x;
  double s = border;
  for (double back = rounding; !inside(b, at(s)); back *= 2) {
    if (back >= std::abs(good - border)) return good;
    s = border + std::copysign(back, good - border);
  }
  return s;
}

}  // namespace

GapSearch::GapSearch(const ContactPair& pair, std::vector<double> heights)
    : pair_(pair), heights_(std::move(heights)) {
  double widest = 0.0;
  for (const FlankPatch& a : pair.patches(1)) {
    widest = std::max(widest, std::abs(a.twist) * std::max(std::abs(a.z_lo), std::abs(a.z_hi)));
    std::array<double, kRows> forward;
    for (int i = 0; i < kRows; ++i)
      forward[i] = std::cos(kFarFromMesh) * std::abs(a.profile.at(row_of(a, i)).factor);
    std::vector<Rows> rows;
    for (const FlankPatch& b : pair.patches(2)) {
      GapField field = pair.field(a, b);
      if (rows.empty()) {
        for (const double z : heights_) {
          Rows& at = rows.emplace_back();
          for (int i = 0; i < kRows; ++i) at[i] = field.point_at_rest(row_of(a, i), z);
        }
      }
      patches_.push_back({field, std::exp(2 * b.u_lo), std::exp(2 * b.u_hi), forward, rows});
    }
  }
  farthest_pair_ = static_cast<int>(std::ceil((pair.reach() + widest) / pair.pitch())) + 1;
}

std::optional<GapPlace> GapSearch::nearest(const Patches& patches, std::size_t height) const {
  const GapField& field = patches.field;
  const FlankPatch& a = field.one();
  const FlankPatch& b = field.two();
  const double z = heights_[height];
  if (z < a.z_lo || z > a.z_hi) return std::nullopt;
  double s2 = 0.5 * (b.s_lo + b.s_hi);
  const auto at = [&](double s) { return field.at(s, z, s2); };
  const auto row = [&](int i) { return row_of(a, i); };
  const Complex mesh = std::polar(1.0, -pair_.mesh_azimuth());
  std::array<bool, kRows> in{};
  int best = -1;
  double highest = 0.0;
  for (int i = 0; i < kRows; ++i) {
    const Complex w1 = field.rotated(patches.rows[height][i]);
    if (!(times(w1, mesh).real() > patches.least_forward[i])) continue;
    const GapField::Place2 place = field.on_gear_2(w1, z);
    const double square = std::norm(place.w);
    in[i] = square >= patches.least_square && square <= patches.most_square && place.Z >= b.z_lo &&
            place.Z <= b.z_hi;
    if (!in[i]) continue;
    const double te = field.value(place, s2);
    if (best >= 0 && !(te > highest)) continue;
    best = i;
    highest = te;
  }
  if (best < 0) return std::nullopt;
  // If T increases from the best row towards a neighbouring row, the least gap lies between these
  // two rows, or at the border of flank 2 if the border is nearer. If T increases beyond the first
  // or the last row, the least gap lies at this end of flank 1.
  const double s = row(best);
  GapJet j = at(s);
  double reached = s;
  GapPlace place;
  if (const double slope = j.t.s; slope != 0.0) {
    const int next = best + (slope > 0.0 ? 1 : -1);
    double end = s;
    if (next >= 0 && next < kRows) {
      end = row(next);
      if (!in[next]) end = last_inside(b, at, s, end, kBorderRounding * (a.s_hi - a.s_lo));
    }
    const GapJet last = at(end);
    if (last.t.s * slope >= 0.0) {
      j = last;
      reached = end;
      place.kind = end == a.s_lo   ? edge_of_one(a.s_lo_end)
                   : end == a.s_hi ? edge_of_one(a.s_hi_end)
                                   : edge_of_two(b, j);
    } else {
      const auto slope_at = [&](double x) {
        j = at(x);
        reached = x;
        return Slope<double>{j.t.s, j.t.ss};
      };
      const double lo = std::min(s, end), hi = std::max(s, end);
      const double start = std::clamp(s - slope / j.t.ss, lo, hi);
      newton_in_bracket<double>(slope_at, lo, hi, start, false);
    }
  }
  place.s = reached;
  place.te = j.t.v;
  place.arm = GapField::arm(j);
  place.radius = {std::abs(j.w1), std::exp(j.u.v)};
  place.curvature = curvature(j);
  return place;
}

std::vector<PairPlaces> GapSearch::places(double rotation) {
  std::vector<PairPlaces> found;
  for (int k = farthest_pair_; k >= -farthest_pair_; --k) {
    PairPlaces p{k, rotation - k * pair_.pitch(), {}};
    p.at.resize(heights_.size());
    bool any = false;
    for (std::size_t n = 0; n < patches_.size(); ++n) {
      patches_[n].field.set_rotation(p.turn);
      for (std::size_t i = 0; i < heights_.size(); ++i) {
        auto place = nearest(patches_[n], i);
        if (!place || (p.at[i] && !nearer(*place, *p.at[i]))) continue;
        place->patches = n;
        p.at[i] = place;
        any = true;
      }
    }
    if (any) found.push_back(std::move(p));
  }
  return found;
}

double GapSearch::slope(const PairPlaces& pair, std::size_t height, const Influence& influence) {
  const GapPlace& place = pair.at[height].value();
  GapField& field = patches_[place.patches].field;
  field.set_rotation(pair.turn);
  return row_slope(pair_, field, place.s, heights_[height], influence);
}

RemovalTurn GapSearch::turn(const PairPlaces& pair, std::size_t height, int gear) {
  const GapPlace& place = pair.at[height].value();
  GapField& field = patches_[place.patches].field;
  field.set_rotation(pair.turn);
  return row_turn(pair_, field, place.s, heights_[height], gear);
}

}  // namespace gearwright
