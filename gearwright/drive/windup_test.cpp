// Windup. Laws: (1) a single mesh has the variation of its contact lines; (2) the variation is that
// of a fine sampling of all copies with their delays; (3) it does not depend on a factor of the
// weights or on a common delay; (4) planets in sequence vary less than planets in phase, and N
// copies of a spur mesh whose delays differ by 1/N of a pitch vary like one mesh with the contact
// ratio N ε_α; (5) a drive without geometry has the value of the same drive with standard teeth.
#include "gearwright/drive/windup.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "gearwright/drive/short_forms.hpp"
#include "gearwright/pair/contact_lines.hpp"

namespace gearwright {
namespace {

// The rotation at a time, from thin slices of all teeth.
double sampled_rotation(const std::vector<WindupMesh>& meshes, double t) {
  constexpr int kSlices = 200;
  double sum = 0.0;
  for (const WindupMesh& mesh : meshes)
    for (const double delay : mesh.delays) {
      int touching = 0;
      for (int tooth = -8; tooth <= 8; ++tooth)
        for (int s = 0; s < kSlices; ++s) {
          const double face = mesh.overlap * ((s + 0.5) / kSlices - 0.5);
          const double place = t - delay + tooth + face;
          if (place > -mesh.approach && place < mesh.recess) ++touching;
        }
      sum += mesh.weight * (mesh.approach + mesh.recess) * kSlices / touching /
             static_cast<double>(mesh.delays.size());
    }
  return sum;
}

TEST(Windup, OneMeshVariesAsItsContactLines) {  // (1)
  for (const double overlap : {0.0, 0.3, 1.4}) {
    const auto alone = windup_variation(
        {WindupMesh{.approach = 0.7, .recess = 0.85, .overlap = overlap, .weight = 3.0}});
    EXPECT_NEAR(*alone, *deflection_variation(1.55, overlap), 1e-8) << overlap;
  }
  EXPECT_FALSE(windup_variation({WindupMesh{.approach = 0.4, .recess = 0.5}}));
  EXPECT_FALSE(windup_variation(std::vector<WindupMesh>()));
}

TEST(Windup, IsTheSpreadOfASampling) {  // (2), (3)
  std::mt19937 random(9);
  const auto number = [&](double lo, double hi) {
    return std::uniform_real_distribution(lo, hi)(random);
  };
  for (int n = 0; n < 12; ++n) {
    std::vector<WindupMesh> meshes;
    double whole = 0.0;
    for (int m = 0; m < 1 + n % 3; ++m) {
      WindupMesh& mesh = meshes.emplace_back();
      mesh.approach = number(0.5, 0.9);
      mesh.recess = number(0.6, 0.9);
      mesh.overlap = number(0.2, 1.6);
      mesh.weight = number(0.5, 2.0);
      mesh.delays.clear();
      for (int i = 0; i <= n % 4; ++i) mesh.delays.push_back(number(-1.0, 1.0));
      whole += mesh.weight;
    }
    double least = 1e300, greatest = 0.0;
    for (int i = 0; i < 500; ++i) {
      const double value = sampled_rotation(meshes, (i + 0.5) / 500);
      least = std::min(least, value);
      greatest = std::max(greatest, value);
    }
    const double variation = *windup_variation(meshes);
    EXPECT_NEAR(variation, (greatest - least) / whole, 0.03) << n;
    for (WindupMesh& mesh : meshes) {
      mesh.weight *= 7.0;
      for (double& delay : mesh.delays) delay += 0.37;
    }
    EXPECT_NEAR(*windup_variation(meshes), variation, 1e-9);
  }
}

TEST(Windup, SequenceSmoothsTheRotation) {  // (4)
  WindupMesh mesh{.approach = 0.8, .recess = 0.75};
  mesh.delays = {0.0, 0.0, 0.0};
  const double in_phase = *windup_variation({mesh});
  EXPECT_NEAR(in_phase, 1.55 * 0.5, 1e-12);
  mesh.delays = {0.0, 1.0 / 3, 2.0 / 3};
  // In total, 4 or 5 tooth pairs are in contact (3 ε_α = 4.65), because 1 or 2 of the three copies
  // are in double contact.
  EXPECT_NEAR(*windup_variation({mesh}), 1.55 * 0.5 / 3, 1e-12);
}

PlanetarySpec windup_set(int sun, int planet, int ring, int planets) {
  PlanetarySpec set;
  set.z(SetMember::sun) = sun;
  set.z(SetMember::planet) = planet;
  set.z(SetMember::ring) = ring;
  set.planets = planets;
  set.normal_module = 2.0;
  set.face_width.all = 20.0;
  return set;
}

TEST(Windup, NumbersOfTeethGiveTheValueOfStandardTeeth) {  // (5)
  for (const auto& [sun, planet, ring, planets] : {std::array{24, 24, 72, 3},
                                                   {21, 27, 75, 3},
                                                   {22, 26, 74, 3},
                                                   {20, 28, 76, 4},
                                                   {25, 23, 71, 3},
                                                   {23, 27, 77, 4},
                                                   {24, 30, 84, 4}}) {
    for (const double helix_deg : {0.0, 12.0}) {
      const Angle helix = Angle::degrees(helix_deg);
      PlanetarySpec set = windup_set(sun, planet, ring, planets);
      set.helix_deg.all = helix_deg;
      set.tip_diameter.each[static_cast<std::size_t>(SetMember::ring)] =
          2.0 * (ring / std::cos(helix.rad()) - 2);
      StraightRack deep;  // its flanks begin below the tips of the ring
      deep.dedendum = 1.4;
      deep.root_fillet_radius = 0.2;
      DriveGraph graph = graph_of(set).value();
      for (DriveGear& gear : graph.gears) gear.spec->rack = deep;
      const auto exact = make_drive({graph}).value();
      for (const auto& pair : exact.geometry.pairs)  // no flank ends within the path
        ASSERT_NEAR(pair->involute()->mesh.true_ratio, pair->involute()->mesh.path_ratio, 1e-12);
      set.normal_module.reset();
      const auto bare = make_drive({graph_of(set).value()}).value();
      const auto with_teeth = windup_variation(exact);
      const auto without = windup_variation(bare, StandardTeeth{.helix_angle = helix});
      ASSERT_TRUE(with_teeth && without) << sun;
      EXPECT_FALSE(windup_variation(bare));
      EXPECT_NEAR(*with_teeth, *without, 1e-7) << sun << " " << planet << " " << helix_deg;
    }
  }
}

}  // namespace
}  // namespace gearwright
