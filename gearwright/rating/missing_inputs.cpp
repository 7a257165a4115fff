#include "gearwright/rating/rating.hpp"

#include <fmt/format.h>

#include <string>

namespace gearwright {

namespace {

bool needs_helix_slopes(const RatingInput& in) {
  if (in.face_load_computed) return !in.misalignment;
  if (in.face_load_factor) return false;
  return in.mounting ? !in.mounting->manufacture : in.shafts && !in.misalignment;
}

}  // namespace

std::vector<Error> missing_inputs(const RatingInput& in, int halves) {
  if (in.edition == RatingEdition::vdi_2736) return missing_plastic_inputs(in);
  std::vector<Error> missing;
  if (!in.quality && (!in.dynamic_factor || !in.transverse_load_factor)) {
    missing.push_back(
        absent_input("rating.quality",
                     "; K_v and K_Hα depend on the accuracy grade of ISO 1328 (0 to 12). Give the "
                     "grade, for example `quality` = 6, or give both factors"));
  } else if (!in.quality && needs_helix_slopes(in)) {
    missing.push_back(
        absent_input("rating.quality",
                     "; the face load factor depends on the helix slopes. Give the accuracy grade "
                     "of ISO 1328, for example `quality` = 6, or give the misalignment"));
  }
  if (in.quality)
    for (const int grade : *in.quality)
      if (!has_class(tolerance_edition(in.edition), grade))
        missing.push_back({"rating.quality", std::to_string(grade), kClassesOfEditions});
  if (!in.speed && !in.dynamic_factor) {
    missing.push_back(absent_input("rating.speed",
                                   "; the dynamic factor depends on the speed. Give the speed, for "
                                   "example `speed` = 1500, or give the dynamic factor"));
  }
  if (!in.face_load_factor && (in.face_load_computed || (!in.mounting && !in.shafts))) {
    missing.push_back(absent_input(
        "rating.face_load_factor",
        halves == 1
            ? fmt::format("; give the factor, for example `face_load_factor` = 1.2, or give the "
                          "arrangement of the pinion in `mounting` or, for a pair of gears without "
                          "a drive, a shaft with its bearings in {}",
                          gear_field(1, "shaft"))
            : "; give the factor, for example `face_load_factor` = 1.2; for double-helical gears, "
              "the factor cannot be computed from the arrangement of the pinion"));
  }
  return missing;
}

std::optional<Error> missing_input(const RatingInput& in, int halves) {
  const std::vector<Error> missing = missing_inputs(in, halves);
  if (missing.empty()) return std::nullopt;
  return all_missing(missing);
}

}  // namespace gearwright
