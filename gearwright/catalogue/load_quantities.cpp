#include "gearwright/catalogue/load_quantities.hpp"

#include "gearwright/base/units.hpp"

namespace gearwright {

namespace {

using T = LoadTorqueView;
using P = LoadPositionView;
using S = LoadedTorque::Stiffness;

constexpr const char* kLoad = "Teeth under load";

template <Unit unit>
void add_stiffness(Quantities<S>& q) {
  q.number("mean", "mesh stiffness", "", "mesh stiffness at the mean approach over the positions",
           &S::mean)
      .or_null()
      .unit(unit);
  q.number("min", "least mesh stiffness", "", "", &S::min).or_null().unit(unit);
  q.number("max", "greatest mesh stiffness", "", "", &S::max).or_null().unit(unit);
}
const Quantities<S>& stiffness_quantities() {
  return define<add_stiffness<Unit::newton_per_mm_um>>("load.torques stiffness");
}
const Quantities<S>& point_stiffness_quantities() {
  return define<add_stiffness<Unit::newton_per_um>>("load.torques point stiffness");
}

bool at_points(const P& p) { return p.regime == LoadRegime::point; }
bool has_points(const T& t) { return t.all->regime == LoadRegime::point; }
bool on_lines(const T& t) { return t.all->regime == LoadRegime::line; }

bool on_shafts(const T& t) { return t.torque->shafts.has_value(); }

ValueList shares(const LoadedPosition& p) {
  ValueList list;
  for (const LoadedPair& pair : p.pairs) list.push_back(Value(pair.share));
  return list;
}

ValueList numbers(const Eigen::VectorXd& all) {
  ValueList list;
  for (const double v : all) list.push_back(Value(v));
  return list;
}

const LoadedPosition* position_of(const P& p) { return p.position; }

void add_load_position(Quantities<P>& q) {
  auto of_position = q.part(position_of);
  q.term("torque_Nm", "on gear 1", [](const P& p) { return newton_metres(p.torque->torque); });
  q.term("rotation1_deg", "clockwise seen from +z",
         [](const P& p) { return p.position->rotation1; });
  of_position
      .term("transmission_error_arcsec",
            "transmission error as in `contact` minus the deflection of gear 2. This value and all "
            "other results of a position are null if no teeth touch or the forces do not converge",
            &LoadedPosition::te)
      .words("loaded transmission error");
  q.number("approach_um", "approach under load", "Θ r_b2",
           "approach of the flanks relative to the first contact without load, along the line of "
           "action in the transverse section or, for point contact, along the normals; the "
           "approach includes the deflection of the flanks and the twist of the bodies, but not "
           "the displacement of the axes when the shafts deflect under this load",
           [](const P& p) { return p.position->approach * kUmPerMm; })
      .or_null();
  q.number(
      "share", "load shares", "",
      "share of each loaded tooth pair, beginning with the pair that came into contact last. For "
      "point contact, the share of each contact point",
      [](const P& p) { return shares(*p.position); });
  of_position.term("max_pressure_MPa", "Hertz pressure; a lower bound if `kind` is an edge",
                   &LoadedPosition::max_pressure);
  of_position
      .number("root_stress_MPa", "greatest root stress", "",
              "greatest principal stress along the fillets, per gear", &LoadedPosition::root_stress)
      .per_gear();
  q.record<load_point_quantities>(
       "points", "the loaded points in the order of `share`; double-arc teeth touch at two points",
       [](const P& p) -> const auto& { return p.position->pairs; })
      .when(at_points)
      .doors(kJson);
  q.word("kind", "kind of the contact with the greatest pressure",
         "`line` is a contact line, `interior` is a point inside the flanks, and all other kinds "
         "are loaded edges",
         [](const P& p) {
           return p.position->kind == TouchKind::none ? Value()
                                                      : Value(to_string(p.position->kind));
         })
      .one_of({"line", "interior", "tip1", "tip2", "form1", "form2", "face1", "face2", "ridge",
               "corner"});
}

bool has_standard(const T& t) { return t.standard.has_value(); }
bool has_nominal(const T& t) { return has_standard(t) && t.standard->root_stress; }

const LoadedTorque* torque_of(const T& t) { return t.torque; }

void add_loaded_error(Quantities<T>& q) {
  auto of_torque = q.part(torque_of);
  q.under(kLoad);
  q.term("torque_Nm", "on gear 1", [](const T& t) { return newton_metres(t.torque->torque); });
  q.record<load_position_quantities>("positions",
                                     "one entry for each position, in the order of the rotations",
                                     [](const T& t) {
                                       std::vector<P> all;
                                       for (const LoadedPosition& p : t.torque->positions)
                                         all.push_back({t.torque, &p, t.all->regime});
                                       return all;
                                     })
      .doors(kJson);
  of_torque
      .term("peak_to_peak_arcsec", "over the positions with a result", &LoadedTorque::peak_to_peak)
      .words("loaded transmission error, peak to peak");
  q.term("harmonics_arcsec",
         "amplitudes at orders 1, 2, … of the mesh frequency, at most 20; empty if `rotation1_deg` "
         "is given or a position has no result",
         [](const T& t) { return t.torque->harmonics; })
      .doors(kJson);
}

void add_mesh_stiffness(Quantities<T>& q) {
  auto of_torque = q.part(torque_of);
  of_torque
      .record<stiffness_quantities>(
          "mesh_stiffness_N_per_mm_um",
          "secant stiffness of the mesh: line load divided by approach, including the twist of the "
          "bodies",
          &LoadedTorque::stiffness)
      .when(on_lines);
  of_torque
      .record<stiffness_quantities>(
          "mesh_stiffness_without_twist_N_per_mm_um",
          "secant stiffness of the mesh without the twist of the bodies from bore to root [T12.16]",
          &LoadedTorque::without_twist)
      .when(on_lines)
      .doors(kJson);
  of_torque
      .record<stiffness_quantities>("tangent_stiffness_N_per_mm_um",
                                    "mesh stiffness for small changes of the torque",
                                    &LoadedTorque::tangent)
      .when(on_lines)
      .doors(kJson);
  of_torque
      .record<point_stiffness_quantities>("contact_stiffness_N_per_um",
                                          "secant stiffness for point contact: force divided by "
                                          "approach along the normals, including "
                                          "the twist of the bodies",
                                          &LoadedTorque::stiffness)
      .when(has_points);
  of_torque
      .record<point_stiffness_quantities>(
          "tangent_contact_stiffness_N_per_um",
          "stiffness for point contact and small changes of the torque", &LoadedTorque::tangent)
      .when(has_points)
      .doors(kJson);
  q.number("c_gamma_alpha", "mesh stiffness by ISO 6336-1", "c_γα",
           "method B, for solid discs [T11.3]",
           [](const T& t) { return has_standard(t) ? Value(t.standard->stiffness) : Value(); })
      .unit(Unit::newton_per_mm_um)
      .when(has_standard);
  q.number("stiffness_over_c_gamma_alpha",
           "mean stiffness without twist, divided by c_γα of ISO 6336-1", "",
           "mean mesh stiffness without twist, divided by `c_gamma_alpha`; the "
           "standard does not include the twist of the bodies",
           [](const T& t) {
             return has_standard(t) ? Value(t.torque->without_twist.mean / t.standard->stiffness)
                                    : Value();
           })
      .when(has_standard);
}

void add_stresses(Quantities<T>& q) {
  auto of_torque = q.part(torque_of);
  of_torque.term("max_pressure_MPa",
                 "Hertz pressure over all positions; a lower bound if an edge carries load",
                 &LoadedTorque::max_pressure);
  of_torque
      .number("max_root_stress_MPa", "greatest root stress", "",
              "greatest principal stress along the fillets over all positions, per gear; the "
              "stress depends on the number of slices if an edge carries load",
              &LoadedTorque::max_root_stress)
      .per_gear();
  of_torque
      .number("least_root_stress_MPa", "lower end of the root stress range", "",
              "least principal stress over all positions at the place of the greatest stress; the "
              "fillet is compressed while neighbouring teeth carry load",
              &LoadedTorque::least_at_max)
      .per_gear();
  q.number("nominal_root_stress_MPa", "nominal root stress by ISO 6336-3", "σ_F0",
           "F_t/(b m_n) Y_F Y_S Y_β of the 2006 edition, method B, for solid rims, per gear",
           [](const T& t) { return has_nominal(t) ? Value(*t.standard->root_stress) : Value(); })
      .per_gear()
      .when(has_nominal);
  q.number("root_stress_over_nominal", "greatest root stress divided by the nominal root stress",
           "",
           "the nominal stress assumes that one tooth pair carries the whole load at the outer "
           "point of single contact",
           [](const T& t) {
             if (!has_nominal(t)) return Value();
             const auto& nominal = *t.standard->root_stress;
             return Value(std::array{t.torque->max_root_stress[0] / nominal[0],
                                     t.torque->max_root_stress[1] / nominal[1]});
           })
      .per_gear()
      .when(has_nominal);
}

void add_distribution(Quantities<T>& q) {
  auto of_torque = q.part(torque_of);
  of_torque
      .term("face_load_factor",
            "maximum load along the face divided by the mean load, averaged over the positions",
            &LoadedTorque::face_load_factor)
      .when(on_lines);
  q.number("shaft_slope_um", "deflection of the shafts, linear along the face", "S",
           "approach of the flanks caused by the shafts under the mean load along the face "
           "[T12.31], > 0 "
           "towards +z; only with `[gearN.shaft]`",
           [](const T& t) { return t.torque->shafts->slope * kUmPerMm; })
      .or_null()
      .digits(2)
      .when(on_shafts);
  q.number("shaft_bow_um", "deflection of the shafts, parabolic along the face", "B",
           "value in the middle of the face [T12.31]",
           [](const T& t) { return t.torque->shafts->bow * kUmPerMm; })
      .or_null()
      .digits(2)
      .when(on_shafts);
  of_torque.number(
      "transverse_load_factor", "transverse load factor", "K_Hα",
      "greatest share of a tooth pair divided by its share without errors and deflections",
      &LoadedTorque::transverse_load_factor);
  q.term("edge_carries", "true if an edge carries load, so that the pressure is a lower bound",
         [](const T& t) { return t.torque->edge_carries; });
  q.flag("ellipse_beyond_flank", "contact ellipse beyond the flank",
         "true if an ellipse crosses an end of the flank or of the face, where the pressure is "
         "higher than the Hertz pressure",
         [](const T& t) { return t.torque->beyond_flank; })
      .when(has_points);
  q.number("face_load_N_per_mm", "load along the face", "",
           "load per length of the contact lines for each slice from −z to +z, averaged over the "
           "positions",
           [](const T& t) { return numbers(t.torque->face_load); })
      .when(on_lines)
      .doors(kJson);
}

void add_torque(Quantities<T>& q) {
  add_loaded_error(q);
  add_mesh_stiffness(q);
  add_stresses(q);
  add_distribution(q);
}

const Quantities<ProbeAnswer>& probe_quantities() {
  return define("load.probes", [](Quantities<ProbeAnswer>& q) {
    q.number("own_um_per_N_mm", "displacement under the load", "",
             "displacement divided by the line load, for a wide gear in plane strain, including "
             "the twist of the body",
             [](const ProbeAnswer& p) { return p.own * kUmPerMm; })
        .unit(Unit::none)
        .when(&ProbeAnswer::wide);
    q.number("own_um_per_N", "displacement under the load", "",
             "mean displacement over the loaded length, divided by the force that is distributed "
             "over `z_mm`",
             [](const ProbeAnswer& p) { return p.own * kUmPerMm; })
        .unit(Unit::none)
        .when([](const ProbeAnswer& p) { return !p.wide; });
    q.number("profile_um_per_N", "displacements along the face", "",
             "displacements at `read_z_mm`, divided by the force that is distributed over `z_mm`",
             [](const ProbeAnswer& p) {
               ValueList list;
               for (const double u : p.profile) list.push_back(Value(u * kUmPerMm));
               return list;
             })
        .unit(Unit::none)
        .when([](const ProbeAnswer& p) { return !p.wide; });
  });
}

}  // namespace

std::vector<LoadTorqueView> torque_views(const LoadedContact& contact,
                                         const std::vector<LoadStandard>& standard) {
  std::vector<T> all;
  for (std::size_t i = 0; i < contact.torques.size(); ++i) {
    all.push_back({&contact.torques[i], &contact, std::nullopt});
    if (i < standard.size()) all.back().standard = standard[i];
  }
  return all;
}

const Quantities<LoadedPair>& load_point_quantities() {
  return define("load.points", [](Quantities<LoadedPair>& q) {
    q.number("force_N", "force", "F_n", "along the common normal",
             [](const LoadedPair& p) { return p.point.force; });
    q.number("pressure_MPa", "greatest pressure", "p_0",
             "Hertz pressure in the middle of the contact ellipse",
             [](const LoadedPair& p) { return p.point.pressure; });
    q.number("semi_major_mm", "semi-major axis", "a", "of the contact ellipse",
             [](const LoadedPair& p) { return p.point.semi_major; });
    q.number("semi_minor_mm", "semi-minor axis", "b", "",
             [](const LoadedPair& p) { return p.point.semi_minor; });
    q.number("diameter_mm", "diameter", "", "diameter of the middle of the ellipse, on each gear",
             [](const LoadedPair& p) { return p.point.diameter; })
        .per_gear();
    q.number("height_mm", "place along the face", "z",
             "axial position of the middle of the ellipse, from the middle of the face of each "
             "gear",
             [](const LoadedPair& p) { return p.point.height; })
        .per_gear();
    q.flag("beyond_flank", "ellipse across an end of the flank",
           "true if the ellipse crosses an end of the flank, so that the pressure is higher than "
           "the Hertz pressure",
           [](const LoadedPair& p) { return p.point.beyond; });
  });
}

const Quantities<LoadPositionView>& load_position_quantities() {
  return define<add_load_position>("load.positions");
}

const Quantities<LoadTorqueView>& load_torque_quantities() {
  return define<add_torque>("load.torques");
}

const Quantities<LoadAnalysis>& load_quantities() {
  return define("load", [](Quantities<LoadAnalysis>& q) {
    q.record<load_torque_quantities>("torques", "one entry for each torque, in the given order",
                                     [](const LoadAnalysis& v) {
                                       return v.contact ? torque_views(*v.contact, v.standard)
                                                        : std::vector<T>();
                                     })
        .doors(kJson);
    q.under(kLoad);
    q.word("regime", "kind of contact",
           "parallel involute teeth touch along lines; crossed and circular-arc teeth touch at "
           "points, and the formulas of Hertz give the contact ellipses",
           [](const LoadAnalysis& v) {
             return v.contact ? Value(to_string(v.contact->regime)) : Value();
           })
        .one_of({"line", "point"})
        .when([](const LoadAnalysis& v) { return v.contact.has_value(); });
    q.number("quietest_torque_Nm", "quietest torque", "",
             "the torque of the list at which the peak-to-peak loaded transmission error is least",
             [](const LoadAnalysis& v) {
               const LoadedTorque* t = v.contact ? quietest(*v.contact) : nullptr;
               return t ? Value(newton_metres(t->torque)) : Value();
             })
        .when([](const LoadAnalysis& v) { return v.contact && quietest(*v.contact); });
    q.record<load_quantities>(
         "halves",
         "results of the two halves of a double-helical pair, each under half of the torque, in "
         "the order z > 0, z < 0. All other numbers describe the whole gears; shares and values "
         "along the face are given only for the halves",
         &LoadAnalysis::halves)
        .list({2})
        .when([](const LoadAnalysis& v) { return !v.halves.empty(); })
        .doors(kJson);
    q.record<probe_quantities>("probes", "one entry for each [[load.probe]], in the given order",
                               &LoadAnalysis::probes)
        .doors(kJson);
  });
}

}  // namespace gearwright
