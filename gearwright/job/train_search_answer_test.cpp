// Searches for trains: (1) a search with a list of modules finds a train that is not larger than
// the smallest train of a search with any single one of them; (2) the axial forces on an
// intermediate shaft have opposite directions; (3) each stage has the least module with which it
// has the required safeties; (4) the spec of a design describes the drive that the search computed;
// (5) with several objectives, a short list contains the Pareto front of the complete list, if
// there is room.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "gearwright/arrange/drive_designs.hpp"
#include "gearwright/base/numbers.hpp"
#include "gearwright/drive/drive_forces.hpp"
#include "gearwright/job/drive_answer.hpp"
#include "gearwright/job/drive_job.hpp"
#include "gearwright/spec/json.hpp"
#include "gearwright/spec/parse_spec.hpp"
#include "gearwright/spec/read_drive.hpp"
#include "gearwright/spec/read_search.hpp"

namespace gearwright {
namespace {

Result<Answer> trains_of(const std::string& modules, const std::string& keys, std::size_t top) {
  const auto spec = read_spec(
      "[search]\nkind = \"train\"\nhelix_angle_deg = 15\nobjective = \"size\"\nnormal_module_mm "
      "= " +
          modules + "\n" + keys +
          "[rating]\npower_kW = 5.5\nspeed_rpm = 1450\nlife_h = 20000\nquality = 7\n"
          "application_factor = 1.25\nface_load_factor = 1.3\nmaterial = \"18CrNiMo7-6\"\n",
      SpecFormat::toml);
  EXPECT_TRUE(spec) << spec.error().message();
  return answer_drive_search(*spec, top, 2);
}

// Law (1). The sets of each module are numerous enough for the estimate of the safeties.
TEST(TrainSearchAnswerTest, AListOfModulesFindsATrainAsSmallAsEachModule) {
  const std::string keys =
      "ratio = [11.8, 12.2]\npinion_teeth = [17, 28]\nwheel_teeth = [50, 110]\n"
      "face_width_mm = [15, 60]\nsafety_flank_min = 1.5\nsafety_root_min = 1.6\n";
  constexpr std::size_t kTop = 4;
  double smallest = kInfinity;
  long long hopeless = 0;
  for (const char* module : {"1.25", "2", "2.5"}) {
    const auto alone = trains_of(module, keys, kTop);
    ASSERT_TRUE(alone) << alone.error().message();
    const Json& search = alone->record["search"];
    EXPECT_GT(search["feasible_count"], 1000) << module;
    EXPECT_EQ(search["beyond_limit"], 0);
    hopeless += search["hopeless"].get<long long>();
    for (const Json& design : search["designs"])
      smallest = std::min(smallest, design["size_mm"].get<double>());
  }
  EXPECT_GT(hopeless, 1000);
  const auto all = trains_of("[1.25, 2, 2.5]", keys, kTop);
  ASSERT_TRUE(all) << all.error().message();
  const Json& designs = all->record["search"]["designs"];
  ASSERT_EQ(designs.size(), kTop);
  constexpr double kRounding = 1e-12;  // of the sum of the centre distances
  EXPECT_LE(designs[0]["size_mm"], smallest * (1 + kRounding));
}

// Law (4). Each candidate gets shifts and face widths that its search would not choose.
TEST(TrainSearchAnswerTest, TheSpecOfACandidateDescribesTheDriveThatIsRated) {
  const std::string common =
      "normal_module_mm = [2, 3]\nhelix_angle_deg = 12\nface_width_mm = [10, 40]\n"
      "friction_coefficient = 0.07\nspeed_rpm = 900\ntorque_Nm = 40\nmaterial = \"16MnCr5\"\n";
  for (const std::string kind :
       {"kind = \"train\"\nstages = 3\nratio = [-21, -20]\npinion_teeth = [17, 19]\nwheel_teeth = "
        "[45, 56]\nbacklash_mm = [0.1, 0.2]\n",
        "kind = \"train\"\nratio = [11.9, 12]\npinion_teeth = [17, 22]\nthickness_allowance_mm = "
        "-0.04\n",
        "kind = \"planetary\"\nratio = [4, 5]\nmesh_efficiency = { sun_planet = 0.98 }\n",
        "kind = \"stepped\"\nratio = [6, 7]\nplanets = [2, 4]\nprofile_shift = { planet = 0.2 "
        "}\n"}) {
    const auto spec = read_spec("[search]\n" + kind + common, SpecFormat::toml);
    ASSERT_TRUE(spec) << spec.error().message();
    const DriveSearchProblem problem = read_drive_search(spec->tree->tables["search"]);
    const auto found = search_drives(problem);
    ASSERT_TRUE(found && found->found.size() > 2) << kind;
    for (DriveCandidate c : {found->found.front(), found->found[1], found->found.back()}) {
      c.face_widths = {20.25, 18.5, 31.0};
      c.shifts = {0.125, 0.0625, -0.1, 0.3};
      if (!c.stages.empty()) c.shifts.resize(2 * c.stages.size(), 0.21);
      const auto own = drive_of(problem, c);
      const auto read = read_spec_tree(drive_spec(*spec, problem, c), {}, SpecUse::geometry);
      ASSERT_TRUE(own) << own.error().message();
      ASSERT_TRUE(read) << read.error().message();
      const Json& tree = read->tree->tables;
      // The materials are read from the spec of the search on one side, and from the spec of the
      // candidate on the other.
      EXPECT_EQ(json_text(expanded_spec(spec->tree->tables, *own)["drive"]),
                json_text(expanded_spec(tree, *read->drive)["drive"]));
    }
  }
}

// Law (3). With a given face width, the safeties of a stage depend on its own module only, so the
// least modules of the stages are found one by one with the verb `rate`.
TEST(TrainSearchAnswerTest, EveryStageHasItsLeastModule) {
  const std::vector<double> modules{1.25, 1.5, 2, 2.5, 3, 4};
  const auto answer = trains_of("[1.25, 1.5, 2, 2.5, 3, 4]",
                                "ratio = [11.8, 12.2]\npinion_teeth = [19, 20]\n"
                                "wheel_teeth = [66, 70]\nface_width_mm = 30\n"
                                "safety_flank_min = 1.2\nsafety_root_min = 1.4\n",
                                2);
  ASSERT_TRUE(answer) << answer.error().message();
  ASSERT_EQ(answer->specs.size(), 2u);
  EXPECT_FALSE(answer->record["search"]["designs"][0]["stage_modules_mm"].is_null());
  for (std::size_t i = 0; i < answer->specs.size(); ++i) {
    const Json& found = answer->record["search"]["designs"][i];
    const auto safe = [&](std::size_t stage, double module) {
      Json tree = answer->specs[i];
      tree["stage"][stage]["normal_module_mm"] = module;
      const auto spec = read_spec(toml_text(tree), SpecFormat::toml);
      const auto job = solve_drive(*spec);
      EXPECT_TRUE(job);
      Drive drive = job->drive;
      EXPECT_FALSE(drive_rater(*spec)(drive));
      const Rating& r = drive.ratings[stage]->rating;
      return std::min(r.S_H[0].value, r.S_H[1].value) >= 1.2 &&
             std::min(r.S_F[0].value, r.S_F[1].value) >= 1.4;
    };
    double size = 0.0;
    for (const std::size_t stage : {0, 1}) {
      const auto least =
          std::find_if(modules.begin(), modules.end(), [&](double m) { return safe(stage, m); });
      ASSERT_NE(least, modules.end());
      EXPECT_EQ(found["stage_modules_mm"].is_null() ? found["normal_module_mm"]
                                                    : found["stage_modules_mm"][stage],
                *least);
      const Json& teeth = found["stages"][stage];
      size += *least * (teeth[0].get<int>() + teeth[1].get<int>()) / 2 /
              std::cos(15 * std::acos(-1.0) / 180);
    }
    EXPECT_NEAR(found["size_mm"].get<double>(), size, 1e-9);
  }
}

// A search for trains whose stages have their own modules, without profile shifts.
struct StageSearch {
  StageSearch(const std::string& keys, double power_kW)
      : spec(read_spec("[search]\nkind = \"train\"\nprofile_shift = 0\n" + keys +
                           "[rating]\nspeed_rpm = 1450\nlife_h = 20000\nquality = 7\n"
                           "face_load_factor = 1.3\nmaterial = \"18CrNiMo7-6\"\npower_kW = " +
                           std::to_string(power_kW) + "\n",
                       SpecFormat::toml)) {
    EXPECT_TRUE(spec) << spec.error().message();
    task.problem = read_drive_search(spec->tree->tables["search"]);
    task.problem.module_per_stage = true;
    task.rate = drive_rater(*spec);
  }

