#include "gearwright/catalogue/drive_keys.hpp"

#include "gearwright/catalogue/gear_keys.hpp"
#include "gearwright/drive/short_forms.hpp"

namespace gearwright {

namespace {

constexpr double kMostTeeth = 100'000;
constexpr std::string_view kBodies = "a body or a list of bodies";
constexpr std::string_view kMembers = "a number, or a table of numbers by member";
constexpr std::string_view kMeshes = "a number, or a table of numbers by mesh";

// A key whose value may have several forms. The reader of drives converts the value.
Key formed(std::string_view key, std::string_view symbol, std::string_view form,
           std::string_view fallback, std::string_view meaning, KeyRange range = {}) {
  const bool required = fallback == kRequired;
  return {.key = key,
          .symbol = symbol,
          .kind = KeyKind::any,
          .range = std::move(range),
          .form = std::string(form),
          .required = required,
          .fallback = required ? std::string_view() : fallback,
          .meaning = meaning};
}

Key tables_key(std::string_view key, const KeyTable& (*table)(), std::string_view meaning) {
  return {.key = key,
          .kind = KeyKind::table,
          .list = KeyList{.least = 1, .most = 1000},
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

Key fixed_key() {
  return formed("fixed", "", kBodies, "the ring", "fixed body or list of fixed bodies");
}
Key speed_key() {
  return formed("speed_rpm", "n", "a number, or a list in the order of the inputs", "",
                "speed of the input");
}
Key torque_key() {
  return formed("torque_Nm", "T", "a number, or a list in the order of the inputs", "",
                "torque on the input");
}

Key series_key() {
  return Key::text("thickness_series", {}, "nominal teeth",
                   "thickness allowances of all gears by DIN 3967, for example `\"cd25\"`; each "
                   "allowance is the mean of its two limits; `\"none\"` gives nominal teeth")
      .with_excludes({"thickness_allowance_mm"});
}
Key backlash_key(std::string_view form) {
  return formed("backlash_mm", "j_n", form, "backlash of the thickness allowances",
                "backlash in the normal section, j_bn/cos α_wn, for which the teeth are thinned; "
                "for a band, the mean is used",
                KeyRange::not_negative())
      .with_excludes({"thickness_allowance_mm", "thickness_series"});
}

template <class Member>
Key friction_key(Member place, std::string_view fallback = "0.05") {
  return Key::not_negative("friction_coefficient", "μ", place, fallback,
                           "coefficient of friction of the flanks");
}

template <class Member>
Key spacing_key(Member place, std::string_view fallback = "\"nearest\"") {
  return Key::word(
      "spacing", {"nearest", "equal", "equal_clocked", "opposite"}, place, fallback,
      "spacing of the planets. `nearest` places the planets at equal pitch if they can be "
      "assembled there, otherwise at the nearest possible positions; `equal` requires equal pitch; "
      "`equal_clocked` requires equal pitch and turns the second gear of each stepped planet so "
      "that it meshes; `opposite` places the planets in opposite pairs");
}

}  // namespace

const KeyTable& planetary_keys() {
  using P = PlanetarySpec;
  static const KeyTable table{
      "planetary",
      "A planetary set, given by its members",
      {member(SetMember::sun, "number of teeth of the sun"),
       member(SetMember::sun2,
              "number of teeth of a second sun, which meshes with `planet2` or, without it, with "
              "`planet`"),
       member(SetMember::planet, "number of teeth of the planet"),
       member(SetMember::planet2, "number of teeth of the second gear of a stepped planet"),
       member(SetMember::ring, "number of teeth of the ring, with either sign", true),
       member(SetMember::ring2,
              "number of teeth of a second ring, which meshes with `planet2` or, without it, with "
              "`planet`",
              true),
       member(SetMember::idler, "number of teeth of an idler between sun and planet"),
       Key::number("planets", "N", KeyRange::between(1, 1000), &P::planets, "1",
                   "number of planets"),
       Key::number("normal_module_mm", "m_n", KeyRange::between(1e-3, 1e3), &P::normal_module,
                   "no geometry", "normal module"),
       Key::number("normal_pressure_angle_deg", "α_n", KeyRange::between(1, 60),
                   &P::normal_pressure_angle, "20", "normal pressure angle"),
       formed("helix_angle_deg", "β", kMembers, "0", "helix angle of the sun",
              gear_keys().find("helix_angle_deg")->range),
       formed("profile_shift", "x", kMembers, "computed from the centre distance", "profile shift",
              gear_keys().find("profile_shift")->range),
       formed("thickness_allowance_mm", "E_sn", kMembers, "0", "thickness allowance"),
       series_key(),
       backlash_key("a number, a band [least, greatest], or a table of numbers by mesh"),
       formed("face_width_mm", "b", kMembers, "10 m_n",
              "face width; a planet that meshes with two rings or two suns has twice this width "
              "plus a gap",
              KeyRange::positive()),
       formed("tip_diameter_mm", "d_a", kMembers,
              "determined by the basic rack and reduced if the tip clearance is too small; for a "
              "ring, a diameter at which its tips touch only the flanks of the planets",
              "tip diameter", KeyRange::positive()),
       formed("bore_mm", "", kMembers, "no bore",
              "diameter of the bore in the CAD files; a single number applies to all gears except "
              "rings; in a table, the number for a ring is the outside diameter of its rim",
              KeyRange::positive())
           .with_also({"bore", "bore_diameter_mm", "shaft_diameter_mm"}),
       formed("center_distance_mm", "a", kMeshes, "backlash-free distance of the first mesh",
              "centre distance", KeyRange::positive()),
       formed("mesh_efficiency", "η", kMeshes, "computed from `friction_coefficient` and the teeth",
              "efficiency of the meshes when the carrier is at rest", KeyRange::above(0, 1)),
       friction_key(&P::friction),
       fixed_key(),
       formed("input", "", kBodies, "the sun", "driving body or list of driving bodies"),
       Key::text("output", &P::output, "the carrier", "body that is driven"),
       speed_key(),
       torque_key(),
       spacing_key(&P::spacing),
       Key::number(
           "positions_deg", "", {}, &P::positions_deg, "determined by `spacing`",
           "positions of the planets around the carrier, counter-clockwise from the first planet")
           .with_list({1, 1000}),
       formed(
           "material", "",
           "a name, a table with the keys of [gear1.material], or a table of such tables by member",
           "material of `[rating]`", "material of the teeth")}};
  return table;
}

namespace {

Key stage_angle() {
  Key key = formed(
      "angle_deg", "", "a number, or `\"coaxial\"` in the last stage",
      "the value of the stage before",
      "direction from the axis of the first gear of a pair to the axis of the second, "
      "counter-clockwise; 0 for the first stage. `\"coaxial\"` leads back to the axis of the "
      "input; if the stage before has no angle, it gets the angle that permits this",
      KeyRange::between(-360, 360));
  key.words = {"coaxial"};
  key.fields = {"angle"};
  return key;
}

}  // namespace

const KeyTable& stage_keys() {
  static const KeyTable table{
      "stage",
      "A stage of a train: a pair of gears or a planetary set; the stages are listed from the "
      "input to the output",
      {formed("teeth", "z", "two numbers, the second negative for a ring", "",
              "numbers of teeth of a pair"),
       formed("gears", "", "two tables with the keys of [gear1]", "",
              "the two gears of a pair, each with its own keys"),
       Key::part("planetary", planetary_keys, {}, "a planetary set")
           .with_excludes({"teeth", "gears"}),
       Key::number("normal_module_mm", "m_n", KeyRange::between(1e-3, 1e3), {}, "no geometry",
                   "normal module"),
       Key::number("normal_pressure_angle_deg", "α_n", KeyRange::between(1, 60), {}, "20",
                   "normal pressure angle"),
       Key::number("helix_angle_deg", "β", KeyRange::between(-89, 89), {}, "0",
                   "helix angle of the first gear"),
       Key::positive("face_width_mm", "b", {}, "10 m_n", "face width"),
       Key::positive("center_distance_mm", "a", {}, "backlash-free distance", "centre distance"),
       stage_angle(),
       formed("profile_shift", "x", "a list of two numbers", "computed from the centre distance",
              "profile shifts", gear_keys().find("profile_shift")->range),
       formed("thickness_allowance_mm", "E_sn", "a number, or a list of two numbers", "0",
              "thickness allowances"),
       series_key(),
       backlash_key("a number, or a band [least, greatest]; in a set, as in [planetary]"),
       formed("bore_mm", "", "a number, or a list of two numbers; in a set, as in [planetary]",
              "no bore",
              "diameters of the bores in the CAD files; a single number applies to both gears, but "
              "not to a ring; if the second gear is a ring, the second number is the outside "
              "diameter of its rim",
              KeyRange::positive())
           .with_also({"bore", "bore_diameter_mm", "shaft_diameter_mm"}),
       formed("mesh_efficiency", "η", kMeshes, "computed from `friction_coefficient` and the teeth",
              "efficiency of the mesh", KeyRange::above(0, 1)),
       friction_key(KeyPlace()), speed_key(), torque_key(),
       formed("material", "", "a name, or a table with the keys of [gear1.material]",
              "material of `[rating]`", "material of the teeth of both gears")}};
  return table;
}

const KeyTable& stage_gear_keys() {
  static const KeyTable table = [] {
    KeyTable t{"stage_gear", "A gear of a drive, with the keys of [gear1]", {}};
    // A gear of a drive is not cut by its mating gear and has no shaft of its own.
    for (const Key& key : gear_keys().keys) {
      if (key.key == "cut_by" || key.key == "profile_shift_pair" || key.key == "shaft") continue;
      Key copy = key;
      copy.in_documents = false;
      t.keys.push_back(std::move(copy));
    }
    return t;
  }();
  return table;
}

const KeyTable& drive_keys() {
  static const KeyTable table{
      "drive",
      "A drive as a graph of bodies, gears and meshes; the other forms are translated into this "
      "form",
      {fixed_key(), formed("input", "", kBodies, "", "driving body or list of driving bodies"),
       formed("output", "", "a body", "", "body that is driven"), speed_key(), torque_key(),
       formed("speed_m_per_s", "v", "a number", "",
              "speed of the input if it is a rack, in place of `speed_rpm`"),
       formed("force_N", "F", "a number", "",
              "force on the input if it is a rack, in place of `torque_Nm`"),
       spacing_key(&DriveGraph::spacing), friction_key(&DriveGraph::friction),
       tables_key("body", drive_body_keys, "a body that turns or moves"),
       tables_key("gear", drive_gear_keys, "a gear on a body"),
       tables_key("mesh", drive_mesh_keys, "two gears that mesh")}};
  return table;
}

const KeyTable& drive_body_keys() {
  static const KeyTable table{
      "drive_body",
      "A body of the graph",
      {Key::text("name", &DriveBody::name, kRequired, "name of the body"),
       formed("rides_on", "", "a body", "the housing", "carrier on which the planet is mounted"),
       Key::number("count", "N", KeyRange::between(1, 1000), &DriveBody::count, "1",
                   "number of copies of a planet"),
       Key::number(
           "positions_deg", "", {}, &DriveBody::positions_deg, "determined by `spacing`",
           "positions of the copies around the carrier, counter-clockwise from the first copy")
           .with_list({1, 1000}),
       spacing_key(&DriveBody::spacing, "the value for the whole drive")}};
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
             .with_also({"height", "back"})}};
    for (const Key& key : stage_gear_keys().keys)
      if (!t.find(key.key)) t.keys.push_back(key);
    return t;
  }();
  return table;
}

