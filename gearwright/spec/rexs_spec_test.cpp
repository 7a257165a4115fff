// Laws: (1) the text of a model reads back to the model   (2) a chain of stages is in the order of
// its shafts, and a planetary stage, alone or in a chain, has the teeth of its members   (3) broken
// input is an error   (4) a gear or a stage that is no part of the drive that is read is an error
// with its name   (5) a number that is read is a decimal number in the unit of its attribute; other
// texts and units are errors, or notes if no stage uses the component.
#include "gearwright/spec/rexs_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace gearwright {
namespace {

std::string file(const std::string& relations, const std::string& components,
                 const std::string& version = "1.5") {
  return "<?xml version=\"1.0\"?><model applicationId=\"test\" version=\"" + version +
         "\"><relations>" + relations + "</relations><components>" + components +
         "</components></model>";
}

std::string gear(const std::string& id, int teeth, const char* type = "cylindrical_gear") {
  return "<component id=\"" + id + "\" type=\"" + type + "\" name=\"g" + id +
         "\"><attribute id=\"number_of_teeth\" unit=\"none\">" + std::to_string(teeth) +
         "</attribute><attribute id=\"normal_module\" unit=\"mm\">2.0</attribute>"
         "<attribute id=\"u_axis_vector\" unit=\"mm\"><array><c>1.0</c></array></attribute>"
         "</component>";
}

std::string component(const std::string& id, const char* type, const std::string& inside = "") {
  return "<component id=\"" + id + "\" type=\"" + type + "\">" + inside + "</component>";
}

std::string stage(const std::string& id, const std::string& one, const std::string& two) {
  return "<relation type=\"stage\"><ref role=\"gear_2\" id=\"" + two +
         "\"/><ref role=\"stage\" id=\"" + id + "\"/><ref role=\"gear_1\" id=\"" + one +
         "\"/></relation>";
}

std::string on(const std::string& shaft, const std::string& part) {
  return "<relation type=\"assembly\"><ref role=\"assembly\" id=\"" + shaft +
         "\"/><ref role=\"part\" id=\"" + part + "\"/></relation>";
}

RexsSpec read(const std::string& xml) {
  const auto model = read_rexs(xml);
  EXPECT_TRUE(model) << (model ? "" : model.error().rule);
  auto spec = spec_of_rexs(*model);
  EXPECT_TRUE(spec) << (spec ? "" : spec.error().rule);
  return std::move(spec).take();
}

std::string rexs_refusal(const std::string& xml) {
  const auto text = spec_text_of_rexs(xml);
  EXPECT_FALSE(text);
  return text ? "" : text.error().rule;
}

TEST(Rexs, AStageIsAPair) {
  const RexsSpec s = read(
      file(stage("3", "1", "2") + "<relation type=\"flank\"><ref role=\"gear\" id=\"1\"/><ref "
                                  "role=\"left\" id=\"4\"/></relation>",
           gear("1", 17) + gear("2", 61, "ring_gear") +
               component("3", "cylindrical_stage",
                         "<attribute id=\"center_distance\" unit=\"mm\">44.5</attribute>") +
               component("4", "flank_geometry",
                         "<attribute id=\"addendum_modification_coefficient\">0.3</attribute>"
                         "<attribute id=\"normal_pressure_angle\" unit=\"deg\">25.0</attribute>") +
               component("5", "concept_bearing")));
  EXPECT_EQ(s.tables["gear1"]["teeth"], 17);
  EXPECT_EQ(s.tables["gear1"]["profile_shift"], 0.3);
  EXPECT_EQ(s.tables["gear1"]["normal_pressure_angle_deg"], 25.0);
  EXPECT_EQ(s.tables["gear2"]["teeth"], -61);
  EXPECT_EQ(s.tables["pair"]["center_distance_mm"], 44.5);
  ASSERT_EQ(s.notes.size(), 1u);
  EXPECT_NE(s.notes[0].find("concept_bearing (1)"), std::string::npos);
}

// The rack of gear 1 is not that of gear 2, which has no tool, alone or in a chain.
TEST(Rexs, AGearWithoutAToolHasTheUsualRack) {
  const std::string tool =
      component("t", "rack_shaped_tool",
                "<attribute id=\"addendum_coefficient_reference_profile\">1.35</attribute>");
  const std::string cut =
      "<relation type=\"reference\"><ref role=\"origin\" id=\"1\"/><ref role=\"referenced\" "
      "id=\"t\"/></relation>";
  const std::string gears = gear("1", 16) + gear("2", 47, "ring_gear");
  const RexsSpec pair =
      read(file(stage("3", "1", "2") + cut, gears + tool + component("3", "cylindrical_stage")));
  EXPECT_EQ(pair.tables["gear1"]["rack"]["dedendum"], 1.35);
  EXPECT_EQ(pair.tables["gear2"]["rack"], "ISO53-A");
  ASSERT_EQ(pair.notes.size(), 1u);
  EXPECT_NE(pair.notes[0].find("gear \"g2\""), std::string::npos);
  const Json chain =
      read(file(stage("3", "1", "2") + stage("4", "5", "6") + cut + on("s1", "1") + on("s2", "2") +
                    on("s2", "5") + on("s3", "6"),
                gears + gear("5", 20) + gear("6", 40) + tool + component("3", "cylindrical_stage") +
                    component("4", "cylindrical_stage") + component("s1", "shaft") +
                    component("s2", "shaft") + component("s3", "shaft")))
          .tables["stage"];
  EXPECT_EQ(chain[0]["gears"][1]["rack"], "ISO53-A");
  EXPECT_FALSE(chain[1]["gears"][1].contains("rack"));
}

// A pair whose stage and shaft have this attribute, and whose gear 1 has these teeth.
std::string pair_with(const std::string& attribute, const std::string& teeth = "17") {
  const std::string gear_1 =
      "<component id=\"1\" type=\"cylindrical_gear\" name=\"g1\"><attribute "
      "id=\"number_of_teeth\" unit=\"none\">" +
      teeth + "</attribute></component>";
  return file(stage("3", "1", "2") + on("s", "1"),
              gear_1 + gear("2", 61) + component("s", "shaft", attribute) +
                  component("3", "cylindrical_stage", attribute));
}

TEST(Rexs, ANumberThatIsReadIsADecimalNumber) {  // (5)
  const auto distance = [](const std::string& text) {
    return pair_with("<attribute id=\"center_distance\" unit=\"mm\">" + text + "</attribute>");
  };
  for (const char* text : {"78,5", "NaN", "inf", "1e400", "78.5 mm", "2;3", "0x4E", "-"}) {
    const std::string rule = rexs_refusal(distance(text));
    EXPECT_NE(rule.find(std::string("component cylindrical_stage 3 has `center_distance` = \"") +
                        text + "\", which is not a number"),
              std::string::npos)
        << rule;
  }
  EXPECT_EQ(read(distance("+7.85e1")).tables["pair"]["center_distance_mm"], 78.5);
  for (const char* teeth : {"17.5", "999999999999", "0x2", "-100001"})
    EXPECT_NE(rexs_refusal(pair_with("", teeth)).find("component \"g1\" has `number_of_teeth`"),
              std::string::npos)
        << teeth;
  EXPECT_EQ(read(pair_with("", "17.0")).tables["gear1"]["teeth"], 17);
  // An attribute that is not read may have any text.
  read(pair_with("<attribute id=\"comment\" unit=\"mm\">3,5</attribute>"));
}

TEST(Rexs, ANumberThatIsReadHasTheUnitOfItsAttribute) {  // (5)
  const auto with = [](const char* attribute, const char* unit) {
    return pair_with(std::string("<attribute id=\"") + attribute + "\" unit=\"" + unit +
                     "\">78.5</attribute>");
  };
  for (const char* unit : {"inch", "mum", "none"})
    EXPECT_NE(
        rexs_refusal(with("center_distance", unit)).find("convert the value to the unit \"mm\""),
        std::string::npos);
  EXPECT_NE(rexs_refusal(with("rotational_speed", "rad / s")).find("\"1 / min\""),
            std::string::npos);
  for (const char* unit : {"mm", ""})
    EXPECT_EQ(read(with("center_distance", unit)).tables["pair"]["center_distance_mm"], 78.5);
  read(with("rotational_speed", "1/min"));
  for (const char* unit : {"deg", "°"}) {
    RexsComponent gear{"1", "ring_gear", ""};
    gear.set("helix_angle_reference_diameter", 15, unit);
    EXPECT_FALSE(rexs_number_error(gear));
  }
}

TEST(Rexs, AWrongNumberOfAnUnusedComponentIsANote) {  // (5)
  const auto with_spare_shaft = [](const std::string& relations) {
    std::string xml = pair_with("");
    xml.insert(xml.find("</relations>"), on("u", "1") + on("u", "99") + relations);
    xml.insert(xml.find("</components>"),
               component("u", "gear_unit") +
                   component("99", "shaft",
                             "<attribute id=\"rotational_speed\" unit=\"1 / min\">78,5"
                             "</attribute>"));
    return xml;
  };
  const RexsSpec s = read(with_spare_shaft(""));
  const char* const named = "component shaft 99 has `rotational_speed` = \"78,5\"";
  EXPECT_TRUE(std::any_of(s.notes.begin(), s.notes.end(), [&](const std::string& note) {
    return note.find(named) != std::string::npos;
  }));
  EXPECT_NE(rexs_refusal(with_spare_shaft(on("99", "2"))).find(named), std::string::npos);
}

TEST(Rexs, StagesAreInTheOrderOfTheirShafts) {
  // Stage 20 comes first in the file and last in the chain. Its first gear is the output.
  const std::string relations = stage("20", "4", "3") + stage("10", "1", "2") + on("s1", "1") +
                                on("s2", "2") + on("s2", "3") + on("s3", "4") + on("s1", "9");
  const std::string components =
      gear("1", 20) + gear("2", 60) + gear("3", 21) + gear("4", 84) +
      component("10", "cylindrical_stage") + component("20", "cylindrical_stage") +
      component("s3", "shaft") + component("s1", "shaft") + component("s2", "shaft") +
      component("9", "external_load",
                "<attribute id=\"torque_around_u_axis\">-12.5</attribute>"
                "<attribute id=\"defines_torque\">true</attribute>");
  const RexsSpec s = read(file(relations, components));
  ASSERT_EQ(s.tables["stage"].size(), 2u);
  EXPECT_EQ(s.tables["stage"][0]["torque_Nm"], 12.5);
  EXPECT_EQ(s.tables["stage"][0]["gears"][1]["teeth"], 60);
  EXPECT_EQ(s.tables["stage"][1]["gears"][0]["teeth"], 21);
  EXPECT_EQ(s.tables["stage"][1]["gears"][1]["teeth"], 84);
}

TEST(Rexs, TheTorqueOfGear1IsPreferred) {
  const auto load = [](const char* id, const char* torque) {
    return component(id, "external_load",
                     std::string("<attribute id=\"torque_around_u_axis\">") + torque +
                         "</attribute><attribute id=\"defines_torque\">true</attribute>");
  };
  const std::string relations =
      stage("10", "1", "2") + on("s1", "1") + on("s2", "2") + on("s1", "8") + on("s2", "9");
  const std::string gears = gear("1", 20) + gear("2", 60) + component("10", "cylindrical_stage") +
                            component("s1", "shaft") + component("s2", "shaft");
  const Json both = read(file(relations, gears + load("8", "12.5") + load("9", "-30"))).tables;
  EXPECT_EQ(both["load"], (Json{{"torque_Nm", 12.5}}));
  const Json second = read(file(relations, gears + load("9", "-30"))).tables;
  EXPECT_EQ(second["load"], (Json{{"torque_Nm", 10.0}, {"driver", 2}}));
}

TEST(Rexs, APlanetaryStageHasItsMembers) {
  const std::string relations =
      stage("10", "1", "2") + stage("11", "1", "3") + stage("12", "2", "4") + stage("13", "3", "4");
  std::string components = gear("1", 18) + gear("2", 24) + gear("3", 24) +
                           gear("4", 66, "ring_gear") + component("5", "planetary_stage");
  for (const char* id : {"10", "11", "12", "13"}) components += component(id, "cylindrical_stage");
  const Json set = read(file(relations, components)).tables["planetary"];
  EXPECT_EQ(set["sun"], 18);
  EXPECT_EQ(set["planet"], 24);
  EXPECT_EQ(set["ring"], -66);
  EXPECT_EQ(set["planets"], 2);
}

// A set with one planet. The sun 1, the planet 2 and the ring 4 are on the shafts s1, s2 and s4,
// and sc is the shaft of the carrier. The casing is c. The sun turns backwards, and its load is l.
struct SetFile {
  std::string relations = stage("10", "1", "2") + stage("12", "2", "4") + on("s1", "1") +
                          on("s2", "2") + on("s4", "4") + on("s1", "l") +
                          role("planet_shaft", "s2") + role("planet_carrier_shaft", "sc");
  std::string components =
      gear("1", 18) + gear("2", 24) + gear("4", 66, "ring_gear") +
      component("5", "planetary_stage") + component("10", "cylindrical_stage") +
      component("12", "cylindrical_stage") +
      component("s1", "shaft",
                "<attribute id=\"rotational_speed\" unit=\"1 / min\">-100</attribute>"
                "<attribute id=\"defines_speed\">true</attribute>") +
      component("s2", "shaft") + component("s4", "shaft") + component("sc", "shaft") +
      component("c", "gear_casing") +
      component("l", "external_load", "<attribute id=\"transmits_torque\">true</attribute>");

