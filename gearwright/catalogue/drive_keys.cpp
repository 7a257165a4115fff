#include "gearwright/catalogue/drive_keys.hpp"

#include <cmath>

#include "gearwright/base/units.hpp"
#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/catalogue/search_keys.hpp"

namespace gearwright {

namespace {

constexpr double kMostTeeth = 100'000;
constexpr std::size_t kMostBodies = 1000;
constexpr const char* kBodies = "a body or a list of bodies";
constexpr const char* kMembers = "a number, or a table of numbers by member";
constexpr const char* kMeshes = "a number, or a table of numbers by mesh";

// Makes a key whose value may have several forms. The reader of drives converts the value.
Key formed(std::string_view key, std::string_view form, std::string_view fallback,
           std::string_view meaning) {
  return {.key = key,
          .kind = KeyKind::any,
          .form = std::string(form),
          .fallback = fallback,
          .meaning = meaning};
}

Key tables_key(std::string_view key, const KeyTable& (*table)(), KeyPlace place,
               std::string_view must, std::string_view meaning) {
  return {.key = key,
          .kind = KeyKind::table,
          .list = KeyList{.most = kMostBodies, .must = must},
          .place = std::move(place),
          .tables = {table},
          .meaning = meaning};
}

Key member(SetMember which, std::string_view meaning, bool ring = false) {
  return Key::number(
      to_string(which), "z",
      ring ? KeyRange{.lo = -kMostTeeth, .hi = kMostTeeth, .zero = false}
           : KeyRange::between(1, kMostTeeth),
      KeyPlace::within<PlanetarySpec>([which](auto& set) -> auto& { return set.z(which); }), "",
      meaning);
}

Key bodies_key(std::string_view key, KeyPlace place, std::string_view fallback,
               std::string_view meaning) {
  return Key::text(key, std::move(place), fallback, meaning)
      .with_list({.least = 0,
                  .most = kMostBodies,
                  .single = true,
                  .must = "must be the name of a body, or a list of names"})
      .with_form(kBodies);
}

Key fixed_key(KeyPlace place) {
  return bodies_key("fixed", std::move(place), "the ring", "fixed body or list of fixed bodies");
}

Key speed_key(KeyPlace place) {
  return Key::number("speed_rpm", "n", {}, std::move(place), "", "speed of the input")
      .with_list({.most = kMostBodies, .single = true})
      .with_form("a number, or a list in the order of the inputs");
}
Key torque_key(KeyPlace place) {
  return Key::number("torque_Nm", "T", {}, std::move(place), "",
                     "torque on the first input, which determines the torques of the other bodies; "
                     "the torque of a single input has the sign of its speed")
      .with_list({.single = true,
                  .must = "must be one torque, which determines the torques of the other bodies"})
      .with_form("a number");
}

// Sets the torque P/ω. The speed is known, because its key comes before the key of the power.
// Returns the reason if the torque cannot be computed, and otherwise an empty text.
std::string set_power(const std::vector<double>& speeds_rpm, double power_kW,
                      std::optional<double>& torque_Nm) {
  if (speeds_rpm.empty() || speeds_rpm.front() == 0.0)
    return "needs the speed of the input, which must not be 0; give speed_rpm, or give torque_Nm "
           "in place of the power";
  torque_Nm = torque_of_power(power_kW, speeds_rpm.front());
  constexpr double kMostTorque_Nm = 1e9;
  if (!(std::abs(*torque_Nm) <= kMostTorque_Nm))
    return "gives a torque of more than 1e9 N m at this speed; give a greater speed_rpm or less "
           "power";
  return "";
}

// Makes the key of a power. `part` returns the member of T that contains the speeds and the torque
// of the input.
template <class T, class Part>
Key power_key(Part part) {
  const auto set = [part](T& input, double power) {
    return set_power(part(input).speeds_rpm, power, part(input).torque_Nm);
  };
  return Key::number("power_kW", "P", {}, KeyPlace::by<T, double>(set), "",
                     "power of the first input, in place of its torque; needs `speed_rpm`")
      .with_excludes({"torque_Nm"});
}

constexpr KeyList kOneOrTwo{.least = 2, .most = 2, .single = true};

template <class T>
Key series_key(std::string T::*member) {
  const auto set = [member](T& input, const std::string& name) {
    input.*member = name == kNoAllowances ? "" : name;
    return series_fault(name);
  };
  return Key::text("thickness_series", KeyPlace::by<T, std::string>(set), "nominal teeth",
                   "thickness allowances of all gears by DIN 3967, for example `\"cd25\"`; each "
                   "allowance is the mean of its two limits; `\"none\"` gives nominal teeth")
      .with_excludes({"thickness_allowance_mm"});
}

Key backlash_key(KeyPlace place, const char* form) {
  return Key::not_negative("backlash_mm", "j_n", std::move(place),
                           "backlash of the thickness allowances",
                           "backlash in the normal section, j_bn/cos α_wn; the teeth are thinned "
                           "to give this backlash, or the mean of a band")
      .with_form(form)
      .with_list({.most = 2,
                  .single = true,
                  .order = {.sentence = "must be a band of two numbers in rising order"},
                  .numbers = true})
      .with_excludes({"thickness_allowance_mm", "thickness_series"});
}

Key friction_key(KeyPlace place, std::string_view fallback = "0.05") {
  return Key::number("friction_coefficient", "μ", friction_range(), std::move(place), fallback,
                     "coefficient of friction of the flanks");
}

Key spacing_key(KeyPlace place, std::string_view fallback = "\"nearest\"") {
  return Key::word(
      "spacing", {"nearest", "equal", "equal_clocked", "opposite"}, std::move(place), fallback,
      "spacing of the planets. `nearest` places the planets at equal pitch if this is possible, "
      "otherwise at the nearest possible positions; `equal` requires equal pitch; "
      "`equal_clocked` requires equal pitch and turns the second gear of each stepped planet so "
      "that it meshes; `opposite` places the planets in opposite pairs");
}

Key idler_side_key(KeyPlace place, std::string_view meaning) {
  return Key::word("idler_side", {"counter_clockwise", "clockwise"}, std::move(place),
                   "\"counter_clockwise\"", meaning);
}

std::string set_teeth(StageInput& input, const std::array<int, 2>& teeth) {
  input.stage.pair.teeth = teeth;
  const auto possible = [](int z) { return z != 0 && std::abs(z) <= kMostTeeth; };
  if (possible(teeth[0]) && possible(teeth[1]) && teeth[0] > 0) return {};
  return "must be two whole numbers; the second number is negative for a ring";
}

// Makes the key of the bores of a stage. The value of a pair is one number or a list of two
// numbers. The value of a planetary set is a number or a table of numbers by member.
Key bore_key() {
  Key key = formed("bore_mm",
                   "a number, or a list of two numbers; for a planetary set, the same forms as in "
                   "[planetary]",
                   "no bore",
                   "diameters of the bores in the CAD files; a single number applies to both "
                   "gears, but not to a ring. If the second gear is a ring, the second number is "
                   "the outside diameter of its rim")
                .with_also({"bore", "bore_diameter_mm", "shaft_diameter_mm"});
  key.range = KeyRange::positive();
  key.list = kOneOrTwo;
  return key;
}

}  // namespace

const KeyTable& planetary_keys() {
  using P = PlanetarySpec;
  static const KeyTable table{
      "planetary",
      "A planetary set, given by its members",
      {member(SetMember::sun, "number of teeth of the sun"),
       member(SetMember::sun2,
              "number of teeth of a second sun, which meshes with `planet2` or, if there is no "
              "`planet2`, with `planet`"),
       member(
           SetMember::planet,
           "number of teeth of the planet; for a set of a sun and a ring, the default is half the "
           "difference of their numbers of teeth"),
       member(SetMember::planet2, "number of teeth of the second gear of a stepped planet"),
       member(SetMember::ring, "number of teeth of the ring, with either sign", true),
       member(SetMember::ring2,
              "number of teeth of a second ring, which meshes with `planet2` or, if there is no "
              "`planet2`, with `planet`",
              true),
       member(SetMember::idler, "number of teeth of an idler between sun and planet"),
       idler_side_key(&P::idler_side,
                      "side of the idler as seen from its planet, about the axis of the carrier, "
                      "seen from +z; the two sides are mirror images, so `\"clockwise\"` gives the "
                      "drive that turns in the other sense with all hands reversed"),
       Key::number("planets", "N", KeyRange::between(1, 1000), &P::planets, "1",
                   "number of planets"),
       Key::number("normal_module_mm", "m_n", KeyRange::between(1e-3, 1e3), &P::normal_module,
                   "no geometry", "normal module"),
       Key::number("normal_pressure_angle_deg", "α_n", KeyRange::between(1, 60),
                   &P::normal_pressure_angle, "20", "normal pressure angle"),
       Key::number("helix_angle_deg", "β", gear_keys().find("helix_angle_deg")->range,
                   &P::helix_deg, "0", "helix angle of the sun")
           .with_form(kMembers),
       Key::number("profile_shift", "x", gear_keys().find("profile_shift")->range,
                   &P::profile_shift, "computed from the centre distance", "profile shift")
           .with_form(kMembers),
       Key::number("thickness_allowance_mm", "E_sn", {}, &P::allowance, "0", "thickness allowance")
           .with_form(kMembers),
       series_key(&P::series),
       backlash_key(&P::backlash,
                    "a number, a band [least, greatest], or a table of numbers by mesh"),
       Key::number("face_width_mm", "b", KeyRange::positive(), &P::face_width, "10 m_n",
                   "face width; a planet that meshes with two rings or two suns has twice this "
                   "width plus a gap")
           .with_form(kMembers),
       Key::number("tip_diameter_mm", "d_a", KeyRange::positive(), &P::tip_diameter,
                   "determined by the basic rack and reduced if the tip clearance is too small; "
                   "for a ring, a diameter at which the tips of the ring touch only the flanks of "
                   "the planets",
                   "tip diameter")
           .with_form(kMembers),
       Key::number("bore_mm", "", KeyRange::positive(), &P::bore, "no bore",
                   "diameter of the bore in the CAD files; a single number applies to all gears "
                   "except rings; in a table, the number for a ring is the outside diameter of "
                   "its rim")
           .with_form(kMembers)
           .with_also({"bore", "bore_diameter_mm", "shaft_diameter_mm"}),
       Key::number("center_distance_mm", "a", KeyRange::positive(), &P::center_distance,
                   "backlash-free distance of the first mesh", "centre distance")
           .with_form(kMeshes),
       Key::number("mesh_efficiency", "η", KeyRange::above(0, 1), &P::efficiency,
                   "computed from `friction_coefficient` and the teeth",
                   "efficiency of the meshes when the carrier is at rest")
           .with_form(kMeshes),
       friction_key(&P::friction),
       fixed_key(&P::fixed),
       bodies_key("input", &P::inputs, "the sun", "driving body or list of driving bodies"),
       Key::text("output", &P::output, "the carrier", "body that is driven"),
       speed_key(&P::speeds_rpm),
       torque_key(&P::torque_Nm),
       power_key<P>([](P & p) -> auto& { return p; }),
       spacing_key(&P::spacing),
       Key::number(
           "positions_deg", "", {}, &P::positions_deg, "determined by `spacing`",
           "positions of the planets around the carrier, counter-clockwise from the first planet")
           .with_list({1, 1000}),
       formed(
           "material",
           "a name, a table with the keys of [gear1.material], or a table of such tables by member",
           "material of `[rating]`", "material of the teeth")}};
  return table;
}

namespace {

Key stage_angle() {
  Key key = formed("angle_deg", "a number, or `\"coaxial\"` in the last stage",
                   "the value of the previous stage",
                   "direction from the axis of the first gear of a pair to the axis of the second, "
                   "counter-clockwise; 0 for the first stage. `\"coaxial\"` computes the direction "
                   "that leads back to the axis of the input and, if necessary, also the absent "
                   "angle of the previous stage");
  key.kind = KeyKind::number;
  key.range = KeyRange::between(-360, 360);
  key.words = {"coaxial"};
  key.fields = {"angle"};
  return key;
}

}  // namespace

const KeyTable& stage_keys() {
  using S = StageInput;
  static const KeyTable table{
      "stage",
      "A stage of a train: a pair of gears or a planetary set; the stages are listed from the "
      "input to the output",
      {Key::number("teeth", "z", {}, KeyPlace::by<S, std::array<int, 2>>(set_teeth), "",
                   "numbers of teeth of a pair")
           .with_list({.least = 2, .most = 2})
           .with_form("two numbers, the second negative for a ring"),
       formed("gears", "two tables with the keys of [gear1]", "",
              "the two gears of a pair, each with its own keys"),
       Key::part("planetary", planetary_keys, {}, "a planetary set")
           .with_excludes({"teeth", "gears"}),
       Key::number("normal_module_mm", "m_n", KeyRange::between(1e-3, 1e3),
                   {&S::plain, &PairTeeth::normal_module}, "no geometry", "normal module"),
       Key::number("normal_pressure_angle_deg", "α_n", KeyRange::between(1, 60),
                   {&S::plain, &PairTeeth::normal_pressure_angle}, "20", "normal pressure angle"),
       Key::number("helix_angle_deg", "β", KeyRange::between(-89, 89),
                   {&S::plain, &PairTeeth::helix_deg}, "0", "helix angle of the first gear"),
       Key::positive("face_width_mm", "b", {&S::plain, &PairTeeth::face_width}, "10 m_n",
                     "face width"),
       Key::positive("center_distance_mm", "a", KeyPlace::within<S>([](S & s) -> auto& {
                       return s.stage.pair.center_distance;
                     }),
                     "backlash-free distance", "centre distance"),
       stage_angle(),
       Key::number("profile_shift", "x", gear_keys().find("profile_shift")->range,
                   KeyPlace::within<S>([](S & s) -> auto& { return s.stage.pair.shifts; }),
                   "computed from the centre distance", "profile shifts")
           .with_list(kOneOrTwo)
           .with_form("a number for both gears, or a list of two numbers"),
       Key::number("thickness_allowance_mm", "E_sn", {}, {&S::plain, &PairTeeth::allowance}, "0",
                   "thickness allowances")
           .with_list(kOneOrTwo)
           .with_form("a number, or a list of two numbers"),
       series_key(&S::series),
       backlash_key(&S::backlash,
                    "a number, or a band [least, greatest]; for a planetary set, the same forms as "
                    "in [planetary]"),
       bore_key(),
       Key::number("mesh_efficiency", "η", KeyRange::above(0, 1), &S::efficiency,
                   "computed from `friction_coefficient` and the teeth", "efficiency of the mesh")
           .with_form("a number; for a planetary set, the same forms as in [planetary]"),
       friction_key({&S::stage, &StageSpec::friction}),
       speed_key({&S::stage, &StageSpec::speeds_rpm}),
       torque_key({&S::stage, &StageSpec::torque_Nm}),
       power_key<S>([](S & s) -> auto& { return s.stage; }),
       formed("material", "a name, or a table with the keys of [gear1.material]",
              "material of `[rating]`", "material of the teeth of both gears")}};
  return table;
}

const KeyTable& stage_gear_keys() {
  static const KeyTable table = [] {
    // In a drive, no gear cuts its mating gear, and no gear has a shaft of its own.
    KeyTable t = gear_keys().without({"cut_by", "profile_shift_pair", "shaft"});
    t.name = "stage_gear";
    t.meaning = "A gear of a drive, with the keys of [gear1]";
    for (Key& key : t.keys) key.in_documents = false;
    return t;
  }();
  return table;
}

const KeyTable& drive_keys() {
  using I = GraphInput;
  static const KeyTable table{
      "drive",
      "A drive as a graph of bodies, gears and meshes; the other forms are translated into this "
      "form",
      {fixed_key(&I::fixed),
       bodies_key("input", &I::inputs, "", "driving body or list of driving bodies"),
       Key::text("output", &I::output, "", "body that is driven")
           .with_list({.single = true, .must = "must be the name of a body"})
           .with_form("a body"),
       speed_key({&I::graph, &DriveGraph::speeds_rpm}),
       torque_key({&I::graph, &DriveGraph::torque_Nm}),
       power_key<I>([](I & i) -> auto& { return i.graph; }),
       Key::number("speed_m_per_s", "v", {}, &I::speed_m_per_s, "",
                   "speed of an input that is a rack, in place of `speed_rpm`")
           .with_form("a number"),
       Key::number("force_N", "F", {}, &I::force_N, "",
                   "force on an input that is a rack, in place of `torque_Nm`")
           .with_form("a number"),
       spacing_key({&I::graph, &DriveGraph::spacing}),
       friction_key({&I::graph, &DriveGraph::friction}),
       tables_key("body", drive_body_keys, &I::bodies, "must be a list of tables, [[drive.body]]",
                  "a body that turns or moves"),
       tables_key("gear", drive_gear_keys, {}, "must be a list of tables, [[drive.gear]]",
                  "a gear on a body"),
       tables_key("mesh", drive_mesh_keys, &I::meshes, "must be a list of tables, [[drive.mesh]]",
                  "two gears that mesh")}};
  return table;
}

const KeyTable& drive_body_keys() {
  using B = GraphInput::Body;
  static const KeyTable table{
      "drive_body",
      "A body of the graph",
      {Key::text("name", {&B::body, &DriveBody::name}, kRequired, "name of the body"),
       Key::text("rides_on", &B::rides_on, "the housing", "carrier on which the planet is mounted")
           .with_form("a body"),
       Key::number("count", "N", KeyRange::between(1, 1000), {&B::body, &DriveBody::count}, "1",
                   "number of copies of a planet"),
       Key::number(
           "positions_deg", "", {}, {&B::body, &DriveBody::positions_deg},
           "determined by `spacing`",
           "positions of the copies around the carrier, counter-clockwise from the first copy")
           .with_list({1, 1000}),
       spacing_key({&B::body, &DriveBody::spacing}, "the value for the whole drive"),
       idler_side_key(
           {&B::body, &DriveBody::side},
           "side of a planet that meshes with an earlier planet, as seen from the earlier "
           "planet about the axis of the carrier, seen from +z")}};
  return table;
}

const KeyTable& drive_gear_keys() {
  static const KeyTable table = [] {
    KeyTable t{
        "drive_gear",
        "A gear of the graph, with the keys of [gear1]",
        {Key::text("name", KeyPlace::unused(), kRequired, "name of the gear"),
         Key::text("body", KeyPlace::unused(), kRequired, "body on which the gear is mounted"),
         Key::number("teeth", "z", KeyRange{.lo = -kMostTeeth, .hi = kMostTeeth, .zero = false},
                     {&GearInput::cylindrical, &CylindricalSpec::teeth},
                     "required, unless `form` is `\"rack\"`",
                     "number of teeth, negative for a ring"),
         Key::word("form", {"gear", "rack"}, KeyPlace::unused(), "\"gear\"",
                   "`\"rack\"` makes the gear a rack, whose body moves along a line"),
         Key::positive("height_mm", "", KeyPlace::unused(), "3 modules below the roots",
                       "height of a rack from its back to its datum line")
             .with_also({"height", "back"}),
         Key::positive("length_mm", "", KeyPlace::unused(), "determined by `teeth`",
                       "space for the teeth of a rack along the travel, in place of `teeth`")
             .with_also({"length"})
             .with_excludes({"teeth"})}};
    for (const Key& key : stage_gear_keys().keys)
      if (!t.find(key.key)) t.keys.push_back(key);
    return t;
  }();
  return table;
}

const KeyTable& drive_mesh_keys() {
  using M = GraphInput::Mesh;
  static const KeyTable table{
      "drive_mesh",
      "A mesh of the graph",
      {Key::text("gears", &M::gears, kRequired, "names of the gears that mesh")
           .with_list({.least = 2, .most = 2, .must = "must be the names of two gears"})
           .with_form("two gears"),
       Key::text("name", {&M::mesh, &DriveMesh::name}, "the names of the two gears, joined by _",
                 "name of the mesh"),
       Key::positive("center_distance_mm", "a", {&M::mesh, &DriveMesh::center_distance},
                     "backlash-free distance", "centre distance"),
       Key::number("backlash_mm", "j_n", KeyRange::not_negative(), {&M::mesh, &DriveMesh::backlash},
                   "backlash of the thickness allowances",
                   "backlash in the normal section, j_bn/cos α_wn; the teeth of both gears are "
                   "thinned to give this backlash, in place of their thickness allowances"),
       Key::number("efficiency", "η", KeyRange::above(0, 1), {&M::mesh, &DriveMesh::efficiency},
                   "computed from `friction_coefficient` and the teeth",
                   "efficiency of the mesh when its frame is at rest"),
       friction_key({&M::mesh, &DriveMesh::friction}, "the value for the whole drive"),
       Key::number(
           "angle_deg", "", KeyRange::between(-360, 360), {&M::mesh, &DriveMesh::direction}, "0",
           "direction from the axis of the first gear to the axis of the second gear, "
           "counter-clockwise; not allowed for planets, whose positions determine the direction")}};
  return table;
}

}  // namespace gearwright
