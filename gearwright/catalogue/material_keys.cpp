#include "gearwright/catalogue/material_keys.hpp"

#include "gearwright/base/error.hpp"

namespace gearwright {

namespace {

constexpr KeyList kSteps{2, 100};

Key by_temperature(std::string_view key, std::string_view symbol, std::string_view member,
                   std::string_view meaning) {
  return {.key = key,
          .symbol = symbol,
          .range = KeyRange::positive(),
          .list = kSteps,
          .form = "a list of as many values as `temperatures_C`",
          .needs = {"temperatures_C"},
          .fallback = "the one value above",
          .meaning = meaning,
          .fields = {std::string(member)}};
}

}  // namespace

const KeyTable& material_keys() {
  using Range = KeyRange;
  static const KeyTable table = [] {
    const auto kinds = material_kind_words();
    return KeyTable{
        "material",
        "What the teeth are made of, for `rate`",
        {{.key = "name",
          .kind = KeyKind::text,
          .place = &MaterialInput::name,
          .fallback = "the values below",
          .meaning = "a row of the shipped table, \"18CrNiMo7-6\"; any name where the values "
                     "themselves are given",
          .also = {"steel", "grade", "material"}},
         {.key = "kind",
          .kind = KeyKind::word,
          .words = {kinds.begin(), kinds.end()},
          .place = &MaterialInput::kind,
          .fallback = "of the named row",
          .meaning = "how ISO 6336-5 sorts it: Eh, V, St, IF, NT, NV (nitrocar.), GG, GGG (perl., "
                     "bai.), GGG (ferr.), GTS",
          .also = {"type", "treatment", "heat_treatment"}},
         {.key = "youngs_modulus_MPa",
          .symbol = "E",
          .range = Range::positive(),
          .place = &MaterialInput::youngs_modulus,
          .fallback = "206 000, of cast iron less",
          .meaning = "Young's modulus",
          .fields = {"youngs_modulus"},
          .also = {"e", "modulus", "elasticity"}},
         {.key = "poisson_ratio",
          .symbol = "ν",
          .range = Range::between(0, 0.5),
          .place = &MaterialInput::poisson_ratio,
          .fallback = "0.3",
          .meaning = "Poisson's ratio",
          .also = {"nu", "poisson"}},
         {.key = "density_kg_per_m3",
          .symbol = "ρ",
          .range = Range::positive(),
          .place = &MaterialInput::density,
          .fallback = "7830, of cast iron 7300",
          .meaning = "density, for the resonance of the mesh",
          .fields = {"density"}},
         {.key = "sigma_Hlim_MPa",
          .symbol = "σ_Hlim",
          .range = Range::positive(),
          .place = &MaterialInput::sigma_Hlim,
          .fallback = "of the named row",
          .meaning = "allowable contact stress number of the reference test gears",
          .fields = {"sigma_Hlim"},
          .also = {"sigma_h", "contact_strength", "hlim"}},
         {.key = "sigma_Flim_MPa",
          .symbol = "σ_Flim",
          .range = Range::positive(),
          .place = &MaterialInput::sigma_Flim,
          .fallback = "of the named row",
          .meaning = "allowable bending stress number, nominal: without Y_ST = 2",
          .fields = {"sigma_Flim"},
          .also = {"sigma_f", "bending_strength", "flim"}},
         {.key = "surface_hardness_HV",
          .range = Range::between(50, 1200),
          .place = &MaterialInput::surface_hardness,
          .fallback = "of the named row",
          .meaning = "Vickers hardness of the surface; of a named row it sets the limits, too",
          .fields = {"surface_hardness"},
          .also = {"hardness", "hv"}},
         {.key = "yield_strength_MPa",
          .symbol = "R_e",
          .range = Range::positive(),
          .place = &MaterialInput::yield_strength,
          .fallback = "Y_δrelT = 1 of a tempered or normalized steel",
          .meaning = "yield strength or 0.2 % proof stress",
          .fields = {"yield_strength"},
          .also = {"yield", "re", "rp02"}},
         {.key = "temperatures_C",
          .symbol = "ϑ",
          .range = Range::between(-100, 400),
          .list = kSteps,
          .form = "a list of rising temperatures",
          .fallback = "the values above, at any temperature",
          .meaning = "of a plastic: where its values below are stated; between two the straight "
                     "line, outside nothing",
          .fields = {"temperatures"}},
         by_temperature("sigma_Hlim_by_temperature_MPa", "σ_HlimN", "sigma_Hlim_by",
                        "flank strength at each temperature, for the wanted life"),
         by_temperature("sigma_Flim_by_temperature_MPa", "σ_FlimN", "sigma_Flim_by",
                        "root strength at each temperature, for the wanted life, nominal: without "
                        "Y_ST = 2"),
         by_temperature("youngs_modulus_by_temperature_MPa", "E", "youngs_modulus_by",
                        "Young's modulus at each temperature")}};
  }();
  return table;
}

}  // namespace gearwright