  static std::string role(const char* type, const std::string& shaft) {
    return std::string("<relation type=\"") + type +
           "\"><ref role=\"planetary_stage\" id=\"5\"/><ref role=\"shaft\" id=\"" + shaft +
           "\"/></relation>";
  }
  // Couples two parts. If `engaged` is given, the coupling is switchable and has this state.
  SetFile& couple(const std::string& inner, const std::string& outer,
                  const char* engaged = nullptr) {
    const std::string id = "k" + inner + outer;
    components += engaged ? component(id, "switchable_coupling",
                                      std::string("<attribute id=\"is_engaged\"><array><c>") +
                                          engaged + "</c></array></attribute>")
                          : component(id, "coupling");
    relations += "<relation type=\"side\"><ref role=\"outer_part\" id=\"" + outer +
                 "\"/><ref role=\"inner_part\" id=\"" + inner + "\"/><ref role=\"assembly\" id=\"" +
                 id + "\"/></relation>";
    return *this;
  }
  std::string text() const { return file(relations, components); }
};

TEST(Rexs, AGearBesideAPlanetMayHaveNoTeeth) {
  SetFile f;
  f.components += component("9", "cylindrical_gear");
  f.relations += on("s2", "9");
  EXPECT_EQ(read(f.text()).tables["planetary"]["planet"], 24);
}

TEST(Rexs, TheHeldMemberIsCoupledWithTheCasing) {
  const Json ring = read(SetFile().couple("s4", "c").text()).tables["planetary"];
  EXPECT_EQ(ring["fixed"], "ring");
  EXPECT_EQ(ring["input"], "sun");
  EXPECT_EQ(ring["speed_rpm"], 100.0);
  EXPECT_FALSE(ring.contains("output"));
  // There is a further shaft between the carrier and the casing, and the coupling of the ring is
  // open.
  SetFile far = SetFile().couple("sc", "s9").couple("s9", "c", "true").couple("s4", "c", "false");
  far.components += component("s9", "shaft");
  EXPECT_EQ(read(far.text()).tables["planetary"]["fixed"], "carrier");
  // Without a coupling, the only member without a load is held.
  SetFile loads;
  loads.components +=
      component("m", "external_load", "<attribute id=\"transmits_torque\">true</attribute>");
  loads.relations += on("s4", "m");
  const Json by_loads = read(loads.text()).tables["planetary"];
  EXPECT_EQ(by_loads["fixed"], "carrier");
  EXPECT_EQ(by_loads["output"], "ring");
  // A file without loads and without held members has a note.
  const RexsSpec bare = read(SetFile().text());
  EXPECT_FALSE(bare.tables["planetary"].contains("fixed"));
  EXPECT_NE(bare.notes[0].find("which member is held"), std::string::npos);
}

TEST(Rexs, ADifferentCopyOfAPlanetHasANote) {
  const auto notes_with = [](const char* tip, const char* distance) {
    const std::string relations = stage("10", "1", "2") + stage("11", "1", "3") +
                                  stage("12", "2", "4") + stage("13", "3", "4");
    std::string components =
        gear("1", 18) + gear("4", 66, "ring_gear") + component("5", "planetary_stage") +
        component("12", "cylindrical_stage") + component("13", "cylindrical_stage");
    for (const char* id : {"2", "3"})
      components += component(id, "cylindrical_gear",
                              std::string("<attribute id=\"number_of_teeth\">24</attribute>"
                                          "<attribute id=\"normal_module\">2</attribute>"
                                          "<attribute id=\"tip_diameter\">") +
                                  (id[0] == '2' ? "52" : tip) + "</attribute>");
    for (const char* id : {"10", "11"})
      components += component(id, "cylindrical_stage",
                              std::string("<attribute id=\"center_distance\">") +
                                  (id[1] == '0' ? "42" : distance) + "</attribute>");
    std::string notes;
    for (const std::string& note : read(file(relations, components)).notes) notes += note;
    return notes;
  };
  EXPECT_EQ(notes_with("52.0", "42").find("(id"), std::string::npos);
  EXPECT_NE(
      notes_with("51.5", "42").find("`tip_diameter` of cylindrical_gear 3 (id 3) is not read"),
      std::string::npos);
  EXPECT_NE(notes_with("52", "42.5").find("`center_distance` of cylindrical_stage 11 (id 11)"),
            std::string::npos);
}

TEST(Rexs, AChainMayContainPlanetarySets) {
  SetFile f = SetFile().couple("s4", "c");
  f.components += gear("6", 20) + gear("7", 40) + component("20", "cylindrical_stage") +
                  component("s6", "shaft",
                            "<attribute id=\"rotational_speed\" unit=\"1 / min\">300</attribute>"
                            "<attribute id=\"defines_speed\">true</attribute>");
  f.relations += stage("20", "7", "6") + on("s6", "6") + on("s1", "7");
  const Json stages = read(f.text()).tables["stage"];
  ASSERT_EQ(stages.size(), 2u);
  EXPECT_EQ(stages[0]["gears"][0]["teeth"], 20);
  EXPECT_EQ(stages[0]["speed_rpm"], 300.0);
  const Json& set = stages[1]["planetary"];
  EXPECT_EQ(set["ring"], -66);
  EXPECT_EQ(set["fixed"], "ring");
  EXPECT_EQ(set["input"], "sun");
  EXPECT_EQ(set["output"], "carrier");
  EXPECT_FALSE(set.contains("speed_rpm"));
}

TEST(Rexs, WhatIsNotReadIsNamed) {
  const auto with = [](const std::string& gears, const std::string& relations) {
    SetFile f;
    f.components += gears + component("20", "cylindrical_stage");
    f.relations += relations;
    return rexs_refusal(f.text());
  };
  // The files have a second sun on the shaft of the first, a stage in front of the set whose first
  // gear has no shaft, and a sun that meshes with both gears of a stepped planet.
  EXPECT_NE(with(gear("6", 20), stage("20", "6", "2") + on("s1", "6")).find("gear \"g6\""),
            std::string::npos);
  EXPECT_NE(with(gear("6", 20) + gear("7", 40), stage("20", "6", "7") + on("s1", "7"))
                .find("the 2 stages do not form a chain"),
            std::string::npos);
  EXPECT_NE(with(gear("6", 25), stage("20", "1", "6") + on("s2", "6")).find("gear \"g1\""),
            std::string::npos);
  EXPECT_NE(rexs_refusal(SetFile().couple("s1", "s4").text()).find("connect ring with sun"),
            std::string::npos);
  SetFile bevel;
  bevel.components += component("b", "bevel_stage");
  EXPECT_NE(rexs_refusal(bevel.text()).find("bevel_stage b is a bevel_stage"), std::string::npos);
}

TEST(Rexs, AModelReadsBack) {
  RexsModel model{"1.7", "a & b", {}, {}};
  model.components.push_back({"1", "cylindrical_gear", "<\"pinion\">"});
  model.components.back().set("normal_module", 0.1 + 0.2, "mm");
  model.components.back().set("number_of_teeth", 17, "none");
  model.components.back().flag("transmits_torque");
  model.relations.push_back({"stage", {{"gear_1", "1"}}});
  for (const char* name : {"a.rexs", "a.rexsj", "a.rexsz"}) {
    const auto again = read_rexs(rexs_bytes(model, name));
    ASSERT_TRUE(again) << again.error().rule;
    EXPECT_EQ(again->version, "1.7");
    EXPECT_EQ(again->application, "a & b");
    EXPECT_EQ(again->components[0].name, "<\"pinion\">");
    EXPECT_EQ(again->components[0].attributes, model.components[0].attributes);
    EXPECT_EQ(again->components[0].units, model.components[0].units);
    EXPECT_EQ(again->relations[0].of("gear_1"), "1");
  }
}

TEST(Rexs, AZeroHasNoSign) {
  RexsComponent ring{"1", "ring_gear", ""};
  ring.set("helix_angle_reference_diameter", -0.0, "deg");
  EXPECT_EQ(ring.text("helix_angle_reference_diameter"), "0");
}

// The members of a JSON file are those of the public samples: ids are numbers, and the type of a
// value is its name. A list with one number is a value, and longer lists are not read.
TEST(Rexs, JsonIsReadAsXml) {
  const auto model = read_rexs(R"( {"model": {"version": "1.4", "applicationId": "Other",
      "relations": [{"id": 7, "type": "stage", "refs": [{"id": 2, "role": "gear_1", "hint": "g"}]}],
      "components": [{"id": 2, "type": "cylindrical_gear", "attributes": [
        {"id": "number_of_teeth", "unit": "none", "integer": 17},
        {"id": "face_width", "unit": "mm", "floating_point": 50.0},
        {"id": "defines_speed", "unit": "none", "boolean": true},
        {"id": "material", "unit": "none", "string": "16MnCr5"},
        {"id": "series", "unit": "none", "boolean": false},
        {"id": "one", "unit": "mm", "floating_point_array": [0.5]},
        {"id": "axis", "unit": "mm", "floating_point_array": [1.0, 0.0, 0.0]}, 3]}, null]}})");
  ASSERT_TRUE(model) << model.error().rule;
  EXPECT_EQ(model->relations[0].of("gear_1"), "2");
  const RexsComponent& gear = *model->find("2");
  EXPECT_EQ(gear.name, "");
  EXPECT_EQ(gear.number("number_of_teeth"), 17.0);
  EXPECT_EQ(gear.number("face_width"), 50.0);
  EXPECT_EQ(gear.text("defines_speed"), "true");
  EXPECT_EQ(gear.text("material"), "16MnCr5");
  EXPECT_EQ(gear.number("one"), 0.5);
  for (const char* absent : {"axis", "series"}) EXPECT_FALSE(gear.text(absent));
}

