#include "gearwright/contact/pattern.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/lists.hpp"
#include "gearwright/base/numbers.hpp"

namespace gearwright {

namespace {

FlankRaster empty_raster(const ContactPair& pair, int gear, const RasterSize& size) {
  double u_lo = kInfinity;
  double u_hi = -kInfinity;
  double z_lo = kInfinity;
  double z_hi = -kInfinity;
  for (const FlankPatch& p : pair.patches(gear)) {
    u_lo = std::min(u_lo, p.u_lo);
    u_hi = std::max(u_hi, p.u_hi);
    z_lo = std::min(z_lo, p.z_lo);
    z_hi = std::max(z_hi, p.z_hi);
  }
  FlankRaster r;
  r.diameter = evenly_spaced(pair.diameter(gear, u_lo), pair.diameter(gear, u_hi), size.rows);
  r.height = evenly_spaced(z_lo, z_hi, size.columns);
  r.gap.assign(r.diameter.size() * r.height.size(), kInfinity);
  return r;
}

// Returns the index of the first patch that contains the point (u, z), or −1 if the point lies
// beyond the flank.
int patch_at(const std::vector<FlankPatch>& patches, double u, double z) {
  // Borders of neighbours are equal within rounding, for u = ln ρ and for z in mm.
  constexpr double kSlack = 1e-9;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const FlankPatch& p = patches[i];
    if (u >= p.u_lo - kSlack && u <= p.u_hi + kSlack && z >= p.z_lo - kSlack &&
        z <= p.z_hi + kSlack)
      return static_cast<int>(i);
  }
  return -1;
}

// A node of the raster on flank 1, in the frame N.
struct Node {
  int patch;
  double s, u, z;
  double azimuth;  // at rotation 0, not reduced to one turn
};
// The gap at a node, with a number that identifies the patches of flank 1 and flank 2.
struct Gap {
  double value = kInfinity;
  int pieces = -1;
  bool operator<(const Gap& other) const { return value < other.value; }
};
struct Seen {
  double u = 0.0, Z = 0.0;  // position on gear 2, on its flank or beyond
  Gap gap;                  // finite if the position is on the flank
  bool near = false;        // true if u and Z were computed
};

// Two or three Newton steps are usual. One more step is needed if the point lies on the next patch.
constexpr int kMaxPlaceSteps = 8;
constexpr double kNearPatch = 1e-4;  // the series is valid for steps below this part of the patch

class Rasterer {
 public:
  Rasterer(const ContactPair& pair, const RasterSize& size)
      : pair_(pair), rasters_{empty_raster(pair, 1, size), empty_raster(pair, 2, size)} {
    const FlankRaster& r = rasters_[0];
    for (const double d : r.diameter)
      for (const double z : r.height) nodes_.push_back(node_at(pair.u_at(1, d), z));
    for (const FlankPatch& a : pair.patches(1))
      for (const FlankPatch& b : pair.patches(2)) fields_.push_back(pair.field(a, b));
    seen_.resize(nodes_.size());
    for (std::size_t which = 0; which < 2; ++which) {
      for (auto* gaps : {&now_, &last_, &before_})
        (*gaps)[which].assign(rasters_[which].gap.size(), Gap{});
    }
  }

  // Adds the gaps of tooth pair 0 at the rotation φ in the frame N, with the transmission error
  // `te`. Rotations must increase from call to call.
  void add(double phi, double te) {
    te_ = te;
    for (GapField& f : fields_) f.set_rotation(phi);
    constexpr double kSlack = 0.05;  // margin for errors of mounting and modifications, rad
    bool any = false;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const double off = nodes_[i].azimuth + pair_.rotation_sign() * phi - pair_.mesh_azimuth();
      seen_[i] = std::abs(off) > pair_.reach() + kSlack ? Seen{} : look(nodes_[i]);
      now_[0][i] = seen_[i].gap;
      any = any || seen_[i].near;
    }
    std::fill(now_[1].begin(), now_[1].end(), Gap{});
    if (any) fill_second();
    for (std::size_t which = 0; which < 2; ++which) fold(which);
  }

  // Ends a sequence of positions. The next position begins a new sequence.
  void close() {
    for (std::size_t which = 0; which < 2; ++which) {
      std::fill(now_[which].begin(), now_[which].end(), Gap{});
      fold(which);
      fold(which);
    }
  }

  // Returns the rasters in the frames of the gears, with rows and columns in ascending order.
  std::array<FlankRaster, 2> take() {
    for (FlankRaster& r : rasters_) {
      if (pair_.turned() > 0.0) continue;
      std::reverse(r.height.begin(), r.height.end());
      for (double& z : r.height) z = -z;
      for (std::size_t i = 0; i < r.diameter.size(); ++i)
        std::reverse(r.gap.begin() + static_cast<std::ptrdiff_t>(i * r.height.size()),
                     r.gap.begin() + static_cast<std::ptrdiff_t>((i + 1) * r.height.size()));
    }
    return rasters_;
  }

