// Laws of the contact of the meshes of a drive: (1) it equals, bit by bit, the result of the verb
// `contact` for the spec of the mesh that the drive prints; (2) it is the contact that the verdict
// of the drive judges, which is computed from the gears of the drive in their sense of rotation;
// (3) a drive without [errors] and [contact] has it only on request.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "gearwright/base/testing/taken.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/job/drive_answer.hpp"
#include "gearwright/job/drive_job.hpp"
#include "gearwright/spec/json.hpp"

namespace gearwright {
namespace {

// The verdict uses 256 positions.
constexpr const char* kErrors =
    "[errors]\ncrossing_deg = 0.02\nintersecting_deg = 0.03\naxial_mm = 0.2\n"
    "helix_slope1_um = 6\n[contact]\npositions = 256\n";

// Gears with different flanks. The second and the fourth mesh of the train turn counter-clockwise.
constexpr const char* kGear =
    "normal_module_mm = 2, helix_angle_deg = 12, face_width_mm = 20, modifications = { "
    "right_lead_slope_um = 9, left_lead_slope_um = -4, right_lead_crowning_um = 5, "
    "left_lead_crowning_um = 8 }";

std::string contact_train() {
  std::string text = kErrors;
  for (const char* teeth : {"19", "21", "23"})
    text += std::string("[[stage]]\ngears = [ { teeth = ") + teeth + ", " + kGear +
            " }, { teeth = 58, modifications = { right_profile_slope_um = 3, "
            "left_lead_slope_um = 2 } } ]\n";
  return text;
}

constexpr const char* kHelicalSet =
    "[planetary]\nsun = 20\nplanet = 25\nring = 70\nplanets = 3\nnormal_module_mm = 2\n"
    "helix_angle_deg = 12\nface_width_mm = 20\nthickness_allowance_mm = -0.05\ntorque_Nm = 40\n";

std::string halves_drive(const char* helix) {
  return std::string(kErrors) + "[drive]\ninput = \"a\"\noutput = \"c\"\n" +
         "[[drive.body]]\nname = \"a\"\n[[drive.body]]\nname = \"b\"\n[[drive.body]]\nname = "
         "\"c\"\n" +
         "[[drive.gear]]\nname = \"one\"\nbody = \"a\"\nteeth = 20\nnormal_module_mm = 2\n"
         "face_width_mm = 40\nhelix_angle_deg = " +
         helix +
         "\ndouble_helical = { gap_mm = 8 }\nmodifications = { right_lead_slope_um = 7, "
         "left_lead_slope_um = -3, lead_crowning_um = 5 }\n"
         "[[drive.gear]]\nname = \"two\"\nbody = \"b\"\nteeth = 40\nnormal_module_mm = 2\n"
         "face_width_mm = 40\nhelix_angle_deg = -" +
         helix +
         "\ndouble_helical = { gap_mm = 8 }\n"
         "[[drive.gear]]\nname = \"three\"\nbody = \"c\"\nteeth = 40\nnormal_module_mm = 2\n"
         "face_width_mm = 40\nhelix_angle_deg = " +
         helix +
         "\ndouble_helical = { gap_mm = 8 }\n"
         "[[drive.mesh]]\ngears = [\"one\", \"two\"]\n[[drive.mesh]]\ngears = [\"two\", "
         "\"three\"]\n";
}

constexpr const char* kRackDrive =
    "[drive]\ninput = \"shaft\"\noutput = \"bar\"\n"
    "[[drive.body]]\nname = \"shaft\"\n[[drive.body]]\nname = \"bar\"\n"
    "[[drive.gear]]\nname = \"pinion\"\nbody = \"shaft\"\nteeth = 20\nnormal_module_mm = 2\n"
    "helix_angle_deg = 8\n"
    "[[drive.gear]]\nname = \"rack\"\nbody = \"bar\"\nform = \"rack\"\n"
    "[[drive.mesh]]\ngears = [\"pinion\", \"rack\"]\n";

JobSpec contact_spec(const std::string& toml) {
  return testing::taken(read_spec(toml, SpecFormat::toml));
}

std::vector<std::string> contact_drives() {
  return {contact_train(), kErrors + std::string(kHelicalSet), halves_drive("25"),
          kErrors + std::string(kRackDrive),
          "[contact]\npattern = true\nmap = { x = \"axial_mm\", x_range = [-0.1, 0.3], y = "
          "\"crossing_deg\", y_range = [0, 0.02], points = [3, 2] }\n" +
              std::string(kHelicalSet)};
}

TEST(DriveContactTest, IsTheContactOfThePrintedSpec) {
  for (const std::string& toml : contact_drives()) {
    const Answer answer = testing::taken(answer_drive(contact_spec(toml)));
    const DriveSpecs specs = answer.drive_specs();
    const Json& meshes = answer.record["drive"]["meshes"];
    std::size_t m = 0;
    for (const auto& [name, mesh] : meshes.items()) {
      const JobSpec pair = contact_spec(toml_text(specs.meshes[m++]));
      const Json alone = testing::taken(answer_json("contact", pair))["contact"];
      EXPECT_GT(alone["positions"].size(), 10u);
      EXPECT_EQ(json_text(mesh["contact"]), json_text(alone)) << name << "\n" << toml;
    }
  }
}

TEST(DriveContactTest, IsTheContactThatTheVerdictJudges) {
  bool turned = false;
  for (const std::string& toml : contact_drives()) {
    const JobSpec spec = contact_spec(toml);
    if (!spec.errors.any()) continue;
    const Answer answer = testing::taken(answer_drive(spec));
    const Drive drive = testing::taken(solve_drive(spec)).drive;
    const DriveSpecs specs = answer.drive_specs();
    for (std::size_t m = 0; m < drive.graph.meshes.size(); ++m) {
      const std::string& name = drive.graph.meshes[m].name;
      const Json& contact = answer.record["drive"]["meshes"][name]["contact"];
      ASSERT_TRUE(drive.contacts[m]) << name;
      const MeshContact& judged = *drive.contacts[m];
      const bool rack = contact.contains("peak_to_peak_um");
      const double unit = rack ? kUmPerMm * judged.driving.rack.radius : kArcsecPerRad;
      const char* key = rack ? "peak_to_peak_um" : "peak_to_peak_arcsec";
      const double tolerance = 1e-9 * judged.driving.peak_to_peak.rad() * unit;
      EXPECT_NEAR(contact[key], judged.driving.peak_to_peak.rad() * unit, tolerance) << name;
      EXPECT_NEAR(contact["non_working_flank"][key], judged.other.peak_to_peak.rad() * unit,
                  tolerance)
          << name;
      EXPECT_GT(judged.driving.peak_to_peak.rad(), 1e-6) << name;
      EXPECT_EQ(contact["positions"].size(), judged.driving.positions.size());
      for (const std::string& note : specs.notes[m])
        turned = turned || note.starts_with("In the drive, gear 1");
    }
  }
  EXPECT_TRUE(turned);
}

TEST(DriveContactTest, IsAbsentUnlessItIsRequested) {
  const JobSpec spec = contact_spec(kHelicalSet);
  const auto contacts = [&](const DriveParts& parts) {
    return testing::taken(solve_whole_drive(spec, parts)).drive.analyses.size();
  };
  EXPECT_EQ(contacts({}), 0u);
  EXPECT_EQ(contacts({.contact = Wanted::yes}), 2u);
  const JobSpec with_errors = contact_spec(kErrors + std::string(kHelicalSet));
  EXPECT_EQ(
      testing::taken(solve_whole_drive(with_errors, {.contact = Wanted::no})).drive.analyses.size(),
      0u);
}

}  // namespace
}  // namespace gearwright
