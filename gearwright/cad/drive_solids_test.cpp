// Laws of the solids of drives: (1) every gear is in one solid; (2) gears of one body are joined by
// a neck below their roots; (3) copies of a planet refer to the first; (4) laid out for printing,
// the solids stand on z = 0 and do not overlap.
#include "gearwright/cad/drive_solids.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/drive/short_forms.hpp"

namespace gearwright {
namespace {

std::vector<ToothedBody> solids_of(const DriveInput& input) {
  const Drive drive = testing::taken(make_drive(input));
  return testing::taken(drive_solids(drive, testing::taken(drive_layout(drive))));
}

DriveInput train() {
  StageSpec stage;
  stage.pair.teeth = {19, 57};
  for (const std::size_t i : {0, 1})
    stage.pair.specs[i] =
        CylindricalSpec{.teeth = stage.pair.teeth[i], .normal_module = 2.0, .face_width = 20.0};
  return testing::taken(train_of({stage, stage}));
}

DriveInput planets() {
  PlanetarySpec set;
  set.z(SetMember::sun) = 21;
  set.z(SetMember::planet) = 24;
  set.z(SetMember::ring) = 69;
  set.planets = 3;
  set.normal_module = 2.0;
  set.face_width.all = 20.0;
  return {testing::taken(graph_of(set))};
}

TEST(DriveSolids, the_gears_of_a_shaft_are_one_solid) {
  const std::vector<ToothedBody> solids = solids_of(train());
  ASSERT_EQ(solids.size(), 3u);  // (1) four gears on three shafts
  const std::vector<SolidGear> shaft = solids[1].gears();
  ASSERT_EQ(shaft.size(), 2u);
  const double neck = shaft[1].body->neck;
  EXPECT_GT(neck, 0.0);
  for (const SolidGear& gear : shaft)  // (2)
    EXPECT_LT(neck, gear.body->outline.arcs.front().begin_point.norm());
  EXPECT_GT(shaft[1].bottom(), shaft[0].top());
}

TEST(DriveSolids, planets_are_copies) {
  const std::vector<ToothedBody> solids = solids_of(planets());
  ASSERT_EQ(solids.size(), 5u);
  int copies = 0;
  for (const ToothedBody& solid : solids) copies += solid.same_as.has_value();
  EXPECT_EQ(copies, 2);  // (3)
}

TEST(DriveSolids, stand_side_by_side_on_the_plate) {
  for (const DriveInput& input : {train(), planets()}) {
    const std::vector<ToothedBody> plate = laid_out(solids_of(input));
    const auto radius = [](const ToothedBody& body) {
      double most = 0.0;
      for (const SolidGear& gear : body.gears())
        for (const Arc& arc : gear.body->outline.arcs)
          most = std::max({most, arc.begin_point.norm(), arc.end_point.norm()});
      return most;
    };
    for (std::size_t i = 0; i < plate.size(); ++i) {
      const std::vector<SolidGear> gears = plate[i].gears();
      const double side = plate[i].pose.axis(2).z();
      const double low = side > 0.0 ? gears.front().bottom() : -gears.back().top();
      EXPECT_NEAR(plate[i].pose.origin().z() + low, 0.0, 1e-12);  // (4)
      for (std::size_t k = 0; k < i; ++k) {
        const Vec3 apart = plate[i].pose.origin() - plate[k].pose.origin();
        EXPECT_GT(apart.head<2>().norm(), radius(plate[i]) + radius(plate[k]));
      }
    }
  }
}

}  // namespace
}  // namespace gearwright
