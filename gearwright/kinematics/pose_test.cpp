// Laws of poses: adjacent frames of a product must be equal, a pose times its inverse is the
// identity, and lengths are preserved.
#include "gearwright/kinematics/pose.hpp"

#include <gtest/gtest.h>

#include <type_traits>

namespace gearwright {
namespace {

Pose<Housing, Gear1> some_pose() {
  Eigen::Isometry3d x = Eigen::Isometry3d::Identity();
  x.rotate(Eigen::AngleAxisd(0.7, Vec3(1.0, 2.0, -1.0).normalized()));
  x.pretranslate(Vec3(3.0, -4.0, 5.0));
  return Pose<Housing, Gear1>(x);
}

template <class A, class B>
concept Composes = requires(A a, B b) {
  a* b;
};

TEST(Pose, frames_must_cancel) {
  static_assert(Composes<Pose<Gear2, Housing>, Pose<Housing, Gear1>>);
  static_assert(!Composes<Pose<Housing, Gear1>, Pose<Gear2, Housing>>);
  static_assert(Composes<Pose<Housing, Gear1>, Point<Gear1>>);
  static_assert(!Composes<Pose<Housing, Gear1>, Point<Gear2>>);
  static_assert(std::is_same_v<decltype(some_pose().inverse()), Pose<Gear1, Housing>>);
  static_assert(std::is_same_v<decltype(some_pose() * Point<Gear1>{}), Point<Housing>>);
}

TEST(LinearMap, frames_must_cancel) {
  using Map = LinearMap<Gear2, Gear1>;
  static_assert(Composes<Map, LinearMap<Gear1, Housing>>);
  static_assert(!Composes<LinearMap<Gear1, Housing>, Map>);
  static_assert(std::is_same_v<decltype(Map() * FreeVector<Gear1>{}), FreeVector<Gear2>>);
  static_assert(!Composes<Map, FreeVector<Gear2>>);
  static_assert(!Composes<Map, Point<Gear1>>);  // a map without an origin does not move points
  static_assert(!Composes<Map, Pose<Gear1, Housing>>);
}

TEST(LinearMap, maps_as_its_matrix) {
  Mat3 m, n;
  m << 1, 2, 3, 4, 5, 6, 7, 8, 10;
  n << 0, -1, 2, 1, 0, 3, -2, 5, 1;
  const LinearMap<Gear2, Housing> two(m);
  const LinearMap<Housing, Gear1> one(n);
  const FreeVector<Gear1> v{Vec3(1.0, -2.0, 4.0)};
  EXPECT_EQ((two * one).matrix(), Mat3(m * n));
  EXPECT_EQ((one * v).v, Vec3(n * v.v));
  EXPECT_EQ((v * 2.0 + v).v, Vec3(3.0 * v.v));
  EXPECT_EQ((LinearMap<Gear2, Gear1>() * v).v, v.v);
}

TEST(Pose, is_made_from_origin_and_rotation) {
  const double angle = 0.7;
  const Vec3 origin(3.0, -4.0, 5.0), r(2.0, 1.0, -6.0);
  const Pose<Housing, Gear1> pose(origin, about_z(angle));
  EXPECT_EQ(pose.origin(), origin);
  EXPECT_EQ(pose.axis(2), Vec3::UnitZ());
  EXPECT_NEAR(pose.turn(), angle, 1e-15);
  const Vec3 turned = Eigen::AngleAxisd(angle, Vec3::UnitZ()) * r;
  EXPECT_LE(((pose * Point<Gear1>{r}).r - origin - turned).norm(), 1e-14);
  EXPECT_TRUE((Pose<Housing, Gear1>(Vec3::Zero(), about_z(0.0)).is_identity()));
}

TEST(Pose, parts) {
  Eigen::Isometry3d x = Eigen::Isometry3d::Identity();
  x.translate(Vec3(3.0, -4.0, 5.0));
  x.rotate(Eigen::AngleAxisd(0.7, Vec3::UnitZ()));
  const Pose<Housing, Gear1> pose(x);
  EXPECT_EQ(pose.origin(), (pose * Point<Gear1>{}).r);
  EXPECT_NEAR(pose.turn(), 0.7, 1e-15);
  const Vec2 in_plane = (pose * Point<Gear1>{Vec3(1.5, -2.0, 0.0)}).r.head<2>();
  EXPECT_LE((pose.plan() * Vec2(1.5, -2.0) - in_plane).norm(), 1e-14);
  for (const int i : {0, 1, 2}) {
    const Vec3 along = (pose * Point<Gear1>{Vec3::Unit(i)}).r - pose.origin();
    EXPECT_LE((pose.axis(i) - along).norm(), 1e-14);
  }
  EXPECT_FALSE(pose.is_identity());
  EXPECT_TRUE((Pose<Housing, Gear1>().is_identity()));
}

TEST(Pose, identity_by_default) {
  const Point<Gear1> p{Vec3(1.0, 2.0, 3.0)};
  EXPECT_EQ((Pose<Housing, Gear1>() * p).r, p.r);
  EXPECT_EQ(Point<Gear1>().r, Vec3(0.0, 0.0, 0.0));
}

TEST(Pose, inverse_undoes) {
  const Point<Gear1> p{Vec3(1.0, 2.0, 3.0)};
  const Pose<Housing, Gear1> X_f1 = some_pose();
  EXPECT_LE(((X_f1.inverse() * (X_f1 * p)).r - p.r).norm(), 1e-14);
}

TEST(Pose, composition_is_one_after_the_other) {
  const Point<Gear1> p{Vec3(1.0, 2.0, 3.0)};
  const Pose<Housing, Gear1> X_f1 = some_pose();
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.rotate(Eigen::AngleAxisd(-0.3, Vec3::UnitZ()));
  const Pose<Gear2, Housing> X_2f(turn);
  EXPECT_LE((((X_2f * X_f1) * p).r - (X_2f * (X_f1 * p)).r).norm(), 1e-14);
}

TEST(Pose, keeps_lengths) {
  const Pose<Housing, Gear1> X_f1 = some_pose();
  const Vec3 a = (X_f1 * Point<Gear1>{Vec3(1.0, 0.0, 0.0)}).r;
  const Vec3 b = (X_f1 * Point<Gear1>{Vec3(0.0, 2.0, 0.0)}).r;
  EXPECT_NEAR((a - b).norm(), std::sqrt(5.0), 1e-15 * 10);
}

}  // namespace
}  // namespace gearwright
