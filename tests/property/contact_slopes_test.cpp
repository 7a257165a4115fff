// Compares the derivatives of transmission error and contact point with central differences, over
// seeded pairs and for every kind of contact.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "tests/property/contact_pairs.hpp"

namespace gearwright::property {
namespace {

struct Slopes {
  double te, te_noise;
  Vec3 point;
  bool smooth;  ///< true if pair, kind and position are the same for all evaluations
};

// Combines the central differences of two step sizes. If the contact moves by more than `near`, mm,
// it counts as a different contact.
template <class At>
Slopes differences(const ContactPoint& here, double h, double near, At at) {
  std::array<ContactPoint, 4> p;
  const std::array<double, 4> steps{h, -h, 2 * h, -2 * h};
  Slopes s{0, 0, Vec3::Zero(), true};
  for (int i = 0; i < 4; ++i) {
    p[i] = at(steps[i]);
    s.smooth &=
        p[i].kind == here.kind && p[i].pair == here.pair && (p[i].point - here.point).norm() < near;
  }
  const double one = (p[0].te - p[1].te).rad() / (2 * h), two = (p[2].te - p[3].te).rad() / (4 * h);
  s.te = (4 * one - two) / 3, s.te_noise = std::abs(one - two);
  const Vec3 short_way = (p[0].point - p[1].point) / (2 * h);
  s.point = (4 * short_way - (p[2].point - p[3].point) / (4 * h)) / 3;
  return s;
}

void check(const Sensitivity& got, const Slopes& want, double h, double size, bool point) {
  if (!want.smooth) return;
  EXPECT_NEAR(got.te, want.te, 1e-6 * std::abs(want.te) + 0.5 * want.te_noise + 2e-14 / h);
  if (!point) return;
  EXPECT_LT((got.point - want.point).norm(),
            1e-3 * want.point.norm() + 1e-9 * size / h + 1e-3 * size);
}

// κ of a gear per mm of f_Hβ. The rack has no errors of its teeth.
double twist_per_slope(const Gear& gear) {
  return 1 / (gear.reference_diameter / 2 * gear.spec.face_width);
}
std::array<double, 2> twists_per_slope(const ContactSet& set) {
  return {twist_per_slope(set.gears[0]), twist_per_slope(set.gears[1])};
}
std::array<double, 2> twists_per_slope(const RackSet& set) {
  return {twist_per_slope(set.rack.pinion), 0.0};
}

// For every kind of contact and every error, the exact derivatives equal central differences.
TEST(ContactSlopes, sensitivities_to_errors) {
  std::map<TouchKind, int> seen;
  const auto law = [&seen](const auto& given, Random& random) {
    ContactRequest request;
    request.rotations = {Angle::radians(random.uniform(-0.1, 0.1)),
                         Angle::radians(random.uniform(-0.1, 0.1))};
    for (const ErrorKind k : kErrorKinds) request.influences.push_back({k});
    const auto r = analyse_contact(given.pair(), request);
    const double size = given.mount.center_distance;
    for (std::size_t k = 0; k < kErrorKinds.size(); ++k) {
      const ErrorKind kind = kErrorKinds[k];
      const bool angle = kind == ErrorKind::crossing || kind == ErrorKind::intersecting;
      const double h = angle ? 1e-7 : 1e-7 * size;
      for (std::size_t i = 0; i < 2; ++i) {
        const ContactPoint& here = r.positions[i];
        if (here.kind == TouchKind::none || here.kind == TouchKind::line) continue;
        const auto at = [&](double d) {
          auto set = given;
          auto& e = set.mount.errors;
          const auto twist = [&](int g) { e.helix_twist[g] += d * twists_per_slope(given)[g]; };
          if (kind == ErrorKind::center_distance) e.center_distance += d;
          if (kind == ErrorKind::crossing) e.crossing += Angle::radians(d);
          if (kind == ErrorKind::intersecting) e.intersecting += Angle::radians(d);
          if (kind == ErrorKind::axial) e.axial += d;
          if (kind == ErrorKind::helix_slope1) twist(0);
          if (kind == ErrorKind::helix_slope2) twist(1);
          return at_rotations(set.pair(), {here.rotation1}).positions[0];
        };
        const Slopes want = differences(here, h, 0.01 * size, at);
        if (want.smooth) ++seen[here.kind];
        SCOPED_TRACE(::testing::Message() << to_string(here.kind) << " by error " << k);
        check(r.sensitivities[k][i], want, h, angle ? size : 1.0, false);
      }
    }
  };
  over_sets(41, {40, 10, 20}, {}, law);
  Wanted plain;
  plain.modifications = false;
  over_sets(42, {60, 10, 20}, plain, law);
  for (const TouchKind k : {TouchKind::interior, TouchKind::face1, TouchKind::face2,
                            TouchKind::tip1, TouchKind::tip2, TouchKind::corner})
    EXPECT_GT(seen[k], 2) << to_string(k);
}

std::vector<const Gear*> gears(const ContactSet& set) { return {&set.gears[0], &set.gears[1]}; }
std::vector<const Gear*> gears(const RackSet& set) { return {&set.rack.pinion}; }

void modify(ContactSet& set, std::size_t gear, std::shared_ptr<const RemovalField> removal) {
  set.removal[gear] = std::move(removal);
}
void modify(RackSet& set, std::size_t, std::shared_ptr<const RemovalField> removal) {
  set.removal = std::move(removal);
}

// The exact derivatives with respect to the amount of every modification equal central differences.
TEST(ContactSlopes, sensitivities_to_modifications) {
  int compared = 0;
  over_sets(43, {16, 8, 8}, {}, [&compared](const auto& given, Random& random) {
    for (std::size_t g = 0; g < gears(given).size(); ++g) {
      FlankModifications f;
      const FlankExtent e = extent_of(*gears(given)[g]);
      const double m = gears(given)[g]->spec.normal_module;
      f.tip_relief = {2e-3 * m,
                      e.rho_root_form + 1.3 * (e.rho_tip_form - e.rho_root_form) + e.rho_root_form,
                      ReliefShape::parabolic};
      f.root_relief = {1e-3 * m,
                       e.rho_root_form + 0.3 * (e.rho_tip_form - e.rho_root_form) + e.rho_root_form,
                       ReliefShape::linear};
      f.profile_crowning = 2e-3 * m, f.profile_slope = 1e-3 * m;
      f.lead_crowning = 2e-3 * m, f.lead_slope = -1e-3 * m;
      f.end_relief = {3e-3 * m, 0.2 * e.face_width, ReliefShape::parabolic};
      auto set = given;
      const auto with = [&](const FlankModifications& n) {
        auto field = make_removal_field(n, e);
        EXPECT_TRUE(field);
        modify(set, g, std::make_shared<RemovalField>(std::move(field).take()));
        return set.pair();
      };
      ContactRequest request;
      request.rotations = {Angle::radians(random.uniform(-0.1, 0.1))};
      for (const ModificationMember& q : kModifications)
        request.influences.push_back({ErrorKind::center_distance, static_cast<int>(g) + 1, q.kind});
      const auto r = analyse_contact(with(f), request);
      const ContactPoint& here = r.positions[0];
      if (here.kind == TouchKind::none || here.kind == TouchKind::line) continue;
      double* const amounts[] = {&f.tip_relief.amount, &f.root_relief.amount, &f.profile_crowning,
                                 &f.profile_slope,     &f.lead_crowning,      &f.lead_slope,
                                 &f.end_relief.amount};
      for (std::size_t k = 0; k < 7; ++k) {
        const double h = 1e-6 * m, was = *amounts[k];
        const Slopes want = differences(here, h, 0.2 * m, [&](double d) {
          *amounts[k] = was + d;
          const auto there = at_rotations(with(f), request.rotations).positions[0];
          *amounts[k] = was;
          return there;
        });
        SCOPED_TRACE(::testing::Message()
                     << to_string(here.kind) << " by modification " << k << " of gear " << g + 1);
        compared += want.smooth;
        check(r.sensitivities[k][0], want, h, 1.0, false);
      }
    }
  });
  EXPECT_GT(compared, 300);
}

// The contact point of crowned pairs moves within the flanks, and the contact point of an edge
// moves along the edge.
TEST(ContactSlopes, the_point_moves_as_said) {
  int compared = 0;
  Random random(44);
  for (int i = 0; i < 40; ++i) {
    const double crossing = random.uniform(-4e-4, 4e-4);
    const ContactSet set = contact_set(some_arcs(crossing, random.uniform(-0.05, 0.05)));
    ContactRequest request;
    request.rotations = {Angle::radians(random.uniform(-0.2, 0.2))};
    for (const ErrorKind k : kErrorKinds) request.influences.push_back({k});
    const auto r = analyse_contact(set.pair(), request);
    const ContactPoint& here = r.positions[0];
    for (std::size_t k = 0; k < 4; ++k) {
      const double h = k == 1 || k == 2 ? 1e-6 : 1e-4;
      const Slopes want = differences(here, h, 1.0, [&](double d) {
        ContactSet moved = set;
        auto& e = moved.mount.errors;
        if (k == 0) e.center_distance += d;
        if (k == 1) e.crossing += Angle::radians(d);
        if (k == 2) e.intersecting += Angle::radians(d);
        if (k == 3) e.axial += d;
        return at_rotations(moved.pair(), request.rotations).positions[0];
      });
      if (!want.smooth) continue;
      ++compared;
      SCOPED_TRACE(::testing::Message() << to_string(here.kind) << " by error " << k);
      const Sensitivity& got = r.sensitivities[k][0];
      EXPECT_NEAR(got.te, want.te, 1e-7 * std::abs(want.te) + 2e-14 / h);
      EXPECT_LT((got.point - want.point).norm(), 1e-4 * want.point.norm() + 1e-9 / h);
    }
  }
  EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace gearwright::property
