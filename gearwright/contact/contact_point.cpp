#include "gearwright/contact/contact_point.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace gearwright {

namespace {

using End = FlankPatch::End;

// Returns the kind of touch at bound j of D, the part of flank 1 opposite flank 2 (touch.hpp).
// Returns none at a seam, where another patch of the same flank continues with the same slope.
TouchKind kind_of(const GapField& field, int j) {
  const FlankPatch& a = field.one();
  const FlankPatch& b = field.two();
  const auto profile = [](End end, TouchKind tip, TouchKind form) {
    return end == End::tip     ? tip
           : end == End::form  ? form
           : end == End::ridge ? TouchKind::ridge
                               : TouchKind::none;
  };
  const auto face = [](End end, TouchKind kind) {
    return end == End::face ? kind : end == End::ridge ? TouchKind::ridge : TouchKind::none;
  };
  const bool s_is_u = b.profile.grows();
  switch (j) {
    case 0: return profile(a.s_lo_end, TouchKind::tip1, TouchKind::form1);
    case 1: return profile(a.s_hi_end, TouchKind::tip1, TouchKind::form1);
    case 2: return face(a.z_lo_end, TouchKind::face1);
    case 3: return face(a.z_hi_end, TouchKind::face1);
    case 4: return profile(s_is_u ? b.s_lo_end : b.s_hi_end, TouchKind::tip2, TouchKind::form2);
    case 5: return profile(s_is_u ? b.s_hi_end : b.s_lo_end, TouchKind::tip2, TouchKind::form2);
    case 6: return face(b.z_lo_end, TouchKind::face2);
    default: return face(b.z_hi_end, TouchKind::face2);
  }
}

TouchKind kind_of(const GapField& field, const detail::ActiveSet& set) {
  if (set.inside()) return TouchKind::interior;
  const TouchKind first = kind_of(field, set.first);
  const TouchKind second = set.corner() ? kind_of(field, set.second) : TouchKind::none;
  if (first == TouchKind::none && second == TouchKind::none) return TouchKind::interior;
  if (first == TouchKind::none) return second;
  return second == TouchKind::none ? first : TouchKind::corner;
}

constexpr double kOnBound = 1e-12;  // rounding error of a point on a bound; a scaled length

struct Place {
  double s, z;
};

// Follows the straight line through the touch along which the gap field T has the least curvature,
// and finds the part of this line on which the flanks stay in contact.
class LineWalk {
 public:
  LineWalk(Transmission& transmission, const PairTouch& touch)
      : transmission_(transmission),
        touch_(touch),
        search_(transmission.search(touch.fields)),
        a_(search_.field().one()),
        s_half_(0.5 * (a_.s_hi - a_.s_lo)),
        z_half_(0.5 * (a_.z_hi - a_.z_lo)) {
    const GapJet j = transmission.jet_at(touch, touch.touch.s, touch.touch.z);
    Eigen::Matrix2d h;
    h << j.t.ss * s_half_ * s_half_, j.t.sz * s_half_ * z_half_, j.t.sz * s_half_ * z_half_,
        j.t.zz * z_half_ * z_half_;
    const SymmetricEigen eigen = symmetric_eigen(h);
    const int soft = std::abs(eigen.values[0]) < std::abs(eigen.values[1]) ? 0 : 1;
    direction_ = eigen.vectors.col(soft);
    soft_ = eigen.values[soft];
    arm_ = GapField::arm(j);
  }

  // True if the curvature at the touch permits a gap below kLineGap over half the patch.
  bool worth_walking() const { return std::abs(soft_) * arm_ < 8.0 * kLineGap; }

  // Returns the two points at which the line leaves D. Returns none if the gap opens inside D.
  std::optional<std::array<Place, 2>> ends() {
    std::array<Place, 2> found;
    for (const int sense : {-1, 1}) {
      const double t = last_inside(sense);
      const Place end = at(sense * t);
      if (!together(at(sense * 0.5 * t)) || !together(end)) return std::nullopt;
      found[sense > 0 ? 1 : 0] = end;
    }
    // A line shorter than kPoint counts as a point.
    constexpr double kPoint = 1e-6;  // shortest line, relative to half the patch
    const double long_s = (found[1].s - found[0].s) / s_half_;
    const double long_z = (found[1].z - found[0].z) / z_half_;
    if (std::hypot(long_s, long_z) < kPoint) return std::nullopt;
    return found;
  }

 private:
  Place at(double t) const {
    return {touch_.touch.s + t * direction_[0] * s_half_,
            touch_.touch.z + t * direction_[1] * z_half_};
  }

