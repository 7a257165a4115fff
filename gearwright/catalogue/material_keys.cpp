#include "gearwright/catalogue/gear_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "gearwright/base/error.hpp"
#include "gearwright/base/lists.hpp"
#include "gearwright/base/printable.hpp"

namespace gearwright {

namespace {

constexpr std::size_t kMinSteps = 2, kMaxSteps = 100;  // number of temperatures

// Makes a key for values of a plastic, one for each temperature that the material lists.
Key by_temperature(std::string_view key, std::string_view symbol,
                   ByTemperature MaterialInput::*member, std::string_view field,
                   std::string_view meaning) {
  const auto set = [member](MaterialInput& m, const std::vector<double>& values) {
    const std::vector<double>& celsius = m.temperatures;
    if (celsius.empty()) return std::string();
    if (values.size() != celsius.size())
      return fmt::format("has {} values, but temperatures_C has {} values", values.size(),
                         celsius.size());
    for (std::size_t i = 0; i < values.size(); ++i) (m.*member).push_back({celsius[i], values[i]});
    return std::string();
  };
  return Key::positive(key, symbol, KeyPlace::by<MaterialInput, std::vector<double>>(set),
                       "the single value of the key without `_by_temperature`", meaning)
      .with_list({kMinSteps, kMaxSteps})
      .with_form("a list with one value for each of `temperatures_C`")
      .with_needs({"temperatures_C"})
      .with_fields({std::string(field)});
}

// True if the name begins with the abbreviation or the trade name of a plastic, for example
// "PA66-GF30" or "pom c".
bool names_plastic(std::string_view name) {
  constexpr std::array kPlastics{"abs", "delrin", "lcp", "nylon", "pa",  "pbt", "pc",   "peek",
                                 "pei", "pet",    "pla", "poly",  "pom", "pps", "ptfe", "uhmw"};
  const std::string lower = lower_case(name.substr(0, name.find_first_of(" -0123456789")));
  return std::any_of(kPlastics.begin(), kPlastics.end(), [&](std::string_view plastic) {
    return lower == plastic || (plastic.size() > 3 && lower.starts_with(plastic));
  });
}

// Checks the name of a material. Without values, the name must be in the table of known materials.
std::optional<KeyFault> check_name(MaterialInput& m, const KeyGiven&) {
  const bool by_temperature = !m.sigma_Hlim_by.empty() || !m.sigma_Flim_by.empty();
  if (!m.name || m.sigma_Hlim || m.sigma_Flim || m.youngs_modulus || by_temperature)
    return std::nullopt;
  std::vector<std::string> known;
  for (const NamedMaterial& row : named_materials()) known.emplace_back(row.name);
  if (is_in(*m.name, known)) return std::nullopt;
  if (names_plastic(*m.name)) {
    return KeyFault{
        "name",
        "is a plastic. The table of materials has no plastics, because their strength depends on "
        "grade, temperature and life. Give kind = \"plastic\" and the values of the supplier or of "
        "VDI 2736 for youngs_modulus_MPa, sigma_Hlim_MPa and sigma_Flim_MPa, or lists of these "
        "values at temperatures_C. In this case [rating] needs standard = \"VDI 2736:2014\""};
  }
  return KeyFault{
      "name", fmt::format("is not in the table of materials; {}. For any other material give kind, "
                          "sigma_Hlim_MPa, sigma_Flim_MPa and, for a plastic, youngs_modulus_MPa",
                          word_hint(*m.name, known))};
}

}  // namespace

const KeyTable& material_keys() {
  static const KeyTable table = [] {
    const auto kinds = material_kind_words();
    return KeyTable{
        "material",
        "Material of the teeth, for `rate`",
        {Key::text("name", &MaterialInput::name,
                   "the values of the material are given instead of a name",
                   "name of a material in the table of materials, for example \"18CrNiMo7-6\"; any "
                   "name is allowed if the values are given")
             .with_also({"steel", "grade", "material"}),
         Key::word("kind", {kinds.begin(), kinds.end()}, &MaterialInput::kind,
                   "value in the table of materials",
                   "kind of material by ISO 6336-5 (Eh, V, St, IF, NT, NV (nitrocar.), GG, GGG "
                   "(perl., bai.), GGG (ferr.), GTS)")
             .with_also({"type", "treatment", "heat_treatment"}),
         Key::positive("youngs_modulus_MPa", "E", &MaterialInput::youngs_modulus,
                       "206 000, or less for cast iron", "Young's modulus")
             .with_also({"e", "modulus", "elasticity"}),
         Key::number("poisson_ratio", "ν", KeyRange::between(0, 0.5), &MaterialInput::poisson_ratio,
                     "0.3", "Poisson's ratio")
             .with_also({"nu", "poisson"}),
         Key::positive("density_kg_per_m3", "ρ", &MaterialInput::density,
                       "7830, or 7300 for cast iron; plastics have no default",
                       "density, for the mass and for the resonance of the mesh"),
         Key::positive("sigma_Hlim_MPa", "σ_Hlim", &MaterialInput::sigma_Hlim,
                       "value in the table of materials",
                       "allowable contact stress number of the reference test gears")
             .with_also({"sigma_h", "contact_strength", "hlim"}),
         Key::positive("sigma_Flim_MPa", "σ_Flim", &MaterialInput::sigma_Flim,
                       "value in the table of materials",
                       "nominal allowable bending stress number, which does not include Y_ST = 2")
             .with_also({"sigma_f", "bending_strength", "flim"}),
         Key::number("surface_hardness_HV", "", KeyRange::between(50, 1200),
                     &MaterialInput::surface_hardness, "value in the table of materials",
                     "Vickers hardness of the surface; for a material of the table, the hardness "
                     "also determines the stress limits")
             .with_also({"hardness", "hv"}),
         Key::positive("yield_strength_MPa", "R_e", &MaterialInput::yield_strength,
                       "Y_δrelT = 1 for a tempered or normalized steel",
                       "yield strength or 0.2 % proof stress")
             .with_also({"yield", "re", "rp02"}),
         Key::number("temperatures_C", "ϑ", KeyRange::between(-100, 400),
                     &MaterialInput::temperatures, "the single values are used at any temperature",
                     "temperatures of the lists of values, only for plastics; interpolation is "
                     "linear and there is no extrapolation")
             .with_list({.least = kMinSteps,
                         .most = kMaxSteps,
                         .order = {true, "must be in rising order"}})
             .with_form("a list of rising temperatures"),
         by_temperature("sigma_Hlim_by_temperature_MPa", "σ_HlimN", &MaterialInput::sigma_Hlim_by,
                        "sigma_Hlim_by",
                        "flank strength at each temperature, for the required life"),
         by_temperature("sigma_Flim_by_temperature_MPa", "σ_FlimN", &MaterialInput::sigma_Flim_by,
                        "sigma_Flim_by",
                        "nominal root strength at each temperature, for the required life; the "
                        "strength does not include Y_ST = 2"),
         by_temperature("youngs_modulus_by_temperature_MPa", "E", &MaterialInput::youngs_modulus_by,
                        "youngs_modulus_by", "Young's modulus at each temperature")},
        check_name,
        "name"};
  }();
  return table;
}

}  // namespace gearwright