const KeyTable& drive_mesh_keys() {
  static const KeyTable table{
      "drive_mesh",
      "A mesh of the graph",
      {formed("gears", "", "two gears", kRequired, "names of the gears that mesh"),
       Key::text("name", &DriveMesh::name, "the names of the two gears, joined by _",
                 "name of the mesh"),
       Key::positive("center_distance_mm", "a", &DriveMesh::center_distance,
                     "backlash-free distance", "centre distance"),
       Key::number("backlash_mm", "j_n", KeyRange::not_negative(), &DriveMesh::backlash,
                   "backlash of the thickness allowances",
                   "backlash in the normal section, j_bn/cos α_wn, for which the teeth of both "
                   "gears are thinned; it replaces their thickness allowances"),
       Key::number("efficiency", "η", KeyRange::above(0, 1), &DriveMesh::efficiency,
                   "computed from `friction_coefficient` and the teeth",
                   "efficiency of the mesh when its frame is at rest"),
       friction_key(&DriveMesh::friction, "the value for the whole drive"),
       Key::number(
           "angle_deg", "", KeyRange::between(-360, 360), &DriveMesh::direction, "0",
           "direction from the axis of the first gear to the axis of the second gear, "
           "counter-clockwise; not allowed for planets, whose positions determine the direction")}};
  return table;
}

}  // namespace gearwright