  // Returns the bounds of D at a place. The parameter on flank 2 does not affect the bounds.
  std::array<double, detail::kBounds> bounds(const Place& p) const {
    double s2 = touch_.touch.s2;
    const GapJet j = search_.field().at(p.s, p.z, s2);
    std::array<double, detail::kBounds> c;
    for (int b = 0; b < detail::kBounds; ++b) c[b] = search_.bound(j, p.s, p.z, b) + kOnBound;
    return c;
  }

  bool together(const Place& p) {
    const GapJet j = transmission_.jet_at(touch_, p.s, p.z);
    return (touch_.touch.te - j.t.v) * GapField::arm(j) < kLineGap;
  }

  // Returns the greatest multiple of kStep, at most kMost, up to which the line lies inside D.
  double last_inside(int sense) const {
    constexpr double kMost = 4.0;  // in half lengths of the patch; exceeds half its diagonal
    constexpr double kStep = 0x1p-48;
    // Each bound is nearly linear along the line, so secants find the first bound that is crossed.
    double before = 0.0, t = 1.0;
    auto last = bounds(at(before));
    for (int k = 0; k < 8 && std::abs(t - before) > kStep; ++k) {
      const auto here = bounds(at(sense * t));
      double next = kMost;
      for (int b = 0; b < detail::kBounds; ++b) {
        const double slope = (here[b] - last[b]) / (t - before);
        if (slope < 0.0) next = std::min(next, t - here[b] / slope);
      }
      before = std::exchange(t, std::max(0.0, next));
      last = here;
    }
    const auto inside = [&](double x) {
      const auto c = bounds(at(sense * x));
      return x == 0.0 || (x < kMost && *std::min_element(c.begin(), c.end()) >= 0.0);
    };
    // The bracket begins with one step around t. It grows until it contains the border of D.
    double lo = kStep * std::floor(t / kStep), hi = lo + kStep;
    for (double step = kStep; !inside(lo); step *= 2) lo = std::max(0.0, (hi = lo) - step);
    for (double step = kStep; inside(hi); step *= 2) hi = (lo = hi) + step;
    while (hi - lo > kStep) {
      const double middle = lo + kStep * std::floor(0.5 * (hi - lo) / kStep);
      (inside(middle) ? lo : hi) = middle;
    }
    return lo;
  }

  Transmission& transmission_;
  const PairTouch& touch_;
  const TouchSearch& search_;
  const FlankPatch& a_;
  double s_half_, z_half_;
  Eigen::Vector2d direction_;
  double soft_ = 0.0, arm_ = 0.0;
};

// True if a bound is active and its multiplier is positive, as far as kLineGap can distinguish it
// from 0. The touch is then at an edge, even if the edge touches along its whole length.
bool holds_with_weight(Transmission& transmission, const PairTouch& touch) {
  const double weight = std::max(touch.touch.multiplier[0], touch.touch.multiplier[1]);
  const Touch& t = touch.touch;
  const double arm = t.arm > 0.0 ? t.arm : GapField::arm(transmission.jet_at(touch, t.s, t.z));
  return weight * arm > kLineGap;
}

// Computes the principal curvatures of the gap and the contact ellipse. [T8.15], [T8.16]
void curvatures(const ContactPair& pair, const GapJet& j, bool line, double marking,
                ContactPoint& p) {
  const Vec3 r_s = pair.in_housing(pair.tilt() * along_1(j.w1_s, 0.0));
  const Vec3 r_z = pair.in_housing(pair.tilt() * along_1(j.w1_z, 1.0));
  const Vec3 axis(0, 0, 1);  // nominal direction of axis 1 in the housing
  const Vec3 e1 = (axis - p.normal * p.normal.dot(axis)).normalized();
  const Vec3 e2 = p.normal.cross(e1);
  const SymmetricEigen eigen = gap_form(j, r_s, r_z, e1, e2).principal;
  const double k1 = line ? 0.0 : eigen.values[0];
  const double k2 = eigen.values[1];
  p.gap_curvature = std::array{k1, k2};
  if (!(k2 > 0.0)) return;
  ContactEllipse ellipse;
  if (k1 > 0.0) ellipse.semi_major = std::sqrt(2 * marking / k1);
  ellipse.semi_minor = std::sqrt(2 * marking / k2);
  Eigen::Vector2d major = eigen.vectors.col(0);
  if (major[0] < 0.0 || (major[0] == 0.0 && major[1] < 0.0)) major = -major;
  ellipse.angle = Angle::radians(std::atan2(major[1], major[0]));
  p.ellipse = ellipse;
}

}  // namespace

