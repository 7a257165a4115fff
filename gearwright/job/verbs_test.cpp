#include "gearwright/job/verbs.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "gearwright/base/parallel.hpp"
#include "gearwright/catalogue/testing/document_blocks.hpp"

#ifndef GEARWRIGHT_STOP_AT_VIOLATIONS
namespace gearwright {
namespace {

// Odd numbers of teeth simulate a defect of the program in any thread.
Result<Json> computed(const JobSpec& spec) {
  const int teeth = spec.gears[0]->cylindrical.teeth;
  parallel_for(8, [&](std::size_t) { GW_EXPECTS(teeth % 2 == 0); });
  return answer_json("gear", spec);
}

TEST(BatchLine, a_violation_is_the_error_of_its_own_line) {
  constexpr int kLines = 40;
  for (const int threads : {1, 4}) {
    int next = 20;
    std::vector<std::string> lines;
    in_order(
        [&](std::string& line) {
          line = fmt::format(R"({{"gear1": {{"teeth": {}, "normal_module_mm": 2}}}})", next);
          return next++ < 20 + kLines;
        },
        [&](const std::string& line) {
          return [&, answer = batch_line(computed, line)] { lines.push_back(answer.text); };
        },
        threads);
    ASSERT_EQ(lines.size(), kLines);
    for (int i = 0; i < kLines; ++i) {
      const Json answer = Json::parse(lines[static_cast<std::size_t>(i)]);
      if (i % 2 == 0) {
        EXPECT_EQ(answer["gears"][0]["teeth"], 20 + i);
        continue;
      }
      EXPECT_EQ(answer["error"]["key"], "");
      EXPECT_EQ(answer["error"]["value"], "");
      EXPECT_EQ(answer["error"]["kind"], "defect");
      const std::string message = answer["error"]["message"];
      for (const char* words : {"teeth % 2 == 0", "verbs_test.cpp:", "please report it"})
        EXPECT_NE(message.find(words), std::string::npos) << message;
    }
  }
}

TEST(BatchLine, tells_a_violation_from_an_error_of_the_spec) {
  const auto line = [](int teeth) {
    return batch_line(computed,
                      fmt::format(R"({{"gear1": {{"teeth": {}, "normal_module_mm": 2}}}})", teeth))
        .outcome;
  };
  EXPECT_EQ(line(20), BatchLine::Outcome::answered);
  EXPECT_EQ(line(21), BatchLine::Outcome::violated);
  const BatchLine refused = batch_line(computed, "{}");
  EXPECT_EQ(refused.outcome, BatchLine::Outcome::failed);
  EXPECT_EQ(Json::parse(refused.text)["error"]["kind"], "missing") << refused.text;
}

TEST(Verbs, are_found_by_their_names) {
  for (const Verb& verb : verbs()) {
    EXPECT_EQ(find_verb(verb.name), &verb);
    EXPECT_TRUE(std::string_view(verb.example).starts_with(std::string("gearwright ") + verb.name));
    EXPECT_EQ(verb.take == Verb::Take::none, std::string_view(verb.take_meaning).empty());
  }
  EXPECT_EQ(find_verb("run"), nullptr);  // writes files
  EXPECT_EQ(find_verb(""), nullptr);
}

TEST(VerbDocument, TheTypeOfTheEngineIsTheTable) {
  constexpr const char* kTypes = "apps/web/engine/engine.d.ts";
  std::string made = "export type Verb =";
  for (const Verb& verb : verbs()) made += fmt::format(" \"{}\" |", verb.name);
  made.replace(made.size() - 2, 2, ";\n");
  std::string text = document(kTypes);
  const std::size_t from = text.find("export type Verb =");
  ASSERT_NE(from, std::string::npos);
  expect_document(kTypes, text.replace(from, text.find('\n', from) + 1 - from, made));
}

TEST(Verbs, answer_in_the_forms_that_their_rows_promise) {
  const auto spec = read_spec(
      R"({"gear1": {"teeth": 20, "normal_module_mm": 2, "face_width_mm": 20, "profile_shift": 0.2},
          "gear2": {"teeth": 41, "face_width_mm": 20, "profile_shift": 0}})",
      SpecFormat::json);
  ASSERT_TRUE(spec);
  for (const char* name : {"gear", "pair", "measure", "contact"}) {
    const Verb& verb = *find_verb(name);
    const auto answer = verb.run(*spec, nullptr);
    ASSERT_TRUE(answer) << name;
    EXPECT_EQ(static_cast<bool>(answer->csv), verb.csv) << name;
    EXPECT_EQ(answer->verdict.has_value(), verb.strict) << name;
    EXPECT_EQ(answer_json(*answer)["verdict"]["level"], "green") << name;
    EXPECT_NE(answer_text(*answer).find("Verdict: green"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace gearwright
#endif
