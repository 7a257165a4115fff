// Face widths of searches for drives. A search gives each mesh the least face width with the
// required safeties. The oracle rates the drive of the printed spec with other widths by the verb
// `rate`.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/job/drive_answer.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/parse_spec.hpp"

namespace gearwright {
namespace {

constexpr const char* kSizedLoad =
    "[rating]\npower_kW = 11\nspeed_rpm = 1450\nlife_h = 20000\nquality = 6\n"
    "face_load_factor = 1.2\nmesh_load_factor = 1.1\napplication_factor = 1.25\n"
    "material = { name = \"16MnCr5\" }\n";
constexpr double kFlank = 1.2, kRoot = 1.5;  // required safeties

JobSpec sized_job(const std::string& toml) {
  return testing::taken(read_spec(toml, SpecFormat::toml));
}

Answer sized_search(const std::string& keys) {
  return testing::taken(answer_drive_search(
      sized_job("[search]\nsafety_flank_min = 1.2\nsafety_root_min = 1.5\n" + keys + kSizedLoad), 4,
      2));
}

Answer sized_rating(const Json& spec) {
  return testing::taken(answer_drive_rating(sized_job(toml_text(spec))));
}

// The names of the meshes that lack a required safety.
std::vector<std::string> weak_meshes(const Answer& rated) {
  std::vector<std::string> weak;
  for (const auto& [name, mesh] : rated.record["drive"]["meshes"].items()) {
    double flank = 1e9, root = 1e9;
    for (const Json& s : mesh["rating"]["S_H"]) flank = std::min(flank, s.get<double>());
    for (const Json& s : mesh["rating"]["S_F"]) root = std::min(root, s.get<double>());
    if (flank < kFlank || root < kRoot) weak.push_back(name);
  }
  return weak;
}

// Law: a set with computed face widths is green. If the face width of a mesh is one millimetre
// less, this mesh lacks a required safety.
TEST(SizedDrives, EveryMeshOfASetHasItsLeastWidth) {
  for (const std::string keys :
       {"kind = \"planetary\"\nratio = [4.4, 4.6]\nplanets = [3, 4]\nnormal_module_mm = [1, 2]\n"
        "face_width_mm = [10, 60]\nobjective = [\"size\", \"efficiency\"]\n",
        "kind = \"stepped\"\nratio = [9.3, 9.4]\nsun_teeth = [17, 20]\nplanet2_teeth = [17, 20]\n"
        "normal_module_mm = 2\nface_width_mm = [5, 60]\nobjective = \"size\"\n"}) {
    const Answer answer = sized_search(keys);
    const Json& search = answer.record["search"];
    ASSERT_GE(search["designs"].size(), 4u) << keys;
    std::size_t left_out = 0, uneven = 0;
    for (const auto& [reason, count] : search["left_out"].items())
      left_out += count.get<std::size_t>();
    EXPECT_EQ(search["computed"], left_out + search["designs"].size());
    const double band = keys.find("[10, 60]") != std::string::npos ? 10 : 5;
    for (std::size_t i = 0; i < search["designs"].size(); ++i) {
      const Json& design = search["designs"][i];
      EXPECT_GE(design["safety_flank"], kFlank);
      EXPECT_GE(design["safety_root"], kRoot);
      Json taken = answer.specs[i];
      Json& widths = taken["planetary"]["face_width_mm"];
      EXPECT_EQ(design["face_widths_mm"], widths);
      const Json chosen = widths;
      const Answer rated = sized_rating(taken);
      EXPECT_EQ(rated.verdict->level, Level::green) << rated.verdict->headline;
      EXPECT_EQ(weak_meshes(rated), std::vector<std::string>());
      for (const char* central : {"sun", "ring", "ring2"}) {
        if (!chosen.contains(central) || chosen[central] <= band) continue;
        widths = chosen;
        widths[central] = chosen[central].get<double>() - 1;
        const auto weak = weak_meshes(sized_rating(taken));
        ASSERT_EQ(weak.size(), 1u) << keys << i << central;
        EXPECT_NE(weak.front().find(central), std::string::npos);
      }
      if (chosen.contains("ring") && chosen["ring"] != chosen["sun"]) ++uneven;
      if (chosen.contains("ring2") && chosen["ring2"] != chosen["sun"]) ++uneven;
    }
    EXPECT_GT(uneven, 0u);
  }
}

// A sun drives a planet that meshes with two rings (3K). The planet spans both rings, and each mesh
// has its least width. With one millimetre less, the mesh of the ring or of the sun lacks a
// required safety.
TEST(SizedDrives, ThePlanetOfTwoRingsSpansTheirLeastWidths) {
  const Answer answer = sized_search(
      "kind = \"wolfrom\"\nratio = [-95, 95]\nsun_teeth = [14, 16]\nplanet_teeth = [18, 19]\n"
      "normal_module_mm = [4, 5]\nface_width_mm = [8, 90]\nobjective = \"size\"\n");
  const Json& designs = answer.record["search"]["designs"];
  ASSERT_GE(designs.size(), 2u);
  for (std::size_t i = 0; i < std::min<std::size_t>(designs.size(), 3); ++i) {
    Json taken = answer.specs[i];
    Json& widths = taken["planetary"]["face_width_mm"];
    const Json chosen = widths;
    EXPECT_EQ(designs[i]["face_widths_mm"], chosen);
    EXPECT_EQ(chosen["planet"].get<double>(), chosen["ring"].get<double>() +
                                                  chosen["ring2"].get<double>() +
                                                  2 * designs[i]["normal_module_mm"].get<double>());
    const Answer rated = sized_rating(taken);
    EXPECT_EQ(rated.verdict->level, Level::green) << rated.verdict->headline;
    EXPECT_EQ(weak_meshes(rated), std::vector<std::string>());
    for (const char* central : {"sun", "ring", "ring2"}) {
      if (chosen[central] <= 8) continue;
      widths = chosen;
      widths[central] = chosen[central].get<double>() - 1;
      const auto weak = weak_meshes(sized_rating(taken));
      ASSERT_FALSE(weak.empty()) << i << central;
      EXPECT_NE(weak.front().find(central), std::string::npos);
    }
  }
}

// The oracle rates all pairs of widths of the two stages. The narrowest train with the required
// safeties has the widths of the search.
TEST(SizedDrives, ATrainIsTheNarrowestOfAllWidths) {
  const Answer answer = sized_search(
      "kind = \"train\"\nratio = [9.9, 10.1]\npinion_teeth = [19, 21]\nwheel_teeth = [60, 70]\n"
      "normal_module_mm = 3\nface_width_mm = [14, 40]\nobjective = \"size\"\n");
  ASSERT_GE(answer.specs.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    Json taken = answer.specs[i];
    const Json first = taken["stage"][0]["face_width_mm"],
               second = taken["stage"][1]["face_width_mm"];
    double least = kInfinity;
    std::array<double, 2> best{};
    for (double a = 14; a <= 40; a += 1)
      for (double b = 14; b <= 40; b += 1) {
        if (a + b > least) continue;  // no narrower train
        taken["stage"][0]["face_width_mm"] = a;
        taken["stage"][1]["face_width_mm"] = b;
        if (!weak_meshes(sized_rating(taken)).empty()) continue;
        least = a + b;
        best = {a, b};
      }
    EXPECT_EQ(first, best[0]) << i;
    EXPECT_EQ(second, best[1]) << i;
    EXPECT_NE(first, second);
  }
}

}  // namespace
}  // namespace gearwright