std::string_view to_string(TouchKind kind) {
  switch (kind) {
    case TouchKind::none: return "none";
    case TouchKind::interior: return "interior";
    case TouchKind::line: return "line";
    case TouchKind::tip1: return "tip1";
    case TouchKind::tip2: return "tip2";
    case TouchKind::face1: return "face1";
    case TouchKind::face2: return "face2";
    case TouchKind::form1: return "form1";
    case TouchKind::form2: return "form2";
    case TouchKind::ridge: return "ridge";
    case TouchKind::corner: return "corner";
  }
  GW_ENSURES(false);
  return "";
}

bool is_edge(TouchKind kind) { return is_sharp(kind) && kind != TouchKind::ridge; }

bool is_sharp(TouchKind kind) {
  return kind != TouchKind::none && kind != TouchKind::interior && kind != TouchKind::line;
}

bool at_seam(Transmission& transmission, const PairTouch& touch) {
  const detail::ActiveSet& set = touch.touch.active;
  const double arm = GapField::arm(transmission.jet_at(touch, touch.touch.s, touch.touch.z));
  const auto holds = [&](int bound, double multiplier) {
    return bound >= 0 && multiplier * arm > kLineGap &&
           kind_of(transmission.field(touch.fields), bound) == TouchKind::none;
  };
  return holds(set.first, touch.touch.multiplier[0]) ||
         holds(set.second, touch.touch.multiplier[1]);
}

bool on_edge(Transmission& transmission, const PairTouch& touch) {
  if (!touch.found() || !is_edge(kind_of(transmission.field(touch.fields), touch.touch.active)))
    return false;
  if (holds_with_weight(transmission, touch)) return true;
  LineWalk walk(transmission, touch);
  return !walk.worth_walking() || !walk.ends();
}

ContactPoint describe(Transmission& transmission, const PairTouch& touch, Angle rotation1,
                      double marking) {
  ContactPoint p;
  p.rotation1 = rotation1;
  p.rack = {transmission.pair().rack_radius()};
  if (!touch.found()) return p;
  const ContactPair& pair = transmission.pair();
  const GapField& field = transmission.field(touch.fields);
  const double turned = pair.turned();
  p.te = Angle::radians(turned * touch.touch.te);
  p.rotation2 = pair.ratio() * rotation1 + p.te;
  p.pair = static_cast<int>(turned) * touch.pair;
  p.kind = kind_of(field, touch.touch.active);
  Place at{touch.touch.s, touch.touch.z};
  const bool edge = holds_with_weight(transmission, touch);
  // If the multiplier of a ridge is 0, T does not rise towards it, so the touch counts as interior.
  if (p.kind == TouchKind::ridge && !edge) p.kind = TouchKind::interior;
  if (LineWalk walk(transmission, touch); !edge && walk.worth_walking()) {
    if (const auto ends = walk.ends()) {
      p.kind = TouchKind::line;
      std::array<Vec3, 2> line;
      for (int i = 0; i < 2; ++i) {
        const GapJet j = transmission.jet_at(touch, (*ends)[i].s, (*ends)[i].z);
        line[i] = pair.in_housing(j.w1, (*ends)[i].z);
      }
      if (line[0].z() > line[1].z()) std::swap(line[0], line[1]);
      p.line = line;
      // Every point of the line touches, so the middle of the line represents all of them.
      at = {0.5 * ((*ends)[0].s + (*ends)[1].s), 0.5 * ((*ends)[0].z + (*ends)[1].z)};
    }
  }
  const GapJet j = transmission.jet_at(touch, at.s, at.z);
  p.point = pair.in_housing(j.w1, at.z);
  p.diameter = {2 * std::abs(j.w1), pair.diameter(2, j.u.v)};
  p.height = {turned * at.z, turned * j.Z.v};
  const auto rack_angle = field.one().profile.involute() ? pair.normal_pressure_angle()
                                                         : field.one().profile.rack_angle(at.s);
  if (rack_angle) p.rack_angle = Angle::radians(*rack_angle);
  const Vec3 r_s = (pair.tilt() * along_1(j.w1_s, 0.0)).v;
  const Vec3 r_z = (pair.tilt() * along_1(j.w1_z, 1.0)).v;
  // The normal that points out of gear 1.
  Vec3 normal = r_s.cross(r_z).normalized();
  const Vec3 round = (pair.tilt() * along_1(Complex(0, 1) * j.w1, 0.0)).v;
  if (normal.dot(round) * field.one().profile.side() < 0.0) normal = -normal;
  p.normal = pair.in_housing(FreeVector<World>{normal});
  if (p.kind == TouchKind::line || (p.kind == TouchKind::interior && touch.touch.active.inside()))
    curvatures(pair, j, p.kind == TouchKind::line, marking, p);
  if (p.kind == TouchKind::ridge) p.ridge = detail::ridge_at(transmission, touch);
  return p;
}

}  // namespace gearwright