TEST(Rexs, BrokenInputIsAnError) {
  EXPECT_NE(rexs_refusal("gear1 = 3").find("XML"), std::string::npos);
  EXPECT_NE(rexs_refusal("<model version=\"1.0\"><components>").find("line 1"), std::string::npos);
  EXPECT_NE(rexs_refusal("<other/>").find("`model`"), std::string::npos);
  EXPECT_NE(rexs_refusal(file("", "", "3.1")).find("3.1"), std::string::npos);
  EXPECT_NE(rexs_refusal(file("", "")).find("no cylindrical stage"), std::string::npos);
  EXPECT_NE(rexs_refusal(file(stage("3", "1", "2"), component("3", "cylindrical_stage")))
                .find("does not have two cylindrical gears"),
            std::string::npos);
  EXPECT_NE(rexs_refusal("{\"model\": ").find("not JSON"), std::string::npos);
  for (const char* other : {"{}", "{\"gear1\": {}}"})
    EXPECT_NE(rexs_refusal(other).find("`model`"), std::string::npos);
  for (const char* empty : {"{\"model\": 3}", "{\"model\": {\"version\": [1]}}"})
    EXPECT_NE(rexs_refusal(empty).find("REXS version \"\""), std::string::npos);
  EXPECT_NE(rexs_refusal("{\"model\": {\"version\": \"1.4\", \"components\": 3}}").find("no cyl"),
            std::string::npos);
  std::string deep, deep_json;
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  for (int i = 0; i < 100'000; ++i) deep_json += "{\"a\":";
  for (const std::string& text : {deep, deep_json})
    EXPECT_NE(rexs_refusal(text).find("nested"), std::string::npos);
  const std::string apart = stage("10", "1", "2") + stage("11", "3", "4");
  EXPECT_NE(rexs_refusal(file(apart, gear("1", 20) + gear("2", 40) + gear("3", 20) + gear("4", 40) +
                                         component("10", "cylindrical_stage") +
                                         component("11", "cylindrical_stage")))
                .find("do not form a chain"),
            std::string::npos);
}

}  // namespace
}  // namespace gearwright
