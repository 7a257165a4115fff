#include "gearwright/base/lists.hpp"
#include "gearwright/catalogue/drive_keys.hpp"
#include "gearwright/catalogue/search_keys.hpp"
#include "gearwright/design/drive_search.hpp"

namespace gearwright {

namespace {

using Problem = DriveSearchProblem;

Key band(std::string_view key, std::string_view symbol, KeyRange range, KeyPlace place,
         std::string_view fallback, std::string_view meaning) {
  return Key::number(key, symbol, std::move(range), std::move(place), fallback, meaning)
      .with_list(kBand)
      .with_form("a whole number, or a band [least, greatest]");
}

Key teeth(std::string_view key, SetMember member, std::string_view fallback,
          std::string_view meaning) {
  const auto m = static_cast<std::size_t>(member);
  return band(key, "z", KeyRange::between(1, kMostDriveTeeth),
              KeyPlace::within<Problem>([m](auto& p) -> auto& { return p.teeth[m]; }), fallback,
              meaning);
}

// Returns a key of [planetary] for use in [search]. The key has the same form as in [planetary] and
// applies to every set of the search.
Key of_set(std::string_view key, std::string_view fallback = {}) {
  Key k = *planetary_keys().find(key);
  if (k.place) k.place = k.place.inside(&Problem::base);
  if (!fallback.empty()) k.fallback = fallback;
  return k;
}

// Works like objective_called(), but returns an empty text if the objective is not one for searches
// for drives.
std::string_view drive_objective_called(std::string_view word) {
  const std::string_view objective = objective_called(word);
  return is_in(objective, kDriveObjectiveNames) ? objective : std::string_view();
}

Key normal_modules() {
  Key k = Key::number("normal_module_mm", "m_n", KeyRange::between(1e-3, 1e3), &Problem::modules,
                      "no geometry is computed, and sizes are in modules",
                      "normal module of all meshes. If several modules are given, every set is "
                      "tried with each module. In a rated search for trains, each stage gets the "
                      "least of the modules with which it has the required safeties. With "
                      "`center_distance_mm`, all choices of the modules of the stages are tried")
              .with_list(
                  {.most = 100, .single = true, .order = {.strict = true}, .series = module_series})
              .with_form(
                  "`\"ISO54-I\"`, `\"ISO54-II\"`, `\"ISO54-I+II\"`, a number, or a list of 1 "
                  "to 100 numbers in rising order");
  k.words = {"ISO54-I", "ISO54-II", "ISO54-I+II"};
  return k;
}

Key face_width() {
  Key k = of_set("face_width_mm");
  constexpr std::string_view kRule =
      "must be a number, a table of numbers by member, or a band of two positive numbers in rising "
      "order, for example [20, 60]";
  k.place = k.place.or_ends(&Problem::face_width);
  k.list = {.least = 2,
            .most = 2,
            .single = true,
            .order = {.sentence = kRule},
            .must = kRule,
            .numbers = true};
  k.form += ", or a band [least, greatest]";
  k.meaning =
      "face width; within a band, each mesh of a rated design has the least width with the "
      "required "
      "safeties, in steps of 1 mm or, in a spec in inch, of 0.05 inch";
  return k;
}

}  // namespace

const KeyTable& drive_search_keys() {
  static const KeyTable table{
      "drive_search",
      "The input of a search for drives",
      {Key::word("kind", {kDriveKindNames.begin(), kDriveKindNames.end()}, &Problem::kind,
                 kRequired,
                 "kind of the drive: `planetary` (sun, planet and ring), `stepped` (`sun`, stepped "
                 "planets and `ring2`), `wolfrom` (two rings, and a sun if `sun_teeth` is given), "
                 "`two_suns` (two suns) or `train` (train of pairs)"),
       Key::number("ratio", "i", {}, &Problem::ratio, kRequired,
                   "signed ratio n_in/n_out; a band includes its ends")
           .with_list(kBand)
           .with_form("a number, or a band [least, greatest]"),
       Key::number("target_ratio", "", {}, &Problem::target_ratio, "the middle of the band `ratio`",
                   "target of the objective `ratio`"),
       band("planets", "N", KeyRange::between(1, 100), &Problem::planets, "3", "number of planets"),
       teeth("sun_teeth", SetMember::sun, "12 to 60; a Wolfrom set has no sun by default",
             "number of teeth of the sun"),
       teeth("sun2_teeth", SetMember::sun2, "12 to 60", "number of teeth of the second sun"),
       teeth("planet_teeth", SetMember::planet, "12 to 60", "number of teeth of the planet"),
       teeth("planet2_teeth", SetMember::planet2,
             "12 to 60. For a Wolfrom set, the planet has no second gear by default: its one gear "
             "meshes with both rings",
             "number of teeth of the second gear of the planet"),
       teeth("ring_teeth", SetMember::ring, "30 to 150",
             "number of teeth of the ring, without sign"),
       teeth("ring2_teeth", SetMember::ring2, "30 to 150", "number of teeth of the second ring"),
       band("stages", "", KeyRange::between(1, kMostStages), &Problem::stages, "2",
            "number of stages of a train"),
       band("pinion_teeth", "z", KeyRange::between(1, kMostDriveTeeth), &Problem::pinion,
            "17 to 40", "numbers of teeth of the pinions of a train"),
       band("wheel_teeth", "z", KeyRange::between(1, kMostDriveTeeth), &Problem::wheel, "17 to 150",
            "numbers of teeth of the wheels of a train"),
       Key::number("coaxial_teeth", "", KeyRange::between(0, 100), &Problem::coaxial_teeth,
                   "no limit for a train; for a set, the number of planets if two rings mesh with "
                   "one planet gear, otherwise 1",
                   "greatest difference between the sums of teeth of meshes with a common centre "
                   "distance, for example between |z_r| and z_s + 2 z_p; profile shifts compensate "
                   "for this difference"),
       Key::flag(
           "coprime", &Problem::coprime, "false",
           "if true, the numbers of teeth of meshing gears must not have a common factor, so that "
           "each tooth meets every tooth of the mating gear; other sets are not counted as tested"),
       Key::number("neighbour_clearance_min", "c", KeyRange::between(-10, 1000),
                   &Problem::neighbour_clearance, "1",
                   "least clearance between the tip circles of neighbouring planets, in modules"),
       Key::number("sliding_max", "|ζ|", KeyRange::between(0, 1000), &Problem::sliding,
                   "3 for a rated train without profile_shift; other drives have no limit",
                   "greatest permitted magnitude of the specific sliding at both ends of the path "
                   "of contact of every mesh; sets of small gears without undercut have values of "
                   "about 3 to 5"),
       Key::not_negative("overlap_ratio_min", "ε_β", &Problem::overlap, "no limit",
                         "least overlap ratio of every mesh; needs `normal_module_mm`"),
       Key::word("phasing", {"in_phase", "sequential", "counter", "mixed"}, &Problem::phasing,
                 "all",
                 "allowed classes of phasing; with `sequential` and `counter` there is no torque "
                 "ripple at the mesh frequency")
           .with_list({.least = 1, .most = 4, .single = true, .noun = "class"}),
       Key::word("objective", {kDriveObjectiveNames.begin(), kDriveObjectiveNames.end()},
                 &Problem::objectives, "\"efficiency\"",
                 "criterion of the ranking: `efficiency` (greatest), `ratio` (nearest to "
                 "`target_ratio`), `size` (least), `efficiency_backward` (greatest), `clearance` "
                 "(greatest), `planets` (most), `noise` (least variation of the elastic rotation "
                 "under load) or `mass` (least mass of all gears, needs `normal_module_mm`); a "
                 "list of criteria gives a Pareto front")
           .with_list({.least = 1,
                       .most = kDriveObjectiveNames.size(),
                       .single = true,
                       .noun = "objective",
                       .meant = drive_objective_called}),
       of_set("spacing", "\"equal\""),
       of_set("fixed"),
       of_set("input"),
       of_set("output"),
       normal_modules(),
       Key::positive("size_max_mm", "", &Problem::size_max, "no limit",
                     "greatest permitted diameter of a set, measured over the planets and over the "
                     "root circles of the rings, without the rims; for a train, greatest permitted "
                     "sum of the centre distances. The diameter and the sum are computed without "
                     "profile shifts"),
       Key::positive(
           "center_distance_mm", "a", &Problem::center_distance, "no limit",
           "centre distance of every stage of a train, as mounted; a single number is the "
           "exact centre distance. The profile shifts follow from the centre distance")
           .with_list(kBand)
           .with_form("a distance in mm, or a band [least, greatest]")
           .with_excludes({"profile_shift"},
                          "excludes profile_shift, because the centre distances determine the "
                          "profile shifts"),
       of_set("normal_pressure_angle_deg"),
       of_set("helix_angle_deg"),
       of_set("profile_shift", "chosen for each set, without undercut"),
       of_set("thickness_allowance_mm", "by `thickness_series`"),
       of_set("thickness_series", "\"cd25\" if a module is given"),
       of_set("backlash_mm", "backlash by `thickness_series`"),
       face_width(),
       Key::positive("face_width_diameters_max", "b/d", &Problem::face_diameters, "1.2",
                     "greatest face width within a band, as a multiple of the reference diameter "
                     "of the smaller gear of a mesh"),
       Key::positive(
           "safety_flank_min", "S_Hmin", &Problem::safety_flank, "value of `[rating]`, otherwise 1",
           "least permitted safety against pitting, for every mesh; designs are rated if this key, "
           "`safety_root_min` or a table `[rating]` is given"),
       Key::positive("safety_root_min", "S_Fmin", &Problem::safety_root,
                     "value of `[rating]`, otherwise 1",
                     "least permitted safety against root breakage, for every mesh"),
       of_set("mesh_efficiency"),
       of_set("friction_coefficient"),
       of_set("speed_rpm"),
       of_set("torque_Nm"),
       of_set("power_kW"),
       of_set("material")}};
  return table;
}

}  // namespace gearwright
