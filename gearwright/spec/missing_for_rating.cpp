#include "gearwright/spec/missing_for_rating.hpp"

#include <vector>

#include "gearwright/base/missing.hpp"
#include "gearwright/catalogue/spelling.hpp"
#include "gearwright/rating/missing_inputs.hpp"

namespace gearwright {

std::optional<Error> missing_for_rating(const RatingTable& table,
                                        const std::array<MaterialInput, 2>& materials,
                                        std::array<int, 2> named) {
  std::vector<Error> missing;
  if (!table.torque) {
    missing.push_back({"rating.torque_Nm", "",
                       "is missing; a rating needs a load: power_kW with speed_rpm, or torque_Nm "
                       "on gear 1, torque_Nm = 50 for example"});
  }
  RatingInput input = table.input;
  bool known = true;
  for (const std::size_t i : {0, 1}) {
    const auto material = material_of(materials[i], named[i], input.edition);
    known = known && material;
    if (material) {
      input.materials[i] = *material;
    } else {
      missing.push_back(spelled(material.error()));
    }
  }
  // What VDI 2736 asks for depends on the materials.
  if (known || input.edition != RatingEdition::vdi_2736)
    for (const Error& error : missing_inputs(input)) missing.push_back(spelled(error));
  if (missing.empty()) return std::nullopt;
  return all_missing(missing);
}

}  // namespace gearwright
