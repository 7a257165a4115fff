#include "gearwright/generation/cut_by_pinion.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/error.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/base/overloaded.hpp"
#include "gearwright/generation/branch.hpp"
#include "gearwright/math/root.hpp"

namespace gearwright {

namespace {

using detail::Branch;
using detail::branch_of;

// Two arcs join smoothly if their normals differ by at most this angle, rad. If the normal
// turns by ε at a corner, the point that the corner cuts moves by only ε λ²/w.
constexpr double kEqualAngles = 1e-12;

// Returns the angle ν of the outward normal at an end of an arc. ν lies in the half turn that
// begins at the polar angle of this end.
double normal_angle(const Arc& arc, double u) {
  const CurvePoint p = arc.at(u);
  const double c = std::cos(p.tangent_angle);
  const double s = std::sin(p.tangent_angle);
  const double theta = arc.curve->polar_angle(u == 0.0 ? arc.begin : arc.end);
  return theta + std::atan2(std::max(0.0, p.point.x() * c + p.point.y() * s),
                            p.point.y() * c - p.point.x() * s);
}

ArcName cut_by_arc(ArcName cutter) {
  switch (cutter) {
    case ArcName::root_land: return ArcName::tip_land;
    case ArcName::root_fillet: return ArcName::tip_fillet;
    case ArcName::flank: return ArcName::flank;
    case ArcName::tip_fillet: return ArcName::root_fillet;
    case ArcName::tip_land: return ArcName::root_land;
  }
  return ArcName::flank;
}

Walk walk_of(const Arc& arc) { return arc.end > arc.begin ? Walk::forward : Walk::backward; }

// The branches that one cutter gives, ordered from the root of the gear to its tip.
class Cutting {
 public:
  Cutting(const GeneratedTooth& cutter, const PinionMotion& motion)
      : cutter_(cutter), motion_(motion) {}

  bool misses_flank = false;  // true if the centrode lies inside the cutter's base circle
  std::vector<Branch> branches;
  bool loops = false;  // true if a normal misses the centrode, so that a path turns back

  void run() {
    const auto& arcs = cutter_.outline.arcs;
    double nu = 0.0;  // ν at the end of the preceding arc

    bool smooth = true;
    for (std::size_t i = arcs.size(); i-- > 0;) {
      const Arc& arc = arcs[i];
      const double nu_tip_side = normal_angle(arc, 1.0);
      if (nu_tip_side > nu + kEqualAngles) {  // a convex corner
        add_fan(arc, nu, nu_tip_side, smooth);
      } else if (nu_tip_side < nu - kEqualAngles) {
        smooth = false;  // a concave corner does not cut, but the neighbouring arcs do
      }
      smooth = add_arc(arc, smooth);
      nu = normal_angle(arc, 0.0);
    }
    const Arc& root = arcs.front();
    const bool closes = std::abs(nu - kPi / motion_.cutter_teeth) <= kEqualAngles;
    if (root.name != ArcName::root_land && closes && !branches.empty())
      branches.back().ends_on_center_line = true;
  }

  // Returns all branches that the arcs and the convex corners of the cutter cut ahead of the tooth
  // and behind it.
  std::vector<Branch> everything() const {
    std::vector<Branch> all = branches;
    const auto& arcs = cutter_.outline.arcs;
    double nu = 0.0;
    for (std::size_t i = arcs.size(); i-- > 0;) {
      const Arc& arc = arcs[i];
      const double nu_tip_side = normal_angle(arc, 1.0);
      if (nu_tip_side > nu + kEqualAngles)
        pieces(all, std::make_shared<CornerFan>(arc.end_point), Walk::forward, nu_tip_side, nu);
      nu = normal_angle(arc, 0.0);
      visit_curve<AxisCircle, Involute>(
          *arc.curve,
          Overloaded{
              [](const AxisCircle*) {},  // a land can only end the tooth
              [&](const Involute* involute) { involute_piece(all, *involute, arc); },
              [&](const auto*) { pieces(all, arc.curve, walk_of(arc), arc.begin, arc.end); }});
    }
    return all;
  }

 private:
  // Adds the branches that a curve of the cutter cuts behind the tooth, in the order from the
  // root side to the tip side of this curve.
  void pieces(std::vector<Branch>& all, const CurvePtr& curve, Walk walk, double t_root,
              double t_tip) const {
    const auto envelope = std::make_shared<PinionEnvelope>(motion_, curve, walk, Meeting::behind);
    std::vector<double> ends{t_root};
    for (double t : envelope->breaks(t_root, t_tip)) ends.push_back(t);
    ends.push_back(t_tip);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      if (!envelope->cuts(0.5 * (ends[i] + ends[i + 1]))) continue;
      Branch b = branch_of(ArcName::tip_fillet, envelope, ends[i], ends[i + 1], motion_.side());
      if (b.height_lo < b.height_hi) all.push_back(std::move(b));
    }
  }

  void involute_piece(std::vector<Branch>& all, const Involute& involute, const Arc& arc) const {
    const auto cut = pinion_involute(motion_, involute, Meeting::behind);
    if (!cut) return;
    const double a = cut->roll(arc.begin);
    const double b = cut->roll(arc.end);
    // One side of the cusp is kept. It is the side ξ < 0 on an external gear, and the side ξ > 0 on
    // an internal gear.
    const double side = motion_.side();
    const double t_lo = side > 0.0 ? std::min(a, 0.0) : std::max(a, 0.0);
    const double t_hi = side > 0.0 ? std::min(b, 0.0) : std::max(b, 0.0);
    Branch branch =
        branch_of(ArcName::tip_fillet, std::make_shared<Involute>(cut->flank), t_lo, t_hi, side);
    if (branch.height_lo < branch.height_hi) all.push_back(std::move(branch));
  }