 private:
  Node node_at(double u, double z) const {
    const auto& ones = pair_.patches(1);
    Node node{patch_at(ones, u, z), 0.0, u, z, 0.0};
    if (node.patch < 0) return node;
    const FlankPatch& patch = ones[static_cast<std::size_t>(node.patch)];
    node.s = patch.profile.s_of(u);
    const PolarJet p = patch.profile.at(node.s);
    node.azimuth = std::arg(p.factor) + p.phase + patch.center + z * patch.twist;
    return node;
  }

  int pieces(int one, int two) const {
    return one * static_cast<int>(pair_.patches(2).size()) + two;
  }

  GapJet jet(int one, int two, double s, double z) const {
    const FlankPatch& b = pair_.patches(2)[static_cast<std::size_t>(two)];
    double s2 = 0.5 * (b.s_lo + b.s_hi);
    return fields_[static_cast<std::size_t>(pieces(one, two))].at(s, z, s2);
  }

  Gap gap_of(const GapJet& j, double t, int pieces) const {
    return {std::max(0.0, (te_ - t) * GapField::arm(j)), pieces};
  }

  Seen look(const Node& node) const {
    Seen seen;
    if (node.patch < 0) return seen;
    // The position (u, Z) relative to gear 2 does not depend on the patch of flank 2, so it is
    // computed with the first patch.
    GapJet j = jet(node.patch, 0, node.s, node.z);
    seen.near = true;
    seen.u = j.u.v;
    seen.Z = j.Z.v;
    const int two = patch_at(pair_.patches(2), j.u.v, j.Z.v);
    if (two < 0) return seen;
    if (two > 0) j = jet(node.patch, two, node.s, node.z);
    seen.gap = gap_of(j, j.t.v, pieces(node.patch, two));
    return seen;
  }

  // Maps each cell of the raster of flank 1 to a quadrangle on flank 2. For each node of flank 2,
  // the search for the opposite point starts in the cell whose quadrangle contains the node.
  void fill_second() {
    const FlankRaster& r = rasters_[1];
    const std::size_t columns = rasters_[0].height.size();
    const std::size_t rows = rasters_[0].diameter.size();
    const auto row_of = [&](double u) {
      return (pair_.diameter(2, u) - r.diameter.front()) /
             (r.diameter.back() - r.diameter.front()) * static_cast<double>(r.diameter.size() - 1);
    };
    const auto column_of = [&](double Z) {
      return (Z - r.height.front()) / (r.height.back() - r.height.front()) *
             static_cast<double>(r.height.size() - 1);
    };
    for (std::size_t i = 0; i + 1 < rows; ++i) {
      for (std::size_t k = 0; k + 1 < columns; ++k) {
        const std::array<std::size_t, 4> at{i * columns + k, i * columns + k + 1,
                                            (i + 1) * columns + k + 1, (i + 1) * columns + k};
        if (!std::all_of(at.begin(), at.end(), [&](std::size_t q) { return seen_[q].near; }))
          continue;
        std::array<Vec2, 4> p;
        for (std::size_t q = 0; q < 4; ++q)
          p[q] = Vec2(column_of(seen_[at[q]].Z), row_of(seen_[at[q]].u));
        fill_triangle({p[0], p[1], p[2]}, {at[0], at[1], at[2]});
        fill_triangle({p[0], p[2], p[3]}, {at[0], at[2], at[3]});
      }
    }
  }

  void fill_triangle(const std::array<Vec2, 3>& p, const std::array<std::size_t, 3>& corner) {
    const FlankRaster& r = rasters_[1];
    const Vec2 a = p[1] - p[0];
    const Vec2 b = p[2] - p[0];
    const double det = a.x() * b.y() - a.y() * b.x();
    if (det == 0.0) return;
    // Margin, relative to a cell, so that no node between two cells is missed.
    constexpr double kSlack = 1e-6;
    const auto first = [](double lo) {
      return std::max(0, static_cast<int>(std::ceil(lo - kSlack)));
    };
    const auto last = [](double hi, std::size_t n) {
      return std::min(static_cast<int>(n) - 1, static_cast<int>(std::floor(hi + kSlack)));
    };
    const auto [x_lo, x_hi] = std::minmax({p[0].x(), p[1].x(), p[2].x()});
    const auto [y_lo, y_hi] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
    for (int y = first(y_lo); y <= last(y_hi, r.diameter.size()); ++y) {
      for (int x = first(x_lo); x <= last(x_hi, r.height.size()); ++x) {
        const Vec2 d = Vec2(x, y) - p[0];
        const double v = (d.x() * b.y() - d.y() * b.x()) / det;
        const double w = (a.x() * d.y() - a.y() * d.x()) / det;
        if (v < -kSlack || w < -kSlack || v + w > 1.0 + kSlack) continue;
        const auto between = [&](double Node::*q) {
          return (1 - v - w) * nodes_[corner[0]].*q + v * nodes_[corner[1]].*q +
                 w * nodes_[corner[2]].*q;
        };
        const auto row = static_cast<std::size_t>(y);
        const auto column = static_cast<std::size_t>(x);
        Gap& here = now_[1][row * r.height.size() + column];
        here = std::min(here, gap_on_2(between(&Node::u), between(&Node::z),
                                       pair_.u_at(2, r.diameter[row]), r.height[column]));
      }
    }
  }

