#include "gearwright/catalogue/drive_search_keys.hpp"

#include "gearwright/catalogue/drive_keys.hpp"
#include "gearwright/design/drive_search.hpp"

namespace gearwright {

namespace {

using Problem = DriveSearchProblem;

constexpr ListOrder kDriveBandOrder{
    .sentence = "is an empty band; nothing lies between {} and {}; write the least value first"};
constexpr KeyList kDriveBand{.most = 2, .single = true, .order = kDriveBandOrder};

Key band(std::string_view key, std::string_view symbol, KeyRange range, KeyPlace place,
         std::string_view fallback, std::string_view meaning) {
  return Key::number(key, symbol, std::move(range), std::move(place), fallback, meaning)
      .with_list(kDriveBand)
      .with_form("a whole number, or a band [least, greatest]");
}

Key teeth(std::string_view key, SetMember member, std::string_view fallback,
          std::string_view meaning) {
  const auto m = static_cast<std::size_t>(member);
  return band(key, "z", KeyRange::between(1, kMostDriveTeeth),
              KeyPlace::within<Problem>([m](auto& p) -> auto& { return p.teeth[m]; }), fallback,
              meaning);
}

// A key of [planetary] that holds for every set of the search; its reader is that of the set.
Key of_set(std::string_view key, std::string_view fallback = {}) {
  Key k = *planetary_keys().find(key);
  k.place = {};
  if (!fallback.empty()) k.fallback = fallback;
  return k;
}

Key face_width() {
  Key k = of_set("face_width_mm");
  k.form += ", or a band [least, greatest]";
  k.meaning =
      "face width; of a band each rated design takes the least whole number of millimetres that "
      "has the safeties";
  return k;
}

}  // namespace

const KeyTable& drive_search_keys() {
  static const KeyTable table{
      "drive_search",
      "The input of a search for drives",
      {Key::word("kind", {kDriveKindNames.begin(), kDriveKindNames.end()}, &Problem::kind,
                 kRequired,
                 "sun, planet, ring; stepped planets with `sun` and `ring2`; two rings, with "
                 "`sun_teeth` a sun too; two suns; or a train of pairs"),
       Key::number("ratio", "i", {}, &Problem::ratio, kRequired,
                   "n_in/n_out, signed; its closed band")
           .with_list(kDriveBand)
           .with_form("a number, or a band [least, greatest]"),
       Key::number("target_ratio", "", {}, &Problem::target_ratio, "the middle of the band",
                   "target of the objective `ratio`"),
       band("planets", "N", KeyRange::between(1, 100), &Problem::planets, "3", "number of planets"),
       teeth("sun_teeth", SetMember::sun, "12 to 60; of a Wolfrom set no sun", "of the sun"),
       teeth("sun2_teeth", SetMember::sun2, "12 to 60", "of the second sun"),
       teeth("planet_teeth", SetMember::planet, "12 to 60", "of the planet"),
       teeth("planet2_teeth", SetMember::planet2,
             "12 to 60; of a Wolfrom set one planet gear meshes with both rings",
             "of the second gear of the planet"),
       teeth("ring_teeth", SetMember::ring, "30 to 150", "of the ring, without its sign"),
       teeth("ring2_teeth", SetMember::ring2, "30 to 150", "of the second ring"),
       band("stages", "", KeyRange::between(1, 4), &Problem::stages, "2",
            "number of stages of a train"),
       band("pinion_teeth", "z", KeyRange::between(1, kMostDriveTeeth), &Problem::pinion,
            "17 to 40", "of the pinions of a train"),
       band("wheel_teeth", "z", KeyRange::between(1, kMostDriveTeeth), &Problem::wheel, "17 to 150",
            "of its wheels"),
       Key::number("coaxial_teeth", "", KeyRange::between(0, 100), &Problem::coaxial_teeth,
                   "1; of two rings on one planet gear `planets`; of a train any",
                   "how many teeth the sums of teeth of meshes on one circle may differ, |z_r| and "
                   "z_s + 2 z_p for example; profile shifts make up for them"),
       Key::number("neighbour_clearance_min", "c", KeyRange::between(-10, 1000),
                   &Problem::neighbour_clearance, "1",
                   "least clearance between the tip circles of neighbouring planets, in modules"),
       Key::word("phasing", {"in_phase", "sequential", "counter", "mixed"}, &Problem::phasing,
                 "all",
                 "classes of phasing that are allowed; `sequential` and `counter` have no torque "
                 "ripple at the mesh frequency")
           .with_list({.least = 1, .most = 4, .single = true, .noun = "class"}),
       Key::word("objective", {kDriveObjectiveNames.begin(), kDriveObjectiveNames.end()},
                 &Problem::objectives, "\"efficiency\"",
                 "criterion of the ranking: `efficiency` (greatest), `ratio` (nearest to "
                 "`target_ratio`), `size` (least), `efficiency_backward` (greatest), `clearance` "
                 "(greatest), `planets` (most); or a list of them: a Pareto front")
           .with_list({.least = 1,
                       .most = kDriveObjectiveNames.size(),
                       .single = true,
                       .noun = "objective"}),
       of_set("spacing", "\"equal\""),
       of_set("fixed"),
       of_set("input"),
       of_set("output"),
       Key::number("normal_module_mm", "m_n", KeyRange::between(1e-3, 1e3), &Problem::modules,
                   "no geometry; sizes are in modules",
                   "normal module of all meshes; of several each set is tried with every one")
           .with_list({.least = 1, .most = 100, .single = true, .order = {.strict = true}}),
       Key::positive("size_max_mm", "", &Problem::size_max, "no limit",
                     "greatest diameter over all, of a train the greatest sum of the centre "
                     "distances, both without profile shifts"),
       of_set("normal_pressure_angle_deg"),
       of_set("helix_angle_deg"),
       of_set("profile_shift"),
       of_set("thickness_allowance_mm"),
       face_width(),
       Key::positive("face_width_diameters_max", "b/d", &Problem::face_diameters, "1.2",
                     "greatest face width, of a band, in reference diameters of the smallest gear"),
       Key::positive("safety_flank_min", "S_Hmin", &Problem::safety_flank,
                     "of `[rating]`, otherwise 1",
                     "least safety against pitting of every mesh; designs are rated with it, with "
                     "`safety_root_min`, or with a table `[rating]`"),
       Key::positive("safety_root_min", "S_Fmin", &Problem::safety_root,
                     "of `[rating]`, otherwise 1", "least safety against root breakage, likewise"),
       of_set("mesh_efficiency"),
       of_set("friction_coefficient"),
       of_set("speed_rpm"),
       of_set("torque_Nm"),
       of_set("material")}};
  return table;
}

}  // namespace gearwright
