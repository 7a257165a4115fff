// The yield of the shafts is compared with an oracle that uses vectors in the housing frame, and
// beams whose curvature is integrated numerically. Loaded contact on shafts must satisfy the laws
// of mirrored and exchanged gears.
#include "gearwright/load/shaft_yield.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gearwright/gear/testing/plain_spec.hpp"
#include "gearwright/load/testing/drive.hpp"
#include "gearwright/rating/distribution.hpp"

namespace gearwright {
namespace {

using testing::Drive;
using testing::kE;
using testing::run;

constexpr double kFace = 40.0;

Drive drive_of(double helix_deg, std::array<int, 2> teeth, bool gear2_drives) {
  const auto gear = [&](int z, double hand) {
    CylindricalSpec s = testing::plain_spec(
        {.teeth = z, .module = 3.0, .beta_deg = hand * helix_deg, .face_width = kFace});
    s.rack = *iso53_rack("ISO53-A");
    return std::move(make_gear(s)).take();
  };
  Drive d{gear(teeth[0], 1), gear(teeth[1], -1), {}};
  d.mount.center_distance = (d.one.reference_diameter + d.two.reference_diameter) / 2;
  d.mount.gear2_drives = gear2_drives;
  return d;
}

std::array<std::optional<Shaft>, 2> sample_shafts() {
  Shaft one;
  one.bearings = {-45, 80};
  one.diameters = {30, 40, 28};
  one.steps = {-20.5, 31};
  one.bearing_stiffness = {4e5, 7e5};
  one.shear = false;
  Shaft two = one;
  two.bearings = {-90, -30};
  two.diameters = {55, 45};
  two.steps = {-5.2};
  two.bearing_stiffness.reset();
  two.torque_from = ShaftSide::right;
  return {one, two};
}

LoadRequest request_of(int slices) {
  LoadRequest r;
  r.bodies = {ElasticBody{36, 0.3, kE}, ElasticBody{36, 0.3, kE}};
  r.accuracy = ComplianceAccuracy::draft;
  r.slices = {slices, slices};
  r.positions = 8;
  r.root_stress = false;
  r.torques = {2e5};
  return r;
}

// A compliance without tables of teeth.
PairCompliance shafts_only(const Drive& d, const LoadRequest& r) {
  PairCompliance c;
  c.slices[0] = c.slices[1] = {r.slices[0], -kFace / 2, kFace / 2};
  for (std::size_t g = 0; g < 2; ++g)
    if (r.shafts[g])
      c.shafts[g] = shaft_influence(*r.shafts[g], c.slices[g], (g ? d.two : d.one).root_diameter);
  return c;
}

struct PointLoad {
  double z, force, moment;
};
struct BeamPlace {
  double w, slope;
};

// A beam without shear on two bearings. The curvature, bending moment over E I, is integrated twice
// on a fine grid.
BeamPlace beam_at(const Shaft& s, std::vector<PointLoad> loads, double place) {
  const auto [A, B] = s.bearings;
  double about = 0.0;
  double sum = 0.0;
  for (const PointLoad& l : loads) {
    about += l.force * (l.z - A) + l.moment;
    sum += l.force;
  }
  const std::array<double, 2> R{-sum + about / (B - A), -about / (B - A)};
  loads.push_back({A, R[0], 0});
  loads.push_back({B, R[1], 0});
  constexpr int kSteps = 12'000;
  const double lo = -100.0;
  const double step = 200.0 / kSteps;
  BeamPlace at{0, 0};
  std::array<double, 2> w_bearing{};
  BeamPlace found{};
  for (int k = 0; k < kSteps; ++k) {
    const double z = lo + (k + 0.5) * step;
    double K = 0.0;
    for (const PointLoad& l : loads)
      if (l.z < z) K += l.force * (z - l.z) - l.moment;
    std::size_t section = 0;
    while (section < s.steps.size() && s.steps[section] < z) ++section;
    const double d = s.diameters[section];
    at.w += at.slope * step;
    at.slope += K / (s.youngs_modulus * std::numbers::pi * std::pow(d, 4) / 64) * step;
    for (std::size_t i = 0; i < 2; ++i)
      if (std::abs(z - s.bearings[i]) <= step / 2) w_bearing[i] = at.w;
    if (std::abs(z - place) <= step / 2) found = at;
  }
  std::array<double, 2> off{};
  for (std::size_t i = 0; i < 2; ++i)
    off[i] = (s.bearing_stiffness ? -R[i] / (*s.bearing_stiffness)[i] : 0.0) - w_bearing[i];
  const double turn = (off[1] - off[0]) / (B - A);
  return {found.w + off[0] + turn * (place - A), found.slope + turn};
}

// The displacement along `normal` at the place `read` under a force along `normal` at the places
// `loaded`, for a gear whose axis passes through the origin.
double oracle_yield(const Shaft& s, double body, const Eigen::Vector3d& normal,
                    const Eigen::Vector3d& read, const std::vector<Eigen::Vector3d>& loaded) {
  std::vector<PointLoad> in_x, in_y;
  double twist = 0.0;
  const double part = 1.0 / static_cast<double>(loaded.size());
  const double GI = s.youngs_modulus / 2.6 * std::numbers::pi * std::pow(body, 4) / 32;
  for (const Eigen::Vector3d& p : loaded) {
    const Eigen::Vector3d f = part * normal;
    in_x.push_back({p.z(), f.x(), -f.z() * p.x()});
    in_y.push_back({p.z(), f.y(), -f.z() * p.y()});
    const bool left = s.torque_from == ShaftSide::left;
    const double reach =
        left ? std::min(p.z(), read.z()) + kFace / 2 : kFace / 2 - std::max(p.z(), read.z());
    twist += (p.x() * f.y() - p.y() * f.x()) * reach / GI;
  }
  const BeamPlace x = beam_at(s, in_x, read.z());
  const BeamPlace y = beam_at(s, in_y, read.z());
  return normal.dot(Eigen::Vector3d(x.w - twist * read.y(), y.w + twist * read.x(),
                                    -x.slope * read.x() - y.slope * read.y()));
}

// At azimuth 0, the tooth traces of a right-hand gear have the direction (0, tan β_w, 1). The force
// on gear 2 is normal to them.
TEST(ShaftYield, AgreesWithBeamsInSpace) {
  constexpr int kSlices = 24;
  for (const double helix : {25.0, -25.0})
    for (const bool gear2_drives : {false, true})
      for (const std::size_t which : {0, 1}) {
        const Drive d = drive_of(helix, {19, 31}, gear2_drives);
        LoadRequest r = request_of(kSlices);
        r.shafts[which] = sample_shafts()[which];
        const PairCompliance c = shafts_only(d, r);
        const ContactPair pair = d.pair();
        const ShaftYield yield(pair, d.one, d.two, c, r);
        const double a = d.mount.center_distance;
        const double alpha = std::acos((d.one.base_radius() + d.two.base_radius()) / a);
        const double y = gear2_drives ? 1.0 : -1.0;
        const double tan_w = std::tan(helix * std::numbers::pi / 180);
        Eigen::Vector3d normal(std::sin(alpha), y * std::cos(alpha), 0);
        const Eigen::Vector3d along = normal;
        normal.z() = -normal.y() * tan_w;
        normal.normalize();
        const double r_b = d.one.base_radius();
        const auto point = [&](double rho, double z) -> Eigen::Vector3d {
          return Eigen::Vector3d(r_b * std::cos(alpha), -y * r_b * std::sin(alpha), z) +
                 rho * along;
        };
        const double rho_w = r_b * std::tan(alpha);
        const std::vector<std::pair<int, double>> at{{0, 0.6}, {9, 1.0}, {23, 1.5}, {9, 1.3}};
        std::vector<ShaftYield::Place> places;
        const Eigen::Vector3d axis(which == 0 ? 0.0 : a, 0, 0);
        for (const auto& [slice, of_pitch] : at) {
          const Eigen::Vector3d p = point(of_pitch * rho_w, 0);
          // If gear 2 drives, the slices of N begin at the end at +z.
          places.push_back({gear2_drives ? kSlices - 1 - slice : slice,
                            {p.head<2>().norm(), (p - Eigen::Vector3d(a, 0, 0)).head<2>().norm()}});
        }
        const Eigen::MatrixXd S = yield.between(places);
        const double body = (which == 0 ? d.one : d.two).root_diameter;
        for (std::size_t i = 0; i < at.size(); ++i)
          for (std::size_t j = 0; j < at.size(); ++j) {
            const auto z_of = [&](int slice) { return c.slices[0].middle(slice); };
            std::vector<Eigen::Vector3d> loaded;
            for (int k = 0; k < 8; ++k)
              loaded.push_back(point(at[j].second * rho_w,
                                     z_of(at[j].first) + (k - 3.5) / 8 * c.slices[0].width()) -
                               axis);
            const double oracle =
                oracle_yield(*r.shafts[which], body, normal,
                             point(at[i].second * rho_w, z_of(at[i].first)) - axis, loaded);
            EXPECT_NEAR(S(Eigen::Index(i), Eigen::Index(j)), oracle,
                        1.5e-3 * S.cwiseAbs().maxCoeff())
                << helix << gear2_drives << which << i << j;
          }
      }
}

// Without a helix there is no axial force, and the deviation equals shaft_deviation() of the
// rating.
TEST(ShaftYield, OfSpurGearsUnderUniformLoadIsTheDeviationOfTheRating) {
  constexpr int kSlices = 32;
  const Drive d = drive_of(0, {19, 31}, false);
  LoadRequest r = request_of(kSlices);
  r.shafts = sample_shafts();
  const PairCompliance c = shafts_only(d, r);
  const ContactPair pair = d.pair();
  const ShaftYield yield(pair, d.one, d.two, c, r);
  const auto rated = rated_pair(*mount(d.one, d.two));
  ASSERT_TRUE(rated);
  MeshShafts shafts;
  shafts.of = r.shafts;
  shafts.hand1 = 1.0;
  const double F_bt = 1e4;
  const double F_t = F_bt * d.one.base_radius() * 2 / d.one.reference_diameter;
  const auto f = shaft_deviation(*rated, shafts, F_t);
  const Eigen::VectorXd u =
      yield.at_pitch_point() * Eigen::VectorXd::Constant(kSlices, F_bt / kSlices);
  for (int i = 0; i < kSlices; ++i) {
    const double at = f[static_cast<std::size_t>(i * (kShaftPoints - 1) / kSlices +
                                                 (kShaftPoints - 1) / kSlices / 2)];
    EXPECT_NEAR(1000 * u[i], at, 1e-4 * at) << i;
  }
}

TEST(ShaftYield, DeflectionIsTheNearestParabola) {
  for (const int n : {4, 7, 32}) {
    Eigen::VectorXd approach(n);
    for (int i = 0; i < n; ++i) {
      const double x = (i + 0.5) / n - 0.5;
      approach[i] = 0.7 - 0.013 * x + 0.004 * (1 - 4 * x * x);
    }
    const FaceDeflection d = face_deflection(approach);
    EXPECT_NEAR(d.slope, -0.013, 1e-14);
    EXPECT_NEAR(d.bow, 0.004, 1e-14);
  }
}

Shaft mirrored(const Shaft& s) {
  Shaft m = s;
  m.bearings = {-s.bearings[1], -s.bearings[0]};
  std::reverse(m.diameters.begin(), m.diameters.end());
  std::reverse(m.steps.begin(), m.steps.end());
  for (double& z : m.steps) z = -z;
  if (m.bearing_stiffness) std::swap((*m.bearing_stiffness)[0], (*m.bearing_stiffness)[1]);
  m.torque_from = s.torque_from == ShaftSide::left ? ShaftSide::right : ShaftSide::left;
  return m;
}

TEST(ShaftYield, MirroredGearsHaveMirroredLoads) {
  for (const bool gear2_drives : {false, true}) {
    LoadRequest r = request_of(12);
    r.shafts = sample_shafts();
    const LoadedContact a = run(drive_of(20, {19, 31}, gear2_drives), r);
    for (auto& shaft : r.shafts) shaft = mirrored(*shaft);
    const LoadedContact b = run(drive_of(-20, {19, 31}, gear2_drives), r);
    const Eigen::VectorXd& load = a.torques[0].face_load;
    EXPECT_GT(a.torques[0].face_load_factor, 1.1);
    EXPECT_LT((load - b.torques[0].face_load.reverse()).norm(), 1e-6 * load.norm());
    EXPECT_NEAR(a.torques[0].shafts->slope, -b.torques[0].shafts->slope, 1e-8);
    EXPECT_NEAR(a.torques[0].shafts->bow, b.torques[0].shafts->bow, 1e-8);
  }
}

// Seen from the other end of the axes, a driving gear 2 is a driving gear 1.
TEST(ShaftYield, ExchangedGearsHaveTheSameLoads) {
  LoadRequest r = request_of(12);
  r.shafts = sample_shafts();
  const LoadedContact a = run(drive_of(20, {19, 31}, true), r);
  r.shafts = {mirrored(*r.shafts[1]), mirrored(*r.shafts[0])};
  r.torques[0] *= 31.0 / 19;
  Drive exchanged = drive_of(-20, {31, 19}, false);
  const LoadedContact b = run(exchanged, r);
  const Eigen::VectorXd& load = a.torques[0].face_load;
  EXPECT_LT((load - b.torques[0].face_load.reverse()).norm(), 2e-3 * load.norm());
  EXPECT_NEAR(a.torques[0].shafts->slope, -b.torques[0].shafts->slope, 2e-5);
}

TEST(ShaftYield, StiffShaftsChangeNothing) {
  for (const double helix : {0.0, 15.0}) {
    const Drive d = drive_of(helix, {19, 31}, false);
    LoadRequest r = request_of(12);
    const LoadedContact without = run(d, r);
    r.shafts = sample_shafts();
    const LoadedContact soft = run(d, r);
    for (auto& shaft : r.shafts) {
      shaft->youngs_modulus = 1e14;
      shaft->bearing_stiffness.reset();
    }
    const LoadedContact stiff = run(d, r);
    const LoadedTorque& t = without.torques[0];
    const LoadedTorque& u = stiff.torques[0];
    EXPECT_NEAR(u.face_load_factor, t.face_load_factor, 1e-7);
    EXPECT_NEAR(u.max_pressure, t.max_pressure, 1e-6 * t.max_pressure);
    EXPECT_NEAR(u.stiffness.mean, t.stiffness.mean, 1e-7 * t.stiffness.mean);
    EXPECT_GT(soft.torques[0].face_load_factor, 1.2 * t.face_load_factor);
    // The displacement of the axes is not a part of the approach, so the shafts change the
    // stiffness only by making the load uneven.
    EXPECT_GT(soft.torques[0].stiffness.mean, 0.75 * t.stiffness.mean);
    EXPECT_LT(soft.torques[0].stiffness.mean, 1.01 * t.stiffness.mean);
  }
}

// If rigid shafts in soft bearings leave the load of spur gears uniform, they displace both axes
// without a change of the mesh.
TEST(ShaftYield, DisplacedAxesDoNotChangeTheMesh) {
  const Drive d = drive_of(0, {19, 31}, false);
  LoadRequest r = request_of(12);
  const LoadedContact without = run(d, r);
  for (auto& shaft : r.shafts) {
    Shaft rigid;
    rigid.bearings = {-60, 60};
    rigid.diameters = {40};
    rigid.youngs_modulus = 1e14;
    rigid.bearing_stiffness = {5e4, 5e4};
    shaft = rigid;
  }
  const LoadedContact displaced = run(d, r);
  const LoadedTorque& t = without.torques[0];
  const LoadedTorque& u = displaced.torques[0];
  EXPECT_NEAR(u.face_load_factor, t.face_load_factor, 1e-6);
  EXPECT_NEAR(u.stiffness.mean, t.stiffness.mean, 1e-5 * t.stiffness.mean);
  EXPECT_NEAR(u.tangent.mean, t.tangent.mean, 1e-5 * t.tangent.mean);
}

// The load moves to the end of the face at which the shafts yield less. The displacement of the axes
// under this load is less than under a uniform load, so the rest of the approach is positive, and
// softer shafts do not make the mesh stiffer.
TEST(ShaftYield, SoftShaftsDoNotStiffenTheMesh) {
  for (const double helix : {0.0, 15.0}) {
    const Drive d = drive_of(helix, {19, 31}, false);
    LoadRequest r = request_of(12);
    const LoadedTorque rigid = run(d, r).torques[0];
    for (const double diameter : {40.0, 15.0}) {
      Shaft overhung;
      overhung.bearings = {30, 40};
      overhung.diameters = {diameter};
      overhung.torque_from = ShaftSide::right;
      r.shafts[0] = overhung;
      const LoadedTorque soft = run(d, r).torques[0];
      EXPECT_GT(soft.stiffness.min, 0.0) << helix << ' ' << diameter;
      EXPECT_GT(soft.tangent.min, 0.0) << helix << ' ' << diameter;
      EXPECT_LT(soft.stiffness.mean, 1.01 * rigid.stiffness.mean) << helix << ' ' << diameter;
      for (const LoadedPosition& p : soft.positions)
        EXPECT_GT(p.approach, 0.0) << helix << ' ' << diameter;
    }
  }
}

// The mean transmission error under load is that without load minus the mean deflection of the
// mesh. The displacement of the axes by soft shafts leaves no constant, but its variation remains.
TEST(ShaftYield, MeanTransmissionErrorIsThatOfTheMesh) {
  for (const double helix : {0.0, 15.0})
    for (const bool gear2_drives : {false, true}) {
      const Drive d = drive_of(helix, {19, 31}, gear2_drives);
      LoadRequest r = request_of(12);
      Shaft overhung;
      overhung.bearings = {30, 40};
      overhung.diameters = {15};
      overhung.torque_from = ShaftSide::right;
      r.shafts[0] = overhung;
      const LoadedTorque t = run(d, r).torques[0];
      const double sign = d.pair().turned();
      double lag = 0.0, approach = 0.0, difference = 0.0;
      for (const LoadedPosition& p : t.positions) {
        ASSERT_TRUE(p.solved());
        const double own = sign * (p.unloaded_te.rad() - p.te.rad());
        lag += own;
        approach += p.approach / d.two.base_radius();
        difference = std::max(difference, std::abs(own - p.approach / d.two.base_radius()));
      }
      EXPECT_NEAR(lag, approach, 1e-12) << helix << gear2_drives;
      EXPECT_GT(difference, 1e-9) << helix << gear2_drives;
    }
}

}  // namespace
}  // namespace gearwright
