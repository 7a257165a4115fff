#include "gearwright/catalogue/double_helical_quantities.hpp"

namespace gearwright {

namespace {

constexpr const char* kHalves = "Double helical";

void say(Quantities<Halves>& q) {
  using H = Halves;
  q.mm(kHalves, "half_face_width_mm", "face width of one half", "b_B", "(b − gap)/2 [T2.42]",
       [](const H& h) { return Value(h.half_face_width); })
      .always();
  q.mm(kHalves, "gap_mm", "gap between the halves", "", "as given", [](const H& h) {
     return Value(h.given.gap);
   }).always();
  q.mm(kHalves, "apex_to_half_mm", "distance of a half from the apex", "",
       "gap/2, as the two helices of one tooth meet in the middle plane",
       [](const H& h) { return Value(h.given.gap / 2); })
      .always();
  q.pure(kHalves, "stagger_pitches", "stagger of the half at z < 0, pitches", "s", "as given",
         [](const H& h) { return Value(h.given.stagger_pitches); })
      .always();
  q.mm(kHalves, "hob_run_out_mm", "least gap for the run-out of the hob", "",
       "[T2.43]; null without a hob", [](const H& h) { return Value(h.hob_run_out); });
  q.pure(kHalves, "axial_shift_per_index_error", "axial shift per index error", "Δz/e",
         "1/(2 tan |β|): a member that floats so far shares an index error of the halves [T2.44]",
         [](const H& h) { return Value(h.axial_shift_per_index_error); })
      .always();
}

}  // namespace

const Quantities<Halves>& double_helical_quantities() {
  static const Quantities<Halves> kAll("double_helical", say);
  return kAll;
}

}  // namespace gearwright
