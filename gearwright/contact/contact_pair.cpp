#include "gearwright/contact/contact_pair.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gearwright/contact/error_turns.hpp"
#include "gearwright/contact/recut.hpp"

namespace gearwright {

namespace {

using End = FlankPatch::End;
using Cell = RemovalField::Cell;

// Returns the type of a border of a cell: ridge or seam. `of_u` selects a border at an end of the
// range of u instead of z. `below` selects the lower end instead of the upper end.
End border(const RemovalField& field, const Cell& cell, bool of_u, bool below) {
  for (const Cell& other : field.pieces()) {
    const bool across = of_u ? other.z_lo == cell.z_lo &&
                                   (below ? other.u_hi == cell.u_lo : other.u_lo == cell.u_hi)
                             : other.u_lo == cell.u_lo &&
                                   (below ? other.z_hi == cell.z_lo : other.z_lo == cell.z_hi);
    if (across && field.ridge_between(cell.piece, other.piece)) return End::ridge;
  }
  return End::seam;
}

// Returns two parts of the twist of a gear's teeth in the frame N: the twist of the lead, including
// the error of the cutter's lead angle, and the twist κ of a lead error.
std::array<double, 2> twist_in_n(const Gear& g, const ContactErrors& e, int i, double side) {
  const double lead = with_cutter_lead(g.twist(), g.reference_diameter / 2, e.cutter_lead[i].rad());
  return {side * lead, side * e.helix_twist[i]};
}

}  // namespace

ContactErrors mirrored(const ContactErrors& errors) {
  ContactErrors e = errors;
  e.crossing = -e.crossing;
  e.intersecting = -e.intersecting;
  e.axial = -e.axial;
  return e;
}

ContactPair::ContactPair(const ContactGear& gear_1, const ContactGear& gear_2,
                         const ContactMount& mount)
    : place_(mount) {
  const Gear& g1 = *gear_1.gear;
  const Gear& g2 = *gear_2.gear;
  GW_EXPECTS(!g1.internal() && g1.exists() && g2.exists() && g1.tooth && g2.tooth);
  side_ = g2.side();
  alpha_n_ = g1.spec.normal_pressure_angle.rad();
  const double z1 = g1.spec.teeth;
  const double z2 = std::abs(g2.spec.teeth);
  ratio_ = z1 / z2;
  pitch_ = 2 * std::numbers::pi / z1;
  rotation_sign_ = -side();
  const auto& e = mount.errors;
  const double pi = std::numbers::pi;
  const bool right_1 = !mount.gear2_drives;
  const bool right_2 = !g2.left_flank_works(mount.gear2_drives);
  for (int i = 0; i < 2; ++i) {
    const Gear& g = i == 0 ? g1 : g2;
    slope_unit_[i] = side() / (g.reference_diameter / 2 * g.spec.face_width);
  }
  add_patches(0, gear_1, twist_in_n(g1, e, 0, side()), mesh_azimuth(), -side(), right_1);
  // Gear 2 is turned by `apart` so that, at rotation 0, teeth are in mesh at the middle of face 1.
  const double apart = side() * g2.twist() * (middle(2) - middle(1));
  add_patches(1, gear_2, twist_in_n(g2, e, 1, side()), pi + pi / z2 + apart, -1.0, right_2);
  set_mount();
  // Points of gear 1 at an angle greater than reach_ from the mesh azimuth cannot touch gear 2,
  // because they lie outside the annulus of its teeth.
  const auto radius = [](const std::vector<FlankPatch>& patches, bool greatest) {
    double r = greatest ? 0.0 : std::numeric_limits<double>::infinity();
    for (const FlankPatch& p : patches)
      r = greatest ? std::max(r, std::exp(p.u_hi)) : std::min(r, std::exp(p.u_lo));
    return r;
  };
  const double a = mount.center_distance + e.center_distance;
  const double r1 = radius(patches_[0], true);
  double cosine = (a - radius(patches_[1], true)) / r1;
  double aside = 0.0;
  if (side_ < 0.0) {
    // On crossed axes, the transverse sections of gear 1 are displaced sideways from axis 2. `off`
    // is the displacement at the end of the face. [T4.37]
    const double r2 = radius(patches_[1], false);
    const double off = g1.spec.face_width / 2 * std::abs(std::sin(mount.axis_angle.rad()));
    const double across = 2 * r1 * off, along = 2 * a * r1;
    cosine = a > 0.0 ? (r2 * r2 - a * a - r1 * r1 - off * off) / std::hypot(along, across) : -1.0;
    aside = std::atan2(across, along);
  }
  reach_ = std::min(pi, std::acos(std::clamp(cosine, -1.0, 1.0)) + aside);
}

ContactPair::ContactPair(const ContactGear& pinion, const RackGeometry& rack,
                         const ContactMount& mount)
    : place_(mount), side_(1.0), ratio_(1.0), rotation_sign_(-1.0) {
  const Gear& g = *pinion.gear;
  const ContactErrors& e = mount.errors;
  GW_EXPECTS(!g.internal() && g.exists() && g.tooth);
  GW_EXPECTS(mount.axis_angle == Angle() && !mount.fillets && mount.middle[1] == mount.middle[0] &&
             e.helix_twist[1] == 0.0 && e.cutter_lead[1] == Angle());
  const double r = g.reference_diameter / 2;
  const double tan_t = std::tan(g.reference().transverse_pressure_angle);
  alpha_n_ = g.spec.normal_pressure_angle.rad();
  pitch_ = 2 * std::numbers::pi / g.spec.teeth;
  rack_radius_ = r;
  slope_unit_[0] = 1.0 / (r * g.spec.face_width);
  add_patches(0, pinion, twist_in_n(g, e, 0, 1.0), 0.0, -1.0, !mount.gear2_drives);
  // At rotation 0, a space of the rack is on the centre line.
  const double half = rack.thickness / (2 * r * std::cos(rack.helix_angle.rad()));
  const Profile::RackFlank flank{-rack.form_depth() / r, rack.addendum / r, half, tan_t};
  FlankPatch p{Profile(flank, -1.0), pitch_ / 2, std::tan(rack.helix_angle.rad()) / r,
               -rack.face_width / 2, rack.face_width / 2};
  p.s_lo = p.u_lo = flank.u_lo;
  p.s_hi = p.u_hi = flank.u_hi;
  patches_[1].push_back(p);
  set_mount();
  const double a = mount.center_distance + e.center_distance;
  double r_1 = 0.0;
  for (const FlankPatch& one : patches_[0]) r_1 = std::max(r_1, std::exp(one.u_hi));
  reach_ = std::acos(std::clamp((a - rack.addendum) / r_1, -1.0, 1.0));
}

double ContactPair::diameter(int gear, double u) const {
  return gear == 2 && is_rack() ? rack_radius_ * u : 2 * std::exp(u);
}

double ContactPair::u_at(int gear, double diameter) const {
  return gear == 2 && is_rack() ? diameter / rack_radius_ : std::log(diameter / 2);
}

void ContactPair::add_patches(int which, const ContactGear& gear,
                              const std::array<double, 2>& twist, double center, double side,
                              bool right) {
  const Gear& g = *gear.gear;
  const bool ring = g.internal();
  const double half = g.spec.face_width / 2;
  const RemovalField* removal = gear.removal[right ? 0 : 1];
  const auto touches = [&](ArcName name) {
    if (name == ArcName::flank) return true;
    if (!place_.fillets) return false;
    return name == ArcName::root_fillet || (name == ArcName::tip_fillet && !removal);
  };
  const double delta_lambda = place_.errors.cutter_lead[which].rad();
  const auto changed = delta_lambda != 0.0 ? recut_outline(g, delta_lambda) : std::nullopt;
  GW_EXPECTS(!place_.fillets || delta_lambda == 0.0 || changed);
  std::vector<Arc> arcs;
  for (const Arc& arc : changed ? changed->arcs : g.tooth->outline.arcs)
    if (touches(arc.name)) arcs.push_back(changed ? arc : recut(arc, g, delta_lambda));
  GW_EXPECTS(!arcs.empty());
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const Arc& arc = arcs[i];
    const Profile profile(arc, side, twist[0]);
    if (arc.name == ArcName::root_fillet)
      root_end_[which] = std::exp(ring ? profile.u_lo() : profile.u_hi());
    FlankPatch p{profile, center, twist[0] + twist[1], -half, half};
    const End root = i == 0 ? End::form : End::seam;
    const End tip = i + 1 == arcs.size() ? End::tip : End::seam;
    const bool root_first = profile.grows() != ring;
    p.s_lo_end = root_first ? root : tip;
    p.s_hi_end = root_first ? tip : root;
    p.s_lo = profile.s_lo();
    p.s_hi = profile.s_hi();
    p.u_lo = profile.u_lo();
    p.u_hi = profile.u_hi();
    if (!removal || arc.name != ArcName::flank) {
      patches_[which].push_back(p);
      continue;
    }
    p.removal = removal;
    p.removal_z = turned();
    for (const auto& cell : removal->pieces()) {
      FlankPatch c = p;
      c.piece = cell.piece;
      c.u_lo = std::max(p.u_lo, cell.u_lo);
      c.u_hi = std::min(p.u_hi, cell.u_hi);
      // The borders of the field and of the profile differ by the rounding of ln ρ. A cell that
      // overlaps this piece of the profile only by this difference belongs to the next piece.
      constexpr double kSameBorder = 1e-12;  // in u = ln ρ
      if (!(c.u_hi - c.u_lo > kSameBorder)) continue;
      const auto cut_u = [&](double u, bool at_lower) {
        const bool first = profile.grows() == at_lower;
        (first ? c.s_lo : c.s_hi) = profile.s_of(u);
        (first ? c.s_lo_end : c.s_hi_end) = border(*removal, cell, true, at_lower);
      };
      if (c.u_lo > p.u_lo + kSameBorder) cut_u(c.u_lo, true);
      if (c.u_hi < p.u_hi - kSameBorder) cut_u(c.u_hi, false);
      const double z_a = turned() * cell.z_lo;
      const double z_b = turned() * cell.z_hi;
      c.z_lo = std::max(-half, std::min(z_a, z_b));
      c.z_hi = std::min(half, std::max(z_a, z_b));
      // z in the frame N may have the opposite sign of z in the RemovalField.
      if (c.z_lo > -half) c.z_lo_end = border(*removal, cell, false, turned() > 0.0);
      if (c.z_hi < half) c.z_hi_end = border(*removal, cell, false, turned() < 0.0);
      patches_[which].push_back(c);
    }
  }
}

