#include "gearwright/catalogue/rating_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gearwright/base/error.hpp"
#include "gearwright/base/units.hpp"
#include "gearwright/rating/rated_pair.hpp"

namespace gearwright {

namespace {

constexpr double kMaxFactor = 100.0;

// Makes a key for a factor that replaces the formula of the standard.
Key factor(std::string_view key, std::string_view symbol, double RatingInput::*member,
           std::string_view fallback, std::string_view meaning) {
  return Key::number(key, symbol, KeyRange::between(1, kMaxFactor), {&RatingTable::input, member},
                     fallback, meaning);
}
Key factor(std::string_view key, std::string_view symbol,
           std::optional<double> RatingInput::*member, std::string_view fallback,
           std::string_view meaning) {
  return Key::number(key, symbol, KeyRange::between(1, kMaxFactor), {&RatingTable::input, member},
                     fallback, meaning);
}

// Makes the key of K_γ. For a drive, the value may also be a table of numbers by mesh, or the word
// "computed". spec/read_drive.hpp reads these forms.
Key mesh_load_factor() {
  Key key = factor(
      "mesh_load_factor", "K_γ", &RatingInput::mesh_load_factor, "1",
      "greatest load of a mesh divided by the mean load of all meshes that share the power, for "
      "example the meshes of planets. A mesh that the table does not name has the factor 1; with "
      "`\"computed\"`, the results of the drive under `[load]` give K_γ of each mesh");
  key.kind = KeyKind::any;
  key.words = {"computed"};
  key.form = "a number; for a drive also a table of numbers by mesh, or `\"computed\"`";
  return key;
}

// Makes the key of K_Hβ. For "computed", the job computes K_Hβ from the load along the teeth.
Key face_load_factor() {
  Key key = factor(
      "face_load_factor", "K_Hβ", &RatingInput::face_load_factor,
      "from `[rating.mounting]` or the shafts of the gears; a search without these values uses 1.4",
      "face load factor of the flank, which replaces the value by formula; with `\"computed\"`, "
      "K_Hβ is computed from the load along the teeth, with their modifications and shafts, "
      "and the computation takes a few seconds");
  key.place = key.place.or_word<RatingTable>(
      [](RatingTable& rating) { rating.input.face_load_computed = true; });
  key.words = {"computed"};
  key.form = "a number, or `\"computed\"`";
  return key;
}

// Makes a key for two numbers, one for each gear. A single number applies to both gears.
Key of_both(std::string_view key, std::string_view symbol, KeyRange range, KeyPlace place,
            std::string_view fallback, std::string_view meaning) {
  return Key::number(key, symbol, std::move(range), std::move(place), fallback, meaning)
      .with_list(KeyList{2, 2, true})
      .with_form("one number, or a list of two numbers for gear 1 and gear 2");
}

std::string set_quality(RatingTable& rating, const std::array<double, 2>& grade) {
  for (const double g : grade)
    if (g != std::floor(g)) return "must be whole numbers, which are grades of ISO 1328-1";
  rating.input.quality = {static_cast<int>(grade[0]), static_cast<int>(grade[1])};
  return "";
}

// Sets the rims. For the stiffness of the gear bodies, the thinner rim is used for both gears.
void set_rims(RatingTable& rating, const std::array<double, 2>& rim) {
  rating.input.rim = {rim[0], rim[1]};
  rating.rim_thickness = std::min(rim[0], rim[1]);
}

// If power and torque are both given, they must agree. If a spectrum is given but neither power nor
// torque, the step with the greatest torque is the load. This step also gives the speed if no speed
// is given.
std::optional<KeyFault> complete_load(RatingTable& rating) {
  RatingInput& in = rating.input;
  if (!rating.spectrum.empty()) {
    if (in.life_h)
      return KeyFault{
          "life_h",
          "cannot be combined with a spectrum, because each step of a spectrum has its own hours"};
    const LoadBin& worst =
        *std::max_element(rating.spectrum.begin(), rating.spectrum.end(),
                          [](const LoadBin& a, const LoadBin& b) { return a.torque < b.torque; });
    if (!rating.torque && !rating.power && !rating.output_torque) rating.torque = worst.torque;
    if (!in.speed) in.speed = worst.speed;
  }
  if (rating.power) {
    const double torque = torque_of_power(*rating.power, *in.speed);
    if (rating.torque && std::abs(torque - *rating.torque) > 1e-9 * torque) {
      return KeyFault{"torque_Nm", fmt::format("contradicts power_kW = {}, which is {} N m at this "
                                               "speed; leave out one of the two keys",
                                               format_number(*rating.power),
                                               format_number(torque, *rating.torque))};
    }
    rating.torque = torque;
  }
  in.torque = rating.torque.value_or(0.0);
  return std::nullopt;
}

std::optional<KeyFault> complete_rating(RatingTable& rating, const KeyGiven& given) {
  const bool plastics = rating.input.edition == RatingEdition::vdi_2736;
  if (rating.input.face_load_computed && plastics) {
    return KeyFault{"face_load_factor",
                    "cannot be \"computed\" for VDI 2736, because the stiffness of plastic teeth "
                    "depends on their temperature; give a number"};
  }
  if (rating.input.mounting && (rating.input.face_load_factor || rating.input.face_load_computed)) {
    return KeyFault{"face_load_factor",
                    "cannot be combined with [rating.mounting], which determines this value; leave "
                    "out one of the two"};
  }
  if (rating.input.mounting && rating.input.misalignment) {
    return KeyFault{"misalignment_um",
                    "has no effect with [rating.mounting], which has a misalignment of its own; "
                    "give misalignment_um in that table"};
  }
  if (given("plastic") && !plastics)
    return KeyFault{"plastic", "is used only with standard = \"VDI 2736:2014\""};
  if (!rating.spectrum.empty() && plastics) {
    return KeyFault{
        "spectrum",
        "cannot be used with VDI 2736, because the strengths of a plastic apply to a single life"};
  }
  return complete_load(rating);
}

std::optional<KeyFault> check_mounting(PinionMounting& m, const KeyGiven&) {
  if (2 * m.offset < m.bearing_span || m.arrangement == PinionArrangement::c) return std::nullopt;
  return KeyFault{"pinion_offset_mm",
                  fmt::format("must be less than half of the bearing span {} mm; for an overhung "
                              "pinion give arrangement = \"c\"",
                              format_number(m.bearing_span))};
}

}  // namespace

const KeyTable& rating_keys() {
  static const KeyTable table{
      "rating",
      "Strength by ISO 6336, method B",
      {Key::word("standard", {"ISO 6336:2006", "ISO 6336:2019", "VDI 2736:2014"},
                 {&RatingTable::input, &RatingInput::edition}, "\"ISO 6336:2006\"",
                 "edition of ISO 6336-1, -2 and -3, or the guideline for plastics")
           .with_fields({"edition"})
           .with_also({"norm", "edition", "method"}),
       Key::positive("power_kW", "P", &RatingTable::power, "from `torque_Nm`",
                     "power through the mesh; can be given instead of `torque_Nm`")
           .with_needs({"speed_rpm"})
           .with_also({"power", "p", "kw"}),
       Key::positive("torque_Nm", "T_1", &RatingTable::torque, "from `power_kW`",
                     "torque on gear 1; can be given instead of `power_kW`")
           .with_also({"torque", "moment", "t"}),
       Key::positive("output_torque_Nm", "T_2", &RatingTable::output_torque, "",
                     "torque on the driven gear of a pair, instead of `torque_Nm` and `power_kW`. "
                     "Losses are neglected, as in ISO 6336: T_1 = T_2 z_1/|z_2|. With `driver = 2` "
                     "in `[load]`, the driven gear is gear 1. In a search, each design has the "
                     "torque T_1 of its own ratio")
           .with_fields({"output_torque", "torque"})
           .with_excludes({"torque_Nm", "power_kW"})
           .with_also({"t2", "torque2"}),
       Key::positive("speed_rpm", "n_1", {&RatingTable::input, &RatingInput::speed},
                     "the speed can be absent only if `dynamic_factor` is given", "speed of gear 1")
           .with_also({"speed", "rpm", "n"}),
       factor(
           "application_factor", "K_A", &RatingInput::application_factor, "1",
           "application factor K_A for additional loads from the driving and the driven machine"),
       mesh_load_factor(),
       Key::positive("life_h", "L_h", {&RatingTable::input, &RatingInput::life_h},
                     "life factors are 1", "required life in hours at the given load")
           .with_needs({"speed_rpm"})
           .with_also({"life", "hours", "service_life"}),
       Key::flag(
           "reversed", {&RatingTable::input, &RatingInput::reversed}, "false",
           "if true, the teeth bend in both directions, as in an idler, and σ_FG is multiplied "
           "by 0.7")
           .with_also({"idler", "alternating"}),
       Key::number("lubricant_viscosity_40C_mm2_s", "ν_40", KeyRange::between(1, 5000),
                   {&RatingTable::input, &RatingInput::viscosity}, "Z_L = 1",
                   "viscosity of the oil at 40 °C")
           .with_fields({"viscosity"})
           .with_also({"viscosity", "oil", "iso_vg", "lubricant"}),
       of_both("quality", "Q", KeyRange::between(kBestGrade, kWorstGrade, ", grades of ISO 1328-1"),
               KeyPlace::by<RatingTable, std::array<double, 2>>(set_quality),
               "`quality` of the gears; not required if the dynamic and transverse load factors "
               "are given",
               "accuracy grades of ISO 1328-1; the edition of 1995 applies if `standard` is `\"ISO "
               "6336:2006\"`, otherwise the edition of 2013")
           .with_form("one whole number, or a list of two whole numbers for gear 1 and gear 2")
           .with_also({"accuracy", "grade", "iso1328"}),
       of_both("flank_roughness_um", "Rz_H", KeyRange::between(0.01, 1000),
               {&RatingTable::input, &RatingInput::flank_roughness}, "Z_R = 1",
               "mean peak-to-valley roughness Rz of the flanks, about 6 Ra")
           .with_also({"roughness", "rz", "flank_rz"}),
       of_both("root_roughness_um", "Rz_F", KeyRange::between(0.01, 1000),
               {&RatingTable::input, &RatingInput::root_roughness}, "Y_RrelT = 1",
               "Rz of the root fillets")
           .with_also({"root_rz"}),
       Key::not_negative("tip_relief_um", "C_a", {&RatingTable::input, &RatingInput::tip_relief},
                         "the tip relief that running-in produces; for grade 6 and coarser grades, "
                         "the tip relief has no effect",
                         "tip relief, for the dynamic factor of grades 0 to 5"),
       of_both("rim_thickness_mm", "s_R", KeyRange::positive(),
               KeyPlace::by<RatingTable, std::array<double, 2>>(set_rims), "the rim is thick",
               "thickness of the rim under the teeth, for Y_B and, together with the web, for c'")
           .with_also({"rim"}),
       Key::positive("web_thickness_mm", "b_s", &RatingTable::web_thickness,
                     "the gear is a solid disc",
                     "thickness of the web that carries the rim, for c'")
           .with_needs({"rim_thickness_mm"})
           .with_also({"web"}),
       Key::flag("limited_pitting", KeyPlace::within<RatingTable>([](auto& r) -> auto& {
                   return r.input.life.limited_pitting;
                 }),
                 "false",
                 "if true, some pitting is permitted and Z_NT follows the corresponding line of "
                 "the standard"),
       Key::number(
           "life_factor_end", "", KeyRange::between(0.85, 1),
           KeyPlace::within<RatingTable>([](auto& r) -> auto& { return r.input.life.at_10_10; }),
           "0.85",
           "Z_NT and Y_NT at 10¹⁰ cycles; a value greater than 0.85 requires optimum "
           "manufacture and lubrication"),
       face_load_factor(),
       Key::flag(
           "face_load_factor_assumed", {&RatingTable::input, &RatingInput::face_load_assumed},
           "false",
           "true if `face_load_factor` is the default of a search, in the specs that `--take` "
           "writes; `rate` then names this source of K_Hβ"),
       Key::not_negative(
           "misalignment_um", "f_ma", {&RatingTable::input, &RatingInput::misalignment},
           "√(f_Hβ1² + f_Hβ2²)",
           "mesh misalignment caused by manufacture, used with `[gear1.shaft]` or `[gear2.shaft]` "
           "and with `face_load_factor = \"computed\"`"),
       factor("face_load_factor_root", "K_Fβ", &RatingInput::face_load_factor_root, "K_Hβ^N_F",
              "face load factor of the root, which replaces the computed value"),
       factor("dynamic_factor", "K_v", &RatingInput::dynamic_factor, "computed by formula",
              "dynamic factor, which replaces the computed value"),
       factor("transverse_load_factor", "K_Hα", &RatingInput::transverse_load_factor,
              "computed by formula",
              "transverse load factor of the flank, which replaces the computed value"),
       factor("transverse_load_factor_root", "K_Fα", &RatingInput::transverse_load_factor_root,
              "computed by formula",
              "transverse load factor of the root, which replaces the computed value"),
       Key::positive("safety_flank_min", "S_Hmin", &RatingTable::safety_flank_min,
                     "none; the value 1 is used for results that need a required safety",
                     "required safety of the flanks")
           .with_also({"sh", "sh_min", "safety_flank"}),
       Key::positive("safety_root_min", "S_Fmin", &RatingTable::safety_root_min,
                     "none; the value 1 is used for results that need a required safety",
                     "required safety of the roots")
           .with_also({"sf", "sf_min", "safety_root"}),
       Key::flag("tooth_contact", &RatingTable::tooth_contact, "false",
                 "if true, Hertz pressure and root stress of the teeth under T_1 K_A K_γ K_v are "
                 "also computed, as in `load`. The positions, slices and accuracy are those of "
                 "`[load]`; the computation takes a few seconds")
           .with_also({"loaded_contact", "compare_load"}),
       {.key = "spectrum",
        .kind = KeyKind::table,
        .list =
            KeyList{
                .most = kMaxLoadBins,
                .must = "must be a list of 1 to {} tables [[rating.spectrum]], one for each step"},
        .place = &RatingTable::spectrum,
        .tables = {load_bin_keys},
        .fallback = "one load for the whole life",
        .meaning = "steps of the load with their hours, each in a table; safeties are computed by "
                   "Miner's rule with K_A = 1"},
       Key::part("material", material_keys, &RatingTable::material,
                 "material of gears without a table `material`"),
       Key::part("mounting", rating_mounting_keys, {&RatingTable::input, &RatingInput::mounting},
                 "position of the pinion between the bearings, for K_Hβ"),
       Key::part("plastic", rating_plastic_keys, {&RatingTable::input, &RatingInput::plastic},
                 "temperatures of plastic teeth, for VDI 2736")},
      complete_rating};
  return table;
}

const KeyTable& rating_plastic_keys() {
  using P = PlasticInput;
  static const KeyTable table{
      "rating_plastic",
      "Temperatures of plastic teeth, for VDI 2736",
      {of_both("flank_temperature_C", "ϑ_Fla", KeyRange::between(-100, 400), &P::flank_temperature,
               "computed from the friction", "temperature of the flanks"),
       of_both("root_temperature_C", "ϑ_Fu", KeyRange::between(-100, 400), &P::root_temperature,
               "computed from the friction", "temperature of the roots"),
       Key::number("ambient_temperature_C", "ϑ_0", KeyRange::between(-100, 400),
                   &P::ambient_temperature, "", "temperature of the air or oil around the gears")
           .with_also({"ambient"}),
       Key::number("friction_coefficient", "μ", KeyRange::between(0, 1), &P::friction, "",
                   "coefficient of friction of the flanks")
           .with_fields({"friction"})
           .with_also({"friction", "mu"}),
       Key::not_negative("housing_resistance_m2K_per_W", "R_λG", &P::housing_resistance,
                         "0, an open housing",
                         "thermal resistance of the housing, about 0.015 to 0.045 if it is partly "
                         "open and 0.06 if it is closed")
           .with_needs({"housing_area_m2"}),
       Key::positive("housing_area_m2", "A_G", &P::housing_area, "",
                     "surface of the housing that gives off heat"),
       Key::number("duty", "ED", KeyRange::between(0, 1), &P::duty, "1",
                   "running time as a share of ten minutes"),
       Key::not_negative("heat_transfer_flank", "k_ϑ,Fla", &P::flank_heat_transfer,
                         "9000 for two plastic gears, 6300 with a metal gear",
                         "heat transfer coefficient of the flanks, in K (m/s)^0.75 mm^1.75/W")
           .with_fields({"flank_heat_transfer"}),
       Key::not_negative("heat_transfer_root", "k_ϑ,Fu", &P::root_heat_transfer,
                         "2148 for two plastic gears, 895 with a metal gear",
                         "heat transfer coefficient of the roots, in K (m/s)^0.75 mm^1.75/W")
           .with_fields({"root_heat_transfer"})}};
  return table;
}

const KeyTable& load_bin_keys() {
  static const KeyTable table{
      "rating_spectrum",
      "One step of the load",
      {Key::positive("torque_Nm", "T_1", &LoadBin::torque, kRequired, "torque on gear 1"),
       Key::positive("speed_rpm", "n_1", &LoadBin::speed, kRequired, "speed of gear 1"),
       Key::positive("duration_h", "", &LoadBin::hours, kRequired, "duration")
           .with_fields({"hours"})}};
  return table;
}

const KeyTable& rating_mounting_keys() {
  using P = PinionMounting;
  static const KeyTable table{
      "rating_mounting",
      "Position of the pinion between the bearings, for K_Hβ without helix modification",
      {Key::positive("bearing_span_mm", "l", &P::bearing_span, kRequired,
                     "distance of the pinion bearings"),
       Key::not_negative(
           "pinion_offset_mm", "s", &P::offset, "0",
           "distance from the middle of the bearings to the middle of the pinion face"),
       Key::positive("shaft_diameter_mm", "d_sh", &P::shaft_diameter, kRequired,
                     "outside diameter of the pinion shaft"),
       Key::word(
           "arrangement", {"a", "b", "c", "d", "e"}, &P::arrangement, "\"a\"",
           "arrangement in the figure of the standard for K'; a for torque from the near side, b "
           "for torque from the far side, c for an overhung pinion, d and e for a second pinion"),
       Key::flag("stiffening", &P::stiffening, "true",
                 "true if the pinion is integral with the shaft or shrunk onto the shaft"),
       Key::not_negative("misalignment_um", "f_ma", &P::manufacture, "√(f_Hβ1² + f_Hβ2²)",
                         "mesh misalignment caused by manufacture")
           .with_fields({"manufacture"})},
      check_mounting};
  return table;
}

}  // namespace gearwright