  // Returns the gap at the point (u, Z) of flank 2. The search starts at (u1, z), the approximate
  // opposite point on flank 1. Newton steps, which may change the patch, lead to the exact opposite
  // point. A series of second order replaces the last step. The gap is infinite if the steps leave
  // flank 1 or do not converge.
  Gap gap_on_2(double u1, double z, double u, double Z) const {
    const int two = patch_at(pair_.patches(2), u, Z);
    if (two < 0) return {};
    int one = patch_at(pair_.patches(1), u1, z);
    if (one < 0) return {};
    const FlankPatch* patch = &pair_.patches(1)[static_cast<std::size_t>(one)];
    double s = patch->profile.s_of(u1);
    for (int step = 0; step < kMaxPlaceSteps; ++step) {
      const GapJet j = jet(one, two, s, z);
      const double det = j.u.s * j.Z.z - j.u.z * j.Z.s;
      if (det == 0.0) return {};
      const double du = u - j.u.v;
      const double dZ = Z - j.Z.v;
      const double ds = (du * j.Z.z - dZ * j.u.z) / det;
      const double dz = (dZ * j.u.s - du * j.Z.s) / det;
      if (std::abs(ds) <= kNearPatch * (patch->s_hi - patch->s_lo) &&
          std::abs(dz) <= kNearPatch * (patch->z_hi - patch->z_lo)) {
        const double t = j.t.v + j.t.s * ds + j.t.z * dz +
                         0.5 * (j.t.ss * ds * ds + 2 * j.t.sz * ds * dz + j.t.zz * dz * dz);
        return gap_of(j, t, pieces(one, two));
      }
      s += ds;
      z += dz;
      if (s >= patch->s_lo && s <= patch->s_hi && z >= patch->z_lo && z <= patch->z_hi) continue;
      u1 = std::log(std::abs(patch->profile.at(s).factor));
      one = patch_at(pair_.patches(1), u1, z);
      if (one < 0) return {};
      patch = &pair_.patches(1)[static_cast<std::size_t>(one)];
      s = patch->profile.s_of(u1);
    }
    return {};
  }

  // If the middle of three successive gaps is the least, the minimum of the parabola through the
  // three gaps is used. Gaps of different patches are not combined, because the gap jumps there.
  void fold(std::size_t which) {
    std::vector<double>& least = rasters_[which].gap;
    for (std::size_t i = 0; i < least.size(); ++i) {
      const Gap g0 = before_[which][i];
      const Gap g1 = last_[which][i];
      const Gap g2 = now_[which][i];
      before_[which][i] = g1;
      last_[which][i] = g2;
      if (g1.pieces < 0) continue;
      double lowest = g1.value;
      if (g0.pieces == g1.pieces && g1.pieces == g2.pieces && !(g0 < g1) && !(g2 < g1)) {
        const double bend = g0.value - 2 * g1.value + g2.value;
        const double slope = g2.value - g0.value;
        if (bend > 0.0) lowest = std::max(0.0, g1.value - slope * slope / (8 * bend));
      }
      least[i] = std::min(least[i], lowest);
    }
  }

  const ContactPair& pair_;
  std::array<FlankRaster, 2> rasters_;
  std::vector<Node> nodes_;
  std::vector<GapField> fields_;
  std::vector<Seen> seen_;
  std::array<std::vector<Gap>, 2> now_, last_, before_;  // gaps at three successive positions
  double te_ = 0.0;
};

}  // namespace

std::array<FlankRaster, 2> contact_pattern(const ContactPair& pair, int positions,
                                           const RasterSize& size, Progress* progress) {
  GW_EXPECTS(positions >= 2 && size.rows >= 2 && size.columns >= 2);
  Transmission transmission(pair);
  const auto touches = transmission.over_a_pitch(-0.5 * pair.pitch(), positions);
  Rasterer rasterer(pair, size);
  // Follows one tooth pair from its first to its last possible contact, at every position.
  const int farthest = transmission.farthest_pair();
  begin_stage(progress, "computing the contact pattern",
              (2 * std::int64_t{farthest} + 1) * positions);
  for (int k = farthest; k >= -farthest; --k) {
    for (int i = 0; i < positions; ++i) {
      count_step(progress);
      const double phi = pair.pitch() * (-0.5 + static_cast<double>(i) / positions - k);
      touches[i].found() ? rasterer.add(phi, touches[i].te()) : rasterer.close();
    }
  }
  rasterer.close();
  return rasterer.take();
}

FlankRaster gap_map(const ContactPair& pair, Angle rotation1, int k, const RasterSize& size) {
  GW_EXPECTS(size.rows >= 2 && size.columns >= 2);
  Transmission transmission(pair);
  const double phi = pair.to_world(rotation1.rad());
  const PairTouch touch = transmission.at(phi);
  Rasterer rasterer(pair, size);
  if (touch.found())
    rasterer.add(phi - static_cast<int>(pair.turned()) * k * pair.pitch(), touch.te());
  rasterer.close();
  return rasterer.take()[0];
}

}  // namespace gearwright
