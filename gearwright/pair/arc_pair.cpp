#include "gearwright/pair/arc_pair.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/numbers.hpp"
#include "gearwright/gear/gear.hpp"
#include "gearwright/pair/interference.hpp"

namespace gearwright {

namespace {

std::vector<WorkingArc> working(const Gear& gear, double side) {
  GW_EXPECTS(gear.arc_cutter() != nullptr);
  const double m = gear.spec.normal_module;
  const double thinner = gear.spec.thickness_allowance / 2;
  std::vector<WorkingArc> list;
  for (const RackArc& arc : gear.arc_cutter()->arcs) {
    if (arc.cuts != ArcName::flank || !arc.working || !(side * arc.radius > 0.0)) continue;
    // The formulas [T7.1] and [T7.2], solved for the working arc.
    const double middle = side > 0.0 ? 0.0 : kPi / 2;
    list.push_back({std::abs(arc.radius) * m,
                    -side * (arc.center_offset * m + thinner) + side * middle * m,
                    -side * arc.center_height * m});
  }
  return list;
}

double pitch_radius(const Gear& gear) { return gear.reference_diameter / 2; }

std::optional<Error> check_gears(const std::array<Gear, 2>& gears) {
  for (const int which : {1, 2}) {
    const Gear& gear = gears[which - 1];
    if (gear.involute()) {
      return Error{gear_field(which, "rack"), "",
                   "an involute gear does not mesh with a circular-arc gear; give both gears a "
                   "rack of arcs"};
    }
    if (!gear.exists()) {
      return Error{gear_field(which, "rack.dedendum"), "", gear.warnings.back().message};
    }
  }
  const CylindricalSpec &s_1 = gears[0].spec, &s_2 = gears[1].spec;
  if (s_1.helix_angle.rad() == 0.0) {
    return refused(gear_field(1, "helix_angle"), 0.0,
                   "must not be 0, because the contact points of circular-arc teeth move along a "
                   "helix; usual angles are 10° to 35°");
  }
  if (!(std::abs(s_2.normal_module / s_1.normal_module - 1.0) <= kNearModule)) {
    return refused(gear_field(2, "normal_module"), s_2.normal_module, {s_1.normal_module},
                   "must equal the module of gear 1, {}\u00a0mm, because racks of different pitch "
                   "do not mesh");
  }
  if (!(std::abs((s_1.helix_angle + s_2.helix_angle).rad()) <= kNearHelix.rad())) {
    return refused(gear_field(2, "helix_angle"), s_2.helix_angle.deg(), {-s_1.helix_angle.deg()},
                   "must be {}°, because circular-arc gears run on parallel axes with opposite "
                   "hands");
  }
  return std::nullopt;
}

bool of_one_lead(const std::array<Gear, 2>& gears) {
  const CylindricalSpec &s_1 = gears[0].spec, &s_2 = gears[1].spec;
  return std::abs(s_2.normal_module / s_1.normal_module - 1.0) <= kSameAsWritten &&
         std::abs((s_1.helix_angle + s_2.helix_angle).rad()) <= kSameAsWritten;
}

// Transforms the contact from the frame of arc_contact.hpp to the housing.
void place(ArcContact& at, const Gear& convex, bool by_gear_2, double a) {
  if (by_gear_2) {
    // The frame of arc_contact.hpp has its origin on axis 2, and its x axis points towards axis 1.
    // In that frame, a tooth of the convex gear is on the centre line at rotation 0. In the
    // housing, a space of gear 2 is there, so the contacts are displaced by half an axial pitch.
    // Two of the displaced contacts are neighbours of the middle of the face, and the nearer one is
    // used.
    const double half = at.advance * kPi / convex.spec.teeth;
    at.point.z() += at.point.z() > 0.0 ? -half : half;
    at.point = {a - at.point.x(), -at.point.y(), at.point.z()};
    // The normal is turned with the frame. Then its sign is changed, so that it points out of gear
    // 1.
    at.normal = {at.normal.x(), at.normal.y(), -at.normal.z()};
  }
  const double hand = convex.spec.helix_angle.rad() > 0.0 ? 1.0 : -1.0;
  at.point.z() *= hand;
  at.normal.z() *= hand;
  at.angle = hand * at.angle;
  at.advance *= hand;
}

ArcMeshInput mesh_of(const Gear& convex, const Gear& concave, const WorkingArc& v,
                     const WorkingArc& c, double a) {
  return {v,
          c,
          pitch_radius(convex),
          pitch_radius(concave),
          Angle::radians(kPi / 2 - std::abs(convex.spec.helix_angle.rad())),
          a};
}

// True if a working arc of the gear's rack includes a point with the normal angle θ.
bool has_angle(const Gear& gear, double side, Angle theta) {
  for (const RackArc& arc : gear.arc_cutter()->arcs) {
    if (arc.cuts != ArcName::flank || !arc.working || !(side * arc.radius > 0.0)) continue;
    const auto [lo, hi] = std::minmax({arc.begin, arc.end});
    if (theta >= lo && theta <= hi) return true;
  }
  return false;
}

// Returns the name of the spec member that gives the radius of the concave flank.
const char* radius_field(const Gear& concave) {
  const Rack& rack = concave.spec.rack;
  return std::holds_alternative<ArcRack>(rack)         ? "rack.arc_radius"
         : std::holds_alternative<DoubleArcRack>(rack) ? "rack.concave_radius"
                                                       : "rack.arcs";
}

// Finds all contacts. If there is none, the function returns the reason as an error.
std::optional<Error> find_contacts(ArcPair& pair) {
  std::optional<Error> reason;
  for (const bool by_gear_2 : {false, true}) {
    const Gear& convex = pair.gears[by_gear_2 ? 1 : 0];
    const Gear& concave = pair.gears[by_gear_2 ? 0 : 1];
    for (const WorkingArc& v : convex_arcs(convex)) {
      for (const WorkingArc& c : concave_arcs(concave)) {
        if (!(c.radius > v.radius)) {
          const double m = concave.spec.normal_module;
          reason = refused(gear_field(by_gear_2 ? 1 : 2, radius_field(concave)), c.radius / m,
                           {v.radius / convex.spec.normal_module},
                           "a concave flank must have a greater radius than the convex flank of "
                           "the mating gear, {} modules");
          continue;
        }
        const ArcMeshInput in = mesh_of(convex, concave, v, c, pair.center_distance);
        const auto theta = contact_angle(in);
        if (!theta) {
          const double free = pair.reference_center_distance + c.b - v.b;
          reason = refused(
              "pair.center_distance", pair.center_distance, {free - (c.radius - v.radius), free},
              fmt::format(
                  "the arcs have no common normal at this centre distance. Their radii are {:.6g} "
                  "mm and {:.6g} mm, and their centres are {:.6g} mm and {:.6g} mm from the pitch "
                  "plane. The centre distance must lie between {{}} mm and {{}} mm",
                  v.radius, c.radius, v.b, c.b));
          continue;
        }
        ArcMeshInput nominal = in;
        nominal.center_distance = pair.reference_center_distance;
        ArcPairContact contact{by_gear_2 ? 2 : 1, arc_contact(in, *theta), contact_angle(nominal)};
        place(contact.at, convex, by_gear_2, pair.center_distance);
        pair.contacts.push_back(contact);
      }
    }
  }
  if (!pair.contacts.empty()) return std::nullopt;
  if (reason) return reason;
  return Error{gear_field(2, "rack"), "",
               "no convex flank of one gear touches a concave flank of the other gear; combine "
               "racks F and P, or use the same double-arc rack for both gears"};
}

// Returns the greatest distance along z between neighbouring contact points. The positions of the
// contact points repeat with the axial pitch.
double longest_gap(const ArcPair& pair) {
  const CylindricalSpec& s = pair.gears[0].spec;
  const double p_x = kPi * s.normal_module / std::sin(std::abs(s.helix_angle.rad()));
  std::vector<double> z;
  for (const ArcPairContact& c : pair.contacts)
    z.push_back(c.at.point.z() - p_x * std::floor(c.at.point.z() / p_x));
  if (z.empty()) return p_x;
  std::sort(z.begin(), z.end());
  double longest = z.front() + p_x - z.back();
  for (std::size_t i = 1; i < z.size(); ++i) longest = std::max(longest, z[i] - z[i - 1]);
  return longest;
}

void find_backlash(ArcPair& pair) {
  if (pair.contacts.empty()) return;
  const ArcPairContact& first = pair.first_contact();
  const Angle play = -2 * first.at.rotation_offset;  // play of the concave gear; the flanks of both
                                                     // sides are equal
  const double z_1 = pair.gears[0].spec.teeth, z_2 = pair.gears[1].spec.teeth;
  const Angle of_gear_2 = first.convex_gear == 1 ? play : z_1 * play / z_2;
  pair.backlash_rotation = std::array{z_2 * of_gear_2 / z_1, of_gear_2};
  // Turning gear 2 by dφ moves its flank along the normal by dφ (ẑ × r)·n.
  const Vec3 r = first.at.point - Vec3(pair.center_distance, 0.0, 0.0);
  const double lever = std::abs(r.x() * first.at.normal.y() - r.y() * first.at.normal.x());
  pair.base_backlash = of_gear_2.rad() * lever;
}

void warn(ArcPair& pair, WarningCode code, std::string message) {
  pair.warnings.push_back({code, std::move(message), 0});
}

void warn_about_contact(ArcPair& pair, const ArcPairContact& c) {
  const Gear& convex = pair.gears[c.convex_gear == 1 ? 0 : 1];
  const Gear& concave = pair.gears[c.convex_gear == 1 ? 1 : 0];
  const std::string where = fmt::format("convex flank of gear {}", c.convex_gear);
  if (!(c.at.gap[0] > 0.0)) {
    warn(pair, WarningCode::interference,
         fmt::format("At the {} the surfaces cut into each other, because the radii of the arcs "
                     "differ by too little. The relative curvatures are {:.4g} and {:.4g} per mm.",
                     where, c.at.gap[0], c.at.gap[1]));
  }
  const auto off = [&](const Gear& gear, double side, double radius) {
    const auto form = gear.root_form_radius();
    return !has_angle(gear, side, c.at.theta) || !form || radius < *form ||
           radius > gear.tip_form_radius();
  };
  if (off(convex, 1.0, c.at.radius_convex) || off(concave, -1.0, c.at.radius_concave)) {
    warn(pair, WarningCode::contact_off_flank,
         fmt::format(
             "The contact on the {}, at a normal angle of {:.4f}°, lies outside the usable flanks, "
             "so an edge of a tooth touches. The reference centre distance is {:.4f} mm.",
             where, c.at.theta.deg(), pair.reference_center_distance));
  }
  for (const int which : {1, 2}) {
    const Gear& gear = pair.gears[which - 1];
    std::optional<Angle> written;
    if (const auto* rack = std::get_if<ArcRack>(&gear.spec.rack)) {
      written = rack->pressure_angle;
    } else if (const auto* rack_2 = std::get_if<DoubleArcRack>(&gear.spec.rack)) {
      written = rack_2->pressure_angle;
    }
    if (!written) continue;
    if (c.nominal_theta && abs(*written - *c.nominal_theta) <= kSamePressureAngle) continue;
    const std::string is = c.nominal_theta
                               ? fmt::format("the flanks touch at {:.4f}°", c.nominal_theta->deg())
                               : "the flanks have no common normal";
    pair.warnings.push_back(
        {WarningCode::pressure_angle,
         fmt::format("The given pressure angle of the rack is {:.4f}°, but with the given radii "
                     "and centres, {} at the reference centre distance.",
                     written->deg(), is),
         which});
  }
}

void warn_about_pair(ArcPair& pair) {
  for (const ArcPairContact& c : pair.contacts) warn_about_contact(pair, c);
  const CylindricalSpec &s_1 = pair.gears[0].spec, &s_2 = pair.gears[1].spec;
  if (pair.contacts.empty()) {
    warn(pair, WarningCode::unequal_lead,
         fmt::format("The gears do not have matching leads (modules {}\u00a0mm and {}\u00a0mm, "
                     "helix angles {}° and {}°). Their teeth have no contact point that moves "
                     "along the face, and results that depend on such a point are omitted.",
                     s_1.normal_module, s_2.normal_module, s_1.helix_angle.deg(),
                     s_2.helix_angle.deg()));
  }
  const double face = std::min(s_1.face_width, s_2.face_width);
  if (!pair.contacts.empty() && face < pair.face_for_contact) {
    warn(pair, WarningCode::contact_ratio,
         fmt::format("Contact is not continuous, because the common face width of {:.4f} mm is "
                     "less than the spacing of the contact points, {:.4f} mm.",
                     pair.whole_face(face), pair.whole_face(pair.face_for_contact)));
  }
  if (pair.backlash_rotation && pair.base_backlash <= -no_backlash(s_1.normal_module)) {
    warn(pair, WarningCode::negative_backlash,
         fmt::format(
             "The teeth are too thick for this centre distance; the normal backlash is {:.4f} mm.",
             pair.normal_backlash()));
  }
  for (const int which : {1, 2}) {
    const double c = pair.tip_clearance[which - 1];
    if (c > 0.0) continue;
    pair.warnings.push_back(
        {WarningCode::root,
         fmt::format("The tip of gear {} reaches {:.4f} mm below the root circle of gear {}.",
                     which, -c, 3 - which),
         3 - which});
  }
}

}  // namespace

std::vector<WorkingArc> convex_arcs(const Gear& gear) { return working(gear, 1.0); }
std::vector<WorkingArc> concave_arcs(const Gear& gear) { return working(gear, -1.0); }

double ArcPair::contact_ratio() const {
  return overlap_ratio * static_cast<double>(std::max<std::size_t>(1, contacts.size()));
}

std::array<double, 2> ArcPair::working_pitch_diameter() const {
  const double z_1 = gears[0].spec.teeth, z_2 = gears[1].spec.teeth;
  return {2 * center_distance * z_1 / (z_1 + z_2), 2 * center_distance * z_2 / (z_1 + z_2)};
}

double ArcPair::normal_backlash() const {
  return base_backlash / std::cos(first_contact().at.theta.rad());
}

StatedBacklash ArcPair::stated_backlash() const {
  const double module = gears[0].spec.normal_module;
  if (!backlash_rotation) return {0.0, 1.0, center_distance, module};
  return {normal_backlash(), std::cos(first_contact().at.theta.rad()), center_distance, module};
}

const ArcPairContact& ArcPair::first_contact() const {
  GW_EXPECTS(!contacts.empty());
  // Converts the offset to a rotation of gear 2. The offsets of all contacts can then be compared.
  const auto ahead = [&](const ArcPairContact& c) {
    return c.convex_gear == 1 ? c.at.rotation_offset : c.at.rotation_offset / gear_ratio();
  };
  return *std::max_element(contacts.begin(), contacts.end(),
                           [&](const auto& a, const auto& b) { return ahead(a) < ahead(b); });
}

Result<ArcPair> mount_arcs(Gear gear_1, Gear gear_2, std::optional<double> distance) {
  ArcPair pair{};
  pair.gears = {std::move(gear_1), std::move(gear_2)};
  if (auto error = check_gears(pair.gears)) return *error;
  pair.reference_center_distance = pitch_radius(pair.gears[0]) + pitch_radius(pair.gears[1]);
  pair.center_distance = distance.value_or(pair.reference_center_distance);
  if (of_one_lead(pair.gears)) {
    if (auto error = find_contacts(pair)) return *error;
  }
  const CylindricalSpec &s_1 = pair.gears[0].spec, &s_2 = pair.gears[1].spec;
  // ε_β = b sin |β|/(π m_n). [T7.11]
  pair.overlap_ratio = std::min(s_1.face_width, s_2.face_width) *
                       std::sin(std::abs(s_1.helix_angle.rad())) / (kPi * s_1.normal_module);
  pair.face_for_contact = longest_gap(pair);
  for (const std::size_t i : {0, 1}) {
    pair.tip_clearance[i] = pair.center_distance - pair.gears[i].actual_tip_radius() -
                            pair.gears[1 - i].root_diameter / 2;
  }
  find_backlash(pair);
  // If the leads match, all transverse sections have the same outline, but at different rotations.
  // A comparison of the outlines in one section is therefore valid for the whole bodies.
  if (pair.backlash_rotation) {
    detail::find_collisions(pair, pair.backlash_rotation->at(1).rad() / 2, pair.base_backlash);
    // Negative backlash and tips that cut into roots have their own warnings.
    for (const Collision& s : *pair.overlap) {
      if (s.cause != CollisionCause::negative_backlash && s.cause != CollisionCause::root)
        pair.warnings.push_back({WarningCode::overlap, s.message, s.gear});
    }
    for (const Collision& s : pair.beyond_flank)
      pair.warnings.push_back({WarningCode::beyond_flank, s.message, s.gear});
  }
  warn_about_pair(pair);
  return pair;
}

}  // namespace gearwright