  Result<JobSpec> spec;
  DriveDesignTask task{{}, 0.5, {1.1, 1.2}};
};

// Law (3). The second stage has the greatest module. Its own pinion limits its face width, so its
// safeties do not depend on the module of the first stage. That module is therefore the least one
// with the required safeties.
TEST(TrainSearchAnswerTest, AStageHasItsLeastModuleBesideAStageWithTheGreatestOne) {
  struct Case {
    double power_kW, face_diameters;
    std::array<int, 2> pinions;
  };
  const std::vector<double> modules{1, 1.5, 2, 2.5, 3};
  for (const auto& [power_kW, face_diameters, z] :
       {Case{24, 1.1, {29, 24}}, Case{48, 1.0, {25, 28}}, Case{40, 1.2, {20, 29}}}) {
    StageSearch search(
        "normal_module_mm = [1, 1.5, 2, 2.5, 3]\nratio = [5, 16]\n"
        "face_width_mm = [5, 200]\n",
        power_kW);
    search.task.problem.face_diameters = face_diameters;
    DriveCandidate train;
    train.stages = {{z[0], 70}, {z[1], 70}};
    train.stage_modules = {1, 3};
    const DriveOutcome found = DriveDesigner(search.task)(train);
    ASSERT_TRUE(std::holds_alternative<FoundDrive>(found)) << power_kW;
    search.task.problem.module_per_stage = false;  // the modules of the candidate are not changed
    const auto least = std::find_if(modules.begin(), modules.end(), [&](double m) {
      return std::holds_alternative<FoundDrive>(
          DriveDesigner(search.task)(with_modules(search.task.problem, train, {m, 3})));
    });
    EXPECT_EQ(std::get<FoundDrive>(found).candidate.stage_modules,
              (std::vector<double>{*least, 3}));
  }
}

// Law (5).
TEST(TrainSearchAnswerTest, AShortListContainsTheParetoFront) {
  StageSearch search(
      "objective = [\"size\", \"ratio\"]\nnormal_module_mm = [1.5, 2, 2.5, 3, 4, 5]\n"
      "ratio = [9, 14]\npinion_teeth = [20, 21]\nwheel_teeth = [70, 72]\nface_width_mm = 30\n",
      30);
  for (const bool per_stage : {true, false}) {
    search.task.problem.module_per_stage = per_stage;
    const auto result = search_drives(search.task.problem, 2);
    ASSERT_TRUE(result);
    const auto all = drive_designs(search.task, *result, 1000, 2);
    const auto few = drive_designs(search.task, *result, 2, 2);
    ASSERT_TRUE(all && few);
    EXPECT_EQ(all->pareto.size(), per_stage ? 3u : 2u);
    EXPECT_LE(few->list.size(), 4u);
    const auto stages_of = [](const DriveDesigns& designs) {
      std::vector<std::vector<std::array<int, 2>>> front;
      for (const std::size_t i : designs.pareto) front.push_back(designs.list[i].candidate.stages);
      return front;
    };
    EXPECT_EQ(stages_of(*few), stages_of(*all)) << per_stage;
  }
}

// A search with coaxial_teeth makes trains whose output has the axis of the input.
TEST(TrainSearchAnswerTest, TheTrainsOfCoaxialTeethAreCoaxial) {
  for (const auto& [stages, ratio] :
       {std::pair{"2", "[8.9, 9.1]"}, std::pair{"3", "[-30, -29.9]"}}) {
    const auto spec = read_spec(std::string("[search]\nkind = \"train\"\nhelix_angle_deg = 12\n"
                                            "normal_module_mm = 2\ncoaxial_teeth = 1\n"
                                            "pinion_teeth = [19, 24]\nwheel_teeth = [50, 80]\n"
                                            "stages = ") +
                                    stages + "\nratio = " + ratio + "\n",
                                SpecFormat::toml);
    ASSERT_TRUE(spec) << spec.error().message();
    const auto answer = answer_drive_search(*spec, 5, 2);
    ASSERT_TRUE(answer) << answer.error().message();
    ASSERT_EQ(answer->specs.size(), 5u) << stages;
    for (const Json& found : answer->specs) {
      const auto job = solve_drive(*read_spec(toml_text(found), SpecFormat::toml));
      ASSERT_TRUE(job) << job.error().message();
      ASSERT_TRUE(job->places);
      EXPECT_LT(job->places->axes[job->drive.graph.output].norm(), 1e-6);
    }
  }
}

// Returns the centre distances of a found train, from its spec.
std::vector<double> distances_of(const Json& found) {
  const auto job = solve_drive(*read_spec(toml_text(found), SpecFormat::toml));
  EXPECT_TRUE(job) << job.error().message();
  std::vector<double> list;
  for (const auto& a : job->drive.geometry.distance) list.push_back(a.value());
  return list;
}

// A limit of the centre distances loses no train that has such distances without the limit. With a
// single number, every stage has this distance.
TEST(TrainSearchAnswerTest, TheStagesHaveTheGivenCentreDistances) {
  const auto trains = [](const std::string& limit) {
    const auto spec = read_spec(
        "[search]\nkind = \"train\"\nratio = [8.9, 9.1]\npinion_teeth = [14, 19]\n"
        "wheel_teeth = [45, 60]\nhelix_angle_deg = 12\nnormal_module_mm = 2\n" +
            limit,
        SpecFormat::toml);
    EXPECT_TRUE(spec) << spec.error().message();
    const auto answer = answer_drive_search(*spec, 1000, 2);
    EXPECT_TRUE(answer) << answer.error().message();
    std::vector<std::pair<Json, std::vector<double>>> list;  // numbers of teeth, centre distances
    for (std::size_t i = 0; i < answer->specs.size(); ++i) {
      const Json& design = answer->record["search"]["designs"][i];
      list.emplace_back(design["stages"],
                        design["stage_center_distances_mm"].get<std::vector<double>>());
      if (i % 8 != 0) continue;
      const std::vector<double> own = distances_of(answer->specs[i]);
      for (const std::size_t k : {0, 1}) EXPECT_NEAR(list.back().second[k], own[k], 1e-9);
    }
    return list;
  };
  const auto lies_in = [](const std::vector<double>& distances, double least, double most) {
    constexpr double kRounding = 1e-9;
    return std::all_of(distances.begin(), distances.end(),
                       [&](double a) { return a > least - kRounding && a < most + kRounding; });
  };
  const auto all = trains("");
  const auto near = trains("center_distance_mm = [68, 72]\n");
  const auto exact = trains("center_distance_mm = 70\n");
  std::size_t kept = 0;
  for (const auto& [stages, distances] : all) {
    if (!lies_in(distances, 68, 72)) continue;
    ++kept;
    EXPECT_TRUE(std::any_of(near.begin(), near.end(), [&, &own = stages](const auto& n) {
      return n.first == own;
    })) << stages;
  }
  EXPECT_GT(kept, 10u);
  EXPECT_LT(kept, all.size() / 2);
  EXPECT_GT(near.size(), kept);
  EXPECT_GT(exact.size(), 10u);
  for (const auto& train : near) EXPECT_TRUE(lies_in(train.second, 68, 72)) << train.first;
  for (const auto& train : exact) EXPECT_TRUE(lies_in(train.second, 70, 70)) << train.first;
}

// Rated stages have the modules that their centre distance permits. Equal centre distances permit a
// coaxial output.
TEST(TrainSearchAnswerTest, RatedStagesHaveTheGivenCentreDistance) {
  const auto answer = trains_of("[1.5, 2, 2.5]",
                                "ratio = [9, 9.3]\npinion_teeth = [17, 25]\n"
                                "wheel_teeth = [48, 75]\nface_width_mm = [10, 45]\n"
                                "center_distance_mm = 82\ncoaxial_teeth = 30\n",
                                5);
  ASSERT_TRUE(answer) << answer.error().message();
  ASSERT_EQ(answer->specs.size(), 5u);
  std::size_t coaxial = 0;
  for (const Json& found : answer->specs) {
    for (const double a : distances_of(found)) EXPECT_NEAR(a, 82, 1e-9);
    if (!found["stage"][1].contains("angle_deg")) continue;
    ++coaxial;
    const auto job = solve_drive(*read_spec(toml_text(found), SpecFormat::toml));
    EXPECT_LT(job->places->axes[job->drive.graph.output].norm(), 1e-6);
  }
  EXPECT_GT(coaxial, 0u);
}

// Three stages with the default numbers of teeth have more than a million trains.
TEST(TrainSearchAnswerTest, TooManyTrainsAreRefused) {
  const auto answer = trains_of("2", "ratio = [-500, -5]\nstages = 3\n", 4);
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().field, "search.stages");
  EXPECT_NE(answer.error().rule.find("wheel_teeth"), std::string::npos);
}

// A stage with too much sliding excludes all trains that contain it before they are computed.
TEST(TrainSearchAnswerTest, TheSlidingOfAStageIsComputedOnce) {
  const std::string keys =
      "ratio = [11.8, 12.2]\npinion_teeth = [17, 28]\nwheel_teeth = [50, 110]\n";
  const auto answer = trains_of("2", keys + "sliding_max = 1.4\n", 4);
  ASSERT_TRUE(answer) << answer.error().message();
  const Json& search = answer->record["search"];
  EXPECT_EQ(search["beyond_limit"], 0);
  const Json& left_out = search["left_out"];
  EXPECT_GT(left_out["sliding"], 500);
  EXPECT_EQ(search["computed"].get<std::size_t>(),
            search["designs"].size() + left_out["no_teeth"].get<std::size_t>() +
                left_out["safety"].get<std::size_t>() + left_out["verdict"].get<std::size_t>());
  for (const Json& design : search["designs"]) EXPECT_LE(design["sliding_max"], 1.4);
}

// If the spec gives neither a limit nor the shifts, rated trains have the limit of rated pairs.
TEST(TrainSearchAnswerTest, SlidingIsLimitedByDefault) {
  const auto greatest = [](const std::string& more) {
    const auto answer =
        trains_of("[1.25, 1.5, 2]",
                  "ratio = [13.72, 13.74]\npinion_teeth = [19, 25]\nwheel_teeth = [70, 103]\n"
                  "face_width_mm = 37\n" +
                      more,
                  100);
    EXPECT_TRUE(answer) << answer.error().message();
    double most = 0.0;
    for (const Json& design : answer->record["search"]["designs"])
      most = std::max(most, design["sliding_max"].get<double>());
    return most;
  };
  const double limited = greatest("");
  EXPECT_GT(limited, 2.0);
  EXPECT_LE(limited, 3.0);
  EXPECT_GT(greatest("sliding_max = 50\n"), 3.0);
  EXPECT_GT(greatest("profile_shift = 0\n"), 3.0);
}

// If no train has the safeties, the advice names keys of trains.
TEST(TrainSearchAnswerTest, AdviceForUnsafeTrainsIsForTrains) {
  const auto answer = trains_of("1.5",
                                "ratio = [11.8, 12.2]\npinion_teeth = [17, 28]\n"
                                "wheel_teeth = [50, 110]\nsafety_flank_min = 9\n",
                                4);
  ASSERT_TRUE(answer) << answer.error().message();
  const Json& search = answer->record["search"];
  EXPECT_EQ(search["hopeless"], search["feasible_count"]);
  const std::string text = answer->listing();
  EXPECT_NE(text.find("greater pinion_teeth"), std::string::npos) << text;
  EXPECT_EQ(text.find("planets or"), std::string::npos) << text;
}

// The ratio of three external stages is negative, so no band of positive ratios contains it.
TEST(TrainSearchAnswerTest, AdviceForARatioOfTheOtherSignNamesTheSign) {
  for (const auto& [ratio, sign] : {std::pair{"ratio = [20, 22]\nstages = 3\n", "negative"},
                                    std::pair{"ratio = [-12, -11]\n", "positive"}}) {
    const auto answer =
        trains_of("2", std::string(ratio) + "pinion_teeth = [17, 19]\nwheel_teeth = [40, 60]\n", 4);
    ASSERT_TRUE(answer) << answer.error().message();
    EXPECT_NE(answer->listing().find(std::string("stages is ") + sign), std::string::npos)
        << answer->listing();
  }
}

// Law (2). The forces of a gear and of its mate are opposite, so the forces on the shaft have
// opposite directions if its force is the difference of their magnitudes.
TEST(TrainSearchAnswerTest, AxialForcesOnAnIntermediateShaftAreOpposite) {
  const auto answer = trains_of("6",
                                "ratio = [-58, -56]\nstages = 3\npinion_teeth = 18\n"
                                "wheel_teeth = [68, 72]\nface_width_mm = 100\n",
                                1);
  ASSERT_TRUE(answer) << answer.error().message();
  ASSERT_FALSE(answer->specs.empty());
  const Json& stages = answer->specs[0]["stage"];
  ASSERT_EQ(stages.size(), 3u);
  EXPECT_EQ(stages[0]["helix_angle_deg"], 15);
  EXPECT_EQ(stages[1]["helix_angle_deg"], -15);
  EXPECT_EQ(stages[2]["helix_angle_deg"], 15);
  const auto spec = read_spec(toml_text(answer->specs[0]), SpecFormat::toml);
  ASSERT_TRUE(spec) << spec.error().message();
  const auto job = solve_drive(*spec);
  ASSERT_TRUE(job) << job.error().message();
  const DriveGraph& graph = job->drive.graph;
  std::size_t shafts = 0;
  for (std::size_t b = 0; b < graph.bodies.size(); ++b) {
    std::vector<double> axial;
    for (std::size_t m = 0; m < graph.meshes.size(); ++m)
      for (const int side : {0, 1})
        if (graph.gear(graph.meshes[m], side).body == b)
          axial.push_back(std::abs(mesh_forces(job->drive, m)->axial));
    if (axial.size() != 2) continue;
    ++shafts;
    const double sum = std::abs(body_forces(job->drive, b)->axial);
    EXPECT_NEAR(sum, std::abs(axial[0] - axial[1]), 1e-9 * (axial[0] + axial[1]));
    EXPECT_GT(std::min(axial[0], axial[1]), 100.0);
  }
  EXPECT_EQ(shafts, 2u);
}

}  // namespace
}  // namespace gearwright
