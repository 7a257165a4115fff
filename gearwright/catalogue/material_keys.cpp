#include "gearwright/catalogue/material_keys.hpp"

namespace gearwright {

const KeyTable& material_keys() {
  using Range = KeyRange;
  static const KeyTable table{"material",
                              "What the teeth are made of",
                              {{.key = "name",
                                .kind = KeyKind::text,
                                .place = &MaterialInput::name,
                                .fallback = "the values below",
                                .meaning = "any name",
                                .also = {"steel", "grade", "material"}},
                               {.key = "youngs_modulus_MPa",
                                .symbol = "E",
                                .range = Range::positive(),
                                .place = &MaterialInput::youngs_modulus,
                                .fallback = "206 000",
                                .meaning = "Young's modulus",
                                .fields = {"youngs_modulus"},
                                .also = {"e", "modulus", "elasticity"}},
                               {.key = "poisson_ratio",
                                .symbol = "ν",
                                .range = Range::between(0, 0.5),
                                .place = &MaterialInput::poisson_ratio,
                                .fallback = "0.3",
                                .meaning = "Poisson's ratio",
                                .also = {"nu", "poisson"}}}};
  return table;
}

}  // namespace gearwright
