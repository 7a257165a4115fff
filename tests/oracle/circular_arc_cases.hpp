// The pairs of circular_arc.json as input for the five equations. The file comes from a 30-digit
// computation that was checked by minimising the gap. It contains the pairs in the paper of Litvin
// and Tsay on circular-arc gears, and similar ones. Lengths are in inch (names ex…) or mm, and the
// numbers are rounded to double.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gearwright/base/testing/source_file.hpp"
#include "tests/oracle/five_equation.hpp"
#include "tests/oracle/numbers.hpp"

namespace gearwright::oracle::tca {

inline constexpr Real kArcsec = kLongDegree / 3600;

inline const nlohmann::json& circular_arc_file() {
  static const nlohmann::json file =
      nlohmann::json::parse(std::ifstream(testing::source_file("tests/oracle/circular_arc.json")));
  return file;
}

inline Real number(const nlohmann::json& of, const char* key) { return of.at(key).get<double>(); }

inline Vector3 vector(const nlohmann::json& of, const char* key) {
  const nlohmann::json& v = of.at(key);
  return {v.at(0).get<double>(), v.at(1).get<double>(), v.at(2).get<double>()};
}

inline ArcPair arc_pair(const nlohmann::json& of) {
  const nlohmann::json &d = of.at("design"), &e = of.at("errors");
  const auto arc = [&d](const char* key) {
    const nlohmann::json& a = d.at(key);
    RackArc out;
    out.rho = number(a, "rho"), out.a = number(a, "a"), out.b = number(a, "b");
    return out;
  };
  ArcPair p;
  p.teeth_1 = d.at("N1"), p.teeth_2 = d.at("N2");
  p.f = arc("F"), p.p = arc("P");
  p.lead_angle_f = number(d, "lamF_deg") * kLongDegree,
  p.lead_angle_p = number(d, "lamP_deg") * kLongDegree;
  p.pitch_radius_1 = number(d, "r1"), p.pitch_radius_2 = number(d, "r2");
  p.mounting = {.center_distance = p.pitch_radius_1 + p.pitch_radius_2,
                .shaft_angle = 0,
                .d_center = number(e, "dC"),
                .crossing = number(e, "dgam"),
                .intersecting = number(e, "ddel"),
                .axial = number(e, "dz")};
  p.lead_1.twist = number(e, "kap1"), p.lead_2.twist = number(e, "kap2");
  return p;
}

/// The pair of `composite_te`: the consistent geometry of Example 1, a face of 8 in on gear 1, a
/// crossing error of 0.1°, and the working arcs of the racks as cut.
inline ArcPair composite_pair(const nlohmann::json& of) {
  const nlohmann::json& racks = circular_arc_file().at("racks_Pn2_lam75");
  const auto arc = [&racks](const char* key) {
    const nlohmann::json& a = racks.at(key);
    return RackArc{number(a, "rho"), number(a, "a"), number(a, "b"),
                   number(a, "th_lo_deg") * kLongDegree, number(a, "th_hi_deg") * kLongDegree};
  };
  ArcPair p;
  p.teeth_1 = 12, p.teeth_2 = 94;
  p.f = arc("F"), p.p = arc("P");
  p.lead_angle_f = number(of, "lamF_deg") * kLongDegree, p.lead_angle_p = 75 * kLongDegree;
  const Real normal_pitch = 2;  // P_n, 1/in
  p.pitch_radius_1 = p.teeth_1 / (2 * normal_pitch * std::sin(p.lead_angle_p));
  p.pitch_radius_2 = p.teeth_2 / (2 * normal_pitch * std::sin(p.lead_angle_p));
  p.mounting.center_distance = p.pitch_radius_1 + p.pitch_radius_2;
  p.mounting.crossing = kLongDegree / 10;
  p.half_face_1 = number(of, "face") / 2;
  return p;
}

}  // namespace gearwright::oracle::tca