void ContactPair::set_mount() {
  const ContactErrors& e = place_.errors;
  tilt_ = detail::tilt(side() * e.crossing.rad(), turned() * e.intersecting.rad());
  // [T8.26]
  lift_.r = Vec3(0, 0, turned() * e.axial) + (tilt_ * along_1(0.0, middle(1))).v;
  const LinearMap<Axis2, World> shaft = detail::shaft_turn(side() * place_.axis_angle.rad());
  const FreeVector<World> from_axis_2{lift_.r -
                                      Vec3(place_.center_distance + e.center_distance, 0, 0)};
  relative_.rotation = shaft * tilt_;
  relative_.shift.r = (shaft * from_axis_2).v - Vec3(0, 0, middle(2));
}

Vec3 ContactPair::in_housing(const FreeVector<World>& v) const {
  return {v.v.x(), turned() * side() * v.v.y(), turned() * v.v.z()};
}

Vec3 ContactPair::in_housing(const Complex& w1, double z) const {
  return in_housing(FreeVector<World>{(tilt_ * along_1(w1, z)).v + lift_.r});
}

Vec3 ContactPair::tilted(const Vec3& direction) const {
  // The conversion between the frame N and the housing is its own inverse.
  const Vec3 in_n = in_housing(FreeVector<World>{direction});
  return in_housing(tilt_ * FreeVector<Axis1>{in_n});
}

}  // namespace gearwright
