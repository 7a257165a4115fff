// Circular-arc racks, teeth and contacts are compared with a computation of 30 digits that shares
// no code with this project (tests/oracle/circular_arc.json, its conventions in
// tests/oracle/five_equation.hpp).
//
// In that computation, x points from axis 1 to axis 2, and θ is our τ. Its flanks are on the side y
// < 0 of gear 1's tooth, so they are mirror images of the flanks of the outline. Lengths in both of
// its units are used as mm here.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <fstream>
#include <nlohmann/json.hpp>

#include "gearwright/base/numbers.hpp"
#include "gearwright/base/testing/numbers.hpp"
#include "gearwright/base/testing/source_file.hpp"
#include "gearwright/base/testing/taken.hpp"
#include "gearwright/gear/finished_gear.hpp"
#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/pair/arc_pair.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {
namespace {

using Complex = std::complex<double>;

using testing::kDegree;

const Json& cases() {
  static const Json all = [] {
    std::ifstream file(testing::source_file("tests/oracle/circular_arc.json"));
    EXPECT_TRUE(file);
    return Json::parse(file);
  }();
  return all;
}

// The rack of the drawing without tip rounding. A changed centre would leave no space for the
// rounding.
ArcRack rack_of(const Json& numbers, ArcRack::Cutter cutter, double m) {
  ArcRack rack = default_arc_rack(cutter);
  rack.arc_radius = numbers["rho"].get<double>() / m;
  rack.center_a = numbers["a"].get<double>() / m;
  rack.center_b = numbers["b"].get<double>() / m;
  return rack;
}

Gear gear_of(const Json& design, int which, double m) {
  const bool first = which == 1;
  CylindricalSpec spec =
      testing::plain_spec({.teeth = design[first ? "N1" : "N2"],
                           .module = m,
                           .beta_deg = (first ? 1 : -1) * (90.0 - design["lamF_deg"].get<double>()),
                           .face_width = 40 * m});
  spec.rack =
      rack_of(design[first ? "F" : "P"], first ? ArcRack::Cutter::F : ArcRack::Cutter::P, m);
  return testing::taken(make_gear(spec));
}

TEST(CircularArc, racks) {
  const double m = 0.5;  // inch: P_n = 2
  const Json& racks = cases()["racks_Pn2_lam75"];
  for (const char* name : {"F", "P"}) {
    const bool is_F = *name == 'F';
    const auto cutter = is_F ? ArcRack::Cutter::F : ArcRack::Cutter::P;
    const auto rack = arcs_of(rack_of(racks[name], cutter, m));
    ASSERT_TRUE(rack) << rack.error().message();
    const auto edge = make_edge(*rack, m, 0.0);
    ASSERT_TRUE(edge) << edge.error().message();
    ASSERT_EQ(edge->arcs.size(), 2u);
    for (const bool fillet : {true, false}) {
      const Json& want = racks[std::string(name) + (fillet ? "f" : "")];
      const auto& got = std::get<EdgeCircle>(edge->arcs[fillet ? 0 : 1].shape);
      // F is drawn from the middle of the tooth and away from the axis. P is drawn in the opposite
      // direction.
      const double rho = want["rho"], a = want["a"], b = want["b"];
      EXPECT_NEAR(got.q, is_F ? rho : -rho, 1e-15);
      EXPECT_NEAR(got.center.x(), is_F ? -b : b, 1e-15);
      EXPECT_NEAR(got.center.y(), is_F ? -a : a + kPi * m / 2, 4e-15);
      const double joint = racks[is_F ? "F" : "Pf"]["th_lo_deg"];
      EXPECT_NEAR((fillet ? got.end_tau : got.begin_tau).rad(), joint * kDegree, 1e-13);
    }
    // The source ends the flank at the tip. Here the flank continues beyond it.
    const auto& flank = std::get<EdgeCircle>(edge->arcs[1].shape);
    const double tip = racks[name][is_F ? "th_hi_deg" : "th_lo_deg"].get<double>() * kDegree;
    EXPECT_NEAR(flank.center.x() + flank.q * std::sin(tip), (is_F ? 0.9 : 0.0) * m, 1e-13);
    EXPECT_TRUE(is_F ? flank.end_tau.rad() > tip : flank.end_tau.rad() < tip);
  }
}

TEST(CircularArc, undercut_limits) {
  const Json& design = cases()["racks_Pn2_lam75"];
  const double m = 0.5;
  for (const Json& c : cases()["undercut_limit_gear1_Pn2_lam75"]) {
    CylindricalSpec spec =
        testing::plain_spec({.teeth = c["N1"], .module = m, .beta_deg = 15, .face_width = 10 * m});
    ArcRack rack = rack_of(design["F"], ArcRack::Cutter::F, m);
    spec.rack = rack;
    const auto gear = make_gear(spec);
    ASSERT_TRUE(gear) << gear.error().message();
    ASSERT_TRUE(gear->arcs()->undercut_limit);
    const double limit = c["theta_limit_deg"];
    EXPECT_NEAR(gear->arcs()->undercut_limit->deg(), limit, 1e-10);
    EXPECT_FALSE(gear->undercut);
    // With this dedendum, the flank begins exactly at the undercut limit. A slightly smaller
    // dedendum causes no undercut, and a slightly greater one does.
    const double at_limit = rack.center_b + rack.root_fillet_radius -
                            (rack.arc_radius + rack.root_fillet_radius) * std::sin(limit * kDegree);
    for (const double more : {-1e-8, 1e-8}) {
      rack.dedendum = at_limit + more;
      spec.rack = rack;
      const auto changed = make_gear(spec);
      ASSERT_TRUE(changed) << changed.error().message();
      EXPECT_EQ(changed->undercut, more > 0.0);
      EXPECT_TRUE(changed->root_form_radius());
    }
  }
}

// Points, normals and curvatures of flanks and fillets of both gears.
TEST(CircularArc, surfaces) {
  int gears_seen = 0;
  for (const Json& s : cases()["surfaces"]) {
    const bool first = s["gear"] == 1;
    const double lambda = s["lam_deg"].get<double>() * kDegree;
    const double r = s["r"], theta = s["theta"];
    const double rho = s["rho"], a = s["a"], b = s["b"];
    const double m = 0.5;
    const int z = static_cast<int>(std::lround(2 * r * std::sin(lambda) / m));
    ASSERT_NEAR(2 * r * std::sin(lambda) / m, z, 1e-12);
    const EdgeCircle circle{{first ? -b : b, first ? -a : a + kPi * m / 2},
                            first ? rho : -rho,
                            Angle::radians(0.1),
                            Angle::radians(1.0)};
    const RackTrochoid curve({r, std::sin(lambda), 0.0}, circle);
    const Vec2 w = curve.point(theta);
    const CurvePoint at = curve.at(theta);
    const auto& p = s["position"];
    const double p_z = p[2];
    const double twist = (first ? 1 : -1) / (r * std::tan(lambda));
    // The point is mirrored to y < 0. Gear 2 has a space on its −x axis, so the tooth is half a
    // pitch further.
    const Complex turn =
        (first ? Complex(1.0) : -std::polar(1.0, kPi / z)) * std::polar(1.0, twist * p_z);
    const Complex point = turn * Complex(w.x(), -w.y());
    EXPECT_NEAR(point.real(), p[0].get<double>(), 2e-14 * r);
    EXPECT_NEAR(point.imag(), p[1].get<double>(), 2e-14 * r);
    // The normal points out of gear 1, and therefore out of the tooth of the outline on gear 1 and
    // into it on gear 2. If the outline is followed towards increasing radius, the tooth is on the
    // right for y > 0 and on the left in the mirror image.
    const double forward = (curve.point(theta + 1e-6).norm() > w.norm()) ? 0.0 : kPi;
    const Complex tangent = std::polar(1.0, -(at.tangent_angle + forward));
    const Complex n = turn * tangent * Complex(0.0, first ? -1.0 : 1.0);
    const auto& want = s["normal"];
    const Complex wanted(want[0], want[1]);
    EXPECT_NEAR(std::abs(n - wanted / std::abs(wanted)), 0.0, 1e-13);
    EXPECT_NEAR(want[2].get<double>(), std::cos(theta) * std::cos(lambda), 1e-15);
    const Mat2 k = cut_curvature(rho, b, theta, lambda, r, first ? 1.0 : -1.0);
    for (int i : {0, 1}) {
      for (int j : {0, 1}) EXPECT_NEAR(k(i, j), s["K_t_u_basis"][i][j].get<double>(), 1e-12);
    }
    ++gears_seen;
  }
  EXPECT_EQ(gears_seen, 12);
}

// Pairs with no error except a changed centre distance are compared with the closed form of the
// contact.
TEST(CircularArc, contacts_at_other_centre_distances) {
  int seen = 0;
  for (const Json& c : cases()["cases"]) {
    const Json& e = c["errors"];
    const Json& d = c["design"];
    const std::string name = c["name"];
    bool distance_only = true;
    for (const char* key : {"dgam", "ddel", "dz", "kap1", "kap2"})
      distance_only = distance_only && e[key] == 0.0;
    if (!distance_only) continue;
    ArcMeshInput in;
    const auto arc = [](const Json& j) { return WorkingArc{j["rho"], j["a"], j["b"]}; };
    in.convex = arc(d["F"]);
    in.concave = arc(d["P"]);
    in.pitch_radius_convex = d["r1"];
    in.pitch_radius_concave = d["r2"];
    in.lead_angle = Angle::degrees(d["lamF_deg"]);
    in.center_distance = d["r1"].get<double>() + d["r2"].get<double>() + e["dC"].get<double>();
    const double size = in.pitch_radius_convex;
    const auto theta = contact_angle(in);
    ASSERT_TRUE(theta) << name;
    const ArcContact at = arc_contact(in, *theta);
    for (const Json& t : c["tca"]) {
      EXPECT_NEAR(theta->rad() / kDegree, t["thF_deg"].get<double>(), 2e-11) << name;
      EXPECT_NEAR(at.mu.rad(), t["mu1"].get<double>(), 1e-13) << name;
      EXPECT_NEAR(at.rotation_offset.rad(), t["te_rad"].get<double>(), 1e-13) << name;
      EXPECT_NEAR(at.radius_convex, t["radius1"].get<double>(), 1e-12 * size) << name;
      EXPECT_NEAR(at.radius_concave, t["radius2"].get<double>(), 1e-12 * size) << name;
      const double along = t["phi1p"].get<double>() * at.advance;
      for (int i : {0, 1, 2}) {
        const double p = at.point(i) + (i == 2 ? along : 0.0);
        EXPECT_NEAR(p, t["point_f"][i].get<double>(), 1e-12 * size) << name;
        EXPECT_NEAR(at.normal(i), t["normal_f"][i].get<double>(), 1e-12) << name;
      }
    }
    const Json& k = c["contact"];
    if (!k.is_null()) {
      const double delta = k["delta"];
      EXPECT_NEAR(at.gap[0], k["relative_principal"][0].get<double>(), 1e-11 / size) << name;
      EXPECT_NEAR(at.gap[1], k["relative_principal"][1].get<double>(), 1e-11 / size) << name;
      EXPECT_NEAR(std::sqrt(2 * delta / at.gap[0]), k["semi_major"].get<double>(), 1e-8 * size);
      EXPECT_NEAR(at.angle.rad() / kDegree, k["major_angle_deg"].get<double>(), 1e-8) << name;
    }
    ++seen;
  }
  EXPECT_EQ(seen, 8);
}

// Compares mounted gears with the same computation. The pitch radii of both gears must correspond
// to the same module and the same lead angle.
TEST(CircularArc, mounted_pairs) {
  int seen = 0;
  for (const Json& c : cases()["cases"]) {
    const Json& e = c["errors"];
    const Json& d = c["design"];
    const std::string name = c["name"];
    if (e["dgam"] != 0.0 || e["kap1"] != 0.0 || e["dz"] != 0.0) continue;
    if (name.find("mixed") != std::string::npos) continue;  // pitch radii with another lead
    const double m = 2 * d["r1"].get<double>() * std::sin(d["lamF_deg"].get<double>() * kDegree) /
                     d["N1"].get<double>();
    const double a = d["r1"].get<double>() + d["r2"].get<double>() + e["dC"].get<double>();
    const auto pair = mount_arcs(gear_of(d, 1, m), gear_of(d, 2, m), a);
    ASSERT_TRUE(pair) << pair.error().message();
    ASSERT_EQ(pair->contacts.size(), 1u);
    const ArcPairContact& contact = pair->contacts.front();
    const Json& t = c["tca"][0];
    EXPECT_NEAR(contact.at.theta.rad() / kDegree, t["thF_deg"].get<double>(), 1e-9) << name;
    EXPECT_NEAR((*pair->backlash_rotation)[1].rad(), -2 * t["te_rad"].get<double>(), 1e-11) << name;
    // Touching points in one section lie on both outlines.
    for (const std::size_t i : {0, 1}) {
      const double radius = i == 0 ? contact.at.radius_convex : contact.at.radius_concave;
      EXPECT_GT(radius, *pair->gears[i].root_form_radius()) << name;
      EXPECT_LT(radius, pair->gears[i].tip_form_radius()) << name;
    }
    ++seen;
  }
  EXPECT_EQ(seen, 4);
}

}  // namespace
}  // namespace gearwright