  // Adds the branches of an arc. Returns true if the next branch continues the last one smoothly.
  bool add_arc(const Arc& arc, bool smooth) {
    return visit_curve<AxisCircle, Involute>(
        *arc.curve,
        Overloaded{[](const AxisCircle*) { return true; },  // a land can only end the tooth
                   [&](const Involute* involute) { return add_involute(arc, *involute, smooth); },
                   [&](const auto*) {
                     return add_envelope(cut_by_arc(arc.name), arc.curve, walk_of(arc), arc.end,
                                         arc.begin, smooth);
                   }});
  }

  void add_fan(const Arc& arc, double nu_from, double nu_to, bool& smooth) {
    // A corner beyond the flank belongs to the root of the cutter and cuts the tip of the gear.
    const ArcName cuts = arc.name == ArcName::root_fillet || arc.name == ArcName::root_land
                             ? ArcName::tip_fillet
                             : ArcName::root_fillet;
    const auto corner = std::make_shared<CornerFan>(arc.end_point);
    smooth = add_envelope(cuts, corner, Walk::forward, nu_from, nu_to, smooth);
  }

  bool add_involute(const Arc& arc, const Involute& involute, bool smooth) {
    const auto cut = pinion_involute(motion_, involute);
    if (!cut) {
      misses_flank = misses_flank || arc.name == ArcName::flank;
      return false;
    }
    const double side = motion_.side();
    double t_lo = cut->roll(arc.end);
    const double t_hi = cut->roll(arc.begin);
    if (side > 0.0 && t_lo < 0.0) {  // with undercut, the radius decreases up to the cusp at ξ = 0
      if (!(t_hi > 0.0)) return false;
      t_lo = 0.0;
      smooth = false;
    }
    Branch b =
        branch_of(cut_by_arc(arc.name), std::make_shared<Involute>(cut->flank), t_lo, t_hi, side);
    b.smooth_start = smooth;
    branches.push_back(std::move(b));
    return true;
  }

  bool add_envelope(ArcName cuts, const CurvePtr& curve, Walk walk, double t_tip, double t_root,
                    bool smooth) {
    const auto ahead = std::make_shared<PinionEnvelope>(motion_, curve, walk);
    std::vector<double> ends{t_tip};
    for (double t : ahead->breaks(t_tip, t_root)) ends.push_back(t);
    ends.push_back(t_root);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const double middle = 0.5 * (ends[i] + ends[i + 1]);
      const bool stands = ahead->cuts(middle);
      if (stands) add(cuts, ahead, ends[i], ends[i + 1], smooth);
      loops = loops || !ahead->reaches(middle);
      smooth = stands && i + 2 == ends.size();  // no branch continues smoothly after a cusp
    }
    return smooth;
  }

  void add(ArcName cuts, const std::shared_ptr<PinionEnvelope>& envelope, double t_lo, double t_hi,
           bool smooth) {
    Branch b = branch_of(cuts, envelope, t_lo, t_hi, motion_.side());
    b.smooth_start = smooth;
    if (cuts == ArcName::root_fillet) b.turns = envelope->turns(t_lo, t_hi);
    if (b.height_lo < b.height_hi) branches.push_back(std::move(b));
  }

  const GeneratedTooth& cutter_;
  const PinionMotion& motion_;
};

}  // namespace

double left_by_root(const GeneratedTooth& cutter, const PinionMotion& motion) {
  return motion.distance - motion.side() * cutter.root_radius;
}

Result<GeneratedTooth> cut_by_pinion(const GeneratedTooth& cutter, const PinionMotion& motion,
                                     double blank_radius) {
  GW_EXPECTS(!cutter.outline.arcs.empty());
  GW_EXPECTS(motion.teeth > 0 || -motion.teeth > motion.cutter_teeth);
  const double side = motion.side();
  const auto& arcs = cutter.outline.arcs;
  GeneratedTooth tooth{};
  tooth.root_radius = motion.distance - side * cutter.tip_radius;
  const double cutter_radius = left_by_root(cutter, motion);
  if (!(tooth.root_radius > 0.0)) {
    tooth.tip_radius = side > 0.0 ? std::min(blank_radius, cutter_radius) : blank_radius;
    tooth.through_axis = true;
    return tooth;
  }
  Cutting cutting(cutter, motion);
  cutting.run();
  if (cutting.misses_flank) {
    return refused("cut_by", motion.distance,
                   "at this generating centre distance the generating pitch circle of the cutter "
                   "lies inside its base circle, so its flanks do not cut; increase the distance");
  }
  if (cutting.branches.empty())
    return Error{"cut_by", "", "the cutter leaves no tooth at this centre distance"};
  const Arc& last = arcs.back();
  const double land = last.name == ArcName::tip_land ? last.begin : 0.0;
  const detail::ToothEnds ends{motion.teeth,
                               side,
                               kPi / std::abs(motion.teeth) - std::abs(motion.ratio()) * land,
                               blank_radius,
                               cutter_radius,
                               false,
                               cutting.loops || side < 0.0,
                               [&] { return cutting.everything(); }};
  return detail::finish_tooth(cutting.branches, ends, std::move(tooth));
}

}  // namespace gearwright
