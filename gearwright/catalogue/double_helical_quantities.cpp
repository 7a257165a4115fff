#include "gearwright/catalogue/double_helical_quantities.hpp"

namespace gearwright {

namespace {

constexpr const char* kHalves = "Double helical";

void say(Quantities<Halves>& q) {
  using H = Halves;
  q.under(kHalves);
  q.number("half_face_width_mm", "face width of one half", "b_B", "(b − gap)/2 [T2.42]",
           &H::half_face_width)
      .always();
  q.number("gap_mm", "gap between the halves", "", "as given", [](const H& h) {
     return h.given.gap;
   }).always();
  q.number("apex_to_half_mm", "distance of a half from the apex", "",
           "gap/2, as the two helices of one tooth meet in the middle plane",
           [](const H& h) { return h.given.gap / 2; })
      .always();
  q.number("stagger_pitches", "stagger of the half at z < 0, pitches", "s", "as given",
           [](const H& h) { return h.given.stagger_pitches; })
      .always();
  q.number("hob_run_out_mm", "least gap for the run-out of the hob", "",
           "[T2.43]; null without a hob", &H::hob_run_out);
  q.number("axial_shift_per_index_error", "axial shift per index error", "Δz/e",
           "1/(2 tan |β|): axial shift by which a floating member shares an index error between "
           "the halves [T2.44]",
           &H::axial_shift_per_index_error)
      .always();
}

}  // namespace

const Quantities<Halves>& double_helical_quantities() {
  static const Quantities<Halves> kAll("double_helical", say);
  return kAll;
}

}  // namespace gearwright
