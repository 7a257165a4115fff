// The quantities of a contact between circular-arc teeth. The record of a pair contains them under
// `arc_contacts`.
#include <cmath>

#include "gearwright/catalogue/pair_parts.hpp"

namespace gearwright {

namespace {

constexpr double kMarking = 0.00635;  // mm, thickness of the marking compound for the ellipse

// Returns the semi-axis, mm, of the area in which the gap is smaller than the thickness of the
// marking compound. k is the curvature of the gap along the axis, 1/mm. Returns null if k ≤ 0,
// because the flanks then interfere or the gap does not open.
Value semi_axis(double k) { return k > 0.0 ? Value(std::sqrt(2 * kMarking / k)) : Value(); }

Value tensor(const Mat2& k) {
  return ValueList{ValueList{k(0, 0), k(0, 1)}, ValueList{k(1, 0), k(1, 1)}};
}

bool convex_first(const ArcContactView& c) { return c.contact->convex_gear == 1; }

// Returns the values for gear 1 and gear 2, given the values for the convex and the concave flank.
template <class T>
std::array<T, 2> by_gear(const ArcContactView& c, const T& convex, const T& concave) {
  return convex_first(c) ? std::array{convex, concave} : std::array{concave, convex};
}

using C = ArcContactView;

const Quantities<C>& tensor_quantities() {
  return define("pair.arc_contacts curvature", [](Quantities<C>& q) {
    const auto of_gear = [](std::size_t i) {
      return [i](const C& c) {
        const ArcContact& at = c.contact->at;
        return tensor(by_gear(c, at.curvature_convex, at.curvature_concave)[i]);
      };
    };
    q.number("gear1", "curvature of gear 1", "K", "components in (t, u) [T7.14]", of_gear(0))
        .unit(Unit::per_mm)
        .list({2, 2});
    q.number("gear2", "curvature of gear 2", "K", "components in (t, u) [T7.14]", of_gear(1))
        .unit(Unit::per_mm)
        .list({2, 2});
  });
}

const Quantities<ArcContact>& arc_quantities() {
  using A = ArcContact;
  return define("pair.arc_contacts ellipse", [](Quantities<A>& q) {
    q.term("marking_mm", "the ellipse is computed for this thickness", [](const A&) {
       return kMarking;
     }).doors(kJson);
    q.number("semi_major_mm", "semi-major axis of the contact ellipse", "",
             "null if the flanks interfere in this direction",
             [](const A& a) { return semi_axis(a.gap[0]); });
    q.number("semi_minor_mm", "semi-minor axis of the contact ellipse", "",
             "null if the flanks interfere in this direction",
             [](const A& a) { return semi_axis(a.gap[1]); });
    q.number("angle_deg", "direction of the ellipse's major axis", "",
             "angle about the flank normal; 0 along the projection of axis 1 onto the tangent "
             "plane",
             &A::angle);
  });
}

const Quantities<ArcContact>& radius_quantities() {
  using A = ArcContact;
  return define("pair.arc_contacts radius", [](Quantities<A>& q) {
    q.number("convex", "radius of the convex profile in the transverse section", "ρ",
             "at the contact on the convex flank", &A::transverse_radius_convex)
        .unit(Unit::mm);
    q.number("concave", "radius of the concave profile in the transverse section", "ρ",
             "at the contact on the concave flank", &A::transverse_radius_concave)
        .unit(Unit::mm);
  });
}

void add_arc_contact(Quantities<C>& q) {
  const auto at = [](auto get) {
    return [get](const C& c) -> decltype(auto) { return std::invoke(get, c.contact->at); };
  };
  q.whole("convex_gear", "gear with the convex flank", "", "1 or 2",
          [](const C& c) { return c.contact->convex_gear; });
  q.number("rack_angle_deg", "normal angle of the racks", "θ", "at the contact",
           at(&ArcContact::theta));
  q.number("nominal_rack_angle_deg", "normal angle at the reference centre distance", "θ_0",
           "[T7.9]; null if the flanks do not touch at the reference centre distance",
           [](const C& c) {
             const auto& theta = c.contact->nominal_theta;
             return theta ? Value(theta->deg()) : Value();
           });
  q.number("point_mm", "point of contact at rotation 0", "x, y, z", "in the housing frame",
           at(&ArcContact::point));
  q.term("normal", "unit vector that points out of gear 1", at(&ArcContact::normal)).doors(kJson);
  q.number("contact_diameter_mm", "diameter of contact", "", "per gear", [](const C& c) {
     const ArcContact& a = c.contact->at;
     return by_gear(c, 2 * a.radius_convex, 2 * a.radius_concave);
   }).per_gear();
  q.number(
       "rotation2_offset_deg", "rotation of gear 2 at the contact", "",
       "angle by which gear 2 is ahead of gear 1 when the two flanks of this contact touch [T7.18]",
       [](const C& c) {
         const Angle offset = c.contact->at.rotation_offset;
         return (convex_first(c) ? offset : offset / c.pair->gear_ratio()).deg();
       })
      .doors(kJson);
  q.record<tensor_quantities>("curvature_per_mm", "curvatures of both flanks").doors(kJson);
  q.term("gap_curvature_per_mm", "k1 ≤ k2; k1 is 0 or negative if the flanks interfere",
         at(&ArcContact::gap))
      .words("relative curvatures")
      .list({2});
  q.record<arc_quantities>("ellipse", "the contact ellipse under the marking compound",
                           at(std::identity{}));
  q.record<radius_quantities>("transverse_radius_mm", "radii of the transverse profiles",
                              at(std::identity{}));
  q.number("transverse_radius_difference_mm", "difference of the transverse radii", "Δρ",
           "radius of the concave profile minus radius of the convex profile",
           at([](const ArcContact& a) {
             return a.transverse_radius_concave - a.transverse_radius_convex;
           }));
  q.number("line_contact_radius_difference_mm",
           "difference of the transverse radii for line contact", "", "[T7.10]",
           at(&ArcContact::line_contact_difference))
      .or_null();
}

}  // namespace

const Quantities<ArcContactView>& arc_contact_quantities() {
  return define<add_arc_contact>("pair.arc_contacts");
}

std::vector<ArcContactView> arc_contacts_of(const ArcPair& pair) {
  std::vector<ArcContactView> list;
  for (const ArcPairContact& c : pair.contacts) list.push_back({&pair, &c});
  return list;
}

}  // namespace gearwright
