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
