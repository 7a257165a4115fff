#include "gearwright/catalogue/pair_parts.hpp"

#include <algorithm>
#include <cmath>

#include "gearwright/base/units.hpp"
#include "gearwright/pair/drive.hpp"

namespace gearwright {

namespace {

double amount(const Interference& i) {
  const auto* angle = std::get_if<Angle>(&i.amount);
  return angle ? angle->rad() : std::get<double>(i.amount);
}

struct PathPoint {
  const InvolutePair* pair;
  double rho1;
};

void add_path_point(Quantities<PathPoint>& q) {
  using P = PathPoint;
  q.number("from_A_mm", "distance from A", "", "distance along the line of action",
           [](const P& p) { return (p.rho1 - p.pair->mesh.rho1_A) / p.pair->mesh.line_cosine; });
  q.number("from_pitch_point_mm", "distance from the pitch point", "",
           "distance along the line of action",
           [](const P& p) { return (p.rho1 - p.pair->mesh.rho1_C) / p.pair->mesh.line_cosine; });
  q.number("rho1_mm", "radius of curvature, gear 1", "ρ_1", "of the transverse profile", &P::rho1);
  q.number("rho2_mm", "radius of curvature, gear 2", "ρ_2", "of the transverse profile",
           [](const P& p) { return p.pair->mesh.rho2(p.rho1); });
  q.term("point_mm", "in the housing frame",
         [](const P& p) { return p.pair->on_line_of_action(p.rho1).r; });
}

const Quantities<PathPoint>& path_point_quantities() {
  return define<add_path_point>("pair.path point");
}

// Returns one part of the sliding velocity at A, at the pitch point of gear 1 and at E, mm per
// radian of gear 1. `part` computes it from the velocities across and along the teeth.
std::array<double, 3> sliding_at_A_C_E(const InvolutePair& p,
                                       double (*part)(double across, double along)) {
  const auto at = [&](double rho1) {
    const FlankSpeeds<double> w = flank_speeds(p.input, p.mesh, rho1);
    return part(w.across[0] - w.across[1], w.along[0] - w.along[1]);
  };
  return {at(p.mesh.rho1_A), at(p.mesh.rho1_C), at(p.mesh.rho1_E)};
}

template <Unit unit>
void add_two_gears(Quantities<std::array<Value, 2>>& q) {
  for (const std::size_t i : {0, 1}) {
    const std::string gear = std::to_string(i + 1);
    q.term(("gear" + gear).c_str(), ("of gear " + gear).c_str(),
           [i](const std::array<Value, 2>& a) { return a[i]; })
        .list({2})
        .unit(unit);
  }
}

}  // namespace

const Quantities<std::array<Value, 2>>& two_gears() {
  return define<add_two_gears<Unit::none>>("two gears");
}

const Quantities<std::array<Value, 2>>& two_gears_mm() {
  return define<add_two_gears<Unit::mm>>("two lengths");
}

const Quantities<CrossedPlace>& place_quantities() {
  using P = CrossedPlace;
  return define("place", [](Quantities<P>& q) {
    q.term("center_distance_mm", "without backlash", &P::center_distance);
    q.term("shaft_angle_deg", "in this position", &P::shaft_angle);
    q.term("working_normal_pressure_angle_deg", "in this position", &P::normal_pressure_angle);
  });
}

const Quantities<CrossedPlaces>& places_quantities() {
  using P = CrossedPlaces;
  return define("places", [](Quantities<P>& q) {
    const char* ends = "[at the least α_wn, at the greatest α_wn]";
    q.term("working_normal_pressure_angle_deg", ends, [](const P& p) {
       return std::array{p.lo.normal_pressure_angle, p.hi.normal_pressure_angle};
     }).ends();
    q.term("center_distance_mm", ends,
           [](const P& p) {
             return std::array{p.lo.center_distance, p.hi.center_distance};
           })
        .words("centre distances at both ends of the range of α_wn")
        .ends();
    q.term("shaft_angle_deg", ends,
           [](const P& p) {
             return std::array{p.lo.shaft_angle, p.hi.shaft_angle};
           })
        .words("shaft angles at both ends of the range of α_wn")
        .ends();
    q.flag("ends_at_90_deg_helix", "limited by a helix angle of 90°",
           "true if the interval ends because a helix angle reaches 90°", &P::limit)
        .doors(kJson);
  });
}

const Quantities<LineView>& line_quantities() {
  using L = LineView;
  return define("pair.line of action", [](Quantities<L>& q) {
    const auto ends = [](const std::array<Vec3, 2>& line) { return ValueList{line[0], line[1]}; };
    q.number("length_mm", "length of path of contact", "g_α",
             "for crossed axes the distance AE along the line of action, and for circular arcs the "
             "common face width; 0 if the usable flanks do not meet",
             &L::length);
    q.number("leading", "leading line of action", "",
             "points [A, E]; for parallel axes in the section z = 0",
             [ends](const L& l) { return ends(l.leading); })
        .unit(Unit::mm)
        .list({2, 3})
        .doors(kJson);
    q.number("trailing", "trailing line of action", "", "points [A′, E′]",
             [ends](const L& l) { return ends(l.trailing); })
        .unit(Unit::mm)
        .list({2, 3})
        .doors(kJson);
    q.text("unit", "unit of the points, spelled as in keys", [](const L&) { return "mm"; });
  });
}

namespace {

std::optional<LineView> line_between(const InvolutePair& p) {
  return LineView{p.path_length(),
                  {p.on_line_of_action(p.mesh.rho1_A).r, p.on_line_of_action(p.mesh.rho1_E).r},
                  {p.on_trailing_line(p.mesh.rho1_A).r, p.on_trailing_line(p.mesh.rho1_E).r}};
}

// Returns the path of the first contact over the common face. The path of the non-working flanks is
// this path, rotated by 180° about the centre line.
std::optional<LineView> line_between(const ArcPair& p) {
  if (p.contacts.empty()) return std::nullopt;
  const Vec3 at = p.first_contact().at.point;
  const double face = std::min(p.gears[0].spec.face_width, p.gears[1].spec.face_width);
  const double half = face / 2 * (p.gears[0].spec.helix_angle.rad() > 0.0 ? 1.0 : -1.0);
  return LineView{face,
                  {Vec3(at.x(), at.y(), -half), Vec3(at.x(), at.y(), half)},
                  {Vec3(at.x(), -at.y(), half), Vec3(at.x(), -at.y(), -half)}};
}

std::vector<InterferenceView> interference_between(const InvolutePair& p) {
  std::vector<InterferenceView> list;
  for (const Interference& i : p.interference)
    list.push_back({i.code, i.gear, amount(i), i.message});
  return list;
}

std::vector<InterferenceView> interference_between(const ArcPair& p) {
  std::vector<InterferenceView> list;
  for (const Warning& w : p.warnings) {
    if (w.code == WarningCode::root || w.code == WarningCode::interference ||
        w.code == WarningCode::overlap)
      list.push_back({w.code, w.gear, std::nullopt, w.message});
  }
  return list;
}

}  // namespace

std::optional<LineView> line_of(const Pair& v) {
  return v.visit([](const auto& p) { return line_between(p); });
}

std::vector<InterferenceView> interference_of(const Pair& v) {
  return v.visit([](const auto& p) { return interference_between(p); });
}

const Quantities<InvolutePair>& path_quantities() {
  return define("pair.path", [](Quantities<InvolutePair>& q) {
    const auto point = [&q](const char* key, const char* meaning, auto rho1) {
      q.record<path_point_quantities>(key, meaning, [rho1](const InvolutePair& p) {
        return path_point_quantities().of({&p, p.mesh.*rho1});
      });
    };
    point("A", "start of contact, at the tip of gear 2", &Mesh<double>::rho1_A);
    point("B", "one pitch before E", &Mesh<double>::rho1_B);
    point("C", "pitch point; for crossed axes, the pitch point of gear 1", &Mesh<double>::rho1_C);
    point("D", "one pitch after A", &Mesh<double>::rho1_D);
    point("E", "end of contact, at the tip of gear 1", &Mesh<double>::rho1_E);
  });
}

const Quantities<PairBacklash>& backlash_quantities() {
  using B = PairBacklash;
  return define("pair.backlash", [](Quantities<B>& q) {
    q.term("normal_base_mm", "along the common normal", &B::normal_base);
    q.term("normal_mm", "j_bn/cos α_wn", &B::normal);
    q.term("circumferential_mm", "per gear, at the working pitch circles", &B::circumferential)
        .per_gear();
    q.number("rotation_deg", "angular backlash with the mating gear fixed", "j_φ", "per gear",
             &B::rotation)
        .per_gear();
    q.number("free_rotation_deg", "free play with the mating gear fixed", "",
             "per gear, rotation without any contact; less than the backlash if other parts of the "
             "teeth touch before the flanks. The rotation is null if a tip lies inside a root, or "
             "if the rotation is not computed, for example on crossed axes with an internal gear",
             [](const B& b) {
               if (!b.free) return Value();
               return Value(std::array{b.free->at(0).deg(), b.free->at(1).deg()});
             })
        .per_gear()
        .shown([](const B& b) {
          constexpr double kSame = 1e-9;
          return b.free && std::abs(b.free->at(1).rad() - b.rotation[1].rad()) > kSame;
        });
  });
}

const Quantities<ParallelPair>& needed_face_quantities() {
  using P = ParallelPair;
  using Face = std::optional<double> (*)(const P&);
  return define("pair.needed face width", [](Quantities<P>& q) {
    // Adds the face width of the teeth and, for double-helical gears, also that of the whole gear.
    const auto add = [&q](const char* key, const char* whole_key, const char* words,
                          const char* meaning, Face face) {
      const auto worth = [face](const P& p) { return face(p).value_or(0.0) > 0.0; };
      q.number(key, words, "b", meaning, face).unit(Unit::mm).shown([worth](const P& p) {
        return worth(p) && !p.gears[0].gap;
      });
      q.number(whole_key, words, "b", "face width including both halves and the gap",
               [face](const P& p) {
                 const auto half = face(p);
                 return half && *half > 0.0 ? std::optional(p.whole_face(*half)) : half;
               })
          .unit(Unit::mm)
          .when([](const P& p) { return p.gears[0].gap.has_value(); })
          .shown(worth);
    };
    add("total_1", "whole_total_1", "face width for a total contact ratio of 1",
        "null for a spur pair whose transverse contact ratio is below 1",
        [](const P& p) { return face_width_for_total(p, 1.0); });
    add("total_1_2", "whole_total_1_2", "face width for a total contact ratio of 1.2",
        "null for a spur pair whose transverse contact ratio is below 1.2",
        [](const P& p) { return face_width_for_total(p, 1.2); });
    add("overlap_1", "whole_overlap_1", "face width for an overlap ratio of 1",
        "null for spur pairs", face_width_for_overlap);
  });
}

const Quantities<InvolutePair>& sliding_velocity_quantities() {
  return define("pair.sliding velocity", [](Quantities<InvolutePair>& q) {
    const auto at = [&q](const char* key, const char* meaning, double (*part)(double, double)) {
      q.number(key, key, "", meaning, [part](const InvolutePair& p) {
         return sliding_at_A_C_E(p, part);
       }).unit(Unit::mm_per_rad);
    };
    at("across_teeth", "[at A, at C, at E]; on parallel axes in the transverse section",
       [](double across, double) { return across; });
    at("along_teeth", "[at A, at C, at E]; 0 on parallel axes",
       [](double, double along) { return along; });
    at("total", "[at A, at C, at E]; resultant of `across_teeth` and `along_teeth`",
       [](double across, double along) { return std::hypot(across, along); });
  });
}

const Quantities<Efficiency>& efficiency_quantities() {
  using E = Efficiency;
  return define("pair.efficiency", [](Quantities<E>& q) {
    q.number("gear1_drives", "efficiency, gear 1 driving", "η",
             "output power divided by input power; null if self-locking", &E::gear1_drives)
        .unit(Unit::percent);
    q.number("gear2_drives", "efficiency, gear 2 driving", "η",
             "output power divided by input power; null if self-locking", &E::gear2_drives)
        .unit(Unit::percent);
  });
}

const Quantities<InternalMargins>& internal_quantities() {
  using M = InternalMargins;
  return define("pair.internal", [](Quantities<M>& q) {
    q.under(kMargins);
    q.number("involute_margin_mm", "involute interference, distance on the pinion flank", "",
             "from the form point of the pinion to the start of the path of contact [T2.27]; "
             "negative if the tip of the internal gear reaches below the form point; null "
             "if the pinion has no form point",
             &M::involute);
    q.number("trochoid_margin_deg", "trochoid interference, play when the tips pass each other", "",
             "[T2.27]; computed for sharp tips without backlash; negative if the tips collide; "
             "null if the tip circles do not intersect",
             &M::trochoid);
    q.number("trimming_margin_deg", "trimming interference, play in radial assembly", "",
             "[T2.28]; negative if only axial assembly is possible; null if there is no limit to "
             "radial assembly",
             &M::trimming);
  });
}

const Quantities<InterferenceView>& interference_quantities() {
  using I = InterferenceView;
  return define("pair.interference", [](Quantities<I>& q) {
    q.text("code", "code for programs; it never changes",
           [](const I& i) { return to_string(i.code); });
    q.term("gear", "gear whose root or tip is affected; null if both gears are affected",
           [](const I& i) { return i.gear ? Value(i.gear) : Value(); });
    q.number("amount", "amount", "", "margin in `unit`; negative if the parts interfere",
             &I::amount)
        .when([](const I& i) { return i.amount.has_value(); });
    q.text("unit", "unit of the amount, spelled as in keys; the amount of `trochoid` is an angle",
           [](const I& i) { return i.code == WarningCode::trochoid ? "rad" : "mm"; })
        .when([](const I& i) { return i.amount.has_value(); });
    q.text("message", "sentence for users", &I::message);
  });
}

std::array<std::optional<double>, 2> needed_crowning_um(const CrossedPair& pair) {
  auto needed = pair.needed_crowning;
  for (auto& crowning : needed)
    if (crowning) *crowning *= kUmPerMm;
  return needed;
}

const Quantities<Collision>& collision_quantities() {
  using S = Collision;
  return define("pair.collision", [](Quantities<S>& q) {
    const auto at = [](auto get) {
      return [get](const S& s) { return s.touch ? std::optional(get(*s.touch)) : std::nullopt; };
    };
    q.text("cause", "code for programs; it never changes",
           [](const S& s) { return to_string(s.cause); });
    q.term("gear",
           "gear with the affected root or the projecting tip; null if both gears are affected",
           [](const S& s) { return s.gear ? Value(s.gear) : Value(); });
    q.number("depth_mm", "depth", "",
             "depth of an overlap along the common normal, if the gears are in the middle of their "
             "play; for contact beyond the flank, the remaining distance between the flanks",
             &S::depth);
    q.text("arcs", "names of the arcs of gear 1 and gear 2 that touch, as in `outline`",
           at([](const OutlineTouch& t) {
             return ValueList{std::string(to_string(t.places[0].arc)),
                              std::string(to_string(t.places[1].arc))};
           }))
        .list({2});
    q.flag("corners", "contact at an end of the arc",
           "for gear 1 and gear 2, true if an end of the arc touches",
           at([](const OutlineTouch& t) {
             return ValueList{t.places[0].corner, t.places[1].corner};
           }))
        .list({2});
    q.number("rotation1_deg", "rotation of gear 1", "",
             "rotation of gear 1 at the contact, within half a pitch",
             at([](const OutlineTouch& t) { return Angle::radians(t.rotation_1).deg(); }));
    q.term("point_mm", "in the housing frame",
           at([](const OutlineTouch& t) { return Vec3(t.point.x(), t.point.y(), t.height); }));
    q.text("message", "sentence for users", &S::message);
  });
}

// The helix angle is greater on a larger cylinder, because tan β is proportional to the radius.
double working_helix(const ArcPair& p, std::size_t i) {
  const Gear& g = p.gears[i];
  return std::atan(std::tan(g.spec.helix_angle.rad()) * p.working_pitch_diameter()[i] /
                   g.reference_diameter);
}

// Returns the normal angle of the rack at the first contact, converted to the transverse section.
double working_transverse(const ArcPair& p, std::size_t i) {
  return std::atan(std::tan(p.first_contact().at.theta.rad()) /
                   std::cos(p.gears[i].spec.helix_angle.rad()));
}

}  // namespace gearwright
